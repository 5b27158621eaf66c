// Sampling of the table of emitters and point lights: docs/light-transport.md section 6. Every kind of light has a
// function that samples it from a surface, and one that returns the pdf of this sampling for a point that a ray has
// hit. The power by which lights are chosen is in the probabilities of the table. Rays never hit point lights. The pdf
// of the background is in background.glsl.
#ifndef CANDELA_LIGHTS_GLSL
#define CANDELA_LIGHTS_GLSL
#include "coat.glsl"
#include "light_tree.glsl"
#include "occlusion.glsl"
#include "primitives.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

struct LightSample {
  vec3 wi;
  vec3 emission;   // radiance towards the surface, or the irradiance if delta; not yet divided by the pdf
  float distance;  // to the sampled point
  float pdf;       // solid angle, with the choice of the light; the choice only if delta
  bool delta;      // a point, spot or directional light, which rays never hit
  vec3 point;      // the sampled point or the position; kNoPoint for a sphere or a directional light
};

const LightSample kNoLight = LightSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0, 0.0, false, kNoPoint);

// Height of the cap of directions that a sphere subtends, seen from `position`; 2 (all directions) from inside it.
float sphereCapHeight(vec3 toCentre, float radius, bool startsHere) {
  float distanceSquared = dot(toCentre, toCentre);
  float radiusSquared = radius * radius;
  if (startsHere || distanceSquared <= radiusSquared) return 2.0;
  float sinSquared = radiusSquared / distanceSquared;
  float cosine = sqrt(max(0.0, (distanceSquared - radiusSquared) / distanceSquared));
  return sinSquared / (1.0 + cosine);
}

LightSample sampleSphereLight(Light light, Surface from, vec2 u) {
  vec3 toCentre = light.position - from.position;
  float height = sphereCapHeight(toCentre, light.radius, from.slot == light.slot);
  vec3 local = sampleCap(u, height);
  vec3 wi = height == 2.0 ? local : frameAround(unit(toCentre)) * local;
  PrimitiveHit hit = hitPrimitive(withStart(rayFrom(from, wi, false)), light.slot, kSphere);
  if (hit.t >= kNoHit) return kNoLight;
  vec3 emission = light.emission;
  if (kHasCoat) {
    float cosine = abs(dot(wi, wi * hit.t - toCentre)) / light.radius;
    float weight = coatWeightAt(sceneRow(primitiveRow(light.slot) + 2u).w, kNoAttributes, vec2(0.0), vec2(0.0));
    emission *= 1.0 - coatReflectance(weight, cosine);
  }
  return LightSample(wi, emission, hit.t, light.probability * capPdf(height), false, kNoPoint);
}

// Returns the factor of the emission at a point of the triangle with these records, in a direction with this cosine to
// its normal: the texel of its texture and the vertex colour, as far as they exist, times the opacity and the
// transmittance of the coat.
vec3 emissionFactor(uvec4 rows[3], vec2 weights, float cosine, vec2 jitter) {
  uint kind = rows[2].w;
  Attributes attributes = attributesOf(rows[0].w, indexOf(rows));
  vec3 factor = vec3(1.0);
  if (kHasTextures && hasAll(attributes, kGeometryTexCoords)) {
    uint reference = textureOf(kind >> kMaterialShift, kSlotEmission);
    if (reference != 0u) factor = linearColour(textureTexel(reference, texCoordsAt(attributes, weights), jitter));
  }
  if (kHasColours && hasAll(attributes, kGeometryEmissionColours)) factor *= colourAt(attributes, weights).xyz;
  if (kHasCoat) factor *= 1.0 - coatReflectance(coatWeightAt(kind, attributes, weights, jitter), cosine);
  if (kHasTransparency && (kind & kFlagTransparent) != 0u) factor *= opacityAt(attributes, kind, weights, jitter);
  return factor;
}

LightSample sampleTriangleLight(Light light, Surface from, vec2 u) {
  if (from.slot == light.slot || (kHasLightInstances && light.area <= 0.0)) return kNoLight;
  uvec4 rows[3] = rowsOfSlot(light.slot);
  vec3 p0 = uintBitsToFloat(rows[0].xyz);
  vec3 edge1 = uintBitsToFloat(rows[1].xyz) - p0;
  vec3 edge2 = uintBitsToFloat(rows[2].xyz) - p0;
  vec2 weights = sampleTriangle(u);
  vec3 fromCorner = weights.x * edge1 + weights.y * edge2;
  vec3 toPoint = (p0 - from.position) + fromCorner;
  float distanceSquared = dot(toPoint, toPoint);
  float distance = sqrt(distanceSquared);
  vec3 wi = toPoint / distance;
  float cosine = -dot(triangleNormal(edge1, edge2), wi);
  if (cosine == 0.0 || (kOneSided && cosine < 0.0)) return kNoLight;
  vec3 emission = light.emission;
  if (kHasTextures || kHasColours || kHasCoat) {
    emission *= emissionFactor(rows, weights, abs(cosine), from.jitter.zw);
  }
  float pdf = light.probability * distanceSquared / (light.area * abs(cosine));
  return LightSample(wi, emission, distance, pdf, false, p0 + fromCorner);
}

LightSample samplePointLight(Light light, Surface from) {
  vec3 toPoint = light.position - from.position;
  float distance = sqrt(dot(toPoint, toPoint));
  if (distance == 0.0) return kNoLight;
  return LightSample(toPoint / distance, light.emission * kPi, distance, light.probability, true, light.position);
}

// The fraction of its intensity that a spot light emits along -wi; wi points towards it. 1 - cos of the angle to its
// direction is half the squared distance of the two unit vectors, without the cancellation of 1 - dot().
float spotFactor(Light light, vec3 wi) {
  vec4 cone = sceneRowFloat(lightRow(constants.lightCount) + uint(light.area));
  vec3 apart = cone.xyz + wi;
  float falloff = clamp((cone.w - 0.5 * dot(apart, apart)) * light.radius, 0.0, 1.0);
  return falloff * falloff;
}

// Point and spot lights with fall-off, and directional lights.
LightSample samplePunctualLight(Light light, Surface from) {
  if (light.kind == kLightDirectional) {
    return LightSample(light.position, light.emission, kNoHit, light.probability, true, kNoPoint);
  }
  vec3 toPoint = light.position - from.position;
  float distanceSquared = dot(toPoint, toPoint);
  float distance = sqrt(distanceSquared);
  if (distanceSquared == 0.0) return kNoLight;
  vec3 wi = toPoint / distance;
  float falloff = light.kind == kLightSpot ? spotFactor(light, wi) : 1.0;
  return LightSample(wi, light.emission * (falloff / distanceSquared), distance, light.probability, true, light.position);
}

LightSample sampleLight(Light light, Surface from, vec2 u) {
  if (kHasSphereLights && light.kind == kLightSphere) return sampleSphereLight(light, from, u);
  if (kHasTriangleLights && light.kind == kLightTriangle) return sampleTriangleLight(light, from, u);
  if (kHasPointLights && light.kind == kLightPoint) return samplePointLight(light, from);
  if (kHasPunctualLights && light.kind >= kLightPunctual) return samplePunctualLight(light, from);
  return kNoLight;
}

float sphereLightPdf(Light light, Ray ray) {
  bool startsHere = startsOn(ray, light.slot);
  return light.probability * capPdf(sphereCapHeight(light.position - ray.origin, light.radius, startsHere));
}

float triangleLightPdf(Light light, Ray ray, Surface emitter, float t) {
  return light.probability * t * t / (light.area * abs(dot(emitter.outward, ray.direction)));
}

// Returns whether a light is an instance that emits.
bool isInstance(Light light) { return light.kind == kLightTriangle && light.slot == kNoSlot; }

// Returns one of the triangles of such a light as a light.
Light triangleOfInstance(Light light, uint slot, float probability) {
  uvec4 rows[3] = rowsOfSlot(slot);
  vec3 p0 = uintBitsToFloat(rows[0].xyz);
  vec3 across = cross(uintBitsToFloat(rows[1].xyz) - p0, uintBitsToFloat(rows[2].xyz) - p0);
  light.slot = slot;
  light.area = 0.5 * sqrt(dot(across, across));
  light.probability = probability;
  return light;
}

// Chooses a light for a vertex at this depth, with the word of receiverAt(), by a 24-bit number, and by the numbers of
// the light tree if there is one. `entry` becomes its index in the light table.
Light chooseLight(vec3 position, uint receiver, uint k, SampleKey key, uint depth, out uint entry,
                  inout uint truncated) {
  if (kHasLightTree && k < sceneRow(constants.firstLightTreeRow).x) {
    LightChoice choice = walkLightTree(receiverAt(position, receiver), false, 0u, key, depth, truncated);
    entry = choice.light;
    Light light = loadLight(entry);
    light.probability = choice.probability;
    if (kHasLightInstances && isInstance(light)) {
      uint row = floatBitsToUint(light.area);
      LightChoice chosen = walkMeshTree(row, choice.probability, receiverAt(position, receiver), false, 0u, key, depth, truncated);
      light = triangleOfInstance(light, slotOfTriangle(row, chosen.light), chosen.probability);
    }
    return light;
  }
  entry = entryChosenBy(k, truncated);
  return loadLight(entry);
}

// Returns an emitter that a ray hit, with the probability with which it would have been chosen at the receiver where the
// ray starts.
Light emitterFound(Surface emitter, vec3 position, uint receiver, inout uint truncated) {
  Light light = loadLight(emitter.light - 1u);
  if (kHasLightTree) {
    uint trail = floatBitsToUint(light.probability);
    light.probability = 0.0;
    if (trail != kNoTrail) {
      light.probability = walkLightTree(receiverAt(position, receiver), true, trail, SampleKey(0u, 0u, 0u, 0u), 1u, truncated).probability;
    }
    if (kHasLightInstances && isInstance(light)) {
      uint row = floatBitsToUint(light.area);
      uvec4 rows[3] = rowsOfSlot(emitter.slot);
      uint triangle = sceneRow(geometryRow(rows[0].w) + 1u).y + indexOf(rows);
      LightChoice found = walkMeshTree(row, light.probability, receiverAt(position, receiver), true, triangle, SampleKey(0u, 0u, 0u, 0u), 1u, truncated);
      light = triangleOfInstance(light, emitter.slot, found.probability);
    }
  }
  return light;
}

// Returns the pdf with which sampleLight would have sampled, from the ray's origin, the point of an emitter that the
// ray hit at distance t.
float lightPdf(Light light, Ray ray, Surface emitter, float t) {
  if (kHasSphereLights && light.kind == kLightSphere) return sphereLightPdf(light, ray);
  return triangleLightPdf(light, ray, emitter, t);
}

#endif
