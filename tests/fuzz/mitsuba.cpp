// The reader of Mitsuba's XML, as written and lenient. It finds no other files.
#include "host/formats/mitsuba/mitsuba_loader.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  const std::string text = textOf(input);
  for (const bool lenient : {false, true}) {
    const scene::LoadOptions options{.lenient = lenient};
    expectErrors([&] {
      mitsuba::mitsubaLoader().open({text, "input", "/nonexistent"}, options, false)->at(options.time);
    });
  }
}
