// The commands: their names, their arguments, and the functions that execute them.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "host/cli/arguments.h"
#include "host/core/errors.h"

namespace candela::cli {

struct CommandInfo {
  Command command;
  std::string name;
  std::string usage;     ///< after the program's name
  std::string summary;   ///< an imperative phrase, without a capital and a full stop
  std::string fileNoun;  ///< noun for a missing file in messages
  std::size_t minFileCount;
  std::size_t maxFileCount;
  ExitCode (*run)(const Arguments&, const Log&);
};

std::span<const CommandInfo> commandTable();
const CommandInfo& commandInfo(Command command);

// Each command has a separate file. Commands return an exit code for results (done, differ, interrupted, invalid
// scenes) and throw Error if there is no result.
ExitCode runRender(const Arguments& arguments, const Log& log);
ExitCode runDevices(const Arguments& arguments, const Log& log);
ExitCode runDoctor(const Arguments& arguments, const Log& log);
ExitCode runCheck(const Arguments& arguments, const Log& log);
ExitCode runCompare(const Arguments& arguments, const Log& log);
ExitCode runConformance(const Arguments& arguments, const Log& log);
ExitCode runCapture(const Arguments& arguments, const Log& log);
ExitCode runVerify(const Arguments& arguments, const Log& log);
ExitCode runExplain(const Arguments& arguments, const Log& log);
ExitCode runBench(const Arguments& arguments, const Log& log);
// The benchmarks of runBench(), by their first argument.
ExitCode runBenchStructures(const Arguments& arguments, const Log& log);  ///< `table1`, `accel`
ExitCode runBenchRays(const Arguments& arguments, const Log& log);        ///< `rays`
ExitCode runBenchScenes(const Arguments& arguments, const Log& log);      ///< scenes
ExitCode runBenchCompare(const Arguments& arguments, const Log& log);     ///< `compare`
ExitCode runTune(const Arguments& arguments, const Log& log);
ExitCode runFilm(const Arguments& arguments, const Log& log);
ExitCode runDenoise(const Arguments& arguments, const Log& log);
ExitCode runMerge(const Arguments& arguments, const Log& log);
ExitCode runGenerate(const Arguments& arguments, const Log& log);
ExitCode runReport(const Arguments& arguments, const Log& log);
ExitCode runView(const Arguments& arguments, const Log& log);
ExitCode runBoxes(const Arguments& arguments, const Log& log);

}  // namespace candela::cli
