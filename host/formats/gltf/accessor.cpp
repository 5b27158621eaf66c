// Reads accessors.
#include "host/formats/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/memory_budget.h"
#include "host/base/setting_words.h"

namespace candela::gltf {
namespace {

bool isFiniteComponent(float value) { return std::isfinite(value); }

/// Returns the index of the first element that is not finite, if there is one.
std::optional<std::size_t> findNonFinite(std::span<const float> values, std::size_t components) {
  const auto bad = std::ranges::find_if_not(values, isFiniteComponent);
  if (bad == values.end()) return std::nullopt;
  return static_cast<std::size_t>(bad - values.begin()) / components;
}

void zeroNonFinite(std::span<float> values, std::size_t components) {
  for (std::size_t i = 0; i < values.size(); i += components) {
    const std::span<float> element = values.subspan(i, components);
    if (!std::ranges::all_of(element, isFiniteComponent)) std::ranges::fill(element, 0.0f);
  }
}

void requireWhole(const Value& reference, const ElementType& type) {
  if (!type.isUnsigned() || type.normalised) reference.fail("the accessor's elements are not unsigned integers");
}

}  // namespace

std::size_t Accessors::indexOf(const Value& reference) const {
  return reference.indexInto("accessors", root_.sizeOf("accessors"));
}

Value Accessors::accessorOf(const Value& reference) const { return root_.require("accessors")[indexOf(reference)]; }

ElementType Accessors::type(const Value& reference) const { return elementTypeOf(accessorOf(reference)); }

Accessors::Elements Accessors::elementsOf(const Value& reference, std::size_t components) {
  const Value accessor = accessorOf(reference);
  const ElementType type = elementTypeOf(accessor);
  if (type.components != components) {
    reference.fail(
        fmt::format("the accessor's elements have {} components instead of {}", type.components, components));
  }
  const Elements elements = elementsIn(accessor, type);
  (elements.bytes.empty() ? zeroCount_ : readCount_) += type.count;
  requireMemory(accessor.pointer(), type.count * type.components * sizeof(float), "use a machine with more memory");
  return elements;
}

Accessors::Elements Accessors::elementsIn(const Value& accessor, const ElementType& type) {
  if (accessor.find("bufferView")) return inView(accessor, type);
  constexpr std::uint64_t kMaxZeros = 1u << 24, kMaxZerosPerElement = 1024;
  const std::uint64_t max = kMaxZeros + kMaxZerosPerElement * readCount_;
  if (type.count > max - zeroCount_) {
    accessor.require("count").fail(fmt::format(
        "{} elements without a buffer view, after {} others; at most {} are read", type.count, zeroCount_, max));
  }
  return {accessor, type, {}, 0};
}

std::size_t Accessors::count(const Value& reference) {
  const Value accessor = accessorOf(reference);
  const ElementType type = elementTypeOf(accessor);
  return elementsIn(accessor, type).type.count;
}

/// `source` has bufferView and byteOffset. Counts are below 2^32, strides at most 256 and offsets at most 2^53, so that
/// nothing overflows.
Accessors::Elements Accessors::inView(const Value& source, const ElementType& type) {
  const BufferView view = buffers_.view(source.require("bufferView"));
  const std::size_t size = type.components * sizeOf(type.component);
  const std::size_t stride = view.stride.value_or(size);
  if (stride < size)
    source.fail(fmt::format("elements of {} bytes overlap, since they are {} bytes apart", size, stride));
  const std::uint64_t offset = source.wholeOr("byteOffset", 0);
  const std::uint64_t end = offset + std::uint64_t{type.count - 1} * stride + size;
  if (end > view.bytes.size()) {
    source.fail(
        fmt::format("{} elements end at byte {} of a buffer view of {} bytes", type.count, end, view.bytes.size()));
  }
  return {source, type, view.bytes.subspan(static_cast<std::size_t>(offset)), stride};
}

template <class Out>
void Accessors::applySparse(const Value& accessor, const ElementType& type, std::span<Out> result) {
  const std::optional<Value> sparse = accessor.find("sparse");
  if (!sparse) return;
  const std::uint64_t count = sparse->require("count").whole();
  if (count == 0 || count > type.count) {
    sparse->require("count").fail(fmt::format("{} of {} elements are replaced", count, type.count));
  }
  const Value indexSource = sparse->require("indices");
  const ElementType indexType{static_cast<std::size_t>(count), componentOf(indexSource.require("componentType")), 1,
                              false};
  requireWhole(indexSource, indexType);
  ElementType valueType = type;
  valueType.count = indexType.count;
  const Elements indices = inView(indexSource, indexType);
  const Elements values = inView(sparse->require("values"), valueType);
  std::vector<std::uint32_t> targets(indexType.count);
  copyElements<std::uint32_t>(indexType, indices.bytes, indices.stride, targets);
  std::vector<Out> replacements(indexType.count * type.components);
  copyElements<Out>(valueType, values.bytes, values.stride, replacements);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i] >= type.count || (i > 0 && targets[i] <= targets[i - 1])) {
      indexSource.fail(fmt::format("index {} of element {} is not below {}, or not above the one before", targets[i], i,
                                   type.count));
    }
    std::copy_n(replacements.begin() + static_cast<std::ptrdiff_t>(i * type.components), type.components,
                result.begin() + static_cast<std::ptrdiff_t>(targets[i] * type.components));
  }
}

void Accessors::readReals(const Elements& elements, NonFinite nonFinite, std::span<float> result) {
  if (!elements.bytes.empty()) copyElements(elements.type, elements.bytes, elements.stride, result);
  applySparse(elements.source, elements.type, result);
  const std::optional<std::size_t> bad = findNonFinite(result, elements.type.components);
  if (!bad) return;
  const std::string message = fmt::format("element {} is not finite", *bad);
  if (nonFinite == NonFinite::refused) elements.source.fail(message);
  if (lenientLog_ == nullptr)
    elements.source.fail(fmt::format("{}; {} reads it as 0", message, settingWords("lenient")));
  lenientLog_->warn("finite", {}, fmt::format("{}: {}, and is read as 0", elements.source.pointer(), message));
  zeroNonFinite(result, elements.type.components);
}

std::span<const float> Accessors::storedReals(const Value& reference, std::size_t components, NonFinite nonFinite) {
  return reals_.get({indexOf(reference), components, nonFinite == NonFinite::zero}, [&] {
    const Elements elements = elementsOf(reference, components);
    std::vector<float> values(elements.type.count * components);
    readReals(elements, nonFinite, values);
    return values;
  });
}

std::vector<std::uint32_t> Accessors::readWhole(const Value& reference, std::size_t components,
                                                const Selection& selection) {
  if (!selection) return readAllWhole(reference, components);
  const std::span<const std::uint32_t> all = wholes_.get({indexOf(reference), components, false},
                                                         [&] { return readAllWhole(reference, components); });
  std::vector<std::uint32_t> result(selection->size() * components);
  gather(all, components, *selection, std::span(result));
  return result;
}

std::vector<std::uint32_t> Accessors::readAllWhole(const Value& reference, std::size_t components) {
  requireWhole(reference, type(reference));
  const Elements elements = elementsOf(reference, components);
  std::vector<std::uint32_t> result(elements.type.count * components);
  if (!elements.bytes.empty()) copyElements<std::uint32_t>(elements.type, elements.bytes, elements.stride, result);
  applySparse<std::uint32_t>(elements.source, elements.type, result);
  return result;
}

}  // namespace candela::gltf
