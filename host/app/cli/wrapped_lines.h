// Text in columns, whose lines have a maximum width.
#pragma once
#include <cstddef>
#include <sstream>
#include <string>

namespace candela::cli {

/// Appends words to lines of a maximum width.
class WrappedLines {
 public:
  explicit WrappedLines(std::size_t width) : width_(width) {}

  void add(const std::string& text) {
    std::istringstream words(text);
    for (std::string word; words >> word;) addWord(word);
  }
  /// Appends a text that has columns of its own, unless it is too long for a line.
  void addColumns(const std::string& text) {
    if (column_ + text.size() > width_) return add(text);
    out_ += text;
    column_ += text.size();
    isStart_ = false;
  }
  /// Continues at a column, on a new line if the current one is beyond it. Later lines begin at `indent`.
  void moveTo(std::size_t column, std::size_t indent) {
    indent_ = indent;
    if (column_ + 2 > column) startLine();
    out_.append(column - column_, ' ');
    column_ = column;
    isStart_ = true;
  }
  std::string text() const { return out_ + "\n"; }

 private:
  void startLine() {
    out_ += "\n" + std::string(indent_, ' ');
    column_ = indent_;
    isStart_ = true;
  }
  void addWord(const std::string& word) {
    if (!isStart_ && column_ + 1 + word.size() > width_) startLine();
    if (!isStart_) out_ += ' ';
    column_ += word.size() + (isStart_ ? 0 : 1);
    out_ += word;
    isStart_ = false;
  }

  std::size_t width_;
  std::size_t indent_ = 0;
  std::string out_;
  std::size_t column_ = 0;
  bool isStart_ = true;
};

}  // namespace candela::cli
