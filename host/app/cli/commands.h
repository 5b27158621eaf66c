// The commands: their names, their numbers of files, and the functions that execute them.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "host/app/cli/command_arguments.h"
#include "host/base/errors.h"
#include "host/base/log.h"

namespace candela::cli {

struct CommandInfo {
  Command command;
  std::string name;
  std::string usage;     ///< after the program's name
  std::string summary;   ///< an imperative phrase, without a capital and a full stop
  std::string fileNoun;  ///< noun for a missing file in messages
  std::size_t minFileCount;
  std::size_t maxFileCount;
};

std::span<const CommandInfo> commandTable();
const CommandInfo& commandInfo(Command command);

// Each command has a separate file. Commands return an exit code for results (done, differ, interrupted, invalid
// scenes) and throw Error if there is no result.
ExitCode run(const RenderArguments& arguments, const Log& log);
ExitCode run(const DevicesArguments& arguments, const Log& log);
ExitCode run(const DoctorArguments& arguments, const Log& log);
ExitCode run(const CheckArguments& arguments, const Log& log);
ExitCode run(const CompareArguments& arguments, const Log& log);
ExitCode run(const ConformanceArguments& arguments, const Log& log);
ExitCode run(const CaptureArguments& arguments, const Log& log);
ExitCode run(const VerifyArguments& arguments, const Log& log);
ExitCode run(const ExplainArguments& arguments, const Log& log);
ExitCode run(const BenchArguments& arguments, const Log& log);
ExitCode run(const KernelsArguments& arguments, const Log& log);
ExitCode run(const TuneArguments& arguments, const Log& log);
ExitCode run(const FilmArguments& arguments, const Log& log);
ExitCode run(const DenoiseArguments& arguments, const Log& log);
ExitCode run(const MergeArguments& arguments, const Log& log);
ExitCode run(const GenerateArguments& arguments, const Log& log);
ExitCode run(const ReportArguments& arguments, const Log& log);
ExitCode run(const ViewArguments& arguments, const Log& log);
ExitCode run(const BoxesArguments& arguments, const Log& log);

// The benchmarks of `candela bench`, by its first argument.
ExitCode runBenchStructures(const BenchArguments& arguments, const Log& log);  ///< `table1`, `accel`
ExitCode runBenchRays(const BenchArguments& arguments, const Log& log);        ///< `rays`
ExitCode runBenchScenes(const BenchArguments& arguments, const Log& log);      ///< scenes
ExitCode runBenchError(const BenchArguments& arguments, const Log& log);       ///< `error`
ExitCode runBenchCompare(const BenchArguments& arguments, const Log& log);     ///< `compare`

}  // namespace candela::cli
