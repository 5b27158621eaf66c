// Short ways to read Mitsuba scenes made in code.
#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "host/formats/mitsuba/mitsuba_loader.h"
#include "host/scene/scene.h"

namespace candela::mitsuba {

/// Reads a file whose root element contains `content`, beginning in the second line.
inline scene::LoadedScene loadXml(const std::string& content, const scene::LoadOptions& options = {},
                                  const std::string& version = "3.0.0",
                                  const std::filesystem::path& folder = "/nonexistent") {
  const std::string text = "<scene version=\"" + version + "\">\n" + content + "\n</scene>\n";
  return mitsubaLoader().open({text, "test.xml", folder}, options, false)->at(options.time);
}
inline scene::Scene xmlSceneOf(const std::string& content, const std::string& version = "3.0.0") {
  return loadXml(content, {}, version).scene;
}

/// The messages of all warnings.
inline std::vector<std::string> xmlWarningsOf(const scene::LoadedScene& loaded) {
  std::vector<std::string> messages;
  for (const scene::Diagnostic& warning : loaded.warnings) messages.push_back(toString(warning));
  return messages;
}

/// The errors of a file, one line each; empty if it is read.
inline std::string xmlErrorsOf(const std::string& content, const scene::LoadOptions& options = {},
                               const std::string& version = "3.0.0",
                               const std::filesystem::path& folder = "/nonexistent") {
  try {
    loadXml(content, options, version, folder);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

/// A rectangle with this BSDF.
inline std::string withBsdf(const std::string& bsdf) { return "<shape type=\"rectangle\">" + bsdf + "</shape>"; }

/// The material of a primitive, that of its front if its back has another, with the opacity of both.
inline scene::Material frontOf(const scene::Scene& scene, std::size_t primitive = 0) {
  const scene::Material& own = scene.materials.at(scene.primitives[primitive].material);
  if (!own.choice || own.choice->weight) return own;
  scene::Material front = scene.materials.at(own.choice->first);
  front.opacity = own.opacity;
  return front;
}

/// The front of a rectangle with this BSDF.
inline scene::Material materialOf(const std::string& bsdf, const std::string& version = "3.0.0") {
  return frontOf(xmlSceneOf(withBsdf(bsdf), version));
}

inline bool near(const glm::vec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
  return glm::length(glm::dvec3(a) - b) <= tolerance * (1 + glm::length(b));
}

}  // namespace candela::mitsuba
