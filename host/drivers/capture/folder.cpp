// Writes the files of a capture.
#include "host/drivers/capture/folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "embedded/interesting.h"
#include "embedded/reduce.h"
#include "embedded/reproduce.h"
#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/drivers/capture/capture.h"
#include "host/drivers/capture/header_text.h"

namespace candela::capture {
namespace {

std::string countText(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

// Returns sentences, each after a space.
std::string remarksOf(const Capture& capture) {
  std::string text;
  if (capture.wholeCount > 0) text += fmt::format(" They were reduced from {} values.", capture.wholeCount);
  if (!capture.note.empty()) text += " " + capture.note;
  return text;
}

std::string foundText(const Capture& capture) {
  if (capture.found.empty()) {
    return fmt::format("It was captured on {}, which computed these values.", capture.capturedOn);
  }
  return fmt::format("On {}:\n\n```\n{}\n```", capture.capturedOn, capture.found);
}

std::string readmeText(const Capture& capture) {
  return fmt::format(
      R"(# {}

The program in this folder repeats work of Candela, a path tracer that verifies Vulkan drivers, on any Vulkan 1.2 device: {} with {} and {}.
It compares {} of the result with those that {} computed.{} {}

## How to run it

    cc -std=c99 -o reproduce reproduce.c -lvulkan
    ./reproduce                                           # on the first device
    VK_DRIVER_FILES=/path/to/icd.json ./reproduce         # with this driver

It prints the first value that differs. The exit code is 0 if no value differs, 1 if one does, and 2 if Vulkan cannot run it.

## Files

- `reproduce.c` and `capture.h`: the program and its tables.
- `module_*.spv`: the shaders as they are passed to the driver; specialisation constants are set, and the code that they disable is removed.
- `buffer_*.bin`, `write_*.bin`: contents of buffers. Buffers without a file begin with equal words.
- `expected.bin`: records of 32 bytes (type, buffer, word, 0, minimum and maximum permitted value as doubles).
- `minimum.txt`: number of values that must differ when the shader is reduced.
- `interesting.sh`: tests whether two executions of a module disagree.
- `reduce.sh`: reduces a module as long as `interesting.sh` accepts it.

## How to reduce the shader

    export ICD_A=/path/to/icd.json ICD_B=/path/to/another/icd.json
    ./reduce.sh module_0.spv reduced.spv
    ICD=$ICD_A; VK_DRIVER_FILES=$ICD ./reproduce --module 0 reduced.spv --dump a
    ICD=$ICD_B; VK_DRIVER_FILES=$ICD ./reproduce --module 0 reduced.spv --against a 0.001

It needs SPIRV-Tools. A reduced module computes something else, so that two executions are compared instead of the expected values.
)",
      capture.title, countText(capture.work.commands.size(), "command", "commands"),
      countText(capture.work.shaders.size(), "shader", "shaders"),
      countText(capture.work.buffers.size(), "buffer", "buffers"),
      countText(capture.expected.size(), "value", "values"), capture.expectedBy, remarksOf(capture),
      foundText(capture));
}

namespace fs = std::filesystem;

/// A value in expected.bin, as reproduce.c reads it.
struct FileValue {
  std::uint32_t type;
  std::uint32_t buffer;
  std::uint32_t word;
  std::uint32_t unused;
  double low;
  double high;
};
static_assert(sizeof(FileValue) == 32);

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

void writeExpected(const Capture& capture, const fs::path& file) {
  std::vector<FileValue> values;
  for (const ExpectedValue& value : capture.expected) {
    values.push_back({static_cast<std::uint32_t>(value.type), bufferOf(capture, value.position), value.position.word, 0,
                      value.low, value.high});
  }
  writeFileAtomically(file, std::as_bytes(std::span(values)));
}

void writeData(const Capture& capture, const fs::path& folder) {
  const vulkan::Recording& work = capture.work;
  for (std::size_t i = 0; i < work.shaders.size(); ++i) {
    writeFileAtomically(folder / moduleFile(i), std::as_bytes(std::span(work.shaders[i].spirv)));
  }
  for (std::size_t i = 0; i < work.buffers.size(); ++i) {
    if (!commonWord(capture.contents[i])) writeFileAtomically(folder / bufferFile(i), capture.contents[i]);
  }
  for (std::size_t i = 0; i < work.commands.size(); ++i) {
    const auto* const write = std::get_if<vulkan::RecordedWrite>(&work.commands[i]);
    if (write != nullptr) writeFileAtomically(folder / writeFile(i), write->data);
  }
  writeExpected(capture, folder / "expected.bin");
}

void writeScript(std::string_view text, const fs::path& file) {
  writeFileAtomically(file, bytesOf(text));
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
}

// Reductions must preserve a quarter of the values that differ, so that they do not end at another fault.
std::size_t minimumOf(const Capture& capture) { return std::max<std::size_t>(1, capture.differing / 4); }

void writeFiles(const Capture& capture, const fs::path& folder) {
  writeFileAtomically(folder / "capture.h", bytesOf(headerText(capture)));
  writeFileAtomically(folder / "reproduce.c", bytesOf(embedded::reproduce));
  writeFileAtomically(folder / "README.md", bytesOf(readmeText(capture)));
  writeScript(embedded::interesting, folder / "interesting.sh");
  writeScript(embedded::reduce, folder / "reduce.sh");
  writeFileAtomically(folder / "minimum.txt", bytesOf(fmt::format("{}\n", minimumOf(capture))));
  for (const TextFile& file : capture.files) writeFileAtomically(folder / file.name, bytesOf(file.text));
  writeData(capture, folder);
}

fs::path parentOf(const fs::path& folder) { return folder.has_parent_path() ? folder.parent_path() : "."; }

fs::path withoutSlash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

// The number of the process follows.
std::string temporaryName(const fs::path& target) { return fmt::format(".{}.", target.filename().string()); }

/// A folder that is removed unless it was renamed.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const fs::path& target)
      : path(parentOf(target) / (temporaryName(target) + std::to_string(::getpid()))) {
    fs::create_directory(path);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  const fs::path path;
};

}  // namespace

void requireNewFolder(const fs::path& given) {
  const fs::path folder = withoutSlash(given);
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
    throw FileError(fmt::format("{}: is a file; name a new folder", given.string()));
  }
  if (fs::is_directory(folder, ignored) && !fs::is_empty(folder, ignored)) {
    throw FileError(
        fmt::format("{}: the folder has files, which a capture does not replace; name a new folder", given.string()));
  }
  const fs::path parent = parentOf(folder);
  if (!fs::is_directory(parent, ignored)) {
    throw FileError(fmt::format("{}: there is no folder {}", given.string(), parent.string()));
  }
  if (::access(parent.c_str(), W_OK) != 0) {
    throw FileError(fmt::format("{}: no permission to write there", given.string()));
  }
}

void writeFolder(const Capture& capture, const fs::path& given) {
  requireNewFolder(given);
  const fs::path folder = withoutSlash(given);
  try {
    const TemporaryFolder temporary(folder);
    writeFiles(capture, temporary.path);
    fs::rename(temporary.path, folder);
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("{}: {}", given.string(), error.code().message()));
  }
}

void removeRemains(const fs::path& given) {
  const fs::path folder = withoutSlash(given);
  const std::string name = temporaryName(folder);
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(parentOf(folder), ignored)) {
    const std::string other = entry.path().filename().string();
    const bool isRemains = other.starts_with(name) && other.find_first_not_of("0123456789", name.size()) == other.npos;
    if (isRemains) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace candela::capture
