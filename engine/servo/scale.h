// The scale between a device and a molecule: what it is for a part of the molecule that is to fill the device's room, and
// what a person is told of it. Any thread but the haptic one. Units: angstrom, millimetre, newton, piconewton.
#pragma once

#include <optional>
#include <string>

#include "engine/core/units.h"
#include "engine/device/device.h"

namespace moltact {

inline constexpr double kFinest_A_per_mm = 0.01, kCoarsest_A_per_mm = 4.0;

/// The workspace in which a ball round `centre` fills the device's room as far as its narrowest side allows: the paper's
/// active haptic workspace, set round a selection. `radius_A` is clamped so that the scale stays within the figures above;
/// what is not finite leaves `now` as it is.
Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceFigures& device);

/// "1 mm here is 0.2 Å there, 1 N here would be 4.2 pN there." Without `pN_per_N`, where the force stands for none between
/// molecules: "1 mm here is 0.2 Å there; the force is made for the hand and is none between molecules."
std::string scaleSentence(const Workspace& workspace, std::optional<double> pN_per_N = std::nullopt);

}  // namespace moltact
