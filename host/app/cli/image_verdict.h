// The verdict of `candela compare A B`: by a tolerance, by statistics, by both, or none.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/app/cli/command_arguments.h"
#include "host/image/channel_comparison.h"
#include "host/image/metrics.h"
#include "host/judge/verify/film_test.h"

namespace candela::cli {

/// Pictures that cannot be laid over each other differ. All requested criteria must be met: the tolerance if
/// --tolerance is given, by the colours and by every other channel that is compared, the test of both films if --alpha
/// is given. If neither is given, two films with variances are tested, and other images get no verdict.
struct ImageVerdict {
  std::string whyApart;  ///< image::whyApart(): then there is nothing else
  std::optional<double> tolerance;
  bool withinTolerance = true;
  std::vector<std::string> exceeding{};  ///< channels beyond the tolerance; `colours` are R, G and B
  std::optional<verify::FilmTestResult> films;
  std::string whyNoTest;  ///< the reason if films with variances were not tested; else empty

  bool isGiven() const { return !whyApart.empty() || tolerance || films; }
  verify::Conclusion conclusion() const;
  /// Returns sentences without a newline at the end, also if there is no verdict.
  std::string sentence() const;
};

/// Throws UsageError if --alpha is given and the images cannot be tested.
ImageVerdict judgeImages(const CompareArguments& arguments, const image::Image& a, const image::Image& reference,
                         const image::ImageComparison& comparison, const image::ChannelComparison& channels);

/// Returns lines, each ending in a newline; nothing if there is neither a verdict nor a reason for its absence.
std::string toText(const ImageVerdict& verdict);
/// Adds `agrees`, `sameLight` if the light was tested, `exceeding` if there is a tolerance, and `apart` if the pictures
/// cannot be laid over each other.
void addToJson(const ImageVerdict& verdict, nlohmann::ordered_json& json);

}  // namespace candela::cli
