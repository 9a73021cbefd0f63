#include "engine/haptics/field/pair_shares.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/haptics/contact.h"

namespace moltact {
namespace {

// Pairs at a greater distance attract each other: the largest sum of half distances of lowest energy in AMBER's force
// fields is below this (unit: angstrom).
constexpr double kRepelling_A = 5.0;

}  // namespace

PairShares::PairShares(std::shared_ptr<const PairField> field, std::span<const std::uint32_t> group_of_carrier)
    : field_(std::move(field)), constants_(field_->model), kernel_(pairKernel(field_->model.kind)) {
  std::map<std::uint32_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < field_->atoms.size(); ++i) members[group_of_carrier[field_->carriers[i]]].push_back(i);
  for (const auto& [number, atoms] : members) {
    Group group{.number = number, .first_block = blocks_.size(), .atoms = int(atoms.size())};
    for (const std::size_t i : atoms) group.centre_A += field_->atoms[i].centre_A / double(atoms.size());
    int lane = PairBlock::kLanes;
    for (const std::size_t i : atoms) {
      const Vec3 relative = field_->atoms[i].centre_A - group.centre_A;
      group.radius_A = std::max(group.radius_A, glm::length(relative));
      if (lane == PairBlock::kLanes) {
        blocks_.emplace_back().clear(0);
        ++group.blocks;
        lane = 0;
      }
      blocks_.back().set(lane++, relative, field_->atoms[i]);
    }
    groups_.push_back(group);
  }
  for (const PairAtom& a : field_->held) reach_A_ = std::max(reach_A_, glm::length(a.centre_A));
  places_.resize(field_->held.size());
  held_.resize(field_->held.size());
}

void PairShares::at(const PoseA& pose) {
  pairs_ = 0;
  force_ = Vec3(0.0);
  near_.clear();
  for (std::size_t k = 0; k < held_.size(); ++k) held_[k] = {.index = std::uint32_t(k)};
  const Quat& q = pose.orientation;
  const bool finite_pose = finite(pose.place.A) && glm::length(pose.place.A) <= kMaxPosition_A && rotates(q);
  const glm::dmat3 turn = finite_pose ? glm::mat3_cast(q) : glm::dmat3(1.0);
  for (std::size_t k = 0; k < held_.size(); ++k)
    places_[k] = (finite_pose ? pose.place.A : Vec3(0.0)) + turn * field_->held[k].centre_A;
  if (!finite_pose) return;
  const double cut = field_->model.cutoff_A;
  for (const Group& group : groups_) {
    if (glm::distance(pose.place.A, group.centre_A) > reach_A_ + group.radius_A + cut) continue;
    EnergyShare share{.index = group.number};
    const PairRun run{blocks_.data() + group.first_block, group.blocks};
    bool near = false;
    for (std::size_t k = 0; k < held_.size(); ++k) {
      const Vec3 relative = places_[k] - group.centre_A;
      if (glm::length(relative) > group.radius_A + cut) continue;
      PairTerms terms;
      kernel_.slope(&run, 1, constants_, PairOwn(field_->held[k], relative), terms);
      near = true;
      pairs_ += std::size_t(group.atoms);
      share.parts += terms.energy;
      held_[k].parts += terms.energy;
      force_ -= terms.gradient;
    }
    if (near) near_.push_back(share);
  }
}

std::vector<NearPair> PairShares::pairsAbove(double least_kcal_mol) const {
  std::vector<NearPair> out;
  for (std::size_t k = 0; k < places_.size(); ++k)
    field_->places->visitCentresNear(places_[k], kRepelling_A, [&](std::uint32_t index, const Sphere& sphere) {
      PairBlock block;
      block.clear(0);
      block.set(0, sphere.centre_A - places_[k], field_->atoms[index]);
      const PairRun one{&block, 1};
      PairTerms terms;
      kernel_.slope(&one, 1, constants_, PairOwn(field_->held[k], Vec3(0.0)), terms);
      const double energy = terms.energy[EnergyPart::VanDerWaals];
      if (energy >= least_kcal_mol) out.push_back({std::uint32_t(k), index, energy});
    });
  return out;
}

}  // namespace moltact
