// A scene as its XML file describes it: objects that refer to each other.
#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "host/formats/loading/load.h"
#include "host/formats/loading/loader.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/mitsuba/object.h"

namespace candela::mitsuba {

struct Description {
  std::deque<Object> objects{};  ///< each may refer to others, without a cycle
  const Object* scene = nullptr;
  bool isOld = false;                            ///< the file's version is below 2: Mitsuba 0.6
  std::vector<std::filesystem::path> folders{};  ///< of <path>, in which files are looked up after the scene's own
  std::deque<std::string> texts{};               ///< of files that are included, and of spectra
  scene::StatementCounts counts{};
};

/// Reads a file and those that it includes. Values are those that it states: parameters are replaced, references are
/// resolved, names of Mitsuba 0.6 become those of Mitsuba 3, and the operations of a transform are multiplied. Adds
/// errors to the report. Throws SceneError if there are any, and UsageError for wrong definitions.
Description readDescription(const scene::SceneFile& file, const scene::LoadOptions& options, scene::PathGuard& guard,
                            Report& report);

/// Returns the path of a file that a scene names: in the folder of the document, in one of <path>, or in that of the
/// scene.
std::filesystem::path findFile(const std::string& name, const Document& document, const Description& description,
                               const std::filesystem::path& sceneFolder);

}  // namespace candela::mitsuba
