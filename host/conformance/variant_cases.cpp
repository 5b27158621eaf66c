// The table of variants of kernels.
#include <fmt/format.h>

#include "host/conformance/case_tables.h"
#include "host/conformance/variant_run.h"

namespace candela::conformance {

Cases variantCases() {
  Cases cases;
  for (const variants::Variant& variant : variants::allVariants()) {
    for (const char* const scene : {"cornell", "primitives", "depth_of_field"}) {
      Picture picture{scene, {}, 0};
      picture.settings.image.size = {24, 24};
      picture.settings.image.sampleCount = 8;
      picture.settings.execution.kernel = render::KernelKind::megakernel;
      picture.settings.structure.bvhLayout = render::BvhLayout::cwbvh;
      cases.push_back({fmt::format("variants.path.{}.{}", variant.name, scene), "variants.path." + std::string(scene),
                       [=](Workbench& bench) { return compareVariant(picture, variant, bench); }});
    }
  }
  return cases;
}

}  // namespace candela::conformance
