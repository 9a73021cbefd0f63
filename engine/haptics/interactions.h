// The tables of interactions, the ways to feel a scene, and of layers, which act on top of any of them. A new
// interaction or layer needs its own file and a row in interactions.cpp. Window's thread; creating an interaction may
// allocate. Units: angstrom.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/pair_field.h"
#include "engine/haptics/friction.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/touch_setup.h"

namespace moltact {

/// The data from which an interaction is created.
struct InteractionInput {
  std::shared_ptr<const SphereGrid> spheres;
  TouchSetup touch = {};
  std::shared_ptr<const HeldBody> body = nullptr;  ///< for a kind with `holds_body`; other kinds ignore it
  /// One entry per sphere where needsChemistry() is true (built by engine/structure/atom_charges.h); else null.
  std::shared_ptr<const AtomChemistry> chemistry = nullptr;
  /// Where `touch` selects forces between atoms: those atoms (built by engine/structure/interaction_input.h); else null.
  std::shared_ptr<const PairField> pairs = nullptr;
  /// Where `touch` selects a texture: its factors (built by engine/structure/roughness.h); null: 1 everywhere.
  std::shared_ptr<const Roughness> roughness = nullptr;
  /// Of the spring that turns a held body to the hand's orientation (unit: N A per radian, for a spring of 1 N per A at
  /// its middle); 0: by the body's size. For a kind that has such a spring.
  double rotational_stiffness_N_A = 0.0;
};

struct InteractionKind {
  std::string_view name;      ///< "probe"
  std::string_view title;     ///< on the screen: "Probe"; untranslated (N_)
  std::string_view sentence;  ///< description, untranslated (N_)
  /// Creates the interaction. Returns null if the setup names an unknown method, or if a kind with `holds_body` gets no
  /// body.
  std::unique_ptr<Interaction> (*make)(const InteractionInput& input);
  bool holds_body = false;            ///< for a scene that hands over a body; a choice only there
  bool needs_chemistry = false;       ///< `make` reads InteractionInput::chemistry
  std::string_view former_name = {};  ///< in files of earlier versions; empty: the same
};

/// A force or a surface property that acts on top of every interaction, probe or body: a field, friction. It is a
/// decorator (`WrappedInteraction`) of the response. A change of the contact's force thus acts on the springs of a body
/// as on that of a probe. No method depends on it, nor does the search for a body's rest. A decorator that changes the
/// contact changes `displacement_A`, `torque_A2` and `energy_A2` together, so that no energy is created.
struct InteractionLayer {
  std::string_view name;            ///< "forces"
  bool (*acts)(const TouchSetup&);  ///< whether the setup selects it; otherwise `wrap` is not called
  /// Wraps an interaction. The setup, the body and, with `needs_chemistry`, the chemistry are in `input`.
  std::unique_ptr<Interaction> (*wrap)(std::unique_ptr<Interaction> inner, const InteractionInput& input);
  bool needs_chemistry = false;  ///< `wrap` reads InteractionInput::chemistry
};

/// All layers, from the innermost to the outermost.
std::span<const InteractionLayer> interactionLayers();

/// All kinds, the default first.
std::span<const InteractionKind> interactionKinds();

/// The kind of that name, or nullptr.
const InteractionKind* findInteractionKind(std::string_view name);

/// Returns `wanted` with a kind of interaction that matches the hand. The kind is kept if it holds a body exactly when
/// `body` is true; otherwise it becomes the first kind that matches.
TouchSetup resolveInteraction(TouchSetup wanted, bool body);

/// True if the setup's interaction, or one of its layers, needs InteractionInput::chemistry.
bool needsChemistry(const TouchSetup& touch, std::span<const InteractionLayer> layers = interactionLayers());

/// Creates the interaction that the setup names, inside the layers that it selects; without any, the bare interaction.
/// The layer `friction` acts in every setup, so that the loop can change its coefficient; with 0 it changes no bit.
/// Returns null if interaction or method is unknown, or a required body, chemistry or pair field is missing.
std::unique_ptr<Interaction> makeInteraction(const InteractionInput& input,
                                             std::span<const InteractionLayer> layers = interactionLayers());

/// The setup that serves as reference for a method felt with `felt`: the same with referenceMethod(). A layer, which
/// changes the force of every method, thus does not count as an error of the method.
TouchSetup referenceOf(TouchSetup felt);

}  // namespace moltact
