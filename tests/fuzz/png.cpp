// The reader of PNG files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodePng(std::as_bytes(input)); });
}
