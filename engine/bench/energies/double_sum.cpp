#include "engine/bench/energies/double_sum.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/field/held_atom_sum.h"

namespace moltact::bench {

DoubleSum::DoubleSum(std::shared_ptr<const SphereGrid> scene, std::vector<PairAtom> atoms, std::vector<PairAtom> body,
                     double cutoff_A, bool lists)
    : scene_(std::move(scene)),
      atoms_(std::move(atoms)),
      body_(std::move(body)),
      cut2_(cutoff_A * cutoff_A),
      from2_((cutoff_A - 2.0) * (cutoff_A - 2.0)),
      reach_A_(cutoff_A + PairSum::kMargin_A),
      lists_(lists),
      near_(lists ? body_.size() : 0) {}

void DoubleSum::add(PairTerms& out, const PairAtom& own, const Vec3& place, const PairAtom& other) const {
  const Vec3 way = place - other.centre_A;
  const double far = glm::dot(way, way);
  if (far >= cut2_) return;
  const double t = std::max(far, kMinPair_A * kMinPair_A), r = std::sqrt(t);
  const double minimum = double(own.half_minimum_A) + double(other.half_minimum_A);
  const double depth = std::sqrt(double(own.depth_kcal_mol) * double(other.depth_kcal_mol));
  const double s2 = minimum * minimum / t, s6 = s2 * s2 * s2;
  double lj = depth * s6 * (s6 - 2.0), lj1 = 6.0 * depth * s6 * (1.0 - s6) / t;
  // eps = A + B / (1 + k exp(-lambda B r)); Mehler & Solmajer 1991
  constexpr double kB = 86.9525, kA = 78.4 - kB, kK = 7.7839, kRate = 0.003627 * kB;
  const double w = 1.0 / (1.0 + kK * std::exp(-kRate * r));
  const double eps = kA + kB * w, eps1 = kB * kRate * w * (1.0 - w);
  const double strength = kCoulomb_kcal_A * double(own.charge_e) * double(other.charge_e);
  double el = strength / (r * eps), el1 = -el * (eps + r * eps1) / (r * eps) / (2.0 * r);
  if (t > from2_ && std::isfinite(cut2_)) {
    const double u = (cut2_ - t) / (cut2_ - from2_), s = u * u * (3.0 - 2.0 * u);
    const double s1 = -6.0 * u * (1.0 - u) / (cut2_ - from2_);
    lj1 = s1 * lj + s * lj1;
    lj *= s;
    el1 = s1 * el + s * el1;
    el *= s;
  }
  // Nearer than kMinPair_A the energy continues with the slope at that distance.
  out.energy[EnergyPart::VanDerWaals] += lj + lj1 * (far - t);
  out.energy[EnergyPart::Electrostatic] += el + el1 * (far - t);
  out.gradient += 2.0 * (lj1 + el1) * way;
}

PairEnergy DoubleSum::at(const PoseA& pose) {
  const glm::dmat3 turn = glm::mat3_cast(pose.orientation);
  HeldAtomSum sum{FeltFunction(PairModel{})};
  for (std::size_t k = 0; k < body_.size(); ++k) {
    const Vec3 arm = turn * body_[k].centre_A, place = pose.place.A + arm;
    PairTerms terms;
    if (lists_) {
      Near& near = near_[k];
      if (glm::distance(near.centre_A, place) > PairSum::kMargin_A) {
        near.centre_A = place;
        near.atoms.clear();
        scene_->visitCentresNear(place, reach_A_, [&](std::uint32_t index, const Sphere& sphere) {
          if (glm::distance(sphere.centre_A, place) <= reach_A_) near.atoms.push_back(atoms_[index]);
        });
      }
      for (const PairAtom& other : near.atoms) add(terms, body_[k], place, other);
    } else {
      for (const PairAtom& other : atoms_) add(terms, body_[k], place, other);
    }
    sum.add(terms, terms.curvature, arm);
  }
  return sum.energy();
}

std::size_t DoubleSum::bytes() const {
  std::size_t out = (atoms_.capacity() + body_.capacity()) * sizeof(PairAtom);
  for (const Near& near : near_) out += sizeof near + near.atoms.capacity() * sizeof(PairAtom);
  return out;
}

}  // namespace moltact::bench
