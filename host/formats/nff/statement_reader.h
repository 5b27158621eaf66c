// Reads the numbers and words of one statement. Required numbers may continue on later lines; optional numbers may not.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/loading/diagnostic.h"
#include "host/formats/nff/tokenizer.h"

namespace candela::scene {

class StatementReader {
 public:
  explicit StatementReader(Tokenizer& tokens) : tokens_(&tokens) {}

  /// Consumes the keyword. `form` shows the syntax of the statement in messages.
  Token begin(std::string_view form);

  /// Reads a required number. `what` names it in messages: "the radius". Throws StatementError.
  float number(std::string_view what);
  /// Reads three required numbers. Throws StatementError.
  glm::vec3 vector(std::string_view what);
  /// Reads a required whole number in [min, max]. Throws StatementError.
  std::int64_t wholeNumber(std::string_view what, std::int64_t min, std::int64_t max);
  /// Reads a required word on the same line. Throws StatementError.
  Token word(std::string_view what);

  /// Return whether the next token is a number: on this line, or on any line.
  bool numberOnLine() const;
  bool numberFollows() const;
  /// Reads the numbers that remain on the line, at most `maxCount`.
  std::vector<float> numbersOnLine(std::size_t maxCount);
  std::string_view form() const { return form_; }

  /// Returns the position of the last number that was read.
  Position lastNumber() const { return lastNumber_; }
  /// Returns the position of the next token if it is on this line, else the position after the last token.
  Position here() const;
  /// Skips to the next line that does not begin with a number, and so skips the rest of a statement that failed.
  void skipStatement();
  [[noreturn]] static void fail(Position position, std::string message);

 private:
  [[noreturn]] void failExpecting(std::string_view what) const;
  Token takeNumber(std::string_view what);

  Tokenizer* tokens_;
  std::string_view form_;
  Position lastNumber_;
};

}  // namespace candela::scene
