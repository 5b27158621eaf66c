// The expected film of one sample of each pixel.
#pragma once
#include <cstdint>

#include "host/drivers/capture/expected_value.h"
#include "host/image/film.h"
#include "host/trace/render/renderer.h"

namespace candela::capture {

/// Binding of the film in the kernels that render: docs/architecture.md.
inline constexpr std::uint32_t kFilmBinding = 2;

/// Returns the sums and counts of the pixels of the settings' window after only sample `index`, as the reference
/// computes them. The tolerance of a sum is that of docs/testing.md, "The verdict on a device". Pixels that single
/// precision cannot decide are omitted. `reference` traces replicas.
ExpectedValues expectedFilm(const scene::Scene& scene, const render::RenderSettings& settings, std::uint32_t index,
                            render::Renderer& reference);

/// Returns the words of the same pixels, all of which are expected.
ExpectedValues bitsOf(const image::Film& film);

/// Returns the number of values from which the film differs.
std::size_t differingCount(const image::Film& film, const ExpectedValues& expected);

}  // namespace candela::capture
