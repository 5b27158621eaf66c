// The titles of groups of options, and the meanings of exit codes.
#include "host/app/cli/help_sections.h"

#include <array>

namespace candela::cli {
namespace {

constexpr std::array kGroupTitles{
    GroupTitle{OptionGroup::output, "Output"},
    GroupTitle{OptionGroup::film, "Films: checkpoints and parts of a render"},
    GroupTitle{OptionGroup::image, "Image"},
    GroupTitle{OptionGroup::sceneFile, "Reading scenes"},
    GroupTitle{OptionGroup::sequence, "Sequences of frames"},
    GroupTitle{OptionGroup::execution,
               "Execution (only --device affects the image, by rounding; --accel affects the view `cost`)"},
    GroupTitle{OptionGroup::comparison, "Comparing images"},
    GroupTitle{OptionGroup::verification, "Verifying a device"},
    GroupTitle{OptionGroup::conformance, "Conformance of a driver"},
    GroupTitle{OptionGroup::capture, "Reproducers of faults"},
    GroupTitle{OptionGroup::explanation, "Explaining a sample"},
    GroupTitle{OptionGroup::benchmark, "Benchmarks"},
    GroupTitle{OptionGroup::kernels, "Reports of kernels"},
    GroupTitle{OptionGroup::tuning, "Tuning"},
    GroupTitle{OptionGroup::generation, "Writing scenes"},
    GroupTitle{OptionGroup::viewing, "The window of view"},
    GroupTitle{OptionGroup::general, "General"},
};

constexpr std::array kExitCodeTexts{
    ExitCodeText{ExitCode::done, "success"},
    ExitCodeText{ExitCode::usage, "wrong usage"},
    ExitCodeText{ExitCode::file, "invalid scene, image or file, or a size beyond the limits"},
    ExitCodeText{ExitCode::differ,
                 "the images differ, the device failed the test, a report became worse, or --strict found bad samples"},
    ExitCodeText{ExitCode::noDevice, "no usable device"},
    ExitCodeText{ExitCode::deviceLost, "the device was lost or hung"},
    ExitCodeText{ExitCode::outOfMemory, "out of memory"},
    ExitCodeText{ExitCode::interrupted, "interrupted; the samples rendered so far are written"},
    ExitCodeText{ExitCode::undecided,
                 "the verdict is not decided: rounding, noise or too few renders may hide more than is permitted"},
    ExitCodeText{ExitCode::internal, "internal error"},
};

}  // namespace

std::span<const GroupTitle> groupTitles() { return kGroupTitles; }
std::span<const ExitCodeText> exitCodeTexts() { return kExitCodeTexts; }

}  // namespace candela::cli
