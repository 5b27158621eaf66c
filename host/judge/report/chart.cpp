// Draws histograms as SVG.
#include "host/judge/report/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace candela::report {
namespace {

// Size of the drawing in its own units.
constexpr double kChartWidth = 480;
constexpr double kHeight = 150;
constexpr double kBase = kHeight - 20;  // above the labels of the axis

std::uint64_t highest(const Histogram& histogram) {
  return std::max<std::uint64_t>(1, *std::max_element(histogram.counts.begin(), histogram.counts.end()));
}

double heightOf(std::uint64_t count, std::uint64_t maxCount) {
  return (kBase - 4) * static_cast<double>(count) / static_cast<double>(maxCount);
}

std::string bars(const Histogram& histogram, std::uint64_t maxCount) {
  const double step = kChartWidth / static_cast<double>(histogram.counts.size());
  std::string out;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double height = heightOf(histogram.counts[i], maxCount);
    if (height == 0) continue;
    out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                       static_cast<double>(i) * step, kBase - height, step, height);
  }
  return "<g class=\"bars\">" + out + "</g>";
}

std::string line(const Histogram& histogram, std::uint64_t maxCount) {
  const double step = kChartWidth / static_cast<double>(histogram.counts.size());
  std::string path = fmt::format("M0 {:.1f}", kBase);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    path += fmt::format("V{:.1f}H{:.1f}", kBase - heightOf(histogram.counts[i], maxCount),
                        static_cast<double>(i + 1) * step);
  }
  return fmt::format("<path class=\"line\" d=\"{}V{:.1f}\"/>", path, kBase);
}

std::string axis(const std::string& left, const std::string& middle, const std::string& right) {
  const auto label = [](double x, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", x, kHeight - 5, anchor, text);
  };
  return fmt::format("<path class=\"axis\" d=\"M0 {0}H{1}\"/>", kBase, kChartWidth) + label(0, "start", left) +
         label(kChartWidth / 2, "middle", middle) + label(kChartWidth, "end", right);
}

std::string drawing(const std::string& description, const std::string& content) {
  return fmt::format("<svg role=\"img\" viewBox=\"0 0 {} {}\" aria-label=\"{}\">{}</svg>", kChartWidth, kHeight,
                     description, content);
}

std::string power(double stops) { return fmt::format("{:.3g}", std::exp2(stops)); }

}  // namespace

std::string valueChart(const ValueHistograms& histograms) {
  const auto& [a, b] = histograms;
  const std::uint64_t maxCount = std::max(highest(a), highest(b));
  const std::string description = fmt::format("Histogram of the luminances of A and B, from {} to {}, logarithmic",
                                              power(a.low), power(a.high));
  return drawing(description, bars(a, maxCount) + line(b, maxCount) +
                                  axis(power(a.low), power((a.low + a.high) / 2), power(a.high)));
}

std::string differenceChart(const Histogram& histogram) {
  const std::string range = fmt::format("{:g} %", 100 * histogram.high);
  const std::string description = fmt::format("Histogram of the relative differences of the pixels, from -{0} to +{0}",
                                              range);
  return drawing(description, bars(histogram, highest(histogram)) + axis("−" + range, "0", "+" + range));
}

}  // namespace candela::report
