#include "app/ui/scene/force_watch.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/structure/measure.h"

namespace moltact {
namespace {

constexpr double kMinShown_kcal_mol = 0.05;     // a smaller energy rounds to zero on the screen
constexpr std::size_t kPairsOfFrame = 400'000;  // a sum over more pairs is spread: it is computed in fewer frames

}  // namespace

void ForceWatch::begin(const TouchableModel& stage, std::shared_ptr<const PairField> pairs) {
  const bool same_atoms = stage.spheres == stage_.spheres && stage.body == stage_.body;
  stage_ = stage;
  shares_.reset();
  field_ = pairs;
  on_ = false;
  clear();
  if (!same_atoms || !pairs) bonds_.reset();
  if (!pairs) return;
  const Molecule& m = *stage.molecule;
  std::vector<std::uint32_t> residue_of(m.atoms.size());
  for (std::size_t i = 0; i < residue_of.size(); ++i) residue_of[i] = m.atoms[i].residue;
  shares_.emplace(std::move(pairs), residue_of);
  if (stage.body && !bonds_) bonds_.emplace(m, *stage.spheres, *stage.body);
}

void ForceWatch::clear() {
  at_.reset();
  frames_left_ = 0;
  residues_.clear();
  highest_.reset();
  lines_.clear();
  drawn_.reset();
}

bool ForceWatch::isDrawn(std::uint32_t atom) const {
  return !hidden_ || !std::binary_search(hidden_->begin(), hidden_->end(), atom);
}

void ForceWatch::follow(const ServoSample& now, const AtomList& hidden) {
  on_ = shares_ && now.molecular_energy;
  if (!on_) return clear();
  if (hidden != hidden_ || language_ != language()) at_.reset();
  hidden_ = hidden;
  language_ = language();
  const PoseA pose = now.shownBody();
  if (frames_left_ > 0) --frames_left_;
  if (at_ && (frames_left_ > 0 || (at_->place == pose.place && at_->orientation == pose.orientation))) return;
  at_ = pose;
  shares_->at(pose);
  frames_left_ = 1 + shares_->pairs() / kPairsOfFrame;
  highest_.reset();
  for (const EnergyShare& one : shares_->held()) highest_ = std::max(highest_.value_or(-1e300), one.total_kcal_mol());
  residues_.assign(shares_->groups().begin(), shares_->groups().end());
  std::erase_if(residues_, [&](const EnergyShare& r) {
    if (r.index == kNoResidue || !(std::abs(r.total_kcal_mol()) >= kMinShown_kcal_mol)) return true;
    const Residue& residue = stage_.molecule->residues[r.index];
    for (std::uint32_t a = residue.first_atom; a < residue.first_atom + residue.atom_count; ++a)
      if (isDrawn(a)) return false;
    return true;
  });
  std::stable_sort(residues_.begin(), residues_.end(), [](const EnergyShare& a, const EnergyShare& b) {
    return std::abs(a.total_kcal_mol()) > std::abs(b.total_kcal_mol());
  });
  if (!stage_.body) return;
  findLines(pose);
  drawLines();
}

void ForceWatch::findLines(const PoseA& pose) {
  lines_.clear();
  const HeldBody& body = *stage_.body;
  const auto heldPlace = [&](std::size_t k) {
    return PointA{pose.place.A + pose.orientation * body.spheres[k].centre_A};
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;  // held atom and the scene's
  for (const HydrogenBond& bond : bonds_->at(pose)) {
    const bool gives = std::binary_search(body.atoms.begin(), body.atoms.end(), bond.donor);
    const std::uint32_t held = gives ? bond.donor : bond.acceptor, scene = gives ? bond.acceptor : bond.donor;
    if (!isDrawn(scene)) continue;
    const auto k = std::lower_bound(body.atoms.begin(), body.atoms.end(), held) - body.atoms.begin();
    lines_.push_back({held, scene, heldPlace(std::size_t(k)), {(*stage_.spheres)[scene].centre_A}, false});
    drawn.insert({held, scene});
  }
  // Two atoms near each other may have several pairs of their hydrogens.
  const PairField& field = shares_->field();
  for (const NearPair& pair : shares_->pairsAbove(kClash_kcal_mol)) {
    const std::uint32_t k = field.held_carriers[pair.held], held = body.atoms[k], scene = field.carriers[pair.scene];
    if (!isDrawn(scene) || !drawn.insert({held, scene}).second) continue;
    lines_.push_back({held, scene, heldPlace(k), {(*stage_.spheres)[scene].centre_A}, true});
  }
}

void ForceWatch::drawLines() {
  auto lines = std::make_shared<Annotations>();
  for (const HeldLine& line : lines_) {
    std::vector<PointA> places{line.from, line.to};
    std::string text = measureText(places);
    lines->measures.push_back(
        {std::move(places), std::move(text), line.clash ? Annotations::Line::Clash : Annotations::Line::Bond});
  }
  if (lines->measures.empty())
    drawn_.reset();
  else if (!drawn_ || drawn_->measures != lines->measures)
    drawn_ = std::move(lines);
}

}  // namespace moltact
