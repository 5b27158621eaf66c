// The statements of MTL files (Ramey, Rose and Tyerman, "MTL material format (Lightwave, OBJ)", version 4.2, 1995), and
// those that describe physically based materials (Exocortex, 2015).
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/loading/diagnostic_log.h"

namespace candela::obj {

/// The maps that are rendered.
enum class MapKind : std::uint8_t { diffuse, specular, emission, opacity, bump, normal, roughness, metalness };

/// The argument of a statement `map_...`: a file, and its options.
struct MtlMap {
  std::string file;
  scene::Position position{};  ///< of the file's name
  glm::vec2 offset{0, 0};      ///< -o
  glm::vec2 scale{1, 1};       ///< -s
  bool isClamped = false;      ///< -clamp on
  float bumpScale = 1;         ///< -bm
  char channel = 0;            ///< -imfchan: r, g, b, m (alpha) or l (luminance); 0: not stated
};

/// A material as the file states it. Absent values are empty.
struct MtlMaterial {
  std::string name;
  std::optional<glm::vec3> diffuse{};    ///< Kd
  std::optional<glm::vec3> specular{};   ///< Ks
  std::optional<glm::vec3> emission{};   ///< Ke
  std::optional<glm::vec3> filter{};     ///< Tf
  std::optional<float> exponent{};       ///< Ns
  std::optional<float> ior{};            ///< Ni
  std::optional<float> opacity{};        ///< d, or 1 - Tr
  std::optional<int> illumination{};     ///< illum
  std::optional<float> roughness{};      ///< Pr
  std::optional<float> metalness{};      ///< Pm
  std::optional<float> sheen{};          ///< Ps
  std::optional<float> coat{};           ///< Pc
  std::optional<float> coatRoughness{};  ///< Pcr
  std::optional<float> anisotropy{};     ///< aniso
  std::optional<float> rotation{};       ///< anisor, in turns
  std::map<MapKind, MtlMap> maps{};
};

struct MtlFile {
  std::vector<MtlMaterial> materials{};
  std::set<std::string> omissions{};  ///< statements and options that a picture could show: "map_Ns", "-t"
  std::set<std::string> unused{};     ///< those that no picture of a path tracer shows: "Ka"
};

/// Reads all statements. Errors are added to `log`, each with its position. Statements that are not known are
/// MtlFile::omissions, because many programs add their own.
MtlFile parseMtl(std::string_view text, bool lenient, scene::DiagnosticLog& log);

}  // namespace candela::obj
