// Runs work that may crash or hang in a child process.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/base/file_descriptor.h"

namespace candela::process {

/// A child process that sends JSON values while it works. Start it while this process has one thread.
class ChildProcess {
 public:
  using Send = std::function<void(const nlohmann::json&)>;

  /// Forks, and calls `work` in the child, whose stdout and stderr go to a temporary file. The child ends at the latest
  /// two seconds after it has sent nothing for `limit`, even if this process has been killed. Throws InternalError if
  /// no process can be started.
  ChildProcess(std::chrono::milliseconds limit, const std::function<void(const Send&)>& work);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills the child if it has not ended.
  ~ChildProcess();

  /// Returns the file descriptor that poll() reports as readable when receive() has something to read.
  int descriptor() const { return in_.get(); }
  /// Reads the values that the child has sent so far. Blocks if there is nothing. Call it until hasEnded().
  std::vector<nlohmann::json> receive();
  /// Returns whether the child has closed its end, so that it sends nothing more.
  bool hasEnded() const { return ended_; }
  void kill();
  /// Waits for the end of the child. Returns a predicate of a sentence about the work, e.g. "crashes (Aborted)" or
  /// "ends the program with exit code 0"; empty if `work` returned. Call it when hasEnded(), or after kill().
  std::string failure();
  /// Returns the last line that the child printed on stdout or stderr, as printableLine() shows its first 1024 bytes;
  /// it may be empty. Call it after failure().
  std::string lastMessage() const;

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  FileDescriptor in_{-1};
  std::unique_ptr<std::FILE, CloseFile> messages_;
  pid_t child_ = -1;
  std::string unread_;     ///< the beginning of a value whose end has not been read
  bool returned_ = false;  ///< `work` has returned
  bool ended_ = false;
};

struct ChildResult {
  nlohmann::json answer;     ///< the result of the work; null after a failure
  std::string failure;       ///< as ChildProcess::failure(), or "fails: " and the message of an exception; empty: none
  std::string lastMessage;   ///< as ChildProcess::lastMessage()
  bool interrupted = false;  ///< `stop` was true before the end of the child; there is a failure, too
};

/// Calls `work` in a child process, and ends it after `limit`, or within 0.1 s after `stop` becomes true (null: it is
/// not polled). An exception of `work` is a failure. Messages of the validation layer in the child are added to those
/// of this process. Throws as the constructor of ChildProcess does.
ChildResult runInChild(std::chrono::milliseconds limit, const std::function<nlohmann::json()>& work,
                       const std::atomic<bool>* stop = nullptr);

}  // namespace candela::process
