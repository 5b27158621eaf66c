// The results of the kit: the measurements of its script `run.sh` on one device, from the file `results.json`.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela::kit {

/// One command of the script.
struct Step {
  std::string name;
  int exitCode = 0;
  double seconds = 0;
};

/// A conformance case that did not pass.
struct FailedCase {
  std::string name;
  std::string result;  ///< `Fail`, `Crash`, `Timeout` or `Flake`
};

/// The outcome of `candela verify` for one scene.
struct Verdict {
  std::string scene;
  bool agree = false;
  std::string text;  ///< one sentence
};

/// The speed of whole renders of a scene with one choice of kernel, layout and loads.
struct RenderSpeed {
  std::string scene;
  std::string variant;
  double msamplesPerSecond = 0;
  double mraysPerSecond = 0;
  double spread = 0;  ///< of the repeated runs: (max - min) / median
};

/// The speed of rays of one kind with one layout and kind of loads.
struct RaySpeed {
  std::string scene;
  std::string kind;     ///< `primary`, `diffuse` or `shadow`
  std::string variant;  ///< layout and loads
  double mraysPerSecond = 0;
};

struct KitResults {
  std::string version;    ///< of the program
  std::string device;     ///< name that the driver reports
  std::string driver;     ///< its name and version
  std::string system;     ///< operating system
  std::string processor;  ///< of the host
  bool quick = false;     ///< small images, as for devices in software
  std::vector<Step> steps;
  std::map<std::string, unsigned> caseCounts;  ///< conformance cases by result; empty if they were not run
  std::vector<FailedCase> failedCases;
  std::vector<Verdict> verdicts;
  std::vector<RenderSpeed> renders;
  std::vector<RaySpeed> rays;
  std::string tuned;  ///< fastest settings, as text; empty if they were not measured
};

/// Reads a `results.json` with the schema "candela-kit/2" or "candela-kit/1". Steps without a result are null in it.
/// Throws FileError, which names the file and the JSON pointer of the error.
KitResults readKitResults(const std::filesystem::path& file);

/// Returns the rows with the maximum speed of each scene, in the order of the file.
std::vector<RenderSpeed> fastestRenders(const KitResults& results);
/// Returns the rows with the maximum speed of each scene and kind of rays, in the order of the file.
std::vector<RaySpeed> fastestRays(const KitResults& results);

}  // namespace candela::kit
