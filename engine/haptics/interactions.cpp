#include "engine/haptics/interactions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/field/coupled_field.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

std::unique_ptr<Interaction> makeProbe(const InteractionInput& input) {
  const Method* method = findMethod(input.touch.method);
  return method ? method->make(input.spheres, input.touch.probe_A) : nullptr;
}

std::unique_ptr<Interaction> makeSprings(const InteractionInput& input) {
  const Method* method = findMethod(input.touch.method);
  if (!method || !input.body) return nullptr;
  const auto make = [&](double radius_A) { return method->make(input.spheres, radius_A); };
  return std::make_unique<RigidBody>(input.body, make, input.spheres->bytes());
}

// A single sphere about the middle has no lever: the exact tracker, which needs no search, is its exact body.
std::unique_ptr<Interaction> makeExactBody(const InteractionInput& input) {
  if (!input.body) return nullptr;
  if (input.body->spheres.size() > 1 || glm::length(input.body->spheres.front().centre_A) > 1e-9)
    return std::make_unique<ExactBody>(input.spheres, input.body, input.rotational_stiffness_N_A);
  const auto make = [&](double radius_A) { return referenceMethod().make(input.spheres, radius_A); };
  return std::make_unique<RigidBody>(input.body, make, input.spheres->bytes());
}

constexpr std::array kKinds{
    InteractionKind{"probe", N_("Probe"), N_("a sphere at the hand, which a haptic method keeps outside every atom"),
                    &makeProbe},
    InteractionKind{"exact-body", N_("Exact rigid body"),
                    N_("a rigid body that rests where its springs are in balance and overlaps no atom"), &makeExactBody,
                    true},
    InteractionKind{"springs", N_("Springs of a rigid body"),
                    N_("atoms that follow the hand, each kept outside by a haptic method"), &makeSprings, true, false,
                    "body"},
};

bool forcesAct(const TouchSetup& touch) { return forceChoice(touch.forces).any(); }

std::unique_ptr<Interaction> withForces(std::unique_ptr<Interaction> inner, const InteractionInput& input) {
  if (!input.pairs) return nullptr;
  constexpr double kStiffnessUnit_N_per_mm = 1e-5 * kForceUnit_pN;
  VirtualCoupling coupling;
  const double wanted = input.touch.coupling_N_per_mm > 0.0
                            ? input.touch.coupling_N_per_mm
                            : 1.8e-3 * double(std::clamp<std::size_t>(input.pairs->held.size(), 1, 200));
  coupling.stiffness_kcal_mol_A2 = wanted / kStiffnessUnit_N_per_mm;
  if (input.body && inner->hasOrientation()) {
    const double gyration_A = std::max(kMinLever_A, radiusOfGyration_A(*input.body));
    coupling.lever_A = input.rotational_stiffness_N_A > 0.0 ? std::sqrt(input.rotational_stiffness_N_A) : gyration_A;
    coupling.reach_A = input.body->reach_A;
  }
  return std::make_unique<CoupledField>(std::move(inner), input.pairs, coupling);
}

// Without friction too, because the servo loop changes its coefficient.
bool always(const TouchSetup&) { return true; }

std::unique_ptr<Interaction> withFriction(std::unique_ptr<Interaction> inner, const InteractionInput& input) {
  return std::make_unique<FrictionLayer>(std::move(inner), input.spheres, input.body, input.roughness,
                                         Friction{input.touch.friction, input.touch.stick_slip});
}

// From the innermost to the outermost: friction, which acts on the contact, before fields.
constexpr std::array kLayers{InteractionLayer{"friction", &always, &withFriction},
                             InteractionLayer{"forces", &forcesAct, &withForces}};

}  // namespace

std::span<const InteractionLayer> interactionLayers() { return kLayers; }

std::span<const InteractionKind> interactionKinds() { return kKinds; }

const InteractionKind* findInteractionKind(std::string_view name) {
  for (const InteractionKind& k : kKinds)
    if (k.name == name || (!k.former_name.empty() && k.former_name == name)) return &k;
  return nullptr;
}

TouchSetup resolveInteraction(TouchSetup wanted, bool body) {
  const InteractionKind* kind = findInteractionKind(wanted.interaction);
  if (kind && kind->holds_body == body) return wanted;
  const auto first =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const InteractionKind& k) { return k.holds_body == body; });
  wanted.interaction = first->name;
  return wanted;
}

bool needsChemistry(const TouchSetup& touch, std::span<const InteractionLayer> layers) {
  const InteractionKind* kind = findInteractionKind(touch.interaction);
  return (kind && kind->needs_chemistry) || std::any_of(layers.begin(), layers.end(), [&](const InteractionLayer& l) {
           return l.needs_chemistry && l.acts(touch);
         });
}

std::unique_ptr<Interaction> makeInteraction(const InteractionInput& input, std::span<const InteractionLayer> layers) {
  const InteractionKind* kind = findInteractionKind(input.touch.interaction);
  if (!kind || (!input.chemistry && needsChemistry(input.touch, layers))) return nullptr;
  std::unique_ptr<Interaction> felt = kind->make(input);
  for (const InteractionLayer& layer : layers)
    if (felt && layer.acts(input.touch)) felt = layer.wrap(std::move(felt), input);
  return felt;
}

TouchSetup referenceOf(TouchSetup felt) {
  felt.interaction = kKinds.front().name;
  felt.method = referenceMethod().name;
  return felt;
}

}  // namespace moltact
