#include "engine/bench/energies/energy_task.h"

#include <algorithm>
#include <cmath>

#include "engine/structure/amber/pair_atoms.h"

namespace moltact::bench {
namespace {

enum class EnergySide : std::uint8_t { Held, Scene, Neither };

// Distributes atoms with their placed hydrogens over the body and its scene.
template <class SideOf>
EnergyTask energyTaskOf(std::string_view name, const Molecule& molecule, SideOf side_of) {
  EnergyTask out;
  out.name = name;
  const PairAtoms all = pairAtoms(molecule);
  for (std::size_t i = 0; i < all.atoms.size(); ++i) {
    const EnergySide side = side_of(molecule.residues[molecule.atoms[all.carrier[i]].residue]);
    if (side == EnergySide::Held) out.held.push_back(all.atoms[i]);
    if (side == EnergySide::Scene) out.atoms.push_back(all.atoms[i]);
  }
  return out;
}

void keepNearest(EnergyTask& task, std::size_t count) {
  const auto distance = [&](const PairAtom& held) {
    double least = 1e300;
    for (const PairAtom& a : task.atoms) least = std::min(least, glm::distance(a.centre_A, held.centre_A));
    return least;
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < task.held.size(); ++i) order.push_back({distance(task.held[i]), i});
  std::sort(order.begin(), order.end());
  order.resize(std::min(count, order.size()));
  std::vector<PairAtom> kept;
  for (const auto& [least, i] : order) kept.push_back(task.held[i]);
  task.held = std::move(kept);
}

}  // namespace

Expected<EnergyTask> energyTask(std::string_view name, const OpenMolecule& open) {
  const auto molecule = open(name == "ligand" ? "1hpv" : "2hhb");
  if (!molecule) return molecule.problem();
  EnergyTask task;
  if (name == "ligand") {
    task = energyTaskOf(name, *molecule, [](const Residue& r) {
      return r.kind == ResidueKind::Ligand  ? EnergySide::Held
             : r.kind == ResidueKind::Water ? EnergySide::Neither
                                            : EnergySide::Scene;
    });
  } else {
    task = energyTaskOf(name, *molecule, [](const Residue& r) {
      if (r.kind != ResidueKind::AminoAcid || r.chain > 1) return EnergySide::Neither;
      return r.chain == 0 ? EnergySide::Held : EnergySide::Scene;
    });
    if (name == "200") keepNearest(task, 200);
  }
  for (const PairAtom& a : task.held) task.home_A += a.centre_A / double(task.held.size());
  for (PairAtom& a : task.held) {
    a.centre_A -= task.home_A;
    task.gyration_A += glm::dot(a.centre_A, a.centre_A) / double(task.held.size());
  }
  task.gyration_A = std::sqrt(task.gyration_A);
  std::vector<Sphere> places;
  for (const PairAtom& a : task.atoms) places.push_back({a.centre_A, 1.0});
  task.scene = std::make_shared<const SphereGrid>(std::move(places));
  return task;
}

std::vector<PoseA> energyPath(const EnergyTask& task, int ticks) {
  constexpr double kWay_A = 0.5;
  std::vector<PoseA> out;
  for (int k = 0; k < ticks; ++k) {
    const double t = kTwoPi * double(k) / double(ticks);
    const Vec3 shift(std::sin(3 * t), std::sin(5 * t + 1), std::sin(7 * t + 2)),
        turn =
            kWay_A / std::max(task.gyration_A, 1.0) * Vec3(std::sin(4 * t), std::sin(6 * t + 1), std::sin(8 * t + 2));
    const double angle = glm::length(turn);
    out.push_back({{task.home_A + kWay_A * shift}, angle > 1e-9 ? glm::angleAxis(angle, turn / angle) : kNoRotation});
  }
  return out;
}

}  // namespace moltact::bench
