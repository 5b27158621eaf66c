// The reader of HDR files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodeHdr(std::as_bytes(input)); });
}
