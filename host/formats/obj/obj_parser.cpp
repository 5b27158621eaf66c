// Reads the statements of an OBJ file.
#include "host/formats/obj/obj_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/base/suggestion.h"
#include "host/base/utf8.h"
#include "host/formats/loading/polygon.h"
#include "host/formats/obj/lines.h"
#include "host/image/colour_transfer.h"

namespace candela::obj {
namespace {

using scene::quote;

/// Statements that are read over, and what they are.
struct Omission {
  std::string_view keyword;
  std::string_view what;
};
constexpr std::array kOmissions{
    Omission{"p", "points"},
    Omission{"l", "lines"},
    Omission{"vp", "curves and surfaces"},
    Omission{"cstype", "curves and surfaces"},
    Omission{"deg", "curves and surfaces"},
    Omission{"bmat", "curves and surfaces"},
    Omission{"step", "curves and surfaces"},
    Omission{"curv", "curves and surfaces"},
    Omission{"curv2", "curves and surfaces"},
    Omission{"surf", "curves and surfaces"},
    Omission{"parm", "curves and surfaces"},
    Omission{"trim", "curves and surfaces"},
    Omission{"hole", "curves and surfaces"},
    Omission{"scrv", "curves and surfaces"},
    Omission{"sp", "curves and surfaces"},
    Omission{"end", "curves and surfaces"},
    Omission{"con", "curves and surfaces"},
    Omission{"bzp", "curves and surfaces"},
    Omission{"bsp", "curves and surfaces"},
    Omission{"cdc", "curves and surfaces"},
    Omission{"cdp", "curves and surfaces"},
    Omission{"res", "curves and surfaces"},
    Omission{"ctech", "curves and surfaces"},
    Omission{"stech", "curves and surfaces"},
    Omission{"mg", "merging groups"},
    Omission{"bevel", "display attributes"},
    Omission{"c_interp", "display attributes"},
    Omission{"d_interp", "display attributes"},
    Omission{"lod", "display attributes"},
    Omission{"shadow_obj", "objects for shadows"},
    Omission{"trace_obj", "objects for reflections"},
    Omission{"maplib", "map libraries"},
    Omission{"usemap", "map libraries"},
    Omission{"call", "calls of other files"},
    Omission{"csh", "commands"},
};

const std::vector<scene::Spelling> kSpellings{{"v", "v"},
                                              {"vt", "vt"},
                                              {"vn", "vn"},
                                              {"f", "f"},
                                              {"fo", "f"},
                                              {"o", "o"},
                                              {"g", "g"},
                                              {"s", "s"},
                                              {"usemtl", "usemtl"},
                                              {"mtllib", "mtllib"},
                                              {"vertex", "v"},
                                              {"face", "f"},
                                              {"normal", "vn"},
                                              {"texcoord", "vt"},
                                              {"group", "g"},
                                              {"object", "o"},
                                              {"material", "usemtl"},
                                              {"smooth", "s"}};

float fromScreen(float signal) {
  return static_cast<float>(image::srgbDecode(std::clamp(static_cast<double>(signal), 0.0, 1.0)));
}

class ObjParser {
 public:
  ObjParser(const scene::SceneFile& file, bool lenient, scene::DiagnosticLog& log)
      : file_(file), lines_(file.bytes), isLenient_(lenient), log_(log) {}

  ObjModel parse() {
    readLines(lines_, isLenient_, log_, [this] { readStatement(); });
    return std::move(model_);
  }

 private:
  void readStatement() {
    const Word keyword = lines_.word();
    const std::string_view name = keyword.text;
    if (name.empty()) return;
    if (name == "v") return readPosition();
    if (name == "f" || name == "fo") return readFace(keyword);
    if (name == "vt") return readTexCoord();
    if (name == "vn") return readNormal();
    readOther(keyword);
  }

  void readOther(const Word& keyword) {
    const std::string_view name = keyword.text;
    if (name == "usemtl") return useMaterial();
    if (name == "mtllib") return useLibrary(keyword);
    if (name == "o" || name == "g") return beginObject();
    if (name == "s") return readSmoothing();
    const auto* const omission = std::ranges::find(kOmissions, name, &Omission::keyword);
    if (omission != kOmissions.end()) {
      model_.omissions.emplace(name, omission->what);
    } else {
      const std::string kind = "unknown " + std::string(name.substr(0, 40));
      const bool isListed = isLenient_ ? log_.listsWarning(kind) : log_.listsError();
      deviate(kind, keyword.position, isListed ? unknownKeyword(name) : "");
    }
    lines_.skipRest();
  }

  static std::string unknownKeyword(std::string_view name) {
    const std::optional<std::string_view> suggestion = scene::suggest(name, kSpellings);
    return fmt::format("unknown keyword {}{}", quote(name),
                       suggestion ? fmt::format("; did you mean \"{}\"?", *suggestion) : std::string());
  }

  /// Adds an error, or with `lenient` a warning.
  void deviate(const std::string& kind, scene::Position position, const std::string& message) {
    if (isLenient_) {
      log_.warn(kind, position, message + "; skipped");
    } else {
      log_.error(position, message);
    }
  }

  /// x y z, or x y z w with a weight of curves, or x y z and a colour.
  void readPosition() {
    glm::vec3 position;
    for (int i = 0; i < 3; ++i) position[i] = lines_.number("a coordinate");
    model_.positions.push_back(position);
    if (!model_.colours.empty()) model_.colours.emplace_back(1);
    if (!lines_.hasWord()) return;
    glm::vec3 colour;
    colour.x = lines_.number("a weight");
    if (!lines_.hasWord()) return;
    colour.y = lines_.number("a colour");
    colour.z = lines_.number("a colour");
    model_.colours.resize(model_.positions.size(), glm::vec3(1));
    model_.colours.back() = {fromScreen(colour.x), fromScreen(colour.y), fromScreen(colour.z)};
  }

  void readTexCoord() {
    glm::vec2 texCoord(lines_.number("a texture coordinate"), 0);
    if (lines_.hasWord()) texCoord.y = lines_.number("a texture coordinate");
    if (lines_.hasWord()) lines_.number("a texture coordinate");
    model_.texCoords.push_back(texCoord);
  }

  void readNormal() {
    glm::vec3 normal;
    for (int i = 0; i < 3; ++i) normal[i] = lines_.number("a component of the normal");
    model_.normals.push_back(normal);
  }

  /// Reads an index that counts from 1, or backwards from -1.
  std::uint32_t readIndex(std::string_view what, std::size_t count) {
    const scene::Position position = lines_.here();
    std::int64_t index = 0;
    if (!lines_.index(index)) failCorner(position);
    const auto signedCount = static_cast<std::int64_t>(count);
    const std::int64_t found = index > 0 ? index - 1 : index + signedCount;
    if (index == 0 || found < 0 || found >= signedCount) {
      Lines::fail(position, fmt::format("there is no {} {}: {} so far, counted from 1, or from -1 backwards", what,
                                        index, count));
    }
    return static_cast<std::uint32_t>(found);
  }

  [[noreturn]] void failCorner(scene::Position position) {
    const Word word = lines_.word();
    Lines::fail(position, fmt::format("expected a corner such as 1, 1/2, 1//3 or 1/2/3, found {}", quote(word.text)));
  }

  Corner readCorner() {
    Corner corner;
    corner.position = readIndex("vertex", model_.positions.size());
    if (!lines_.slash()) return corner;
    const bool hasTexCoord = !lines_.isAtWordEnd() && !lines_.slash();
    if (hasTexCoord) {
      corner.texCoord = readIndex("texture coordinate", model_.texCoords.size());
      if (!lines_.slash()) return corner;
    }
    if (!lines_.isAtWordEnd()) corner.normal = readIndex("normal", model_.normals.size());
    return corner;
  }

  void readFace(const Word& keyword) {
    polygon_.clear();
    while (lines_.hasWord()) {
      polygon_.push_back(readCorner());
      if (!lines_.isAtWordEnd()) failCorner(lines_.here());
      if (polygon_.size() > scene::kMaxPolygonVertices) {
        Lines::fail(keyword.position, fmt::format("a face of more than {} vertices", scene::kMaxPolygonVertices));
      }
    }
    if (polygon_.size() < 3) Lines::fail(keyword.position, "a face has at least three vertices");
    requireOneForm(keyword);
    beginRun();
    smooth();
    addTriangles(keyword);
    ++model_.faceCount;
  }

  void requireOneForm(const Word& keyword) {
    const auto hasTexCoord = [](const Corner& corner) { return corner.texCoord != kNone; };
    const auto hasNormal = [](const Corner& corner) { return corner.normal != kNone; };
    const auto texCoords = static_cast<std::size_t>(std::ranges::count_if(polygon_, hasTexCoord));
    const auto normals = static_cast<std::size_t>(std::ranges::count_if(polygon_, hasNormal));
    const bool isMixed = (texCoords != 0 && texCoords != polygon_.size()) ||
                         (normals != 0 && normals != polygon_.size());
    if (!isMixed) return;
    deviate("mixed", keyword.position, "the corners of the face have different forms");
    for (Corner& corner : polygon_) {
      if (texCoords != polygon_.size()) corner.texCoord = kNone;
      if (normals != polygon_.size()) corner.normal = kNone;
    }
  }

  /// Begins a run unless the face belongs to the last one.
  void beginRun() {
    if (!hasObject_) {
      model_.objectNames.push_back(objectName_);
      hasObject_ = true;
    }
    const Corner& first = polygon_.front();
    const Run run{.firstCorner = model_.corners.size(),
                  .object = static_cast<std::uint32_t>(model_.objectNames.size() - 1),
                  .material = material_,
                  .hasTexCoords = first.texCoord != kNone,
                  .hasNormals = first.normal != kNone || group_ != 0};
    const auto continues = [&](const Run& last) {
      return last.object == run.object && last.material == run.material && last.hasTexCoords == run.hasTexCoords &&
             last.hasNormals == run.hasNormals;
    };
    if (model_.runs.empty() || !continues(model_.runs.back())) model_.runs.push_back(run);
  }

  /// Corners of a smoothing group without normals get those that are computed.
  void smooth() {
    if (group_ == 0 || polygon_.front().normal != kNone) return;
    for (Corner& corner : polygon_) {
      corner.normal = ObjModel::kSmooth + model_.smoothNormals.find(corner.position, group_);
    }
  }

  void addTriangles(const Word& keyword) {
    requireRoom();
    if (polygon_.size() == 3) return addTriangle(polygon_[0], polygon_[1], polygon_[2]);
    points_.clear();
    for (const Corner& corner : polygon_) points_.push_back(model_.positions[corner.position]);
    for (const auto& [a, b, c] : scene::triangulateWithWarnings(points_, keyword.position, log_).triangles) {
      addTriangle(polygon_[a], polygon_[b], polygon_[c]);
    }
  }

  void addTriangle(const Corner& a, const Corner& b, const Corner& c) {
    model_.corners.insert(model_.corners.end(), {a, b, c});
    if (a.normal == kNone || a.normal < ObjModel::kSmooth) return;
    const auto& p = model_.positions;
    model_.smoothNormals.add({a.normal - ObjModel::kSmooth, b.normal - ObjModel::kSmooth, c.normal - ObjModel::kSmooth},
                             {p[a.position], p[b.position], p[c.position]});
  }

  /// Checks the memory whenever the list of corners is about to grow: a vertex and an index of the mesh for each.
  void requireRoom() {
    if (model_.corners.size() + 3 * polygon_.size() <= model_.corners.capacity()) return;
    constexpr std::size_t kBytesPerCorner = sizeof(Corner) + sizeof(std::uint32_t);
    requireMemory(file_.name + ": the scene", 2 * (model_.corners.size() + 3 * polygon_.size()) * kBytesPerCorner,
                  "use a machine with more memory");
  }

  void useMaterial() {
    const Word name = lines_.rest();
    if (name.text.empty()) Lines::fail(name.position, "expected the name of a material");
    const auto next = static_cast<std::uint32_t>(model_.materialNames.size());
    const auto [found, isNew] = materials_.try_emplace(std::string(name.text), next);
    if (isNew) model_.materialNames.push_back({found->first, name.position});
    material_ = found->second;
  }

  void useLibrary(const Word& keyword) {
    const Word files = lines_.rest();
    if (files.text.empty()) Lines::fail(keyword.position, "expected the name of a file");
    model_.libraries.push_back({std::string(files.text), files.position});
  }

  void beginObject() {
    const Word name = lines_.rest();
    objectName_ = name.text.empty() ? "default" : printableLine(name.text, kMaxNameLength);
    hasObject_ = false;
  }

  void readSmoothing() {
    const Word group = lines_.word();
    if (group.text == "off" || group.text == "on" || group.text.empty()) {
      if (group.text.empty()) Lines::fail(group.position, "expected the number of a smoothing group, or off");
      group_ = group.text == "on" ? 1 : 0;
      return;
    }
    const char* const end = group.text.data() + group.text.size();
    const auto [stop, error] = std::from_chars(group.text.data(), end, group_);
    if (error != std::errc() || stop != end) {
      Lines::fail(group.position, fmt::format("{} is not the number of a smoothing group, or off", quote(group.text)));
    }
  }

  const scene::SceneFile& file_;
  Lines lines_;
  bool isLenient_;
  scene::DiagnosticLog& log_;
  ObjModel model_{};
  std::vector<Corner> polygon_{};    ///< corners of the current face
  std::vector<glm::vec3> points_{};  ///< their positions
  std::unordered_map<std::string, std::uint32_t> materials_{};
  std::uint32_t material_ = kNone;
  std::uint32_t group_ = 0;
  std::string objectName_ = "default";
  bool hasObject_ = false;
};

}  // namespace

bool looksLikeObj(std::string_view bytes) {
  Lines lines(bytes);
  Word keyword = lines.word();
  while (keyword.text.empty() && !lines.isAtEnd()) {
    lines.endLine();
    keyword = lines.word();
  }
  constexpr std::array<std::string_view, 7> kUnmistakable{"vt", "vn", "vp", "o", "g", "mtllib", "usemtl"};
  if (std::ranges::count(kUnmistakable, keyword.text) > 0) return true;
  const Word argument = lines.word();
  if (keyword.text == "v") {
    return !argument.text.empty() && std::string_view("+-.0123456789").find(argument.text[0]) != std::string_view::npos;
  }
  return keyword.text == "s" && !argument.text.empty() && !lines.hasWord();
}

ObjModel parseObj(const scene::SceneFile& file, bool lenient, scene::DiagnosticLog& log) {
  return ObjParser(file, lenient, log).parse();
}

}  // namespace candela::obj
