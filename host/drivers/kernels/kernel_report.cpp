// The report of kernels as text, Markdown and JSON.
#include "host/drivers/kernels/kernel_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/report_head.h"
#include "host/measure/bench/text_table.h"

namespace candela::kernels {
namespace {

bool isReported(const KernelReport& report, const FigureInfo& figure) {
  return std::ranges::any_of(report.rows,
                             [&](const KernelRow& row) { return (row.figures.*figure.member).has_value(); });
}

bench::TextTable tableOf(const KernelReport& report) {
  bench::TextTable table{{"kernel"}, {}};
  for (const FigureInfo& figure : kFigures) {
    if (isReported(report, figure)) table.header.emplace_back(figure.title);
  }
  for (const KernelRow& row : report.rows) {
    std::vector<std::string> cells{row.scene + ", " + row.kernel};
    for (const FigureInfo& figure : kFigures) {
      if (isReported(report, figure)) cells.push_back(figureText(figure, row.figures.*figure.member));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string headline(const KernelReport& report) {
  const std::string device = fmt::format("{}, driver {}", report.device.name, report.device.driver);
  if (report.hasStatistics()) return device;
  return device + "\nThis driver reports no statistics (VK_KHR_pipeline_executable_properties).";
}

std::string settingsText(const KernelRow& row) {
  std::string text = fmt::format("workgroup {}, structure {}", row.workgroup, row.structure);
  if (!row.layout.empty()) text += ", layout " + row.layout;
  return text + ", loads " + row.sceneLoads;
}

std::string textOf(const vulkan::Executable& executable) {
  std::string text = fmt::format("  {}, subgroups of {}:\n", executable.name, executable.subgroupSize);
  for (const auto& [name, value] : executable.statistics)
    std::visit([&](auto number) { text += fmt::format("    {:<32} {}\n", name, number); }, value);
  return text;
}

nlohmann::ordered_json toJson(const vulkan::Executable& executable) {
  nlohmann::ordered_json statistics = nlohmann::ordered_json::array();
  for (const auto& [name, value] : executable.statistics)
    std::visit([&](auto number) { statistics.push_back({{"name", name}, {"value", number}}); }, value);
  return {{"name", executable.name}, {"subgroupSize", executable.subgroupSize}, {"statistics", std::move(statistics)}};
}

nlohmann::ordered_json toJson(const KernelRow& row) {
  nlohmann::ordered_json line{{"scene", row.scene},          {"sceneHash", row.sceneHash}, {"kernel", row.kernel},
                              {"workgroup", row.workgroup},  {"structure", row.structure}, {"layout", row.layout},
                              {"sceneLoads", row.sceneLoads}};
  for (const FigureInfo& figure : kFigures) {
    const std::optional<double>& value = row.figures.*figure.member;
    line[figure.key] = value ? nlohmann::ordered_json(*value) : nullptr;
  }
  line["executables"] = nlohmann::ordered_json::array();
  for (const vulkan::Executable& executable : row.executables) line["executables"].push_back(toJson(executable));
  return line;
}

}  // namespace

bool KernelReport::hasStatistics() const {
  return std::ranges::any_of(rows, [](const KernelRow& row) { return !row.executables.empty(); });
}

std::string figureText(const FigureInfo& figure, const std::optional<double>& value) {
  if (!value) return "";
  if (figure.member == &Figures::occupancy) return fmt::format("{:.1f} %", 100 * *value);
  if (figure.member == &Figures::compileSeconds) return fmt::format("{:.1f}", 1000 * *value);
  return fmt::format("{}", *value);
}

std::string toText(const KernelReport& report) {
  std::string text = headline(report) + "\n\n" + toText(tableOf(report));
  text += "\n";
  for (const KernelRow& row : report.rows) {
    text += fmt::format("{}, {}: {}\n", row.scene, row.kernel, settingsText(row));
    for (const vulkan::Executable& executable : row.executables) text += textOf(executable);
  }
  return text;
}

std::string toMarkdown(const KernelReport& report) { return headline(report) + "\n\n" + toMarkdown(tableOf(report)); }

nlohmann::ordered_json toJson(const KernelReport& report) {
  nlohmann::ordered_json json = reportHead(kKernelsSchema);
  json["device"] = report.device.name;
  json["driver"] = report.device.driver;
  json["driverName"] = report.device.driverName;
  json["hasStatistics"] = report.hasStatistics();
  json["rows"] = nlohmann::ordered_json::array();
  for (const KernelRow& row : report.rows) json["rows"].push_back(toJson(row));
  return json;
}

}  // namespace candela::kernels
