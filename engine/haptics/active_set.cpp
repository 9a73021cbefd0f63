#include "engine/haptics/active_set.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr int kMaxTried = 6;             // number of touches among which every set of up to three is tried
constexpr double kSteep = 1e-3;          // sine above which a path into a sphere does not graze it
constexpr double kArithmetic = 0x1p-50;  // relative rounding of a sum of a few products
constexpr double kParallel = 1e-26;  // squared sine or squared volume below which normals count as linearly dependent

// The motion that a set leaves of the displacement, and the curvature of its path: the acceleration at unit speed,
// toward the centre of the blocking sphere or circle.
struct Motion {
  Vec3 left{0.0}, curvature{0.0};
  double far = INFINITY, bend = 0.0,
         loose = 0.0;  // as in nearCentre_A; far is infinite if the motion is computed otherwise
};

// True if only rounding is left of the displacement.
bool isStill(const Vec3& left, double displacement_A, std::span<const Touch> touches, double contact_A,
             const std::array<int, 3>& by) {
  double still_A = 0.0;
  for (const int k : by)
    if (k >= 0) still_A = std::max(still_A, stillUnder_A(touches[std::size_t(k)], contact_A, displacement_A));
  return glm::dot(left, left) <= still_A * still_A;
}

// Tries every set of up to three among a few touches, smallest first, until one is acceptable.
class Trial {
 public:
  Trial(const Vec3& displacement, std::span<const Touch> touches, double contact_A, Admitted admitted)
      : displacement_(displacement),
        touches_(touches),
        contact_(contact_A),
        length_(glm::length(displacement)),
        admitted_(admitted) {}

  // Adds a touch in the list's order, so that among equals the first is tried first. If the list is full, a touch that
  // is not in the active set is replaced.
  void add(int touch) {
    if (tried_count_ == kMaxTried) {
      const auto holds = [&](int t) { return std::find(best_.by.begin(), best_.by.end(), t) != best_.by.end(); };
      (void)std::remove(tried_.begin(), tried_.end(), *std::find_if_not(tried_.begin(), tried_.end(), holds));
      --tried_count_;
    }
    int at = tried_count_++;
    for (; at > 0 && tried_[std::size_t(at - 1)] > touch; --at) tried_[std::size_t(at)] = tried_[std::size_t(at - 1)];
    tried_[std::size_t(at)] = touch;
  }

  ActiveSet best() {
    best_ = {};
    motion_ = {displacement_};
    passed_ = 0;
    min_ = INFINITY;
    const int n = tried_count_;
    if (offer({-1, -1, -1}, 0, {displacement_})) return best_;
    for (int a = 0; a < n; ++a) {
      if (glm::dot(displacement_, normal(a)) < 0.0 && offer({tried_[std::size_t(a)], -1, -1}, 1, alone(a)))
        return best_;
    }
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        if (pair(a, b)) return best_;
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        for (int c = b + 1; c < n; ++c)
          if (triple(a, b, c)) return best_;
    best_.found = false;  // the result is the set that leads least into a touch
    return best_;
  }

  // The touch that the remaining displacement violates most, beyond rounding; -1: none.
  int mostViolated() const {
    int worst = -1;
    double largest = 1.0;
    for (std::size_t k = 0; k < touches_.size(); ++k)
      if (int(k) == best_.by[0] || int(k) == best_.by[1] || int(k) == best_.by[2])
        continue;
      else if (const double v = violation(motion_, touches_[k]); v > largest)
        largest = v, worst = int(k);
    return worst;
  }

  bool tries(int touch) const {
    return std::find(tried_.begin(), tried_.begin() + tried_count_, touch) != tried_.begin() + tried_count_;
  }

 private:
  const Vec3& normal(int a) const { return touch(a).normal; }
  const Touch& touch(int a) const { return touches_[std::size_t(tried_[std::size_t(a)])]; }
  double bound(const Motion& m, const Touch& t) const {
    return std::isfinite(m.far) ? nearCentre_A(t, contact_, m.far, m.bend, m.loose) : rounding_A(t, contact_, length_);
  }

  // The motion with one active touch. On a sphere it is computed from the displacement relative to its centre. With two
  // nearly equal spheres and the HIP near both centres, only this reveals how one sphere leads into the other.
  Motion alone(int a) const {
    const Touch& t = touch(a);
    const Vec3 curvature = t.normal * (-1.0 / t.radius);
    if (admitted_.grazes || !std::isfinite(t.radius))
      return {displacement_ - glm::dot(displacement_, t.normal) * t.normal, curvature};
    const Vec3 from_centre = displacement_ + (t.radius + t.gap) * t.normal;
    return {from_centre - glm::dot(from_centre, t.normal) * t.normal, curvature, glm::length(from_centre),
            1.0 / t.radius};
  }

  // The part of a motion that leads into a touch, relative to the tolerance: a value of 1 or more counts as blocked.
  double violation(const Motion& m, const Touch& t) const {
    const double into = -glm::dot(m.left, t.normal);
    if (into <= 0.0) return 0.0;
    double allowed = bound(m, t);
    if (into > kSteep * length_ || !admitted_.grazes || into <= allowed) return into / allowed;
    allowed += glm::length(m.left) * grazing(t, contact_, 1.0 / t.radius + glm::dot(m.curvature, t.normal));
    return into / allowed;
  }

  bool offer(std::array<int, 3> by, int count, const Motion& motion) {
    double largest = 0.0;
    for (int a = 0; a < tried_count_; ++a)  // active touches cannot be violated
      if (std::find(by.begin(), by.end(), tried_[std::size_t(a)]) == by.end())
        largest = std::max(largest, violation(motion, touch(a)));
    if (largest > 1.0 && largest >= min_) return false;
    if (largest <= 1.0 && passed_++ < admitted_.skip) return false;
    min_ = largest;
    best_ = {count, by, isStill(motion.left, length_, touches_, contact_, by), true};
    motion_ = motion;
    return largest <= 1.0;
  }

  // Both multipliers must be pushes, or zero within rounding.
  bool pair(int a, int b) {
    const Vec3 &na = normal(a), &nb = normal(b), line = glm::cross(na, nb);
    const double sine2 = glm::dot(line, line);
    if (sine2 < kParallel) return false;
    const double cosine = glm::dot(na, nb);
    // Two spheres that touch from outside have no circle distinguishable from a point; either alone blocks like both.
    if (cosine < 0.0 && sine2 < 16.0 * contact_ * (1.0 / touch(a).radius + 1.0 / touch(b).radius)) return false;
    // Each sphere must lead into the other, or lead out only within rounding.
    const Motion by_a = alone(a), by_b = alone(b);
    if (-glm::dot(by_b.left, na) < -bound(by_b, touch(a)) || -glm::dot(by_a.left, nb) < -bound(by_a, touch(b)))
      return false;
    // On both spheres: curvature . n_a = -1 / R_a and curvature . n_b = -1 / R_b.
    const double bend_a = 1.0 / touch(a).radius, bend_b = 1.0 / touch(b).radius;
    const Vec3 curvature = (na * (bend_b * cosine - bend_a) + nb * (bend_a * cosine - bend_b)) / sine2;
    const Motion& near = by_a.far <= by_b.far ? by_a : by_b;  // along the line both sums are equal
    return offer({tried_[std::size_t(a)], tried_[std::size_t(b)], -1}, 2,
                 {line * (glm::dot(near.left, line) / sine2), curvature, near.far, std::max(bend_a, bend_b),
                  kArithmetic / std::sqrt(sine2)});
  }

  bool triple(int a, int b, int c) {
    const Vec3 &na = normal(a), &nb = normal(b), &nc = normal(c);
    const Vec3 ab = glm::cross(na, nb), bc = glm::cross(nb, nc), ca = glm::cross(nc, na);
    const double volume = glm::dot(ab, nc);
    if (volume * volume < kParallel) return false;
    const double side = volume < 0.0 ? 1.0 : -1.0;
    const auto bound = [&](int k) {
      return rounding_A(touch(k), contact_, length_, admitted_.grazes || !std::isfinite(touch(k).radius));
    };
    if (side * glm::dot(displacement_, bc) < -bound(a) || side * glm::dot(displacement_, ca) < -bound(b) ||
        side * glm::dot(displacement_, ab) < -bound(c))
      return false;
    return offer({tried_[std::size_t(a)], tried_[std::size_t(b)], tried_[std::size_t(c)]}, 3, {});
  }

  Vec3 displacement_;
  Motion motion_;
  std::span<const Touch> touches_;
  double contact_, length_, min_ = INFINITY;
  Admitted admitted_;
  int passed_ = 0, tried_count_ = 0;
  std::array<int, kMaxTried> tried_{};
  ActiveSet best_;
};

// Handles one or two touches that rounding cannot make ambiguous, the common case; false otherwise.
bool plainly(const Vec3& displacement, std::span<const Touch> touches, double contact_A, ActiveSet& set) {
  const double length = glm::length(displacement), steep = kSteep * length;
  const double into_0 = -glm::dot(displacement, touches[0].normal);
  if (touches.size() == 1) {
    if (into_0 > 0.0 && into_0 <= steep) return false;
    if (into_0 > 0.0) set = {.count = 1, .by = {0, -1, -1}};
    return true;
  }
  const double into_1 = -glm::dot(displacement, touches[1].normal),
               cosine = glm::dot(touches[0].normal, touches[1].normal);
  const auto one = [&](int by, double into) {
    const Vec3 left = displacement + into * touches[std::size_t(by)].normal;
    set = {.count = 1, .by = {by, -1, -1}};
    set.still = isStill(left, length, touches, contact_A, set.by);
    return true;
  };
  // The amount by which the displacement remaining on one sphere leads into the other.
  const double then_1 = into_1 - into_0 * cosine, then_0 = into_0 - into_1 * cosine;
  const double doubt = kArithmetic * length;
  if (into_0 > steep && then_1 <= -doubt) return one(0, into_0);
  if (into_1 > steep && then_0 <= -doubt) return one(1, into_1);
  if (into_0 <= steep || into_1 <= steep || then_0 <= steep || then_1 <= steep) return false;
  set = {.count = 2, .by = {0, 1, -1}};
  return true;
}

}  // namespace

ActiveSet activeSet(const Vec3& displacement, std::span<const Touch> touches, double contact_A,
                    Admitted admitted) noexcept {
  ActiveSet set;
  if (touches.empty()) return set;
  if (touches.size() <= 2 && admitted.skip == 0 && plainly(displacement, touches, contact_A, set)) return set;
  Trial trial(displacement, touches, contact_A, admitted);
  // Each round adds the touch that the best motion so far violates most, as in non-negative least squares (Lawson &
  // Hanson 1974). The remaining displacement becomes shorter, so no set repeats.
  for (int round = 0; round < 4 * kMaxTried; ++round) {
    set = trial.best();
    const int worst = trial.mostViolated();
    if (worst < 0 || trial.tries(worst)) break;
    trial.add(worst);
  }
  return set;
}

}  // namespace moltact
