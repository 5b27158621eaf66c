// Polls the time and the size of a file.
#include "host/app/view/file_watch.h"

#include <system_error>

namespace candela::view {

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)), known_(look()), last_(known_) {}

std::optional<FileWatch::State> FileWatch::look() const {
  std::error_code missing;
  const State state{std::filesystem::last_write_time(file_, missing), std::filesystem::file_size(file_, missing)};
  return missing ? std::nullopt : std::optional(state);
}

bool FileWatch::hasChanged() {
  const std::optional<State> now = look();
  const bool isSettled = now && now == last_;
  last_ = now;
  if (!isSettled || now == known_) return false;
  known_ = now;
  return true;
}

}  // namespace candela::view
