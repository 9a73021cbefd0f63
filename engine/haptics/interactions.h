// What there is to feel a scene with. An interaction is added with its own files and a row in interactions.cpp.
// Window's thread; making one may allocate. Units: angstrom.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/touch_setup.h"

namespace moltact {

/// What an interaction is made from.
struct InteractionInput {
  std::shared_ptr<const SphereGrid> spheres;
  TouchSetup touch = {};
  std::shared_ptr<const HeldBody> body = nullptr;  ///< what a kind that holds one is made with; else passed over
  /// Of each sphere, for a kind that needs it (engine/structure/atom_charges.h makes it); else null.
  std::shared_ptr<const AtomChemistry> chemistry = nullptr;
  /// Of the spring that turns a held body to the hand's orientation (unit: N A per radian, for a spring of 1 N per A at
  /// its middle); 0: by the body's size. For a kind that has such a spring.
  double rotational_stiffness_N_A = 0.0;
};

struct InteractionKind {
  std::string_view name;      ///< "probe"
  std::string_view title;     ///< on the screen: "Probe"
  std::string_view sentence;  ///< what it is
  /// Null where the setup names a method that there is not, and where there is no body for one that holds it.
  std::unique_ptr<Interaction> (*make)(const InteractionInput& input);
  bool holds_body = false;       ///< a scene chooses it by what it hands over, so that nobody is offered it
  bool needs_chemistry = false;  ///< `make` reads InteractionInput::chemistry
};

/// All, the one that a scene has unless it chooses another first.
std::span<const InteractionKind> interactionKinds();

/// The one of that name, or nullptr.
const InteractionKind* findInteractionKind(std::string_view name);

/// The same with a kind of interaction that goes with what the hand holds: as wanted where that holds a body and there
/// is one, or neither; else the first that does.
TouchSetup resolveInteraction(TouchSetup wanted, bool body);

/// Makes what the setup names; null where there is no such interaction or method, or no body for one that holds it.
std::unique_ptr<Interaction> makeInteraction(const InteractionInput& input);

/// What judges a method that is felt so: the probe by referenceMethod(), all else as it is felt, so that what changes
/// the force of every method (a `WrappedInteraction`) is no error of the method's.
TouchSetup referenceOf(TouchSetup felt);

}  // namespace moltact
