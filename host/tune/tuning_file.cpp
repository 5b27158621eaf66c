// Reads and writes results of tuning.
#include "host/tune/tuning_file.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "host/core/atomic_file.h"
#include "host/core/errors.h"
#include "host/core/hash_text.h"
#include "host/core/version.h"
#include "host/device/kernel.h"
#include "host/scene/hash.h"

namespace candela::tune {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kSchema = "candela-tune/1";
constexpr std::size_t kMaxFileSize = std::size_t{1} << 16;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

ordered_json toJson(const TuningKey& key) {
  return {{"device", key.device},
          {"driver", key.driver},
          {"driverVersion", key.driverVersion},
          {"pipelineCacheUuid", key.pipelineCacheUuid},
          {"kernels", key.kernels}};
}

std::string dump(const ordered_json& object, int indent = -1) {
  return object.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

// Refuses devices and pipes, which could block a reader forever.
std::optional<std::string> readSmallFile(const fs::path& file, std::string& problem) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor.isOpen()) {
    if (errno != ENOENT && errno != ENOTDIR) problem = std::generic_category().message(errno);
    return std::nullopt;
  }
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    problem = "not a regular file";
    return std::nullopt;
  }
  std::string text(kMaxFileSize + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t count = ::read(descriptor.get(), text.data() + size, text.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) problem = std::generic_category().message(errno);
    if (count <= 0) break;
    size += static_cast<std::size_t>(count);
  }
  if (size > kMaxFileSize) problem = "too large";
  text.resize(size);
  return problem.empty() ? std::optional(text) : std::nullopt;
}

std::string textAt(const json& object, const std::string& key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// The date is printed, so that nothing but a date is accepted.
bool isDate(const std::string& text) {
  constexpr std::string_view kPattern = "0000-00-00T00:00:00Z";
  return text.size() == kPattern.size() && std::equal(text.begin(), text.end(), kPattern.begin(), [](char c, char p) {
           return p == '0' ? c >= '0' && c <= '9' : c == p;
         });
}

// Requires exactly one known value of each dimension.
std::optional<Candidate> candidateIn(const json& choice) {
  if (!choice.is_object() || choice.size() != dimensionTable().size()) return std::nullopt;
  Candidate candidate;
  for (const Dimension& dimension : dimensionTable()) {
    const std::optional<std::size_t> value = valueNamed(dimension, textAt(choice, dimension.option));
    if (!value) return std::nullopt;
    candidate.push_back(*value);
  }
  return candidate;
}

TuningLookup refuse(std::string problem) { return {std::nullopt, std::move(problem)}; }

TuningLookup parse(const std::string& text, const TuningKey& key, const vulkan::DeviceInfo& info) {
  const json file = json::parse(text, nullptr, false);
  if (!file.is_object()) return refuse("it is damaged");
  if (textAt(file, "schema") != kSchema) return refuse("it was written by another version of Candela");
  if (file.value("key", json()) != json::parse(dump(toJson(key)))) {
    return refuse("it is for another device, driver or set of kernels");
  }
  const std::optional<Candidate> candidate = candidateIn(file.value("choice", json()));
  const std::string date = textAt(file, "date");
  if (!candidate || !isDate(date)) return refuse("it is damaged");
  if (!isFeasible(*candidate, info)) return refuse("the device does not support its settings");
  return {Tuning{*candidate, date}, ""};
}

}  // namespace

TuningKey keyOf(const vulkan::DeviceInfo& info) {
  return {info.name, info.driver, fmt::to_string(info.driverVersion), info.pipelineCacheUuid,
          std::string(device::kernelsHash())};
}

std::optional<fs::path> cacheFolder() {
  if (const std::string own = variable("CANDELA_CACHE_DIR"); !own.empty()) return own;
  if (const fs::path caches = variable("XDG_CACHE_HOME"); caches.is_absolute()) return caches / "candela";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "candela";
  return std::nullopt;
}

std::string fileNameOf(const TuningKey& key) {
  const std::string text = dump(toJson(key));
  return "tune-" + hashText(scene::fnv1a({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()})) + ".json";
}

TuningLookup readTuning(const fs::path& file, const TuningKey& key, const vulkan::DeviceInfo& info) {
  std::string problem;
  const std::optional<std::string> text = readSmallFile(file, problem);
  return text ? parse(*text, key, info) : refuse(problem);
}

void requireTuningFile(const fs::path& file) {
  const auto fail = [&](const std::string& cause) {
    throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), cause));
  };
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) fail("it is not a regular file");
  fs::path existing = fs::absolute(file, error).parent_path();
  while (!fs::exists(existing, error) && existing != existing.parent_path()) existing = existing.parent_path();
  if (!fs::is_directory(existing, error)) fail(fmt::format("\"{}\" is not a folder", existing.string()));
  if (::access(existing.c_str(), W_OK | X_OK) != 0) fail(std::generic_category().message(errno));
}

void writeTuning(const fs::path& file, const TuningKey& key, const Tuning& tuning) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw FileError(fmt::format("cannot create \"{}\": {}", file.parent_path().string(), error.message()));
  ordered_json content{{"schema", kSchema}, {"version", versionText()}, {"date", tuning.date}, {"key", toJson(key)}};
  for (std::size_t i = 0; i < tuning.candidate.size(); ++i) {
    const Dimension& dimension = dimensionTable()[i];
    content["choice"][dimension.option] = dimension.values[tuning.candidate[i]].name;
  }
  const std::string text = dump(content, 2) + "\n";
  writeFileAtomically(file, std::as_bytes(std::span(text)));
}

std::string dateNow() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace candela::tune
