// How far a method's SCP and force are from the right ones along strokes in contact. The right ones are
// exact's, and for exact itself those of the brute-force oracle (oracle.h). Units: angstrom, degree.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/bench/statistics.h"
#include "engine/bench/strokes.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

struct Accuracy {
  Statistics scp_A;          ///< distance of the SCP from the right one, where the right one touches
  Statistics direction_deg;  ///< angle between the forces, where both touch
  double lost = 0;           ///< fraction of ticks with no contact where there should be some (0 to 1)
};

/// The angle between two vectors (unit: degree), exact for small angles; 0 where one is zero.
double angle_deg(const Vec3& a, const Vec3& b);

/// Against exact.
Accuracy accuracyOf(const Method& method, const std::shared_ptr<const BallScene>& scene, double probe_A,
                    const std::vector<Stroke>& strokes);

/// Of exact against the oracle, on every piece of `piece` ticks out of each stroke: the oracle sees the balls
/// near the piece only, and begins at exact's SCP. Ticks in which the oracle calls two outcomes right are
/// left out.
Accuracy exactAgainstOracle(const std::shared_ptr<const BallScene>& scene, double probe_A,
                            const std::vector<Stroke>& strokes, std::size_t piece);

}  // namespace moltact::bench
