// `v`: the view, with its entries in any order.
#include <fmt/format.h>

#include <array>
#include <map>

#include "host/formats/nff/keywords.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"
#include "host/image/image.h"

namespace candela::scene {
namespace {

struct ViewEntry {
  std::string_view name;
  std::string_view form;
  void (*read)(Parser&, Camera&);
};

void readFrom(Parser& p, Camera& camera) { camera.from = p.in.vector("the eye's position"); }
void readAt(Parser& p, Camera& camera) { camera.at = p.in.vector("the point looked at"); }
void readUp(Parser& p, Camera& camera) { camera.up = p.in.vector("the up direction"); }
void readHither(Parser& p, Camera& camera) { camera.hither = p.in.number("the hither distance"); }

void readAngle(Parser& p, Camera& camera) {
  camera.angle = p.in.number("the angle");
  if (camera.angle > 0 && camera.angle < 180) return;
  p.log.error(p.in.lastNumber(), "the angle must be greater than 0 and less than 180 degrees");
}

void readResolution(Parser& p, Camera& camera) {
  camera.width = static_cast<std::uint32_t>(p.in.wholeNumber("the width", 1, image::kMaxImageSide));
  camera.height = static_cast<std::uint32_t>(p.in.wholeNumber("the height", 1, image::kMaxImageSide));
}

void readAperture(Parser& p, Camera& camera) {
  camera.aperture = p.in.number("the aperture");
  p.requireNonNegative("the aperture", camera.aperture, p.in.lastNumber());
}

void readFocal(Parser& p, Camera& camera) {
  camera.focal = p.in.number("the focal ratio");
  if (!(camera.focal > 0)) p.log.error(p.in.lastNumber(), "the focal ratio must be greater than 0");
}

void readViewDistance(Parser& p, Camera&) {
  p.in.number("the view distance");
  p.log.warn("view distance", p.in.lastNumber(), "\"view\" is ignored: the view plane passes through \"at\"");
}

constexpr std::array kEntries{
    ViewEntry{"from", "from x y z", readFrom},
    ViewEntry{"eye", "eye x y z", readFrom},
    ViewEntry{"at", "at x y z", readAt},
    ViewEntry{"up", "up x y z", readUp},
    ViewEntry{"angle", "angle degrees", readAngle},
    ViewEntry{"hither", "hither distance", readHither},
    ViewEntry{"resolution", "resolution width height", readResolution},
    ViewEntry{"aperture", "aperture a", readAperture},
    ViewEntry{"apperture", "apperture a", readAperture},
    ViewEntry{"focal", "focal f", readFocal},
    ViewEntry{"view", "view d", readViewDistance},
};

/// `eye` and `apperture` are synonyms of `from` and `aperture`.
std::string_view canonicalName(std::string_view name) {
  if (name == "eye") return "from";
  return name == "apperture" ? "aperture" : name;
}

using PositionsByName = std::map<std::string_view, Position>;

void readEntry(Parser& parser, const ViewEntry& entry, Camera& camera, PositionsByName& seen) {
  const Position position = parser.in.begin(entry.form).position;
  if (!seen.emplace(canonicalName(entry.name), position).second) {
    parser.log.warn("repeated view entry", position,
                    fmt::format("\"{}\" is repeated; the last one counts", entry.name));
  }
  try {
    entry.read(parser, camera);
  } catch (StatementError& error) {
    parser.log.error(error.position, std::move(error.message));
    parser.in.skipStatement();
  }
}

void requireEntries(Parser& parser, const PositionsByName& seen) {
  constexpr std::array<std::string_view, 2> kEssential{"from", "at"};
  constexpr std::array<std::string_view, 4> kWithDefault{"up", "angle", "hither", "resolution"};
  for (const std::string_view name : kEssential) {
    if (!seen.contains(name)) parser.log.error(parser.keyword, fmt::format("this view lacks \"{}\"", name));
  }
  for (const std::string_view name : kWithDefault) {
    if (seen.contains(name)) continue;
    const std::string message = fmt::format("this view lacks \"{}\"", name);
    if (parser.options.lenient) {
      parser.log.warn("view lacks " + std::string(name), parser.keyword, message + "; the default is used");
    } else {
      parser.log.error(parser.keyword, message);
    }
  }
}

void checkDirections(Parser& parser, const Camera& camera) {
  const glm::dvec3 back = glm::dvec3(camera.from) - glm::dvec3(camera.at);
  if (camera.from == camera.at) {
    parser.log.error(parser.keyword, "\"from\" and \"at\" are the same point");
  } else if (camera.up == glm::vec3(0)) {
    parser.log.error(parser.keyword, "\"up\" is the zero vector");
  } else if (glm::cross(glm::dvec3(camera.up), back) == glm::dvec3(0)) {
    parser.log.error(parser.keyword, "\"up\" is parallel to the direction of view");
  }
}

const ViewEntry* nextEntry(const Parser& parser) {
  for (const ViewEntry& entry : kEntries) {
    if (parser.tokens.peek().text == entry.name) return &entry;
  }
  return nullptr;
}

}  // namespace

bool isViewKeyword(std::string_view word) {
  for (const ViewEntry& entry : kEntries) {
    if (entry.name == word) return true;
  }
  return false;
}

void parseView(Parser& parser) {
  const std::size_t errorsBefore = parser.log.errorCount();
  const bool again = parser.scene.camera.has_value();
  if (again) parser.log.warn("second view", parser.keyword, "a second view; the last one counts");

  Camera camera;
  PositionsByName seen;
  while (true) {
    const Token& next = parser.tokens.peek();
    if (const ViewEntry* const entry = nextEntry(parser)) {
      readEntry(parser, *entry, camera, seen);
    } else if (next.atEnd() || parser.log.isFull() || findKeyword(next.text)) {
      break;
    } else {
      skipUnknown(parser);
    }
  }
  parser.scene.camera = camera;
  if (parser.log.errorCount() > errorsBefore) return;  // a missing entry may be one that could not be read
  requireEntries(parser, seen);
  if (seen.contains("from") && seen.contains("at")) checkDirections(parser, camera);
}

}  // namespace candela::scene
