// Writes glTF files.
#include "tests/formats/gltf/gltf_file.h"

#include <algorithm>

#include "host/judge/report/base64.h"

namespace candela::gltf {
namespace {

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xffu);
  return bytes;
}

std::string padded(std::string chunk, char filler) {
  while (chunk.size() % 4 != 0) chunk += filler;
  return chunk;
}

}  // namespace

std::string GltfFile::text() const {
  json file = root;
  if (!binary.empty() && file.is_object() && !file.contains("buffers")) {
    const std::string uri = "data:application/octet-stream;base64," +
                            report::base64(std::as_bytes(std::span(binary.data(), binary.size())));
    file["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri}}};
  }
  return file.dump();
}

std::string GltfFile::glb() const {
  json file = root;
  file["buffers"] = {{{"byteLength", binary.size()}}};
  return glbOf({{0x4e4f534a, padded(file.dump(), ' ')}, {0x004e4942, padded(binary, '\0')}});
}

GltfFile triangleFile() {
  GltfFile file;
  const std::size_t positions = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  file.addMesh({{"attributes", {{"POSITION", positions}}}});
  return file;
}

std::string glbOf(const std::vector<std::pair<std::uint32_t, std::string>>& chunks) {
  std::string body;
  for (const auto& [type, content] : chunks) {
    body += word(static_cast<std::uint32_t>(content.size())) + word(type) + content;
  }
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + body.size())) + body;
}

std::string errorsOf(const std::string& bytes, const scene::LoadOptions& options) {
  try {
    loadText(bytes, options);
    return {};
  } catch (const FileError& error) {
    CHECK(error.code() == ExitCode::file);
    return error.what();
  }
}

bool warns(const scene::LoadedScene& loaded, std::string_view part) {
  return std::ranges::any_of(loaded.warnings, [&](const scene::Diagnostic& warning) {
    return warning.message.find(part) != std::string::npos;
  });
}

}  // namespace candela::gltf
