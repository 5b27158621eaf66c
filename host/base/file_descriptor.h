// A POSIX file descriptor that is closed once.
#pragma once
#include <unistd.h>

#include <utility>

namespace candela {

class FileDescriptor {
 public:
  /// Takes ownership of `value`, the result of open(). A negative value means that there is no file.
  explicit FileDescriptor(int value) : value_(value) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~FileDescriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }
  bool isOpen() const { return value_ >= 0; }
  /// Closes the file. Returns false and sets errno on an error; some file systems report a failed write only here.
  bool close() {
    const int value = value_;
    value_ = -1;
    return ::close(value) == 0;
  }

 private:
  int value_;
};

}  // namespace candela
