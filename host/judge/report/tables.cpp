// Formats the tables of a report as HTML.
#include "host/judge/report/tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/judge/report/html.h"

namespace candela::report {
namespace {

using verify::RegionResult;

constexpr std::size_t kTestsShown = 12;

std::string row(const std::string& name, const std::string& cells) {
  return fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>\n", escapeHtml(name), cells);
}

std::string cell(const std::string& text) { return "<td>" + escapeHtml(text) + "</td>"; }

std::string number(double value) { return fmt::format("<td class=\"number\">{:.6g}</td>", value); }

std::vector<Figure> imageFigures(const Report& report) {
  const image::ImageComparison& c = report.comparison;
  std::vector<Figure> figures{
      {"Size", fmt::format("{} × {} pixels", c.width, c.height)},
      {"Mean luminance", fmt::format("A {:.6g}, B {:.6g}: {:+.4g} %", c.meanLuminance, c.referenceMeanLuminance,
                                     100 * c.relativeMeanDifference)},
      {"relMSE", fmt::format("{:.6g}", c.relativeMeanSquaredError)},
      {"PSNR", fmt::format("{:.2f} dB", c.peakSignalToNoise)},
      {"FLIP", fmt::format("mean {:.4g}, maximum {:.4g}", report.flip.mean, report.flip.maximum)},
      {"Largest difference", fmt::format("{:.6g} at {}, {}", c.maximumDifference, c.maximumX, c.maximumY)},
      {"Pixels that differ",
       fmt::format("{} ({:.4g} %), by more than {:g} relative and {:g} absolute", c.differingCount,
                   100 * c.differingFraction, c.tolerance.relative, c.tolerance.absolute)}};
  if (c.notFiniteCount > 0) figures.push_back({"Not finite", fmt::format("{} pixels, ignored", c.notFiniteCount)});
  return figures;
}

std::string testRow(const RegionResult& result) {
  const char* verdict = result.differs ? "<td class=\"differ\">differs</td>" : "<td>equal</td>";
  return row(verify::regionText(result.region),
             number(result.deviceMean) + number(result.referenceMean) +
                 fmt::format("<td class=\"number\">{:+.3f} %</td><td class=\"number\">{:.2f}</td>"
                             "<td class=\"number\">{:.1e}</td>",
                             100 * result.relativeDifference(), result.test.t, result.test.pValue) +
                 verdict);
}

std::string scrolling(const std::string& table) { return "<div class=\"scroll\">" + table + "</div>\n"; }

}  // namespace

std::string figureTable(const Report& report) {
  std::string rows;
  for (const Figure& figure : report.figures) rows += row(figure.name, cell(figure.value));
  for (const Figure& figure : imageFigures(report)) rows += row(figure.name, cell(figure.value));
  return scrolling("<table>\n" + rows + "</table>");
}

std::string factTable(const Report& report) {
  std::string rows;
  for (const Fact& fact : report.facts) rows += row(fact.name, cell(fact.a) + cell(fact.b));
  if (rows.empty()) return "";
  return "<section aria-labelledby=\"sides\">\n<h2 id=\"sides\">What was compared</h2>\n" +
         scrolling(
             "<table class=\"facts\">\n<thead><tr><td></td><th scope=\"col\">A</th><th "
             "scope=\"col\">B</th></tr></thead>\n" +
             rows + "</table>") +
         "</section>";
}

std::string testTable(const Report& report) {
  if (!report.tests) return "";
  std::vector<RegionResult> results = report.tests->regions;
  std::stable_sort(results.begin(), results.end(),
                   [](const RegionResult& x, const RegionResult& y) { return x.test.pValue < y.test.pValue; });
  std::string rows;
  for (std::size_t i = 0; i < std::min(results.size(), kTestsShown); ++i) rows += testRow(results[i]);
  const auto differing = std::count_if(results.begin(), results.end(), [](const RegionResult& r) { return r.differs; });
  const std::string condition = report.tests->isAdjusted ? ""
                                                         : fmt::format(" at p &lt; {:.1e} each", report.tests->level);
  return "<section aria-labelledby=\"tests\">\n<h2 id=\"tests\">Tests of regions</h2>\n" +
         fmt::format("<p>{} of {} regions differ{}. The most significant ones{}:</p>\n", differing, results.size(),
                     condition, report.tests->isAdjusted ? ", with p-values that count all regions" : "") +
         scrolling(
             "<table>\n<thead><tr><th scope=\"col\">Region</th><th scope=\"col\">A</th><th scope=\"col\">B</th>"
             "<th scope=\"col\">difference</th><th scope=\"col\">t</th><th scope=\"col\">p</th>"
             "<th scope=\"col\">verdict</th></tr></thead>\n" +
             rows + "</table>") +
         "</section>";
}

std::string commandList(const Report& report) {
  std::string list;
  for (const std::string& command : report.commands) list += "<pre><code>" + escapeHtml(command) + "</code></pre>\n";
  return list;
}

}  // namespace candela::report
