#include "engine/lesson/scene_forces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/sweep.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_search.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

// The stiffness of the spring to a hand that yields: it only damps the fall (unit: N/mm; 0.7 kcal/mol/A^2).
constexpr double kYielding_N_per_mm = 5e-4;
constexpr int kMaxTicks = 4000, kRestTicks = 5;
constexpr double kRest_A = 2e-4;       // motion per tick below which it rests
constexpr double kOffSurface_A = 0.3;  // gap at which a fall begins
constexpr int kProbeDirections = 14;   // per atom, for a probe

}  // namespace

// An interaction that falls, and the energy at a pose.
class SceneForces::Felt {
 public:
  explicit Felt(std::unique_ptr<Interaction> interaction) : interaction_(std::move(interaction)) {}
  explicit operator bool() const { return bool(interaction_); }

  /// Puts it down there; empty if that is inside an atom.
  std::optional<Well> put(const PoseA& pose) {
    interaction_->reset();
    return at(pose);
  }
  /// One tick in which the hand is at `pose`.
  std::optional<Well> at(const PoseA& pose) {
    const Response r = interaction_->respond(pose);
    if (r.contact.fault != Fault::None || !r.molecular_energy) return std::nullopt;
    return Well{r.shownBody(pose), *r.molecular_energy};
  }

 private:
  std::unique_ptr<Interaction> interaction_;
};

SceneForces::SceneForces(const TouchSetup& touch, std::shared_ptr<const Molecule> molecule,
                         std::shared_ptr<const SphereGrid> spheres, std::shared_ptr<const HeldBody> body)
    : touch_(resolveInteraction(touch, body != nullptr)),
      molecule_(std::move(molecule)),
      spheres_(std::move(spheres)),
      body_(std::move(body)) {}

std::shared_ptr<const SceneForces> SceneForces::holding(std::shared_ptr<const HeldBody> body) const {
  return std::make_shared<const SceneForces>(touch_, molecule_, spheres_, std::move(body));
}

namespace {

std::unique_ptr<Interaction> yielding(TouchSetup touch, const Molecule& molecule,
                                      const std::shared_ptr<const SphereGrid>& spheres,
                                      const std::shared_ptr<const HeldBody>& body) {
  touch.coupling_N_per_mm = kYielding_N_per_mm;
  return makeInteraction(interactionInput(touch, molecule, spheres, body));
}

std::optional<Well> fallOf(auto& felt, const PoseA& start, const std::function<bool(const Well&)>& visit) {
  std::optional<Well> now = felt.put(start);
  for (int k = 0, rested = 0; now && k < kMaxTicks && rested < kRestTicks; ++k) {
    if (visit && !visit(*now)) break;
    const std::optional<Well> next = felt.at(now->pose);
    if (!next) break;
    const double moved_A = glm::distance(next->pose.place.A, now->pose.place.A) +
                           glm::length(rotationBetween(now->pose.orientation, next->pose.orientation));
    rested = moved_A < kRest_A ? rested + 1 : 0;
    now = next;
  }
  return now;
}

}  // namespace

std::optional<Well> SceneForces::fall(const PoseA& start, const TouchChange& change,
                                      const std::function<bool(const Well&)>& visit) const {
  Felt felt(yielding(change.over(touch_), *molecule_, spheres_, body_));
  return felt ? fallOf(felt, start, visit) : std::nullopt;
}

std::vector<PoseA> SceneForces::starts(int count, Felt& felt, const std::function<bool(const Vec3&)>& from) const {
  std::vector<PoseA> out;
  const auto wanted = [&](const Vec3& place) { return !from || from(place); };
  if (body_) {
    const PoseA file{body_->middle};
    if (wanted(file.place.A)) out.push_back(file);
    std::uint64_t random = 1;
    const Vec3 middle = 0.5 * (spheres_->low_A() + spheres_->high_A());
    const double far_A = glm::distance(spheres_->low_A(), spheres_->high_A()) + 2.0 * body_->reach_A + 1.0;
    for (int tries = 0; int(out.size()) < count && tries < 20 * count; ++tries) {
      const Quat turned = randomOrientation(random);
      const Vec3 way = evenDirection(tries, 20 * count) * far_A;
      // Toward a random atom, so that pits are met as well as faces.
      const auto atom = std::size_t(nextFraction(random) * double(spheres_->size()));
      const Vec3 aim = spheres_->touchable(atom) ? (*spheres_)[atom].centre_A : middle;
      const Hit hit = sweep(*spheres_, HandShape(*body_, turned), aim + way, aim);
      if (hit.sphere < 0) continue;
      const Vec3 place = aim + way * (1.0 - hit.t) + glm::normalize(way) * kOffSurface_A;
      if (wanted(place)) out.push_back({{place}, turned});
    }
    return out;
  }
  // A probe: around every atom, the places with the lowest energy first.
  std::vector<std::pair<double, PoseA>> found;
  const double probe_A = touch_.probe_A;
  for (std::size_t i = 0; i < spheres_->size(); ++i) {
    if (!spheres_->touchable(i)) continue;
    for (int k = 0; k < kProbeDirections; ++k) {
      const Sphere& atom = (*spheres_)[i];
      const Vec3 place = atom.centre_A + evenDirection(k, kProbeDirections) * (atom.radius_A + probe_A + kOffSurface_A);
      if (!wanted(place)) continue;
      bool free = true;
      spheres_->visitNear(place, probe_A, [&](std::uint32_t, const Sphere& s) {
        return free = glm::distance(place, s.centre_A) >= s.radius_A + probe_A;
      });
      if (!free) continue;
      const PoseA pose{{place}};
      if (const auto there = felt.put(pose)) found.emplace_back(there->energy.total_kcal_mol(), pose);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [energy, pose] : found) {
    if (int(out.size()) >= count) break;
    const auto near = [&, here = pose.place.A](const PoseA& p) { return glm::distance(p.place.A, here) < 1.0; };
    if (std::none_of(out.begin(), out.end(), near)) out.push_back(pose);
  }
  return out;
}

std::vector<Well> SceneForces::wells(int count, const TouchChange& change,
                                     const std::function<bool(const Vec3&)>& from) const {
  Felt felt(yielding(change.over(touch_), *molecule_, spheres_, body_));
  std::vector<Well> out;
  if (!felt) return out;
  for (const PoseA& start : starts(count, felt, from))
    if (const auto well = fallOf(felt, start, {})) out.push_back(*well);
  std::stable_sort(out.begin(), out.end(),
                   [](const Well& a, const Well& b) { return a.energy.total_kcal_mol() < b.energy.total_kcal_mol(); });
  return out;
}

std::shared_ptr<const SceneForces> sceneForces(const SceneSpec& scene, std::shared_ptr<const Molecule> molecule,
                                               std::span<const std::uint32_t> untouchable,
                                               std::shared_ptr<const HeldBody> body) {
  if (!molecule || !forceChoice(scene.touch.forces).any()) return nullptr;
  auto spheres = std::make_shared<const SphereGrid>(molecule->spheres, untouchable);
  return std::make_shared<const SceneForces>(scene.touch, std::move(molecule), std::move(spheres), std::move(body));
}

std::string energyText(double energy_kcal_mol) { return quantityIn(energy_kcal_mol, "kcal/mol", decimals(1)); }

}  // namespace moltact
