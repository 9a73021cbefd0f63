// The scale between a device and a molecule: the scale at which a part of the molecule fills the device's workspace,
// and the sentences that describe a scale to a person. Any thread but the haptic one. Units: angstrom, millimetre,
// newton, piconewton.
#pragma once

#include <optional>
#include <string>

#include "engine/core/region.h"
#include "engine/core/units.h"
#include "engine/device/device.h"

namespace moltact {

inline constexpr double kFinest_A_per_mm = 0.01, kCoarsest_A_per_mm = 4.0;

/// The workspace in which a sphere round `centre` fills the device's workspace as far as its narrowest side allows: the
/// paper's active haptic workspace, set round a selection. `radius_A` is clamped so that the scale stays within the
/// figures above; non-finite input leaves `now` unchanged.
Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceSpecs& device);

inline Workspace magnified(const Workspace& now, const Region& region, const DeviceSpecs& device) {
  return magnified(now, region.centre, region.radius_A, device);
}

/// Another scale for a hand that stays where it is, at `hand` and at `hip`. Scales that are not a number or not above 0
/// change nothing.
Workspace rescaled(const Workspace& now, double A_per_mm, PointMm hand, PointA hip);

/// "1 mm here is 0.2 Å there".
std::string lengthScale(const Workspace& workspace);

/// The energy (unit: J) that the spring in the hand stores at a contact of `Contact::energy_A2`: 0.5 k d^2, where d is
/// the displacement in the hand's millimetres.
double springEnergy_J(double energy_A2, double stiffness_N_per_mm, double A_per_mm);

/// The force (unit: pN) with which two carbon atoms push each other apart that lie `overlap_A` nearer than they touch:
/// the yardstick for what a press would be between atoms. The van der Waals term of the Tripos 5.2 force field (Clark,
/// Cramer & Van Opdenbosch, J. Comput. Chem. 10, 982, 1989), which takes carbon's radius as 1.70 Å, as Bondi and the
/// spheres here do: F = 12 e/R ((R/r)^13 - (R/r)^7), R = 3.40 Å, e = 0.107 kcal/mol, r = R - overlap. Nothing where they
/// do not overlap, and where they overlap by more than kDeepest_A, which no such term describes.
std::optional<double> carbonPush_pN(double overlap_A);

/// At this overlap two carbon atoms push with 2 nN, of the order of the force that breaks a covalent bond.
inline constexpr double kDeepest_A = 1.0;

/// "1 mm here is 0.2 Å there, 1 N here would be 71 pN there": how deep 1 N presses with a spring of
/// `stiffness_N_per_mm`, and carbonPush_pN() at that depth; in words where that returns nothing.
std::string scaleSentence(const Workspace& workspace, double stiffness_N_per_mm);

/// Explains that force and what the spring leaves out: three sentences, or one where there is no such force.
std::string scaleReason(const Workspace& workspace, double stiffness_N_per_mm);

}  // namespace moltact
