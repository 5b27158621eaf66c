// The reader of TGA files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodeTga(std::as_bytes(input)); });
}
