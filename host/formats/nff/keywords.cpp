// The table of statements, and messages for unknown keywords.
#include "host/formats/nff/keywords.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/base/suggestion.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

constexpr std::string_view
    kViewForm = "v from x y z at x y z up x y z angle degrees hither d resolution width height [aperture a] [focal f]";
constexpr std::string_view
    kMaterialForm = "f r g b Kd Ks Shine T ior, or f r g b Kd r g b Ks Shine T ior [roughness] [emission r g b]";
constexpr std::string_view kBoxForm = "box minx miny minz maxx maxy maxz";

constexpr std::array kKeywords{
    Keyword{"v", kViewForm, "view", parseView},
    Keyword{"camera", kViewForm, "view", parseView},
    Keyword{"b", "b r g b", "background", parseBackground},
    Keyword{"bclr", "bclr r g b", "background", parseBackground},
    Keyword{"env", "env folder", "sky", parseSky},
    Keyword{"f", kMaterialForm, "material", parseMaterial},
    Keyword{"mat", kMaterialForm, "material", parseMaterial},
    Keyword{"l", "l x y z [r g b]", "pointLight", parsePointLight},
    Keyword{"al", "al corner(x y z) u(x y z) v(x y z) r g b", "areaLight", parseAreaLight},
    Keyword{"la", "la corner(x y z) u(x y z) v(x y z) [r g b]", "areaLight", parseAreaLightWithDefault},
    Keyword{"light", "light punctual x y z r g b, or light quad corner(x y z) r g b u(x y z) v(x y z) n", "light",
            parseNamedLight},
    Keyword{"s", "s x y z radius", "sphere", parseSphere},
    Keyword{"ms", "ms centre0(x y z) centre1(x y z) radius [t0 t1]", "movingSphere", parseMovingSphere},
    Keyword{"c", "c basex basey basez baseradius apexx apexy apexz apexradius", "cone", parseCone},
    Keyword{"p", "p n, then n times x y z", "polygon", parsePolygon},
    Keyword{"pp", "pp n, then n times x y z nx ny nz", "patch", parsePatch},
    Keyword{"pl", "pl x y z x y z x y z", "plane", parsePlane},
    Keyword{"npl", "npl nx ny nz d", "plane", parseHessianPlane},
    Keyword{"box", kBoxForm, "box", parseBox},
    Keyword{"aabb", kBoxForm, "box", parseBox},
    Keyword{"mesh", "mesh nv nf, then nv times x y z, then nf times i j k", "mesh", parseMesh},
    Keyword{"accel", "accel 0|1|2 or accel none|grid|bvh", "accel", parseAccel},
    Keyword{"spp", "spp n", "spp", parseSamples},
};

// Spellings that people use instead of the keywords.
constexpr std::array kLongNames{
    Spelling{"from", "from"},
    Spelling{"eye", "eye"},
    Spelling{"angle", "angle"},
    Spelling{"hither", "hither"},
    Spelling{"resolution", "resolution"},
    Spelling{"aperture", "aperture"},
    Spelling{"focal", "focal"},
    Spelling{"view", "v"},
    Spelling{"viewpoint", "v"},
    Spelling{"background", "b"},
    Spelling{"sky", "env"},
    Spelling{"skybox", "env"},
    Spelling{"fill", "f"},
    Spelling{"material", "f"},
    Spelling{"sphere", "s"},
    Spelling{"cone", "c"},
    Spelling{"cylinder", "c"},
    Spelling{"polygon", "p"},
    Spelling{"triangle", "p"},
    Spelling{"patch", "pp"},
    Spelling{"plane", "pl"},
    Spelling{"cube", "box"},
    Spelling{"arealight", "al"},
    Spelling{"samples", "spp"},
    Spelling{"triangles", "mesh"},
};

// Keywords of other programs' dialects, with advice.
constexpr std::array kForeign{
    Spelling{"fire", "the sky box of another dialect: write \"env\""},
    Spelling{"number", "a foreign keyword"},
    Spelling{"g", "a keyword of another dialect (group)"},
    Spelling{"Q", "a foreign keyword"},
    Spelling{"Z", "a foreign keyword"},
    Spelling{"fp", "a foreign keyword"},
    Spelling{"tess", "a keyword of another dialect (tessellation)"},
    Spelling{"shader", "a foreign keyword"},
    Spelling{"t", "a keyword of another dialect (texture)"},
    Spelling{"pt", "a keyword of another dialect (textured polygon)"},
    Spelling{"st", "a keyword of another dialect (textured sphere)"},
};

using KeywordMap = std::unordered_map<std::string_view, const Keyword*>;

const KeywordMap& keywordMap() {
  static const KeywordMap map = [] {
    KeywordMap all;
    for (const Keyword& keyword : kKeywords) all.emplace(keyword.name, &keyword);
    return all;
  }();
  return map;
}

const std::vector<Spelling>& spellings() {
  static const std::vector<Spelling> all = [] {
    std::vector<Spelling> list;
    for (const Keyword& keyword : kKeywords) list.push_back({keyword.name, keyword.name});
    list.insert(list.end(), kLongNames.begin(), kLongNames.end());
    return list;
  }();
  return all;
}

}  // namespace

const Keyword* findKeyword(std::string_view word) {
  const auto found = keywordMap().find(word);
  return found == keywordMap().end() ? nullptr : found->second;
}

std::string describeUnknown(std::string_view word) {
  const std::string unknown = fmt::format("unknown keyword {}", quote(word));
  const auto foreign = std::ranges::find(kForeign, word, &Spelling::word);
  if (foreign != kForeign.end()) {
    return fmt::format("{}, {}; {} skips it", unknown, foreign->keyword, settingWords("lenient"));
  }
  if (isViewKeyword(word)) return unknown + " outside a view, which begins with \"v\"";
  if (const auto near = suggest(word, spellings())) return fmt::format("{}; did you mean \"{}\"?", unknown, *near);
  return fmt::format("{}; comments begin with \"#\", and {} skips unknown lines", unknown, settingWords("lenient"));
}

}  // namespace candela::scene
