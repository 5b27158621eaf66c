// Formats the tables of reproduce.c.
#include "host/drivers/capture/header_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

#include "host/base/errors.h"

namespace candela::capture {
namespace {

using vulkan::BindingKind;
using vulkan::Usage;

// The limits of reproduce.c.
constexpr std::size_t kMaxObjects = 64;
constexpr std::size_t kMaxBindings = 16;

void requireFew(std::size_t count, std::size_t max, const char* what) {
  if (count <= max) return;
  throw UsageError(
      fmt::format("the work has {} {}, and reproduce.c takes {}: it cannot be captured", count, what, max));
}

const char* useOf(BindingKind kind) {
  switch (kind) {
    case BindingKind::uniformTexelBuffer:
      return "USE_TEXEL";
    case BindingKind::uniformBuffer:
      return "USE_UNIFORM";
    default:
      return "USE_STORAGE";
  }
}

std::string usesOf(Usage usage) {
  std::string uses;
  const auto add = [&](Usage flag, const char* name) {
    if (has(usage, flag)) uses += (uses.empty() ? "" : " | ") + std::string(name);
  };
  add(Usage::storage, "USE_STORAGE");
  add(Usage::uniformTexel, "USE_TEXEL");
  add(Usage::uniform, "USE_UNIFORM");
  add(Usage::indirect, "USE_INDIRECT");
  return uses.empty() ? "0" : uses;
}

std::string moduleText(const vulkan::RecordedShader& shader, std::size_t index) {
  std::vector<std::string> bindings;
  for (const BindingKind kind : shader.options.bindings) bindings.emplace_back(useOf(kind));
  requireFew(bindings.size(), kMaxBindings, "bindings");
  std::string text = fmt::format("    {{\"{}\", {}, {}, {{{}}}}},", moduleFile(index), shader.options.pushConstantBytes,
                                 bindings.size(), fmt::join(bindings, ", "));
  for (const vulkan::Specialisation& constant : shader.options.specialisations) {
    text += fmt::format(" /* constant {} = {:#x} */", constant.id, constant.value);
  }
  return text + "\n";
}

std::string bufferText(const Capture& capture, std::size_t index) {
  const vulkan::RecordedBuffer& buffer = capture.work.buffers[index];
  const std::optional<std::uint32_t> word = commonWord(capture.contents[index]);
  const std::string file = word ? "NULL" : fmt::format("\"{}\"", bufferFile(index));
  return fmt::format("    {{{}, {}, {}, {:#x}u}},\n", file, buffer.bytes, usesOf(buffer.usage), word.value_or(0));
}

std::string words(std::span<const std::byte> bytes) {
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  return words.empty() ? "0" : fmt::format("{:#x}u", fmt::join(words, "u, "));
}

std::string commandText(const vulkan::RecordedWrite& write, std::size_t index) {
  return fmt::format(".kind = COMMAND_WRITE, .buffer = {}, .offset = {}, .file = \"{}\"", write.buffer, write.offset,
                     writeFile(index));
}

std::string commandText(const vulkan::RecordedFill& fill, std::size_t) {
  return fmt::format(".kind = COMMAND_FILL, .buffer = {}, .offset = {}, .bytes = {}, .word = {:#x}u", fill.buffer,
                     fill.offset, fill.bytes, fill.word);
}

std::string commandText(const vulkan::RecordedCopy& copy, std::size_t) {
  return fmt::format(".kind = COMMAND_COPY, .buffer = {}, .offset = {}, .target = {}, .target_offset = {}, .bytes = {}",
                     copy.from, copy.fromOffset, copy.to, copy.toOffset, copy.bytes);
}

std::string commandText(const vulkan::RecordedDispatch& dispatch, std::size_t) {
  const std::string common = fmt::format(".module = {}, .buffers = {{{}}}, .push = {{{}}}", dispatch.shader,
                                         fmt::join(dispatch.buffers, ", "), words(dispatch.pushConstants));
  if (dispatch.indirect) {
    return fmt::format(".kind = COMMAND_DISPATCH_INDIRECT, {}, .buffer = {}, .offset = {}", common,
                       dispatch.indirect->buffer, dispatch.indirect->offset);
  }
  return fmt::format(".kind = COMMAND_DISPATCH, {}, .groups = {{{}, {}, {}}}", common, dispatch.groups.x,
                     dispatch.groups.y, dispatch.groups.z);
}

std::string commandsText(const Capture& capture) {
  std::string text;
  for (std::size_t i = 0; i < capture.work.commands.size(); ++i) {
    const std::string members = std::visit([&](const auto& one) { return commandText(one, i); },
                                           capture.work.commands[i]);
    text += fmt::format("    {{{}}},\n", members);
  }
  return text;
}

// Titles contain file names.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') result += '\\';
    result += static_cast<unsigned char>(character) < 0x20 ? ' ' : character;
  }
  return result + "\"";
}

}  // namespace

std::optional<std::uint32_t> commonWord(const Content& content) {
  std::uint32_t first;
  std::memcpy(&first, content.data(), sizeof first);
  const bool isCommon = std::equal(content.begin() + sizeof first, content.end(), content.begin());
  return isCommon ? std::optional(first) : std::nullopt;
}

std::string moduleFile(std::size_t index) { return fmt::format("module_{}.spv", index); }
std::string bufferFile(std::size_t index) { return fmt::format("buffer_{}.bin", index); }
std::string writeFile(std::size_t command) { return fmt::format("write_{}.bin", command); }

std::string headerText(const Capture& capture) {
  requireFew(capture.work.shaders.size(), kMaxObjects, "shader modules");
  requireFew(capture.work.buffers.size(), kMaxObjects, "buffers");
  std::string text = fmt::format(
      "/* Written by candela capture for reproduce.c. Modules have their specialisation constants at their values. */\n"
      "#define CAPTURE_TITLE {}\n#define CAPTURE_DEVICE {}\n#define CAPTURE_ROBUST_ACCESS {}\n#define "
      "CAPTURE_SUBGROUP_SIZE {}\n\n"
      "static const struct module capture_modules[] = {{\n",
      quoted(capture.title), quoted(capture.deviceName), capture.work.robustBufferAccess ? 1 : 0,
      capture.work.subgroupSize);
  for (std::size_t i = 0; i < capture.work.shaders.size(); ++i) text += moduleText(capture.work.shaders[i], i);
  text += "};\n\nstatic const struct buffer capture_buffers[] = {\n";
  for (std::size_t i = 0; i < capture.work.buffers.size(); ++i) text += bufferText(capture, i);
  text += "};\n\nstatic const struct command capture_commands[] = {\n" + commandsText(capture) + "};\n";
  return text;
}

}  // namespace candela::capture
