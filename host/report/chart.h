// Histograms as drawings within a page (SVG), which need no script.
#pragma once
#include <string>

#include "host/report/histogram.h"

namespace candela::report {

/// Both images' luminances, on a logarithmic axis: bars for A, a line for B.
std::string valueChart(const ValueHistograms& histograms);
/// The pixels' relative differences: one bar a bin.
std::string differenceChart(const Histogram& histogram);

}  // namespace candela::report
