// The reader of EXR files.
#include "host/image/codecs.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] { image::decodeExr(std::as_bytes(input), image::ImageParts::withLayers); });
}
