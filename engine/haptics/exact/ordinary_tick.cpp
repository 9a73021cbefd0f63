// The fast path for ordinary ticks: the SCP stays on its feature, and the cached surroundings exclude obstacles on its
// path. Part of ExactTracker; haptic thread. Units: angstrom; radian.
#include <cmath>

#include "engine/haptics/exact/entry_angle.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/hip_input.h"

namespace moltact {
namespace {

constexpr double kArcOfChord2 =
    2.4674011002723397;  // an arc of up to half a turn is at most pi / 2 times as long as its chord

}  // namespace

// The contact with the first `count` spheres of held_ as active set. Each number is stored directly in the result;
// temporary vectors would cost a store and reload.
inline Contact ExactTracker::contactHeldBy(std::size_t count, const Vec3& hip) const noexcept {
  const auto normal = [&](std::size_t k) {
    return k < count ? (scp_ - held_[k].centre) * held_[k].inverse_radius : Vec3(0.0);
  };
  Contact out{.scp = {near_.origin() + scp_},
              .atoms = holders_,
              .feature = feature_,
              .normals = {normal(0), normal(1), normal(2)}};
  stretchToScp(out, {hip});
  return out;
}

Contact ExactTracker::contact(const Vec3& hip) const noexcept {
  if (feature_ == Feature::Free) return {.scp = {behind_ ? near_.origin() + scp_ : hip}, .atoms = holders_};
  return contactHeldBy(3, hip);
}

Contact ExactTracker::step(PointA hip) noexcept {
  const Vec3& h = hip.A;
  // The most frequent case: free, and nothing within reach. A HIP that is NaN fails the comparison.
  if (feature_ == Feature::Free && armed_) {
    const Vec3& o = near_.origin();
    const double x = h.x - o.x, y = h.y - o.y,
                 z = h.z - o.z;  // separate scalars avoid a store and reload of the vector
    const double dx = x - free_from_.x, dy = y - free_from_.y, dz = z - free_from_.z;
    if (dx * dx + dy * dy + dz * dz < free_gap2_) {
      scp_.x = x, scp_.y = y, scp_.z = z;
      return {.scp = hip};
    }
  }
  return stepFast(h.x, h.y, h.z);
}

// A tick in contact, as a separate function so that free ticks need not save its registers. Computes the point of the
// feature nearest to the HIP; if that may be incomplete, runs the full tick with unchanged state. It need not test for
// moving spheres or a changing probe, because these invalidate the cache (forgetSurroundings).
Contact ExactTracker::stepFast(double x, double y, double z) noexcept {
  const Vec3 h(x, y, z);
  if (!usableHip(h)) return stepFull(x, y, z);
  const Vec3 hip = h - near_.origin();
  switch (feature_) {
    case Feature::Free:
      break;  // handled in step()
    case Feature::Sphere: {
      const Held& sphere = held_[0];
      const Vec3 m = hip - sphere.centre;
      const double r = sphere.radius, d2 = glm::dot(m, m);
      if (d2 >= r * r || d2 < r * r * 1e-6) break;
      const double d = std::sqrt(d2), along = glm::dot(m, patch_.centre);
      const Vec3 to = m * (r / d);  // from the centre to the sphere's point nearest to the HIP
      if (along < patch_.clear * d) {
        if (along < patch_.cosine * d) break;
        // The path over the nearest cap's rim is longer than the direct path between the two positions.
        const Vec3 from = scp_ - sphere.centre, chord = to - from;
        const double rim = patch_.rim * r, gap = rim - glm::dot(to, patch_.axis),
                     by_rim = rim - glm::dot(from, patch_.axis) + gap;
        if (gap <= 0.0 || by_rim * by_rim <= kArcOfChord2 * glm::dot(chord, chord)) break;
      }
      scp_ = sphere.centre + to;
      return contactHeldBy(1, h);
    }
    case Feature::Circle: {
      const Circle& c = circle_;
      if (c.i < 0) break;
      const Vec3 m = hip - c.centre;
      const double along = glm::dot(m, c.axis), y1 = glm::dot(m, c.axis_1), y2 = glm::dot(m, c.axis_2);
      const double out = std::sqrt(y1 * y1 + y2 * y2);
      if (out < 1e-6 * c.radius) break;
      // Both spheres must block the SCP along the whole path: multipliers mu_i, mu_j >= 0 (docs/exact-tracker.md), here
      // times the circle's radius to avoid a division.
      const double start = c.radius - (y1 * c.along_1 + y2 * c.along_2), end = c.radius - out, lean = along * c.radius;
      const double slack_i = std::min(start * c.to_j, end * c.to_j) - lean,
                   slack_j = std::min(start * c.to_i, end * c.to_i) + lean;
      if (slack_i < 0.0 || slack_j < 0.0) break;
      if (c.narrow) {  // between ends less than half a turn apart, the short path stays inside
        if (c.low_1 * y2 - c.low_2 * y1 <= 0.0 || y1 * c.high_2 - y2 * c.high_1 <= 0.0) break;
      } else {
        double angle = std::atan2(y2, y1);
        angle += kTwoPi * std::round((c.angle - angle) / kTwoPi);  // the shorter path
        if (angle <= c.low || angle >= c.high) break;
        circle_.angle = angle;
      }
      circle_.along_1 = y1 / out;
      circle_.along_2 = y2 / out;
      scp_ = c.centre + (c.axis_1 * y1 + c.axis_2 * y2) * (c.radius / out);
      return contactHeldBy(2, h);
    }
    case Feature::Point: {
      if (!holds_known_) break;
      const Vec3 displacement = hip - scp_;
      if (glm::dot(holds_[0], displacement) <= 0.0 && glm::dot(holds_[1], displacement) <= 0.0 &&
          glm::dot(holds_[2], displacement) <= 0.0)
        return contactHeldBy(3, h);
      break;
    }
  }
  return stepFull(x, y, z);
}

}  // namespace moltact
