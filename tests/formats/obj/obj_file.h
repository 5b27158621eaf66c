// Short ways to read OBJ files made in code.
#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "host/formats/obj/obj_loader.h"

namespace candela::obj {

inline scene::LoadedScene load(const std::string& text, const scene::LoadOptions& options = {},
                               const std::filesystem::path& folder = "/nonexistent") {
  return objLoader().open({text, "test.obj", folder}, options, false)->at(options.time);
}
inline scene::Scene sceneOf(const std::string& text) { return load(text).scene; }

/// The messages of all warnings.
inline std::vector<std::string> warningsOf(const scene::LoadedScene& loaded) {
  std::vector<std::string> messages;
  for (const scene::Diagnostic& warning : loaded.warnings) messages.push_back(toString(warning));
  return messages;
}

/// The errors of a file, one line each; empty if it is read.
inline std::string errorsOf(const std::string& text, const scene::LoadOptions& options = {},
                            const std::filesystem::path& folder = "/nonexistent") {
  try {
    load(text, options, folder);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

/// The corners of the unit square.
inline const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace candela::obj
