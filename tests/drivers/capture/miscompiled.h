// The environment of a program whose shaders a faulty compiler changes.
#pragma once
#include <string>
#include <vector>

namespace candela {

/// Returns the environment in which the layer of miscompiler.cpp makes a change, as CANDELA_MISCOMPILE states it.
inline std::vector<std::string> miscompiled(const std::string& change) {
  return {"VK_LAYER_PATH=" CANDELA_MISCOMPILER_LAYERS, "VK_INSTANCE_LAYERS=VK_LAYER_CANDELA_miscompiler",
          "CANDELA_MISCOMPILE=" + change};
}

}  // namespace candela
