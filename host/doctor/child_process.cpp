// The child returns its result as JSON through a pipe, and its messages go to a temporary file.
#include "host/doctor/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "host/core/errors.h"
#include "host/core/file_descriptor.h"
#include "host/vulkan/validation.h"
#include "host/vulkan/validation_log.h"

namespace candela::doctor {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string resultOf(const std::function<Json()>& work) {
  try {
    Json answer = work();
    return dump({{"answer", std::move(answer)}, {"validation", vulkan::validationMessages()}});
  } catch (const std::exception& error) {
    return dump({{"error", error.what()}, {"validation", vulkan::validationMessages()}});
  }
}

void writeAll(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

// Handlers of this process would report a crash of the child as one of the program.
void resetSignals() {
  for (const int signal : {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGSEGV, SIGTERM}) {
    std::signal(signal, SIG_DFL);
  }
}

// A crash leaves no core dump, and the child ends soon after the limit even if this process has been killed.
[[noreturn]] void beChild(int out, std::FILE* messages, std::chrono::milliseconds limit,
                          const std::function<Json()>& work) {
  const rlimit noCoreDump{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCoreDump);
  resetSignals();
  ::alarm(static_cast<unsigned>(limit.count() / 1000 + 2));
  if (messages != nullptr) {
    ::dup2(::fileno(messages), STDOUT_FILENO);
    ::dup2(::fileno(messages), STDERR_FILENO);
  }
  vulkan::clearValidationMessages();
  writeAll(out, resultOf(work));
  std::fflush(nullptr);
  ::_exit(0);
}

// Reads to the end of the pipe. Returns false if that takes longer than `limit`.
bool readAll(int descriptor, std::chrono::milliseconds limit, std::string& text) {
  const Clock::time_point end = Clock::now() + limit;
  std::array<char, 4096> block;
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd ready{descriptor, POLLIN, 0};
    const int count = left <= 0 ? 0 : ::poll(&ready, 1, static_cast<int>(left));
    if (count == 0) return false;
    if (count < 0) continue;
    const ssize_t size = ::read(descriptor, block.data(), block.size());
    if (size == 0) return true;
    if (size > 0) text.append(block.data(), static_cast<std::size_t>(size));
  }
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string lastLine(std::FILE* file) {
  if (file == nullptr) return "";
  std::rewind(file);
  std::string last;
  std::array<char, 1024> line;
  while (std::fgets(line.data(), static_cast<int>(line.size()), file) != nullptr) {
    std::string text = line.data();
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    if (!text.empty()) last = std::move(text);
  }
  return last;
}

void interpret(const std::string& text, int status, ChildResult& result) {
  if (WIFSIGNALED(status)) {
    result.failure = fmt::format("crashes ({})", ::strsignal(WTERMSIG(status)));
    return;
  }
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    result.failure = fmt::format("ends the program with exit code {}", WEXITSTATUS(status));
    return;
  }
  for (const Json& message : json["validation"]) vulkan::addValidationMessage(message.get<std::string>());
  if (json.contains("error")) {
    result.failure = "fails: " + json["error"].get<std::string>();
  } else {
    result.answer = json["answer"];
  }
}

}  // namespace

ChildResult runInChild(std::chrono::milliseconds limit, const std::function<Json()>& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw InternalError(fmt::format("cannot open a pipe: {}", std::strerror(errno)));
  const FileDescriptor in(ends[0]);
  FileDescriptor out(ends[1]);
  const File messages(std::tmpfile());
  const pid_t child = ::fork();
  if (child < 0) throw InternalError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child == 0) beChild(out.get(), messages.get(), limit, work);
  out.close();
  std::string text;
  const bool ended = readAll(in.get(), limit, text);
  if (!ended) ::kill(child, SIGKILL);
  const int status = waitFor(child);
  ChildResult result;
  result.lastMessage = lastLine(messages.get());
  if (ended) {
    interpret(text, status, result);
  } else {
    result.failure = fmt::format("does not end within {:g} s", static_cast<double>(limit.count()) / 1000);
  }
  return result;
}

}  // namespace candela::doctor
