// PLY files made in code, and short ways to read them.
#pragma once
#include <bit>
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/ply/ply_loader.h"

namespace candela::ply {

inline scene::LoadedScene load(const std::string& bytes, const scene::LoadOptions& options = {},
                               const std::filesystem::path& folder = ".") {
  return plyLoader().open({bytes, "test.ply", folder}, options, false)->at(options.time);
}
inline scene::Scene sceneOf(const std::string& bytes) { return load(bytes).scene; }
inline scene::Mesh meshOf(const std::string& bytes) { return load(bytes).scene.meshes.at(0); }

/// The error of a file; empty if it is read.
inline std::string errorOf(const std::string& bytes, const scene::LoadOptions& options = {}) {
  try {
    load(bytes, options);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

/// Returns the messages of all warnings.
inline std::vector<std::string> warningsOf(const scene::LoadedScene& loaded) {
  std::vector<std::string> messages;
  for (const scene::Diagnostic& warning : loaded.warnings) messages.push_back(toString(warning));
  return messages;
}

/// A header with an encoding and its lines.
inline std::string header(const std::string& lines, const std::string& encoding = "ascii") {
  return "ply\nformat " + encoding + " 1.0\n" + lines + "end_header\n";
}

inline const std::string kPositions = "property float x\nproperty float y\nproperty float z\n";
inline const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

/// A triangle with further properties of its vertices.
inline std::string triangle(const std::string& properties, const std::vector<std::string>& rows) {
  return header("element vertex 3\n" + kPositions + properties + kFaces) + "0 0 0 " + rows.at(0) + "\n1 0 0 " +
         rows.at(1) + "\n0 1 0 " + rows.at(2) + "\n3 0 1 2\n";
}

/// The bytes of a number in one of both orders.
template <class Number>
std::string bytesOf(Number number, bool isBigEndian) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if (isBigEndian != (std::endian::native == std::endian::big)) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

}  // namespace candela::ply
