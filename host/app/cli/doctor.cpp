// `candela doctor`: examines the machine.
#include <iostream>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/drivers/doctor/diagnosis.h"

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
