// Films name their settings and values as the command line does.
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "host/app/cli/render_job.h"
#include "host/job/film_identity.h"
#include "tests/app/cli/find_option.h"

namespace candela::cli {
namespace {

std::shared_ptr<const scene::Scene> sharedScene() {
  auto scene = std::make_shared<scene::Scene>();
  scene->camera = scene::Camera{};
  scene->camera->width = scene->camera->height = 64;
  scene->pointLights.emplace_back();
  return scene;
}

RenderJob jobWith(const std::vector<std::pair<std::string, std::string>>& options) {
  Arguments arguments = RenderArguments();
  for (const auto& [name, value] : options) REQUIRE(find(name, Command::render).apply(arguments, value));
  std::ostringstream sink;
  return jobOf(std::get<RenderArguments>(arguments), sharedScene(), Log(sink, Verbosity::normal));
}

void checkSettings(const RenderJob& job) {
  const Arguments stated = statedArguments(job);
  for (const job::FilmSetting& setting : job::filmSettings()) {
    CAPTURE(setting.name);
    const std::string name = "--" + std::string(setting.name);
    const Option& option = find(name, Command::render);
    const std::vector<std::string> words = option.show(stated);
    CHECK(setting.value(job) == (words.empty() ? "off" : words.front()));
    CHECK(setting.isFlag == option.isFlag());
  }
}

}  // namespace

TEST_CASE("each setting of films has the name, the default and the values of an option") {
  checkSettings(jobWith({}));
  checkSettings(jobWith({{"--max-depth", "7"},
                         {"--rr-start", "2"},
                         {"--ao-distance", "0.1"},
                         {"--nee", "off"},
                         {"--lights", "tree"},
                         {"--sampler", "independent"},
                         {"--filter", "tent"},
                         {"--lens", "square"},
                         {"--pixel-origin", "corner"},
                         {"--light-size", "0.3"},
                         {"--clamp-indirect", "1.7"},
                         {"--background", "none"},
                         {"--aov-through-specular", "true"},
                         {"--noise-threshold", "15%"},
                         {"--spp", "4096"},
                         {"--one-sided", "true"},
                         {"--lenient", "true"},
                         {"--env-rotate", "12.5"},
                         {"--env-scale", "0.7"},
                         {"--camera", "left"},
                         {"--time", "0.25"},
                         {"--animation", "walk"}}));
  checkSettings(jobWith({{"--filter", "gaussian"}}));
  checkSettings(jobWith({{"--filter", "gaussian:0.35"}}));
  checkSettings(jobWith({{"--integrator", "whitted"}, {"--sampler", "stratified"}, {"--background", "env"}}));
}

// A new option that decides the image and that films do not record would let films be resumed with another value.
TEST_CASE("every option that decides the image is a setting of films, or a member of their headers") {
  std::set<std::string> recorded{"--size", "--spp", "--seed", "--film-scale"};
  // The folders that files may be in do not change what is read, and the scene's hash covers the environment and the
  // definitions.
  recorded.insert({"--allow-path", "--env", "--define"});
  for (const job::FilmSetting& setting : job::filmSettings()) recorded.insert("--" + std::string(setting.name));
  for (const Option& option : optionTable()) {
    const bool decides = option.group == OptionGroup::image || option.group == OptionGroup::sceneFile;
    if (!decides || !option.isFor(Command::render)) continue;
    CAPTURE(option.name());
    CHECK(recorded.contains(option.name()));
  }
}

}  // namespace candela::cli
