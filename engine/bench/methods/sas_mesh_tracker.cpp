#include "engine/bench/methods/sas_mesh_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kCorner_A = 1e-9;  // a point within this distance of a corner lies on it
constexpr double kMoved_A = 1e-12;
constexpr double kInto = 1e-10;  // sine above which a path crosses a border instead of running along it
constexpr int kMaxStuck = 24;
constexpr int kMaxIterations = 8;  // changes between flight and sliding per tick

}  // namespace

SasMeshTracker::SasMeshTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A)
    : scene_(std::move(scene)),
      probe_(usableProbe_A(probe_A, kWaterProbe_A)),
      margin_(2.0 * spacing_A),
      origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)),
      mesh_(SurfaceMesh::of(scene_, probe_, spacing_A, origin_)) {}

void SasMeshTracker::reset() noexcept {
  has_been_outside_ = false;
  on_ = On::Nothing;
  free_gap_ = 0.0;
}

MemoryUsage SasMeshTracker::memoryUsage() const noexcept {
  return {mesh_->spheres(), sizeof(*this) + mesh_->bytes() + scene_->bytes()};
}

Contact SasMeshTracker::step(PointA hip) noexcept {
  if (!usableHip(hip.A)) return refusedHip(hip, origin_ + scp_);
  const Vec3 h = hip.A - origin_;
  if (!has_been_outside_) {
    const double gap = clearance(*scene_, probe_, hip.A);
    scp_ = h;
    if (gap < 0.0) return {.scp = hip, .fault = Fault::StartedInside};
    has_been_outside_ = true;
    free_from_ = h;
    free_gap_ = gap - margin_;
    return {.scp = hip};
  }
  if (on_ == On::Nothing) {
    const Vec3 moved = h - free_from_;
    if (free_gap_ > 0.0 && glm::dot(moved, moved) < free_gap_ * free_gap_) {
      scp_ = h;
      return {.scp = hip};
    }
  }
  SlideResult result = SlideResult::Short;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (on_ != On::Nothing) {
      result = walk(h);
      if (result == SlideResult::Leaves) on_ = On::Nothing;
    } else {
      result = fly(h);
    }
    if (result == SlideResult::Arrived || result == SlideResult::Rests || result == SlideResult::Short) break;
  }
  if (result == SlideResult::Arrived) return {.scp = hip};
  if (result != SlideResult::Rests) ++cut_short_;
  Contact out{.scp = {origin_ + scp_}, .feature = Feature::Sphere};
  stretchToScp(out, hip);
  if (on_ == On::Nothing) return out;
  out.atoms[0] = mesh_->triangles()[std::size_t(triangle_)].sphere;
  out.normals[0] = outward();
  return out;
}

// The triangle's normal; on an edge or a corner the mean of the adjacent normals.
Vec3 SasMeshTracker::outward() const noexcept {
  const Vec3 sum = on_ == On::Edge     ? plane_.normal + beyond_.normal
                   : on_ == On::Corner ? corner_normal_
                                       : plane_.normal;
  const double far = glm::length(sum);
  return far > 0.0 ? sum / far : plane_.normal;
}

SasMeshTracker::SlideResult SasMeshTracker::fly(const Vec3& h) noexcept {
  const Vec3 path = h - scp_;
  const SurfaceMesh::Hit hit = mesh_->cast(scp_, path);
  if (hit.triangle < 0) {
    scp_ = free_from_ = h;
    free_gap_ = clearance(*scene_, probe_, origin_ + h) - margin_;
    return SlideResult::Arrived;
  }
  scp_ += path * hit.t;
  goToTriangle(hit.triangle);
  scp_ -= plane_.normal * (glm::dot(plane_.normal, scp_) - plane_.height);
  return SlideResult::Meets;
}

void SasMeshTracker::goToTriangle(std::int32_t triangle) noexcept {
  on_ = On::Triangle;
  triangle_ = triangle;
  plane_ = mesh_->plane(triangle);
}

void SasMeshTracker::goToEdge(std::int32_t triangle, std::int32_t edge) noexcept {
  if (triangle != triangle_) plane_ = mesh_->plane(triangle);
  on_ = On::Edge;
  triangle_ = triangle;
  edge_ = edge;
  const SurfaceMesh::Triangle& t = mesh_->triangles()[std::size_t(triangle)];
  other_ = t.across[std::size_t(edge)];
  beyond_ = mesh_->plane(other_);
  const auto& back = mesh_->triangles()[std::size_t(other_)];
  const std::int32_t from = t.corners[std::size_t(edge)], to = t.corners[std::size_t((edge + 1) % 3)];
  other_edge_ = back.corners[0] == to && back.corners[1] == from   ? 0
                : back.corners[1] == to && back.corners[2] == from ? 1
                                                                   : 2;
  edge_from_ = mesh_->vertices()[std::size_t(from)];
  const Vec3 whole = mesh_->vertices()[std::size_t(to)] - edge_from_;
  edge_length_ = glm::length(whole);
  edge_along_ = whole / edge_length_;
}

// Collects the triangles around the corner in turn, and computes the normal that distinguishes outside from inside
// there (Baerentzen & Aanaes 2005: the triangles' normals, weighted by their angles).
void SasMeshTracker::goToCorner(std::int32_t triangle, std::int32_t corner) noexcept {
  on_ = On::Corner;
  triangle_ = triangle;
  plane_ = mesh_->plane(triangle);
  const std::int32_t vertex = mesh_->triangles()[std::size_t(triangle)].corners[std::size_t(corner)];
  scp_ = mesh_->vertices()[std::size_t(vertex)];
  corner_normal_ = Vec3(0.0);
  round_count_ = 0;
  std::int32_t at = triangle;
  do {
    const SurfaceMesh::Triangle& t = mesh_->triangles()[std::size_t(at)];
    const std::size_t k = t.corners[0] == vertex ? 0 : t.corners[1] == vertex ? 1 : 2;
    const Vec3 right = mesh_->vertices()[std::size_t(t.corners[(k + 1) % 3])] - scp_,
               left = mesh_->vertices()[std::size_t(t.corners[(k + 2) % 3])] - scp_, across = glm::cross(right, left);
    const double sine = glm::length(across);
    Wedge& w = round_[round_count_++];
    w.triangle = at;
    w.edge = std::int32_t(k);
    w.normal = sine > 0.0 ? across / sine : Vec3(0.0);
    w.along = glm::normalize(right);
    w.in_right = glm::cross(w.normal, w.along);
    w.in_left = glm::cross(glm::normalize(left), w.normal);
    corner_normal_ += w.normal * std::atan2(sine, glm::dot(right, left));
    at = t.across[(k + 2) % 3];  // across the left edge
  } while (at != triangle && round_count_ < kMaxRound);
}

SasMeshTracker::SlideResult SasMeshTracker::walk(const Vec3& h) noexcept {
  int stuck = 0;
  for (int piece = 0; piece < kMaxPieces && stuck < kMaxStuck; ++piece) {
    const SlideResult result = on_ == On::Triangle ? overTriangle(h, stuck)
                               : on_ == On::Edge   ? alongEdge(h, stuck)
                                                   : fromCorner(h, stuck);
    if (result != SlideResult::Meets) return result;
  }
  return SlideResult::Short;
}

SasMeshTracker::SlideResult SasMeshTracker::overTriangle(const Vec3& h, int& stuck) noexcept {
  const double height = glm::dot(plane_.normal, h) - plane_.height;
  if (height >= 0.0) return SlideResult::Leaves;
  const Vec3 foot = h - plane_.normal * height;
  double t = 1.0;
  int over = -1;
  for (int k = 0; k < 3; ++k) {
    const double beyond = glm::dot(plane_.out[std::size_t(k)], foot) - plane_.reach[std::size_t(k)];
    if (beyond <= 0.0) continue;
    const double before = std::max(0.0, plane_.reach[std::size_t(k)] - glm::dot(plane_.out[std::size_t(k)], scp_));
    if (const double at = before / (before + beyond); at < t || over < 0) t = at, over = k;
  }
  if (over < 0) {
    scp_ = foot;
    return SlideResult::Rests;
  }
  const Vec3 path = foot - scp_;
  stuck = t * glm::length(path) > kMoved_A ? 0 : stuck + 1;
  scp_ += path * t;
  goToEdge(triangle_, over);
  const double along = glm::dot(scp_ - edge_from_, edge_along_);
  if (along <= kCorner_A)
    goToCorner(triangle_, over);
  else if (along >= edge_length_ - kCorner_A)
    goToCorner(triangle_, (over + 1) % 3);
  else
    scp_ = edge_from_ + edge_along_ * along;
  return SlideResult::Meets;
}

// Selects, among the directions that leave a border, the steepest descent of |x - h|^2. The side of the nearest element
// determines whether the HIP is outside.
SasMeshTracker::SlideResult SasMeshTracker::alongEdge(const Vec3& h, int& stuck) noexcept {
  const Vec3 displacement = h - scp_;
  const double smallest = kInto * glm::length(displacement);
  const double up = glm::dot(displacement, plane_.normal), up_beyond = glm::dot(displacement, beyond_.normal),
               along = glm::dot(displacement, edge_along_);
  const bool here = glm::dot(displacement, plane_.out[std::size_t(edge_)]) < -smallest,
             there = glm::dot(displacement, beyond_.out[other_edge_]) < -smallest;
  const double pull2 = glm::dot(displacement, displacement), gain = pull2 - up * up,
               gain_beyond = pull2 - up_beyond * up_beyond;
  if (here && (!there || gain >= gain_beyond)) {
    if (up > 0.0) return SlideResult::Leaves;
    ++stuck;
    on_ = On::Triangle;
    return SlideResult::Meets;
  }
  if (there) {
    if (up_beyond > 0.0) return SlideResult::Leaves;
    ++stuck;
    on_ = On::Triangle;
    triangle_ = other_;
    plane_ = beyond_;
    return SlideResult::Meets;
  }
  if (up + up_beyond > 0.0) return SlideResult::Leaves;
  const double at = glm::dot(scp_ - edge_from_, edge_along_), to = at + along;
  if (to > kCorner_A && to < edge_length_ - kCorner_A) {
    scp_ = edge_from_ + edge_along_ * to;
    return SlideResult::Rests;
  }
  stuck = std::abs(along) > kMoved_A ? 0 : stuck + 1;
  goToCorner(triangle_, to <= kCorner_A ? edge_ : (edge_ + 1) % 3);
  return SlideResult::Meets;
}

SasMeshTracker::SlideResult SasMeshTracker::fromCorner(const Vec3& h, int& stuck) noexcept {
  const Vec3 displacement = h - scp_;
  const double pull2 = glm::dot(displacement, displacement), smallest = kInto * std::sqrt(pull2);
  double best = 0.0;
  std::size_t by = 0;
  bool on_edge = false;
  for (std::size_t k = 0; k < round_count_; ++k) {
    const Wedge& w = round_[k];
    const double along = glm::dot(displacement, w.along);
    if (along > smallest && along * along > best) best = along * along, by = k, on_edge = true;
    if (glm::dot(displacement, w.in_right) <= smallest || glm::dot(displacement, w.in_left) <= smallest) continue;
    const double up = glm::dot(displacement, w.normal);
    if (pull2 - up * up > best) best = pull2 - up * up, by = k, on_edge = false;
  }
  if (best == 0.0) return glm::dot(displacement, corner_normal_) > 0.0 ? SlideResult::Leaves : SlideResult::Rests;
  const Wedge& w = round_[by];
  const Vec3 side = on_edge ? w.normal + round_[(by + round_count_ - 1) % round_count_].normal : w.normal;
  if (glm::dot(displacement, side) > 0.0) return SlideResult::Leaves;
  ++stuck;
  const std::int32_t triangle = w.triangle, edge = w.edge;
  if (on_edge)
    goToEdge(triangle, edge);
  else
    goToTriangle(triangle);
  return SlideResult::Meets;
}

}  // namespace moltact
