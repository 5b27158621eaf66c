// Draws horizontal bar charts as SVG.
#include "host/judge/report/bar_chart.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/judge/report/html.h"

namespace candela::report {
namespace {

// Lengths in pixels.
constexpr double kBarsWidth = 860;
constexpr double kLabels = 330;
constexpr double kBars = 400;
constexpr double kRow = 22;
constexpr double kBar = 14;
constexpr double kMargin = 16;

double largestOf(const std::vector<BarGroup>& groups) {
  double largest = 0;
  for (const BarGroup& group : groups) {
    for (const Bar& bar : group.bars) largest = std::max({largest, bar.value, bar.high});
  }
  return largest > 0 ? largest : 1;
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, escapeHtml(text));
}

std::string drawBar(const Bar& bar, double top, double scale, const std::string& unit) {
  const double middle = top + kRow / 2;
  const double end = kLabels + bar.value * scale;
  std::string out = label(kLabels - 8, middle + 4, "end", bar.label);
  out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>\n", kLabels, middle - kBar / 2,
                     bar.value * scale, kBar);
  if (bar.high > bar.low) {
    out += fmt::format("<path d=\"M{:.1f} {}H{:.1f}\"/>\n", kLabels + bar.low * scale, middle,
                       kLabels + bar.high * scale);
  }
  return out + label(std::max(end, kLabels + bar.high * scale) + 6, middle + 4, "start",
                     fmt::format("{:.3g} {}", bar.value, unit));
}

}  // namespace

std::string barChart(const std::string& title, const std::string& unit, const std::vector<BarGroup>& groups) {
  const double scale = kBars / largestOf(groups);
  double top = kMargin + kRow;
  std::string body = fmt::format("<g font-weight=\"bold\">{}</g>\n", label(kMargin, kMargin + 4, "start", title));
  for (const BarGroup& group : groups) {
    body += fmt::format("<g font-weight=\"bold\">{}</g>\n", label(kMargin, top + kRow - 6, "start", group.title));
    top += kRow;
    for (const Bar& bar : group.bars) {
      body += drawBar(bar, top, scale, unit);
      top += kRow;
    }
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n<g fill=\"#2b6cb0\" stroke-width=\"2\">\n"
      "<style>text {{ fill: #222; stroke: none }} path {{ stroke: #222 }}</style>\n{2}</g>\n</svg>\n",
      kBarsWidth, top + kMargin, body);
}

}  // namespace candela::report
