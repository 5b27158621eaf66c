// The mesh of a PLY file.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"
#include "host/formats/ply/ply_header.h"
#include "host/scene/mesh.h"

namespace candela::ply {

/// The numbers of a file that are the colours of its mesh.
struct ColourSource {
  bool isOfFaces = false;      ///< else of vertices
  std::string name = "color";  ///< see planOf()
  bool isLinear = false;       ///< floats are linear, as in Mitsuba; else, and always integers, encoded in sRGB
};

struct Contents {
  scene::Mesh mesh{};
  std::vector<glm::vec4>
      faceColours{};             ///< of ColourSource::isOfFaces, one for each triangle; empty: the file has none
  bool hasTransparency = false;  ///< some vertex colour has an alpha below 1
  scene::StatementCounts counts{};
  std::set<std::string> omissions{};  ///< properties and elements that a picture could show: "face \"red\""
  std::set<std::string> unused{};     ///< those that no picture shows
};

/// Reads the elements after the header. Throws SceneError, and OutOfMemoryError if the mesh needs more memory than the
/// budget.
Contents readContents(const scene::SceneFile& file, const Header& header, const ColourSource& source, bool lenient,
                      scene::DiagnosticLog& log);

}  // namespace candela::ply
