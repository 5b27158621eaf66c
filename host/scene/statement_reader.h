// Reads the numbers and words of one statement. Required numbers cross line ends; optional ones never do.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/tokenizer.h"

namespace candela::scene {

/// Ends the reading of a statement. Caught by the parser, which goes on with the next one.
struct StatementError {
  Position position;
  std::string message;
};

class StatementReader {
 public:
  explicit StatementReader(Tokenizer& tokens) : tokens_(&tokens) {}

  /// Takes the keyword. `form` shows the statement's grammar in messages.
  Token begin(std::string_view form);

  /// A required number; `what` names it in messages: "the radius". Throws StatementError.
  float number(std::string_view what);
  /// Three required numbers. Throws StatementError.
  glm::vec3 vector(std::string_view what);
  /// A required whole number in [min, max]. Throws StatementError.
  std::int64_t wholeNumber(std::string_view what, std::int64_t min, std::int64_t max);
  /// A required word, on the same line. Throws StatementError.
  Token word(std::string_view what);

  /// True if the next token is a number: on this line, or anywhere.
  bool numberOnLine() const;
  bool numberFollows() const;
  /// The numbers left on the line, `most` of them at most.
  std::vector<float> numbersOnLine(std::size_t most);
  std::string_view form() const { return form_; }

  /// Where the last number read stands.
  Position lastNumber() const { return lastNumber_; }
  /// Where the next token is if it is on this line, else just behind the last one.
  Position here() const;
  /// Skips to the next line that does not begin with a number: what a failed statement may have owned.
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
