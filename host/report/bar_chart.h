// Horizontal bars with labels, as a self-contained SVG file.
#pragma once
#include <string>
#include <vector>

namespace candela::report {

struct Bar {
  std::string label;
  double value = 0;  ///< >= 0
  double low = 0;    ///< of a whisker that shows the spread
  double high = 0;
};

struct BarGroup {
  std::string title;
  std::vector<Bar> bars;
};

/// `unit`: what values are in. Groups share one scale.
std::string barChart(const std::string& title, const std::string& unit, const std::vector<BarGroup>& groups);

}  // namespace candela::report
