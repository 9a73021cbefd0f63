#include "engine/structure/interaction_input.h"

#include <utility>
#include <vector>

#include "engine/haptics/field/force_choices.h"
#include "engine/structure/amber/charge_faults.h"
#include "engine/structure/amber/pair_atoms.h"
#include "engine/structure/atom_charges.h"
#include "engine/structure/roughness.h"

namespace moltact {

PairAtom probeAtom(double charge_e) {
  return {.half_minimum_A = 1.7683f, .depth_kcal_mol = 0.1521f, .charge_e = float(charge_e)};
}

std::shared_ptr<const PairField> pairField(const TouchSetup& touch, const Molecule& molecule, const SphereGrid& spheres,
                                           const HeldBody* body) {
  const ForceChoice& forces = forceChoice(touch.forces);
  if (!forces.any()) return nullptr;
  PairAtoms all = pairAtoms(molecule);
  if (touch.charges == kFormalCharges) {
    const std::vector<float> formal = formalCharges_e(molecule);
    for (std::size_t i = 0; i < all.atoms.size(); ++i) all.atoms[i].charge_e = i < formal.size() ? formal[i] : 0.0f;
  }
  constexpr std::uint32_t kNotHeld = 0xFFFFFFFF;
  std::vector<std::uint32_t> held(molecule.atoms.size(), kNotHeld);
  if (body)
    for (std::uint32_t k = 0; k < body->atoms.size(); ++k) held[body->atoms[k]] = k;
  auto out = std::make_shared<PairField>();
  out->faults = chargeFaults(all);
  const DielectricChoice& medium = dielectricChoice(touch.dielectric);
  out->model.kind = medium.kind;
  out->model.dielectric = medium.dielectric;
  out->model.weak_gain = touch.weak_gain;
  std::vector<Sphere> places;
  const auto selected = [&](PairAtom atom) {
    for (const EnergyPartInfo& part : energyParts())
      if (!forces.acts[part.part]) part.remove(atom);
    return atom;
  };
  for (std::size_t i = 0; i < all.atoms.size(); ++i) {
    PairAtom atom = selected(all.atoms[i]);
    const std::uint32_t carrier = all.carrier[i];
    if (held[carrier] != kNotHeld) {
      atom.centre_A -= body->middle.A;
      out->held.push_back(atom);
      out->held_carriers.push_back(held[carrier]);
    } else if (spheres.touchable(carrier)) {
      atom.centre_A += spheres[carrier].centre_A - molecule.spheres[carrier].centre_A;
      out->carriers.push_back(carrier);
      out->atoms.push_back(atom);
      places.push_back({atom.centre_A, 1.0});
    }
  }
  if (!body) out->held.push_back(selected(probeAtom(touch.probe_charge_e)));
  out->places = std::make_shared<const SphereGrid>(std::move(places));
  return out;
}

std::shared_ptr<const HeldBody> heldBody(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
  return heldBody(molecule.spheres, atoms, molecule.body_overlap_A);
}

InteractionInput interactionInput(const TouchSetup& touch, const Molecule& molecule,
                                  std::shared_ptr<const SphereGrid> spheres, std::shared_ptr<const HeldBody> body) {
  InteractionInput out{.spheres = std::move(spheres),
                       .touch = touch,
                       .body = std::move(body),
                       .chemistry = chemistryFor(touch, molecule),
                       .roughness = roughness(molecule, touch.texture)};
  out.pairs = pairField(touch, molecule, *out.spheres, out.body.get());
  return out;
}

}  // namespace moltact
