// Reduces renders to the means of their regions.
#include "host/judge/verify/render_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/finite.h"

namespace candela::verify {
namespace {

std::string textOfPlace(const image::PixelBox& window, const image::PixelBox& frame) {
  return window == frame ? fmt::format("the size {}x{}", frame.width, frame.height)
                         : fmt::format("the window {} of the frame {}", boxText(window), boxText(frame));
}

void requireFinite(const image::Image& render) {
  const auto bad = std::ranges::find_if_not(render.rgb, isFinite<float>);
  if (bad == render.rgb.end()) return;
  const auto index = bad - render.rgb.begin();
  throw FileError(fmt::format(
      "the pixel {},{} is not finite ({} such pixels): no mean over it exists, and to leave it out would hide it",
      render.origin.x + index % render.width, render.origin.y + index / render.width,
      std::ranges::count_if(render.rgb, [](const glm::vec3& colour) { return !isFinite(colour); })));
}

}  // namespace

void RenderSet::requireUsable(const image::Image& render) const {
  if (render.isDisplayReferred) {
    throw FileError(
        "a display transform has clipped and rounded its pixels, so that their means are not those of the light; "
        "write EXR, PFM or HDR files");
  }
  if (count() > 0 && (windowOf(render) != window_ || frameOf(render) != frame_)) {
    throw FileError(fmt::format("it has {}, and the renders before it have {}",
                                textOfPlace(windowOf(render), frameOf(render)), placeText()));
  }
  requireFinite(render);
}

void RenderSet::add(const image::Image& render) {
  requireUsable(render);
  if (count() == 0) {
    window_ = windowOf(render);
    frame_ = frameOf(render);
    regions_ = regionsOf({render.width, render.height});
    sums_.resize(render.rgb.size());
  }
  std::vector<double>& means = means_.emplace_back();
  for (const Region& region : regions_) means.push_back(regionMean(render, region));
  for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += glm::dvec3(render.rgb[i]);
  significandBits_ = std::min(significandBits_, render.significandBits);
}

std::string RenderSet::placeText() const { return textOfPlace(window_, frame_); }

std::optional<std::size_t> RenderSet::twinOfLast() const {
  const auto last = means_.end() - 1;
  const auto twin = std::find(means_.begin(), last, *last);
  return twin == last ? std::nullopt : std::optional(static_cast<std::size_t>(twin - means_.begin()));
}

image::Image RenderSet::mean() const {
  image::Image mean;
  mean.width = static_cast<std::uint32_t>(window_.width);
  mean.height = static_cast<std::uint32_t>(window_.height);
  mean.origin = {window_.x, window_.y};
  mean.frame = frame_;
  for (const glm::dvec3& sum : sums_) mean.rgb.emplace_back(sum / static_cast<double>(count()));
  return mean;
}

}  // namespace candela::verify
