#include "engine/haptics/mesh/mesh_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/active_set.h"
#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kMoved_A = 1e-12;  // a shorter piece does not move the SCP
constexpr double kRounding =
    8e-12;                       // relative to the displacement: a motion that leads into a face by no more is along it
constexpr double kAlong = 1e-9;  // sine below which a path is along a face
constexpr double kNearPath_A = 1.0;  // a longer piece searches the grid along its path
constexpr int kMaxStuck = 32;        // at a corner of a mesh, pieces of zero length cross its faces, at most eight
constexpr double kSwelling_A =
    0.05;  // largest motion of the surface per step, so that the SCP stays on its side of a wall
constexpr double kMaxSwellings = 64.0;  // largest number of steps per tick; faster motions use larger steps
constexpr int kMaxPushes = 256;
constexpr double kSure = 1e-9;  // relative margin within which rounding could affect a decision
constexpr double kNearly = 1.0 - 1e-9;
constexpr double kKept_A = 1.0;  // range in which a list of near spheres is valid
constexpr int kMaxPlanes = 8;    // number of planes tried for separating a mesh from the SCP's path

}  // namespace

MeshTracker::MeshTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, Options options)
    : mesh_(SphereMesh::ofTriangles(options.triangles)), options_(options), nearby_(std::move(scene), kKept_A) {
  nearby_.setProbe(usableProbe_A(probe_A, kWaterProbe_A));
}

void MeshTracker::reset() noexcept {
  has_been_outside_ = quick_prepared_ = false;
  touch_count_ = hold_count_ = 0;
  forgetSurroundings();
}

MemoryUsage MeshTracker::memoryUsage() const noexcept {
  return {std::size_t(touch_count_), sizeof(*this) + mesh_->bytes() + nearby_.scene().bytes()};
}

bool MeshTracker::touches(std::int32_t sphere) const {
  for (int k = 0; k < touch_count_; ++k)
    if (touching_[std::size_t(k)].sphere == sphere) return true;
  return false;
}

Contact MeshTracker::contact(const Vec3& hip) const noexcept {
  if (hold_count_ == 0 && scp_ == hip - nearby_.origin()) return {.scp = {hip}};
  // The result is assembled at once; a piecewise result would be read before its parts are stored, which stalls the
  // processor.
  const auto held = [&](int k) -> const Touch& { return touching_[std::size_t(holding_[std::size_t(k)])]; };
  std::array<int, 3> by{0, 1, 2};  // the blocking faces, ordered by sphere
  const auto order = [&](std::size_t j, std::size_t k) {
    if (held(by[j]).sphere > held(by[k]).sphere) std::swap(by[j], by[k]);
  };
  if (hold_count_ > 1) order(0, 1);
  if (hold_count_ > 2) order(1, 2), order(0, 1);
  const auto sphere = [&](int k) { return hold_count_ > k ? held(by[std::size_t(k)]).sphere : -1; };
  const auto normal = [&](int k) { return hold_count_ > k ? face(held(by[std::size_t(k)])).normal : Vec3(0.0); };
  const Vec3 scp = nearby_.origin() + scp_, straight = scp - hip;
  const Vec3 shaded = options_.smooth ? shadedNormal(hip - nearby_.origin()) : Vec3(0.0);
  return {.scp = {scp},
          .atoms = {sphere(0), sphere(1), sphere(2)},
          .feature = Feature(std::max(hold_count_, 1)),
          .displacement_A = shaded == Vec3(0.0) ? straight : shaded * glm::length(straight),
          .energy_A2 = 0.5 * glm::dot(straight, straight),
          .normals = {normal(0), normal(1), normal(2)}};
}

Contact MeshTracker::step(PointA hip) noexcept {
  if (!usableHip(hip.A)) return refusedHip(hip, nearby_.origin() + scp_);
  const Vec3 h = hip.A - nearby_.origin();
  if (touch_count_ == 0 && has_been_outside_ && options_.coherent && holdsQuickly(h)) return {.scp = hip};
  if (!has_been_outside_) {
    free_gap_ = nearby_.clearanceAt(h);
    scp_ = h;
    if (free_gap_ < 0.0) return {.scp = hip, .fault = Fault::StartedInside};
    has_been_outside_ = true;
    free_from_ = h;
    return {.scp = hip};
  }
  if (!options_.coherent) forgetSurroundings();
  if (!holdsQuickly(h)) {
    flow(h);
    prepareQuickTicks();
  }
  return contact(hip.A);
}

[[gnu::always_inline]] inline bool MeshTracker::wellWithin(const Touch& t, const Vec3& place) const {
  const SphereMesh::Face& f = face(t);
  const Vec3 x = place - t.centre;
  for (std::size_t k = 0; k < 3; ++k)
    if (glm::dot(f.out[k], x) > (f.reach[k] - kSure) * t.radius) return false;
  return true;
}

// True if the straight path from the SCP to `end` is known to meet no other mesh than those that the SCP touches.
[[gnu::always_inline]] inline bool MeshTracker::isClear(const Vec3& end, double length) noexcept {
  const Vec3 from = end - clear_from_;
  const double far2 = glm::dot(from, from), clear = clear_gap_ - length;
  if (clear > 0.0 && far2 < kNearly * clear * clear) return true;
  const double nearby_meshes_clear = nearby_mesh_gap_ - length;
  if (!(nearby_meshes_clear > 0.0 && far2 < kNearly * nearby_meshes_clear * nearby_meshes_clear)) return false;
  for (int k = 0; k < nearby_mesh_count_; ++k) {
    NearbyMesh& other = nearby_meshes_[std::size_t(k)];
    const Vec3 m = end - other.sphere.centre;
    const double far = other.sphere.radius + length;
    if (kNearly * glm::dot(m, m) <= far * far && !staysAbove(other, end)) return false;
  }
  return true;
}

// The fast path: nothing is near the free HIP, or the SCP stays on its face, seam or point and no other mesh is within
// reach. It performs the operations of the single piece of flow() in the same order, so the results are bitwise
// identical. A tick within kSure of a decision is left to flow().
bool MeshTracker::holdsQuickly(const Vec3& h) noexcept {
  if (touch_count_ == 0) {
    const Vec3 moved = h - free_from_;
    if (!(glm::dot(moved, moved) < free_gap_ * free_gap_)) return false;
    scp_ = h;
    return true;
  }
  if (!quick_prepared_) return false;
  const Vec3 displacement = h - scp_;
  const double sure = kSure * (std::abs(displacement.x) + std::abs(displacement.y) + std::abs(displacement.z));
  Vec3 s = scp_;
  switch (hold_count_) {
    case 1: {
      const Touch& t = touching_[0];
      const SphereMesh::Face& f = face(t);
      const double height = heightOver(t, h);
      if (height >= -sure || glm::dot(displacement, f.normal) >= -sure) return false;
      const Vec3 path = displacement - f.normal * height;
      if (glm::dot(path, path) <= kMoved_A * kMoved_A) return true;
      s += path;
      break;
    }
    case 2: {
      // Both multipliers of the displacement must be pushes; otherwise one face alone would block the SCP.
      const double a = -glm::dot(displacement, face(touching_[0]).normal),
                   b = -glm::dot(displacement, face(touching_[1]).normal);
      if (a - b * seam_cosine_ <= sure || b - a * seam_cosine_ <= sure) return false;
      const Vec3 path = seam_ * (glm::dot(displacement, seam_) / glm::dot(seam_, seam_));
      if (glm::dot(path, path) <= kMoved_A * kMoved_A) return true;
      s += path;
      for (int k = 0; k < 2; ++k) {
        const Touch& t = touching_[std::size_t(k)];
        s -= face(t).normal * heightOver(t, s);
      }
      break;
    }
    default:
      for (const Vec3& hold : holds_)
        if (glm::dot(hold, displacement) >= -sure) return false;
      return true;
  }
  for (int k = 0; k < hold_count_; ++k)
    if (!wellWithin(touching_[std::size_t(k)], s)) return false;
  if (!isClear(s, glm::distance(s, scp_))) return false;
  scp_ = s;
  return true;
}

// True if a plane of the other mesh, which is convex, separates it from the whole path from the SCP to `end`. The plane
// that last did so is tried first, then its neighbours.
bool MeshTracker::staysAbove(NearbyMesh& other, const Vec3& end) const {
  if (other.face < 0) return false;
  const double r = other.sphere.radius;
  const Vec3 p = scp_ - other.sphere.centre, q = end - other.sphere.centre;
  for (int k = 0; k < kMaxPlanes; ++k) {
    const SphereMesh::Face& f = mesh_->faces()[std::size_t(other.face)];
    const double hp = glm::dot(f.normal, p) - f.height * r, hq = glm::dot(f.normal, q) - f.height * r;
    if (std::min(hp, hq) > kSure * r) return true;
    double highest = hp + hq;
    std::int32_t next = -1;
    for (const std::int32_t neighbour : f.across) {
      const SphereMesh::Face& g = mesh_->faces()[std::size_t(neighbour)];
      const double height = glm::dot(g.normal, p + q) - 2.0 * g.height * r;
      if (height > highest) highest = height, next = neighbour;
    }
    if (next < 0) return false;
    other.face = next;
  }
  return false;
}

// The SCP has left the mesh of this sphere, which must therefore be watched again.
void MeshTracker::trackNearby(const Touch& t) noexcept {
  clear_gap_ = 0.0;
  for (int k = 0; k < touch_count_; ++k)
    if (&touching_[std::size_t(k)] != &t && touching_[std::size_t(k)].sphere == t.sphere) return;
  if (nearby_mesh_count_ == int(kMaxNearbyMeshes))
    nearby_mesh_gap_ = 0.0;
  else
    nearby_meshes_[std::size_t(nearby_mesh_count_++)] = {{t.centre, t.radius, t.sphere}, t.face};
}

// Prepares the fast path after a step in which every touched face is blocking.
void MeshTracker::prepareQuickTicks() noexcept {
  quick_prepared_ = hold_count_ > 0 && hold_count_ == touch_count_;
  if (!quick_prepared_ || hold_count_ == 1) return;
  const Vec3 &n0 = face(touching_[0]).normal, &n1 = face(touching_[1]).normal;
  seam_ = glm::cross(n0, n1);
  seam_cosine_ = glm::dot(n0, n1);
  if (hold_count_ == 2) {
    quick_prepared_ = glm::dot(seam_, seam_) > kSure;
    return;
  }
  // The negated mu_k |displacement| times the squared volume: if it exceeds rounding, no two of the faces block the SCP
  // without the third.
  const Vec3& n2 = face(touching_[2]).normal;
  const double volume = glm::dot(seam_, n2);
  holds_ = {glm::cross(n1, n2) * volume, glm::cross(n2, n0) * volume, seam_ * volume};
}

// Finds the first mesh that the path from the SCP enters, before first.t.
void MeshTracker::meet(const Vec3& path, Meeting& first) noexcept {
  const double length = glm::length(path);
  const double to_go = length * first.t;
  if (isClear(scp_ + path * first.t, to_go)) return;
  const auto look = [&](const NearSphere& b) {
    const SphereMesh::Entry entry = mesh_->enter((scp_ - b.centre) / b.radius, path / b.radius, first.t);
    if (entry.face >= 0) first = {entry.t, b, entry.face};
  };
  if (options_.coherent && to_go <= kNearPath_A) {
    const std::array<NearbyMesh, kMaxNearbyMeshes> before = nearby_meshes_;
    const int count_before = nearby_mesh_count_;
    std::array<double, kNearbyMeshes + 1> gaps;  // of the nearest spheres, ascending
    gaps.fill(1e300);
    nearby_mesh_count_ = 0;
    const Vec3 end = scp_ + path * first.t;
    const double visited = nearby_.each(scp_, to_go, [&](const NearSphere& b) {
      const Vec3 m = scp_ - b.centre;
      const double far = b.radius + to_go, d2 = glm::dot(m, m), beyond = b.radius + gaps[kNearbyMeshes];
      if (d2 >= far * far && d2 >= beyond * beyond) return;
      if (b.radius <= 0.0 || touches(b.index)) return;
      NearbyMesh other{b, -1};
      if (d2 < far * far) {
        for (int k = 0; k < count_before; ++k)
          if (before[std::size_t(k)].sphere.index == b.index) other.face = before[std::size_t(k)].face;
        if (other.face < 0) other.face = mesh_->faceAbout(m);
        if (!staysAbove(other, end)) look(b);
      }
      const double gap = std::sqrt(d2) - b.radius;
      if (gap >= gaps[kNearbyMeshes]) return;
      std::size_t at = kNearbyMeshes;
      for (; at > 0 && gaps[at - 1] > gap; --at) {
        gaps[at] = gaps[at - 1];
        if (at < kNearbyMeshes) nearby_meshes_[at] = nearby_meshes_[at - 1];
      }
      gaps[at] = gap;
      if (at < kNearbyMeshes) {
        nearby_meshes_[at] = other;
        nearby_mesh_count_ = std::min(nearby_mesh_count_ + 1, int(kNearbyMeshes));
      }
    });
    clear_from_ = scp_;
    clear_gap_ = std::min(gaps[0], visited);
    nearby_mesh_gap_ = std::min(gaps[kNearbyMeshes], visited);
    return;
  }
  // A long path is examined piece by piece, from its entry into the scene's bounding box.
  const SphereGrid& scene = nearby_.scene();
  if (scene.size() == 0) return;
  const double probe = nearby_.probe_A();
  const Vec3 low = scene.low_A() - Vec3(probe) - nearby_.origin(),
             high = scene.high_A() + Vec3(probe) - nearby_.origin();
  double a = 0.0, z = first.t;
  for (int k = 0; k < 3; ++k) {
    if (path[k] == 0.0) {
      if (scp_[k] < low[k] || scp_[k] > high[k]) return;
      continue;
    }
    const double u = (low[k] - scp_[k]) / path[k], v = (high[k] - scp_[k]) / path[k];
    a = std::max(a, std::min(u, v));
    z = std::min(z, std::max(u, v));
  }
  for (const double piece = scene.cell_A() / length; a <= z && a <= first.t; a += piece) {
    const Vec3 p = scp_ + path * a, q = scp_ + path * std::min(a + piece, z);
    const Vec3 box_low = glm::min(p, q), box_high = glm::max(p, q);
    scene.visitNearBox(nearby_.origin() + box_low, nearby_.origin() + box_high, probe,
                       [&](std::uint32_t i, const Sphere&) {
                         const NearSphere b = nearby_.sphere(std::int32_t(i));
                         const Vec3 apart = glm::max(glm::max(box_low - b.centre, b.centre - box_high), Vec3(0.0));
                         if (b.radius <= 0.0 || std::max({apart.x, apart.y, apart.z}) > b.radius || touches(b.index))
                           return;
                         look(b);
                       });
  }
}

// Removes faces that the SCP has left; meet() finds them again.
void MeshTracker::removeSeparated() noexcept {
  int kept = 0, left_count = 0;
  std::array<Touch, kMaxTouching> left;
  for (int k = 0; k < touch_count_; ++k) {
    const Touch& t = touching_[std::size_t(k)];
    if (std::abs(heightOver(t, scp_)) <= SphereMesh::kSkin * t.radius)
      touching_[std::size_t(kept++)] = t;
    else
      left[std::size_t(left_count++)] = t;
  }
  touch_count_ = kept;
  for (int k = 0; k < left_count; ++k) trackNearby(left[std::size_t(k)]);
}

void MeshTracker::flow(const Vec3& h) noexcept {
  int stuck = 0;
  hold_count_ = 0;
  for (int piece = 0; piece < kMaxPieces && stuck <= kMaxStuck; ++piece) {
    std::array<moltact::Touch, kMaxTouching> planes;
    for (int k = 0; k < touch_count_; ++k)
      planes[std::size_t(k)] = {face(touching_[std::size_t(k)]).normal, INFINITY, 0.0, k};
    const auto normal = [&](int k) { return planes[std::size_t(k)].normal; };
    const Vec3 displacement = h - scp_;
    const ActiveSet blocked = activeSet(displacement, {planes.data(), std::size_t(touch_count_)},
                                        kRounding * glm::length(displacement), {.grazes = false});
    holding_ = blocked.by;
    hold_count_ = blocked.count;
    Vec3 path(0.0);
    if (blocked.count == 0) {
      path = displacement;
    } else if (blocked.count == 1) {
      const Touch& t = touching_[std::size_t(blocked.by[0])];
      path = displacement - normal(blocked.by[0]) * heightOver(t, h);  // ends exactly in the face's plane
    } else if (blocked.count == 2) {
      const Vec3 line = glm::cross(normal(blocked.by[0]), normal(blocked.by[1]));
      path = line * (glm::dot(displacement, line) / glm::dot(line, line));
    }
    const double length = glm::length(path);
    if (length <= kMoved_A && blocked.count > 0) return;

    // The end of this piece: an edge of a face along the path, or another mesh.
    double end = 1.0;
    int over = -1;
    std::size_t edge = 0;
    for (int k = 0; k < touch_count_; ++k) {
      const Touch& t = touching_[std::size_t(k)];
      const SphereMesh::Face& f = face(t);
      if (std::abs(glm::dot(f.normal, path)) > kAlong * length) continue;
      const Vec3 x = scp_ - t.centre;
      for (std::size_t e = 0; e < 3; ++e) {
        const double speed = glm::dot(f.out[e], path);
        if (!(speed > kAlong * length)) continue;
        const double at = std::max(0.0, (f.reach[e] * t.radius - glm::dot(f.out[e], x)) / speed);
        if (at < end) end = at, over = k, edge = e;
      }
    }
    Meeting first{end, {}, -1};
    meet(path, first);

    scp_ += path * first.t;
    const bool moved = first.t * length > kMoved_A;
    if (moved && blocked.count >= 2)  // along a seam rounding accumulates: project onto both planes
      for (int k = 0; k < blocked.count; ++k) {
        const Touch& t = touching_[std::size_t(blocked.by[std::size_t(k)])];
        scp_ -= face(t).normal * heightOver(t, scp_);
      }
    stuck = moved ? 0 : stuck + 1;
    if (first.face >= 0) {
      if (moved) removeSeparated();
      if (touch_count_ == kMaxTouching) break;
      const Touch t{first.sphere.index, first.face, first.sphere.centre, first.sphere.radius};
      scp_ -= face(t).normal * heightOver(t, scp_);
      touching_[std::size_t(touch_count_++)] = t;
      nearby_mesh_count_ = int(std::remove_if(nearby_meshes_.begin(), nearby_meshes_.begin() + nearby_mesh_count_,
                                              [&](const NearbyMesh& r) { return r.sphere.index == t.sphere; }) -
                               nearby_meshes_.begin());
    } else if (over >= 0) {
      touching_[std::size_t(over)].face = face(touching_[std::size_t(over)]).across[edge];
      if (moved) removeSeparated();
    } else {
      if (blocked.count == 0) {
        scp_ = free_from_ = h;
        touch_count_ = 0;
        clear_gap_ = nearby_mesh_gap_ = 0.0;
        // Between a sphere and its mesh the clearance is negative: it gives no information.
        free_gap_ = options_.coherent ? std::max(0.0, nearby_.clearanceAt(h)) : 0.0;
      } else if (touch_count_ >
                 blocked.count) {  // keep only blocking faces, so that the next tick can use the fast path
        std::array<Touch, 3> kept;
        for (int k = 0; k < blocked.count; ++k)
          kept[std::size_t(k)] = touching_[std::size_t(blocked.by[std::size_t(k)])];
        const std::array<Touch, kMaxTouching> before = touching_;
        const int count_before = touch_count_;
        std::copy_n(kept.begin(), blocked.count, touching_.begin());
        touch_count_ = blocked.count;
        for (int k = 0; k < count_before; ++k)
          if (std::find(blocked.by.begin(), blocked.by.end(), k) == blocked.by.end())
            trackNearby(before[std::size_t(k)]);
        holding_ = {0, 1, 2};
      }
      return;
    }
  }
  ++cut_short_;
  hold_count_ = std::min(hold_count_, touch_count_);
  for (int k = 0; k < hold_count_; ++k) holding_[std::size_t(k)] = k;
}

// SCP - HIP is the sum of mu_k n_k over the blocking faces; the shaded normal is the same sum with the corners' normals
// interpolated.
Vec3 MeshTracker::shadedNormal(const Vec3& h) const noexcept {
  const Vec3 lift = scp_ - h;
  std::array<Vec3, 3> n{}, radial{};
  for (int k = 0; k < hold_count_; ++k) {
    const Touch& t = touching_[std::size_t(holding_[std::size_t(k)])];
    n[std::size_t(k)] = face(t).normal;
    radial[std::size_t(k)] = (scp_ - t.centre) / glm::distance(scp_, t.centre);
  }
  Vec3 sum(0.0);
  if (hold_count_ == 1) return radial[0];
  if (hold_count_ == 2) {
    const double c = glm::dot(n[0], n[1]), a = glm::dot(lift, n[0]), b = glm::dot(lift, n[1]);
    sum = (a - b * c) * radial[0] + (b - a * c) * radial[1];
  } else if (hold_count_ == 3) {
    const Vec3 ij = glm::cross(n[0], n[1]), jk = glm::cross(n[1], n[2]), ki = glm::cross(n[2], n[0]);
    const double side = glm::dot(ij, n[2]) < 0.0 ? -1.0 : 1.0;
    sum = side * (glm::dot(lift, jk) * radial[0] + glm::dot(lift, ki) * radial[1] + glm::dot(lift, ij) * radial[2]);
  }
  const double far = glm::length(sum);
  return far > 0.0 ? sum / far : Vec3(0.0);
}

void MeshTracker::setProbe(double probe_A) noexcept {
  const double had = nearby_.probe_A(), wanted = usableProbe_A(probe_A, had);
  if (wanted == had) return;
  const int pieces = !has_been_outside_ || wanted < had ? 1 : static_cast<int>(std::ceil((wanted - had) / kSwelling_A));
  for (int k = 1; k <= pieces; ++k) {
    nearby_.setProbe(k == pieces ? wanted : had + (wanted - had) * k / pieces);
    if (carry()) continue;
    nearby_.setProbe(wanted);  // the surroundings have closed over the SCP: no surface is left
    reset();
    return;
  }
}

bool MeshTracker::setMotion(const SphereMotion* motion) noexcept {
  if (nearby_.has(motion)) return true;
  nearby_.setMotion(motion);
  if (!carry()) reset();
  return true;
}

void MeshTracker::advanceTo(double fraction) noexcept {
  const double had = nearby_.fraction();
  if (fraction == had) return;
  if (has_been_outside_) nearby_.each(scp_, 0.0, [](const NearSphere&) {});  // creates the list
  const double max_A = std::abs(fraction - had) * nearby_.maxMotion_A();
  const int pieces = has_been_outside_ && max_A > kSwelling_A
                         ? static_cast<int>(std::ceil(std::min(max_A / kSwelling_A, kMaxSwellings)))
                         : 1;
  for (int k = 1; k <= pieces; ++k) {
    nearby_.advanceTo(k == pieces ? fraction : had + (fraction - had) * k / pieces);
    if (carry()) continue;
    nearby_.advanceTo(fraction);
    reset();
    return;
  }
}

// After a change of the surface: discards the cache and moves the SCP out of the meshes that have grown over it.
// Returns false if that fails.
bool MeshTracker::carry() noexcept {
  forgetSurroundings();
  touch_count_ = hold_count_ = 0;
  quick_prepared_ = false;
  return !has_been_outside_ || pushOut();
}

// Moves the SCP out of the meshes that have grown over it, out of each through the face above it, in turn. This
// converges to a point on all of them in a crease or pit. Returns false if that fails.
bool MeshTracker::pushOut() noexcept {
  for (int round = 0; round < kMaxPushes; ++round) {
    bool inside = false;
    nearby_.each(scp_, 0.0, [&](const NearSphere& b) {
      const Vec3 x = scp_ - b.centre;
      if (glm::dot(x, x) >= b.radius * b.radius) return;
      if (x == Vec3(0.0)) return;
      const SphereMesh::Face& f = mesh_->faces()[std::size_t(mesh_->faceToward(x))];
      const double height = glm::dot(f.normal, x) - f.height * b.radius;
      if (height >= 0.0) return;
      inside = true;
      scp_ -= f.normal * (height * (1.0 + 1e-9) - 1e-12);
    });
    if (!inside) return true;
  }
  return false;
}

}  // namespace moltact
