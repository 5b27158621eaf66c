// The child sends JSON values, one per line, through a pipe, and its messages go to a temporary file. An empty line is
// sent when the work has returned: a driver that calls exit(0) ends the child with the same status.
#include "host/drivers/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/base/utf8.h"
#include "host/trace/vulkan/validation.h"
#include "host/trace/vulkan/validation_log.h"

namespace candela::process {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

constexpr std::chrono::milliseconds kNoTime{0};
constexpr const char* kReturned = "\n";  // no JSON value is an empty line

std::string lineOf(const Json& json) { return jsonText(json) + "\n"; }

Json resultOf(const std::function<Json()>& work) {
  try {
    Json answer = work();
    return {{"answer", std::move(answer)}, {"validation", vulkan::validationMessages()}};
  } catch (const std::exception& error) {
    return {{"error", error.what()}, {"validation", vulkan::validationMessages()}};
  }
}

void writeAll(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

// Handlers of this process would report a crash of the child as one of the program. Like this process, a child of
// `nohup candela` goes on ignoring SIGHUP.
void resetSignals() {
  if (std::signal(SIGHUP, SIG_DFL) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  for (const int signal : {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGSEGV, SIGTERM}) {
    std::signal(signal, SIG_DFL);
  }
}

// A crash leaves no core dump. An exception of `work` is a crash, too: it must not reach the callers of this process.
[[noreturn]] void beChild(int out, std::FILE* messages, std::chrono::milliseconds limit,
                          const std::function<void(const ChildProcess::Send&)>& work) noexcept {
  const rlimit noCoreDump{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCoreDump);
  resetSignals();
  const auto seconds = static_cast<unsigned>(limit.count() / 1000 + 2);
  ::alarm(seconds);
  if (messages != nullptr) {
    ::dup2(::fileno(messages), STDOUT_FILENO);
    ::dup2(::fileno(messages), STDERR_FILENO);
  }
  vulkan::clearValidationMessages();
  work([&](const Json& json) {
    writeAll(out, lineOf(json));
    ::alarm(seconds);
  });
  writeAll(out, kReturned);
  std::fflush(nullptr);
  ::_exit(0);
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// Returns the end of a file, at most 64 KiB.
std::string endOf(std::FILE* file) {
  constexpr long kMaxBytes = 65536;
  if (std::fseek(file, -kMaxBytes, SEEK_END) != 0) std::rewind(file);
  std::string text(kMaxBytes, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

// Returns the last line that is not blank.
std::string lastLineOf(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n") + 1;  // 0 if there is none
  const std::size_t begin = text.substr(0, end).find_last_of("\r\n") + 1;
  return text.substr(begin, end - begin);
}

bool isTrue(const std::atomic<bool>* flag) { return flag != nullptr && flag->load(); }

// Returns whether the child sends something, or ends, before `end` and before `stop` is true.
bool waitForMore(const ChildProcess& child, Clock::time_point end, const std::atomic<bool>* stop) {
  constexpr std::chrono::milliseconds kStep{50};
  while (Clock::now() < end && !isTrue(stop)) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    pollfd ready{child.descriptor(), POLLIN, 0};
    if (::poll(&ready, 1, static_cast<int>(std::clamp(left, kNoTime, kStep).count())) > 0) return true;
  }
  return false;
}

void interpret(const Json& json, ChildResult& result) {
  for (const Json& message : json["validation"]) vulkan::addValidationMessage(message.get<std::string>());
  if (json.contains("error")) {
    result.failure = "fails: " + json["error"].get<std::string>();
  } else {
    result.answer = json["answer"];
  }
}

}  // namespace

ChildProcess::ChildProcess(std::chrono::milliseconds limit, const std::function<void(const Send&)>& work)
    : messages_(std::tmpfile()) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw InternalError(fmt::format("cannot open a pipe: {}", std::strerror(errno)));
  in_ = FileDescriptor(ends[0]);
  const FileDescriptor out(ends[1]);
  std::fflush(nullptr);  // otherwise the child would also print the pending output of this process
  child_ = ::fork();
  if (child_ < 0) throw InternalError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child_ == 0) beChild(out.get(), messages_.get(), limit, work);
}

ChildProcess::~ChildProcess() {
  if (child_ < 0) return;
  kill();
  waitFor(child_);
}

void ChildProcess::kill() { ::kill(child_, SIGKILL); }

std::vector<Json> ChildProcess::receive() {
  std::array<char, 4096> block;
  const ssize_t size = ::read(in_.get(), block.data(), block.size());
  ended_ = ended_ || size == 0;
  if (size > 0) unread_.append(block.data(), static_cast<std::size_t>(size));
  std::vector<Json> received;
  for (std::size_t end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n')) {
    if (end == 0) {
      returned_ = true;
    } else {
      received.push_back(Json::parse(unread_.substr(0, end), nullptr, false));
    }
    unread_.erase(0, end + 1);
  }
  return received;
}

std::string ChildProcess::failure() {
  const int status = waitFor(std::exchange(child_, -1));
  if (WIFSIGNALED(status)) return fmt::format("crashes ({})", ::strsignal(WTERMSIG(status)));
  return returned_ ? "" : fmt::format("ends the program with exit code {}", WEXITSTATUS(status));
}

std::string ChildProcess::lastMessage() const {
  constexpr std::size_t kMaxBytes = 1024;
  return messages_ == nullptr ? "" : printableLine(lastLineOf(endOf(messages_.get())), kMaxBytes);
}

ChildResult runInChild(std::chrono::milliseconds limit, const std::function<Json()>& work,
                       const std::atomic<bool>* stop) {
  const Clock::time_point end = Clock::now() + limit;
  ChildProcess child(limit, [&](const ChildProcess::Send& send) { send(resultOf(work)); });
  std::optional<Json> sent;
  while (!child.hasEnded() && waitForMore(child, end, stop)) {
    for (Json& json : child.receive()) sent = std::move(json);
  }
  ChildResult result;
  const bool ended = child.hasEnded();
  if (!ended) child.kill();
  result.failure = child.failure();
  result.lastMessage = child.lastMessage();
  result.interrupted = isTrue(stop) && !result.failure.empty();  // Ctrl-C may have ended the child, too
  if (result.interrupted) {
    result.failure = "is interrupted";
  } else if (!ended) {
    result.failure = fmt::format("does not end within {:g} s", static_cast<double>(limit.count()) / 1000);
  } else if (sent) {
    interpret(*sent, result);
  }
  return result;
}

}  // namespace candela::process
