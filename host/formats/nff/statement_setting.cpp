// `b`, `env`, `accel` and `spp`: settings of the whole scene.
#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/sky.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {

void parseBackground(Parser& parser) {
  const Position position = parser.in.here();
  parser.scene.background = parser.in.vector("the background's colour");
  parser.requireNonNegative("the background's colour", parser.scene.background, position);
}

void parseSky(Parser& parser) {
  if (!parser.tokens.nextIsOnLine()) parser.in.word("the sky's folder");
  const Token name = parser.tokens.takeRestOfLine();
  const bool printable = std::ranges::none_of(name.text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (!printable) StatementReader::fail(name.position, "the sky's folder has a control character in its name");
  std::vector<std::string> warnings;
  try {
    parser.scene.sky = loadSky(parser.folder / name.text, parser.guard, warnings);
    for (const std::string& warning : warnings) parser.log.warn(warning, name.position, warning);
  } catch (const FileError& error) {
    return parser.deviation("sky", name.position, error.what());
  }
  if (parser.scene.sky) return;
  parser.log.warn("no sky", name.position,
                  fmt::format("there is no folder {}; the background's colour is used", quote(name.text)));
}

void parseAccel(Parser& parser) {
  if (parser.in.numberFollows()) {
    parser.scene.requestedAccel = static_cast<RequestedAccel>(parser.in.wholeNumber("accel", 0, 2));
    return;
  }
  const Token word = parser.in.word("0, 1, 2, none, grid or bvh");
  const auto* const found = std::ranges::find(kRequestedAccelNames, word.text);
  if (found == kRequestedAccelNames.end()) {
    StatementReader::fail(word.position,
                          fmt::format("expected 0, 1, 2, none, grid or bvh, found {}", quote(word.text)));
  }
  parser.scene.requestedAccel = static_cast<RequestedAccel>(found - kRequestedAccelNames.begin());
}

void parseSamples(Parser& parser) {
  constexpr std::int64_t kMaxSamples = 1'000'000'000;
  const auto samples = static_cast<std::uint32_t>(parser.in.wholeNumber("spp", 0, kMaxSamples));
  parser.scene.requestedSamples = samples;
  if (samples == 0) {
    return parser.log.warn("spp", parser.keyword,
                           "spp 0 is read as one ray through the centre of each pixel, without antialiasing");
  }
  parser.log.warn(
      "spp", parser.keyword,
      fmt::format("spp {} is read as {} samples per pixel in total; some programs read it as samples per side", samples,
                  samples));
}

}  // namespace candela::scene
