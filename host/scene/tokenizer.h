// Splits a scene file into words, each with its place, and hides comments, blanks and the three kinds of line end.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace candela::scene {

/// 1-based; columns count bytes, a tab is one.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// `text` points into the file. It is empty at the end of the file only.
struct Token {
  std::string_view text;
  Position position;
  bool atEnd() const { return text.empty(); }
};

class Tokenizer {
 public:
  /// `text` must outlive the tokenizer and its tokens. A UTF-8 byte order mark is skipped.
  explicit Tokenizer(std::string_view text);

  /// The next token, which stays the next one.
  const Token& peek() const { return next_; }
  Token take();
  /// What is left of the current line, without comment and surrounding blanks; empty (but not the end) if nothing is.
  Token takeRestOfLine();

  /// Just behind the last token taken; 1:1 before the first.
  Position end() const { return end_; }
  /// True if the next token is on the line of the last one taken.
  bool nextIsOnLine() const { return !next_.atEnd() && next_.position.line == end_.line; }
  /// Bytes from the next token on: what is left can hold no more than half as many tokens.
  std::size_t bytesLeft() const;

 private:
  Position positionOf(std::size_t offset) const;
  void skipBlanks();
  void breakLine();
  void scan();

  std::string_view text_;
  std::size_t offset_ = 0;  ///< behind next_
  std::size_t lineStart_ = 0;
  std::uint32_t line_ = 1;
  Token next_;
  Position end_{1, 1};
};

}  // namespace candela::scene
