// `candela doctor`: examines the machine.
#include <iostream>

#include "host/cli/commands.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/requirements.h"
#include "host/cli/text_output.h"
#include "host/doctor/diagnosis.h"

namespace candela::cli {

ExitCode run(const DoctorArguments& arguments, const Log& log) {
  requireVulkanDevice(arguments, "the reference tracer needs no driver, so there is nothing to examine");
  requireWritableReport(arguments.json);
  log.note("examining this machine; a software device may take a minute to compile its kernels");
  const doctor::Diagnosis diagnosis = doctor::diagnose(arguments.device);
  if (wantsText(arguments, {arguments.json})) std::cout << doctor::toText(diagnosis) << std::flush;
  writeJson(arguments.json, doctor::toJson(diagnosis));
  return diagnosis.code();
}

}  // namespace candela::cli
