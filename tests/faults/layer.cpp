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
#include "tests/vulkan_support/layer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using namespace candela::layer;

// Every function that Candela calls and that can fail, except the global ones, which layers do not see.
#define CANDELA_INSTANCE_FUNCTIONS(X) \
  X(vkEnumeratePhysicalDevices)       \
  X(vkEnumerateDeviceExtensionProperties) X(vkCreateDebugUtilsMessengerEXT)
#define CANDELA_DEVICE_FUNCTIONS(X) \
  X(vkCreatePipelineCache)          \
  X(vkMergePipelineCaches)          \
  X(vkGetPipelineCacheData)         \
  X(vkCreateCommandPool)            \
  X(vkResetCommandPool)             \
  X(vkAllocateCommandBuffers)       \
  X(vkBeginCommandBuffer)           \
  X(vkEndCommandBuffer)             \
  X(vkCreateFence)                  \
  X(vkResetFences)                  \
  X(vkWaitForFences)                \
  X(vkQueueSubmit)                  \
  X(vkDeviceWaitIdle)               \
  X(vkCreateBuffer)                 \
  X(vkCreateBufferView)             \
  X(vkAllocateMemory)               \
  X(vkBindBufferMemory)             \
  X(vkMapMemory)                    \
  X(vkCreateDescriptorPool)         \
  X(vkCreateDescriptorSetLayout)    \
  X(vkAllocateDescriptorSets)       \
  X(vkCreatePipelineLayout)         \
  X(vkCreateShaderModule)           \
  X(vkCreateComputePipelines)       \
  X(vkCreateSwapchainKHR)           \
  X(vkAcquireNextImageKHR)          \
  X(vkQueuePresentKHR)

enum Function : std::size_t {
#define CANDELA_NAME(name) k_##name,
  CANDELA_INSTANCE_FUNCTIONS(CANDELA_NAME) CANDELA_DEVICE_FUNCTIONS(CANDELA_NAME) k_vkCreateInstance,
  k_vkCreateDevice,
  k_vkCmdDispatch,
  kFunctionCount
#undef CANDELA_NAME
};

#define CANDELA_NAME(name) #name,
constexpr std::array<const char*, kFunctionCount> kNames{CANDELA_INSTANCE_FUNCTIONS(CANDELA_NAME)
                                                             CANDELA_DEVICE_FUNCTIONS(CANDELA_NAME) "vkCreateInstance",
                                                         "vkCreateDevice", "vkCmdDispatch"};
#undef CANDELA_NAME

constexpr VkResult kHang = static_cast<VkResult>(1);  // no result that a function returns here
constexpr VkResult kDrop = static_cast<VkResult>(2);
constexpr VkResult kDropWide = static_cast<VkResult>(3);
constexpr std::array<std::pair<const char*, VkResult>, 19> kResults{
    {{"HANG", kHang},
     {"DROP", kDrop},
     {"DROP_WIDE", kDropWide},
     {"VK_ERROR_OUT_OF_HOST_MEMORY", VK_ERROR_OUT_OF_HOST_MEMORY},
     {"VK_ERROR_OUT_OF_DEVICE_MEMORY", VK_ERROR_OUT_OF_DEVICE_MEMORY},
     {"VK_ERROR_INITIALIZATION_FAILED", VK_ERROR_INITIALIZATION_FAILED},
     {"VK_ERROR_DEVICE_LOST", VK_ERROR_DEVICE_LOST},
     {"VK_ERROR_MEMORY_MAP_FAILED", VK_ERROR_MEMORY_MAP_FAILED},
     {"VK_ERROR_LAYER_NOT_PRESENT", VK_ERROR_LAYER_NOT_PRESENT},
     {"VK_ERROR_EXTENSION_NOT_PRESENT", VK_ERROR_EXTENSION_NOT_PRESENT},
     {"VK_ERROR_FEATURE_NOT_PRESENT", VK_ERROR_FEATURE_NOT_PRESENT},
     {"VK_ERROR_INCOMPATIBLE_DRIVER", VK_ERROR_INCOMPATIBLE_DRIVER},
     {"VK_ERROR_TOO_MANY_OBJECTS", VK_ERROR_TOO_MANY_OBJECTS},
     {"VK_ERROR_FRAGMENTED_POOL", VK_ERROR_FRAGMENTED_POOL},
     {"VK_ERROR_UNKNOWN", VK_ERROR_UNKNOWN},
     {"VK_ERROR_OUT_OF_POOL_MEMORY", VK_ERROR_OUT_OF_POOL_MEMORY},
     {"VK_ERROR_FRAGMENTATION", VK_ERROR_FRAGMENTATION},
     {"VK_TIMEOUT", VK_TIMEOUT},
     {"VK_ERROR_OUT_OF_DATE_KHR", VK_ERROR_OUT_OF_DATE_KHR}}};

struct Fault {
  std::string function;
  unsigned long first = 0;
  bool continues = false;
  VkResult result = VK_SUCCESS;
};

[[noreturn]] void refuse(const std::string& text) {
  std::fprintf(stderr, "CANDELA_FAULT: \"%s\" is not FUNCTION:N:RESULT\n", text.c_str());
  std::abort();
}

Fault parseFault(const std::string& text) {
  std::istringstream words(text);
  std::string number, result;
  Fault fault;
  std::getline(words, fault.function, ':');
  std::getline(words, number, ':');
  std::getline(words, result);
  fault.first = std::strtoul(number.c_str(), nullptr, 10);
  fault.continues = !number.empty() && number.back() == '+';
  const auto* known = std::find_if(kResults.begin(), kResults.end(), [&](auto& r) { return result == r.first; });
  const bool isFunction = std::any_of(kNames.begin(), kNames.end(), [&](auto* n) { return fault.function == n; });
  if (known == kResults.end() || !isFunction || fault.first == 0) refuse(text);
  fault.result = known->second;
  return fault;
}

std::vector<Fault> parseFaults() {
  std::vector<Fault> faults;
  const char* const value = std::getenv("CANDELA_FAULT");
  std::istringstream list(value == nullptr ? "" : value);
  for (std::string text; std::getline(list, text, ',');) faults.push_back(parseFault(text));
  return faults;
}

std::array<std::atomic<unsigned long>, kFunctionCount> calls{};

/// Returns the result that replaces this call; nothing if the call is passed on.
std::optional<VkResult> faultOf(Function function) {
  static const std::vector<Fault> faults = parseFaults();
  const unsigned long number = ++calls[function];
  for (const Fault& fault : faults) {
    const bool isDue = fault.continues ? number >= fault.first : number == fault.first;
    if (fault.function != kNames[function] || !isDue) continue;
    if (const char* const log = std::getenv("CANDELA_FAULT_LOG")) {
      std::ofstream(log, std::ios::app) << fault.function << ' ' << number << '\n';
    }
    return fault.result;
  }
  return std::nullopt;
}

void writeCounts() {
  const char* const file = std::getenv("CANDELA_FAULT_COUNTS");
  if (file == nullptr) return;
  std::ofstream output(file);
  for (std::size_t i = 0; i < kFunctionCount; ++i) output << kNames[i] << ' ' << calls[i] << '\n';
}

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
  if (instance == VK_NULL_HANDLE) return hook;
  const PFN_vkVoidFunction next = nexts.of(instance).instance(instance, name);
  return hook != nullptr && next != nullptr ? hook : next;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  return negotiate(*interface, getInstanceProcAddr, getDeviceProcAddr);
}
