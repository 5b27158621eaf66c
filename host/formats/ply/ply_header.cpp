// Reads the lines of a header.
#include "host/formats/ply/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "host/base/quote.h"

namespace candela::ply {
namespace {

using scene::Position;
using scene::quote;

struct TypeName {
  std::string_view name;
  NumberType type;
};

/// The first name of each type is the one that messages use.
constexpr std::array kTypeNames{TypeName{"char", NumberType::int8},      TypeName{"int8", NumberType::int8},
                                TypeName{"uchar", NumberType::uint8},    TypeName{"uint8", NumberType::uint8},
                                TypeName{"short", NumberType::int16},    TypeName{"int16", NumberType::int16},
                                TypeName{"ushort", NumberType::uint16},  TypeName{"uint16", NumberType::uint16},
                                TypeName{"int", NumberType::int32},      TypeName{"int32", NumberType::int32},
                                TypeName{"uint", NumberType::uint32},    TypeName{"uint32", NumberType::uint32},
                                TypeName{"float", NumberType::float32},  TypeName{"float32", NumberType::float32},
                                TypeName{"double", NumberType::float64}, TypeName{"float64", NumberType::float64}};

constexpr std::size_t kMaxElements = 256;
constexpr std::size_t kMaxProperties = 1024;  // of one element

struct Word {
  std::string_view text;
  Position position;
};

/// The words of the header, line by line. All lines end as the first one does; after one that ends with LF, others may
/// end with CR LF.
class HeaderLines {
 public:
  explicit HeaderLines(const scene::SceneFile& file) : file_(file), rest_(file.bytes) {
    const std::size_t end = rest_.find_first_of("\r\n");
    const bool isPair = end != std::string_view::npos && rest_.substr(end, 2) == "\r\n";
    lineEnd_ = isPair ? "\r\n" : end != std::string_view::npos && rest_[end] == '\r' ? "\r" : "\n";
  }

  /// Goes to the next line, and returns its first word. Throws SceneError if the file ends.
  Word next() {
    ++line_;
    const std::size_t end = rest_.find(lineEnd_);
    if (end == std::string_view::npos) {
      fail({{}, {line_, 1}}, "the file ends within the header: there is no line \"end_header\"");
    }
    text_ = rest_.substr(0, end);
    rest_.remove_prefix(end + lineEnd_.size());
    if (text_.ends_with('\r')) text_.remove_suffix(1);
    offset_ = 0;
    return word();
  }

  /// Returns the next word of the line; empty at its end.
  Word word() {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t", offset_), text_.size());
    offset_ = std::min(text_.find_first_of(" \t", begin), text_.size());
    return {text_.substr(begin, offset_ - begin), {line_, static_cast<std::uint32_t>(begin + 1)}};
  }

  /// Returns what is left of the line, without blanks at both ends.
  Word rest() {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t", offset_), text_.size());
    const std::size_t end = text_.find_last_not_of(" \t") + 1;
    offset_ = text_.size();
    return {text_.substr(begin, end > begin ? end - begin : 0), {line_, static_cast<std::uint32_t>(begin + 1)}};
  }

  /// Throws SceneError if the line has another word.
  void requireEnd() {
    const Word surplus = word();
    if (!surplus.text.empty()) fail(surplus, fmt::format("unexpected {}", quote(surplus.text)));
  }

  std::size_t offset() const { return file_.bytes.size() - rest_.size(); }

  [[noreturn]] void fail(const Word& word, const std::string& message) const {
    throw scene::SceneError({{file_.name, word.position.line, word.position.column, message}});
  }

 private:
  const scene::SceneFile& file_;
  std::string_view rest_;
  std::string_view lineEnd_;
  std::string_view text_;  ///< of the current line
  std::size_t offset_ = 0;
  std::uint32_t line_ = 0;
};

class HeaderReader {
 public:
  explicit HeaderReader(const scene::SceneFile& file) : file_(file), lines_(file) {}

  Header read() {
    lines_.next();  // "ply"
    readFormat();
    for (Word keyword = lines_.next(); keyword.text != "end_header"; keyword = lines_.next()) readLine(keyword);
    header_.size = lines_.offset();
    requireRoom();
    return std::move(header_);
  }

 private:
  void readFormat() {
    Word keyword = lines_.next();
    while (passComment(keyword)) keyword = lines_.next();
    if (keyword.text != "format") lines_.fail(keyword, "expected \"format\", then the encoding and \"1.0\"");
    const Word name = lines_.word();
    if (name.text == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (name.text == "binary_little_endian") {
      header_.encoding = Encoding::littleEndian;
    } else if (name.text == "binary_big_endian") {
      header_.encoding = Encoding::bigEndian;
    } else {
      lines_.fail(name, fmt::format("{} is not ascii, binary_little_endian or binary_big_endian", quote(name.text)));
    }
    const Word version = lines_.word();
    if (version.text != "1.0") lines_.fail(version, fmt::format("version {} is not 1.0", quote(version.text)));
    lines_.requireEnd();
  }

  void readLine(const Word& keyword) {
    if (keyword.text == "element") return readElement(keyword);
    if (keyword.text == "property") return readProperty(keyword);
    if (passComment(keyword)) return;
    lines_.fail(keyword, fmt::format("unknown keyword {}; expected element, property, comment, obj_info or end_header",
                                     quote(keyword.text)));
  }

  /// Returns whether the line is empty or a comment. The name of an image is noted.
  bool passComment(const Word& keyword) {
    if (keyword.text == "comment" && lines_.word().text == "TextureFile") {
      const Word name = lines_.rest();
      if (!name.text.empty()) header_.textures.push_back({std::string(name.text), name.position});
    }
    return keyword.text == "comment" || keyword.text == "obj_info" || keyword.text.empty();
  }

  void readElement(const Word& keyword) {
    if (header_.elements.size() == kMaxElements) {
      lines_.fail(keyword, fmt::format("the file has more than {} kinds of elements", kMaxElements));
    }
    Element element;
    const Word name = lines_.word();
    if (name.text.empty()) lines_.fail(name, "expected the name of the element");
    const auto hasName = [&](const Element& other) { return other.name == name.text; };
    if (std::ranges::any_of(header_.elements, hasName)) {
      lines_.fail(name, fmt::format("element {} is stated twice", quote(name.text)));
    }
    element.name = name.text;
    const Word count = lines_.word();
    const char* const end = count.text.data() + count.text.size();
    const auto [stop, error] = std::from_chars(count.text.data(), end, element.count);
    if (error != std::errc() || stop != end) {
      lines_.fail(count, fmt::format("{} is not the number of the elements {}", quote(count.text), quote(name.text)));
    }
    lines_.requireEnd();
    header_.elements.push_back(std::move(element));
    positions_.push_back(count);
  }

  void readProperty(const Word& keyword) {
    if (header_.elements.empty()) lines_.fail(keyword, "a property before any element");
    Element& element = header_.elements.back();
    if (element.properties.size() == kMaxProperties) {
      lines_.fail(keyword, fmt::format("the element has more than {} properties", kMaxProperties));
    }
    Property property;
    Word type = lines_.word();
    if (type.text == "list") {
      const Word countType = lines_.word();
      property.countType = typeOf(countType);
      if (!isInteger(*property.countType)) lines_.fail(countType, "the length of a list is not an integer");
      type = lines_.word();
    }
    property.type = typeOf(type);
    const Word name = lines_.word();
    if (name.text.empty()) lines_.fail(name, "expected the name of the property");
    const auto hasName = [&](const Property& other) { return other.name == name.text; };
    if (std::ranges::any_of(element.properties, hasName)) {
      lines_.fail(name, fmt::format("property {} is stated twice", quote(name.text)));
    }
    property.name = name.text;
    lines_.requireEnd();
    element.properties.push_back(std::move(property));
  }

  NumberType typeOf(const Word& word) const {
    const auto* const found = std::ranges::find(kTypeNames, word.text, &TypeName::name);
    if (found != kTypeNames.end()) return found->type;
    lines_.fail(word, fmt::format("{} is not a type: char, uchar, short, ushort, int, uint, float, double or list",
                                  quote(word.text)));
  }

  /// Refuses counts beyond what the file can contain, so that memory and time are limited by its size.
  void requireRoom() const {
    const std::size_t bytes = file_.bytes.size() - header_.size;
    const bool isText = header_.encoding == Encoding::ascii;
    std::uint64_t room = isText ? (bytes + 1) / 2 : bytes;  // a value in a text takes a digit and a blank
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      const Element& element = header_.elements[i];
      if (element.count == 0) continue;
      const std::uint64_t size = element.minSize(header_.encoding);
      if (size == 0) lines_.fail(positions_[i], fmt::format("the element {} has no properties", quote(element.name)));
      if (element.count > room / size) {
        lines_.fail(positions_[i], fmt::format("{} elements {} are more than the file can contain", element.count,
                                               quote(element.name)));
      }
      room -= element.count * size;
    }
  }

  const scene::SceneFile& file_;
  HeaderLines lines_;
  Header header_{};
  std::vector<Word> positions_{};  ///< of the counts of elements
};

}  // namespace

std::string_view nameOf(NumberType type) { return std::ranges::find(kTypeNames, type, &TypeName::type)->name; }

std::uint64_t Element::minSize(Encoding encoding) const {
  std::uint64_t size = 0;
  for (const Property& property : properties) {
    size += encoding == Encoding::ascii ? 1 : sizeOf(property.countType.value_or(property.type));
  }
  return size;
}

bool looksLikePly(std::string_view bytes) {
  constexpr std::string_view kMagic = "ply";
  return bytes.starts_with(kMagic) && bytes.size() > kMagic.size() &&
         (bytes[kMagic.size()] == '\n' || bytes[kMagic.size()] == '\r');
}

Header readHeader(const scene::SceneFile& file) {
  if (!looksLikePly(file.bytes)) throw scene::SceneError({{file.name, 1, 1, "the first line is not \"ply\""}});
  return HeaderReader(file).read();
}

}  // namespace candela::ply
