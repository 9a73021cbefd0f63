// The errors of a method's SCP and force along strokes in contact. The reference is the method exact; for exact itself
// it is the brute-force oracle (oracle.h). Units: angstrom, degree.
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
  double lost = 0;           ///< fraction of ticks without contact although the reference touches (0 to 1)
};

/// The angle between two vectors (unit: degree), exact for small angles; 0 where one is zero.
double angle_deg(const Vec3& a, const Vec3& b);

/// Measures a method against exact.
Accuracy accuracyOf(const Method& method, const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                    const std::vector<Stroke>& strokes);

/// Measures exact against the oracle, on every segment of `piece` ticks of each stroke. The oracle uses only the
/// spheres near the segment and starts at exact's SCP. Ticks in which the oracle accepts two results are ignored.
Accuracy exactAgainstOracle(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                            const std::vector<Stroke>& strokes, std::size_t piece);

}  // namespace moltact::bench
