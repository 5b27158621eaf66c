// Which lines each verbosity shows.
#include <catch2/catch.hpp>
#include <sstream>

#include "host/core/log.h"

namespace candela {
namespace {

std::string allLines(Verbosity verbosity) {
  std::ostringstream sink;
  const Log log(sink, verbosity);
  log.problem("p");
  log.warning("w");
  log.note("n");
  log.detail("d");
  return sink.str();
}

}  // namespace

TEST_CASE("quiet hides all but problems, verbose shows details too") {
  CHECK(allLines(Verbosity::quiet) == "candela: p\n");
  CHECK(allLines(Verbosity::normal) == "candela: p\ncandela: warning: w\ncandela: n\n");
  CHECK(allLines(Verbosity::verbose) == "candela: p\ncandela: warning: w\ncandela: n\ncandela: d\n");
}

}  // namespace candela
