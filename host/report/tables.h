// The tables of a report, as HTML.
#pragma once
#include <string>

#include "host/report/report.h"

namespace candela::report {

/// The figures of the report and those of the images.
std::string figureTable(const Report& report);
/// What is known of A and of B; empty without facts.
std::string factTable(const Report& report);
/// The tests by significance, as many as can be read; empty without tests.
std::string testTable(const Report& report);
/// One block a command.
std::string commandList(const Report& report);

}  // namespace candela::report
