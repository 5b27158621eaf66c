// The table of statements: keyword, form, handler.
#pragma once
#include <string>
#include <string_view>

namespace candela::scene {

struct Parser;

struct Keyword {
  std::string_view name;
  std::string_view form;       ///< as messages show it
  std::string_view countedAs;  ///< in StatementCounts
  /// Reads what follows the keyword. Throws StatementError.
  void (*parse)(Parser&);
};

/// nullptr if `word` is no keyword. Keywords are case-sensitive.
const Keyword* findKeyword(std::string_view word);

/// The message for a word that is no keyword, with a suggestion where there is one.
std::string describeUnknown(std::string_view word);

/// True for the words that begin an entry of a view.
bool isViewKeyword(std::string_view word);

}  // namespace candela::scene
