#include "engine/structure/surface_potential.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/haptics/contact.h"
#include "engine/haptics/field/compute_grid.h"
#include "engine/haptics/field/pair_kernel.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/structure/amber/pair_atoms.h"

namespace moltact {
namespace {

constexpr std::size_t kPoints = 48;        // of a sphere
constexpr std::size_t kAtomsOfPiece = 64;  // of the work

// Points on the unit sphere, evenly spread along a spiral.
std::array<Vec3, kPoints> spiral() {
  std::array<Vec3, kPoints> out;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double z = 1.0 - (2.0 * double(k) + 1.0) / double(kPoints), r = std::sqrt(1.0 - z * z);
    out[k] = {r * std::cos(turn * double(k)), r * std::sin(turn * double(k)), z};
  }
  return out;
}

PairModel modelOf(const DielectricChoice& medium) {
  PairModel model;
  model.kind = medium.kind;
  model.dielectric = medium.dielectric;
  return model;
}

std::vector<char> flagsOf(std::size_t atoms, std::span<const std::uint32_t> held) {
  std::vector<char> out(atoms);
  for (const std::uint32_t i : held)
    if (i < out.size()) out[i] = 1;
  return out;
}

}  // namespace

// The atoms of the hand, or all others.
class SurfacePotential::Part {
 public:
  Part(const Molecule& molecule, const PairAtoms& all, const PairModel& model, const std::vector<char>& held, bool hand)
      : spheres_(molecule.spheres), constants_(model), kernel_(pairKernel(model.kind)), cut_A_(model.cutoff_A) {
    std::vector<Sphere> places;
    for (std::size_t i = 0; i < all.atoms.size(); ++i) {
      if (bool(held[all.carrier[i]]) != hand || all.atoms[i].charge_e == 0.0f) continue;
      PairAtom charge = all.atoms[i];
      charge.depth_kcal_mol = 0.0f;
      charges_.push_back(charge);
      places.push_back({charge.centre_A, 1.0});
    }
    grid_ = SphereGrid(std::move(places));
    std::vector<std::uint32_t> others;
    for (std::uint32_t i = 0; i < held.size(); ++i)
      if (bool(held[i]) != hand) others.push_back(i);
    cover_ = SphereGrid(molecule.spheres, others);
  }

  float potential(std::size_t atom, std::span<const Vec3> directions) const {
    const Sphere& own = spheres_[atom];
    const double radius = own.radius_A + kWaterProbe_A;
    std::vector<Sphere> near;
    cover_.visitNear(own.centre_A, radius + kWaterProbe_A, [&](std::uint32_t index, const Sphere& sphere) {
      if (index != atom) near.push_back({sphere.centre_A, sphere.radius_A + kWaterProbe_A});
    });
    std::vector<Vec3> free;
    for (const Vec3& direction : directions) {
      const Vec3 point = own.centre_A + radius * direction;
      if (std::none_of(near.begin(), near.end(),
                       [&](const Sphere& s) { return glm::distance(point, s.centre_A) < s.radius_A - 1e-9; }))
        free.push_back(radius * direction);
    }
    if (free.empty()) return std::numeric_limits<float>::quiet_NaN();
    std::vector<PairBlock> blocks;
    int lane = PairBlock::kLanes;
    grid_.visitCentresNear(own.centre_A, radius + cut_A_, [&](std::uint32_t index, const Sphere& sphere) {
      if (lane == PairBlock::kLanes) {
        blocks.emplace_back().clear(0);
        lane = 0;
      }
      blocks.back().set(lane++, sphere.centre_A - own.centre_A, charges_[index]);
    });
    const PairRun all{blocks.data(), int(blocks.size())};
    double sum = 0.0;
    for (const Vec3& point : free) {
      PairTerms terms;
      kernel_.slope(&all, 1, constants_, PairOwn({.charge_e = 1.0f}, point), terms);
      sum += terms.energy[EnergyPart::Electrostatic];
    }
    return float(sum / double(free.size()));
  }

 private:
  const SharedArray<Sphere>& spheres_;
  PairConstants constants_;
  PairKernel kernel_;
  double cut_A_;
  std::vector<PairAtom> charges_;
  SphereGrid grid_{std::vector<Sphere>()}, cover_{std::vector<Sphere>()};
};

struct SurfacePotential::Parts {
  Parts(const Molecule& molecule, const PairAtoms& all, const PairModel& model, std::span<const std::uint32_t> held)
      : in_hand(flagsOf(molecule.atoms.size(), held)),
        rest(molecule, all, model, in_hand, false),
        hand(molecule, all, model, in_hand, true),
        out(molecule.atoms.size()) {}

  std::vector<char> in_hand;
  Part rest, hand;
  std::array<Vec3, kPoints> directions = spiral();
  std::vector<float> out;
};

SurfacePotential::SurfacePotential(const Molecule& molecule, const DielectricChoice& medium,
                                   std::span<const std::uint32_t> held)
    : parts_(std::make_unique<Parts>(molecule, pairAtoms(molecule), modelOf(medium), held)) {}

SurfacePotential::~SurfacePotential() = default;

std::size_t SurfacePotential::pieces() const { return (parts_->out.size() + kAtomsOfPiece - 1) / kAtomsOfPiece; }

void SurfacePotential::compute(std::size_t piece) {
  Parts& p = *parts_;
  for (std::size_t i = piece * kAtomsOfPiece; i < std::min(p.out.size(), (piece + 1) * kAtomsOfPiece); ++i)
    p.out[i] = (p.in_hand[i] ? p.hand : p.rest).potential(i, p.directions);
}

std::vector<float> SurfacePotential::take() { return std::move(parts_->out); }

std::vector<float> surfacePotential_kcal_mol_e(const Molecule& molecule, const DielectricChoice& medium,
                                               std::span<const std::uint32_t> held) {
  SurfacePotential work(molecule, medium, held);
  runGridWork(work.pieces(), 0, [&](std::size_t piece) { work.compute(piece); }, {});
  return work.take();
}

double potentialRange_kcal_mol_e(std::span<const float> potentials) {
  std::vector<float> sizes;
  for (const float v : potentials)
    if (!std::isnan(v)) sizes.push_back(std::abs(v));
  if (sizes.empty()) return 0.0;
  const auto most = sizes.begin() + std::ptrdiff_t(0.95 * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), most, sizes.end());
  const double wanted = double(*most) > 0.0 ? double(*most) : double(*std::max_element(sizes.begin(), sizes.end()));
  if (!(wanted > 0.0)) return 0.0;
  const double ten = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (wanted <= step * ten * (1.0 + 1e-9)) return step * ten;
  return 10.0 * ten;
}

}  // namespace moltact
