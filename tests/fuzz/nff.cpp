// The reader of NFF and P3F, as written and lenient.
#include "host/formats/nff/nff_loader.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  const std::string text = textOf(input);
  for (const bool lenient : {false, true}) {
    expectErrors([&] { scene::parseScene(text, "input", "/nonexistent", {.lenient = lenient}); });
  }
}
