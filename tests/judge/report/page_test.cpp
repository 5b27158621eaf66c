// The page as text: its content, that it is self-contained, and that no name breaks it.
#include <catch2/catch.hpp>
#include <regex>

#include "host/judge/report/base64.h"
#include "host/judge/report/report.h"

namespace candela::report {
namespace {

using Catch::Contains;

Report greyReport(float a, float b, std::uint32_t width = 16, std::uint32_t height = 16) {
  Report report;
  report.title = "a and b";
  report.nameA = "a.exr";
  report.nameB = "b.exr";
  for (const auto& [image, value] : {std::pair(&report.a, a), std::pair(&report.b, b)}) {
    image->width = width;
    image->height = height;
    image->rgb.assign(std::size_t{width} * height, glm::vec3(value));
  }
  report.comparison = compareImages(report.a, report.b);
  report.flip.width = width;
  report.flip.height = height;
  report.flip.error.assign(report.a.rgb.size(), 0.5f);
  return report;
}

TEST_CASE("equal reports give equal pages") {
  CHECK(toHtml(greyReport(0.5f, 0.25f)) == toHtml(greyReport(0.5f, 0.25f)));
  CHECK(toHtml(greyReport(0.5f, 0.25f)) != toHtml(greyReport(0.5f, 0.26f)));
}

TEST_CASE("the page contains every verdict in words") {
  Report report = greyReport(0.5f, 0.25f);
  report.verdict = "That is so.";
  CHECK_THAT(toHtml(report), Contains("No verdict.</strong> That is so."));
  report.outcome = Outcome::differ;
  CHECK_THAT(toHtml(report), Contains("class=\"verdict differ\""));
  report.outcome = Outcome::agree;
  CHECK_THAT(toHtml(report), Contains("class=\"verdict agree\""));
}

TEST_CASE("the page refers to nothing but its own data") {
  const std::string page = toHtml(greyReport(0.5f, 0.25f));
  const std::regex address("(src|href|action|data)\\s*=\\s*\"([^\"]{0,22})");
  for (std::sregex_iterator match(page.begin(), page.end(), address), end; match != end; ++match) {
    CHECK((*match)[2].str() == "data:image/png;base64,");
  }
  CHECK(page.find("http") == page.find("http-equiv"));
  CHECK(page.find("http", page.find("http-equiv") + 4) == std::string::npos);
  CHECK(page.find("url(") == std::string::npos);
  CHECK(page.find("@import") == std::string::npos);
}

TEST_CASE("no text of a report becomes HTML") {
  const std::string hostile = "</script><img src=x onerror=alert(1)>\"'&{{style}}";
  Report report = greyReport(0.5f, 0.25f);
  report.title = report.verdict = report.nameA = report.nameB = hostile;
  report.figures = {{hostile, hostile}};
  report.facts = {{hostile, hostile, hostile}};
  report.commands = {hostile};
  const std::string page = toHtml(report);
  CHECK(page.find("<img src=x") == std::string::npos);
  CHECK(page.find("onerror=alert(1)>\"") == std::string::npos);
  CHECK_THAT(page, Contains("&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&quot;&#39;&amp;{{style}}"));
}

TEST_CASE("the page has a map for each size of tiles and a table of the most significant tests") {
  Report report = greyReport(0.5f, 0.25f, 32, 32);
  CHECK(toHtml(report).find("map-t8") == std::string::npos);
  verify::RegionTests tests;
  tests.level = 1e-6;
  for (const verify::Region& region : verify::regionsOf({32, 32})) {
    if (region.quantity != verify::Region::Quantity::luminance) continue;
    tests.regions.push_back(verify::compareRegion(region, {0.5, 1e-6, 100}, {0.25, 1e-6, 100}, tests.level));
  }
  report.tests = tests;
  const std::string page = toHtml(report);
  CHECK_THAT(page, Contains("id=\"map-t8\"") && Contains("id=\"map-t16\"") && Contains("21 of 21 regions differ"));
  CHECK_THAT(page, Contains("+100.000 %") && Contains("image mean (luminance)"));
}

TEST_CASE("the page contains the values of every pixel, or of blocks of large images, with a note") {
  const Report small = greyReport(0.5f, 0.25f);
  CHECK_THAT(toHtml(small), Contains("id=\"values-a\">" + floatText(small.a) + "<"));
  CHECK(toHtml(small).find("id=\"reduction\"") == std::string::npos);
  const std::string page = toHtml(greyReport(0.5f, 0.25f, 2048, 1024));
  CHECK_THAT(page,
             Contains("the mean of 2 × 2 of their pixels") && Contains("data-width=\"1024\" data-height=\"512\""));
}

}  // namespace
}  // namespace candela::report
