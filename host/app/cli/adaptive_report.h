// Reports on adaptive sampling.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/image/film.h"
#include "host/trace/render/adaptive_plan.h"

namespace candela::cli {

/// Returns e.g. "16 to 256 samples per pixel, 38.5 on average". The film must have a pixel.
std::string adaptiveText(const image::Film& film);

/// Returns the numbers of samples, half-regions and errors of a film. `maxSamples` is the limit of the plan.
nlohmann::ordered_json adaptiveJson(const render::AdaptivePlan& plan, const image::Film& film,
                                    std::uint32_t maxSamples);

/// Returns the sentence about the bias of adaptive sampling in the metadata of images. `threshold` is a number or its
/// notation.
std::string adaptiveBiasText(const std::string& threshold);

}  // namespace candela::cli
