// Traversal of two levels: an 8-wide BVH over instances, whose leaves lead to the 8-wide BVHs of their meshes. Rays are
// transformed to the space of a mesh for the tests of boxes only, with a padding that host/trace/accel/instance_padding.h
// derives; primitives are tested with their vertices in the scene, so that hits are those of a copy of the mesh. All
// invocations of a subgroup traverse nodes together, whether they are in the outer BVH or in an instance.
#ifndef CANDELA_INSTANCES_GLSL
#define CANDELA_INSTANCES_GLSL

// The instance that is traversed, and what the outer BVH continues with.
struct Visit {
  uint instance;
  Placement placement;
  Ray ray;  // without its origin primitive, unless that is of this instance
  uint pendingNodes;
  uint leafHits;
  uint leafMask;
  uint firstPrimitive;
};

WideRay rayInMesh(Ray ray, uint instance) {
  uint row = instanceRow(instance) + 7u;
  vec3 x = sceneRowFloat(row).xyz;
  vec3 y = sceneRowFloat(row + 1u).xyz;
  vec3 z = sceneRowFloat(row + 2u).xyz;
  vec3 origin = ((x * ray.origin.x + y * ray.origin.y) + z * ray.origin.z) + sceneRowFloat(row + 3u).xyz;
  vec3 direction = (x * ray.direction.x + y * ray.direction.y) + z * ray.direction.z;
  vec2 padding = vec2(sceneRowFloat(instanceRow(instance) + 2u).w, sceneRowFloat(instanceRow(instance) + 3u).w);
  return wideRay(origin, direction, paddingOf(origin) + padding.x + padding.y * largest(abs(ray.origin)));
}

// Starts at the root of an instance. `number` counts the leaves of the outer BVH.
void enterInstance(inout Visit visit, inout WideRay wide, Ray ray, uint number) {
  visit.pendingNodes = pendingNodes;
  visit.leafHits = leafHits;
  visit.leafMask = leafMask;
  visit.firstPrimitive = firstPrimitive;
  visit.instance = number + 1u;
  visit.placement = loadPlacement(visit.instance);
  visit.ray = ray;
  if (ray.originInstance != visit.instance) visit.ray.originSlot |= kNoSlot;
  wide = rayInMesh(ray, visit.instance);
  insideInstance = true;
  stackFloor = stackTop;
  pendingNodes = (sceneRow(instanceRow(visit.instance) + 1u).w << 8) | (1u << wide.octant);
  leafHits = 0u;
  nonePending = false;
}

void leaveInstance(Visit visit, inout WideRay wide, Ray ray) {
  wide = wideRay(ray);
  insideInstance = false;
  stackFloor = 0u;
  pendingNodes = visit.pendingNodes;
  leafHits = visit.leafHits;
  leafMask = visit.leafMask;
  firstPrimitive = visit.firstPrimitive;
  nonePending = !anyPending(pendingNodes);
  noteWideEnd();
}

void startOuterTraversal(WideRay wide) {
  startWideTraversal(wide);
  pendingNodes |= constants.topNode << 8;
}

void closestInInstances(inout Hit hit, Ray ray, inout Work work) {
  WideRay wide = wideRay(ray);
  Visit visit;
  startOuterTraversal(wide);
  while (!isTraversed() || insideInstance) {
    descendToLeaves(wide, hit.t, work);
    if (insideInstance) {
      while (leafHits != 0u) {
        uint slot = takeLeafHit();
        uvec4 rows[3] = placedRows(visit.placement, rowsOfSlot(slot));
        keepCloser(hit, comparedHit(visit.ray, slot, rows, rows[2].w, kFinitePrimitive), slot, visit.instance);
        work.steps += 1u;
        if (kMasksLanes && leafHits == 0u) break;
      }
      if (isTraversed()) leaveInstance(visit, wide, ray);
    } else if (leafHits != 0u) {
      enterInstance(visit, wide, ray, takeLeafHit());
    }
    if (kMasksLanes && isTraversed() && !insideInstance) break;
  }
  work.truncated += wideUnfinished;
}

bool anyInInstances(Ray ray, RayEnd end, inout Work work) {
  WideRay wide = wideRay(ray);
  Visit visit;
  bool blocked = false;
  startOuterTraversal(wide);
  while ((!isTraversed() || insideInstance) && !blocked) {
    descendToLeaves(wide, end.distance, work);
    if (insideInstance) {
      while (leafHits != 0u && !blocked) {
        uint slot = takeLeafHit();
        uvec4 rows[3] = placedRows(visit.placement, rowsOfSlot(slot));
        blocked = rowsHide(visit.ray, slot, rows, rows[2].w, end, kFinitePrimitive);
        work.steps += 1u;
        if (kMasksLanes && (leafHits == 0u || blocked)) break;
      }
      if (isTraversed()) leaveInstance(visit, wide, ray);
    } else if (leafHits != 0u) {
      enterInstance(visit, wide, ray, takeLeafHit());
    }
    if (kMasksLanes && (isTraversed() && !insideInstance || blocked)) break;
  }
  work.truncated += blocked ? 0u : wideUnfinished;
  return blocked;
}

#endif
