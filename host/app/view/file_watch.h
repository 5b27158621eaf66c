// Detects that a file was written.
#pragma once
#include <filesystem>
#include <optional>

namespace candela::view {

/// Compares the time and the size of a file with those of the last call. A file that is being written, or is missing
/// temporarily, counts as changed once it is the same in two successive calls.
class FileWatch {
 public:
  explicit FileWatch(std::filesystem::path file);
  /// Returns whether the file has changed since the construction or the last call that returned true.
  bool hasChanged();

 private:
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t bytes = 0;
    bool operator==(const State&) const = default;
  };
  std::optional<State> look() const;

  std::filesystem::path file_;
  std::optional<State> known_;
  std::optional<State> last_;
};

}  // namespace candela::view
