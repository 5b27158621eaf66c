// XML text as a tree of elements.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "host/formats/mitsuba/document.h"

namespace candela::mitsuba {

struct Attribute {
  std::string name;
  std::string value;  ///< with character references replaced
};

struct Element {
  std::string name;
  std::vector<Attribute> attributes{};  ///< with different names
  std::vector<Element> children{};
  Place place{};  ///< of its "<"
};

/// Reads the root element of a document with pugixml. Comments and processing instructions are passed over. Throws
/// PlacedError for text that is not well-formed, for a document type declaration (whose entities are therefore never
/// expanded), for text between elements, and beyond these limits: 64 MiB, 2 million tags, 4 million attributes,
/// elements that are nested 64 deep, 64 attributes of an element.
Element readXml(Document& document);

}  // namespace candela::mitsuba
