// A Vulkan layer that makes chosen calls fail, so that tests observe the program's reaction.
//
// CANDELA_FAULT lists faults, separated by commas: FUNCTION:N:RESULT fails the N-th call of a function (from 1) without
// passing it on, and FUNCTION:N+:RESULT that call and all after it. RESULT is the name of a VkResult. After
// VK_ERROR_DEVICE_LOST, submissions to that device fail, and waits for it end with that result. vkWaitForFences:N:HANG
// sleeps until the timeout of the call, as if a kernel did not end. vkCmdDispatch:N:DROP leaves the dispatch out, as a
// driver that loses invocations does; DROP_WIDE does so only if it has several workgroups, so that devices can be
// opened. CANDELA_FAULT_COUNTS names a file to which the number of calls of each function is written when an instance
// is destroyed, and CANDELA_FAULT_LOG one to which each injected fault is appended.
//
// CANDELA_FAULT_WAITS names a file to which a line is appended for each vkWaitForFences: the timeout in seconds, and
// "new" if a pipeline was bound since the last wait that had not been bound before, else "known". All devices then
// claim to be discrete GPUs, since the program sets no time limit for devices in software.
#include "tests/trace/vulkan_support/layer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "tests/faults/faults.h"

namespace {

using namespace candela::faults;
using namespace candela::layer;

struct Next : NextFunctions {
  std::array<PFN_vkVoidFunction, kFunctionCount> functions{};
  PFN_vkGetPhysicalDeviceProperties properties = nullptr;  ///< of an instance
  PFN_vkCmdBindPipeline bindPipeline = nullptr;            ///< of a device
  PFN_vkDestroyPipeline destroyPipeline = nullptr;         ///< of a device
  PFN_vkCmdDispatch dispatch = nullptr;                    ///< of a device
  bool isLost = false;
};
NextTable<Next> nexts;

// Functions that a lost device fails. The waits end after the work, as the specification requires.
constexpr bool isWait(Function function) { return function == k_vkWaitForFences || function == k_vkDeviceWaitIdle; }
constexpr bool usesDevice(Function function) { return isWait(function) || function == k_vkQueueSubmit; }

template <Function kFunction, class Pfn>
struct Hook;
template <Function kFunction, class First, class... Rest>
struct Hook<kFunction, VkResult(VKAPI_PTR*)(First, Rest...)> {
  using Pfn = VkResult(VKAPI_PTR*)(First, Rest...);
  static VKAPI_ATTR VkResult VKAPI_CALL call(First first, Rest... rest) {
    const Next next = nexts.of(first);
    const auto pass = [&] { return reinterpret_cast<Pfn>(next.functions[kFunction])(first, rest...); };
    const std::optional<VkResult> fault = faultOf(kFunction);
    if constexpr (usesDevice(kFunction)) {
      if (fault == VK_ERROR_DEVICE_LOST) nexts.update(first, [](Next& device) { device.isLost = true; });
      if (next.isLost || fault == VK_ERROR_DEVICE_LOST) {
        if constexpr (kFunction == k_vkDeviceWaitIdle) pass();
        return VK_ERROR_DEVICE_LOST;
      }
    }
    return fault ? *fault : pass();
  }
};

// The pipelines of all devices that have been bound. The program records commands in one thread at a time.
struct BoundPipelines {
  std::set<VkPipeline> known;
  bool hasNew = false;
};
BoundPipelines bound;

const char* waitsFile() { return std::getenv("CANDELA_FAULT_WAITS"); }

VKAPI_ATTR void VKAPI_CALL bindPipeline(VkCommandBuffer commands, VkPipelineBindPoint point, VkPipeline pipeline) {
  if (bound.known.insert(pipeline).second) bound.hasNew = true;
  nexts.of(commands).bindPipeline(commands, point, pipeline);
}

VKAPI_ATTR void VKAPI_CALL destroyPipeline(VkDevice device, VkPipeline pipeline,
                                           const VkAllocationCallbacks* allocator) {
  bound.known.erase(pipeline);
  nexts.of(device).destroyPipeline(device, pipeline, allocator);
}

void noteWait(std::uint64_t timeout) {
  if (waitsFile() == nullptr) return;
  std::ofstream(waitsFile(), std::ios::app)
      << static_cast<double>(timeout) * 1e-9 << (bound.hasNew ? " new\n" : " known\n");
  bound.hasNew = false;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice device, VkPhysicalDeviceProperties* properties) {
  nexts.of(device).properties(device, properties);
  if (waitsFile() != nullptr) properties->deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, uint32_t count, const VkFence* fences, VkBool32 all,
                                             uint64_t timeout) {
  noteWait(timeout);
  const VkResult result = Hook<k_vkWaitForFences, PFN_vkWaitForFences>::call(device, count, fences, all, timeout);
  if (result != kHang) return result;
  constexpr std::uint64_t kHour = 3'600'000'000'000;
  std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(timeout, kHour)));
  return VK_TIMEOUT;
}

VKAPI_ATTR void VKAPI_CALL cmdDispatch(VkCommandBuffer commands, uint32_t x, uint32_t y, uint32_t z) {
  const std::optional<VkResult> fault = faultOf(k_vkCmdDispatch);
  const bool isLeftOut = fault == kDrop || (fault == kDropWide && x * y * z > 1);
  if (!isLeftOut) nexts.of(commands).dispatch(commands, x, y, z);
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
  if (const std::optional<VkResult> fault = faultOf(k_vkCreateInstance)) return *fault;
  const PFN_vkGetInstanceProcAddr get = followLink(info);
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(get(nullptr, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  // The functions are looked up now, because the loader's last function returns the first ones of the chain later.
  Next next{{get(*instance, "vkDestroyInstance"), get, nullptr}};
  for (std::size_t i = 0; i < kFunctionCount; ++i) next.functions[i] = get(*instance, kNames[i]);
  next.properties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
      get(*instance, "vkGetPhysicalDeviceProperties"));
  nexts.set(*instance, next);
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physicalDevice, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  if (const std::optional<VkResult> fault = faultOf(k_vkCreateDevice)) return *fault;
  const PFN_vkGetDeviceProcAddr get = followLink(info);
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(nexts.of(physicalDevice).functions[k_vkCreateDevice]);
  const VkResult result = create(physicalDevice, info, allocator, device);
  if (result != VK_SUCCESS) return result;
  Next next{{get(*device, "vkDestroyDevice"), nullptr, get}};
#define CANDELA_GET(function) next.functions[k_##function] = get(*device, #function);
  CANDELA_DEVICE_FUNCTIONS(CANDELA_GET)
#undef CANDELA_GET
  next.bindPipeline = reinterpret_cast<PFN_vkCmdBindPipeline>(get(*device, "vkCmdBindPipeline"));
  next.destroyPipeline = reinterpret_cast<PFN_vkDestroyPipeline>(get(*device, "vkDestroyPipeline"));
  next.dispatch = reinterpret_cast<PFN_vkCmdDispatch>(get(*device, "vkCmdDispatch"));
  nexts.set(*device, next);
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance, const VkAllocationCallbacks* allocator) {
  if (instance == VK_NULL_HANDLE) return;
  writeCounts();
  reinterpret_cast<PFN_vkDestroyInstance>(nexts.take(instance).destroy)(instance, allocator);
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* allocator) {
  if (device == VK_NULL_HANDLE) return;
  reinterpret_cast<PFN_vkDestroyDevice>(nexts.take(device).destroy)(device, allocator);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name);

PFN_vkVoidFunction deviceHook(std::string_view name) {
  if (name == "vkWaitForFences") return erased(waitForFences);
  if (name == "vkCmdDispatch") return erased(cmdDispatch);
  if (name == "vkDestroyDevice") return erased(destroyDevice);
  if (name == "vkCmdBindPipeline") return erased(bindPipeline);
  if (name == "vkDestroyPipeline") return erased(destroyPipeline);
  if (name == "vkGetDeviceProcAddr") return erased(getDeviceProcAddr);
#define CANDELA_HOOK(function) \
  if (name == #function) return erased(Hook<k_##function, PFN_##function>::call);
  CANDELA_DEVICE_FUNCTIONS(CANDELA_HOOK)
  return nullptr;
}

PFN_vkVoidFunction instanceHook(std::string_view name) {
  if (name == "vkCreateInstance") return erased(createInstance);
  if (name == "vkDestroyInstance") return erased(destroyInstance);
  if (name == "vkCreateDevice") return erased(createDevice);
  if (name == "vkGetPhysicalDeviceProperties") return erased(getProperties);
  if (name == "vkGetInstanceProcAddr") return erased(getInstanceProcAddr);
  CANDELA_INSTANCE_FUNCTIONS(CANDELA_HOOK)
#undef CANDELA_HOOK
  return deviceHook(name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
  const PFN_vkVoidFunction next = nexts.of(device).device(device, name);
  const PFN_vkVoidFunction hook = deviceHook(name);
  return hook != nullptr && next != nullptr ? hook : next;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
  const PFN_vkVoidFunction hook = instanceHook(name);
  // The loader asks the first layer for vkCreateInstance with an instance that does not exist yet.
  if (instance == VK_NULL_HANDLE || std::string_view(name) == "vkCreateInstance") return hook;
  const PFN_vkVoidFunction next = nexts.of(instance).instance(instance, name);
  return hook != nullptr && next != nullptr ? hook : next;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  return negotiate(*interface, getInstanceProcAddr, getDeviceProcAddr);
}
