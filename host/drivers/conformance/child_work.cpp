// Runs cases and turns exceptions and messages of the validation layer into results.
#include "host/drivers/conformance/child_work.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/drivers/conformance/workbench.h"
#include "host/trace/vulkan/validation.h"

namespace candela::conformance {
namespace {

Status statusOf(Outcome outcome) {
  if (outcome == Outcome::skip) return Status::skip;
  return outcome == Outcome::pass ? Status::pass : Status::fail;
}

ChildNote ask(const Case& question, Workbench& workbench) {
  try {
    Finding finding = question.run(workbench);
    return {statusOf(finding.outcome), std::move(finding.text)};
  } catch (const DeviceLostError& error) {
    return {Status::crash, error.what()};
  } catch (const std::exception& error) {
    return {Status::fail, error.what()};
  }
}

void addValidation(ChildNote& note) {
  for (const std::string& message : vulkan::validationMessages()) {
    note.status = Status::fail;
    note.text += (note.text.empty() ? "" : "\n") + fmt::format("validation layer: {}", message);
  }
  vulkan::clearValidationMessages();
}

}  // namespace

nlohmann::json toJson(const ChildNote& note) {
  nlohmann::json json{{"text", note.text}, {"seconds", note.seconds}};
  if (note.status) json["status"] = *note.status;
  return json;
}

ChildNote noteFrom(const nlohmann::json& json) {
  ChildNote note{{}, json.at("text").get<std::string>(), json.at("seconds").get<double>()};
  if (json.contains("status")) note.status = json.at("status").get<Status>();
  return note;
}

void runInThisProcess(const std::vector<const Case*>& cases, const vulkan::DeviceInfo& device,
                      const process::ChildProcess::Send& send) {
  Workbench workbench(device);
  for (const Case* const question : cases) {
    send(toJson({}));
    Stopwatch watch;
    ChildNote note = ask(*question, workbench);
    note.seconds = watch.lap();
    addValidation(note);
    send(toJson(note));
    if (note.status == Status::crash) return;
  }
}

}  // namespace candela::conformance
