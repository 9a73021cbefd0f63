// A brute-force god-object on a union of spheres, by which the trackers are judged in tests and benches; slow on purpose.
// The ideal SCP s flows along the steepest descent of |x - h|^2 from its last place, staying outside every sphere (sphere i
// has radius R_i = radius + probe), until it rests or reaches the HIP h. It differs from a tracker in this: long double
// throughout; every sphere examined in a loop; no neighbour lists; no closed form for the place where a path enters a
// sphere (sign changes are bracketed and bisected); the spheres that hold the point found by trying every set of up to
// three touching ones; and four perturbed copies whose HIPs are 1e-9 A away, which show whether the answer is
// ill-conditioned. Units: angstrom.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact::oracle {

/// The distance of the perturbed copies' HIPs from the true one (unit: angstrom).
inline constexpr double kPerturbation_A = 1e-9;

struct PointL {
  long double x = 0, y = 0, z = 0;
};

class Oracle {
 public:
  /// Without perturbed copies it is faster, and each answer counts as decided.
  Oracle(std::vector<Sphere> spheres, double probe_A, bool perturbed = true);

  struct Answer {
    bool contact = false;
    Vec3 scp_A{0.0};          ///< the HIP when there is no contact
    double accuracy_A = 0.0;  ///< the error bound of this answer itself
    /// False when a HIP 1e-9 A away ends in another place or flag: two outcomes are right. A test then judges another
    /// answer by `deepest` and `atRest` alone, and calls `place` to continue from that answer.
    bool decided = true;
    bool started_inside = false;  ///< the HIP has not been outside yet; no contact until then
  };

  /// One tick for a finite HIP.
  Answer step(Vec3 hip);

  /// Goes on from another tracker's SCP (pushed out of the spheres first where rounding left it inside).
  void place(Vec3 scp);

  /// As at the start.
  void reset();

 private:
  struct Flow {
    PointL s;
    bool arrived = true;  // at the HIP: no contact
    bool settled = true;  // false when the rounds ran out
  };
  Flow flow(PointL s, PointL hip) const;

  std::vector<PointL> centres_;  // relative to origin_
  std::vector<long double> radii_;
  PointL origin_;
  std::size_t flows_ = 5;
  bool been_outside_ = false;
  std::array<PointL, 5> s_;  // the true one first, then the perturbed copies
};

/// The greatest penetration of p into any sphere, in long double; negative outside; -infinity without spheres.
double deepest(const std::vector<Sphere>& spheres, double probe_A, Vec3 p);

/// Whether scp is at rest for that hip: |h - s + sum mu_k n_k| <= tolerance_A for some mu_k >= 0 over the spheres whose
/// surface is within tolerance_A of scp (the Karush-Kuhn-Tucker condition; n_k outward unit normals).
bool atRest(const std::vector<Sphere>& spheres, double probe_A, Vec3 scp, Vec3 hip, double tolerance_A);

}  // namespace moltact::oracle
