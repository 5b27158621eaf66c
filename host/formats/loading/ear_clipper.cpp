// Ear clipping of one polygon in the plane (Meisters 1975), with a queue of ears, so that it takes quadratic time.
#include "host/formats/loading/ear_clipper.h"

namespace candela::scene {

EarClipper::EarClipper(std::vector<glm::dvec2> points)
    : points_(std::move(points)),
      previous_(points_.size()),
      next_(points_.size()),
      linked_(points_.size(), true),
      remaining_(points_.size()) {
  const auto count = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    next_[i] = (i + 1) % count;
    previous_[next_[i]] = i;
  }
}

bool EarClipper::isReflex(std::uint32_t i) const {
  return orientation(points_[previous_[i]], points_[i], points_[next_[i]]) <= 0;
}

/// Returns whether `vertex` lies in the closed triangle of `ear`. A vertex with the position of a corner (such as the
/// end of an edge to a hole) does not count.
bool EarClipper::blocks(std::uint32_t vertex, std::uint32_t ear) const {
  const glm::dvec2& p = points_[vertex];
  const glm::dvec2& a = points_[previous_[ear]];
  const glm::dvec2& b = points_[ear];
  const glm::dvec2& c = points_[next_[ear]];
  if (p == a || p == b || p == c) return false;
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

bool EarClipper::isEar(std::uint32_t i) const {
  if (isReflex(i)) return false;
  for (const std::uint32_t vertex : reflex_) {
    if (linked_[vertex] && isReflex(vertex) && blocks(vertex, i)) return false;
  }
  return true;
}

void EarClipper::unlink(std::uint32_t i) {
  next_[previous_[i]] = next_[i];
  previous_[next_[i]] = previous_[i];
  linked_[i] = false;
  someVertex_ = next_[i];
  --remaining_;
}

void EarClipper::cut(std::uint32_t i) {
  triangles_.push_back({previous_[i], i, next_[i]});
  unlink(i);
  revisit(previous_[i]);
  revisit(next_[i]);
}

/// Removes a vertex that is on a straight edge, duplicated, or at the tip of a spike, and then examines its neighbours.
/// Queues any other vertex.
void EarClipper::revisit(std::uint32_t vertex) {
  std::vector<std::uint32_t> pending{vertex};
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    if (!linked_[i] || remaining_ < 3) continue;
    if (orientation(points_[previous_[i]], points_[i], points_[next_[i]]) != 0) {
      queue_.push_back(i);
      continue;
    }
    pending.push_back(next_[i]);
    pending.push_back(previous_[i]);
    unlink(i);
  }
}

void EarClipper::revisitAll() {
  queue_.clear();
  queueFront_ = 0;
  for (std::uint32_t i = 0; i < linked_.size(); ++i) revisit(i);
  reflex_.clear();
  for (std::uint32_t i = 0; i < linked_.size(); ++i) {
    if (linked_[i] && isReflex(i)) reflex_.push_back(i);
  }
}

/// Handles the case that no ear is left: cuts a convex vertex regardless of its inside. If all vertices are reflex, the
/// rest is reversed.
void EarClipper::cutAnyway() {
  std::uint32_t i = someVertex_;
  for (std::size_t step = 0; step < remaining_ && isReflex(i); ++step) i = next_[i];
  cut(i);
}

/// Cuts all that is left, vertex by vertex, in linear time.
void EarClipper::cutRest() {
  while (remaining_ > 3) cut(someVertex_);
}

// A full search takes quadratic time, and a polygon that crosses itself at random may need one for every few vertices.
bool EarClipper::clip() {
  constexpr std::size_t kMaxForcedCuts = 16;
  std::size_t forcedCuts = 0;
  bool progress = true;
  revisitAll();
  while (remaining_ > 3) {
    if (queueFront_ < queue_.size()) {
      const std::uint32_t i = queue_[queueFront_++];
      if (!linked_[i] || !isEar(i)) continue;
      cut(i);
      progress = true;
    } else if (progress) {
      progress = false;
      revisitAll();
    } else if (forcedCuts < kMaxForcedCuts) {
      ++forcedCuts;
      cutAnyway();
      progress = true;
    } else {
      cutRest();
    }
  }
  if (remaining_ == 3) triangles_.push_back({previous_[someVertex_], someVertex_, next_[someVertex_]});
  return forcedCuts == 0;
}

}  // namespace candela::scene
