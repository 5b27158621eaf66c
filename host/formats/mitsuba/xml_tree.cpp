// Calls pugixml, and copies its tree.
#include "host/formats/mitsuba/xml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "host/base/lower_case.h"
#include "host/base/quote.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

constexpr std::size_t kMaxXmlBytes = std::size_t{64} << 20;
constexpr std::ptrdiff_t kMaxTags = 2'000'000;
constexpr std::ptrdiff_t kMaxAttributes = 4'000'000;
constexpr int kMaxXmlDepth = 64;
constexpr std::size_t kMaxAttributesOfElement = 64;

class TreeCopy {
 public:
  explicit TreeCopy(Document& document) : document_(document) {}

  Element copy(const pugi::xml_node& node, int depth) const {
    Element element{node.name(), {}, {}, placeOf(node)};
    if (depth > kMaxXmlDepth) {
      throw PlacedError{element.place, fmt::format("elements are nested more than {} deep", kMaxXmlDepth)};
    }
    for (const pugi::xml_attribute& attribute : node.attributes()) add(attribute, element);
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) {
        element.children.push_back(copy(child, depth + 1));
      } else if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        throw PlacedError{element.place, fmt::format("the element <{}> contains the text {}; values are attributes",
                                                     element.name, quote(child.value()))};
      }
    }
    return element;
  }

  /// pugixml states the offset of an element's name, and of the text of other nodes.
  Place placeOf(const pugi::xml_node& node) const {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 1) - 1);
    return {&document_, std::min(offset, document_.text().size())};
  }

 private:
  static void add(const pugi::xml_attribute& attribute, Element& element) {
    if (element.attributes.size() == kMaxAttributesOfElement) {
      throw PlacedError{element.place, fmt::format("the element has more than {} attributes", kMaxAttributesOfElement)};
    }
    if (std::ranges::count(element.attributes, std::string_view(attribute.name()), &Attribute::name) > 0) {
      throw PlacedError{element.place, fmt::format("the attribute {} is stated twice", quote(attribute.name()))};
    }
    element.attributes.push_back({attribute.name(), attribute.value()});
  }

  Document& document_;
};

/// Limits the memory that pugixml takes.
void checkSize(Document& document) {
  const std::string_view text = document.text();
  const auto fail = [&](std::size_t offset, const std::string& message) {
    throw PlacedError{{&document, offset}, message};
  };
  if (text.size() > kMaxXmlBytes) fail(0, fmt::format("the file is larger than {} MiB", kMaxXmlBytes >> 20));
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) fail(zero, "the file has a byte 0");
  if (std::ranges::count(text, '<') > kMaxTags) fail(0, fmt::format("the file has more than {} tags", kMaxTags));
  if (std::ranges::count(text, '=') > kMaxAttributes) {
    fail(0, fmt::format("the file has more than {} attributes", kMaxAttributes));
  }
}

}  // namespace

Element readXml(Document& document) {
  checkSize(document);
  const std::string_view text = document.text();
  pugi::xml_document tree;
  const pugi::xml_parse_result result = tree.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    std::string what = result.description();
    what.front() = lowerLetter(what.front());
    throw PlacedError{{&document, std::min(offset, text.size())}, "this is not well-formed XML: " + what};
  }
  const TreeCopy treeCopy(document);
  for (const pugi::xml_node& node : tree.children()) {
    if (node.type() == pugi::node_doctype) {
      throw PlacedError{{&document, text.find("<!DOCTYPE")}, "document type declarations (DOCTYPE) are not read"};
    }
    if (node.type() == pugi::node_element && node != tree.document_element()) {
      throw PlacedError{treeCopy.placeOf(node), "the file has a second root element"};
    }
  }
  if (!tree.document_element()) throw PlacedError{{&document, 0}, "the file has no element"};
  return treeCopy.copy(tree.document_element(), 1);
}

}  // namespace candela::mitsuba
