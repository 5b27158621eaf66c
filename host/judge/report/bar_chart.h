// Horizontal bar charts with labels, as self-contained SVG files.
#pragma once
#include <string>
#include <vector>

namespace candela::report {

struct Bar {
  std::string label;
  double value = 0;  ///< >= 0
  double low = 0;    ///< lower end of a whisker that shows the spread
  double high = 0;
};

struct BarGroup {
  std::string title;
  std::vector<Bar> bars;
};

/// `unit` is the unit of the values. All groups have the same scale.
std::string barChart(const std::string& title, const std::string& unit, const std::vector<BarGroup>& groups);

}  // namespace candela::report
