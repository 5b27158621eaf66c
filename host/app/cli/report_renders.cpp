// The page on two sets of renders: their means, and the tests of regions.
#include <fmt/format.h>

#include "host/app/cli/display_choice.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/report_page.h"
#include "host/base/counted.h"

namespace candela::cli {
namespace {

std::string filesText(const std::vector<std::string>& files) {
  if (files.size() == 1) return files.front();
  return fmt::format("{} to {}", files.front(), files.back());
}

std::string nameOf(const std::vector<std::string>& files) {
  return files.size() == 1 ? files.front() : fmt::format("Mean of {} renders, {}", files.size(), filesText(files));
}

std::string compareCommand(const CompareArguments& arguments) {
  std::string command = "candela compare";
  for (const std::string& file : arguments.files) command += " " + shellQuoted(file);
  for (const OptionGroup group : {OptionGroup::comparison, OptionGroup::output}) {
    const std::string options = commandLineOf(arguments, group, true);
    if (!options.empty()) command += " " + options;
  }
  return command;
}

std::vector<report::Figure> figuresOf(const verify::SetTestResult& result) {
  std::vector<report::Figure> figures{
      {"Design", verify::kSetDesignNames[static_cast<std::size_t>(result.options.design)]},
      {"p-value of all tests together", fmt::format("{:.2g}, level {:g}", result.pValue, result.options.alpha)}};
  if (result.options.design == verify::SetDesign::picture) return figures;
  figures.push_back({"Smallest p-value of so many renders", fmt::format("{:.2g}", result.minPValue)});
  figures.push_back({"Divisions of the renders",
                     fmt::format("{}{}", result.divisions, result.isExhaustive ? ", which are all" : ", at random")});
  return figures;
}

}  // namespace

report::Report renderSetReport(const CompareArguments& arguments, const verify::RenderSet& a,
                               const verify::RenderSet& b, const verify::SetTestResult& result) {
  report::Report page;
  page.title = fmt::format("{} and {}", filesText(arguments.files), filesText(arguments.others));
  page.outcome = report::outcomeOf(result.conclusion());
  page.verdict = result.verdict();
  page.nameA = nameOf(arguments.files);
  page.nameB = nameOf(arguments.others);
  page.a = a.mean();
  page.b = b.mean();
  page.display = chooseDisplay(arguments, render::Integrator::path, page.b);
  page.comparison = compareImages(page.a, page.b);
  page.flip = computeFlip(displayed(page.a, page.display), displayed(page.b, page.display));
  page.tests = result;
  page.figures = figuresOf(result);
  page.facts = {{"Renders", fmt::to_string(a.count()), fmt::to_string(b.count())},
                {"Files", filesText(arguments.files), filesText(arguments.others)}};
  page.commands = {compareCommand(arguments)};
  return page;
}

}  // namespace candela::cli
