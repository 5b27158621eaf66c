// Names of modules.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/drivers/conformance/variant_question.h"
#include "spirv/control.h"
#include "spirv/film_sums.h"
#include "spirv/floats.h"
#include "spirv/functions.h"
#include "spirv/identities.h"
#include "spirv/integers.h"
#include "spirv/loads_probe.h"
#include "spirv/loop_probe.h"
#include "spirv/memory.h"
#include "spirv/path.h"
#include "spirv/queue.h"
#include "spirv/records.h"
#include "spirv/samplers.h"
#include "spirv/views.h"
#include "spirv/wave_extend.h"
#include "spirv/wave_gather.h"
#include "spirv/wave_renew.h"
#include "spirv/wave_shade.h"
#include "spirv/wave_shadow.h"
#include "spirv/whitted.h"

namespace candela::conformance {
namespace {

struct ModuleName {
  const std::span<const std::uint32_t>& spirv;
  const char* name;
};

#define CANDELA_MODULE(name) \
  ModuleName { spirv::name, #name }
const std::array kModules{
    CANDELA_MODULE(control),    CANDELA_MODULE(film_sums),  CANDELA_MODULE(floats),      CANDELA_MODULE(functions),
    CANDELA_MODULE(identities), CANDELA_MODULE(integers),   CANDELA_MODULE(loads_probe), CANDELA_MODULE(loop_probe),
    CANDELA_MODULE(memory),     CANDELA_MODULE(path),       CANDELA_MODULE(queue),       CANDELA_MODULE(records),
    CANDELA_MODULE(samplers),   CANDELA_MODULE(views),      CANDELA_MODULE(wave_extend), CANDELA_MODULE(wave_gather),
    CANDELA_MODULE(wave_renew), CANDELA_MODULE(wave_shade), CANDELA_MODULE(wave_shadow), CANDELA_MODULE(whitted)};
#undef CANDELA_MODULE

}  // namespace

std::string moduleName(std::span<const std::uint32_t> spirv) {
  const auto found = std::ranges::find_if(kModules,
                                          [&](const ModuleName& one) { return one.spirv.data() == spirv.data(); });
  return found != kModules.end() ? found->name : "another module";
}

}  // namespace candela::conformance
