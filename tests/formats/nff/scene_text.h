// Short ways to read scenes from text in tests.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <string_view>

#include "host/formats/nff/nff_loader.h"

namespace candela::scene {

inline LoadedScene load(const std::string& text) { return parseScene(text, "test", "."); }
inline LoadedScene loadLenient(const std::string& text) { return parseScene(text, "test", ".", {.lenient = true}); }
inline Scene sceneOf(const std::string& text) { return load(text).scene; }

/// Returns the errors of `text`; empty if there are none.
inline std::vector<Diagnostic> errorsOf(const std::string& text, const LoadOptions& options = {}) {
  try {
    parseScene(text, "test", ".", options);
    return {};
  } catch (const SceneError& error) {
    return error.diagnostics;
  }
}

inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Returns the only warning that contains `part`.
inline Diagnostic warningWith(const LoadedScene& loaded, std::string_view part) {
  const auto matches = [&](const Diagnostic& d) { return contains(d.message, part); };
  REQUIRE(std::ranges::count_if(loaded.warnings, matches) == 1);
  return *std::ranges::find_if(loaded.warnings, matches);
}

/// All scene files under `folder` of the source tree.
inline std::vector<std::filesystem::path> filesIn(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(CANDELA_SOURCE_DIR) / folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".p3f" || extension == ".nff") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace candela::scene
