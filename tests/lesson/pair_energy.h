// The energy of what a lesson's hand holds with the rest of its scene: the engine's, and an independent double sum with
// the charges of the molecule's file and AMBER's Lennard-Jones parameters, written out here.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/structure/interaction_input.h"
#include "tests/lesson/shipped_lesson.h"

namespace moltact::test {

class ShippedPair {
 public:
  ShippedPair(const std::string& molecule, const std::string& fixed, const std::string& held, const std::string& forces,
              const std::string& medium)
      : scene_(molecule), fixed_(scene_.select(fixed)), held_(scene_.select(held)), medium_(medium) {
    SceneSpec spec;
    spec.touch.forces = forces;
    spec.touch.dielectric = medium;
    spec.touch.coupling_N_per_mm = 0.002;
    std::vector<std::uint32_t> absent;
    for (std::uint32_t a = 0; a < scene_.molecule->atoms.size(); ++a)
      if (std::find(fixed_.begin(), fixed_.end(), a) == fixed_.end()) absent.push_back(a);
    body_ = heldBody(*scene_.molecule, held_);
    forces_ = sceneForces(spec, scene_.molecule, absent, body_);
    REQUIRE(forces_);
  }

  const HeldBody& body() const { return *body_; }

  /// The engine's energy of the held atoms, shifted by this and turned about their middle (unit: kcal/mol).
  double engine(const Vec3& shift, const Quat& turned = kNoRotation) const {
    double out = 0.0;
    forces_->fall({{body_->middle.A + shift}, turned}, {}, [&](const Well& w) {
      out = w.energy.total_kcal_mol();
      return false;
    });
    return out;
  }

  double ownSum(const Vec3& shift, const Quat& turned = kNoRotation) const {
    double sum = 0.0;
    for (const std::uint32_t h : held_)
      for (const std::uint32_t f : fixed_) {
        const Vec3 at = body_->middle.A + shift + turned * (scene_.molecule->spheres[h].centre_A - body_->middle.A);
        const double r = glm::distance(at, scene_.molecule->spheres[f].centre_A);
        const auto [half_h, depth_h] = parameters(h);
        const auto [half_f, depth_f] = parameters(f);
        const double x = std::pow((half_h + half_f) / r, 6);
        double pair = std::sqrt(depth_h * depth_f) * (x * x - 2 * x);
        if (!scene_.molecule->charges_e.empty())
          pair += 332.0637 * double(scene_.molecule->charges_e[h]) * double(scene_.molecule->charges_e[f]) /
                  (dielectric(r) * r);
        const double u = std::clamp((100.0 - r * r) / (100.0 - 64.0), 0.0, 1.0);
        sum += u * u * (3 - 2 * u) * pair;
      }
    return sum;
  }

  /// The deepest energy that this number of falls beside the file's pose lead to.
  double well(int falls, double within_A = 2.0) const {
    const auto wells =
        wellsBeside(PoseGoal(body_, PoseA{body_->middle}), {within_A, std::numbers::pi}, *forces_, falls);
    return wells.empty() ? 0.0 : wells.front().energy.total_kcal_mol();
  }

 private:
  double dielectric(double r) const {
    constexpr double kA = -8.5525, kB = 86.9525;
    return medium_ == "vacuum" ? 1.0 : kA + kB / (1 + 7.7839 * std::exp(-0.003627 * kB * r));
  }

  // rmin / 2 and depth: argon's dimer, TIP3P's oxygen, AMBER's types by element, of hydrogens by their carrier.
  std::pair<double, double> parameters(std::uint32_t atom) const {
    const Molecule& m = *scene_.molecule;
    const auto residue = m.residues[m.atoms[atom].residue].name;
    const int element = m.atoms[atom].atomic_number;
    if (residue == "WTR") return element == 8 ? std::pair(1.7683, 0.152) : std::pair(0.0, 0.0);
    switch (element) {
      case 18:
        return {1.88, 0.2846};
      case 6:
        return {1.908, carbonDepth(atom)};
      case 7:
        return {1.824, 0.17};
      case 8:
        return {1.6612, 0.21};
      default:
        return hydrogen(atom);
    }
  }
  std::uint32_t carrier(std::uint32_t atom) const {
    std::uint32_t best = atom;
    double nearest = 2.0;
    for (std::uint32_t a = 0; a < scene_.molecule->atoms.size(); ++a)
      if (const double d = glm::distance(scene_.molecule->spheres[a].centre_A, scene_.molecule->spheres[atom].centre_A);
          a != atom && d < nearest && scene_.molecule->atoms[a].atomic_number != 1)
        nearest = d, best = a;
    return best;
  }
  double carbonDepth(std::uint32_t atom) const {
    int hydrogens = 0;
    for (std::uint32_t a = 0; a < scene_.molecule->atoms.size(); ++a)
      hydrogens += scene_.molecule->atoms[a].atomic_number == 1 && carrier(a) == atom;
    return hydrogens == 3 ? 0.1094 : 0.086;
  }
  std::pair<double, double> hydrogen(std::uint32_t atom) const {
    const int on = scene_.molecule->atoms[carrier(atom)].atomic_number;
    if (on != 6) return {0.6, 0.0157};
    return {1.459, 0.015};
  }

  ShippedScene scene_;
  std::vector<std::uint32_t> fixed_, held_;
  std::string medium_;
  std::shared_ptr<const HeldBody> body_;
  std::shared_ptr<const SceneForces> forces_;
};

}  // namespace moltact::test
