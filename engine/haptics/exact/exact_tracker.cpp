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

// Rounding moves a place by at most some eight units in the last place of the largest coordinate or radius, 2^-50 of
// it. What is within 128 times as much of the SCP is touched (docs/exact-tracker.md, "What rounding may do").
constexpr double kContact = 0x1p-43;

// Every sphere that comes within kLook_A of the SCP is looked at before a path goes on; a list of them serves until the
// SCP has gone kMargin_A farther. Longer lists are dearer to gather, shorter ones are gathered more often.
constexpr double kLook_A = 0.5, kMargin_A = 1.0;

// Pieces, one after the other, that together bring the SCP no nearer to the HIP, before it stays where it is.
constexpr int kMaxIdle = 12;
// Small pieces of a flow after which ways no longer graze: one that takes more goes to and fro over a crease too flat
// to be seen at once. So does one that comes no nearer to the HIP.
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
  if (swells_) near_.setProbe(goal_A_);
  armed_ = behind_ = swells_ = false;
  feature_ = Feature::Free;
  holders_ = {-1, -1, -1};
  forgetSurroundings();
}

MemoryUsage ExactTracker::memoryUsage() const noexcept { return {near_.held(), sizeof(*this) + near_.scene().bytes()}; }

// The spheres that hold the SCP, in ascending order.
void ExactTracker::holdBy(std::int32_t a, std::int32_t b, std::int32_t c) noexcept {
  if (b >= 0 && b < a) std::swap(a, b);
  if (c >= 0 && c < b) std::swap(b, c);
  if (b >= 0 && b < a) std::swap(a, b);
  holders_ = {a, b, c};
  lookAtHolders();
}

// What an ordinary tick and the normals are made from.
void ExactTracker::lookAtHolders() noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (holders_[k] < 0) {
      held_[k] = {};
      continue;
    }
    const NearSphere on = near_.sphere(holders_[k]);
    Held& held = held_[k];  // one by one: as a vector they would go through memory once more
    held.centre.x = on.centre.x, held.centre.y = on.centre.y, held.centre.z = on.centre.z;
    held.radius = on.radius;
    held.inverse_radius = on.radius > 0.0 ? 1.0 / on.radius : 0.0;
  }
}

// A tick that must look round.
Contact ExactTracker::stepFull(double x, double y, double z) noexcept {
  const Vec3 h(x, y, z);
  const PointA hip{h};
  if (!usableHip(h)) return refusedHip(hip, near_.origin() + scp_);
  if (swells_) [[unlikely]]
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

// A tick in which the surface grows or shrinks to another probe.
Contact ExactTracker::stepWhileProbeGrows(const Vec3& hip) noexcept {
  near_.resetWorkCount();
  if (!std::exchange(swelled_, false)) swell();
  if (!armed_) return stepFull(hip.x, hip.y, hip.z);  // the place has closed
  flow(hip - near_.origin());
  if (swells_) {
    forgetSurroundings();  // the next tick must come here
    cut_short_ += !behind_;
  }
  return contact(hip);
}

void ExactTracker::flow(const Vec3& hip) noexcept {
  const Vec3 was = scp_;
  const std::uint64_t most = near_.looked() + kMaxLooked;
  behind_ = true;
  may_sink_ = false;
  int stuck = 0, idle = 0, small = 0;
  bool grazes = true;
  double left_A = glm::distance(hip, scp_);
  for (int count = 0; count < kMaxPieces && near_.looked() < most; ++count) {
    contact_A_ = contactAt(scp_);
    // The first piece that leads nowhere may have moved the SCP within rounding: the same sets are tried from there
    // once more.
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
    // To and fro over a flat crease a path sinks into its two sides alternately: from now on both block it.
    if (grazes && (small >= kMaxGrazing || idle > kMaxIdle)) {
      grazes = false;
      idle = 0;
    }
    // Where the SCP comes no nearer to the HIP but for rounding, it is as good a place as any.
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
  // No SCP is handed out inside a sphere: where rounding has let it sink, it goes to the nearest free place, or back.
  if (may_sink_ && feature_ != Feature::Free && !outsideAll() && depenetrate() != Freed::Yes) {
    scp_ = was;
    holdHere();
    behind_ = true;
    ++cut_short_;
  }
}

// The SCP stays where it is; the next tick looks round again.
void ExactTracker::holdHere() noexcept {
  forgetSurroundings();
  feature_ = holders_[1] < 0 ? Feature::Sphere : holders_[2] < 0 ? Feature::Circle : Feature::Point;
}

// One piece of the path.
ExactTracker::SlideResult ExactTracker::piece(const Vec3& hip, Admitted admitted) noexcept {
  if (feature_ == Feature::Free) return fly(hip);
  findTouching();
  const ActiveSet set = activeSet(hip - scp_, {touching_.data(), touching_count_}, contact_A_, admitted);
  may_sink_ |= int(touching_count_) > set.count;
  const auto by = [&](int k) { return touching_[std::size_t(set.by[std::size_t(k)])].sphere; };
  if (!set.found && admitted.skip > 0) {  // every path that rounding admits has been tried
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
      const int third = set.still ? thirdOf(set) : -1;  // what two hold in a place where three meet, the place holds
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

// A touch whose normal stands out of the plane of those of the set's two; -1: none.
int ExactTracker::thirdOf(const ActiveSet& set) const noexcept {
  const Vec3 line = glm::cross(touching_[std::size_t(set.by[0])].normal, touching_[std::size_t(set.by[1])].normal);
  for (std::size_t k = 0; k < touching_count_; ++k)
    if (std::abs(glm::dot(line, touching_[k].normal)) > 1e-6) return int(k);
  return -1;
}

// A path under 1/16 of what counts as touching leads nowhere.
ExactTracker::SlideResult ExactTracker::slideResult(double moved_A) const noexcept {
  return moved_A > contact_A_ / 16.0 ? SlideResult::GoesOn : SlideResult::Stuck;
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

// A lower bound of the distance from a place to the nearest sphere; negative or zero inside or on one.
double ExactTracker::gapRound(const Vec3& place) noexcept {
  double least = kFarthest_A;
  const double known =
      near_.each(place, kLook_A, [&](const NearSphere& b) { lessenGap(least, place - b.centre, b.radius); });
  return least < known ? least : std::max(known, distanceToBox(near_.scene(), near_.probe_A(), near_.origin() + place));
}

// The first sphere on a straight path. A short one meets only what is known to be near.
Hit ExactTracker::firstMet(const Vec3& to) noexcept {
  const double length = glm::distance(scp_, to);
  if (!(length > 0.0)) return {};
  if (length <= kLook_A) {
    FirstMet first(scp_, (to - scp_) / length, length, contact_A_);
    const double known =
        near_.each(scp_, length, [&](const NearSphere& b) { first.look(b.index, b.centre, b.radius); });
    if (first.sphere() >= 0 && first.at() <= known) return {first.sphere(), std::min(1.0, first.at() / length)};
    if (known >= length) return {};
  }
  return near_.firstMet(scp_, to, contact_A_);
}

ExactTracker::SlideResult ExactTracker::fly(const Vec3& hip) noexcept {
  // From free space a short path needs no search along it: a sphere on it would be as near to its end as the path is
  // long.
  if (feature_ == Feature::Free) {
    const double gap = near_.knownInside(hip) ? 0.0 : gapRound(hip);
    if (gap > 0.0 && gap * gap > glm::dot(hip - scp_, hip - scp_)) {
      scp_ = free_from_ = hip;
      free_gap2_ = gap * gap;
      return SlideResult::Rests;
    }
  }
  const Hit hit = firstMet(hip);
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

// The SCP rests where `direction` leads from the sphere's centre: the next ticks are told what is round it.
ExactTracker::SlideResult ExactTracker::restOnSphere(std::int32_t sphere, const Vec3& direction) noexcept {
  const NearSphere on = near_.sphere(sphere);
  feature_ = Feature::Sphere;
  holdBy(sphere);
  scp_ = on.centre + direction * on.radius;
  // The angle to go until a cap is met, the nearest cap apart: a cosine changes by at most one a radian.
  patch_ = {.centre = direction};
  double nearest_slack = 1.5, slack = 1.5;  // under a hemisphere: paths between its places stay in it
  const double known = near_.each(scp_, kLook_A, [&](const NearSphere& other) {
    if (other.index == sphere || farFrom(on, other, powerOf(scp_, other), slack)) return;
    const Cap cap(on, other);
    const double distance = glm::length(cap.offset);
    // A sphere that stands out by less than rounding can tell stands for the same surface.
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
  // Under so small an angle the cosine has no digits left: the next tick looks again.
  const auto cosine = [](double angle) { return angle > 1e-6 ? std::cos(angle) : 2.0; };
  patch_.cosine = cosine(slack);
  patch_.clear = cosine(std::min(slack, nearest_slack));
  return SlideResult::Rests;
}

// Case 1: the path on a sphere toward the place nearest to the HIP is a great circle.
ExactTracker::SlideResult ExactTracker::slideOnSphere(const Vec3& hip, std::int32_t sphere,
                                                      std::int32_t toward) noexcept {
  const NearSphere on = near_.sphere(sphere);
  const Vec3 c = on.centre, m = hip - c;
  const double r = on.radius, d = glm::length(m);
  const Vec3 x = glm::normalize(scp_ - c);
  if (d <= contact_A_) return restOnSphere(sphere, x);  // from the centre every path is equally long
  const Vec3 nearest = m / d;
  Vec3 tangent = nearest - x * glm::dot(nearest, x);
  const double sine = glm::length(tangent);
  if (sine <= 1e-15)
    return restOnSphere(sphere,
                        glm::dot(nearest, x) > 0.0 ? nearest : x);  // straight behind the centre no path is shorter
  tangent /= sine;
  tangent = glm::normalize(tangent -
                           x * glm::dot(tangent, x));  // nearly behind the centre the first difference has few digits
  const double arrives = std::atan2(sine, glm::dot(nearest, x));

  // A HIP that has come out of the sphere is seen from where the sphere no longer hides it: there the flight begins.
  const double leaves = d > r ? std::max(0.0, arrives - std::acos(r / d)) : kNever;
  double end = std::min(arrives, leaves);
  bool meets = false;
  const double known = near_.each(scp_, std::min(kLook_A, end * r), [&](const NearSphere& other) {
    const double power = powerOf(scp_, other);
    if (other.index == sphere || farFrom(on, other, power, end)) return;
    const Cap cap(on, other);
    const double a = glm::dot(cap.offset, x), b = glm::dot(cap.offset, tangent);
    // What is touched and does not hold is met where the path has sunk by contact_A_ into it.
    const double sinks =
        power <= 2.0 * other.radius * contact_A_ && other.index != toward ? contact_A_ * other.radius / r : 0.0;
    const double t = entryAngle(a, b, std::max(cap.level, a) + sinks);
    if (t < end) end = t, meets = true;
  });
  // Beyond what has been looked at the path is begun anew.
  const bool cut = end * r > known;
  if (cut) end = known / r;

  if (!meets && !cut && end == arrives) return restOnSphere(sphere, nearest);
  feature_ = Feature::Sphere;
  holdBy(sphere);
  scp_ = c + (x * std::cos(end) + tangent * std::sin(end)) * r;
  patch_.clear = patch_.cosine = 2.0;
  return slideResult(end * r);
}

// The circle of spheres i and j (paper, equations 2 to 4) and the arc of it, round the SCP, that no third sphere covers.
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
  // Of two spheres that nearly are one, all of a zone is touched by both: the circle itself may be far off.
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
    // It covers the angles whose a cos + b sin is greater than q.
    double q = (glm::dot(offset, offset) + (c.radius - other.radius) * (c.radius + other.radius)) / (2.0 * c.radius);
    if (q >= 0.0 && q * q >= a * a + b * b) return;
    // What is touched and does not hold is met where the path has sunk by contact_A_ into it; the power here is 2 (q -
    // a) c.radius.
    const double sinks = contact_A_ * other.radius / c.radius;
    if (q - a <= sinks) q = std::max(q, a) + sinks;
    const auto [forward, backward] = entryAngles(a, b, q);
    c.high = std::min(c.high, forward);
    c.low = std::max(c.low, -backward);
  });
  // Beyond what has been looked at the circle is made anew.
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

// Case 2: the path along the circle of two spheres, the short way round to the place nearest to the HIP.
ExactTracker::SlideResult ExactTracker::slideOnCircle(const Vec3& hip, std::int32_t i, std::int32_t j) noexcept {
  Circle& c = circle_;
  const bool same = feature_ == Feature::Circle && ((c.i == i && c.j == j) || (c.i == j && c.j == i));
  if (!same) {
    const Made made = makeCircle(i, j);
    if (made == Made::No) return SlideResult::Stuck;
    if (made == Made::FarOff) {  // on the outer one as far as their circle
      const double gap_i = powerOf(scp_, near_.sphere(i)) / near_.sphere(i).radius,
                   gap_j = powerOf(scp_, near_.sphere(j)) / near_.sphere(j).radius;
      return gap_i <= gap_j ? slideOnSphere(hip, i, j) : slideOnSphere(hip, j, i);
    }
  }
  if (same && c.narrow) c.angle = std::atan2(c.along_2, c.along_1);
  const Vec3 m = hip - c.centre;
  const double along = glm::dot(m, c.axis), y1 = glm::dot(m, c.axis_1), y2 = glm::dot(m, c.axis_2);
  const double out = std::sqrt(y1 * y1 + y2 * y2);
  const bool off_axis = out > contact_A_;  // from the axis every path is equally long
  double rotation = 0.0;
  if (off_axis) {
    rotation = std::atan2(y2, y1) - c.angle;
    rotation -= kTwoPi * std::round(rotation / kTwoPi);
  }
  const double to_go = std::abs(rotation), sign = rotation < 0.0 ? -1.0 : 1.0;

  // mu_i = (S to_j - along) / between and mu_j = (S to_i + along) / between, with S = 1 - out cos(rotation to go) /
  // radius, are the spheres' shares in holding the SCP; where one falls to nothing the SCP leaves that sphere.
  const auto released = [&](double to_other, double lean) {
    const double now = 1.0 - out * std::cos(to_go) / c.radius;
    if (now * to_other - lean < 0.0) return 0.0;
    if (to_other <= 0.0) return kNever;  // S falls as the SCP goes on: this share grows
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
  feature_ = Feature::Point;  // no feature yet: the circle is that of another place
  circle_.i = -1;
  return slideResult(end * c.radius);
}

// Case 3: three spheres hold the SCP in a point.
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
