// Stores the sky box as 16-byte records.
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

void appendTexels(const std::vector<std::uint32_t>& texels, Rows& rows) {
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    gpu::uvec4 four(0);
    for (std::size_t k = 0; k < 4 && i + k < texels.size(); ++k) four[static_cast<int>(k)] = texels[i + k];
    rows.push_back(four);
  }
}

}  // namespace

Rows skyRows(const scene::Sky& sky) {
  Rows rows;
  std::vector<std::uint32_t> texels;
  for (const scene::SkyFace& face : sky.faces) {
    rows.push_back({face.width, face.height, static_cast<std::uint32_t>(texels.size()), 0});
    for (std::size_t i = 0; i + 2 < face.rgb.size(); i += 3) {
      texels.push_back(face.rgb[i] | std::uint32_t{face.rgb[i + 1]} << 8 | std::uint32_t{face.rgb[i + 2]} << 16);
    }
  }
  const Rows table = srgbTableRows();
  rows.insert(rows.end(), table.begin(), table.end());
  appendTexels(texels, rows);
  return rows;
}

}  // namespace candela::flatten
