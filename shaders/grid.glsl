// 3D-DDA through the uniform grid along a driving axis (Fujimoto, Tanaka and Iwata, "ARTS", IEEE CG&A 1986).
// host/accel/grid.h says why it misses no hit. Each slice of cells is computed from its number alone, so that no rounding
// adds up. A turn of the loop may take a lane to its next cell and test the first primitive there: cells hold so few that
// lanes which look for cells while others test would wait for them more often than not (docs/performance.md).
#ifndef CANDELA_GRID_GLSL
#define CANDELA_GRID_GLSL

// The one walk that a lane has under way. Vectors have the driving axis first: that on which the ray crosses most cells.
struct GridWalk {
  vec3 origin;
  vec3 direction;
  vec3 low;          // of the grid
  vec3 scale;        // cells per unit of length
  vec3 lastCell;     // on each axis, counted from 0
  uvec3 strides;
  float pad;
  float nearOrigin;  // the driving coordinate as the planes that the ray comes to first want it, and the others
  float farOrigin;
  float inverse;
  float width;       // of a slice
  float start;       // the ray is within the grid from this distance on
  float exit;        // to this one
  int slice;
  uvec2 firstCell;   // those of the slice's cells that the ray may touch
  uvec2 endCell;     // the last of them
  uvec2 cell;
  uint item;         // of the cell's items the next, and the end
  uint itemEnd;
  bool finished;
  uint unfinished;   // 1 until the walk ends: docs/driver-workarounds.md section 4
};

GridWalk walk;

vec3 drivingFirst(vec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }
uvec3 drivingFirst(uvec3 v, int driving) { return driving == 0 ? v : driving == 1 ? v.yzx : v.zxy; }

// Where the ray is within the grid's bounds, widened by the walk's pad.
void clipToGrid(Ray ray) {
  vec3 inverse = inverseDirection(ray.direction);
  vec3 t0 = (constants.gridLow - (ray.origin + walk.pad)) * inverse;
  vec3 t1 = (constants.gridHigh - (ray.origin - walk.pad)) * inverse;
  vec3 far = max(t0, t1);
  walk.start = max(largest(min(t0, t1)), 0.0);
  walk.exit = min(far.x, min(far.y, far.z));
}

// The slice before the first: nextCell() enters the first one.
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

// The host's cellAt(), on the two axes across the driving one.
uvec2 cellsAt(vec2 x) { return uvec2(clamp((x - walk.low.yz) * walk.scale.yz, vec2(0.0), walk.lastCell.yz)); }

void enterNextSlice(float limit) {
  bool backward = walk.inverse < 0.0;
  walk.slice += backward ? -1 : 1;
  float low = walk.low.x + float(walk.slice) * walk.width;
  float high = walk.low.x + float(walk.slice + 1) * walk.width;
  float enter = ((backward ? high : low) - walk.nearOrigin) * walk.inverse;
  float leave = ((backward ? low : high) - walk.farOrigin) * walk.inverse;
  float end = min(walk.exit, limit);
  walk.finished = max(enter, walk.start) > end || walk.slice < 0 || float(walk.slice) > walk.lastCell.x;
  walk.unfinished = walk.finished ? 0u : 1u;
  vec2 from = walk.origin.yz + max(min(enter, end), walk.start) * walk.direction.yz;
  vec2 to = walk.origin.yz + max(min(leave, end), walk.start) * walk.direction.yz;
  walk.firstCell = cellsAt(min(from, to) - walk.pad);
  walk.endCell = cellsAt(max(from, to) + walk.pad);
  walk.cell = walk.firstCell;
}

// Rows of starts hold three cells each: their starts and the end of the last, so that a cell takes one load.
void loadCell() {
  uint cell = uint(walk.slice) * walk.strides.x + walk.cell.x * walk.strides.y + walk.cell.y * walk.strides.z;
  uint row = cell / kCellsPerRow;
  uint place = cell - kCellsPerRow * row;
  uvec4 starts = sceneRow(constants.firstStructureRow + row);
  walk.item = place == 0u ? starts.x : place == 1u ? starts.y : starts.z;
  walk.itemEnd = place == 0u ? starts.y : place == 1u ? starts.z : starts.w;
}

// Goes to the next cell that the ray may touch before `limit`, or ends the walk.
void nextCell(float limit) {
  bool lineDone = walk.cell.x == walk.endCell.x;
  bool sliceDone = lineDone && walk.cell.y == walk.endCell.y;
  walk.cell = lineDone ? uvec2(walk.firstCell.x, walk.cell.y + 1u) : uvec2(walk.cell.x + 1u, walk.cell.y);
  if (sliceDone) enterNextSlice(limit);
  if (!walk.finished) loadCell();
}

uint gridItem(uint item) {
  uvec4 row = sceneRow(constants.firstItemRow + item / kItemsPerRow);
  uint place = item % kItemsPerRow;
  return place < 2u ? (place == 0u ? row.x : row.y) : (place == 2u ? row.z : row.w);
}

// One turn: on to the next cell where the last one has no more to test.
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

bool anyInGrid(Ray ray, uint ignored, float limit, inout Work work) {
  bool blocked = false;
  startWalk(ray);
  while (!walk.finished && !blocked) {
    seekItem(limit, work);
    if (hasItem()) {
      uint slot = takeItem(work);
      blocked = slot != ignored && hitPrimitive(ray, slot).t < limit;
    }
    if (walk.finished || blocked) break;
  }
  work.truncated += blocked ? 0u : walk.unfinished;
  return blocked;
}

#endif
