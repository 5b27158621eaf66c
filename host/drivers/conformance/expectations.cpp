// Reads baselines and lists of patterns.
#include "host/drivers/conformance/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "host/base/errors.h"
#include "host/base/input_file.h"

namespace candela::conformance {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& reason) {
  throw FileError(fmt::format("{}:{}: {}", file, line, reason));
}

// Calls `use` with each line that is neither empty nor a comment, and its number from 1. A byte order mark is skipped.
void forEachLine(const std::string& text, const std::function<void(const std::string&, std::size_t)>& use) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  std::istringstream lines(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty() && !line.starts_with('#')) use(line, number);
  }
}

std::string contentOf(const std::filesystem::path& file) {
  return readInputFile(file, kMaxFileBytes, InputKind::regularFileOrPipe);
}

}  // namespace

Baseline parseBaseline(const std::string& text, const std::string& fileName) {
  Baseline baseline;
  forEachLine(text, [&](const std::string& line, std::size_t number) {
    const std::size_t comma = line.find(',');
    if (comma == 0 || comma == std::string::npos) {
      refuse(fileName, number, fmt::format("expected `case,Result`, got \"{}\"", line));
    }
    const std::string word = line.substr(comma + 1, line.find(',', comma + 1) - comma - 1);
    const std::optional<Verdict> verdict = verdictNamed(word);
    if (!verdict)
      refuse(fileName, number,
             fmt::format("unknown result \"{}\"; expected Fail, Crash, Timeout, Pass or ExpectedFail", word));
    const Status status = verdict->status == Status::improvement ? verdict->improvedTo : verdict->status;
    if (!baseline.emplace(line.substr(0, comma), status).second) {
      refuse(fileName, number, fmt::format("{} occurs twice", line.substr(0, comma)));
    }
  });
  return baseline;
}

Baseline readBaseline(const std::filesystem::path& file) { return parseBaseline(contentOf(file), file.string()); }

void addBaseline(const Baseline& baseline, const std::string& fileName, Baseline& all) {
  for (const auto& [name, status] : baseline) {
    if (all.emplace(name, status).first->second == status) continue;
    throw FileError(fmt::format("{}: another baseline expects another result of {}", fileName, name));
  }
}

NamePatterns::NamePatterns(const std::string& text, const std::string& fileName) {
  forEachLine(text, [&](const std::string& line, std::size_t number) {
    try {
      expressions_.emplace_back(line);
    } catch (const std::regex_error& error) {
      refuse(fileName, number, fmt::format("\"{}\" is not a valid regular expression: {}", line, error.what()));
    }
  });
}

bool NamePatterns::match(const std::string& name) const {
  return std::ranges::any_of(expressions_, [&](const std::regex& e) { return std::regex_search(name, e); });
}

void NamePatterns::add(const NamePatterns& other) {
  expressions_.insert(expressions_.end(), other.expressions_.begin(), other.expressions_.end());
}

NamePatterns readPatterns(const std::filesystem::path& file) { return {contentOf(file), file.string()}; }

std::optional<Status> Expectations::of(std::string_view name) const {
  const auto found = baseline.find(name);
  return found == baseline.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace candela::conformance
