// Collects the diagnostics of all files.
#include "host/formats/mitsuba/document.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/setting_words.h"
#include "host/formats/loading/text_position.h"

namespace candela::mitsuba {
namespace {

/// Finding a position takes time in proportion to the text, and is needed only for what is listed.
scene::Position positionOf(const Place& place, bool isListed) {
  return isListed ? scene::positionIn(place.document->text(), place.offset) : scene::Position{};
}

}  // namespace

Document& Report::addDocument(std::string name, std::filesystem::path folder, std::string_view text) {
  return documents_.emplace_back(std::move(name), std::move(folder), text);
}

void Report::error(const Place& place, const std::string& message) {
  scene::DiagnosticLog& log = place.document->log;
  log.error(positionOf(place, log.listsError()), message);
}

void Report::warn(const std::string& kind, const Place& place, const std::string& message) {
  scene::DiagnosticLog& log = place.document->log;
  log.warn(kind, positionOf(place, log.listsWarning(kind)), message);
}

void Report::deviate(const Place& place, const std::string& message, const std::string& lenient) {
  if (isLenient_) {
    warn(message, place, message);
  } else {
    error(place, fmt::format("{}; {} {}", message, settingWords("lenient"), lenient));
  }
}

bool Report::isFull() const {
  const auto isFullLog = [](const auto& log) { return log.isFull(); };
  return std::ranges::any_of(documents_, isFullLog, &Document::log) || std::ranges::any_of(logs_, isFullLog);
}

void Report::throwIfErrors() const {
  std::vector<scene::Diagnostic> all;
  const auto collect = [&](const scene::DiagnosticLog& log) {
    for (scene::Diagnostic& error : log.errors()) all.push_back(std::move(error));
  };
  for (const Document& document : documents_) collect(document.log);
  for (const scene::DiagnosticLog& log : logs_) collect(log);
  all.insert(all.end(), others_.begin(), others_.end());
  if (!all.empty()) throw scene::SceneError(std::move(all));
}

std::vector<scene::Diagnostic> Report::warnings() const {
  std::vector<scene::Diagnostic> all;
  const auto collect = [&](const scene::DiagnosticLog& log) {
    for (scene::Diagnostic& warning : log.warnings()) all.push_back(std::move(warning));
  };
  for (const Document& document : documents_) collect(document.log);
  for (const scene::DiagnosticLog& log : logs_) collect(log);
  return all;
}

}  // namespace candela::mitsuba
