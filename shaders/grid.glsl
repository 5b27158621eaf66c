// 3D-DDA through the uniform grid along a driving axis (Fujimoto, Tanaka and Iwata, "ARTS", IEEE CG&A 1986).
// host/trace/accel/grid.h explains why no hit is lost. Each slice of cells is computed from its index alone, so that rounding
// errors do not accumulate. One iteration of the loop may both step to the next cell and test the first primitive
// there: cells hold so few primitives that invocations looking for cells would usually have to wait for invocations
// testing primitives (docs/performance-journal.md, "Grids").
#ifndef CANDELA_GRID_GLSL
#define CANDELA_GRID_GLSL

// State of the invocation's current grid traversal. Vectors have the driving axis first, which is the axis on which the
// ray crosses most cells. Lanes of a processor have the members of GridRay in variables. GPUs compute them where they
// are used, and have registers for more rays.
struct GridRay {
  vec3 origin;
  vec3 direction;
  vec3 low;       // lower corner of the grid
  vec3 scale;     // cells per unit of length
  vec3 lastCell;  // on each axis, from 0
  uvec3 strides;
  float width;    // thickness of a slice
  float nearOrigin;  // driving coordinate of the origin, padded for the near and the far planes of slices
  float farOrigin;
};

struct GridTraversal {
  int driving;
  GridRay ray;
  float pad;
  float inverse;     // of the driving component of the direction
  float start;       // distance at which the ray enters the grid
  float exit;        // distance at which it exits
  int slice;
  uvec2 firstCell;   // first and last cell of the slice that the ray may touch
  uvec2 endCell;     // the last one is included
  uvec2 cell;
  uint item;         // next item of the cell, and the end of its items
  uint itemEnd;
  bool finished;
  uint unfinished;   // 1 until the traversal ends: docs/driver-workarounds.md section 4
};

GridTraversal traversal;

vec3 drivingFirst(vec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }
uvec3 drivingFirst(uvec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }

GridRay gridRay(Ray ray, int driving) {
  vec3 origin = drivingFirst(ray.origin, driving);
  vec3 direction = drivingFirst(ray.direction, driving);
  float signedPad = direction.x < 0.0 ? -traversal.pad : traversal.pad;
  return GridRay(origin, direction, drivingFirst(constants.gridLow, driving), drivingFirst(constants.gridScale, driving),
                 vec3(drivingFirst(constants.gridSides, driving) - 1u), drivingFirst(constants.gridStrides, driving),
                 drivingFirst(constants.gridWidth, driving).x, origin.x + signedPad, origin.x - signedPad);
}

GridRay gridRayOf(Ray ray) {
  if (kMasksLanes) return traversal.ray;
  return gridRay(ray, traversal.driving);
}

// Computes the distances at which the ray enters and exits the grid's bounds, widened by the traversal's pad.
void clipToGrid(Ray ray) {
  vec3 inverse = inverseDirection(ray.direction);
  vec3 t0 = (constants.gridLow - (ray.origin + traversal.pad)) * inverse;
  vec3 t1 = (constants.gridHigh - (ray.origin - traversal.pad)) * inverse;
  vec3 far = max(t0, t1);
  traversal.start = max(largest(min(t0, t1)), 0.0);
  traversal.exit = min(far.x, min(far.y, far.z));
}

// Starts at the slice before the first; nextCell() then enters the first one.
void startSlices(GridRay ray) {
  float first = ray.farOrigin + traversal.start * ray.direction.x;
  traversal.slice = int(clamp((first - ray.low.x) * ray.scale.x, 0.0, ray.lastCell.x));
  traversal.slice -= traversal.inverse < 0.0 ? -1 : 1;
  traversal.firstCell = uvec2(0u);
  traversal.endCell = traversal.firstCell;
  traversal.cell = traversal.firstCell;
}

void startWalk(Ray ray) {
  traversal.pad = (largest(abs(ray.origin)) + constants.gridReach) * (1.0 / 524288.0);
  clipToGrid(ray);
  vec3 crossed = abs(ray.direction) * constants.gridScale;
  traversal.driving = crossed.x >= crossed.y && crossed.x >= crossed.z ? 0 : crossed.y >= crossed.z ? 1 : 2;
  GridRay driven = gridRay(ray, traversal.driving);
  if (kMasksLanes) traversal.ray = driven;
  traversal.inverse = inverseDirection(driven.direction).x;
  startSlices(driven);
  traversal.item = 0u;
  traversal.itemEnd = 0u;
  traversal.finished = traversal.start > traversal.exit;
  traversal.unfinished = traversal.finished ? 0u : 1u;
}

// The counterpart of the host's cellAt(), on the two axes other than the driving one.
uvec2 cellsAt(GridRay ray, vec2 x) { return uvec2(clamp((x - ray.low.yz) * ray.scale.yz, vec2(0.0), ray.lastCell.yz)); }

void enterNextSlice(GridRay ray, float limit) {
  bool backward = traversal.inverse < 0.0;
  traversal.slice += backward ? -1 : 1;
  float low = ray.low.x + float(traversal.slice) * ray.width;
  float high = ray.low.x + float(traversal.slice + 1) * ray.width;
  float enter = ((backward ? high : low) - ray.nearOrigin) * traversal.inverse;
  float exit = ((backward ? low : high) - ray.farOrigin) * traversal.inverse;
  float end = min(traversal.exit, limit);
  traversal.finished = max(enter, traversal.start) > end || traversal.slice < 0 || float(traversal.slice) > ray.lastCell.x;
  traversal.unfinished = traversal.finished ? 0u : 1u;
  vec2 from = ray.origin.yz + max(min(enter, end), traversal.start) * ray.direction.yz;
  vec2 to = ray.origin.yz + max(min(exit, end), traversal.start) * ray.direction.yz;
  traversal.firstCell = cellsAt(ray, min(from, to) - traversal.pad);
  traversal.endCell = cellsAt(ray, max(from, to) + traversal.pad);
  traversal.cell = traversal.firstCell;
}

// Loads the range of the cell's items. A record of cells stores the starts of three cells and the end of the last, so
// that a cell takes one load.
void loadCell(uvec3 strides) {
  uint cell = uint(traversal.slice) * strides.x + traversal.cell.x * strides.y + traversal.cell.y * strides.z;
  uint row = cell / kCellsPerRow;
  uint index = cell - kCellsPerRow * row;
  uvec4 starts = sceneRow(constants.firstStructureRow + row);
  traversal.item = index == 0u ? starts.x : index == 1u ? starts.y : starts.z;
  traversal.itemEnd = index == 0u ? starts.y : index == 1u ? starts.z : starts.w;
}

// Steps to the next cell that the ray may touch before `limit`, or ends the traversal.
void nextCell(Ray ray, float limit) {
  GridRay driven = gridRayOf(ray);
  bool lineDone = traversal.cell.x == traversal.endCell.x;
  bool sliceDone = lineDone && traversal.cell.y == traversal.endCell.y;
  traversal.cell = lineDone ? uvec2(traversal.firstCell.x, traversal.cell.y + 1u) : uvec2(traversal.cell.x + 1u, traversal.cell.y);
  if (sliceDone) enterNextSlice(driven, limit);
  if (!traversal.finished) loadCell(driven.strides);
}

uint gridItem(uint item) {
  uvec4 row = sceneRow(constants.firstItemRow + item / kItemsPerRow);
  uint index = item % kItemsPerRow;
  return index < 2u ? (index == 0u ? row.x : row.y) : (index == 2u ? row.z : row.w);
}

// Performs one iteration: steps to the next cell if the current one has no more items.
void seekItem(Ray ray, float limit, inout Work work) {
  if (traversal.item == traversal.itemEnd) {
    nextCell(ray, limit);
    work.steps += 1u;
  }
}

bool hasItem() { return !traversal.finished && traversal.item < traversal.itemEnd; }

uint takeItem(inout Work work) {
  work.steps += 1u;
  ++traversal.item;
  return gridItem(traversal.item - 1u);
}

void closestInGrid(inout Hit hit, Ray ray, inout Work work) {
  startWalk(ray);
  while (!traversal.finished) {
    seekItem(ray, hit.t, work);
    if (hasItem()) {
      uint slot = takeItem(work);
      keepCloser(hit, hitPrimitive(ray, slot, kFinitePrimitive), slot, 0u);
    }
    if (kMasksLanes && traversal.finished) break;
  }
  work.truncated += traversal.unfinished;
}

bool anyInGrid(Ray ray, RayEnd end, inout Work work) {
  bool blocked = false;
  startWalk(ray);
  while (!traversal.finished && !blocked) {
    seekItem(ray, end.distance, work);
    if (hasItem()) {
      uint slot = takeItem(work);
      blocked = occludes(ray, slot, end, kFinitePrimitive);
    }
    if (kMasksLanes && (traversal.finished || blocked)) break;
  }
  work.truncated += blocked ? 0u : traversal.unfinished;
  return blocked;
}

#endif
