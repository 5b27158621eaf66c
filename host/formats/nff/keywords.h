// The table of statements: keyword, syntax and handler.
#pragma once
#include <string>
#include <string_view>

namespace candela::scene {

struct Parser;

struct Keyword {
  std::string_view name;
  std::string_view form;       ///< syntax for messages
  std::string_view countedAs;  ///< name in StatementCounts
  /// Reads the statement after its keyword. Throws StatementError.
  void (*parse)(Parser&);
};

/// Returns nullptr if `word` is not a keyword. Keywords are case-sensitive.
const Keyword* findKeyword(std::string_view word);

/// Returns the message for a word that is not a keyword, with a suggestion if there is one.
std::string describeUnknown(std::string_view word);

/// Returns whether the word begins an entry of a view.
bool isViewKeyword(std::string_view word);

}  // namespace candela::scene
