// The scale between a device and a molecule: what it is for a part of the molecule that is to fill the device's room, and
// what a person is told of it. Any thread but the haptic one. Units: angstrom, millimetre, newton, piconewton.
#pragma once

#include <optional>
#include <string>

#include "engine/core/units.h"
#include "engine/device/device.h"

namespace moltact {

inline constexpr double kFinest_A_per_mm = 0.01, kCoarsest_A_per_mm = 4.0;

/// A ball of the molecule that is felt larger than the rest (unit: angstrom).
struct Region {
  PointA centre;
  double radius_A = 0.0;
};

/// The workspace in which a ball round `centre` fills the device's room as far as its narrowest side allows: the paper's
/// active haptic workspace, set round a selection. `radius_A` is clamped so that the scale stays within the figures above;
/// what is not finite leaves `now` as it is.
Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceFigures& device);

inline Workspace magnified(const Workspace& now, const Region& region, const DeviceFigures& device) {
  return magnified(now, region.centre, region.radius_A, device);
}

/// Another scale for a hand that stays where it is, at `hand` and at `hip`. Scales that are no number or not above 0 change nothing.
Workspace rescaled(const Workspace& now, double A_per_mm, PointMm hand, PointA hip);

/// "1 mm here is 0.2 Å there".
std::string lengthScale(const Workspace& workspace);

/// "1 mm here is 0.2 Å there, 1 N here would be 4.2 pN there." Without `pN_per_N`, where the force stands for none between
/// molecules: "1 mm here is 0.2 Å there; the force is made for the hand and is none between molecules."
std::string scaleSentence(const Workspace& workspace, std::optional<double> pN_per_N = std::nullopt);

}  // namespace moltact
