#include "engine/lesson/tasks/touch_limits.h"

#include <algorithm>

namespace moltact {
namespace {

std::optional<Vec3> middleOf(const Selection& selection, const Molecule& molecule) {
  if (!selection.given()) return std::nullopt;
  const std::vector<std::uint32_t> atoms = selection.select(molecule);
  if (atoms.empty()) return std::nullopt;
  Vec3 middle(0.0);
  for (const std::uint32_t a : atoms) middle += molecule.spheres[a].centre_A / double(atoms.size());
  return middle;
}

}  // namespace

TouchLimits::TouchLimits(const TaskSpec& spec, std::string_view target, const Molecule& molecule) {
  const auto from = middleOf(spec.values[target].selection, molecule),
             to = middleOf(spec.values["side"].selection, molecule);
  if (from && to) side_ = Side{*from, *to};
  const Selection& round = spec.values["region"].selection;
  if (const auto centre = middleOf(round, molecule)) {
    region_ = Reach{*centre, 0.0};
    for (const std::uint32_t a : round.select(molecule))
      region_->radius_A = std::max(region_->radius_A,
                                   glm::distance(molecule.spheres[a].centre_A, *centre) + molecule.spheres[a].radius_A);
  }
}

bool TouchLimits::allow(const Vec3& scp_A, double probe_A) const {
  if (side_ && glm::dot(scp_A - side_->from_A, side_->to_A - side_->from_A) <= 0.0) return false;
  return !region_ || glm::distance(scp_A, region_->centre_A) <= region_->radius_A + probe_A;
}

std::vector<KeySpec> TouchLimits::keys() {
  return {{.name = "side",
           .type = ValueType::Selection,
           .meaning = "Only the side that faces these atoms counts, as seen from the centre of the target."},
          {.name = "region",
           .type = ValueType::Selection,
           .meaning = "Only contact points in the sphere around these atoms count. It extends as far as the probe on "
                      "the outermost of them."}};
}

WrongTouches::WrongTouches(const TaskSpec& spec, const Molecule& molecule) {
  for (const SelectionRemark& r : spec.values["wrong"].remarks)
    remarks_.push_back({AtomSet(r.atoms, molecule), r.text});
}

std::string WrongTouches::about(const Contact& contact) const {
  for (const Remark& r : remarks_)
    if (r.atoms.touchedBy(contact)) return r.text;
  return {};
}

KeySpec WrongTouches::key() {
  return {.name = "wrong",
          .type = ValueType::Remarks,
          .meaning = "Replies to touches of other atoms; the first line whose atoms are touched applies."};
}

}  // namespace moltact
