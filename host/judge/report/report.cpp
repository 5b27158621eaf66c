// Assembles the page.
#include "host/judge/report/report.h"

#include <fmt/format.h>

#include "embedded/page.h"
#include "embedded/script.h"
#include "embedded/style.h"
#include "host/base/version.h"
#include "host/judge/report/base64.h"
#include "host/judge/report/chart.h"
#include "host/judge/report/html.h"
#include "host/judge/report/maps.h"
#include "host/judge/report/reduce.h"
#include "host/judge/report/tables.h"

namespace candela::report {
namespace {

constexpr std::uint32_t kSmallWidth = 400;  // maximum width of pictures whose pixels are shown as squares when enlarged

struct OutcomeText {
  const char* styleName;
  const char* word;
};

OutcomeText textOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::agree:
      return {"agree", "✓ They agree."};
    case Outcome::differ:
      return {"differ", "✗ They differ."};
    case Outcome::undecided:
      return {"undecided", "? It is not decided."};
    case Outcome::none:
      break;
  }
  return {"none", "No verdict."};
}

std::string pictureTag(const std::string& id, const std::string& alt, const image::Pixels8& pixels) {
  const char* style = pixels.width <= kSmallWidth ? " class=\"small\"" : "";
  return fmt::format("<img id=\"{}\"{} width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">", id, style, pixels.width,
                     pixels.height, escapeHtml(alt), pngUri(pixels));
}

std::string mapFigure(const Map& map) {
  return fmt::format(
      "<figure class=\"map\"><div class=\"stage\">{}</div><figcaption><strong>{}.</strong> {}</figcaption></figure>\n",
      pictureTag(map.id, "Map: " + map.title, map.pixels), escapeHtml(map.title), escapeHtml(map.caption));
}

std::string mapFigures(const Report& report, std::uint32_t k) {
  std::string figures;
  for (const Map& map : mapsOf(report, k)) figures += mapFigure(map);
  return figures;
}

std::string reductionNote(std::uint32_t k) {
  if (k == 1) return "";
  return fmt::format(
      "<p class=\"note\" id=\"reduction\">The images are too large for a page: each pixel shown here is the mean "
      "of {0} × {0} of their pixels. The verdict, the figures and the tests are those of the full images.</p>",
      k);
}

std::string histograms(const image::Image& a, const image::Image& b) {
  return "<figure>" + valueChart(valueHistograms(a, b)) +
         "<figcaption><strong>Luminances</strong>, two bins per stop. Bars: A; line: B. Black pixels are left "
         "out.</figcaption>"
         "</figure>\n<figure>" +
         differenceChart(differenceHistogram(a, b)) +
         "<figcaption><strong>Relative differences</strong> of the pixels, (A − B) / B. Values outside the range are "
         "in the "
         "outermost "
         "bars.</figcaption></figure>\n";
}

}  // namespace

Outcome outcomeOf(verify::Conclusion conclusion) {
  switch (conclusion) {
    case verify::Conclusion::same:
      return Outcome::agree;
    case verify::Conclusion::different:
      return Outcome::differ;
    case verify::Conclusion::undecided:
      break;
  }
  return Outcome::undecided;
}

std::string toHtml(const Report& report) {
  const std::uint32_t k = reductionOf(report.a.width, report.a.height);
  const image::Pixels8 a = sidePicture(report.a, report.display, k);
  const image::Pixels8 b = sidePicture(report.b, report.display, k);
  const OutcomeText outcome = textOf(report.outcome);
  return fillTemplate(embedded::page, {{"style", std::string(embedded::style)},
                                       {"script", std::string(embedded::script)},
                                       {"title", escapeHtml(report.title)},
                                       {"outcome", outcome.styleName},
                                       {"outcomeWord", outcome.word},
                                       {"verdict", escapeHtml(report.verdict)},
                                       {"nameA", escapeHtml(report.nameA)},
                                       {"nameB", escapeHtml(report.nameB)},
                                       {"width", fmt::to_string(a.width)},
                                       {"height", fmt::to_string(a.height)},
                                       {"pictureA", pictureTag("picture-a", "Picture A: " + report.nameA, a)},
                                       {"pictureB", pictureTag("picture-b", "Picture B: " + report.nameB, b)},
                                       {"reductionNote", reductionNote(k)},
                                       {"maps", mapFigures(report, k)},
                                       {"histograms", histograms(report.a, report.b)},
                                       {"figures", figureTable(report)},
                                       {"facts", factTable(report)},
                                       {"tests", testTable(report)},
                                       {"commands", commandList(report)},
                                       {"version", versionText()},
                                       {"valuesA", floatText(k == 1 ? report.a : reduced(report.a, k))},
                                       {"valuesB", floatText(k == 1 ? report.b : reduced(report.b, k))}});
}

}  // namespace candela::report
