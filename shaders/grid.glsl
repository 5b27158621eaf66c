// 3D-DDA through the uniform grid along a driving axis (Fujimoto, Tanaka and Iwata, "ARTS", IEEE CG&A 1986).
// host/accel/grid.h explains why no hit is lost. Each slice of cells is computed from its index alone, so that rounding
// errors do not accumulate. One iteration of the loop may both step to the next cell and test the first primitive
// there: cells hold so few primitives that invocations looking for cells would usually have to wait for invocations
// testing primitives (docs/performance-journal.md, "Grids").
#ifndef CANDELA_GRID_GLSL
#define CANDELA_GRID_GLSL

// State of the invocation's current grid traversal. Vectors have the driving axis first, which is the axis on which the
// ray crosses most cells.
struct GridWalk {
  vec3 origin;
  vec3 direction;
  vec3 low;          // lower corner of the grid
  vec3 scale;        // cells per unit of length
  vec3 lastCell;     // on each axis, from 0
  uvec3 strides;
  float pad;
  float nearOrigin;  // driving coordinate of the origin, padded for the near and the far planes of slices
  float farOrigin;
  float inverse;
  float width;       // thickness of a slice
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

GridWalk walk;

vec3 drivingFirst(vec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }
uvec3 drivingFirst(uvec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }

// Computes the distances at which the ray enters and exits the grid's bounds, widened by the traversal's pad.
void clipToGrid(Ray ray) {
  vec3 inverse = inverseDirection(ray.direction);
  vec3 t0 = (constants.gridLow - (ray.origin + walk.pad)) * inverse;
  vec3 t1 = (constants.gridHigh - (ray.origin - walk.pad)) * inverse;
  vec3 far = max(t0, t1);
  walk.start = max(largest(min(t0, t1)), 0.0);
  walk.exit = min(far.x, min(far.y, far.z));
}

// Starts at the slice before the first; nextCell() then enters the first one.
void startSlices() {
  float signedPad = walk.inverse < 0.0 ? -walk.pad : walk.pad;
  walk.nearOrigin = walk.origin.x + signedPad;
  walk.farOrigin = walk.origin.x - signedPad;
  float first = walk.farOrigin + walk.start * walk.direction.x;
  walk.slice = int(clamp((first - walk.low.x) * walk.scale.x, 0.0, walk.lastCell.x));
  walk.slice -= walk.inverse < 0.0 ? -1 : 1;
  walk.firstCell = uvec2(0u);
  walk.endCell = walk.firstCell;
  walk.cell = walk.firstCell;
}

void startWalk(Ray ray) {
  walk.pad = (largest(abs(ray.origin)) + constants.gridReach) * (1.0 / 524288.0);
  clipToGrid(ray);
  vec3 crossed = abs(ray.direction) * constants.gridScale;
  int driving = crossed.x >= crossed.y && crossed.x >= crossed.z ? 0 : crossed.y >= crossed.z ? 1 : 2;
  walk.origin = drivingFirst(ray.origin, driving);
  walk.direction = drivingFirst(ray.direction, driving);
  walk.inverse = inverseDirection(walk.direction).x;
  walk.low = drivingFirst(constants.gridLow, driving);
  walk.scale = drivingFirst(constants.gridScale, driving);
  walk.width = drivingFirst(constants.gridWidth, driving).x;
  walk.lastCell = vec3(drivingFirst(constants.gridSides, driving) - 1u);
  walk.strides = drivingFirst(constants.gridStrides, driving);
  startSlices();
  walk.item = 0u;
  walk.itemEnd = 0u;
  walk.finished = walk.start > walk.exit;
  walk.unfinished = walk.finished ? 0u : 1u;
}

// The counterpart of the host's cellAt(), on the two axes other than the driving one.
uvec2 cellsAt(vec2 x) { return uvec2(clamp((x - walk.low.yz) * walk.scale.yz, vec2(0.0), walk.lastCell.yz)); }

void enterNextSlice(float limit) {
  bool backward = walk.inverse < 0.0;
  walk.slice += backward ? -1 : 1;
  float low = walk.low.x + float(walk.slice) * walk.width;
  float high = walk.low.x + float(walk.slice + 1) * walk.width;
  float enter = ((backward ? high : low) - walk.nearOrigin) * walk.inverse;
  float exit = ((backward ? low : high) - walk.farOrigin) * walk.inverse;
  float end = min(walk.exit, limit);
  walk.finished = max(enter, walk.start) > end || walk.slice < 0 || float(walk.slice) > walk.lastCell.x;
  walk.unfinished = walk.finished ? 0u : 1u;
  vec2 from = walk.origin.yz + max(min(enter, end), walk.start) * walk.direction.yz;
  vec2 to = walk.origin.yz + max(min(exit, end), walk.start) * walk.direction.yz;
  walk.firstCell = cellsAt(min(from, to) - walk.pad);
  walk.endCell = cellsAt(max(from, to) + walk.pad);
  walk.cell = walk.firstCell;
}

// Loads the range of the cell's items. A record of cells stores the starts of three cells and the end of the last, so
// that a cell takes one load.
void loadCell() {
  uint cell = uint(walk.slice) * walk.strides.x + walk.cell.x * walk.strides.y + walk.cell.y * walk.strides.z;
  uint row = cell / kCellsPerRow;
  uint index = cell - kCellsPerRow * row;
  uvec4 starts = sceneRow(constants.firstStructureRow + row);
  walk.item = index == 0u ? starts.x : index == 1u ? starts.y : starts.z;
  walk.itemEnd = index == 0u ? starts.y : index == 1u ? starts.z : starts.w;
}

// Steps to the next cell that the ray may touch before `limit`, or ends the traversal.
void nextCell(float limit) {
  bool lineDone = walk.cell.x == walk.endCell.x;
  bool sliceDone = lineDone && walk.cell.y == walk.endCell.y;
  walk.cell = lineDone ? uvec2(walk.firstCell.x, walk.cell.y + 1u) : uvec2(walk.cell.x + 1u, walk.cell.y);
  if (sliceDone) enterNextSlice(limit);
  if (!walk.finished) loadCell();
}

uint gridItem(uint item) {
  uvec4 row = sceneRow(constants.firstItemRow + item / kItemsPerRow);
  uint index = item % kItemsPerRow;
  return index < 2u ? (index == 0u ? row.x : row.y) : (index == 2u ? row.z : row.w);
}

// Performs one iteration: steps to the next cell if the current one has no more items.
void seekItem(float limit, inout Work work) {
  if (walk.item == walk.itemEnd) {
    nextCell(limit);
    work.steps += 1u;
  }
}

bool hasItem() { return !walk.finished && walk.item < walk.itemEnd; }

uint takeItem(inout Work work) {
  work.steps += 1u;
  ++walk.item;
  return gridItem(walk.item - 1u);
}

void closestInGrid(inout Hit hit, Ray ray, inout Work work) {
  startWalk(ray);
  while (!walk.finished) {
    seekItem(hit.t, work);
    if (hasItem()) {
      uint slot = takeItem(work);
      keepCloser(hit, hitPrimitive(ray, slot), slot);
    }
    if (walk.finished) break;
  }
  work.truncated += walk.unfinished;
}

bool anyInGrid(Ray ray, RayEnd end, inout Work work) {
  bool blocked = false;
  startWalk(ray);
  while (!walk.finished && !blocked) {
    seekItem(end.distance, work);
    if (hasItem()) {
      uint slot = takeItem(work);
      blocked = occludes(ray, slot, end);
    }
    if (walk.finished || blocked) break;
  }
  work.truncated += blocked ? 0u : walk.unfinished;
  return blocked;
}

#endif
