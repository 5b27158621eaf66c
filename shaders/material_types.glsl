// The parameters of materials, and the lobes that they give: docs/light-transport.md section 5.
#ifndef CANDELA_MATERIAL_TYPES_GLSL
#define CANDELA_MATERIAL_TYPES_GLSL
#include "../lists/surface_parameters.h"

// The parameters of a surface (docs/light-transport.md section 5.1): the entries of CANDELA_SURFACE_PARAMETERS, and what
// has another form than in scene::SurfaceParameters.
struct SurfaceParameters {
#define DECLARE_COLOUR(name, value, record) vec3 name;
#define DECLARE_NUMBER(name, value, record, lane) float name;
#define DECLARE_FLAG(name, value) bool name;
  CANDELA_SURFACE_PARAMETERS(DECLARE_COLOUR, DECLARE_NUMBER, DECLARE_FLAG)
#undef DECLARE_COLOUR
#undef DECLARE_NUMBER
#undef DECLARE_FLAG
  vec2 rotation;      // cosine and sine of the rotation of the anisotropy
  bool isCoatAlone;   // the layers below the coat do not count
  bool lacksDiffuse;  // the diffuse lobe does not count, only those beside it
  bool isConductor;
  vec3 eta;    // complex index of refraction of a conductor
  vec3 kappa;
  vec4 plastic;  // the record of plastic or of a bare interface: scene_rows.h
};

// A thin film on a dielectric, as seen from one direction: section 5.11.
struct FilmOnGlass {
  float weight;
  vec3 reflectance;
  vec3 absorbed;  // by the dielectric beside the film, at normal incidence: it neither reflects nor transmits this light
};

// The part of a surface that reflects and transmits light: section 5.5.
struct Glass {
  bool isThin;
  float eta;         // index of refraction beyond the surface, relative to wo's side
  vec3 all;          // factor of the microfacets with a reflectance of 1
  vec3 transmitted;  // factor of the microfacets with a transmittance of 1
  vec3 normal;       // reflectance at normal incidence, and its rise to grazing angles
  vec3 grazing;
  vec3 absorbed;     // of FilmOnGlass
};

// The boundary of plastic, as seen from one direction: section 5.14.
struct Plastic {
  uint kind;        // kPlastic...
  float ior;
  float exitFactor; // of the transmittance, for the light that leaves the base
  uint firstRow;    // of the transmittances
};

// The lobes of a surface as seen from one direction: section 5.4.
struct SurfaceLobes {
  vec3 diffuse;         // albedo
  vec3 specular;        // factor of the microfacets at normal incidence
  vec3 grazing;         // factor of (1 - wo.h)^5
  vec2 alpha;           // along x and y
  float diffuseProbability;   // probabilities of the lobes
  float specularProbability;
  float glassProbability;
  Glass glass;
  float coat;           // factor of the coat's microfacets
  float coatAlpha;
  float coatProbability;      // probability of the coat, and the light that it takes from the lobes below
  vec3 sheen;           // factor of the fibres
  float sheenAlpha;
  float sheenLambda;    // masking for wo
  float sheenProbability;     // probability of the sheen
  float belowSheen;     // the light that the sheen leaves for the lobes below
  vec3 conductor;       // factor of conductorReflectance()
  vec3 eta;
  vec3 kappa;
  Plastic plastic;      // with it, `specular` is the factor of its boundary, and `grazing` does not count
};

struct Material {
  bool isSurface;  // `surface` and `lobes` count, and not the members from `diffuse` on, except for the emission
  SurfaceParameters surface;
  uint volume;         // number of the volume that the surface bounds; 0: none
  SurfaceLobes lobes;  // computed by prepareLobes(); with dispersion, those of `channel`
  bool outside;        // argument of prepareLobes()
  uint channel;        // of the index of refraction by which a direction is sampled
  vec3 channelProbabilities;  // probabilities of the channels
  vec3 diffuse;
  float diffuseWeight;
  vec3 glossy;
  float glossyWeight;
  vec3 specular;  // colour of the dielectric or mirror lobe
  vec3 emission;
  float dielectricWeight;
  float exponent;
  float ior;
  bool mirror;
};

#endif
