// The loader of scenes of Mitsuba 3, and of Mitsuba 0.6 where it spells things differently.
#pragma once
#include "host/formats/loading/loader.h"

namespace candela::mitsuba {

/// Returns a loader that recognises files by their first tag, <scene>. docs/mitsuba.md lists what is rendered.
scene::Loader mitsubaLoader();

}  // namespace candela::mitsuba
