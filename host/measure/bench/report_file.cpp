// Reads reports with a limited size, since a real one has a few kilobytes.
#include "host/measure/bench/report_file.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/input_file.h"
#include "host/base/json_text.h"

namespace candela::bench {

nlohmann::json readReport(const std::filesystem::path& file) {
  constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
  const std::string text = readInputFile(file, kMaxBytes, InputKind::regularFileOrPipe);
  try {
    return parseJson(text);
  } catch (const JsonSyntaxError& error) {
    throw FileError(fmt::format("{}:{}:{}: {}", file.string(), error.line, error.column, error.what()));
  }
}

}  // namespace candela::bench
