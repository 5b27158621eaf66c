// The environment: its light samples compared with their density, its taps with the interpolated map, and its light
// with closed forms.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <tuple>

#include "host/image/film.h"
#include "host/scene/environment/placement.h"
#include "host/scene/environment/weights.h"
#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using std::numbers::pi;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

constexpr std::size_t kEnvironmentSamples = 1000000;
constexpr std::uint32_t kWidth = 18;  // no power of two
constexpr std::uint32_t kHeight = 8;

scene::Environment prepared(std::uint32_t width, std::uint32_t height, std::vector<vec3> texels, const vec3& up,
                            double degrees, bool hasRowsAtPoles = false) {
  scene::Environment map{.name = "map",
                         .width = width,
                         .height = height,
                         .texels = std::move(texels),
                         .weights = {},
                         .hasRowsAtPoles = hasRowsAtPoles};
  environment::setWeights(map);
  environment::place(map, up, degrees);
  return map;
}

// Texels of very different luminance, no two of them equal, some of them black.
const scene::Environment& wildMap(bool hasRowsAtPoles = false) {
  const auto make = [](bool atPoles) {
    std::mt19937 random(11);
    std::vector<vec3> texels;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
      const float bright = std::exp2(static_cast<float>(random() % 1024) / 100.0f - 5.0f);
      texels.push_back(i % 7 == 3 ? vec3(0) : bright * vec3(1, 0.5f, 0.25f + static_cast<float>(i) / 1000));
    }
    return prepared(kWidth, kHeight, texels, {0, 0, 1}, 35, atPoles);
  };
  static const scene::Environment map = make(false), mapAtPoles = make(true);
  return hasRowsAtPoles ? mapAtPoles : map;
}

scene::Scene under(const scene::Environment& map) {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f))).sphere({0, 0, 0}, 1);
  b.scene.environment = map;
  return b.scene;
}

// The angle from the upper pole, in radians, of a row coordinate of the map.
double polarAngle(const scene::Environment& map, double t) {
  return map.hasRowsAtPoles ? pi * (t - 0.5) / (map.height - 1) : pi * t / map.height;
}

// Map coordinates of a direction of the scene, in texels.
dvec2 coordinatesOf(const scene::Environment& map, const dvec3& direction) {
  const double x = dot(direction, dvec3(map.axes[0])), y = dot(direction, dvec3(map.axes[1]));
  const double z = dot(direction, dvec3(map.axes[2]));
  const double down = 0.5 - std::asin(std::clamp(y, -1.0, 1.0)) / pi;
  return {map.width * (0.5 + std::atan2(z, x) / (2 * pi)),
          map.hasRowsAtPoles ? 0.5 + (map.height - 1) * down : map.height * down};
}

// The direction of the map's frame at map coordinates.
dvec3 mapDirectionAt(const scene::Environment& map, const dvec2& at) {
  const double azimuth = 2 * pi * (at.x / map.width - 0.5), polar = polarAngle(map, at.y);
  return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

double sineOf(const scene::Environment& map, const dvec3& direction) {
  return length(cross(direction, dvec3(map.axes[1])));
}

// The texel `down` rows below and `across` columns beside another one, beyond the edges too, where rows at the poles
// are reflected.
std::size_t neighbour(const scene::Environment& map, int column, int row, int across, int down) {
  int x = column + across, y = row + down;
  if (y < 0 || y >= static_cast<int>(kHeight)) {
    const int beyond = map.hasRowsAtPoles ? 0 : 1;
    y = y < 0 ? -beyond - y : 2 * static_cast<int>(kHeight) - 2 + beyond - y;
    x += map.hasRowsAtPoles ? 0 : kWidth / 2;
  }
  return static_cast<std::size_t>(y) * kWidth +
         static_cast<std::size_t>((x + 2 * static_cast<int>(kWidth)) % static_cast<int>(kWidth));
}

// Luminance times solid angle of each texel, relative to the sum.
std::vector<double> sharesOf(const scene::Environment& map) {
  std::vector<double> shares;
  double sum = 0;
  for (std::size_t i = 0; i < map.texels.size(); ++i) {
    const auto row = static_cast<double>(i / map.width);
    const double top = std::max(polarAngle(map, row), 0.0), bottom = std::min(polarAngle(map, row + 1), pi);
    shares.push_back(image::luminance(dvec3(map.texels[i])) * (std::cos(top) - std::cos(bottom)));
    sum += shares.back();
  }
  for (double& share : shares) share /= sum;
  return shares;
}

std::vector<EnvironmentQuery> randomQueries(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<EnvironmentQuery> queries(count);
  for (EnvironmentQuery& query : queries) {
    query.wordU = static_cast<std::uint32_t>(random());
    query.wordV = static_cast<std::uint32_t>(random());
    for (int axis = 0; axis < 2; ++axis) query.place[axis] = static_cast<float>(random() >> 8) * 0x1p-24f;
  }
  return queries;
}

// Density with which a texel is chosen, in a direction: its probability, times texels per area between the poles, times
// that area per solid angle. The texels of a row at a pole have half of the area.
double densityOf(const scene::Environment& map, const std::vector<double>& shares, std::size_t texel, double sine) {
  const std::size_t row = texel / map.width;
  if (!map.hasRowsAtPoles) return shares[texel] * map.width * map.height / (2 * pi * pi * sine);
  const double area = row == 0 || row == map.height - 1 ? 0.5 : 1;
  return shares[texel] / area * map.width * (map.height - 1) / (2 * pi * pi * sine);
}

}  // namespace

TEST_CASE("light samples of an environment are distributed as its interpolated luminance times solid angle") {
  const scene::Environment& map = wildMap(GENERATE(false, true));
  const EnvironmentLeaves leaves(under(map));
  const std::vector<double> shares = sharesOf(map);
  Cells cells(static_cast<int>(kHeight), static_cast<int>(kWidth));
  for (const LitPoint& lit : leaves.sample(randomQueries(kEnvironmentSamples, 601))) {
    REQUIRE(lit.pdf > 0);
    const dvec2 place = coordinatesOf(map, lit.wi);
    cells.add({place.y / kHeight, place.x / kWidth});
  }
  // The tent around a texel has 3/4 of its area within the texel's row or column, and 1/8 in each of those beside it.
  constexpr double kTent[3] = {0.125, 0.75, 0.125};
  std::vector<double> expected(cells.counts().size(), 0);
  for (int row = 0; row < static_cast<int>(kHeight); ++row) {
    for (int column = 0; column < static_cast<int>(kWidth); ++column) {
      for (int i = 0; i < 9; ++i) {
        const double share = shares[neighbour(map, column, row, 0, 0)];
        expected[neighbour(map, column, row, i % 3 - 1, i / 3 - 1)] += kTent[i % 3] * kTent[i / 3] * share *
                                                                       kEnvironmentSamples;
      }
    }
  }
  checkCounts(cells.counts(), expected);
}

TEST_CASE("the numbers of a light sample of an environment are divided among rows and columns to the last bit") {
  // All texels have the same weight, so that row y begins at the number 2^32 y / H, and column x at 2^32 x / W, rounded
  // down.
  scene::Environment map = wildMap();
  for (std::size_t i = 0; i < map.texels.size(); ++i) map.texels[i] = vec3(1 + static_cast<float>(i));
  map.weights.assign(map.texels.size(), scene::Environment::kMeanWeight);
  std::vector<EnvironmentQuery> queries;
  std::vector<std::uint32_t> texels;
  const auto add = [&](std::uint64_t wordU, std::uint64_t wordV, std::uint32_t row, std::uint32_t column) {
    queries.push_back({static_cast<std::uint32_t>(wordU), static_cast<std::uint32_t>(wordV)});
    texels.push_back(row * kWidth + column);
  };
  for (std::uint64_t row = 1; row <= kHeight; ++row) {
    for (std::uint64_t column = 1; column <= kWidth; ++column) {
      const std::uint64_t endOfRow = (row << 32) / kHeight, endOfColumn = (column << 32) / kWidth;
      const auto x = static_cast<std::uint32_t>(column), y = static_cast<std::uint32_t>(row);
      add(endOfRow - 1, endOfColumn - 1, y - 1, x - 1);
      if (row < kHeight && column < kWidth) add(endOfRow, endOfColumn, y, x);
    }
  }
  const std::vector<LitPoint> points = EnvironmentLeaves(under(map)).sample(queries);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CAPTURE(queries[i].wordU, queries[i].wordV);
    REQUIRE(points[i].emission.x == 1 + double{1} * texels[i]);
  }
}

TEST_CASE("a light sample of an environment has the radiance of its tap, and the density of this tap") {
  const scene::Environment& map = wildMap(GENERATE(false, true));
  const EnvironmentLeaves leaves(under(map));
  const std::vector<double> shares = sharesOf(map);
  std::map<std::tuple<float, float, float>, std::size_t> texelOf;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const vec3& texel = map.texels[i];
    texelOf[{texel.x, texel.y, texel.z}] = i;
  }
  for (const LitPoint& lit : leaves.sample(randomQueries(20000, 602))) {
    const vec3 radiance(lit.emission);
    const auto found = texelOf.find({radiance.x, radiance.y, radiance.z});
    REQUIRE(found != texelOf.end());
    const double sine = sineOf(map, lit.wi);
    if (sine < 1e-3) continue;  // rounding of the direction
    const double expected = densityOf(map, shares, found->second, sine);
    CAPTURE(found->second, sine);
    REQUIRE(lit.pdf == Approx(expected).epsilon(1e-4));  // weights are multiples of 2^-24
    const dvec2 place = coordinatesOf(map, lit.wi);
    const double down = place.y - (static_cast<double>(found->second / kWidth) + 0.5);
    REQUIRE(std::abs(down) < 1 + 1e-4);
  }
}

TEST_CASE("the mean of an environment's taps is its bilinear interpolation, and each has its texel's density") {
  const scene::Environment& map = wildMap(GENERATE(false, true));
  const EnvironmentLeaves leaves(under(map));
  constexpr std::size_t kJitters = 16384;
  const std::vector<vec3> jitter = latticeNumbers(kJitters);
  std::vector<vec3> places;
  for (const vec3& u : jitter) places.emplace_back(u.y, u.x, 0);
  const std::vector<double> shares = sharesOf(map);
  double largest = 0;
  for (const vec3& texel : map.texels) largest = std::max(largest, double{texel.x});
  for (const dvec2& at : {dvec2(4.3, 3.8), dvec2(0.2, 5.1), dvec2(17.9, 2.6), dvec2(7.25, 0.3), dvec2(12.6, 7.8),
                          dvec2(2.5, 4.5), dvec2(3.2, 0.6), dvec2(9.7, 7.1)}) {
    if (map.hasRowsAtPoles && (at.y < 0.5 || at.y > kHeight - 0.5)) continue;  // beyond the poles
    const dvec3 d = mapDirectionAt(map, at);
    const dvec3 direction = d.x * dvec3(map.axes[0]) + d.y * dvec3(map.axes[1]) + d.z * dvec3(map.axes[2]);
    const int column = static_cast<int>(std::floor(at.x - 0.5)), row = static_cast<int>(std::floor(at.y - 0.5));
    const dvec2 fraction(at.x - 0.5 - column, at.y - 0.5 - row);
    dvec3 radiance(0);
    double density = 0, densities = 0;
    for (int i = 0; i < 4; ++i) {
      const double weight = (i % 2 == 1 ? fraction.x : 1 - fraction.x) * (i / 2 == 1 ? fraction.y : 1 - fraction.y);
      const std::size_t texel = neighbour(map, column, row, i % 2, i / 2);
      radiance += weight * dvec3(map.texels[texel]);
      const double ofTexel = densityOf(map, shares, texel, std::hypot(d.x, d.z));
      density += weight * ofTexel;
      densities += ofTexel;
    }
    dvec3 mean(0);
    double meanPdf = 0;
    for (const EnvironmentTap& tap : leaves.tap(std::vector(kJitters, direction), places)) {
      mean += tap.radiance / double{kJitters};
      meanPdf += tap.pdf / double{kJitters};
    }
    CAPTURE(at.x, at.y);
    CHECK(mean.x == Approx(radiance.x).margin(2e-3 * largest));
    CHECK(mean.z == Approx(radiance.z).margin(2e-3 * largest));
    CHECK(meanPdf == Approx(density).margin(2e-3 * densities));
  }
}

TEST_CASE("the densities of an environment's taps integrate to the probability of choosing it") {
  scene::Scene scene = under(wildMap(GENERATE(false, true)));
  std::vector<double> probabilities;
  for (int lights = 1; lights <= 3; ++lights) {
    constexpr std::uint32_t kLast = 0xffffffffu;  // the word that chooses the table's last entry: the environment
    probabilities.push_back(LightLeaves(scene).choose(std::vector{kLast}).front().probability);
    const EnvironmentLeaves leaves(scene);
    double integral = 0;
    const std::vector<EnvironmentTap> taps = leaves.tap(latticeDirections(kEnvironmentSamples),
                                                        randomNumbers(kEnvironmentSamples, 603));
    for (const EnvironmentTap& tap : taps) integral += tap.pdf;
    CAPTURE(lights);
    CHECK(integral * 4 * pi / kEnvironmentSamples == Approx(probabilities.back()).epsilon(5e-3));
    if (lights == 1) {
      scene.pointLights.push_back({vec3(0, 0, 5), vec3(1)});
    } else {
      scene.materials[0].emission = vec3(1);
    }
  }
  CHECK(probabilities[0] == 1);
  CHECK(probabilities[1] < 1);
  CHECK(probabilities[2] < probabilities[1]);
}

TEST_CASE("a diffuse plane under a linear environment shows its irradiance in closed form", "[swiftshader-slow]") {
  constexpr std::uint32_t kAcross = 256, kDown = 128;
  constexpr double kSlope = 0.9;
  const bool hasRowsAtPoles = GENERATE(false, true);
  const scene::Environment size{
      .name = "", .width = kAcross, .height = kDown, .texels = {}, .weights = {}, .hasRowsAtPoles = hasRowsAtPoles};
  std::vector<vec3> texels;
  for (std::uint32_t i = 0; i < kAcross * kDown; ++i) {
    texels.emplace_back(1.0 + kSlope * mapDirectionAt(size, {i % kAcross + 0.5, i / kAcross + 0.5}));
  }
  // In the map's frame, the radiance is 1 + slope * (x, y, z). A plane of normal n receives pi + slope (2 pi / 3) n.
  const vec3 normal(0.48f, 0.6f, 0.64f);
  SceneBuilder b;
  const vec3 u = normalize(vec3(normal.y, -normal.x, 0)), v = cross(normal, u);
  b.material(diffuseMaterial(vec3(0.75f))).plane({0, 0, 0}, u, v);
  b.view(3.0f * normal + u, {0, 0, 0}, u, 1e-3f);
  for (const auto& [up, degrees] :
       {std::pair(vec3(0, 1, 0), 0.0), std::pair(vec3(0, 0, 1), 0.0), std::pair(vec3(0, 1, 0), 90.0)}) {
    b.scene.environment = prepared(kAcross, kDown, texels, up, degrees, hasRowsAtPoles);
    // The normal in the map's frame: scene (x, y, z) is map (x, z, -y) where z points up, and (-z, y, x) turned by 90
    // degrees.
    const dvec3 n = degrees > 0 ? dvec3(-normal.z, normal.y, normal.x)
                    : up.z > 0  ? dvec3(normal.x, normal.z, -normal.y)
                                : dvec3(normal);
    const dvec3 expected = 0.75 / pi * (pi + kSlope * 2 * pi / 3 * n);
    for (const bool nextEventEstimation : {true, false}) {
      render::RenderSettings settings = test::settingsOf(16, 16, 1024);
      settings.image.maxDepth = 2;
      settings.image.nextEventEstimation = nextEventEstimation;
      const dvec3 shown = test::meanOf(renderScene(b.scene, settings).film);
      CAPTURE(up.z, degrees, nextEventEstimation, hasRowsAtPoles);
      for (int channel = 0; channel < 3; ++channel) CHECK(shown[channel] == Approx(expected[channel]).epsilon(2e-3));
    }
  }
}

TEST_CASE("balls of every lobe in a white environment of radiance 1 show their albedo", "[swiftshader-slow]") {
  const std::vector<vec3> white(64 * 32, vec3(1));
  for (const scene::Material& material :
       {diffuseMaterial(vec3(1)), test::mirrorMaterial(vec3(1)), test::glassMaterial(vec3(1), 1.5f)}) {
    SceneBuilder b;
    b.material(material).sphere({0, 0, 0}, 1);
    b.view({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 20);
    b.scene.environment = prepared(64, 32, white, {0, 1, 0}, 0);
    render::RenderSettings settings = test::settingsOf(32, 32, 256);
    settings.image.rouletteStart = 64;
    const dvec3 shown = test::meanOf(renderScene(b.scene, settings).film);
    CHECK(shown.y == Approx(1).epsilon(2e-3));
  }
}

TEST_CASE("an environment lights a mixture equally by light samples and by BSDF samples", "[swiftshader-slow]") {
  SceneBuilder b;
  b.material(test::mixtureMaterial(0.4f, 0.5f, 20)).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.view({0.5f, -2.5f, 2.5f}, {0, 0, 0}, {0, 0, 1}, 1e-3f);
  b.scene.environment = wildMap();
  render::RenderSettings settings = test::settingsOf(64, 64, 1024);
  settings.image.maxDepth = 2;
  settings.image.sampler = render::SamplerKind::independent;
  const double with = test::meanOf(renderScene(b.scene, settings).film).y;
  settings.image.nextEventEstimation = false;
  settings.image.seed = 1;
  CHECK(with == Approx(test::meanOf(renderScene(b.scene, settings).film).y).epsilon(5e-3));
}
