// Tables as aligned text and as Markdown.
#include "host/measure/bench/text_table.h"

#include <catch2/catch.hpp>

namespace candela::bench {
namespace {

const TextTable kTable{{"scene", "s"}, {{"a", "12.5"}, {"long name", "3"}}};

TEST_CASE("text columns are aligned, names to the left and figures to the right") {
  CHECK(toText(kTable) ==
        "scene         s\n"
        "a          12.5\n"
        "long name     3\n");
}

TEST_CASE("Markdown tables escape the cell separator") {
  CHECK(toMarkdown({{"a|b", "c"}, {{"1", "2"}}}) ==
        "| a\\|b | c |\n"
        "|---|---:|\n"
        "| 1 | 2 |\n");
}

}  // namespace
}  // namespace candela::bench
