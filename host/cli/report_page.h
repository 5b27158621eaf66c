// `--report`: what the pages of compare and verify say.
#pragma once
#include <filesystem>

#include "host/cli/image_verdict.h"
#include "host/cli/render_job.h"
#include "host/image/flip.h"
#include "host/report/report.h"
#include "host/verify/agreement.h"
#include "host/verify/verify.h"

namespace candela::cli {

/// Two image files, with what their metadata tells of them.
report::Report imageReport(const Arguments& arguments, const image::Image& a, const image::Image& reference,
                           const image::ImageComparison& comparison, const image::FlipResult& flip,
                           const ImageVerdict& verdict);
/// Device and reference on one scene. `arguments` are those of the command line; the run was not interrupted.
report::Report agreementReport(const Arguments& arguments, const RenderJob& job,
                               const verify::AgreementReport& agreement);
/// The same for `verify`, whose films were kept.
report::Report verificationReport(const Arguments& arguments, const RenderJob& job,
                                  const verify::VerifyReport& verification);

/// Writes the page, as a whole or not at all. Throws FileError.
void writeReport(const std::filesystem::path& file, const report::Report& report);

}  // namespace candela::cli
