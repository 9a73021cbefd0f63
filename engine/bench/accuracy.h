// The errors of a method's SCP and force along strokes in contact. The reference is exact; for exact itself it is the
// brute-force oracle (oracle.h). Units: angstrom, degree.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/bench/statistics.h"
#include "engine/bench/strokes.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

struct Accuracy {
  Statistics scp_A;          ///< distance of the SCP from the reference, where the reference touches
  Statistics direction_deg;  ///< angle between the forces, where both touch
  double lost = 0;           ///< fraction of ticks with no contact where there should be some (0 to 1)
};

/// The angle between two vectors (unit: degree), exact for small angles; 0 where one is zero.
double angle_deg(const Vec3& a, const Vec3& b);

/// Against exact.
Accuracy accuracyOf(const Method& method, const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                    const std::vector<Stroke>& strokes);

/// The errors of exact against the oracle, on every piece of `piece` ticks out of each stroke: the oracle sees only the
/// spheres near the piece, and begins at exact's SCP. Ticks in which the oracle accepts two outcomes are left out.
Accuracy exactAgainstOracle(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                            const std::vector<Stroke>& strokes, std::size_t piece);

}  // namespace moltact::bench
