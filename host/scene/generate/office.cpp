// office: desks and partitions below a grid of equal light panels.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/generate/hash_sequence.h"
#include "host/scene/generate/many_lights.h"

namespace candela::generate {
namespace {

using glm::dvec3;

// Lengths are in metres. The ceiling is a grid of cells, one for each panel; there is a desk below most of them, and an
// aisle below every fourth column. What stands on something enters it a little, so that no faces coincide.
constexpr double kPanelCell = 2.4, kOfficeHeight = 3;
constexpr double kPanelWidth = 0.6, kPanelDepth = 1.2, kPanelHang = 0.02, kPanelRadiance = 3;
constexpr std::uint32_t kMinColumns = 4, kMinRows = 4;
constexpr std::uint32_t kAisleInterval = 4, kPillarInterval = 3;
constexpr std::uint32_t kRoomTriangles = 12, kBoxesPerDesk = 7;
constexpr std::uint32_t kDeskSeed = 43;

struct OfficePlan {
  std::uint32_t columns, rows;
};

OfficePlan planFor(std::uint32_t panels) {
  const std::uint32_t columns = std::max(kMinColumns, static_cast<std::uint32_t>(std::ceil(std::sqrt(panels))));
  return {columns, std::max(kMinRows, (panels + columns - 1) / columns)};
}

bool isAisle(std::uint32_t column) { return column % kAisleInterval == kAisleInterval - 1; }

std::uint64_t deskCount(const OfficePlan& plan) {
  return std::uint64_t{plan.columns - plan.columns / kAisleInterval} * plan.rows;
}

std::uint64_t pillarCount(const OfficePlan& plan) {
  return std::uint64_t{(plan.columns - 1) / kAisleInterval} * ((plan.rows - 1) / kPillarInterval);
}

void writeRoom(NffWriter& out, const OfficePlan& plan) {
  const double w = kPanelCell * plan.columns, d = kPanelCell * plan.rows, h = kOfficeHeight;
  out.diffuse({0.2, 0.22, 0.25});
  out.polygon(std::array<dvec3, 4>{{{0, 0, 0}, {0, 0, d}, {w, 0, d}, {w, 0, 0}}});
  out.diffuse(dvec3(0.8));
  out.polygon(std::array<dvec3, 4>{{{0, h, 0}, {w, h, 0}, {w, h, d}, {0, h, d}}});
  out.diffuse({0.7, 0.7, 0.68});
  out.polygon(std::array<dvec3, 4>{{{0, 0, 0}, {w, 0, 0}, {w, h, 0}, {0, h, 0}}});
  out.polygon(std::array<dvec3, 4>{{{w, 0, d}, {0, 0, d}, {0, h, d}, {w, h, d}}});
  out.diffuse({0.3, 0.45, 0.5});
  out.polygon(std::array<dvec3, 4>{{{0, 0, d}, {0, 0, 0}, {0, h, 0}, {0, h, d}}});
  out.polygon(std::array<dvec3, 4>{{{w, 0, 0}, {w, 0, d}, {w, h, d}, {w, h, 0}}});
}

// Writes desks with partitions behind them. Boxes of one material follow each other, so that a file has few materials.
void writeDesks(NffWriter& out, const OfficePlan& plan) {
  static constexpr std::array kCloths{dvec3(0.5, 0.25, 0.12), dvec3(0.16, 0.3, 0.4), dvec3(0.35, 0.38, 0.2)};
  const auto forEachDesk = [&](const auto& write) {
    for (std::uint32_t row = 0; row < plan.rows; ++row) {
      for (std::uint32_t column = 0; column < plan.columns; ++column) {
        if (isAisle(column)) continue;
        const dvec3 middle = kPanelCell * dvec3(column + 0.5, 0, row + 0.5);
        HashSequence random(kDeskSeed, static_cast<std::int32_t>(column), static_cast<std::int32_t>(row));
        write([&](const dvec3& low, const dvec3& high) { out.box(middle + low, middle + high); }, random, row);
      }
    }
  };
  for (std::size_t i = 0; i < kCloths.size(); ++i) {
    out.diffuse(kCloths[i]);
    forEachDesk([&](const auto& box, HashSequence&, std::uint32_t row) {
      if (row / 2 % kCloths.size() == i) box({-1.15, -0.01, 0.62}, {1.15, 1.25, 0.68});
    });
  }
  out.diffuse({0.62, 0.5, 0.36});
  forEachDesk([](const auto& box, HashSequence&, std::uint32_t) { box({-0.8, 0.7, -0.15}, {0.8, 0.74, 0.6}); });
  out.diffuse(dvec3(0.35));
  forEachDesk([](const auto& box, HashSequence&, std::uint32_t) {
    box({-0.75, -0.02, -0.1}, {-0.71, 0.71, 0.55});
    box({0.32, -0.02, -0.1}, {0.75, 0.71, 0.55});
  });
  out.diffuse({0.05, 0.05, 0.06});
  forEachDesk([](const auto& box, HashSequence& random, std::uint32_t) {
    const double screen = random.between(-0.3, 0.3), chair = random.between(-0.3, 0.3);
    box({screen - 0.28, 0.85, 0.36}, {screen + 0.28, 1.2, 0.4});
    box({screen - 0.03, 0.73, 0.41}, {screen + 0.03, 0.95, 0.44});
    box({chair - 0.23, 0.4, -0.75}, {chair + 0.23, 0.5, -0.3});
  });
}

}  // namespace

std::uint64_t officePrimitives(std::uint32_t size) {
  const OfficePlan plan = planFor(size);
  return 2 * std::uint64_t{size} + kRoomTriangles + kBoxesPerDesk * deskCount(plan) + pillarCount(plan);
}

void writeOffice(NffWriter& out, std::uint32_t size) {
  const OfficePlan plan = planFor(size);
  out.background(dvec3(0));
  out.view({{3.5 * kPanelCell, 1.7, 0.4}, {2.6 * kPanelCell, 1.1, 9}, {0, 1, 0}, 55, 0, 960, 540});
  writeRoom(out, plan);
  for (std::uint32_t i = 0; i < size; ++i) {
    const dvec3 middle(kPanelCell * (i % plan.columns + 0.5), kOfficeHeight - kPanelHang,
                       kPanelCell * (i / plan.columns + 0.5));
    out.areaLight(middle - dvec3(kPanelWidth, 0, kPanelDepth) / 2.0, {kPanelWidth, 0, 0}, {0, 0, kPanelDepth},
                  dvec3(kPanelRadiance));
  }
  writeDesks(out, plan);
  out.diffuse({0.7, 0.7, 0.68});
  for (std::uint32_t row = kPillarInterval; row < plan.rows; row += kPillarInterval) {
    for (std::uint32_t column = kAisleInterval; column < plan.columns; column += kAisleInterval) {
      const dvec3 middle = kPanelCell * dvec3(column, 0, row);
      out.box(middle - dvec3(0.2, 0.05, 0.2), middle + dvec3(0.2, kOfficeHeight + 0.05, 0.2));
    }
  }
}

}  // namespace candela::generate
