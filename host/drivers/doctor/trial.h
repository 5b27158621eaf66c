// Renders a small picture on a device and checks it against the reference tracer.
#pragma once
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "host/drivers/doctor/check.h"
#include "host/trace/render/renderer.h"

namespace candela::doctor {

/// Time after which the device counts as hung. Software Vulkan on a busy machine may take two minutes to
/// compile.
inline constexpr std::chrono::minutes kTrialLimit{5};

/// `works`: the picture is right. `undecided`: rounding or noise may hide an error. `wrong`: it is not right. `fails`:
/// there is no picture.
enum class TrialOutcome { works, undecided, wrong, fails };

struct Trial {
  TrialOutcome outcome = TrialOutcome::fails;
  Check check;
  nlohmann::json agreement;  ///< report of `candela compare SCENE`; null if there is no picture
};

/// Compares the Cornell box, 48x48 pixels, 16 samples, as `candela compare SCENE` does by default.
nlohmann::json compareWithReference(render::Renderer& device);
/// Renders on the device for `selector` (see vulkan::selectDevice) in a child process.
Trial tryRender(const std::string& selector);
/// Interprets the report of compareWithReference().
Trial interpretTrial(const nlohmann::json& comparison);

}  // namespace candela::doctor
