// Indices of refraction by name.
#include "host/formats/mitsuba/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host/base/lower_case.h"
#include "host/base/quote.h"
#include "host/formats/mitsuba/names.h"

namespace candela::mitsuba {
namespace {

struct Metal {
  std::string_view name;
  glm::vec3 ior, extinction;
};

// clang-format off
constexpr std::array kMetals{
    Metal{"Ag", {0.15528, 0.11673, 0.13839}, {4.8284, 3.1222, 2.1469}},
    Metal{"Al", {1.6575, 0.8804, 0.52124}, {9.2238, 6.2695, 4.837}},
    Metal{"AlAs", {3.6053, 3.2329, 2.2163}, {0.00067944, 0, 0.0075127}},
    Metal{"AlSb", {0, 4.1394, 4.6693}, {0, 0.094009, 1.3006}},
    Metal{"Au", {0.14304, 0.37531, 1.442}, {3.983, 2.3856, 1.6034}},
    Metal{"Be", {4.185, 3.185, 2.7841}, {3.8355, 3.0101, 2.869}},
    Metal{"Cr", {4.3697, 2.9165, 1.6549}, {5.2065, 4.2313, 3.7547}},
    Metal{"CsI", {2.1449, 1.7023, 1.6624}, {0, 0, 0}},
    Metal{"Cu", {0.20101, 0.92375, 1.1022}, {3.9133, 2.453, 2.1421}},
    Metal{"Cu2O", {3.5518, 2.9499, 2.7519}, {0.11421, 0.1939, 0.60613}},
    Metal{"CuO", {3.2475, 2.4478, 2.2102}, {0.52109, 0.57003, 0.72218}},
    Metal{"Cu_palik", {0.21323, 0.91972, 1.1024}, {3.9219, 2.4573, 2.1366}},
    Metal{"Hg", {2.3989, 1.44, 0.90957}, {6.3276, 4.3719, 3.4218}},
    Metal{"HgTe", {4.779, 3.2312, 2.6599}, {1.6316, 1.5808, 1.7293}},
    Metal{"Ir", {3.0863, 2.0822, 1.6179}, {5.5922, 4.0671, 3.2673}},
    Metal{"K", {0.064043, 0.04641, 0.038185}, {2.1042, 1.3489, 0.91313}},
    Metal{"Li", {0.26579, 0.19562, 0.22095}, {3.5402, 2.3111, 1.6686}},
    Metal{"MgO", {2.0896, 1.6507, 1.5949}, {4.3327e-12, 0, 2.4986e-11}},
    Metal{"Mo", {4.484, 3.5251, 2.7763}, {4.1114, 3.4208, 3.1506}},
    Metal{"Na_palik", {0.060269, 0.056141, 0.061988}, {3.1793, 2.1125, 1.579}},
    Metal{"Nb", {3.4201, 2.7901, 2.3956}, {3.4414, 2.7377, 2.5797}},
    Metal{"Ni_palik", {2.3673, 1.6634, 1.4671}, {4.4988, 3.0502, 2.3454}},
    Metal{"Rh", {2.5858, 1.8602, 1.5543}, {6.7823, 4.703, 3.9761}},
    Metal{"Se-e", {5.7228, 4.1657, 4.0813}, {0.87114, 1.1052, 1.5653}},
    Metal{"Se", {4.0583, 2.8429, 2.8209}, {0.75405, 0.63844, 0.52181}},
    Metal{"SiC", {3.1723, 2.526, 2.4794}, {7.5377e-07, 0, 1.0193e-05}},
    Metal{"SnTe", {4.5242, 1.9816, 1.2816}, {0, 0, 0}},
    Metal{"Ta", {2.0627, 2.3929, 2.6279}, {2.4084, 1.7415, 1.947}},
    Metal{"Te-e", {7.5089, 4.2964, 2.37}, {5.5839, 4.9472, 3.9976}},
    Metal{"Te", {7.3902, 4.4821, 2.6371}, {3.256, 3.5271, 3.2921}},
    Metal{"ThF4", {1.8307, 1.4422, 1.3876}, {0, 0, 0}},
    Metal{"TiC", {3.7005, 2.8374, 2.5823}, {3.2656, 2.3516, 2.1728}},
    Metal{"TiN", {1.6484, 1.1505, 1.3798}, {3.3683, 1.9435, 1.1021}},
    Metal{"TiO2-e", {3.1066, 2.5132, 2.5824}, {2.9752e-05, 0, 0.0001827}},
    Metal{"TiO2", {3.4566, 2.8017, 2.9052}, {0.00010526, 0, 0.00065289}},
    Metal{"VC", {3.6576, 2.7527, 2.5327}, {3.0683, 2.1987, 1.9632}},
    Metal{"VN", {2.8656, 2.1192, 1.9401}, {3.0322, 2.0561, 1.6163}},
    Metal{"V_palik", {4.2776, 3.5129, 2.7611}, {3.4913, 2.8895, 3.1115}},
    Metal{"W", {4.3708, 3.3002, 2.9984}, {3.5006, 2.6049, 2.2732}},
    Metal{"a-C", {2.944, 2.2271, 1.9682}, {0.88746, 0.7993, 0.81529}},
    Metal{"d-C", {2.7087, 2.3188, 2.2289}, {0, 0, 0}}};
// clang-format on

struct Dielectric {
  std::string_view name;
  double ior;
};

constexpr std::array kDielectrics{
    Dielectric{"vacuum", 1},        Dielectric{"helium", 1.000036},        Dielectric{"hydrogen", 1.000132},
    Dielectric{"air", 1.000277},    Dielectric{"carbon dioxide", 1.00045}, Dielectric{"water", 1.333},
    Dielectric{"acetone", 1.36},    Dielectric{"ethanol", 1.361},          Dielectric{"carbon tetrachloride", 1.461},
    Dielectric{"glycerol", 1.4729}, Dielectric{"benzene", 1.501},          Dielectric{"silicone oil", 1.52045},
    Dielectric{"bromine", 1.661},   Dielectric{"water ice", 1.31},         Dielectric{"fused quartz", 1.458},
    Dielectric{"pyrex", 1.47},      Dielectric{"acrylic glass", 1.49},     Dielectric{"polypropylene", 1.49},
    Dielectric{"bk7", 1.5046},      Dielectric{"sodium chloride", 1.544},  Dielectric{"amber", 1.55},
    Dielectric{"pet", 1.575},       Dielectric{"diamond", 2.419}};

template <class Table>
[[noreturn]] void failName(const Property& property, const std::string& name, const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  throw PlacedError{property.place,
                    fmt::format("no material has the name {}{}", scene::quote(name), suggestionFor(name, names))};
}

}  // namespace

scene::Conductor metalOf(const Property& property, const std::string& name) {
  constexpr std::string_view kSuffix = "_palik";
  const auto find = [](std::string_view wanted) { return std::ranges::find(kMetals, wanted, &Metal::name); };
  auto found = find(name);
  if (found == kMetals.end() && name.ends_with(kSuffix)) found = find(name.substr(0, name.size() - kSuffix.size()));
  if (found == kMetals.end()) failName(property, name, kMetals);
  return {glm::max(found->ior, kMinIor), found->extinction};
}

double iorOf(const Object& object, const char* property, const char* absent) {
  const Property* const stated = object.find(property);
  const bool isNumber = stated && !std::holds_alternative<std::string>(stated->value);
  if (isNumber) {
    const double ior = object.number(property, 1);
    if (!(ior > 0 && ior < 1e6)) throw PlacedError{stated->place, "an index of refraction is positive, and below 1e6"};
    return ior;
  }
  const std::string name = lowerCase(object.text(property, absent));
  const auto found = std::ranges::find(kDielectrics, name, &Dielectric::name);
  if (found == kDielectrics.end()) failName(*stated, name, kDielectrics);
  return found->ior;
}

}  // namespace candela::mitsuba
