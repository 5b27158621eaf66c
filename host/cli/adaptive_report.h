// Reports on adaptive sampling, and the options that exclude it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/cli/arguments.h"
#include "host/film/film_header.h"

namespace candela::cli {

/// Throws UsageError if the resolved arguments combine adaptive sampling with options that exclude it.
void requireAdaptable(const Arguments& arguments);

/// Returns the plan of resolved arguments; nothing without --noise-threshold.
std::optional<render::AdaptivePlan> planOf(const Arguments& arguments);

/// Returns e.g. "16 to 256 samples per pixel, 38.5 on average". The film must have a pixel.
std::string adaptiveText(const image::Film& film);

/// Returns the numbers of samples, half-regions and errors of a film. `maxSamples` is the limit of the plan.
nlohmann::ordered_json adaptiveJson(const render::AdaptivePlan& plan, const image::Film& film,
                                    std::uint32_t maxSamples);

/// Returns the sentence about the bias of adaptive sampling in the metadata of images. `threshold` is a number or its
/// notation.
std::string adaptiveBiasText(const std::string& threshold);

}  // namespace candela::cli
