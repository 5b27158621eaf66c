// The two tracers, and sessions on them: a scene that stays prepared while its film grows.
//
//   const auto tracer = candela::makeGpuRenderer("");  // or candela::makeReferenceRenderer()
//   const auto session = tracer->prepare(scene, settings);
//   for (std::uint32_t done = 0; done < settings.image.sampleCount; ++done) {
//     session->advance({done, done + 1}, {});
//     show(session->film());
//   }
//
// A film is the same, bit for bit, however its samples are divided among calls. A program that only wants a finished
// film uses runJob() of candela/film.h, which also survives failures of the device.
#pragma once
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/renderer.h"

namespace candela {

/// A tracer. prepare() builds what a scene and settings need, and returns a session; the scene must outlive it.
using render::Renderer;
/// The kernels on the Vulkan device that the selector names: an index, a part of a name, or "" for the best one. Throws
/// NoDeviceError, with the devices that there are.
using device::makeGpuRenderer;
/// The independent tracer in double precision, on the threads of the host.
using reference::makeReferenceRenderer;

/// Adds samples to a film, moves the camera, starts again with another seed, continues a film. Its functions throw
/// DeviceLostError and OutOfMemoryError; after one of them, only salvage() is left.
using render::Session;
/// Samples [first, end) of each pixel.
using render::SampleRange;
/// A flag that stops a session between dispatches, and a function that gets its progress.
using render::RenderControl;
/// Counts, times in seconds, names of device and driver, warnings.
using render::RenderStatistics;

}  // namespace candela
