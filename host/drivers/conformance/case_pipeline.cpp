// Creates the pipelines of cases.
#include "host/drivers/conformance/case_pipeline.h"

#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {

vulkan::ComputePipeline create(const CasePipeline& pipeline, vulkan::Device& device) {
  return {device, pipeline.spirv, pipeline.options};
}

CasePipeline pipelineOf(const ShaderRun& run) {
  return {run.spirv,
          {.bindings = {2, vulkan::BindingKind::storageBuffer},
           .pushConstantBytes = 2 * sizeof(std::uint32_t),
           .specialisations = run.specialisations}};
}

Case caseOf(std::string name, std::string group, CasePipeline pipeline, std::function<Finding(Workbench&)> run) {
  return {std::move(name), std::move(group), std::move(run), [pipeline = std::move(pipeline)](Workbench& workbench) {
            create(pipeline, workbench.device());
            return passed();
          }};
}

}  // namespace candela::conformance
