// The loop over statements: keyword, handler, recovery from errors.
#include "host/formats/nff/parser.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/quote.h"
#include "host/formats/loading/number.h"
#include "host/formats/nff/keywords.h"
#include "host/formats/nff/nff_material.h"

namespace candela::scene {
namespace {

void checkSurplus(Parser& parser) {
  if (!parser.in.numberOnLine()) return;
  const Token& surplus = parser.tokens.peek();
  parser.deviation("surplus number", surplus.position,
                   fmt::format("unexpected number {}; the form is: {}", quote(surplus.text), parser.in.form()));
  parser.in.skipStatement();
}

void parseStatement(Parser& parser, const Keyword& keyword) {
  parser.keyword = parser.in.begin(keyword.form).position;
  try {
    const std::size_t first = parser.scene.primitives.size();
    keyword.parse(parser);
    if (parser.scene.primitives.size() > first) parser.scene.objectStarts.push_back(static_cast<std::uint32_t>(first));
    ++parser.counts[std::string(keyword.countedAs)];
    checkSurplus(parser);
  } catch (StatementError& error) {
    parser.log.error(error.position, std::move(error.message));
    parser.in.skipStatement();
  }
}

}  // namespace

void Parser::deviation(const std::string& kind, Position position, const std::string& message) {
  if (options.lenient) {
    log.warn(kind, position, message + "; skipped");
  } else {
    log.error(position, message);
  }
}

void Parser::requireNonNegative(std::string_view what, float value, Position position) {
  if (value < 0) log.error(position, fmt::format("{} must not be negative", what));
}

void Parser::requireNonNegative(std::string_view what, const glm::vec3& value, Position position) {
  requireNonNegative(what, std::min({value.x, value.y, value.z}), position);
}

std::size_t Parser::itemCount(std::string_view what, std::int64_t min, std::int64_t max, std::size_t numbersPerItem) {
  constexpr std::size_t
      kHarmless = 1024;  // always permitted, because the message about a missing number is then clearer
  const auto count = static_cast<std::size_t>(in.wholeNumber(what, min, max));
  const std::size_t room = (tokens.bytesLeft() + 1) / 2 / numbersPerItem;
  if (count <= std::max(room, kHarmless)) return count;
  StatementReader::fail(in.lastNumber(),
                        fmt::format("{} {} is more than the rest of the file can contain", what, count));
}

bool Parser::lists(const std::string& kind) const {
  return options.lenient ? log.listsWarning(kind) : log.listsError();
}

std::uint32_t Parser::currentMaterial() {
  if (!material) {
    log.warn("default material", keyword, "an object before any material (\"f\") is diffuse white");
    material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(fromNff({}));
  }
  return *material;
}

void skipUnknown(Parser& parser) {
  const Token token = parser.in.begin({});
  parser.in.skipStatement();
  if (looksLikeNumber(token.text)) {
    const std::string found = quote(token.text);
    parser.deviation(
        "stray number", token.position,
        fmt::format("expected a keyword, found {}; optional numbers must be on the line of their keyword", found));
    return;
  }
  const std::string kind = "unknown " + std::string(token.text.substr(0, 40));
  parser.deviation(kind, token.position, parser.lists(kind) ? describeUnknown(token.text) : "");
}

void parseStatements(Parser& parser) {
  while (!parser.tokens.peek().atEnd() && !parser.log.isFull()) {
    const Keyword* const keyword = findKeyword(parser.tokens.peek().text);
    if (keyword) {
      parseStatement(parser, *keyword);
    } else {
      skipUnknown(parser);
    }
  }
}

}  // namespace candela::scene
