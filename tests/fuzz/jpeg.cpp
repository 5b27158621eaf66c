// The reader of JPEG files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodeJpeg(std::as_bytes(input)); });
}
