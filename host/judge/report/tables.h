// The tables of a report, as HTML.
#pragma once
#include <string>

#include "host/judge/report/report.h"

namespace candela::report {

/// Returns the figures of the report and those of the images.
std::string figureTable(const Report& report);
/// Returns the properties of A and B; empty if there are none.
std::string factTable(const Report& report);
/// Returns the most significant tests; empty if there are none.
std::string testTable(const Report& report);
/// Returns one block per command.
std::string commandList(const Report& report);

}  // namespace candela::report
