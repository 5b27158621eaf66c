// Calls the readers of OBJ and PLY.
#include "host/formats/mitsuba/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/loading/loader.h"
#include "host/formats/loading/vertex_normals.h"
#include "host/formats/obj/corner_table.h"
#include "host/formats/obj/obj_parser.h"
#include "host/formats/ply/ply_header.h"
#include "host/formats/ply/ply_mesh.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

/// Returns the normals of smooth points, from triangles over them: three indices into `points` each.
std::vector<glm::vec3> smoothNormalsOf(std::span<const glm::vec3> points, std::span<const std::uint32_t> indices) {
  obj::SmoothNormals normals;
  std::vector<std::uint32_t> ofPoint(points.size());
  for (std::uint32_t point = 0; point < ofPoint.size(); ++point) ofPoint[point] = normals.find(point, 0);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
    normals.add({ofPoint[a], ofPoint[b], ofPoint[c]}, {points[a], points[b], points[c]});
  }
  std::vector<glm::vec3> result;
  for (const std::uint32_t normal : ofPoint) result.push_back(normals.at(normal));
  return result;
}

/// Gives each triangle vertices of its own, with its colour.
void colourFaces(scene::Mesh& mesh, std::span<const glm::vec4> colours, const std::string& name) {
  const std::size_t count = mesh.indices.size();
  requireMemory(name + ": the mesh", count * (2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::vec4)),
                "use a machine with more memory");
  const auto spread = [&](auto& attribute) {
    if (attribute.empty()) return;
    std::remove_reference_t<decltype(attribute)> corners;
    corners.reserve(count);
    for (const std::uint32_t index : mesh.indices) corners.push_back(attribute[index]);
    attribute = std::move(corners);
  };
  spread(mesh.positions);
  spread(mesh.normals);
  spread(mesh.texCoords[0]);
  mesh.colours.clear();
  mesh.colours.reserve(count);
  for (std::size_t i = 0; i < count; ++i) mesh.colours.push_back(colours[i / 3]);
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

}  // namespace

void complete(scene::Mesh& mesh, const MeshFileOptions& options) {
  if (options.hasFaceNormals) mesh.normals.clear();
  if (mesh.normals.empty() && !options.hasFaceNormals) mesh.normals = smoothNormalsOf(mesh.positions, mesh.indices);
  if (!mesh.normals.empty()) scene::replaceZeroNormals(mesh);
  if (!options.flipsTexCoords) return;
  for (glm::vec2& uv : mesh.texCoords[0]) uv.y = 1 - uv.y;
}

scene::Mesh readObjMesh(const std::filesystem::path& path, std::string_view bytes, const MeshFileOptions& options,
                        const Place& place, Report& report) {
  scene::DiagnosticLog& log = report.addLog(path.string());
  const scene::SceneFile file{bytes, path.string(), scene::folderOrCurrent(path.parent_path())};
  obj::ObjModel model = obj::parseObj(file, report.isLenient(), log);
  if (log.errorCount() > 0) throw PlacedError{place, fmt::format("{} cannot be read", quote(path.filename().string()))};
  if (model.corners.empty()) throw PlacedError{place, fmt::format("{} has no faces", quote(path.filename().string()))};
  for (const auto& [keyword, what] : model.omissions) report.omit(fmt::format("{} of OBJ ({})", what, keyword));
  const auto isStated = [&](const obj::Corner& corner) { return corner.normal < obj::ObjModel::kSmooth; };
  const bool hasNormals = !options.hasFaceNormals && std::ranges::any_of(model.corners, isStated);
  const bool isSmooth = !options.hasFaceNormals && !hasNormals;
  const bool hasTexCoords = std::ranges::any_of(
      model.corners, [](const obj::Corner& corner) { return corner.texCoord != obj::kNone; });
  obj::CornerTable table(model.positions.size());
  table.beginMesh();
  scene::Mesh mesh;
  for (obj::Corner corner : model.corners) {
    if (!hasNormals || !isStated(corner)) corner.normal = obj::kNone;
    mesh.indices.push_back(table.vertexOf(corner));
  }
  if (isSmooth) {
    std::vector<std::uint32_t> indices;
    for (const obj::Corner& corner : model.corners) indices.push_back(corner.position);
    const std::vector<glm::vec3> normals = smoothNormalsOf(model.positions, indices);
    for (const obj::Corner& vertex : table.vertices()) mesh.normals.push_back(normals[vertex.position]);
  }
  for (const obj::Corner& vertex : table.vertices()) {
    mesh.positions.push_back(model.positions[vertex.position]);
    if (hasTexCoords) {
      mesh.texCoords[0].push_back(vertex.texCoord == obj::kNone ? glm::vec2(0) : model.texCoords[vertex.texCoord]);
    }
    if (hasNormals) {
      mesh.normals.push_back(vertex.normal == obj::kNone
                                 ? glm::vec3(0)
                                 : scene::unitNormalOrZero(glm::dvec3(model.normals[vertex.normal])));
    }
  }
  complete(mesh, options);
  return mesh;
}

scene::Mesh readPlyMesh(const std::filesystem::path& path, std::string_view bytes, const MeshFileOptions& options,
                        const Place& place, Report& report) {
  scene::DiagnosticLog& log = report.addLog(path.string());
  const scene::SceneFile file{bytes, path.string(), scene::folderOrCurrent(path.parent_path())};
  const ply::Header header = ply::readHeader(file);
  ply::ColourSource source{.isLinear = true};
  if (options.attribute) source = {options.attribute->isOfFaces, options.attribute->name, true};
  ply::Contents contents = ply::readContents(file, header, source, report.isLenient(), log);
  if (log.errorCount() > 0) throw PlacedError{place, fmt::format("{} cannot be read", quote(path.filename().string()))};
  complete(contents.mesh, options);
  if (!contents.faceColours.empty()) colourFaces(contents.mesh, contents.faceColours, file.name);
  return std::move(contents.mesh);
}

}  // namespace candela::mitsuba
