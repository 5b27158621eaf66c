// Splits a scene file into words with their positions. Handles comments, blanks and the three kinds of line ends.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/formats/loading/diagnostic.h"

namespace candela::scene {

/// `text` refers to the file. It is empty only at the end of the file.
struct Token {
  std::string_view text;
  Position position;
  bool atEnd() const { return text.empty(); }
};

class Tokenizer {
 public:
  /// `text` must outlive the tokenizer and its tokens. A UTF-8 byte order mark is skipped.
  explicit Tokenizer(std::string_view text);

  /// Returns the next token without consuming it.
  const Token& peek() const { return next_; }
  Token take();
  /// Consumes the rest of the current line and returns it without comment and surrounding blanks; empty (but not the
  /// end) if nothing is left.
  Token takeRestOfLine();

  /// Returns the position after the last token that was consumed; 1:1 before the first.
  Position end() const { return end_; }
  /// Returns whether the next token is on the line of the last consumed token.
  bool nextIsOnLine() const { return !next_.atEnd() && next_.position.line == end_.line; }
  /// Returns the number of bytes from the next token on. They contain at most half as many tokens.
  std::size_t bytesLeft() const;

 private:
  Position positionOf(std::size_t offset) const;
  void skipBlanks();
  void breakLine();
  void scan();

  std::string_view text_;
  std::size_t offset_ = 0;  ///< after next_
  std::size_t lineStart_ = 0;
  std::uint32_t line_ = 1;
  Token next_;
  Position end_{1, 1};
};

}  // namespace candela::scene
