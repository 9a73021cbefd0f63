#include "engine/haptics/field/energy_grid.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/contact.h"
#include "engine/haptics/field/held_atom_sum.h"

namespace moltact {
namespace {

// Adds the second derivatives of outer products a b + b a.
void addOuter(std::array<double, 6>& c, const Vec3& a, const Vec3& b) {
  c[0] += 2.0 * a.x * b.x;
  c[1] += 2.0 * a.y * b.y;
  c[2] += 2.0 * a.z * b.z;
  c[3] += a.x * b.y + a.y * b.x;
  c[4] += a.x * b.z + a.z * b.x;
  c[5] += a.y * b.z + a.z * b.y;
}

// The energy whose folded value is in the sample: E = f sinh(v / f) above zero.
void unfold(GridSample& s, double fold, bool curved) {
  if (!(fold > 0.0 && s.value > 0.0)) return;
  const double x = s.value / fold, sine = std::sinh(x), first = std::sqrt(1.0 + sine * sine), second = sine / fold;
  s.value = fold * sine;
  if (curved) {
    for (double& c : s.curvature) c *= first;
    addOuter(s.curvature, s.gradient, s.gradient * (0.5 * second));
  }
  s.gradient *= first;
}

// The share of the fine grid: 1 inside, 0 at its faces, with its derivatives.
struct Share {
  double value = 1.0;
  Vec3 first{0.0};
  std::array<double, 6> second{};
};

Share shareAt(const GridBox& box, const Vec3& place) {
  const Vec3 low = box.low_A(), high = box.high_A();
  Vec3 value, first(0.0), second(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double from_low = place[axis] - low[axis], from_high = high[axis] - place[axis];
    const double width = std::min(kGridBlend_A, 0.5 * (high[axis] - low[axis]));
    const double u = std::min(from_low, from_high) / width, way = from_low < from_high ? 1.0 : -1.0;
    value[axis] = u < 1.0 ? u * u * (3.0 - 2.0 * u) : 1.0;
    if (u < 1.0) {
      first[axis] = way * 6.0 * u * (1.0 - u) / width;
      second[axis] = (6.0 - 12.0 * u) / (width * width);
    }
  }
  Share out;
  out.value = value.x * value.y * value.z;
  out.first = {first.x * value.y * value.z, value.x * first.y * value.z, value.x * value.y * first.z};
  out.second = {second.x * value.y * value.z, value.x * second.y * value.z, value.x * value.y * second.z,
                first.x * first.y * value.z,  first.x * value.y * first.z,  value.x * first.y * first.z};
  return out;
}

}  // namespace

std::size_t GridMaps::bytes() const {
  std::size_t out = electrostatic.capacity() + desolvation.capacity();
  for (const std::vector<float>& map : van_der_waals) out += map.capacity();
  return out * sizeof(float);
}

void foldWalls(GridMaps& maps, double fold) {
  for (std::vector<float>& map : maps.van_der_waals)
    for (float& value : map)
      if (value > 0.0f) value = float(fold * std::asinh(double(value) / fold));
  maps.fold = fold;
}

std::vector<float> gridSizes(std::span<const PairAtom> body) {
  std::vector<float> out;
  for (const PairAtom& atom : body)
    if (atom.depth_kcal_mol > 0.0f) out.push_back(atom.half_minimum_A);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<GridAtom> gridAtoms(std::span<const PairAtom> body, std::span<const float> sizes) {
  std::vector<GridAtom> out;
  for (const PairAtom& atom : body) {
    const auto size = std::find(sizes.begin(), sizes.end(), atom.half_minimum_A);
    const bool mapped = atom.depth_kcal_mol > 0.0f && size != sizes.end();
    out.push_back({atom.centre_A, mapped ? std::int32_t(size - sizes.begin()) : -1, std::sqrt(atom.depth_kcal_mol),
                   atom.charge_e});
  }
  return out;
}

EnergyGrid::EnergyGrid(std::shared_ptr<const GridMaps> coarse, std::shared_ptr<const GridMaps> fine,
                       std::vector<GridAtom> body, GridInterpolation interpolation, double wall_kcal_mol)
    : coarse_(std::move(coarse)),
      fine_(std::move(fine)),
      body_(std::move(body)),
      interpolation_(interpolation),
      wall_(wall_kcal_mol),
      curvatures_(body_.size()) {}

PairTerms EnergyGrid::terms(const GridMaps& maps, const GridCell& cell, const GridAtom& atom,
                            bool curved) const noexcept {
  PairTerms out;
  const auto add = [&](const std::vector<float>& map, double factor, double fold, double& energy) {
    GridSample s = curved ? curvedGridSample(maps.box, cell, interpolation_, map.data())
                          : gridSample(maps.box, cell, interpolation_, map.data());
    unfold(s, fold, curved);
    energy += factor * s.value;
    out.gradient += factor * s.gradient;
    if (!curved) return;
    for (std::size_t k = 0; k < 6; ++k) out.curvature[k] += factor * s.curvature[k];
  };
  if (atom.map >= 0)
    add(maps.van_der_waals[std::size_t(atom.map)], double(atom.factor), maps.fold, out.energy[EnergyPart::VanDerWaals]);
  if (atom.charge_e == 0.0f) return out;
  if (!maps.electrostatic.empty())
    add(maps.electrostatic, double(atom.charge_e), 0.0, out.energy[EnergyPart::Electrostatic]);
  if (!maps.desolvation.empty())
    add(maps.desolvation, std::abs(double(atom.charge_e)), 0.0, out.energy[EnergyPart::VanDerWaals]);
  return out;
}

void EnergyGrid::blendFine(PairTerms& coarse, const Vec3& place, const GridAtom& atom, bool curved) const noexcept {
  const auto cell = gridCell(fine_->box, place);
  if (!cell) return;
  const PairTerms fine = terms(*fine_, *cell, atom, curved);
  const Share share = shareAt(fine_->box, place);
  const double more = fine.energy.total_kcal_mol() - coarse.energy.total_kcal_mol();
  const Vec3 steeper = fine.gradient - coarse.gradient;
  for (std::size_t k = 0; k < kEnergyParts; ++k)
    coarse.energy.values[k] += share.value * (fine.energy.values[k] - coarse.energy.values[k]);
  coarse.gradient += share.value * steeper + more * share.first;
  if (!curved) return;
  for (std::size_t k = 0; k < 6; ++k)
    coarse.curvature[k] += share.value * (fine.curvature[k] - coarse.curvature[k]) + more * share.second[k];
  addOuter(coarse.curvature, share.first, steeper);
}

PairEnergy EnergyGrid::at(const PoseA& pose) noexcept {
  outside_ = false;
  const Quat& q = pose.orientation;
  if (!finite(pose.place.A) || glm::length(pose.place.A) > kMaxPosition_A || !std::isfinite(glm::dot(q, q))) return {};
  const glm::dmat3 turn = glm::mat3_cast(q);
  HeldAtomSum sum{FeltFunction(wall_)};
  for (std::size_t k = 0; k < body_.size(); ++k) {
    const GridAtom& atom = body_[k];
    const Vec3 arm = turn * atom.centre_A, place = pose.place.A + arm;
    const auto cell = gridCell(coarse_->box, place);
    if (!cell) {
      outside_ = true;
      return {};
    }
    const bool curved = calls_ < PairSum::kCurvatureTicks || (k + calls_) % PairSum::kCurvatureTicks == 0;
    PairTerms found = terms(*coarse_, *cell, atom, curved);
    if (fine_) blendFine(found, place, atom, curved);
    if (curved) curvatures_[k] = found.curvature;
    sum.add(found, curvatures_[k], arm);
  }
  ++calls_;
  return sum.energy();
}

}  // namespace moltact
