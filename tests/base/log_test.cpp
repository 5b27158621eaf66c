// The lines that each verbosity shows.
#include "host/base/log.h"

#include <catch2/catch.hpp>
#include <sstream>

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

TEST_CASE("a quiet log shows only problems, and a verbose one also details") {
  CHECK(allLines(Verbosity::quiet) == "candela: p\n");
  CHECK(allLines(Verbosity::normal) == "candela: p\ncandela: warning: w\ncandela: n\n");
  CHECK(allLines(Verbosity::verbose) == "candela: p\ncandela: warning: w\ncandela: n\ncandela: d\n");
}

TEST_CASE("each line of a message begins with the name of the program") {
  std::ostringstream sink;
  Log(sink, Verbosity::quiet).problem("first\nsecond");
  CHECK(sink.str() == "candela: first\ncandela: second\n");
}

}  // namespace candela
