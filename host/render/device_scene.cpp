#include "host/render/device_scene.h"

#include <fmt/format.h>

#include <span>

#include "host/core/errors.h"

namespace candela {
namespace {

constexpr std::uint64_t kRowBytes = sizeof(gpu::uvec4);

bool fitsTexels(const DeviceInfo& info, const FlatScene& flat) {
  return flat.rows.size() <= info.maxTexelBufferElements;
}

bool fitsStorage(const DeviceInfo& info, const FlatScene& flat) {
  return flat.rows.size() * kRowBytes <= info.maxStorageBufferRange;
}

bool choosesTexels(const vulkan::Device& device, const FlatScene& flat, SceneLoads loads) {
  const bool fits = fitsTexels(device.info(), flat);
  if (loads == SceneLoads::texel && !fits) {
    throw FileError(fmt::format("the scene needs {} texels, but {} binds at most {}: use storage loads",
                                flat.rows.size(), device.info().name, device.info().maxTexelBufferElements));
  }
  if (loads != SceneLoads::texel && !fits && !fitsStorage(device.info(), flat)) {
    throw FileError(fmt::format("the scene needs {} MiB on the device, but {} binds at most {} MiB: make it smaller{}",
                                flat.rows.size() * kRowBytes >> 20, device.info().name,
                                device.info().maxStorageBufferRange >> 20,
                                flat.structure == gpu::kStructureGrid ? ", or lower --grid-density" : ""));
  }
  return loads != SceneLoads::storage && fits;
}

vulkan::Buffer makeRows(vulkan::Device& device, const FlatScene& flat, bool real, vulkan::Usage usage) {
  if (!real || flat.rows.empty()) return vulkan::Buffer(device, kRowBytes, usage);
  vulkan::Buffer buffer(device, flat.rows.size() * kRowBytes, usage);
  buffer.upload(std::as_bytes(std::span(flat.rows)));
  return buffer;
}

}  // namespace

bool canBind(const DeviceInfo& info, const FlatScene& flat, SceneLoads loads) {
  if (loads != SceneLoads::storage && fitsTexels(info, flat)) return true;
  return loads != SceneLoads::texel && fitsStorage(info, flat);
}

DeviceScene::DeviceScene(vulkan::Device& device, const FlatScene& flat, SceneLoads loads)
    : readsTexels_(choosesTexels(device, flat, loads)),
      rows_(makeRows(device, flat, !readsTexels_, vulkan::Usage::storage)),
      texels_(makeRows(device, flat, readsTexels_, vulkan::Usage::uniformTexel)),
      constants_(device, sizeof(gpu::RenderConstants), vulkan::Usage::uniform) {
  constants_.upload(std::as_bytes(std::span(&flat.constants, 1)));
}

}  // namespace candela
