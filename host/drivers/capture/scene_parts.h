// A scene whose parts can be removed.
#pragma once
#include <memory>
#include <string>

#include "host/drivers/capture/subset.h"
#include "host/formats/loading/load.h"
#include "host/scene/scene.h"

namespace candela::capture {

class SceneParts {
 public:
  virtual ~SceneParts() = default;
  /// Number of parts that can be removed.
  virtual std::size_t count() const = 0;
  /// Returns the scene with only these parts. Throws Error if there is no such scene.
  virtual scene::Scene with(const Subset& parts) const = 0;
  /// Returns a scene file with only these parts, or an empty text if the format of the file does not permit it.
  virtual std::string textWith(const Subset& parts) const = 0;
  /// Plural noun for the parts, such as "statements".
  virtual const char* noun() const = 0;
};

/// The parts are the statements of primitives and lights, if the text is NFF or P3F. `name` and `options` are those of
/// scene::parseScene().
std::unique_ptr<SceneParts> statementsOf(const std::string& text, const std::string& name, const std::string& folder,
                                         const scene::LoadOptions& options);
/// The parts are the primitives. The scene must outlive the parts.
std::unique_ptr<SceneParts> primitivesOf(const scene::Scene& scene);

}  // namespace candela::capture
