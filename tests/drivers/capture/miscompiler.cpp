// A Vulkan layer that changes shaders on their way to the driver, as a faulty compiler would.
//
// CANDELA_MISCOMPILE is OPCODE:N:CHANGE. In each module, the instruction N (from 0, or `all`, or %ID for the one with
// this result) with this opcode changes:
//   CHANGE a number  the opcode becomes this one
//   swap             its last two operands are exchanged
//   drop             it is removed
//   plus             its last operand, a literal, is one larger
// Opcodes are numbers of the SPIR-V specification; 12/K is instruction K of the extended set (GLSL.std.450), of which
// CHANGE is the new number. Modules without instruction N do not change.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/trace/vulkan_support/layer.h"

namespace {

using namespace candela::layer;

constexpr std::uint32_t kExtInst = 12, kHeaderWords = 5, kExtInstNumber = 4, kResult = 2;

struct Change {
  std::uint32_t opcode = 0;
  std::optional<std::uint32_t> extended;
  std::optional<unsigned long> index;  ///< absent: all
  bool isResult = false;               ///< `index` is the id of the result
  std::string kind;
};

std::optional<Change> parseChange() {
  const char* const text = std::getenv("CANDELA_MISCOMPILE");
  if (text == nullptr) return std::nullopt;
  std::istringstream words(text);
  std::string opcode, index;
  Change change;
  std::getline(words, opcode, ':');
  std::getline(words, index, ':');
  std::getline(words, change.kind);
  change.opcode = static_cast<std::uint32_t>(std::stoul(opcode));
  if (const auto slash = opcode.find('/'); slash != std::string::npos) {
    change.extended = static_cast<std::uint32_t>(std::stoul(opcode.substr(slash + 1)));
  }
  change.isResult = index.front() == '%';
  if (index != "all") change.index = std::stoul(index.substr(change.isResult ? 1 : 0));
  return change;
}

using Words = std::vector<std::uint32_t>;

void apply(const Change& change, Words& instruction) {
  if (change.kind == "swap") {
    std::swap(instruction[instruction.size() - 1], instruction[instruction.size() - 2]);
  } else if (change.kind == "drop") {
    instruction.clear();
  } else if (change.kind == "plus") {
    ++instruction.back();
  } else if (change.extended) {
    instruction[kExtInstNumber] = static_cast<std::uint32_t>(std::stoul(change.kind));
  } else {
    instruction[0] = (instruction[0] & 0xffff0000u) | static_cast<std::uint32_t>(std::stoul(change.kind));
  }
}

bool isMeant(const Change& change, const Words& instruction) {
  if ((instruction[0] & 0xffffu) != change.opcode) return false;
  return !change.extended || (change.opcode == kExtInst && instruction[kExtInstNumber] == *change.extended);
}

Words changed(const std::uint32_t* code, std::size_t count, const Change& change) {
  Words result(code, code + kHeaderWords);
  unsigned long seen = 0;
  for (std::size_t at = kHeaderWords; at < count; at += code[at] >> 16) {
    Words instruction(code + at, code + at + (code[at] >> 16));
    if (isMeant(change, instruction)) {
      const unsigned long number = change.isResult ? instruction[kResult] : seen++;
      if (number == change.index || !change.index) apply(change, instruction);
    }
    result.insert(result.end(), instruction.begin(), instruction.end());
  }
  return result;
}

struct Next : NextFunctions {
  PFN_vkVoidFunction create = nullptr;  ///< vkCreateDevice or vkCreateShaderModule
};
NextTable<Next> nexts;

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
  const PFN_vkGetInstanceProcAddr get = followLink(info);
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(get(nullptr, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  nexts.set(*instance, {{get(*instance, "vkDestroyInstance"), get, nullptr}, get(*instance, "vkCreateDevice")});
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physicalDevice, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  const PFN_vkGetDeviceProcAddr get = followLink(info);
  const VkResult result = reinterpret_cast<PFN_vkCreateDevice>(nexts.of(physicalDevice).create)(physicalDevice, info,
                                                                                                allocator, device);
  if (result != VK_SUCCESS) return result;
  nexts.set(*device, {{get(*device, "vkDestroyDevice"), nullptr, get}, get(*device, "vkCreateShaderModule")});
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkShaderModule* module) {
  static const std::optional<Change> change = parseChange();
  VkShaderModuleCreateInfo other = *info;
  Words code;
  if (change) {
    code = changed(info->pCode, info->codeSize / sizeof(std::uint32_t), *change);
    other.pCode = code.data();
    other.codeSize = code.size() * sizeof(std::uint32_t);
  }
  return reinterpret_cast<PFN_vkCreateShaderModule>(nexts.of(device).create)(device, &other, allocator, module);
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance, const VkAllocationCallbacks* allocator) {
  if (instance == VK_NULL_HANDLE) return;
  reinterpret_cast<PFN_vkDestroyInstance>(nexts.take(instance).destroy)(instance, allocator);
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* allocator) {
  if (device == VK_NULL_HANDLE) return;
  reinterpret_cast<PFN_vkDestroyDevice>(nexts.take(device).destroy)(device, allocator);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name);

PFN_vkVoidFunction deviceHook(std::string_view name) {
  if (name == "vkCreateShaderModule") return erased(createShaderModule);
  if (name == "vkDestroyDevice") return erased(destroyDevice);
  if (name == "vkGetDeviceProcAddr") return erased(getDeviceProcAddr);
  return nullptr;
}

PFN_vkVoidFunction instanceHook(std::string_view name) {
  if (name == "vkCreateInstance") return erased(createInstance);
  if (name == "vkDestroyInstance") return erased(destroyInstance);
  if (name == "vkCreateDevice") return erased(createDevice);
  if (name == "vkGetInstanceProcAddr") return erased(getInstanceProcAddr);
  return deviceHook(name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
  const PFN_vkVoidFunction hook = deviceHook(name);
  return hook != nullptr ? hook : nexts.of(device).device(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
  const PFN_vkVoidFunction hook = instanceHook(name);
  if (hook != nullptr || instance == VK_NULL_HANDLE) return hook;
  return nexts.of(instance).instance(instance, name);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  return negotiate(*interface, getInstanceProcAddr, getDeviceProcAddr);
}
