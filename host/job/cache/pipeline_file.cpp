// Reads and writes files of compiled pipelines: three lines of text (schema, key, size and checksum), then the data.
#include "host/job/cache/pipeline_file.h"

#include <fmt/format.h>

#include <string_view>
#include <system_error>

#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/hash_text.h"
#include "host/job/cache/read_file.h"

namespace candela::cache {
namespace {

constexpr std::string_view kSchema = "candela-pipelines/1";
constexpr std::size_t kMaxDataBytes = std::size_t{256} << 20;
constexpr std::size_t kMaxHeaderBytes = std::size_t{1} << 16;

std::string checksumLine(std::span<const std::byte> data) {
  const std::uint64_t hash = fnv1a({reinterpret_cast<const std::uint8_t*>(data.data()), data.size()});
  return fmt::format("{} {}", data.size(), hashText(hash));
}

// Removes the first line from `text` and returns it without its newline.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

PipelineLookup refuse(std::string problem) { return {{}, std::move(problem)}; }

}  // namespace

PipelineLookup readPipelines(const std::filesystem::path& file, const DeviceKey& key) {
  std::string problem;
  const std::optional<std::string> text = readRegularFile(file, kMaxDataBytes + kMaxHeaderBytes, problem);
  if (!text) return refuse(problem);
  std::string_view rest = *text;
  if (takeLine(rest) != kSchema) return refuse("it is damaged, or was written by another version of Candela");
  if (takeLine(rest) != toText(key)) return refuse("it is for another device, driver or set of kernels");
  const std::string_view checksum = takeLine(rest);
  const std::span data = std::as_bytes(std::span(rest));
  if (checksum != checksumLine(data)) return refuse("it is damaged");
  return {{data.begin(), data.end()}, ""};
}

void writePipelines(const std::filesystem::path& file, const DeviceKey& key, std::span<const std::byte> data) {
  if (data.size() > kMaxDataBytes) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) throw FileError(fmt::format("cannot create \"{}\": {}", file.parent_path().string(), error.message()));
  const std::string header = fmt::format("{}\n{}\n{}\n", kSchema, toText(key), checksumLine(data));
  AtomicFile out(file);
  out.write(std::as_bytes(std::span(header)));
  out.write(data);
  out.commit();
}

}  // namespace candela::cache
