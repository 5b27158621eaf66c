// Notes about options that have no effect on a render.
#pragma once
#include "host/app/cli/command_arguments.h"
#include "host/base/log.h"
#include "host/trace/render/settings.h"

namespace candela::cli {

/// The facts that decide whether the work of a command reads an option.
struct OptionUse {
  const SceneArguments& arguments;
  const render::RenderSettings& settings;
  bool onDevice = true;        ///< a Vulkan device renders
  bool onReference = true;     ///< the reference tracer renders, or may have to
  bool showsImages = true;     ///< as colours of 8 bits
  bool choosesLayers = false;  ///< layers may be chosen later
};

/// Logs a note for each option that is given although this work does not read it. Such options cause a note rather
/// than an error, so that one command line can be used for all renders.
void noteIdleOptions(const OptionUse& use, const Log& log);
/// Logs a note if --background none makes alpha that no output file can store.
void noteLostAlpha(const RenderArguments& arguments, const Log& log);

}  // namespace candela::cli
