// cornell: the Cornell box with a mirror ball and a glass ball instead of its blocks, each ball one mesh.
#include <array>

#include "host/scene/generate/cube_sphere.h"
#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr double kBallRadius = 100;                 ///< radius of both balls, millimetres
constexpr glm::dvec3 kMirrorCentre{380, 101, 370};  ///< on the left at the back: the left of the picture is +x
constexpr glm::dvec3 kGlassCentre{175, 101, 180};
constexpr double kGlassIor = 1.5;

constexpr glm::dvec3 kWhite{0.725, 0.71, 0.68};
constexpr glm::dvec3 kGreen{0.14, 0.45, 0.091};
constexpr glm::dvec3 kRed{0.63, 0.065, 0.05};
constexpr glm::dvec3 kLampRadiance{17, 12, 4};

// The box as measured at Cornell University's Program of Computer Graphics, in millimetres. Every polygon is
// counter-clockwise seen from inside.
using Quad = std::array<glm::dvec3, 4>;
constexpr Quad kLamp{{{343, 548.8, 227}, {343, 548.8, 332}, {213, 548.8, 332}, {213, 548.8, 227}}};
constexpr Quad kCeiling{{{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}};
constexpr Quad kFloor{{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}};
constexpr Quad kBack{{{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}};
constexpr Quad kRight{{{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}};
constexpr Quad kLeft{{{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}}};

Surface diffuse(const glm::dvec3& colour) { return {colour, 1, 0, 0, 0, 1}; }

/// Writes a frame around the light that closes the ceiling: no light reaches the space above.
void writeCeiling(NffWriter& out) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    out.polygon(Quad{kCeiling[i], kCeiling[next], kLamp[next], kLamp[i]});
  }
}

void writeBox(NffWriter& out) {
  out.areaLight(kLamp[0], kLamp[1] - kLamp[0], kLamp[3] - kLamp[0], kLampRadiance);
  out.surface(diffuse(kWhite));
  out.polygon(kFloor);
  writeCeiling(out);
  out.polygon(kBack);
  out.surface(diffuse(kGreen));
  out.polygon(kRight);
  out.surface(diffuse(kRed));
  out.polygon(kLeft);
}

void writeBall(NffWriter& out, const glm::dvec3& centre, std::uint32_t size) {
  writeCubeSphere(out, size, [&](const glm::dvec3& direction) { return centre + kBallRadius * direction; });
}

}  // namespace

std::uint64_t cornellPrimitives(std::uint32_t size) {
  constexpr std::uint64_t kBoxAndLamp = 8 * 2 + 2;
  return 2 * 12 * std::uint64_t{size} * size + kBoxAndLamp;
}

void writeCornell(NffWriter& out, std::uint32_t size) {
  out.background({0, 0, 0});
  out.view({{278, 273, -800}, {278, 273, 0}, {0, 1, 0}, 39.3077, 0});
  writeBox(out);
  out.surface({{0.9, 0.9, 0.9}, 0, 1, 0, 0, 1});
  writeBall(out, kMirrorCentre, size);
  out.surface({{1, 1, 1}, 0, 0, 0, 1, kGlassIor});
  writeBall(out, kGlassCentre, size);
}

}  // namespace candela::generate
