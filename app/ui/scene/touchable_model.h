// A loaded model, the "stage": a molecule, its spheres and its extent. Built on any thread, then immutable. Unit:
// angstrom.
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
#include "engine/servo/servo_step.h"

namespace moltact {

struct TouchableModel {
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const SphereGrid> spheres;
  std::shared_ptr<const HeldBody> body;  ///< what the hand holds; null: a probe
  Workspace workspace;
  PointA middle;         ///< centre of the touchable atoms; the probe starts in front of it
  double reach_A = 0.0;  ///< distance from the middle, beyond every surface for every available probe

  explicit operator bool() const { return spheres != nullptr; }
};

/// Makes a model of a molecule. A molecule without atoms gives a Problem with `file`.
Expected<TouchableModel> makeTouchableModel(Molecule molecule, const std::filesystem::path& file);

/// The model with exactly these atoms (ascending) excluded from touch, and these held as a body.
TouchableModel withUntouchable(const TouchableModel& stage, const std::vector<std::uint32_t>& atoms,
                               const std::vector<std::uint32_t>& held);

/// The model with its spheres at these positions (one for each), for the picture and for the hand.
TouchableModel movedModel(const TouchableModel& model, SharedArray<Sphere> places);
/// The same for positions during a motion; uses the motion's index instead of building one.
TouchableModel movedModel(const TouchableModel& model, const SphereMotion& motion, SharedArray<Sphere> places);

/// Leads an interaction to the contact at the hand, if there is one, so that it does not begin inside.
void leadToContact(Interaction& made, const Contact& contact, const PoseA& hand);

/// The shape in the hand at this orientation: a probe of this radius, or the model's body.
HandShape handShape(const TouchableModel& stage, double probe_A, const Quat& orientation);

/// The interaction for the model. If there is a contact at the hand it continues with it, so that a change of method is
/// not felt as a release. The rotational spring of a held body suits the device. Null without a model, or if the setup
/// names something unknown. `pairs`, if given, receives the atoms of its forces; null without forces.
std::unique_ptr<Interaction> interactionAt(const TouchableModel& stage, const TouchSetup& touch, const Contact& contact,
                                           const PoseA& hand, const DeviceSpecs& device,
                                           std::shared_ptr<const PairField>* pairs = nullptr);

/// Leads a new interaction to where the body or probe of another one was in a tick, and then to the hand. A change of
/// the forces between atoms therefore does not release what is held. What is stored there in the coupling and in the
/// new field is the energy with which it begins.
void leadFrom(Interaction& made, const ServoSample& latest);

}  // namespace moltact
