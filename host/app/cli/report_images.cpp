// The page on two image files. Their metadata are shown, but not trusted.
#include <fmt/format.h>

#include <array>

#include "host/app/cli/display_choice.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/report_page.h"
#include "host/base/hash.h"
#include "host/base/hash_text.h"

namespace candela::cli {
namespace {

using report::Outcome;
using report::Report;

struct MetadataFact {
  const char* name;
  const char* key;
};
constexpr std::array kMetadataFacts{MetadataFact{"Scene", "candela.scene"},
                                    MetadataFact{"Scene hash", "candela.sceneHash"},
                                    MetadataFact{"Film hash", "candela.filmHash"},
                                    MetadataFact{"Device", "candela.device"},
                                    MetadataFact{"Driver", "candela.driver"},
                                    MetadataFact{"Samples per pixel", "candela.samplesPerPixel"},
                                    MetadataFact{"Seed", verify::kSeedMetadata},
                                    MetadataFact{"Settings", "candela.settings"},
                                    MetadataFact{"Bad samples", "candela.badSamples"},
                                    MetadataFact{"Interrupted", "candela.interrupted"},
                                    MetadataFact{"Written by candela", "candela.version"}};

std::string metadataOf(const image::Image& image, const char* key) {
  const auto entry = image.metadata.find(key);
  return entry == image.metadata.end() ? "" : entry->second;
}

// The hash is that of the colours, since not every format can store a hash of the film.
std::string pixelHash(const image::Image& image) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(image.rgb.data());
  return hashText(fnv1a({first, image.rgb.size() * sizeof(glm::vec3)}));
}

std::vector<report::Fact> factsOf(const CompareArguments& arguments, const image::Image& a, const image::Image& b) {
  std::vector<report::Fact> facts{{"File", arguments.files[0], arguments.files[1]},
                                  {"Hash of the colours", pixelHash(a), pixelHash(b)}};
  for (const auto& [name, key] : kMetadataFacts) {
    const report::Fact fact{name, metadataOf(a, key), metadataOf(b, key)};
    if (!fact.a.empty() || !fact.b.empty()) facts.push_back(fact);
  }
  return facts;
}

// Metadata may contain anything; settings with characters that are special to a shell give no command.
bool isHarmless(const std::string& settings) {
  const std::string plain = std::string(kPlainCharacters) + ' ';
  return settings.starts_with("--") && settings.find_first_not_of(plain) == std::string::npos;
}

// Returns the command that rendered the file, or nothing if the metadata do not contain it.
std::string renderCommand(const std::string& file, const image::Image& image) {
  const std::string scene = metadataOf(image, "candela.scene");
  const std::string settings = metadataOf(image, "candela.settings");
  const std::string device = metadataOf(image, "candela.device");
  if (scene.empty() || scene.starts_with('-') || !isHarmless(settings)) return "";
  return fmt::format("candela render {} {} --device {} -o {}", shellQuoted(scene), settings, shellQuoted(device),
                     shellQuoted(file));
}

std::vector<std::string> commandsOf(const CompareArguments& arguments, const image::Image& a, const image::Image& b) {
  std::string compare = fmt::format("candela compare {} {}", shellQuoted(arguments.files[0]),
                                    shellQuoted(arguments.files[1]));
  for (const OptionGroup group : {OptionGroup::output, OptionGroup::comparison}) {
    const std::string options = commandLineOf(arguments, group, true);
    if (!options.empty()) compare += " " + options;
  }
  std::vector<std::string> commands;
  for (const std::string& command :
       {renderCommand(arguments.files[0], a), renderCommand(arguments.files[1], b), compare}) {
    if (!command.empty()) commands.push_back(command);
  }
  return commands;
}

Outcome outcomeOf(const ImageVerdict& verdict) {
  if (!verdict.isGiven()) return Outcome::none;
  return report::outcomeOf(verdict.conclusion());
}

}  // namespace

Report imageReport(const CompareArguments& arguments, const image::Image& a, const image::Image& reference,
                   const image::ImageComparison& comparison, const image::FlipResult& flip,
                   const ImageVerdict& verdict) {
  Report page;
  page.title = fmt::format("{} and {}", arguments.files[0], arguments.files[1]);
  page.outcome = outcomeOf(verdict);
  page.verdict = verdict.sentence();
  page.nameA = arguments.files[0];
  page.nameB = arguments.files[1];
  page.a = a;
  page.b = reference;
  page.display = chooseDisplay(arguments, render::Integrator::path, reference);
  page.comparison = comparison;
  page.flip = flip;
  if (verdict.films) page.tests = *verdict.films;
  page.facts = factsOf(arguments, a, reference);
  page.commands = commandsOf(arguments, a, reference);
  return page;
}

}  // namespace candela::cli
