// The readers of OBJ and MTL, as written and lenient. They find no other files.
#include "host/formats/obj/mtl_file.h"
#include "host/formats/obj/mtl_mapping.h"
#include "host/formats/obj/obj_loader.h"
#include "tests/fuzz/fuzz.h"

namespace {

using namespace candela;

void readMtl(const std::string& text, bool lenient) {
  scene::DiagnosticLog log("input");
  for (const obj::MtlMaterial& material : obj::parseMtl(text, lenient, log).materials) fromMtl(material, {}, false);
  log.throwIfErrors();
}

}  // namespace

void candela::fuzz::run(Input input) {
  const std::string text = textOf(input);
  for (const bool lenient : {false, true}) {
    const scene::LoadOptions options{.lenient = lenient};
    expectErrors([&] { obj::objLoader().open({text, "input", "/nonexistent"}, options, false)->at(options.time); });
    expectErrors([&] { readMtl(text, lenient); });
  }
}
