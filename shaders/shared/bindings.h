// Binding numbers of descriptor set 0. There are four storage buffers, the number that every Vulkan 1.2 device
// supports.
#ifndef CANDELA_SHARED_BINDINGS_H
#define CANDELA_SHARED_BINDINGS_H
#include "language.h"
CANDELA_BEGIN

CANDELA_CONST uint kBindingSceneRows = 0u;    // storage buffer: the scene, 16-byte records
CANDELA_CONST uint kBindingPathStates = 1u;   // storage buffer: PathState of each pixel of the band
CANDELA_CONST uint kBindingFilm = 2u;         // storage buffer: film of each pixel of the band
CANDELA_CONST uint kBindingResults = 3u;      // storage buffer: counters, then path records if requested
CANDELA_CONST uint kBindingSceneTexels = 4u;  // the scene's records as texels; only one of the two bindings has them
CANDELA_CONST uint kBindingUniforms = 5u;     // uniform buffer: RenderUniforms

CANDELA_END
#endif
