// Decoded values of accessors that several primitives share.
#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace candela::gltf {

/// The vertices that a primitive uses, in ascending order, each once. Absent: all.
using Selection = std::optional<std::vector<std::uint32_t>>;

/// Values of accessors. Their number is limited: above `maxCount`, all are dropped before another accessor is stored.
template <class Number>
class StoredValues {
 public:
  struct Key {
    std::size_t accessor;
    std::size_t components;
    bool isRepaired;  ///< elements that are not finite are 0
    auto operator<=>(const Key&) const = default;
  };

  explicit StoredValues(std::size_t maxCount) : maxCount_(maxCount) {}

  /// Returns the values of an accessor, which `read` returns the first time. They are valid until the next call.
  template <class Read>
  std::span<const Number> get(const Key& key, const Read& read) {
    const auto known = values_.find(key);
    if (known != values_.end()) return known->second;
    std::vector<Number> values = read();
    if (count_ + values.size() > maxCount_) {
      values_.clear();
      count_ = 0;
    }
    count_ += values.size();
    return values_.emplace(key, std::move(values)).first->second;
  }

 private:
  std::map<Key, std::vector<Number>> values_;
  std::size_t count_ = 0;
  std::size_t maxCount_;
};

/// Copies the selected elements, of `components` values each. Every index of the selection is that of an element.
template <class Number>
void gather(std::span<const Number> values, std::size_t components, const std::vector<std::uint32_t>& selection,
            std::span<Number> result) {
  for (std::size_t i = 0; i < selection.size(); ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      result[i * components + c] = values[selection[i] * components + c];
    }
  }
}

}  // namespace candela::gltf
