// Uploads a scene, through the buffer type that fits the device.
#include "host/trace/device/device_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::device {
namespace {

constexpr std::uint64_t kRowBytes = sizeof(gpu::uvec4);

bool fitsTexels(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat) {
  return flat.rows.size() <= info.maxTexelBufferElements;
}

bool fitsStorage(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat) {
  return flat.rows.size() * kRowBytes <= info.maxStorageBufferRange;
}

[[noreturn]] void refuse(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat, render::SceneLoads asked) {
  if (asked == render::SceneLoads::texel) {
    throw FileError(fmt::format("the scene needs {} texels, but {} binds at most {}: use {}", flat.rows.size(),
                                info.name, info.maxTexelBufferElements, settingWords("loads", "storage")));
  }
  const bool grid = flat.shape.structure == gpu::kStructureGrid;
  const std::string smaller = grid ? "make it smaller, or lower " + settingWords("grid-density") : "make it smaller";
  throw FileError(fmt::format("the scene needs {} MiB on the device, but {} binds at most {} MiB: {}",
                              flat.rows.size() * kRowBytes >> 20, info.name, info.maxStorageBufferRange >> 20,
                              fitsTexels(info, flat) ? "use " + settingWords("loads", "texel") : smaller));
}

vulkan::Buffer makeRows(vulkan::Device& device, const flatten::FlatScene& flat, bool real, vulkan::Usage usage) {
  if (!real || flat.rows.empty()) return vulkan::Buffer(device, kRowBytes, usage);
  vulkan::Buffer buffer(device, flat.rows.size() * kRowBytes, usage);
  buffer.upload(std::as_bytes(std::span(flat.rows)));
  return buffer;
}

}  // namespace

bool canBind(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat, render::SceneLoads loads) {
  if (loads != render::SceneLoads::storage && fitsTexels(info, flat)) return true;
  return loads != render::SceneLoads::texel && fitsStorage(info, flat);
}

render::SceneLoads loadsFor(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat,
                            const render::RenderSettings& settings) {
  if (!canBind(info, flat, settings.execution.sceneLoads)) refuse(info, flat, settings.execution.sceneLoads);
  if (settings.execution.sceneLoads != render::SceneLoads::automatic) return settings.execution.sceneLoads;
  using enum render::SceneLoads;
  const render::SceneLoads preferred = settings.execution.automatic.sceneLoads == storage ? storage : texel;
  if (canBind(info, flat, preferred)) return preferred;
  return preferred == render::SceneLoads::texel ? render::SceneLoads::storage : render::SceneLoads::texel;
}

DeviceScene::DeviceScene(vulkan::Device& device, const flatten::FlatScene& flat, render::SceneLoads loads)
    : readsTexels_(loads == render::SceneLoads::texel),
      rows_(makeRows(device, flat, !readsTexels_, vulkan::Usage::storage)),
      texels_(makeRows(device, flat, readsTexels_, vulkan::Usage::uniformTexel)),
      uniforms_(device, sizeof(gpu::RenderUniforms), vulkan::Usage::uniform) {
  uploadUniforms(flat.constants, flat.slotRows);
}

void DeviceScene::uploadUniforms(const gpu::RenderConstants& constants, std::span<const gpu::uvec4> slotRows) {
  gpu::RenderUniforms uniforms{.constants = constants, .slotRows = {}};
  std::ranges::copy(slotRows, uniforms.slotRows);
  uniforms_.upload(std::as_bytes(std::span(&uniforms, 1)));
}

void DeviceScene::update(const flatten::CameraRecords& records) {
  vulkan::Buffer& rows = readsTexels_ ? texels_ : rows_;
  for (const flatten::RecordSpan* span : {&records.primitives, &records.pointLights}) {
    if (!span->rows.empty()) rows.upload(std::as_bytes(std::span(span->rows)), span->first * kRowBytes);
  }
  updateConstants(records);
}

void DeviceScene::updateConstants(const flatten::CameraRecords& records) {
  uploadUniforms(records.constants, records.slotRows);
}

}  // namespace candela::device
