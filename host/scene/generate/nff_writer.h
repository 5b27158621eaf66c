// Writes scenes as text in the format that docs/scene-format.md describes, statement by statement.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <span>
#include <string_view>

namespace candela::generate {

struct View {
  glm::dvec3 from;
  glm::dvec3 at;
  glm::dvec3 up;
  double angle;  ///< vertical field of view, degrees
  double hither;
  std::uint32_t width = 512;  ///< width of the image, pixels
  std::uint32_t height = 512;
};

/// A surface as the Standard Procedural Databases describe it. NFF has eight numbers for it.
struct Surface {
  glm::dvec3 colour;
  double kd;
  double ks;
  double halfAngle;  ///< degrees, in [0, 90), at which a highlight has half its strength; 0: as sharp as possible
  double t;
  double ior;
};

/// The background of all databases but one.
inline constexpr glm::dvec3 kSkyBlue{0.078, 0.361, 0.753};

/// Numbers are printed like C's %g. The text is passed to the sink in blocks, so that a scene of any size needs little
/// memory. Exceptions of the sink are passed on.
class NffWriter {
 public:
  using Sink = std::function<void(std::string_view)>;

  /// Nine `digits` preserve every binary32.
  explicit NffWriter(Sink sink, int digits = 6) : sink_(std::move(sink)), digits_(digits) {}
  NffWriter(const NffWriter&) = delete;
  NffWriter& operator=(const NffWriter&) = delete;

  void background(const glm::dvec3& colour);
  void view(const View& view);
  void light(const glm::dvec3& position);
  /// Writes a parallelogram that emits `radiance`; u x v is its normal.
  void areaLight(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& radiance);
  void surface(const Surface& surface);
  /// Writes a diffuse material of this colour.
  void diffuse(const glm::dvec3& colour);
  /// Writes a black material that emits `radiance`.
  void emitter(const glm::dvec3& radiance);
  void sphere(const glm::dvec3& centre, double radius);
  /// Writes an axis-aligned box.
  void box(const glm::dvec3& low, const glm::dvec3& high);
  void cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& apex, double apexRadius);
  void polygon(std::span<const glm::dvec3> vertices);
  /// Writes a polygon around the z axis at height z, with its front above.
  void square(double halfWidth, double z);
  void patch(std::span<const glm::dvec3> vertices, std::span<const glm::dvec3> normals);
  /// Begins a mesh. All vertices and then all faces must follow.
  void mesh(std::uint64_t vertexCount, std::uint64_t faceCount);
  void meshVertex(const glm::dvec3& position);
  /// Writes a face. Indices of vertices begin at 1.
  void meshFace(std::uint64_t a, std::uint64_t b, std::uint64_t c);

  /// Writes text of another format as it is.
  void text(std::string_view text);

  /// Passes the rest of the text to the sink.
  void finish();

 private:
  void line(std::string_view keyword, std::initializer_list<double> numbers);
  void count(std::string_view keyword, std::uint64_t number);
  void endLine();

  Sink sink_;
  int digits_;
  fmt::memory_buffer buffer_;
};

}  // namespace candela::generate
