// The precompiled header of host/trace/vulkan, the only folder that includes Vulkan headers: vulkan_raii.hpp alone
// takes 10 s to compile.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>
