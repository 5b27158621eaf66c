// The reader of PLY, in ASCII and binary, as written and lenient.
#include "host/formats/ply/ply_loader.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  const std::string bytes = textOf(input);
  for (const bool lenient : {false, true}) {
    const scene::LoadOptions options{.lenient = lenient};
    expectErrors([&] { ply::plyLoader().open({bytes, "input", "/nonexistent"}, options, false)->at(options.time); });
  }
}
