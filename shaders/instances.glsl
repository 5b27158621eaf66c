// Traversal of two levels: an 8-wide BVH over instances, whose leaves lead to the 8-wide BVHs of their meshes. Rays are
// transformed to the space of a mesh for the tests of boxes only, with a padding that host/trace/accel/instance_padding.h
// derives; primitives are tested with their vertices in the scene, so that hits are those of a copy of the mesh. All
// invocations of a subgroup traverse nodes together, whether they are in the outer BVH or in an instance.
#ifndef CANDELA_INSTANCES_GLSL
#define CANDELA_INSTANCES_GLSL

// The instance that is traversed. Lanes of a processor have its placement and what the outer BVH continues with in
// variables. GPUs read the placement for each test, and have the rest on the stack.
struct Visit {
  uint instance;
  Placement placement;
  uvec4 outer;  // pendingNodes, leafHits, leafMask, firstPrimitive
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

void pushOuter(uvec4 outer) {
  setStackWord(stackTop, outer.x);
  setStackWord(stackTop + 1u, outer.y);
  setStackWord(stackTop + 2u, outer.z);
  setStackWord(stackTop + 3u, outer.w);
  stackTop += 4u;
}

uvec4 popOuter() {
  stackTop -= 4u;
  return uvec4(stackWord(stackTop), stackWord(stackTop + 1u), stackWord(stackTop + 2u), stackWord(stackTop + 3u));
}

// Starts at the root of an instance. `number` counts the leaves of the outer BVH.
void enterInstance(inout Visit visit, inout WideRay wide, Ray ray, uint number) {
  uvec4 outer = uvec4(pendingNodes, leafHits, leafMask, firstPrimitive);
  visit.instance = number + 1u;
  if (kMasksLanes) {
    visit.placement = loadPlacement(visit.instance);
    visit.outer = outer;
  } else {
    pushOuter(outer);
  }
  wide = rayInMesh(ray, visit.instance);
  insideInstance = true;
  stackFloor = stackTop;
  pendingNodes = (sceneRow(instanceRow(visit.instance) + 1u).w << 8) | (1u << wide.octant);
  leafHits = 0u;
  nonePending = false;
}

void leaveInstance(Visit visit, inout WideRay wide, Ray ray) {
  wide = wideRay(sameRay(ray));
  insideInstance = false;
  stackFloor = 0u;
  uvec4 outer = kMasksLanes ? visit.outer : popOuter();
  pendingNodes = outer.x;
  leafHits = outer.y;
  leafMask = outer.z;
  firstPrimitive = outer.w;
  nonePending = !anyPending(pendingNodes);
  noteWideEnd();
}

// Returns the ray without its origin primitive, unless that is of this instance: instances of a mesh share slots.
Ray rayInInstance(Ray ray, uint instance) {
  if (ray.originInstance != instance) ray.originSlot |= kNoSlot;
  return ray;
}

uvec4[3] rowsInInstance(uint slot, Visit visit) {
  if (kMasksLanes) return placedRows(visit.placement, rowsOfSlot(slot));
  return placedRows(loadPlacement(visit.instance), rowsOfSlot(slot));
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
        uvec4 rows[3] = rowsInInstance(slot, visit);
        PrimitiveHit found = comparedHit(rayInInstance(ray, visit.instance), slot, rows, rows[2].w, kFinitePrimitive);
        keepCloser(hit, found, slot, visit.instance);
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
        uvec4 rows[3] = rowsInInstance(slot, visit);
        blocked = rowsHide(rayInInstance(ray, visit.instance), slot, rows, rows[2].w, end, kFinitePrimitive);
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
