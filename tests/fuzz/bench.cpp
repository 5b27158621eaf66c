// The reader of benchmark reports: the input is used as both files.
#include "host/measure/bench/report_comparison.h"
#include "host/measure/bench/report_file.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] {
    const nlohmann::json report = bench::readReport(fileOf(input));
    const auto comparison = bench::compareReports(report, "old", report, "new", 0.05);
    bench::toText(comparison);
    bench::toMarkdown(comparison);
  });
}
