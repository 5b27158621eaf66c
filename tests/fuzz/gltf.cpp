// The reader of glTF, as JSON and GLB. It finds no other files.
#include "host/formats/gltf/gltf_loader.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  const std::string bytes = textOf(input);
  scene::LoadOptions options;
  options.time = 0.5;
  expectErrors([&] { gltf::gltfLoader().open({bytes, "input", "/nonexistent"}, options, false)->at(options.time); });
}
