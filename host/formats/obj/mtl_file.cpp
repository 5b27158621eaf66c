// Reads the statements of an MTL file.
#include "host/formats/obj/mtl_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/lower_case.h"
#include "host/base/quote.h"
#include "host/formats/obj/lines.h"

namespace candela::obj {
namespace {

using scene::quote;

struct ColourStatement {
  std::string_view keyword;
  std::optional<glm::vec3> MtlMaterial::*member;
};
constexpr std::array kColours{
    ColourStatement{"kd", &MtlMaterial::diffuse}, ColourStatement{"ks", &MtlMaterial::specular},
    ColourStatement{"ke", &MtlMaterial::emission}, ColourStatement{"tf", &MtlMaterial::filter}};

constexpr float kUnlimited = 3.4e38f;

struct NumberStatement {
  std::string_view keyword;
  std::optional<float> MtlMaterial::*member;
  float max;  ///< the least value is 0
};
constexpr std::array kNumbers{NumberStatement{"ns", &MtlMaterial::exponent, kUnlimited},
                              NumberStatement{"ni", &MtlMaterial::ior, kUnlimited},
                              NumberStatement{"pr", &MtlMaterial::roughness, 1},
                              NumberStatement{"pm", &MtlMaterial::metalness, 1},
                              NumberStatement{"ps", &MtlMaterial::sheen, 1},
                              NumberStatement{"pc", &MtlMaterial::coat, 1},
                              NumberStatement{"pcr", &MtlMaterial::coatRoughness, 1},
                              NumberStatement{"aniso", &MtlMaterial::anisotropy, 1},
                              NumberStatement{"anisor", &MtlMaterial::rotation, 1}};

struct MapStatement {
  std::string_view keyword;
  MapKind kind;
};
constexpr std::array kMaps{MapStatement{"map_kd", MapKind::diffuse},  MapStatement{"map_ks", MapKind::specular},
                           MapStatement{"map_ke", MapKind::emission}, MapStatement{"map_d", MapKind::opacity},
                           MapStatement{"bump", MapKind::bump},       MapStatement{"map_bump", MapKind::bump},
                           MapStatement{"norm", MapKind::normal},     MapStatement{"map_norm", MapKind::normal},
                           MapStatement{"map_kn", MapKind::normal},   MapStatement{"map_pr", MapKind::roughness},
                           MapStatement{"map_pm", MapKind::metalness}};

/// Statements and options that change nothing in pictures of a path tracer: ambient light, the size of textures.
constexpr std::array<std::string_view, 5> kUnused{"ka", "map_ka", "sharpness", "map_aat", "map_refl_aat"};
constexpr std::array<std::string_view, 3> kUnusedOptions{"-blendu", "-blendv", "-texres"};

class MtlParser {
 public:
  MtlParser(std::string_view text, bool lenient, scene::DiagnosticLog& log)
      : lines_(text), isLenient_(lenient), log_(log) {}

  MtlFile parse() {
    readLines(lines_, isLenient_, log_, [this] { readStatement(); });
    return std::move(file_);
  }

 private:
  void readStatement() {
    const Word keyword = lines_.word();
    if (keyword.text.empty()) return;
    const std::string name = lowerCase(std::string(keyword.text));
    if (name == "newmtl") return beginMaterial();
    if (file_.materials.empty()) {
      Lines::fail(keyword.position, fmt::format("{} before any newmtl", quote(keyword.text)));
    }
    if (!readValue(name) && !readMap(name)) omit(keyword, name);
  }

  void omit(const Word& keyword, const std::string& name) {
    const bool isUnused = std::ranges::count(kUnused, name) > 0;
    (isUnused ? file_.unused : file_.omissions).insert(shown(keyword.text));
    lines_.skipRest();
  }

  /// The first bytes of a word, which may be shown.
  static std::string shown(std::string_view word) {
    const std::string quoted = quote(word);
    return quoted.substr(1, quoted.size() - 2);
  }

  void beginMaterial() {
    const Word name = lines_.rest();
    if (name.text.empty()) Lines::fail(name.position, "expected the name of the material");
    file_.materials.push_back({.name = std::string(name.text)});
  }

  bool readValue(const std::string& name) {
    MtlMaterial& material = file_.materials.back();
    const auto* const colour = std::ranges::find(kColours, name, &ColourStatement::keyword);
    if (colour != kColours.end()) {
      if (const std::optional<glm::vec3> value = readColour(name)) material.*(colour->member) = value;
      return true;
    }
    const auto* const number = std::ranges::find(kNumbers, name, &NumberStatement::keyword);
    if (number != kNumbers.end()) {
      material.*(number->member) = readNumber(number->max);
      return true;
    }
    if (name == "d" || name == "tr") {
      readOpacity(name, material);
    } else if (name == "illum") {
      readIllumination(material);
    } else {
      return false;
    }
    return true;
  }

  /// r g b, or one number for all; nothing for other colour spaces.
  std::optional<glm::vec3> readColour(const std::string& name) {
    if (const std::string_view first = peek(); first == "spectral" || first == "xyz") {
      file_.omissions.insert(fmt::format("{} {}", name, first));
      lines_.skipRest();
      return std::nullopt;
    }
    glm::vec3 colour(readNumber(kUnlimited));
    if (lines_.hasWord()) {
      colour.y = readNumber(kUnlimited);
      colour.z = readNumber(kUnlimited);
    }
    return colour;
  }

  float readNumber(float max) {
    lines_.hasWord();
    const scene::Position position = lines_.here();
    const float number = lines_.number("a number");
    if (number < 0 || number > max) {
      Lines::fail(position, number < 0 ? fmt::format("{} is negative", number)
                                       : fmt::format("{} is outside 0 to {}", number, max));
    }
    return number;
  }

  /// Reads `d` or `Tr`. `d` takes precedence, because some programs reverse the meaning of `Tr`.
  void readOpacity(const std::string& name, MtlMaterial& material) {
    if (peek() == "-halo") {
      lines_.word();
      file_.omissions.insert("d -halo");
    }
    const float number = readNumber(1);
    const bool isOpacity = name == "d";
    if (isOpacity || !hasOpacity_.contains(file_.materials.size())) material.opacity = isOpacity ? number : 1 - number;
    if (isOpacity) hasOpacity_.insert(file_.materials.size());
  }

  void readIllumination(MtlMaterial& material) {
    constexpr std::int64_t kMaxModel = 10;
    lines_.hasWord();
    const scene::Position position = lines_.here();
    std::int64_t model = 0;
    if (!lines_.index(model) || model < 0 || model > kMaxModel) {
      Lines::fail(position, fmt::format("expected an illumination model from 0 to {}", kMaxModel));
    }
    material.illumination = static_cast<int>(model);
  }

  bool readMap(const std::string& name) {
    const auto* const found = std::ranges::find(kMaps, name, &MapStatement::keyword);
    if (found == kMaps.end()) return false;
    MtlMap map;
    while (peek().starts_with('-') && readOption(map)) {
    }
    const Word file = lines_.rest();
    if (file.text.empty()) Lines::fail(file.position, "expected the name of an image file");
    map.file = file.text;
    std::ranges::replace(map.file, '\\', '/');  // as programs on Windows write it
    map.position = file.position;
    file_.materials.back().maps[found->kind] = std::move(map);
    return true;
  }

  /// Reads an option of a map. Returns false, and stays, if the word is none.
  bool readOption(MtlMap& map) {
    const std::string name = lowerCase(std::string(peek()));
    if (name == "-o" || name == "-s" || name == "-t") {
      lines_.word();
      const glm::vec3 numbers = readUpToThree(name == "-s" ? 1.0f : 0.0f);
      if (name == "-o") map.offset = glm::vec2(numbers);
      if (name == "-s") map.scale = glm::vec2(numbers);
      if (name == "-t") file_.omissions.insert(name);
    } else if (name == "-clamp") {
      lines_.word();
      map.isClamped = readSwitch();
    } else if (name == "-bm") {
      lines_.word();
      map.bumpScale = lines_.number("a number");
    } else if (name == "-imfchan") {
      lines_.word();
      readChannel(map);
    } else {
      return readOtherOption(name);
    }
    return true;
  }

  /// Reads options that have no effect here: the number of their arguments is known.
  bool readOtherOption(const std::string& name) {
    if (std::ranges::count(kUnusedOptions, name) == 0 && name != "-mm" && name != "-boost" && name != "-cc" &&
        name != "-type") {
      return false;
    }
    lines_.word();
    (std::ranges::count(kUnusedOptions, name) > 0 ? file_.unused : file_.omissions).insert(name);
    lines_.word();
    if (name == "-mm") lines_.word();
    return true;
  }

  glm::vec3 readUpToThree(float absent) {
    glm::vec3 numbers(absent);
    numbers.x = lines_.number("a number");
    for (int i = 1; i < 3 && startsNumber(peek()); ++i) numbers[i] = lines_.number("a number");
    return numbers;
  }

  /// A file name may begin with a digit, so that the whole word must look like a number.
  static bool startsNumber(std::string_view word) {
    return !word.empty() && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos &&
           word.find_first_of("0123456789") != std::string_view::npos;
  }

  bool readSwitch() {
    const Word word = lines_.word();
    if (word.text != "on" && word.text != "off") {
      Lines::fail(word.position, fmt::format("expected on or off, found {}", quote(word.text)));
    }
    return word.text == "on";
  }

  void readChannel(MtlMap& map) {
    const Word word = lines_.word();
    if (word.text == "z") {
      file_.omissions.insert("-imfchan z");
      return;
    }
    if (word.text.size() != 1 || std::string_view("rgbml").find(word.text[0]) == std::string_view::npos) {
      Lines::fail(word.position, fmt::format("expected r, g, b, m, l or z, found {}", quote(word.text)));
    }
    map.channel = word.text[0];
  }

  /// Returns the next word without passing it.
  std::string_view peek() const {
    Lines ahead = lines_;
    return ahead.word().text;
  }

  Lines lines_;
  bool isLenient_;
  scene::DiagnosticLog& log_;
  MtlFile file_{};
  std::set<std::size_t> hasOpacity_{};  ///< numbers of materials that state `d`
};

}  // namespace

MtlFile parseMtl(std::string_view text, bool lenient, scene::DiagnosticLog& log) {
  return MtlParser(text, lenient, log).parse();
}

}  // namespace candela::obj
