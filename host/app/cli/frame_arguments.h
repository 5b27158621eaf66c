// The arguments of the frames of a sequence.
#pragma once
#include "host/app/cli/command_arguments.h"

namespace candela::cli {

/// Returns the frames of a sequence.
job::FrameRange framesOf(const SequenceArguments& arguments);

/// Returns whether each frame of a sequence has its own time: all sequences but a turntable without --fps.
bool hasTimes(const RenderArguments& arguments);

/// Returns the arguments of a render of one frame of a sequence, which gives the same files: the time is the number of
/// the frame divided by the frames per second, in double precision. Films and pictures that --resume names and that do
/// not exist yet are left out.
RenderArguments argumentsOfFrame(const RenderArguments& sequence, std::uint32_t frame);

/// Returns whether --resume names pictures of the sequence rather than films.
bool resumesPictures(const RenderArguments& sequence);

}  // namespace candela::cli
