// The faults of the layer: which calls fail, and with which result. layer.cpp says how a test states them.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "tests/trace/vulkan_support/layer.h"

namespace candela::faults {

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
inline constexpr std::array<const char*, kFunctionCount> kNames{
    CANDELA_INSTANCE_FUNCTIONS(CANDELA_NAME) CANDELA_DEVICE_FUNCTIONS(CANDELA_NAME) "vkCreateInstance",
    "vkCreateDevice", "vkCmdDispatch"};
#undef CANDELA_NAME

inline constexpr VkResult kHang = static_cast<VkResult>(1);  // no result that a function returns here
inline constexpr VkResult kDrop = static_cast<VkResult>(2);
inline constexpr VkResult kDropWide = static_cast<VkResult>(3);

/// Counts a call. Returns the result that replaces it; nothing if it is passed on. Aborts if CANDELA_FAULT is wrong.
std::optional<VkResult> faultOf(Function function);

/// Writes the number of calls of each function to the file that CANDELA_FAULT_COUNTS names, if any.
void writeCounts();

}  // namespace candela::faults
