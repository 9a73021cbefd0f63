// A brute-force god-object on a union of spheres, the reference for the trackers in tests and benchmarks; slow by
// design. The ideal SCP s descends the steepest gradient of |x - h|^2 from its last position until it rests or reaches
// the HIP h. It stays outside every sphere (of radius R_i = radius + probe). Differences from the trackers:
// * long double throughout; every sphere is examined in a loop, without neighbour lists;
// * the entry of a path into a sphere is found by bracketing and bisection, without a closed form;
// * the active set is found by trying every set of up to three touched spheres;
// * four perturbed copies, whose HIPs are 1e-9 A away, show whether the result is ill-conditioned.
// Units: angstrom.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact::oracle {

/// The distance between the HIPs of the perturbed copies and the true HIP (unit: angstrom).
inline constexpr double kPerturbation_A = 1e-9;

struct PointL {
  long double x = 0, y = 0, z = 0;
};

class Oracle {
 public:
  /// Without perturbed copies it is faster, and every answer counts as decided.
  Oracle(std::vector<Sphere> spheres, double probe_A, bool perturbed = true);

  struct Answer {
    bool contact = false;
    Vec3 scp_A{0.0};          ///< the HIP if there is no contact
    double accuracy_A = 0.0;  ///< error bound of this answer
    /// False if a HIP 1e-9 A away gives another position or flag: two results are correct. A test then checks a
    /// tracker's answer only by `deepest` and `atRest`, and calls `place` to continue from that answer.
    bool decided = true;
    bool started_inside = false;  ///< the HIP has not been outside yet, so there is no contact
  };

  /// Performs one tick for a finite HIP.
  Answer step(Vec3 hip);

  /// Continues from another tracker's SCP, which is first pushed out of the spheres if rounding left it inside.
  void place(Vec3 scp);

  /// Restores the initial state.
  void reset();

 private:
  struct Flow {
    PointL s;
    bool arrived = true;    // at the HIP: no contact
    bool converged = true;  // false: the limit of iterations was reached
  };
  Flow flow(PointL s, PointL hip) const;

  std::vector<PointL> centres_;  // relative to origin_
  std::vector<long double> radii_;
  PointL origin_;
  std::size_t flows_ = 5;
  bool been_outside_ = false;
  std::array<PointL, 5> s_;  // the true SCP, then the perturbed copies
};

/// The largest penetration of p into any sphere, in long double; negative outside; -infinity without spheres.
double deepest(const std::vector<Sphere>& spheres, double probe_A, Vec3 p);

/// True if scp is at rest for that HIP: |h - s + sum mu_k n_k| <= tolerance_A for some mu_k >= 0 (the
/// Karush-Kuhn-Tucker condition). The sum is over the spheres whose surface is within tolerance_A of scp; n_k are
/// outward unit normals.
bool atRest(const std::vector<Sphere>& spheres, double probe_A, Vec3 scp, Vec3 hip, double tolerance_A);

}  // namespace moltact::oracle
