// Numbers of the descriptors of set 0. Four storage buffers: what every Vulkan 1.2 device must offer.
#ifndef CANDELA_SHARED_BINDINGS_H
#define CANDELA_SHARED_BINDINGS_H
#include "language.h"
CANDELA_BEGIN

CANDELA_CONST uint kBindingSceneRows = 0u;    // storage buffer: the scene, 16-byte rows
CANDELA_CONST uint kBindingPathStates = 1u;   // storage buffer: PathState of each pixel of the band
CANDELA_CONST uint kBindingFilm = 2u;         // storage buffer: film rows of each pixel of the band
CANDELA_CONST uint kBindingResults = 3u;      // storage buffer: counters, then path records if asked for
CANDELA_CONST uint kBindingSceneTexels = 4u;  // the same rows as texels; only one of the two holds them
CANDELA_CONST uint kBindingUniforms = 5u;     // uniform buffer: RenderUniforms

CANDELA_END
#endif
