// The reader of BMP files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodeBmp(std::as_bytes(input)); });
}
