#include "engine/haptics/grid/grid_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kSurface_A = 1e-9;  // a point within this distance of the level lies on it
/// A Newton step shorter than this is the last of a tick; its error is about its square, far below the grid's own.
constexpr double kSettled_A = 0.025;
/// Safe fraction of the field's distance to the level: the gradient is near 1 except at rounded creases.
constexpr double kFree = 0.8;
constexpr int kMaxFlights = 512;   // steps along one straight path
constexpr int kMaxIterations = 8;  // changes between flight and sliding per tick

}  // namespace

double GridTracker::capFor(double probe_A, double spacing_A) { return std::ceil(probe_A) + 2.0 + 3.0 * spacing_A; }

GridTracker::GridTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A, bool prepared)
    : scene_(std::move(scene)),
      origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)),
      bricks_(scene_, origin_, spacing_A, capFor(usableProbe_A(probe_A, kWaterProbe_A), spacing_A)),
      probe_(usableProbe_A(probe_A, kWaterProbe_A)) {
  if (prepared) bricks_.prepare(probe_);
}

void GridTracker::reset() noexcept {
  has_been_outside_ = touching_ = false;
  free_gap_ = 0.0;
}

MemoryUsage GridTracker::memoryUsage() const noexcept {
  return {bricks_.spheresRemembered(), sizeof(*this) + bricks_.bytes() + scene_->bytes()};
}

Contact GridTracker::step(PointA hip) noexcept {
  if (!usableHip(hip.A)) return refusedHip(hip, origin_ + scp_);
  const Vec3 h = hip.A - origin_;
  fills_left_ = kMaxFills;
  steps_left_ = kMaxSteps;
  if (!has_been_outside_) {
    const double gap = clearance(*scene_, probe_, hip.A);
    DistanceBricks::Sample here{};
    scp_ = h;
    if (gap < 0.0 || (gap < margin() && (!bricks_.sample(h, here, fills_left_) || here.value < probe_)))
      return {.scp = hip, .fault = Fault::StartedInside};
    has_been_outside_ = true;
    free_from_ = h;
    free_gap_ = gap - margin();
    return {.scp = hip};
  }
  if (!touching_) {
    const Vec3 moved = h - free_from_;
    if (free_gap_ > 0.0 && glm::dot(moved, moved) < free_gap_ * free_gap_) {
      scp_ = h;
      return {.scp = hip};
    }
  }
  const Vec3 rested = scp_;
  SlideResult result = SlideResult::Short;
  bool pressed = false;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (touching_) {
      result = slide(h, pressed);
      pressed = false;
      touching_ = result != SlideResult::Leaves;
    } else {
      const Vec3 was = scp_;
      result = fly(h);
      touching_ = result == SlideResult::Meets;
      pressed = touching_ && glm::distance(was, scp_) < 1e-6;
    }
    if (result == SlideResult::Arrived || result == SlideResult::Rests || result == SlideResult::Short) break;
  }
  if (result != SlideResult::Arrived && result != SlideResult::Rests) {
    ++cut_short_;
    if (!pushOut()) scp_ = rested;  // a step of the path may have ended under a crease
  }
  if (result == SlideResult::Arrived) return {.scp = hip};
  Contact out{.scp = {origin_ + scp_}, .feature = Feature::Sphere};
  out.atoms[0] = bricks_.nearestSphere(scp_);
  if (out.atoms[0] < 0) {  // the last step entered a brick that the next tick needs as well
    DistanceBricks::Sample next{};
    bricks_.sample(scp_, next, fills_left_);
    out.atoms[0] = bricks_.nearestSphere(scp_);
  }
  stretchToScp(out, hip);
  if (out.atoms[0] < 0) return out;
  // On the path to the surface the gradient is unknown.
  const Vec3 outward =
      touching_ && outward_ != Vec3(0.0) ? outward_ : origin_ + scp_ - (*scene_)[std::size_t(out.atoms[0])].centre_A;
  if (const double steep = glm::length(outward); steep > 0.0) out.normals[0] = outward / steep;
  return out;
}

// Flies straight toward the HIP: by the spheres' own distances when far away, by the field near the surface.
GridTracker::SlideResult GridTracker::fly(const Vec3& h) noexcept {
  const double spacing = bricks_.spacing_A(), smallest = spacing / 16.0;
  for (int k = 0; k < kMaxFlights; ++k) {
    const Vec3 to_go = h - scp_;
    const double length = glm::length(to_go);
    const double gap = clearance(*scene_, probe_, origin_ + scp_);
    if (gap > 2.0 * margin()) {
      const double free = gap - margin();
      if (free > length) {
        free_from_ = scp_;
        free_gap_ = free;
        scp_ = h;
        return SlideResult::Arrived;
      }
      scp_ += to_go * (free / length);
      continue;
    }
    DistanceBricks::Sample here{};
    if (!bricks_.sample(scp_, here, fills_left_)) return SlideResult::Short;
    if (!(length > 0.0)) {
      free_from_ = h;
      free_gap_ = std::max(0.0, kFree * (here.value - probe_));
      return SlideResult::Arrived;
    }
    const double step = std::min(std::max(here.value - probe_, smallest), length);
    Vec3 a = scp_, b = step == length ? h : scp_ + to_go * (step / length);
    DistanceBricks::Sample there{};
    if (!bricks_.sample(b, there, fills_left_)) return SlideResult::Short;
    if (there.value >= probe_) {
      scp_ = b;
      continue;
    }
    if (here.value < probe_) return SlideResult::Meets;  // on the surface within rounding, and the path leads in
    // The level lies between: bisect and keep the outer end.
    for (int halving = 0; halving < 40 && glm::distance(a, b) > kSurface_A; ++halving) {
      const Vec3 middle = 0.5 * (a + b);
      if (!bricks_.sample(middle, there, fills_left_)) return SlideResult::Short;
      (there.value >= probe_ ? a : b) = middle;
    }
    scp_ = a;
    return SlideResult::Meets;
  }
  return SlideResult::Short;
}

// Slides on the level toward the point nearest to the HIP. `pressed`: a flight from here has just failed, so it slides
// although the HIP appears above the tangent plane.
GridTracker::SlideResult GridTracker::slide(const Vec3& h, bool pressed) noexcept {
  const double spacing = bricks_.spacing_A();
  double longest = 0.75 * spacing;
  Vec3 last_along(0.0);
  bool first = true;
  while (steps_left_-- > 0) {
    DistanceBricks::Sample s{};
    if (!bricks_.sample(scp_, s, fills_left_)) return SlideResult::Short;
    const double off = s.value - probe_, steep = glm::length(s.gradient);
    if (first && off > 1e-3 * spacing) return SlideResult::Leaves;  // the surface has receded
    first = false;
    if (!(steep > 1e-3)) return SlideResult::Short;
    const Vec3 n = s.gradient / steep, displacement = h - scp_;
    const double in = glm::dot(displacement, n);
    if (in >= 0.0 && off > -kSurface_A && !pressed) return SlideResult::Leaves;
    outward_ = s.gradient;
    const Vec3 along = displacement - n * in;
    const double length = glm::length(along);

    // Newton's step in the tangent plane: (1 - share * H) p = along.
    Vec3 p = along;
    if (length > 0.0) {
      const Vec3 t1 = along / length, t2 = glm::cross(n, t1);
      const double share = std::max(0.0, -in) / steep;
      const Vec3 h1 = s.hessian * t1, h2 = s.hessian * t2;
      const double a = 1.0 - share * glm::dot(t1, h1), b = -share * glm::dot(t1, h2),
                   c = 1.0 - share * glm::dot(t2, h2);
      const double whole = a * c - b * b;
      if (a > 0.05 && whole > 0.05 * a) p = (t1 * c - t2 * b) * (length / whole);
    }
    // Where the second derivatives jump between cells, Newton's steps may oscillate about the position of rest; shorter
    // steps end this.
    const double cosine = glm::dot(along, last_along);
    if (cosine < 0.0 && glm::dot(along, along) > 0.25 * glm::dot(last_along, last_along))
      longest *= 0.5;
    else if (cosine > 0.0)
      longest = std::min(1.5 * longest, 0.75 * spacing);
    last_along = along;
    double far = glm::length(p);
    if (far > longest) p *= longest / far, far = longest;
    const double bends = 0.5 * glm::dot(p, s.hessian * p);
    const double back = std::clamp((off + bends) / steep, -0.5 * spacing, 0.5 * spacing);
    const Vec3 step = p - n * back;
    scp_ += step;
    outward_ = s.gradient + s.hessian * step;
    if (far < kSettled_A && std::abs(off) < kSettled_A) return SlideResult::Rests;
  }
  return SlideResult::Short;
}

void GridTracker::setProbe(double probe_A) noexcept {
  const double had = probe_, wanted = usableProbe_A(probe_A, had);
  if (wanted == had) return;
  free_gap_ = 0.0;
  if (capFor(wanted, bricks_.spacing_A()) > capFor(had, bricks_.spacing_A()))
    bricks_.setCap(capFor(wanted, bricks_.spacing_A()));
  // The surface moves by a part of the spacing per step, so that the SCP stays on its side of a wall.
  const int pieces = !has_been_outside_ || wanted < had
                         ? 1
                         : static_cast<int>(std::ceil((wanted - had) / (0.25 * bricks_.spacing_A())));
  for (int k = 1; k <= pieces; ++k) {
    probe_ = k == pieces ? wanted : had + (wanted - had) * k / pieces;
    fills_left_ = kMaxFills;
    if (!has_been_outside_ || pushOut()) continue;
    probe_ = wanted;  // the surroundings have closed over the SCP: no surface is left
    reset();
    return;
  }
}

// Moves the SCP up to the level after the level has risen over it.
bool GridTracker::pushOut() noexcept {
  if (clearance(*scene_, probe_, origin_ + scp_) > margin()) return true;
  for (int k = 0; k < 32; ++k) {
    DistanceBricks::Sample s{};
    if (!bricks_.sample(scp_, s, fills_left_)) return false;
    const double under = probe_ - s.value, steep2 = glm::dot(s.gradient, s.gradient);
    if (under <= 0.0) return true;
    if (!(steep2 > 1e-4)) return false;
    const double rise = std::min((under + kSurface_A) / std::sqrt(steep2), 0.5 * bricks_.spacing_A());
    scp_ += s.gradient * (rise / std::sqrt(steep2));
  }
  return false;
}

}  // namespace moltact
