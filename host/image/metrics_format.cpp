// The difference between two images as text and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/image/metrics.h"

namespace candela::image {
namespace {

nlohmann::ordered_json toJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

bool isIdentical(const ImageComparison& c) { return c.maximumDifference == 0 && c.notFiniteCount == 0; }

std::string toText(const ImageComparison& c) {
  std::string text = fmt::format("size                  {} x {}\n", c.width, c.height);
  if (c.notFiniteCount > 0) text += fmt::format("not finite            {} pixels, ignored\n", c.notFiniteCount);
  text += fmt::format("mean                  {:.6g} {:.6g} {:.6g}, luminance {:.6g}\n", c.mean.x, c.mean.y, c.mean.z,
                      c.meanLuminance);
  text += fmt::format("mean of the reference {:.6g} {:.6g} {:.6g}, luminance {:.6g}\n", c.referenceMean.x,
                      c.referenceMean.y, c.referenceMean.z, c.referenceMeanLuminance);
  text += fmt::format("mean difference       {:+.4g} %\n", 100 * c.relativeMeanDifference);
  text += fmt::format("MSE                   {:.6g}\n", c.meanSquaredError);
  text += fmt::format("relMSE                {:.6g}\n", c.relativeMeanSquaredError);
  text += fmt::format("PSNR                  {}\n",
                      isIdentical(c) ? "infinite" : fmt::format("{:.2f} dB", c.peakSignalToNoise));
  text += fmt::format("maximum difference    {:.6g} at {} {}\n", c.maximumDifference, c.maximumX, c.maximumY);
  text += fmt::format("pixels that differ    {} ({:.4g} %) by more than {:g} relative and {:g} absolute\n",
                      c.differingCount, 100 * c.differingFraction, c.tolerance.relative, c.tolerance.absolute);
  return text;
}

nlohmann::ordered_json toJson(const ImageComparison& c) {
  return {{"size", fmt::format("{}x{}", c.width, c.height)},
          {"notFiniteCount", c.notFiniteCount},
          {"mean", toJson(c.mean)},
          {"referenceMean", toJson(c.referenceMean)},
          {"meanLuminance", c.meanLuminance},
          {"referenceMeanLuminance", c.referenceMeanLuminance},
          {"relativeMeanDifference", c.relativeMeanDifference},
          {"meanSquaredError", c.meanSquaredError},
          {"relativeMeanSquaredError", c.relativeMeanSquaredError},
          {"peakSignalToNoise", c.peakSignalToNoise},
          {"worst", {{"difference", c.maximumDifference}, {"x", c.maximumX}, {"y", c.maximumY}}},
          {"relativeTolerance", c.tolerance.relative},
          {"absoluteTolerance", c.tolerance.absolute},
          {"differingCount", c.differingCount},
          {"differingFraction", c.differingFraction}};
}

}  // namespace candela::image
