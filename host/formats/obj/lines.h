// The lines of OBJ and MTL files, word by word.
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "host/formats/loading/diagnostic_log.h"

namespace candela::obj {

struct Word {
  std::string_view text;  ///< empty at the end of the line
  scene::Position position;
};

/// Reads a text from its beginning. A backslash before a line end continues the line. `#` begins a comment where a word
/// could begin. Functions that read numbers throw scene::StatementError.
class Lines {
 public:
  explicit Lines(std::string_view text);

  bool isAtEnd() const { return next_ == end_; }
  /// Returns the next word of the line.
  Word word();
  /// Returns whether another word is on the line.
  bool hasWord() {
    skipBlanks();
    return !endsLine();
  }
  /// Returns what is left of the line, without blanks at both ends. Comments are part of it: names may contain `#`.
  Word rest();
  /// Passes what is left of the line.
  void skipRest() {
    while (next_ != end_ && !isLineEnd(*next_)) skipByte();
  }
  /// Goes to the next line.
  void endLine() {
    skipRest();
    if (next_ != end_) breakLine();
  }
  /// Reads a number, rounded once to single precision. `what` names it in messages: "a coordinate".
  float number(std::string_view what) {
    skipBlanks();
    float value = 0;
    const auto [stop, error] = std::from_chars(next_, end_, value);
    if (error != std::errc() || !endsWord(stop) || !std::isfinite(value)) return otherNumber(what);
    next_ = stop;
    return value;
  }
  /// Reads a whole number that may be followed by `/`. Returns false, and stays, if there is none.
  bool index(std::int64_t& value);
  /// Passes `/` if it is next.
  bool slash() {
    if (next_ == end_ || *next_ != '/') return false;
    ++next_;
    return true;
  }
  /// Returns whether a word ends here.
  bool isAtWordEnd() const { return endsWord(next_); }

  /// Returns the position of the next byte.
  scene::Position here() const { return {line_, static_cast<std::uint32_t>(next_ - lineBegin_ + 1)}; }
  /// Returns the number of bytes that are left.
  std::size_t size() const { return static_cast<std::size_t>(end_ - next_); }
  [[noreturn]] static void fail(scene::Position position, std::string message) {
    throw scene::StatementError{position, std::move(message)};
  }

 private:
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  bool endsWord(const char* p) const { return p == end_ || isBlank(*p) || isLineEnd(*p) || isContinuation(p); }
  bool endsLine() const { return next_ == end_ || isLineEnd(*next_) || *next_ == '#'; }
  bool isContinuation(const char* p) const { return *p == '\\' && p + 1 != end_ && isLineEnd(p[1]); }
  void skipBlanks() {
    while (next_ != end_ && (isBlank(*next_) || isContinuation(next_))) skipByte();
  }
  /// Passes a byte, or a backslash and the line end that it continues.
  void skipByte() {
    if (!isContinuation(next_++)) return;
    breakLine();
  }
  void breakLine() {
    const bool isPair = *next_ == '\r' && next_ + 1 != end_ && next_[1] == '\n';
    next_ += isPair ? 2 : 1;
    lineBegin_ = next_;
    ++line_;
  }
  float otherNumber(std::string_view what);

  const char* next_;
  const char* end_;
  const char* lineBegin_;
  std::uint32_t line_ = 1;
};

/// Adds an error about the next word of a line, which should have ended, or with `lenient` a warning.
void reportSurplus(Lines& lines, bool lenient, scene::DiagnosticLog& log);

/// Calls `readStatement` for each line until the log is full. Adds the errors that it throws, and those of words that
/// it leaves on the line.
template <class Action>
void readLines(Lines& lines, bool lenient, scene::DiagnosticLog& log, const Action& readStatement) {
  while (!lines.isAtEnd() && !log.isFull()) {
    try {
      readStatement();
      if (lines.hasWord()) reportSurplus(lines, lenient, log);
    } catch (scene::StatementError& error) {
      log.error(error.position, std::move(error.message));
    }
    lines.endLine();
  }
}

}  // namespace candela::obj
