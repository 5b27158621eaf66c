// Reports on the results of the kit: one or many devices, as text, Markdown and a chart.
#pragma once
#include <string>
#include <vector>

#include "host/measure/kit/kit_results.h"

namespace candela::kit {

/// Returns one table of devices x scenes, as aligned text, with lines for failures.
std::string toText(const std::vector<KitResults>& results);

/// Returns a page with the failures and the speed of each device. Its tables of failures and of speeds have the columns
/// of docs/drivers.md and docs/performance.md. One device gets all of its figures; several are compared.
std::string toMarkdown(const std::vector<KitResults>& results);

/// Returns a bar chart of samples per second: a group of bars for each scene, and a bar for each device.
std::string toSvg(const std::vector<KitResults>& results);

}  // namespace candela::kit
