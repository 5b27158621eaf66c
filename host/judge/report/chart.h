// Histograms as SVG drawings within a page, without scripts.
#pragma once
#include <string>

#include "host/judge/report/histogram.h"

namespace candela::report {

/// Draws the luminances of both images on a logarithmic axis: bars for A, a line for B.
std::string valueChart(const ValueHistograms& histograms);
/// Draws the relative differences of the pixels: one bar per bin.
std::string differenceChart(const Histogram& histogram);

}  // namespace candela::report
