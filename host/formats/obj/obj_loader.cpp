// The loader of OBJ: statements, material files, meshes, view and light.
#include "host/formats/obj/obj_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/base/suggestion.h"
#include "host/base/utf8.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/model_scene.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/loading/shrink_images.h"
#include "host/formats/obj/mtl_file.h"
#include "host/formats/obj/mtl_mapping.h"
#include "host/formats/obj/mtl_textures.h"
#include "host/formats/obj/obj_meshes.h"
#include "host/formats/obj/obj_parser.h"

namespace candela::obj {
namespace {

using scene::quote;

/// A material file that was read, and its errors and warnings.
struct Library {
  std::filesystem::path folder;
  scene::DiagnosticLog log;
  MtlFile content{};
};

/// The words of a list of files, whose names contain no blanks.
std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::size_t begin = text.find_first_not_of(" \t");
  while (begin != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(" \t", end);
  }
  return words;
}

/// A file while it is read.
class Reading {
 public:
  Reading(const scene::SceneFile& file, const scene::LoadOptions& options)
      : file_(file),
        options_(options),
        fileHash_(scene::startHash(file.bytes)),
        log_(file.name),
        guard_(file.folder, options.allowedPaths),
        textures_(guard_, options.lenient),
        model_(parseObj(file, options.lenient, log_)) {}

  scene::LoadedScene read() {
    for (const NamedPlace& library : model_.libraries) readLibraries(library);
    addMaterials();
    throwErrors();
    if (model_.corners.empty()) {
      throw scene::SceneError({{file_.name, 0, 0, "the file has no faces, and points and lines are not rendered"}});
    }
    if (std::ranges::any_of(model_.runs, [](const Run& run) { return run.material == kNone; })) addPlainMaterial();
    addMeshes(model_, materialIndices_, scene_);
    return finish();
  }

 private:
  /// Reads the files that a statement `mtllib` names: one whose name may contain blanks, or several.
  void readLibraries(const NamedPlace& library) {
    std::error_code ignored;
    if (std::filesystem::exists(file_.folder / withSlashes(library.name), ignored)) return readLibrary(library);
    for (const std::string& name : wordsOf(library.name)) readLibrary({name, library.position});
  }

  static std::string withSlashes(std::string path) {
    std::ranges::replace(path, '\\', '/');  // as programs on Windows write it
    return path;
  }

  void readLibrary(const NamedPlace& library) {
    const std::filesystem::path path = file_.folder / withSlashes(library.name);
    if (!readPaths_.insert(path.string()).second) return;
    try {
      guard_.require(path);
      const std::string text = scene::readFile(path);
      hash_ = fnv1aOfText(text, hash_);
      Library& added = libraries_.emplace_back(Library{path.parent_path(), scene::DiagnosticLog(path.string())});
      added.content = parseMtl(text, options_.lenient, added.log);
    } catch (const FileError& error) {
      deviate("library", library.position, error.what(), "reads the file without it");
    }
  }

  /// Adds an error with a remedy, or with `lenient` a warning.
  void deviate(const std::string& kind, scene::Position position, const std::string& message,
               const std::string& lenient) {
    if (options_.lenient) {
      log_.warn(kind, position, message);
    } else {
      log_.error(position, fmt::format("{}; {} {}", message, settingWords("lenient"), lenient));
    }
  }

  /// Adds the materials that faces use.
  void addMaterials() {
    std::vector<bool> isUsed(model_.materialNames.size(), false);
    for (const Run& run : model_.runs) {
      if (run.material != kNone) isUsed[run.material] = true;
    }
    materialIndices_.resize(model_.materialNames.size(), 0);
    for (std::size_t i = 0; i < model_.materialNames.size(); ++i) {
      if (isUsed[i]) materialIndices_[i] = addMaterial(model_.materialNames[i]);
    }
  }

  std::uint32_t addMaterial(const NamedPlace& use) {
    for (auto library = libraries_.rbegin(); library != libraries_.rend(); ++library) {
      const auto& materials = library->content.materials;
      const auto found = std::ranges::find(materials.rbegin(), materials.rend(), use.name, &MtlMaterial::name);
      if (found != materials.rend()) return addMaterial(*found, *library);
    }
    reportMissing(use);
    return addPlainMaterial();
  }

  std::uint32_t addMaterial(const MtlMaterial& material, Library& library) {
    const MtlReferences references = textures_.read(material, library.folder, library.log, library.content.omissions);
    scene_.materials.push_back(fromMtl(material, references, !model_.colours.empty()));
    scene_.materialNames.push_back(printableLine(material.name, kMaxNameLength));
    warnOfValues(material, library.log);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  }

  static void warnOfValues(const MtlMaterial& material, scene::DiagnosticLog& log) {
    for (const auto& colour : {material.diffuse, material.specular, material.filter}) {
      if (!colour || glm::all(glm::lessThanEqual(*colour, glm::vec3(1)))) continue;
      log.warn("bright", {}, fmt::format("material {}: a colour above 1 is limited to 1", quote(material.name)));
    }
    if (material.opacity == 0.0f && !material.maps.contains(MapKind::opacity)) {
      log.warn("invisible", {},
               fmt::format("material {} is invisible: its opacity (d, or 1 - Tr) is 0", quote(material.name)));
    }
  }

  void reportMissing(const NamedPlace& use) {
    if (model_.libraries.empty()) {
      log_.warn("material", use.position,
                fmt::format("the file names no material file (mtllib) that could define {}; its faces are grey",
                            quote(use.name)));
      return;
    }
    std::vector<scene::Spelling> spellings;
    for (const Library& library : libraries_) {
      for (const MtlMaterial& material : library.content.materials) spellings.push_back({material.name, material.name});
    }
    const std::optional<std::string_view> suggestion = scene::suggest(use.name, spellings);
    deviate("material", use.position,
            fmt::format("no material file defines {}{}", quote(use.name),
                        suggestion ? fmt::format("; did you mean {}?", quote(*suggestion)) : std::string()),
            "renders its faces in grey");
  }

  /// Adds the material of faces without one, once. It stays the last material.
  std::uint32_t addPlainMaterial() {
    scene_.materials.push_back(scene::plainMaterial(!model_.colours.empty()));
    scene_.materialNames.emplace_back("default");
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  }

  /// Throws the errors of all files, those of the OBJ file first.
  void throwErrors() const {
    std::vector<scene::Diagnostic> all;
    const auto collect = [&](const scene::DiagnosticLog& log) {
      for (scene::Diagnostic& error : log.errors()) all.push_back(std::move(error));
    };
    collect(log_);
    for (const Library& library : libraries_) collect(library.log);
    if (!all.empty()) throw scene::SceneError(std::move(all));
  }

  scene::LoadedScene finish() {
    scene_.images = textures_.takeImages();
    const std::vector<std::string> shrunk = scene::shrinkImages(scene_.images);
    if (!shrunk.empty()) log_.warn("images", {}, fmt::format("{}", fmt::join(shrunk, "; ")));
    warnOfOmissions();
    scene::FileFacts facts = scene::completeModel(scene_, options_, log_);
    if (!unused_.empty()) facts.emplace_back("not used", fmt::format("{}", fmt::join(unused_, ", ")));
    scene_.name = std::filesystem::path(file_.name).filename().string();
    scene_.hash = textures_.hashFiles(fnv1aOfText(fmt::format("{:x}", hash_), fileHash_.get()));
    std::vector<scene::Diagnostic> warnings = log_.warnings();
    for (const Library& library : libraries_) {
      for (scene::Diagnostic& warning : library.log.warnings()) warnings.push_back(std::move(warning));
    }
    return {.scene = std::move(scene_),
            .counts = counts(),
            .warnings = std::move(warnings),
            .facts = std::move(facts),
            .files = guard_.requiredPaths()};
  }

  void warnOfOmissions() {
    std::map<std::string, std::set<std::string>> keywords;  // by what they are
    for (const auto& [keyword, what] : model_.omissions) keywords[what].insert(keyword);
    std::vector<std::string> omitted;
    for (const auto& [what, names] : keywords) omitted.push_back(fmt::format("{} ({})", what, fmt::join(names, ", ")));
    std::set<std::string> ofMaterials;
    for (const Library& library : libraries_) {
      ofMaterials.insert(library.content.omissions.begin(), library.content.omissions.end());
      unused_.insert(library.content.unused.begin(), library.content.unused.end());
    }
    omitted.insert(omitted.end(), ofMaterials.begin(), ofMaterials.end());
    if (!omitted.empty()) log_.warn("omissions", {}, fmt::format("not rendered: {}", fmt::join(omitted, ", ")));
  }

  scene::StatementCounts counts() const {
    scene::StatementCounts counts{{"vertex", model_.positions.size()}, {"face", model_.faceCount}};
    const auto note = [&](const char* name, std::size_t count) {
      if (count > 0) counts[name] = count;
    };
    note("textureCoordinate", model_.texCoords.size());
    note("normal", model_.normals.size());
    note("object", model_.objectNames.size());
    note("materialFile", libraries_.size());
    return counts;
  }

  const scene::SceneFile& file_;
  const scene::LoadOptions& options_;
  std::shared_future<std::uint64_t> fileHash_;
  scene::DiagnosticLog log_;
  scene::PathGuard guard_;
  MtlTextures textures_;
  ObjModel model_;
  scene::Scene scene_{};
  std::deque<Library> libraries_{};
  std::set<std::string> readPaths_{};
  std::vector<std::uint32_t> materialIndices_{};  ///< in Scene::materials, by ObjModel::materialNames
  std::set<std::string> unused_{};
  std::uint64_t hash_ = 0;  ///< of the material files
};

scene::LoadedScene loadObj(const scene::SceneFile& file, const scene::LoadOptions& options) {
  return Reading(file, options).read();
}

std::unique_ptr<scene::SceneReader> openObj(const scene::SceneFile& file, const scene::LoadOptions& options, bool) {
  return scene::readStill(file, options, loadObj);
}

}  // namespace

scene::Loader objLoader() { return {"OBJ", {".obj"}, looksLikeObj, openObj}; }

}  // namespace candela::obj
