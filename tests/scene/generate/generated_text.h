// Generated scenes, as text and as the loader reads them.
#pragma once
#include <string>

#include "host/formats/loading/load.h"
#include "host/scene/generate/kinds.h"

namespace candela {

const generate::Kind& kindNamed(const std::string& name);
std::string generatedText(const std::string& kind, std::uint32_t size);
/// Read strictly.
scene::LoadedScene generatedScene(const std::string& kind, std::uint32_t size);

}  // namespace candela
