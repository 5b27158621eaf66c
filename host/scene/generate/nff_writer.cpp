// Writes the text of statements in blocks.
#include "host/scene/generate/nff_writer.h"

#include <array>
#include <cmath>
#include <iterator>

namespace candela::generate {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;

/// Returns the exponent of a highlight that has half its strength at the half angle of the surface.
double phongExponent(const Surface& surface) {
  constexpr double kSharpest = 100000;
  return surface.halfAngle > 0 ? std::log(0.5) / std::log(std::cos(glm::radians(surface.halfAngle))) : kSharpest;
}

}  // namespace

void NffWriter::background(const glm::dvec3& colour) { line("b", {colour.x, colour.y, colour.z}); }

void NffWriter::view(const View& view) {
  line("v", {});
  line("from", {view.from.x, view.from.y, view.from.z});
  line("at", {view.at.x, view.at.y, view.at.z});
  line("up", {view.up.x, view.up.y, view.up.z});
  line("angle", {view.angle});
  line("hither", {view.hither});
  line("resolution", {static_cast<double>(view.width), static_cast<double>(view.height)});
}

void NffWriter::light(const glm::dvec3& position) { line("l", {position.x, position.y, position.z}); }

void NffWriter::areaLight(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                          const glm::dvec3& radiance) {
  line("al", {corner.x, corner.y, corner.z, u.x, u.y, u.z, v.x, v.y, v.z, radiance.x, radiance.y, radiance.z});
}

void NffWriter::surface(const Surface& surface) {
  const glm::dvec3& colour = surface.colour;
  line("f", {colour.x, colour.y, colour.z, surface.kd, surface.ks, phongExponent(surface), surface.t, surface.ior});
}

void NffWriter::diffuse(const glm::dvec3& colour) { surface({colour, 1, 0, 0, 0, 1}); }

void NffWriter::emitter(const glm::dvec3& radiance) {
  line("f", {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, radiance.x, radiance.y, radiance.z});
}

void NffWriter::sphere(const glm::dvec3& centre, double radius) { line("s", {centre.x, centre.y, centre.z, radius}); }

void NffWriter::box(const glm::dvec3& low, const glm::dvec3& high) {
  line("box", {low.x, low.y, low.z, high.x, high.y, high.z});
}

void NffWriter::cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& apex, double apexRadius) {
  line("c", {base.x, base.y, base.z, baseRadius, apex.x, apex.y, apex.z, apexRadius});
}

void NffWriter::polygon(std::span<const glm::dvec3> vertices) {
  count("p", vertices.size());
  for (const glm::dvec3& vertex : vertices) line("", {vertex.x, vertex.y, vertex.z});
}

void NffWriter::square(double halfWidth, double z) {
  const double h = halfWidth;
  polygon(std::array<glm::dvec3, 4>{{{h, h, z}, {-h, h, z}, {-h, -h, z}, {h, -h, z}}});
}

void NffWriter::patch(std::span<const glm::dvec3> vertices, std::span<const glm::dvec3> normals) {
  count("pp", vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3& vertex = vertices[i];
    const glm::dvec3& normal = normals[i];
    line("", {vertex.x, vertex.y, vertex.z, normal.x, normal.y, normal.z});
  }
}

void NffWriter::mesh(std::uint64_t vertexCount, std::uint64_t faceCount) {
  fmt::format_to(std::back_inserter(buffer_), "mesh {} {}", vertexCount, faceCount);
  endLine();
}

void NffWriter::meshVertex(const glm::dvec3& position) { line("", {position.x, position.y, position.z}); }

void NffWriter::meshFace(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  fmt::format_to(std::back_inserter(buffer_), "{} {} {}", a, b, c);
  endLine();
}

void NffWriter::text(std::string_view text) { buffer_.append(text); }

void NffWriter::finish() {
  sink_({buffer_.data(), buffer_.size()});
  buffer_.clear();
}

void NffWriter::line(std::string_view keyword, std::initializer_list<double> numbers) {
  buffer_.append(keyword);
  bool first = keyword.empty();
  for (const double number : numbers) {
    if (!first) buffer_.push_back(' ');
    first = false;
    fmt::format_to(std::back_inserter(buffer_), "{:.{}g}", number, digits_);
  }
  endLine();
}

void NffWriter::count(std::string_view keyword, std::uint64_t number) {
  fmt::format_to(std::back_inserter(buffer_), "{} {}", keyword, number);
  endLine();
}

void NffWriter::endLine() {
  buffer_.push_back('\n');
  if (buffer_.size() >= kBlock) finish();
}

}  // namespace candela::generate
