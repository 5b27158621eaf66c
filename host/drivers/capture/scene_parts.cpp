// Divides scene files into statements.
#include "host/drivers/capture/scene_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include "host/formats/nff/nff_loader.h"

namespace candela::capture {
namespace {

constexpr std::array<std::string_view, 14> kRemovable{"s",   "ms",   "c",    "p", "pp", "pl", "npl",
                                                      "box", "aabb", "mesh", "l", "al", "la", "light"};

std::string firstWord(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  return word;
}

bool beginsStatement(const std::string& word) {
  return !word.empty() && (std::isalpha(static_cast<unsigned char>(word.front())) != 0 || word.front() == '#');
}

class Statements final : public SceneParts {
 public:
  Statements(const std::string& text, std::string name, std::string folder, scene::LoadOptions options)
      : name_(std::move(name)), folder_(std::move(folder)), options_(std::move(options)) {
    std::istringstream lines(text);
    std::size_t part = kAlways;
    for (std::string line; std::getline(lines, line);) {
      const std::string word = firstWord(line);
      if (beginsStatement(word)) part = std::ranges::count(kRemovable, word) > 0 ? count_++ : kAlways;
      lines_.push_back({line, part});
    }
  }

  std::size_t count() const override { return count_; }
  const char* noun() const override { return "statements"; }

  scene::Scene with(const Subset& parts) const override {
    return scene::parseScene(textWith(parts), name_, folder_, options_).scene;
  }

  std::string textWith(const Subset& parts) const override {
    std::string text;
    for (const Line& line : lines_) {
      if (line.part == kAlways || std::ranges::binary_search(parts, line.part)) text += line.text + "\n";
    }
    return text;
  }

 private:
  static constexpr std::size_t kAlways = static_cast<std::size_t>(-1);
  struct Line {
    std::string text;
    std::size_t part;  ///< part to which it belongs, or kAlways
  };

  std::string name_, folder_;
  scene::LoadOptions options_;
  std::vector<Line> lines_;
  std::size_t count_ = 0;
};

class Primitives final : public SceneParts {
 public:
  explicit Primitives(const scene::Scene& scene) : scene_(scene) {}

  std::size_t count() const override { return scene_.primitives.size(); }
  const char* noun() const override { return "primitives"; }
  std::string textWith(const Subset&) const override { return ""; }

  scene::Scene with(const Subset& parts) const override {
    scene::Scene scene = scene_;
    scene.primitives.clear();
    for (const std::size_t part : parts) scene.primitives.push_back(scene_.primitives[part]);
    return scene;
  }

 private:
  const scene::Scene& scene_;
};

}  // namespace

std::unique_ptr<SceneParts> statementsOf(const std::string& text, const std::string& name, const std::string& folder,
                                         const scene::LoadOptions& options) {
  return std::make_unique<Statements>(text, name, folder, options);
}

std::unique_ptr<SceneParts> primitivesOf(const scene::Scene& scene) { return std::make_unique<Primitives>(scene); }

}  // namespace candela::capture
