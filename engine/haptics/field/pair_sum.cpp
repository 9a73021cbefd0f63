#include "engine/haptics/field/pair_sum.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/contact.h"
#include "engine/haptics/field/held_atom_sum.h"

namespace moltact {

PairSum::PairSum(std::shared_ptr<const SphereGrid> scene, std::vector<PairAtom> atoms, std::vector<PairAtom> body,
                 const PairModel& model)
    : scene_(std::move(scene)),
      atoms_(std::move(atoms)),
      body_(std::move(body)),
      model_(model),
      felt_(model),
      constants_(model),
      kernel_(pairKernel(model.kind)),
      lists_(body_.size()),
      places_(body_.size()),
      curvatures_(body_.size()),
      slopes_(body_.size()) {
  root_depths_.reserve(atoms_.size());
  for (const PairAtom& atom : atoms_) root_depths_.push_back(std::sqrt(atom.depth_kcal_mol));
  // No atom has more neighbours than there are atoms, nor than fit round the most crowded place. The latter is bounded
  // by twice a protein's density with all hydrogens, 0.1 atoms per cubic angstrom.
  const double reach = model_.cutoff_A + kMargin_A;
  const auto crowded = std::size_t(0.2 * 4.19 * reach * reach * reach);
  const std::size_t each = std::min(atoms_.size(), crowded) / Chunk::kAtoms + 2;
  chunks_.resize(std::min(body_.size() * each, kMaxListedPairs / Chunk::kAtoms));
  candidates_.resize(std::clamp<std::size_t>(std::min(atoms_.size(), crowded), 1, kMaxCandidates));
  order_.resize(candidates_.size());
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    chunks_[k].next = free_;
    free_ = std::int32_t(k);
  }
}

std::size_t PairSum::bytes() const noexcept {
  return chunks_.capacity() * sizeof(Chunk) + candidates_.capacity() * (sizeof(Candidate) + sizeof order_[0]) +
         (atoms_.capacity() + body_.capacity()) * sizeof(PairAtom) + lists_.capacity() * sizeof(List) +
         places_.capacity() * sizeof(Vec3);
}

void PairSum::release(List& list) noexcept {
  for (std::int32_t k = list.first; k >= 0;) {
    const std::int32_t next = chunks_[std::size_t(k)].next;
    chunks_[std::size_t(k)].next = free_;
    free_ = k;
    k = next;
  }
  listed_pairs_ -= std::size_t(list.atoms);
  list = {};
}

// Lists the first `count` candidates from near to far; false if no memory is left.
bool PairSum::append(List& list, std::size_t count) noexcept {
  // Counted into shells of equal widths of the squared distance.
  constexpr std::size_t kShells = 64;
  const double reach = model_.cutoff_A + kMargin_A;
  const float shells_per_A2 = float(double(kShells) / (reach * reach));
  const auto shell = [&](const Candidate& c) {
    return std::min(std::size_t(c.squared_A2 * shells_per_A2), kShells - 1);
  };
  std::array<std::uint32_t, kShells + 1> begins{};
  for (std::size_t k = 0; k < count; ++k) ++begins[shell(candidates_[k]) + 1];
  for (std::size_t k = 0; k < kShells; ++k) begins[k + 1] += begins[k];
  for (std::size_t k = 0; k < count; ++k) order_[begins[shell(candidates_[k])]++] = std::uint32_t(k);

  for (std::size_t k = 0; k < count; ++k) {
    const auto at = std::size_t(list.atoms) % Chunk::kAtoms;
    if (at == 0) {
      if (free_ < 0) return false;
      const std::int32_t fresh = free_;
      free_ = chunks_[std::size_t(fresh)].next;
      chunks_[std::size_t(fresh)].next = -1;
      (list.last < 0 ? list.first : chunks_[std::size_t(list.last)].next) = fresh;
      list.last = fresh;
    }
    const Candidate& next = candidates_[order_[k]];
    Chunk& chunk = chunks_[std::size_t(list.last)];
    PairBlock& block = chunk.blocks[at / PairBlock::kLanes];
    const int lane = int(at % PairBlock::kLanes);
    const float away_A = std::sqrt(next.squared_A2);
    block.nearest_A = lane == 0 ? away_A : std::min(block.nearest_A, away_A);
    block.farthest_A = lane == 0 ? away_A : std::max(block.farthest_A, away_A);
    block.set(lane, next.relative_A, atoms_[next.atom], root_depths_[next.atom]);
    chunk.atoms[at] = next.atom;
    ++list.atoms;
  }
  return true;
}

void PairSum::renew(List& list, const Vec3& centre) noexcept {
  release(list);
  list.centre_A = centre;
  list.valid = true;
  const double reach = model_.cutoff_A + kMargin_A;
  std::size_t count = 0;
  scene_->visitCentresNear(centre, reach, [&](std::uint32_t index, const Sphere& sphere) {
    const Vec3 relative = sphere.centre_A - centre;
    const double squared = glm::dot(relative, relative);
    if (squared > reach * reach) return true;
    candidates_[count++] = {glm::vec3(relative), float(squared), index};
    if (count < candidates_.size()) return true;
    list.whole = append(list, count);
    count = 0;
    return list.whole;
  });
  list.whole = list.whole && append(list, count);
  listed_pairs_ += std::size_t(list.atoms);
  const auto at = std::size_t(list.atoms) % Chunk::kAtoms;
  if (!list.whole) {
    release(list);
    list.centre_A = centre;
    list.valid = true;
    list.whole = false;
  } else if (at % PairBlock::kLanes != 0) {
    chunks_[std::size_t(list.last)].blocks[at / PairBlock::kLanes].clear(int(at % PairBlock::kLanes));
  }
  ++renewed_;
}

PairOwn PairSum::own(std::size_t atom) const noexcept {
  const PairAtom& a = body_[atom];
  const Vec3 at = lists_[atom].whole ? places_[atom] - lists_[atom].centre_A : Vec3(0.0);
  return {a, at};
}

template <class Visit>
void PairSum::eachPairOf(std::size_t atom, Visit&& visit) const noexcept {
  const List& list = lists_[atom];
  const PairOwn self = own(atom);
  PairGradients gradients;
  if (list.whole) {
    int left = list.atoms;
    for (std::int32_t k = list.first; k >= 0; k = chunks_[std::size_t(k)].next) {
      const Chunk& chunk = chunks_[std::size_t(k)];
      for (int at = 0; at < Chunk::kAtoms && left > 0; at += PairBlock::kLanes) {
        kernel_.each(chunk.blocks[std::size_t(at / PairBlock::kLanes)], constants_, self, gradients);
        for (int lane = 0; lane < PairBlock::kLanes && left > 0; ++lane, --left)
          visit(chunk.atoms[std::size_t(at + lane)], gradients[std::size_t(lane)]);
      }
    }
    return;
  }
  PairBlock block;
  block.clear(0);
  scene_->visitCentresNear(places_[atom], model_.cutoff_A, [&](std::uint32_t index, const Sphere& sphere) {
    block.set(0, sphere.centre_A - places_[atom], atoms_[index]);
    kernel_.each(block, constants_, self, gradients);
    visit(index, gradients[0]);
  });
}

std::size_t PairSum::sceneForces(std::span<Vec3> forces, std::span<std::uint32_t> near) const noexcept {
  std::size_t count = 0;
  // Not a number marks an atom that is not in `near` yet.
  for (std::size_t k = 0; k < body_.size(); ++k)
    eachPairOf(k, [&](std::uint32_t index, const Vec3&) { forces[index].x = NAN; });
  for (std::size_t k = 0; k < body_.size(); ++k)
    eachPairOf(k, [&](std::uint32_t index, const Vec3& gradient) {
      if (std::isnan(forces[index].x)) {
        forces[index] = Vec3(0.0);
        near[count++] = index;
      }
      forces[index] += slopes_[k] * gradient;
    });
  return count;
}

PairTerms PairSum::sum(std::size_t atom, AddPairs add) const noexcept {
  PairTerms terms;
  const List& list = lists_[atom];
  const Vec3& place = places_[atom];
  const PairOwn self = own(atom);
  if (list.whole) {
    std::array<PairRun, 8> runs;
    std::size_t count = 0;
    std::int32_t k = list.first;
    for (int left = (list.atoms + PairBlock::kLanes - 1) / PairBlock::kLanes; left > 0; left -= Chunk::kBlocks) {
      const Chunk& chunk = chunks_[std::size_t(k)];
      runs[count++] = {chunk.blocks.data(), std::min(left, Chunk::kBlocks)};
      if (left > Chunk::kBlocks) k = chunk.next;  // read only if needed: it lies in a cache line of its own
      if (count == runs.size() || left <= Chunk::kBlocks) {
        add(runs.data(), int(count), constants_, self, terms);
        count = 0;
      }
    }
    return terms;
  }
  PairBlock block;
  const PairRun one{&block, 1};
  int lane = 0;
  scene_->visitCentresNear(place, model_.cutoff_A, [&](std::uint32_t index, const Sphere& sphere) {
    block.set(lane++, sphere.centre_A - place, atoms_[index]);
    if (lane < PairBlock::kLanes) return;
    add(&one, 1, constants_, self, terms);
    lane = 0;
  });
  if (lane > 0) {
    block.clear(lane);
    add(&one, 1, constants_, self, terms);
  }
  return terms;
}

PairEnergy PairSum::at(const PoseA& pose) noexcept {
  renewed_ = 0;
  const Quat& q = pose.orientation;
  if (!finite(pose.place.A) || glm::length(pose.place.A) > kMaxPosition_A || !std::isfinite(glm::dot(q, q)) ||
      body_.empty())
    return {};
  const glm::dmat3 turn = glm::mat3_cast(q);
  const auto movedBy = [&](std::size_t k, double margin_A) {
    const Vec3 off = places_[k] - lists_[k].centre_A;
    return glm::dot(off, off) > margin_A * margin_A;
  };
  // Lists that are no longer valid are renewed at once, and a few that soon will be, in turn.
  for (std::size_t k = 0; k < body_.size(); ++k) {
    places_[k] = pose.place.A + turn * body_[k].centre_A;
    List& list = lists_[k];
    if (!list.valid || (list.whole && movedBy(k, kMargin_A))) renew(list, places_[k]);
  }
  const std::size_t looks = body_.size() / 8 + 1;
  for (std::size_t k = 0; k < looks; ++k) {
    cursor_ = (cursor_ + 1) % body_.size();
    List& list = lists_[cursor_];
    if (!list.whole || movedBy(cursor_, kRenewFrom_A)) renew(list, places_[cursor_]);
  }

  HeldAtomSum total(felt_);
  for (std::size_t k = 0; k < body_.size(); ++k) {
    if (lists_[k].whole && lists_[k].atoms == 0) continue;
    const bool curved = calls_ < kCurvatureTicks || (k + calls_) % kCurvatureTicks == 0;
    const PairTerms terms = sum(k, curved ? kernel_.curvature : kernel_.slope);
    if (curved) curvatures_[k] = terms.curvature;
    slopes_[k] = total.add(terms, curvatures_[k], places_[k] - pose.place.A);
  }
  ++calls_;
  return total.energy();
}

}  // namespace moltact
