// Macros and types that let GLSL and C++ read the same declarations: GLSL's type names for C++, and one word for
// constants.
#ifndef CANDELA_SHARED_LANGUAGE_H
#define CANDELA_SHARED_LANGUAGE_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define CANDELA_CONST inline constexpr
#define CANDELA_BEGIN namespace candela::gpu {
#define CANDELA_END }
namespace candela::gpu {
using uint = std::uint32_t;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using uvec2 = glm::uvec2;
using uvec3 = glm::uvec3;
using uvec4 = glm::uvec4;
}  // namespace candela::gpu
#else
#define CANDELA_CONST const
#define CANDELA_BEGIN
#define CANDELA_END
#endif

#endif
