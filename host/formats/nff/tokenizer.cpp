// Splits a scene file into words with their positions.
#include "host/formats/nff/tokenizer.h"

namespace candela::scene {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
bool endsWord(char c) { return isBlank(c) || isLineEnd(c) || c == '#'; }

std::string_view trimRight(std::string_view text) {
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

Tokenizer::Tokenizer(std::string_view text) : text_(text) {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  scan();
}

Token Tokenizer::take() {
  const Token taken = next_;
  if (taken.atEnd()) return taken;
  end_ = {taken.position.line, taken.position.column + static_cast<std::uint32_t>(taken.text.size())};
  scan();
  return taken;
}

Token Tokenizer::takeRestOfLine() {
  if (!nextIsOnLine()) return {{}, end_};
  const char* const begin = next_.text.data();
  while (offset_ < text_.size() && !isLineEnd(text_[offset_]) && text_[offset_] != '#') ++offset_;
  const Token rest{trimRight({begin, static_cast<std::size_t>(text_.data() + offset_ - begin)}), next_.position};
  end_ = {rest.position.line, rest.position.column + static_cast<std::uint32_t>(rest.text.size())};
  scan();
  return rest;
}

std::size_t Tokenizer::bytesLeft() const { return text_.size() - offset_ + next_.text.size(); }

Position Tokenizer::positionOf(std::size_t offset) const {
  return {line_, static_cast<std::uint32_t>(offset - lineStart_ + 1)};
}

void Tokenizer::breakLine() {
  const bool two = text_[offset_] == '\r' && offset_ + 1 < text_.size() && text_[offset_ + 1] == '\n';
  offset_ += two ? 2 : 1;
  lineStart_ = offset_;
  ++line_;
}

void Tokenizer::skipBlanks() {
  while (offset_ < text_.size()) {
    const char c = text_[offset_];
    if (isLineEnd(c)) {
      breakLine();
    } else if (isBlank(c)) {
      ++offset_;
    } else if (c == '#') {
      while (offset_ < text_.size() && !isLineEnd(text_[offset_])) ++offset_;
    } else {
      return;
    }
  }
}

void Tokenizer::scan() {
  skipBlanks();
  const std::size_t begin = offset_;
  while (offset_ < text_.size() && !endsWord(text_[offset_])) ++offset_;
  next_ = {text_.substr(begin, offset_ - begin), positionOf(begin)};
}

}  // namespace candela::scene
