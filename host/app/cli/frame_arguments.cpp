// Times, angles, seeds and files of the frames of a sequence.
#include "host/app/cli/frame_arguments.h"

#include <algorithm>
#include <cmath>

namespace candela::cli {

job::FrameRange framesOf(const SequenceArguments& arguments) {
  return arguments.frames.value_or(job::FrameRange{0, arguments.turntable.value_or(0)});
}

bool hasTimes(const RenderArguments& arguments) { return !arguments.turntable || arguments.given.contains("--fps"); }

bool resumesPictures(const RenderArguments& sequence) {
  return sequence.isSequence() && !sequence.film.resume.empty() &&
         std::ranges::find(sequence.outputs, sequence.film.resume) != sequence.outputs.end();
}

RenderArguments argumentsOfFrame(const RenderArguments& sequence, std::uint32_t frame) {
  RenderArguments one = sequence;
  static_cast<SequenceArguments&>(one) = {};
  if (hasTimes(sequence)) one.loadOptions.time = frame / sequence.framesPerSecond;
  if (const auto& turn = sequence.turntable) {
    one.loadOptions.orbit = std::fmod(sequence.loadOptions.orbit + 360.0 * (frame % *turn) / *turn, 360);
  }
  if (sequence.seedIsFrame) one.request.image.seed = frame;
  for (std::filesystem::path& output : one.outputs) output = job::frameFile(output, frame);
  one.film.checkpoint = job::frameFile(sequence.film.checkpoint, frame);
  one.film.resume = job::frameFile(sequence.film.resume, frame);
  one.json = job::frameFile(sequence.json, frame).string();
  std::error_code ignored;
  if (resumesPictures(sequence) || !std::filesystem::exists(one.film.resume, ignored)) one.film.resume.clear();
  return one;
}

}  // namespace candela::cli
