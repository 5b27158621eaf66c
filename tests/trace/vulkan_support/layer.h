// The common parts of the Vulkan layers of the tests: the next functions of the chain, found by the dispatch table that
// a handle refers to, and the functions by which the loader and the program find those of the layer.
#pragma once
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <map>
#include <mutex>

namespace candela::layer {

/// The first members of a layer's data for an instance or a device.
struct NextFunctions {
  PFN_vkVoidFunction destroy = nullptr;          ///< vkDestroyInstance or vkDestroyDevice
  PFN_vkGetInstanceProcAddr instance = nullptr;  ///< of an instance
  PFN_vkGetDeviceProcAddr device = nullptr;      ///< of a device
};

template <class Handle>
void* keyOf(Handle handle) {
  return *reinterpret_cast<void**>(handle);
}

/// The data of a layer for each instance and device: a `Next` that derives from NextFunctions.
template <class Next>
class NextTable {
 public:
  template <class Handle>
  void set(Handle handle, const Next& next) {
    const std::scoped_lock lock(mutex_);
    nexts_[keyOf(handle)] = next;
  }
  template <class Handle>
  Next of(Handle handle) {
    const std::scoped_lock lock(mutex_);
    return nexts_.at(keyOf(handle));
  }
  template <class Handle>
  Next take(Handle handle) {
    const std::scoped_lock lock(mutex_);
    const Next next = nexts_.at(keyOf(handle));
    nexts_.erase(keyOf(handle));
    return next;
  }
  /// Calls `change` with the entry of a handle.
  template <class Handle, class Change>
  void update(Handle handle, const Change& change) {
    const std::scoped_lock lock(mutex_);
    change(nexts_.at(keyOf(handle)));
  }

 private:
  std::mutex mutex_;
  std::map<void*, Next> nexts_;
};

template <class Info>
Info* linkOf(const void* start, VkStructureType type) {
  auto* info = static_cast<Info*>(const_cast<void*>(start));
  while (info != nullptr && (info->sType != type || info->function != VK_LAYER_LINK_INFO)) {
    info = static_cast<Info*>(const_cast<void*>(info->pNext));
  }
  return info;
}

/// Returns vkGetInstanceProcAddr of the next layer, and moves the link in `info` to the layer after it.
inline PFN_vkGetInstanceProcAddr followLink(const VkInstanceCreateInfo* info) {
  auto* link = linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  const PFN_vkGetInstanceProcAddr get = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  return get;
}

/// Returns vkGetDeviceProcAddr of the next layer, and moves the link in `info` to the layer after it.
inline PFN_vkGetDeviceProcAddr followLink(const VkDeviceCreateInfo* info) {
  auto* link = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  const PFN_vkGetDeviceProcAddr get = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  return get;
}

template <class F>
PFN_vkVoidFunction erased(F* function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

/// Negotiates the interface of the layer with the loader.
inline VkResult negotiate(VkNegotiateLayerInterface& interface, PFN_vkGetInstanceProcAddr instance,
                          PFN_vkGetDeviceProcAddr device) {
  interface.loaderLayerInterfaceVersion = std::min(interface.loaderLayerInterfaceVersion, 2u);
  interface.pfnGetInstanceProcAddr = instance;
  interface.pfnGetDeviceProcAddr = device;
  interface.pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}

}  // namespace candela::layer
