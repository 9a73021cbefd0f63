// The scale between device and molecule: the scale at which a part of the molecule fills the device's workspace, and
// sentences that describe a scale. Any thread except the haptic one. Units: angstrom, millimetre, newton, piconewton.
#pragma once

#include <optional>
#include <string>

#include "engine/core/region.h"
#include "engine/core/units.h"
#include "engine/device/device.h"

namespace moltact {

inline constexpr double kMinScale_A_per_mm = 0.01, kMaxScale_A_per_mm = 4.0;

/// The workspace in which a sphere around `centre` fills the device's workspace up to its narrowest side: the paper's
/// active haptic workspace around a selection. `radius_A` is clamped so that the scale stays within the limits above;
/// non-finite input returns `now`.
Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceSpecs& device);

inline Workspace magnified(const Workspace& now, const Region& region, const DeviceSpecs& device) {
  return magnified(now, region.centre, region.radius_A, device);
}

/// Changes the scale while the hand stays at `hand` and `hip`. Scales that are not finite and positive return `now`.
Workspace rescaled(const Workspace& now, double A_per_mm, PointMm hand, PointA hip);

/// The scale of lengths as a sentence: "1 mm here is 0.2 Å there".
std::string lengthScale(const Workspace& workspace);

/// The energy (unit: J) that the spring in the hand stores at a contact of `Contact::energy_A2`: 0.5 k d^2, where d is
/// the displacement in the hand's millimetres.
double springEnergy_J(double energy_A2, double stiffness_N_per_mm, double A_per_mm);

/// The repulsive force (unit: pN) between two carbon atoms that are `overlap_A` nearer than contact: a comparison value
/// for the force of a press. It is the van der Waals term of the Tripos 5.2 force field (Clark, Cramer & Van
/// Opdenbosch, J. Comput. Chem. 10, 982, 1989), whose radius of carbon, 1.70 Å, is also that of Bondi and so of the
/// spheres here: F = 12 e/R ((R/r)^13 - (R/r)^7), R = 3.40 Å, e = 0.107 kcal/mol, r = R - overlap. Empty without
/// overlap, and for an overlap above kMaxOverlap_A, which this term does not describe.
std::optional<double> carbonPush_pN(double overlap_A);

/// At this overlap the force is 2 nN, of the order of the force that breaks a covalent bond.
inline constexpr double kMaxOverlap_A = 1.0;

/// "1 mm here is 0.2 Å there, 1 N here would be 71 pN there". The force is carbonPush_pN() at the depth of a press with
/// 1 N on a spring of `stiffness_N_per_mm`. In words if that is empty.
std::string scaleSentence(const Workspace& workspace, double stiffness_N_per_mm);

/// Explains that force and its limitations: three sentences, or one if there is no such force.
std::string scaleReason(const Workspace& workspace, double stiffness_N_per_mm);

}  // namespace moltact
