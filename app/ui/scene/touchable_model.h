// The object that is touched: a molecule, its spheres, and how large it lies under the hand. Built whole on any thread,
// then never changed. Units: angstrom.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/molecule/molecule.h"

namespace moltact {

struct TouchableModel {
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const SphereGrid> spheres;
  std::shared_ptr<const HeldBody> body;  ///< what the hand holds; null: the probe
  Workspace workspace;
  PointA middle;         ///< of the centres of the atoms that can be felt, before which the probe waits
  double reach_A = 0.0;  ///< from the middle, farther than any surface for any probe offered

  explicit operator bool() const { return spheres != nullptr; }
};

/// Puts a molecule on the stage. One without atoms gives a problem that names `file`.
Expected<TouchableModel> makeTouchableModel(Molecule molecule, const std::filesystem::path& file);

/// The stage with these atoms (ascending) not to be felt, and those held as a body, and no others.
TouchableModel withUntouchable(const TouchableModel& stage, const std::vector<std::uint32_t>& atoms,
                               const std::vector<std::uint32_t>& held);

/// The model with its spheres at these places (one for each), for the picture and for the hand.
TouchableModel movedModel(const TouchableModel& model, SharedArray<Sphere> places);
/// The same for places on the way of a motion, found through the motion's own index instead of a new one.
TouchableModel movedModel(const TouchableModel& model, const SphereMotion& motion, SharedArray<Sphere> places);

/// Leads an interaction to the contact where the hand is, if there is one, so that it does not begin inside.
void leadToContact(Interaction& made, const Contact& contact, const PoseA& hand);

/// What the hand holds where it is oriented so: the probe of this radius, or the stage's body.
HandShape handShape(const TouchableModel& stage, double probe_A, const Quat& orientation);

/// The interaction for the stage, continuing with `contact` where the hand is if there is one, so that a change of
/// method is not felt as letting go. The rotational spring of a held body is one that the device can show. Null without a stage, and where the setup names what there is not.
std::unique_ptr<Interaction> interactionAt(const TouchableModel& stage, const TouchSetup& touch, const Contact& contact,
                                           const PoseA& hand, const DeviceSpecs& device);

}  // namespace moltact
