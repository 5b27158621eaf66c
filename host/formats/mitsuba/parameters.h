// The parameters of a scene: <default>, the definitions of `--define`, and "$name" in the values of attributes.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/mitsuba/document.h"

namespace candela::mitsuba {

class Parameters {
 public:
  /// `definitions`: "NAME=VALUE" each, which precede all defaults. Throws UsageError for one without a name or "=".
  explicit Parameters(const std::vector<std::string>& definitions);

  /// Defines a parameter, unless it is defined already, or its name is longer than 256 bytes.
  void addDefault(const std::string& name, const std::string& value);
  /// Replaces every "$name", of which the longest name that is defined counts, and "\$" by "$". What a value contains
  /// is not replaced again. Throws PlacedError for a name that is not defined, and if the values of all attributes in
  /// which something was replaced take more than 64 MiB.
  std::string substitute(const std::string& text, const Place& place);
  /// The names of definitions that no attribute uses.
  std::vector<std::string> unusedDefinitions() const;

 private:
  struct Parameter {
    std::string value;
    bool isUsed = false;
    bool isDefinition = false;
  };
  std::map<std::string, Parameter, std::less<>> parameters_{};
  std::size_t byteCount_ = 0;
};

}  // namespace candela::mitsuba
