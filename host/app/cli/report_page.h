// The content of the pages that `--report` writes for compare and verify.
#pragma once
#include <filesystem>

#include "host/app/cli/image_verdict.h"
#include "host/app/cli/render_job.h"
#include "host/image/flip.h"
#include "host/judge/report/report.h"
#include "host/judge/verify/agreement.h"
#include "host/judge/verify/render_set_test.h"
#include "host/judge/verify/verify.h"

namespace candela::cli {

/// Reports on two image files and their metadata.
report::Report imageReport(const CompareArguments& arguments, const image::Image& a, const image::Image& reference,
                           const image::ImageComparison& comparison, const image::FlipResult& flip,
                           const ImageVerdict& verdict);
/// Reports on the means of two sets of renders.
report::Report renderSetReport(const CompareArguments& arguments, const verify::RenderSet& a,
                               const verify::RenderSet& b, const verify::SetTestResult& result);
/// Reports on device and reference for one scene. `arguments` are those of the command line; the run was not
/// interrupted.
report::Report agreementReport(const CompareArguments& arguments, const RenderJob& job,
                               const verify::AgreementReport& agreement);
/// Reports on a run of `verify` that kept its films.
report::Report verificationReport(const VerifyArguments& arguments, const RenderJob& job,
                                  const verify::VerifyReport& verification);

/// Writes the page atomically. Throws FileError.
void writeReport(const std::filesystem::path& file, const report::Report& report);

}  // namespace candela::cli
