#include "engine/haptics/exact/exact_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/exact/cap.h"
#include "engine/haptics/exact/entry_angle.h"
#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

// Rounding moves a point by at most about eight units in the last place of the largest coordinate or radius, 2^-50 of
// it. A sphere within 128 times this distance counts as touched (docs/exact-tracker.md, "What rounding may do").
constexpr double kContact = 0x1p-43;

// Every sphere within kLook_A of the SCP is examined before a path continues. The list is valid until the SCP has moved
// by kMargin_A. Longer lists are costlier to gather, shorter ones are gathered more often.
constexpr double kLook_A = 0.5, kMargin_A = 1.0;

// Number of consecutive pieces without approach to the HIP after which the SCP stays where it is.
constexpr int kMaxIdle = 12;
// Number of small pieces after which paths no longer graze. More of them, or no approach to the HIP, mean that the path
// oscillates over a crease too flat to be detected directly.
constexpr int kMaxGrazing = 24;

}  // namespace

ExactTracker::ExactTracker(std::shared_ptr<const SphereGrid> scene, double probe_A)
    : near_(std::move(scene), kMargin_A, NearbySpheres::Crowded::ReachLess) {
  near_.setProbe(usableProbe_A(probe_A, kWaterProbe_A));
}

void ExactTracker::forgetSurroundings() noexcept {
  free_gap2_ = 0.0;
  patch_.clear = patch_.cosine = 2.0;
  circle_.i = -1;
  holds_known_ = false;
}

void ExactTracker::reset() noexcept {
  if (resizing_) near_.setProbe(goal_A_);
  armed_ = behind_ = resizing_ = false;
  feature_ = Feature::Free;
  holders_ = {-1, -1, -1};
  forgetSurroundings();
}

MemoryUsage ExactTracker::memoryUsage() const noexcept { return {near_.held(), sizeof(*this) + near_.scene().bytes()}; }

// Sets the active set, in ascending order.
void ExactTracker::holdBy(std::int32_t a, std::int32_t b, std::int32_t c) noexcept {
  if (b >= 0 && b < a) std::swap(a, b);
  if (c >= 0 && c < b) std::swap(b, c);
  if (b >= 0 && b < a) std::swap(a, b);
  holders_ = {a, b, c};
  cacheActiveSet();
}

// Caches the geometry of the active set, for the fast path and the normals.
void ExactTracker::cacheActiveSet() noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (holders_[k] < 0) {
      held_[k] = {};
      continue;
    }
    const NearSphere on = near_.sphere(holders_[k]);
    Held& held = held_[k];  // member by member, which avoids a store and reload of the vector
    held.centre.x = on.centre.x, held.centre.y = on.centre.y, held.centre.z = on.centre.z;
    held.radius = on.radius;
    held.inverse_radius = on.radius > 0.0 ? 1.0 / on.radius : 0.0;
  }
}

// The full tick, which searches the surroundings.
Contact ExactTracker::stepFull(double x, double y, double z) noexcept {
  const Vec3 h(x, y, z);
  const PointA hip{h};
  if (!usableHip(h)) return refusedHip(hip, near_.origin() + scp_);
  if (resizing_) [[unlikely]]
    return stepWhileProbeGrows(h);
  const Vec3 local = h - near_.origin();
  if (moved_) [[unlikely]] {
    trackSurface(local);
    if (!moved_) return contact(h);
    moved_ = false;
  }
  if (!armed_) {
    if (near_.inside(local)) return {.scp = hip, .fault = Fault::StartedInside};
    const double gap = std::max(0.0, gapRound(local));
    free_gap2_ = gap * gap;
    armed_ = true;
    scp_ = free_from_ = local;
    return contact(h);
  }
  near_.resetWorkCount();
  flow(local);
  return contact(h);
}

// A tick while the probe grows or shrinks.
Contact ExactTracker::stepWhileProbeGrows(const Vec3& hip) noexcept {
  near_.resetWorkCount();
  if (!std::exchange(resized_, false)) resizeProbe();
  if (!armed_) return stepFull(hip.x, hip.y, hip.z);  // the surroundings have closed over the SCP
  flow(hip - near_.origin());
  if (resizing_) {
    forgetSurroundings();  // forces the next tick to come here
    cut_short_ += !behind_;
  }
  return contact(hip);
}

void ExactTracker::flow(const Vec3& hip) noexcept {
  const Vec3 was = scp_;
  const std::uint64_t limit = near_.workCount() + kMaxWork;
  behind_ = true;
  may_sink_ = false;
  int stuck = 0, idle = 0, small = 0;
  bool grazes = true;
  double left_A = glm::distance(hip, scp_);
  for (int count = 0; count < kMaxPieces && near_.workCount() < limit; ++count) {
    contact_A_ = contactAt(scp_);
    // A piece without motion may have moved the SCP within rounding: the same sets are tried once more from there.
    const Vec3 from = scp_;
    const SlideResult result = piece(hip, {.skip = std::max(0, stuck - 1), .grazes = grazes});
    if (result == SlideResult::Rests) {
      behind_ = false;
      break;
    }
    stuck = result == SlideResult::Stuck ? stuck + 1 : 0;
    small += glm::distance(from, scp_) < 0.25 * kLook_A;
    const double now_A = glm::distance(hip, scp_);
    ++idle;
    if (left_A - now_A > contact_A_) idle = 0, left_A = now_A;
    // A path that oscillates over a flat crease penetrates its two sides alternately. From now on both block it.
    if (grazes && (small >= kMaxGrazing || idle > kMaxIdle)) {
      grazes = false;
      idle = 0;
    }
    // If the SCP approaches the HIP only within rounding, its position is as good as any other.
    if (idle > kMaxIdle) {
      holdHere();
      behind_ = false;
      break;
    }
  }
  if (behind_) {
    ++cut_short_;
    forgetSurroundings();
  }
  // No SCP inside a sphere is returned. If rounding made it penetrate, it moves to the nearest free point, or back.
  if (may_sink_ && feature_ != Feature::Free && !outsideAll() && depenetrate() != Freed::Yes) {
    scp_ = was;
    holdHere();
    behind_ = true;
    ++cut_short_;
  }
}

// The SCP stays where it is; the next tick searches the surroundings again.
void ExactTracker::holdHere() noexcept {
  forgetSurroundings();
  feature_ = holders_[1] < 0 ? Feature::Sphere : holders_[2] < 0 ? Feature::Circle : Feature::Point;
}

// Performs one piece of the path.
ExactTracker::SlideResult ExactTracker::piece(const Vec3& hip, Admitted admitted) noexcept {
  if (feature_ == Feature::Free) return fly(hip);
  findTouching();
  const ActiveSet set = activeSet(hip - scp_, {touching_.data(), touching_count_}, contact_A_, admitted);
  may_sink_ |= int(touching_count_) > set.count;
  const auto by = [&](int k) { return touching_[std::size_t(set.by[std::size_t(k)])].sphere; };
  if (!set.found && admitted.skip > 0) {  // all sets that rounding admits have been tried
    holdHere();
    return SlideResult::Rests;
  }
  switch (set.count) {
    case 0:
      return fly(hip);
    case 1:
      if (!set.still || touching_count_ == 1) return slideOnSphere(hip, by(0));
      return restOnSphere(by(0), touching_[std::size_t(set.by[0])].normal);
    case 2: {
      const int third = set.still ? thirdOf(set) : -1;  // at a vertex, two active spheres at rest become three
      if (third < 0) return slideOnCircle(hip, by(0), by(1));
      holdAtPoint({by(0), by(1), touching_[std::size_t(third)].sphere});
      return SlideResult::Rests;
    }
    default:
      holdAtPoint({by(0), by(1), by(2)});
      return SlideResult::Rests;
  }
}

double ExactTracker::contactAt(const Vec3& place) const noexcept {
  return kContact * (std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) +
                     near_.scene().largestRadius_A() + probe_A());
}

// A touch whose normal is linearly independent of those of the set's two; -1: none.
int ExactTracker::thirdOf(const ActiveSet& set) const noexcept {
  const Vec3 line = glm::cross(touching_[std::size_t(set.by[0])].normal, touching_[std::size_t(set.by[1])].normal);
  for (std::size_t k = 0; k < touching_count_; ++k)
    if (std::abs(glm::dot(line, touching_[k].normal)) > 1e-6) return int(k);
  return -1;
}

// A piece shorter than 1/16 of the contact tolerance counts as no motion.
ExactTracker::SlideResult ExactTracker::slideResult(double moved_A) const noexcept {
  return moved_A > contact_A_ / 16.0 ? SlideResult::Continues : SlideResult::Stuck;
}

void ExactTracker::findTouching() noexcept {
  touching_count_ = 0;
  near_.each(scp_, contact_A_, [&](const NearSphere& b) {
    const double power = powerOf(scp_, b);
    if (power <= 2.0 * b.radius * contact_A_ && b.radius > 0.0 && touching_count_ < kMaxTouching)
      touching_[touching_count_++] = {glm::normalize(scp_ - b.centre), b.radius, power / (2.0 * b.radius), b.index};
  });
}

bool ExactTracker::outsideAll() noexcept {
  bool outside = true;
  near_.each(scp_, contact_A_,
             [&](const NearSphere& b) { outside &= powerOf(scp_, b) >= -16.0 * contact_A_ * b.radius; });
  return outside;
}

// A lower bound of the distance from a point to the nearest sphere; negative or zero inside or on a sphere.
double ExactTracker::gapRound(const Vec3& place) noexcept {
  double smallest = kMaxPosition_A;
  const double known =
      near_.each(place, kLook_A, [&](const NearSphere& b) { reduceGap(smallest, place - b.centre, b.radius); });
  return smallest < known ? smallest
                          : std::max(known, distanceToBox(near_.scene(), near_.probe_A(), near_.origin() + place));
}

// The first sphere on a straight path. For a short path the list of near spheres suffices.
Hit ExactTracker::firstHit(const Vec3& to) noexcept {
  const double length = glm::distance(scp_, to);
  if (!(length > 0.0)) return {};
  if (length <= kLook_A) {
    FirstHit first(scp_, (to - scp_) / length, length, contact_A_);
    const double known =
        near_.each(scp_, length, [&](const NearSphere& b) { first.look(b.index, b.centre, b.radius); });
    if (first.sphere() >= 0 && first.at() <= known) return {first.sphere(), std::min(1.0, first.at() / length)};
    if (known >= length) return {};
  }
  return near_.firstHit(scp_, to, contact_A_);
}

ExactTracker::SlideResult ExactTracker::fly(const Vec3& hip) noexcept {
  // A short path from free space needs no search along it: any sphere on it is within the path's length of its end.
  if (feature_ == Feature::Free) {
    const double gap = near_.knownInside(hip) ? 0.0 : gapRound(hip);
    if (gap > 0.0 && gap * gap > glm::dot(hip - scp_, hip - scp_)) {
      scp_ = free_from_ = hip;
      free_gap2_ = gap * gap;
      return SlideResult::Rests;
    }
  }
  const Hit hit = firstHit(hip);
  if (hit.sphere < 0) {
    feature_ = Feature::Free;
    holders_ = {-1, -1, -1};
    scp_ = free_from_ = hip;
    const double gap = std::max(0.0, gapRound(hip));
    free_gap2_ = gap * gap;
    return SlideResult::Rests;
  }
  const NearSphere met = near_.sphere(hit.sphere);
  const Vec3 out = scp_ + (hip - scp_) * hit.t - met.centre;
  const double far = glm::length(out);
  const SlideResult result = slideResult(hit.t * glm::length(hip - scp_));
  if (far > 0.0) scp_ = met.centre + out * (met.radius / far);
  feature_ = Feature::Sphere;
  holdBy(hit.sphere);
  return result;
}

// The SCP rests in `direction` from the sphere's centre. Caches its surroundings for the next ticks.
ExactTracker::SlideResult ExactTracker::restOnSphere(std::int32_t sphere, const Vec3& direction) noexcept {
  const NearSphere on = near_.sphere(sphere);
  feature_ = Feature::Sphere;
  holdBy(sphere);
  scp_ = on.centre + direction * on.radius;
  // The angle to the next cap, the nearest cap excluded; a cosine changes by at most one per radian.
  patch_ = {.centre = direction};
  double nearest_slack = 1.5, slack = 1.5;  // less than a hemisphere, so that paths between its points stay inside
  const double known = near_.each(scp_, kLook_A, [&](const NearSphere& other) {
    if (other.index == sphere || farFrom(on, other, powerOf(scp_, other), slack)) return;
    const Cap cap(on, other);
    const double distance = glm::length(cap.offset);
    // A sphere that protrudes by less than rounding represents the same surface.
    if (cap.level >= distance || distance + other.radius - on.radius <= contact_A_) return;
    const double gap = (cap.level - glm::dot(cap.offset, direction)) / distance;
    if (gap >= slack) return;
    slack = std::max(gap, nearest_slack);
    if (gap >= nearest_slack) return;
    nearest_slack = gap;
    patch_.axis = cap.offset / distance;
    patch_.rim = cap.level / distance;
  });
  slack = std::min(slack, known / on.radius);
  // For very small angles the cosine loses its precision; the next tick searches again.
  const auto cosine = [](double angle) { return angle > 1e-6 ? std::cos(angle) : 2.0; };
  patch_.cosine = cosine(slack);
  patch_.clear = cosine(std::min(slack, nearest_slack));
  return SlideResult::Rests;
}

// Case 1: the path on a sphere toward the point nearest to the HIP is a great circle.
ExactTracker::SlideResult ExactTracker::slideOnSphere(const Vec3& hip, std::int32_t sphere,
                                                      std::int32_t toward) noexcept {
  const NearSphere on = near_.sphere(sphere);
  const Vec3 c = on.centre, m = hip - c;
  const double r = on.radius, d = glm::length(m);
  const Vec3 x = glm::normalize(scp_ - c);
  if (d <= contact_A_) return restOnSphere(sphere, x);  // the HIP is at the centre: all paths are equally long
  const Vec3 nearest = m / d;
  Vec3 tangent = nearest - x * glm::dot(nearest, x);
  const double sine = glm::length(tangent);
  if (sine <= 1e-15)
    return restOnSphere(
        sphere, glm::dot(nearest, x) > 0.0 ? nearest : x);  // exactly behind the centre all paths are equally long
  tangent /= sine;
  tangent = glm::normalize(tangent -
                           x * glm::dot(tangent, x));  // nearly behind the centre the first difference loses precision
  const double arrives = std::atan2(sine, glm::dot(nearest, x));

  // If the HIP has left the sphere, flight begins at the point from which the sphere no longer hides the HIP.
  const double leaves = d > r ? std::max(0.0, arrives - std::acos(r / d)) : kNever;
  double end = std::min(arrives, leaves);
  bool meets = false;
  const double known = near_.each(scp_, std::min(kLook_A, end * r), [&](const NearSphere& other) {
    const double power = powerOf(scp_, other);
    if (other.index == sphere || farFrom(on, other, power, end)) return;
    const Cap cap(on, other);
    const double a = glm::dot(cap.offset, x), b = glm::dot(cap.offset, tangent);
    // A touched sphere that is not active is hit where the path has penetrated it by contact_A_.
    const double sinks =
        power <= 2.0 * other.radius * contact_A_ && other.index != toward ? contact_A_ * other.radius / r : 0.0;
    const double t = entryAngle(a, b, std::max(cap.level, a) + sinks);
    if (t < end) end = t, meets = true;
  });
  // Beyond the examined range the path restarts.
  const bool cut = end * r > known;
  if (cut) end = known / r;

  if (!meets && !cut && end == arrives) return restOnSphere(sphere, nearest);
  feature_ = Feature::Sphere;
  holdBy(sphere);
  scp_ = c + (x * std::cos(end) + tangent * std::sin(end)) * r;
  patch_.clear = patch_.cosine = 2.0;
  return slideResult(end * r);
}

// Computes the circle of spheres i and j (paper, equations 2 to 4) and its arc around the SCP that no third sphere
// covers.
ExactTracker::Made ExactTracker::makeCircle(std::int32_t i, std::int32_t j) noexcept {
  Circle& c = circle_;
  const NearSphere sphere_i = near_.sphere(i), sphere_j = near_.sphere(j);
  const Vec3 ci = sphere_i.centre, between = sphere_j.centre - ci;
  const double ri = sphere_i.radius, rj = sphere_j.radius;
  c.i = -1;
  c.between = glm::length(between);
  if (!(c.between > 0.0)) return Made::No;
  c.axis = between / c.between;
  c.to_i = (c.between * c.between + (ri - rj) * (ri + rj)) / (2.0 * c.between);
  c.to_j = c.between - c.to_i;
  const double radius2 = (ri - c.to_i) * (ri + c.to_i);
  c.centre = ci + c.axis * c.to_i;
  Vec3 out = scp_ - c.centre;
  out -= c.axis * glm::dot(out, c.axis);
  const double far = glm::length(out);
  if (!(radius2 > 0.0) || !(far > 0.0)) return Made::No;
  c.radius = std::sqrt(radius2);
  // Two nearly equal spheres touch along a whole zone, so the circle itself may be far away.
  const double off2 = glm::dot(scp_ - c.centre - out * (c.radius / far), scp_ - c.centre - out * (c.radius / far));
  if (off2 > 16.0 * contact_A_ * std::min(ri, rj)) return Made::FarOff;
  c.axis_1 = out / far;
  c.axis_2 = glm::cross(c.axis, c.axis_1);
  c.angle = 0.0;
  c.along_1 = 1.0;
  c.along_2 = 0.0;
  c.high = kTwoPi;
  c.low = -kTwoPi;
  const double known = near_.each(scp_, kLook_A, [&](const NearSphere& other) {
    if (other.index == i || other.index == j) return;
    const Vec3 offset = other.centre - c.centre;
    const double a = glm::dot(offset, c.axis_1), b = glm::dot(offset, c.axis_2);
    // The other sphere covers the angles with a cos + b sin > q.
    double q = (glm::dot(offset, offset) + (c.radius - other.radius) * (c.radius + other.radius)) / (2.0 * c.radius);
    if (q >= 0.0 && q * q >= a * a + b * b) return;
    // A touched sphere that is not active is hit where the path has penetrated it by contact_A_; here the power is 2 (q
    // - a) c.radius.
    const double sinks = contact_A_ * other.radius / c.radius;
    if (q - a <= sinks) q = std::max(q, a) + sinks;
    const auto [forward, backward] = entryAngles(a, b, q);
    c.high = std::min(c.high, forward);
    c.low = std::max(c.low, -backward);
  });
  // Beyond the examined range the circle is recomputed.
  const double seen = known / c.radius;
  c.high = std::min(c.high, seen);
  c.low = std::max(c.low, -seen);
  c.narrow = c.high - c.low < 3.0;
  if (c.narrow) {
    c.low_1 = std::cos(c.low);
    c.low_2 = std::sin(c.low);
    c.high_1 = std::cos(c.high);
    c.high_2 = std::sin(c.high);
  }
  c.i = i;
  c.j = j;
  return Made::Yes;
}

// Case 2: the shorter path along the circle of two spheres to the point nearest to the HIP.
ExactTracker::SlideResult ExactTracker::slideOnCircle(const Vec3& hip, std::int32_t i, std::int32_t j) noexcept {
  Circle& c = circle_;
  const bool same = feature_ == Feature::Circle && ((c.i == i && c.j == j) || (c.i == j && c.j == i));
  if (!same) {
    const Made made = makeCircle(i, j);
    if (made == Made::No) return SlideResult::Stuck;
    if (made == Made::FarOff) {  // slide on the outer sphere up to the circle
      const double gap_i = powerOf(scp_, near_.sphere(i)) / near_.sphere(i).radius,
                   gap_j = powerOf(scp_, near_.sphere(j)) / near_.sphere(j).radius;
      return gap_i <= gap_j ? slideOnSphere(hip, i, j) : slideOnSphere(hip, j, i);
    }
  }
  if (same && c.narrow) c.angle = std::atan2(c.along_2, c.along_1);
  const Vec3 m = hip - c.centre;
  const double along = glm::dot(m, c.axis), y1 = glm::dot(m, c.axis_1), y2 = glm::dot(m, c.axis_2);
  const double out = std::sqrt(y1 * y1 + y2 * y2);
  const bool off_axis = out > contact_A_;  // from the axis all paths are equally long
  double rotation = 0.0;
  if (off_axis) {
    rotation = std::atan2(y2, y1) - c.angle;
    rotation -= kTwoPi * std::round(rotation / kTwoPi);
  }
  const double to_go = std::abs(rotation), sign = rotation < 0.0 ? -1.0 : 1.0;

  // The multipliers of the two spheres are mu_i = (S to_j - along) / between and mu_j = (S to_i + along) / between,
  // with S = 1 - out cos(remaining rotation) / radius. Where one becomes zero, the SCP leaves that sphere.
  const auto released = [&](double to_other, double lean) {
    const double now = 1.0 - out * std::cos(to_go) / c.radius;
    if (now * to_other - lean < 0.0) return 0.0;
    if (to_other <= 0.0) return kNever;  // S decreases along the path, so this multiplier grows
    const double cosine = (1.0 - lean / to_other) * c.radius / std::max(out, 1e-300);
    if (cosine >= 1.0) return kNever;
    return std::max(0.0, to_go - std::acos(std::max(-1.0, cosine)));
  };
  const double meets = std::max(0.0, sign > 0.0 ? c.high - c.angle : c.angle - c.low);
  const double end = std::min({released(c.to_j, along), released(c.to_i, -along), meets});
  holdBy(i, j);
  if (to_go < meets && to_go <= end) {
    feature_ = Feature::Circle;
    c.angle += rotation;
    if (off_axis) {
      c.along_1 = y1 / out;
      c.along_2 = y2 / out;
      scp_ = c.centre + (c.axis_1 * y1 + c.axis_2 * y2) * (c.radius / out);
    } else if (!same) {
      scp_ = c.centre + c.axis_1 * c.radius;
    }
    return SlideResult::Rests;
  }
  const double angle = c.angle + sign * end;
  scp_ = c.centre + (c.axis_1 * std::cos(angle) + c.axis_2 * std::sin(angle)) * c.radius;
  feature_ = Feature::Point;  // temporarily: the cached circle belongs to another position
  circle_.i = -1;
  return slideResult(end * c.radius);
}

// Case 3: three spheres block the SCP at a point.
void ExactTracker::holdAtPoint(const std::array<std::int32_t, 3>& spheres) noexcept {
  std::array<Vec3, 3> n;
  for (std::size_t k = 0; k < 3; ++k) {
    const NearSphere b = near_.sphere(spheres[k]);
    n[k] = (scp_ - b.centre) / b.radius;
  }
  const double volume = glm::dot(glm::cross(n[0], n[1]), n[2]);
  holds_ = {glm::cross(n[1], n[2]) / volume, glm::cross(n[2], n[0]) / volume, glm::cross(n[0], n[1]) / volume};
  holds_known_ = true;
  holdBy(spheres[0], spheres[1], spheres[2]);
  feature_ = Feature::Point;
}

}  // namespace moltact
