// Computes the patches of the teapot from its profiles and from half of its handle and spout.
#include "host/scene/generate/teapot_patches.h"

#include <algorithm>

namespace candela::generate {
namespace {

/// A control point of a profile: its distance from the axis, its height, and the distance of the inner control points
/// of a quarter circle along their tangent, as a fraction of the distance from the axis.
struct ProfilePoint {
  double radius;
  double height;
  double tangent = 0.56;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kRim{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}};
constexpr Profile kUpperBody{{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}};
constexpr Profile kLowerBody{{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}};
constexpr Profile kKnob{{{0, 3.15}, {0.8, 3.15, 0.5625}, {0, 2.85}, {0.2, 2.7}}};
constexpr Profile kLid{{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}};
constexpr Profile kBottom{{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}};

/// The half at y <= 0 of parts that are symmetric about y = 0.
constexpr BezierPatch kUpperHandle{{{{{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}}},
                                    {{{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}}},
                                    {{{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3, -0.3, 2.25}, {-3, 0, 2.25}}},
                                    {{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}}}};
constexpr BezierPatch kLowerHandle{
    {{{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}},
     {{{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3, -0.3, 1.35}, {-3, 0, 1.35}}},
     {{{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}}},
     {{{-2, 0, 0.9}, {-2, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}}}};
constexpr BezierPatch kLowerSpout{{{{{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}}},
                                   {{{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}}},
                                   {{{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}}},
                                   {{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}}}};
constexpr BezierPatch kUpperSpout{
    {{{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}},
     {{{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}}},
     {{{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}}},
     {{{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}}}};

class Assembly {
 public:
  /// Appends four quarters of a surface of revolution. The first begins at +x; they follow clockwise (`sense` -1) or
  /// counter-clockwise (1), seen from above.
  void revolve(const Profile& profile, double sense) {
    BezierPatch quarter;
    for (std::size_t row = 0; row < 4; ++row) {
      const auto& [radius, height, tangent] = profile[row];
      const double inner = radius * tangent;
      quarter[row] = {{{radius, 0, height},
                       {radius, sense * inner, height},
                       {inner, sense * radius, height},
                       {0, sense * radius, height}}};
    }
    for (int i = 0; i < 4; ++i) {
      add(quarter);
      for (auto& row : quarter) {
        for (glm::dvec3& point : row) point = {-sense * point.y, sense * point.x, point.z};
      }
    }
  }

  void addWithMirrorImage(BezierPatch patch) {
    add(patch);
    for (auto& row : patch) {
      std::ranges::reverse(row);  // keeps the front of the patch outside
      for (glm::dvec3& point : row) point.y = -point.y;
    }
    add(patch);
  }

  const std::array<BezierPatch, 32>& patches() const { return patches_; }

 private:
  void add(const BezierPatch& patch) { patches_[count_++] = patch; }

  std::array<BezierPatch, 32> patches_{};
  std::size_t count_ = 0;
};

}  // namespace

std::array<BezierPatch, 32> teapotPatches() {
  Assembly teapot;
  for (const Profile& profile : {kRim, kUpperBody, kLowerBody}) teapot.revolve(profile, -1);
  for (const BezierPatch& patch : {kUpperHandle, kLowerHandle, kLowerSpout, kUpperSpout}) {
    teapot.addWithMirrorImage(patch);
  }
  for (const Profile& profile : {kKnob, kLid}) teapot.revolve(profile, -1);
  teapot.revolve(kBottom, 1);
  return teapot.patches();
}

}  // namespace candela::generate
