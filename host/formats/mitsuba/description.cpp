// Makes objects of elements.
#include "host/formats/mitsuba/description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "host/base/lower_case.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/number.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/mitsuba/attributes.h"
#include "host/formats/mitsuba/names.h"
#include "host/formats/mitsuba/parameters.h"
#include "host/formats/mitsuba/transform.h"
#include "host/image/colour_transfer.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

constexpr int kMaxIncludeDepth = 15;
constexpr std::size_t kMaxElements = 1'000'000;  // of all files

constexpr std::array<std::string_view, 13> kObjectTags{"scene",  "shape",   "bsdf",    "emitter",    "sensor",
                                                       "film",   "sampler", "rfilter", "integrator", "texture",
                                                       "medium", "phase",   "volume"};
constexpr std::array<std::string_view, 16> kValueTags{"boolean", "integer", "float",     "string",   "rgb", "spectrum",
                                                      "point",   "vector",  "transform", "default",  "ref", "alias",
                                                      "include", "path",    "srgb",      "blackbody"};

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }

/// "toWorld" becomes "to_world", as Mitsuba 3 spells the names of Mitsuba 0.6.
std::string withUnderscores(const std::string& name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool beginsWord = i > 0 && isUpper(name[i]) && isLower(name[i - 1]);
    if (beginsWord) result += '_';
    result += beginsWord || (i > 0 && isUpper(name[i - 1])) ? lowerLetter(name[i]) : name[i];
  }
  return result;
}

bool flagOf(std::string_view text, const Place& place) {
  if (equalsIgnoringCase(text, "true")) return true;
  if (equalsIgnoringCase(text, "false")) return false;
  throw PlacedError{place, fmt::format("expected true or false instead of {}", quote(text))};
}

std::int64_t integerOf(std::string_view text, const Place& place) {
  const std::vector<std::string_view> words = wordsOf(text);
  std::int64_t value = 0;
  const char* const end = words.size() == 1 ? words[0].data() + words[0].size() : nullptr;
  const auto [last, error] = end ? std::from_chars(words[0].data(), end, value)
                                 : std::from_chars_result{nullptr, std::errc::invalid_argument};
  if (error != std::errc() || last != end) {
    throw PlacedError{place, fmt::format("expected an integer instead of {}", quote(text))};
  }
  return value;
}

/// A colour of Mitsuba 0.6 in the notation "#rrggbb", which is encoded in sRGB.
glm::dvec3 hexColour(std::string_view text, const Place& place) {
  glm::dvec3 colour;
  for (int channel = 0; channel < 3; ++channel) {
    unsigned value = 0;
    const char* const begin = text.data() + 1 + 2 * channel;
    const auto [last, error] = text.size() == 7 ? std::from_chars(begin, begin + 2, value, 16)
                                                : std::from_chars_result{nullptr, std::errc::invalid_argument};
    if (error != std::errc() || last != begin + 2) {
      throw PlacedError{place, fmt::format("expected a colour such as \"#ff8000\" instead of {}", quote(text))};
    }
    colour[channel] = image::srgbDecode(value / 255.0);
  }
  return colour;
}

Rgb rgbOf(const std::string& text, const Place& place, bool isEncoded) {
  if (text.starts_with('#')) return {hexColour(text, place)};
  const glm::dvec3 colour = tripleOf(text, place);
  if (!isEncoded) return {colour};
  return {{image::srgbDecode(colour.x), image::srgbDecode(colour.y), image::srgbDecode(colour.z)}};
}

class DescriptionReader {
 public:
  DescriptionReader(const scene::SceneFile& file, const scene::LoadOptions& options, scene::PathGuard& guard,
                    Report& report)
      : file_(file), guard_(guard), report_(report), parameters_(options.definitions) {}

  Description read() {
    Document& document = report_.addDocument(file_.name, file_.folder, file_.bytes);
    attempt([&] {
      const Element root = readXml(document);
      if (root.name != "scene") {
        throw PlacedError{root.place, fmt::format("the root element is <{}> instead of <scene>", root.name)};
      }
      Object& scene = description_.objects.emplace_back("scene", "scene", root.place);
      description_.scene = &scene;
      description_.isOld = readVersion(root);
      addChildren(root, scene, {document, description_.isOld, 0});
    });
    for (const std::string& name : parameters_.unusedDefinitions()) {
      report_.error({&document, 0}, fmt::format("no attribute contains ${}, which {} defines", name,
                                                settingWords("define", name + "=...")));
    }
    report_.throwIfErrors();
    resolve();
    report_.throwIfErrors();
    checkCycles();
    return std::move(description_);
  }

 private:
  struct Context {
    Document& document;
    bool isOld;
    int includeDepth;
  };

  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const PlacedError& error) {
      report_.error(error.place, error.message);
    }
  }

  /// Returns whether a file is of a version below 2.
  static bool readVersion(const Element& root) {
    const std::string& version = requireAttribute(root, "version");
    double number = 0;
    const auto [end, error] = std::from_chars(version.data(), version.data() + version.size(), number);
    if (error != std::errc() || end == version.data()) {
      throw PlacedError{root.place, fmt::format("{} is no version", quote(version))};
    }
    return number < 2;
  }

  Element withParameters(const Element& element) {
    Element result{element.name, element.attributes, {}, element.place};
    for (Attribute& attribute : result.attributes) {
      attribute.value = parameters_.substitute(attribute.value, element.place);
    }
    return result;
  }

  void addChildren(const Element& element, Object& parent, const Context& context) {
    for (const Element& child : element.children) {
      if (report_.isFull()) return;
      if (++elementCount_ > kMaxElements) {
        throw PlacedError{child.place, fmt::format("the scene has more than {} elements", kMaxElements)};
      }
      attempt([&] { add(child, parent, context); });
    }
  }

  void add(const Element& element, Object& parent, const Context& context) {
    const Element values = withParameters(element);
    const bool hasType = findAttribute(values, "type") != nullptr;
    if (std::ranges::count(kObjectTags, values.name) > 0 || (values.name == "spectrum" && hasType)) {
      addObject(element, values, parent, context);
      return;
    }
    if (values.name != "transform" && !element.children.empty()) {
      throw PlacedError{element.children.front().place, fmt::format("<{}> is no place for an element", element.name)};
    }
    if (values.name == "default") return addDefault(values);
    if (values.name == "include") return include(values, parent, context);
    if (values.name == "path") return addFolder(values, context);
    if (values.name == "alias") return addAlias(values);
    std::string name = findAttribute(values, "name") ? *findAttribute(values, "name") : std::string();
    if (context.isOld) name = withUnderscores(name);
    if (values.name == "ref") {
      checkAttributes(values, {"id", "name"});
      addProperty(parent, {std::move(name), Reference{requireAttribute(values, "id")}, values.place});
      return;
    }
    Value value = valueOf(element, values, context);
    if (name.empty()) throw PlacedError{values.place, fmt::format("<{}> has no attribute \"name\"", values.name)};
    addProperty(parent, {std::move(name), std::move(value), values.place});
  }

  void addProperty(Object& parent, Property property) {
    constexpr std::size_t kSearched = 64;  // properties that are not objects, of which no plugin has as many
    const bool isValue = !std::holds_alternative<const Object*>(property.value) &&
                         !std::holds_alternative<Reference>(property.value);
    if (isValue) {
      std::size_t& count = valueCounts_[&parent];
      if (++count > kSearched)
        throw PlacedError{property.place,
                          fmt::format("{} has more than {} properties", parent.description(), kSearched)};
      const auto equals = [&](const Property& other) { return other.name == property.name; };
      if (std::ranges::any_of(parent.properties, equals)) {
        throw PlacedError{property.place,
                          fmt::format("{} of {} is stated twice", quote(property.name), parent.description())};
      }
    }
    parent.properties.push_back(std::move(property));
  }

  void addObject(const Element& element, const Element& values, Object& parent, const Context& context) {
    const std::string tag = values.name == "spectrum" ? "texture" : values.name;
    if (tag == "scene") throw PlacedError{values.place, "<scene> is not the root element"};
    checkAttributes(values, {"type", "id", "name"});
    Object& object = description_.objects.emplace_back(tag, requireAttribute(values, "type"), values.place);
    ++description_.counts[tag];
    if (const std::string* const id = findAttribute(values, "id")) {
      object.id = *id;
      addId(*id, object);
    }
    std::string name = findAttribute(values, "name") ? *findAttribute(values, "name") : std::string();
    if (context.isOld) name = withUnderscores(name);
    addProperty(parent, {std::move(name), &object, values.place});
    addChildren(element, object, context);
    if (context.isOld) upgrade(object);
  }

  /// Gives an object of Mitsuba 0.6 the properties of Mitsuba 3.
  static void upgrade(Object& object) {
    if (object.tag == "texture") upgradeTexture(object);
    if (object.tag == "bsdf" && object.type == "diffuse") {
      for (Property& property : object.properties) {
        if (property.name == "diffuse_reflectance") property.name = "reflectance";
      }
    }
  }

  static void upgradeTexture(Object& texture) {
    glm::dmat4 map(1);
    bool isChanged = false;
    const auto set = [&](const char* name, glm::length_t column, glm::length_t row) {
      const auto found = std::ranges::find(texture.properties, std::string_view(name), &Property::name);
      if (found == texture.properties.end()) return;
      const auto* const integer = std::get_if<std::int64_t>(&found->value);
      const auto* const number = std::get_if<double>(&found->value);
      if (!integer && !number) throw PlacedError{found->place, fmt::format("{} is not a number", quote(name))};
      map[column][row] = integer ? static_cast<double>(*integer) : *number;
      texture.properties.erase(found);
      isChanged = true;
    };
    set("uscale", 0, 0);
    set("vscale", 1, 1);
    set("uoffset", 3, 0);
    set("voffset", 3, 1);
    if (isChanged) texture.properties.push_back({"to_uv", map, texture.place});
  }

  void addId(const std::string& id, const Object& object) {
    const auto [known, isNew] = ids_.emplace(id, &object);
    if (!isNew) throw PlacedError{object.place, fmt::format("the id {} is used twice", quote(id))};
  }

  void addDefault(const Element& element) {
    checkAttributes(element, {"name", "value"});
    parameters_.addDefault(requireAttribute(element, "name"), requireAttribute(element, "value"));
  }

  void addFolder(const Element& element, const Context& context) {
    checkAttributes(element, {"value"});
    description_.folders.push_back(context.document.folder() / requireAttribute(element, "value"));
  }

  void addAlias(const Element& element) {
    checkAttributes(element, {"id", "as"});
    const auto found = ids_.find(requireAttribute(element, "id"));
    if (found == ids_.end())
      throw PlacedError{element.place,
                        fmt::format("no object before this has the id {}", quote(requireAttribute(element, "id")))};
    const auto [known, isNew] = ids_.emplace(requireAttribute(element, "as"), found->second);
    if (!isNew)
      throw PlacedError{element.place, fmt::format("the id {} is used twice", quote(requireAttribute(element, "as")))};
  }

  void include(const Element& element, Object& parent, const Context& context) {
    checkAttributes(element, {"filename", "name"});
    if (context.includeDepth >= kMaxIncludeDepth) {
      throw PlacedError{element.place, fmt::format("files are included more than {} deep", kMaxIncludeDepth)};
    }
    const std::filesystem::path path = findFile(requireAttribute(element, "filename"), context.document, description_,
                                                file_.folder);
    std::string& text = description_.texts.emplace_back();
    try {
      guard_.require(path);
      text = scene::readFile(path);
    } catch (const FileError& error) {
      throw PlacedError{element.place, error.what()};
    }
    ++description_.counts["include"];
    Document& document = report_.addDocument(path.string(), path.parent_path(), text);
    const Element root = readXml(document);
    const Context inner{document, readVersion(root), context.includeDepth + 1};
    if (root.name == "scene") {
      checkAttributes(root, {"version", "type", "id", "name"});
      addChildren(root, parent, inner);
      return;
    }
    Element object = root;
    std::erase_if(object.attributes, [](const Attribute& attribute) { return attribute.name == "version"; });
    if (const std::string* const name = findAttribute(element, "name")) {
      std::erase_if(object.attributes, [](const Attribute& attribute) { return attribute.name == "name"; });
      object.attributes.push_back({"name", *name});
    }
    add(object, parent, inner);
  }

  Value valueOf(const Element& element, const Element& values, const Context& context) {
    if (values.name == "transform") return transformOf(element, values);
    if (values.name == "point" || values.name == "vector") {
      checkAttributes(values, {"name", "value", "x", "y", "z"});
      return vectorOf(values, 0);
    }
    if (values.name == "spectrum") return samplesOf(values, context);
    if (values.name == "blackbody" && context.isOld) return blackbodyOf(values);
    const bool isEncoded = values.name == "srgb" && context.isOld;
    if (!isEncoded && std::ranges::count(kValueTags, values.name) == 0) failTag(values);
    checkAttributes(values, {"name", "value"});
    const std::string& text = requireAttribute(values, "value");
    if (values.name == "float") return numberOf(text, values.place);
    if (values.name == "integer") return integerOf(text, values.place);
    if (values.name == "boolean") return flagOf(text, values.place);
    if (values.name == "string") return text;
    if (values.name == "rgb" || isEncoded) return rgbOf(text, values.place, isEncoded);
    failTag(values);
  }

  [[noreturn]] static void failTag(const Element& element) {
    std::vector<std::string_view> names(kObjectTags.begin(), kObjectTags.end());
    names.insert(names.end(), kValueTags.begin(), kValueTags.end());
    throw PlacedError{element.place,
                      fmt::format("unknown element {}{}", quote(element.name), suggestionFor(element.name, names))};
  }

  glm::dmat4 transformOf(const Element& element, const Element& values) {
    checkAttributes(values, {"name"});
    glm::dmat4 map(1);
    for (const Element& child : element.children) {
      if (++elementCount_ > kMaxElements) {
        throw PlacedError{child.place, fmt::format("the scene has more than {} elements", kMaxElements)};
      }
      if (!child.children.empty())
        throw PlacedError{child.children.front().place, fmt::format("<{}> is no place for an element", child.name)};
      map = operationOf(withParameters(child)) * map;
    }
    return map;
  }

  /// "value" is one number, or pairs "wavelength:value"; "filename" a file of such pairs, one a line.
  Samples samplesOf(const Element& values, const Context& context) {
    checkAttributes(values, {"name", "value", "filename"});
    const std::string* const text = findAttribute(values, "value");
    const std::string* const file = findAttribute(values, "filename");
    if ((text == nullptr) == (file == nullptr)) {
      throw PlacedError{values.place, "<spectrum> has either \"value\" or \"filename\""};
    }
    Samples samples = file ? samplesOfFile(*file, values.place, context) : samplesOfText(*text, values.place);
    for (std::size_t i = 1; i < samples.values.size(); ++i) {
      if (!(samples.values[i].first > samples.values[i - 1].first)) {
        throw PlacedError{values.place, "the wavelengths of the spectrum do not rise"};
      }
    }
    return samples;
  }

  static Samples samplesOfText(const std::string& text, const Place& place) {
    Samples samples;
    const std::vector<std::string_view> words = wordsOf(text);
    for (const std::string_view word : words) {
      const std::size_t colon = word.find(':');
      const bool isPair = colon != std::string_view::npos;
      if (!isPair && words.size() > 1) {
        throw PlacedError{place, fmt::format("expected \"wavelength:value\" instead of {}", quote(word))};
      }
      samples.values.emplace_back(isPair ? numberOf(word.substr(0, colon), place) : 0.0,
                                  numberOf(isPair ? word.substr(colon + 1) : word, place));
    }
    if (samples.values.empty()) throw PlacedError{place, "the spectrum has no value"};
    return samples;
  }

  Samples samplesOfFile(const std::string& name, const Place& place, const Context& context) {
    const std::filesystem::path path = findFile(name, context.document, description_, file_.folder);
    std::string& text = description_.texts.emplace_back();
    try {
      guard_.require(path);
      text = scene::readFile(path);
    } catch (const FileError& error) {
      throw PlacedError{place, error.what()};
    }
    Samples samples;
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line(text.data() + begin, end - begin);
      begin = end + 1;
      if (line.starts_with('#') || wordsOf(line).empty()) continue;
      const std::vector<double> numbers = numbersOf(line, place);
      if (numbers.size() < 2) throw PlacedError{place, fmt::format("a line of {} has no value", quote(name))};
      samples.values.emplace_back(numbers[0], numbers[1]);
    }
    if (samples.values.size() < 2) throw PlacedError{place, fmt::format("{} has no spectrum", quote(name))};
    return samples;
  }

  /// An object of Mitsuba 3 for the element of Mitsuba 0.6.
  const Object* blackbodyOf(const Element& values) {
    checkAttributes(values, {"name", "temperature", "scale"});
    Object& object = description_.objects.emplace_back("texture", "blackbody", values.place);
    std::string temperature = requireAttribute(values, "temperature");
    while (!temperature.empty() &&
           (temperature.back() == 'K' || temperature.back() == 'k' || temperature.back() == ' '))
      temperature.pop_back();
    object.properties.push_back({"temperature", numberOf(temperature, values.place), values.place});
    if (const std::string* const scale = findAttribute(values, "scale")) {
      object.properties.push_back({"scale", numberOf(*scale, values.place), values.place});
    }
    return &object;
  }

  void resolve() {
    constexpr std::size_t kMaxSuggested = 1000;
    std::vector<std::string_view> ids;
    for (const auto& [id, object] : ids_) {
      if (ids.size() < kMaxSuggested) ids.push_back(id);
    }
    for (Object& object : description_.objects) {
      for (Property& property : object.properties) {
        const auto* const reference = std::get_if<Reference>(&property.value);
        if (!reference) continue;
        const auto found = ids_.find(reference->id);
        if (found != ids_.end()) {
          property.value = found->second;
          continue;
        }
        report_.error(property.place, fmt::format("no object has the id {}{}", quote(reference->id),
                                                  suggestionFor(reference->id, ids)));
      }
    }
  }

  /// Objects whose references do not lead back to them are removed in rounds, as in a topological sort. Throws if some
  /// remain.
  void checkCycles() {
    std::map<const Object*, std::size_t> pending;  // number of objects that refer to one
    const auto forEachReferred = [](const Object& object, const auto& action) {
      for (const Property& property : object.properties) {
        if (const auto* const referred = std::get_if<const Object*>(&property.value)) action(*referred);
      }
    };
    for (const Object& object : description_.objects)
      forEachReferred(object, [&](const Object* referred) { ++pending[referred]; });
    std::vector<const Object*> free;
    for (const Object& object : description_.objects) {
      if (!pending.contains(&object)) free.push_back(&object);
    }
    std::size_t count = 0;
    while (!free.empty()) {
      const Object* const object = free.back();
      free.pop_back();
      ++count;
      forEachReferred(*object, [&](const Object* referred) {
        if (--pending[referred] == 0) free.push_back(referred);
      });
    }
    if (count == description_.objects.size()) return;
    for (const Object& object : description_.objects) {
      const auto found = pending.find(&object);
      if (found == pending.end() || found->second == 0) continue;
      report_.error(object.place, fmt::format("{} refers to itself, directly or not", object.description()));
      break;
    }
    report_.throwIfErrors();
  }

  const scene::SceneFile& file_;
  scene::PathGuard& guard_;
  Report& report_;
  Parameters parameters_;
  Description description_{};
  std::map<std::string, const Object*> ids_{};
  std::map<const Object*, std::size_t> valueCounts_{};
  std::size_t elementCount_ = 0;
};

}  // namespace

Description readDescription(const scene::SceneFile& file, const scene::LoadOptions& options, scene::PathGuard& guard,
                            Report& report) {
  return DescriptionReader(file, options, guard, report).read();
}

std::filesystem::path findFile(const std::string& name, const Document& document, const Description& description,
                               const std::filesystem::path& sceneFolder) {
  std::string slashed = name;
  std::ranges::replace(slashed, '\\', '/');  // as programs on Windows write it
  const std::filesystem::path path(slashed);
  std::error_code ignored;
  for (auto folder = description.folders.rbegin(); folder != description.folders.rend(); ++folder) {
    if (std::filesystem::exists(*folder / path, ignored)) return *folder / path;
  }
  if (std::filesystem::exists(sceneFolder / path, ignored)) return sceneFolder / path;
  return document.folder() / path;
}

}  // namespace candela::mitsuba
