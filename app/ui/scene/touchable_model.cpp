#include "app/ui/scene/touchable_model.h"

#include <algorithm>
#include <span>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/servo/safety_stage.h"
#include "engine/structure/interaction_input.h"
#include "engine/workspace/fit_workspace.h"

namespace moltact {
namespace {

// The new tracker first approaches from slightly outside the old surface, or from as far as its own surface is outside
// (unit: angstrom). A mesh lies inside the spheres, and a coarse grid may lie outside.
constexpr double kOutside_A = 1e-3, kFarthestOutside_A = 2.0;

TouchableModel stageOf(std::shared_ptr<const Molecule> molecule, std::span<const std::uint32_t> untouchable,
                       std::span<const std::uint32_t> held) {
  TouchableModel stage;
  if (!held.empty()) stage.body = heldBody(*molecule, held);
  stage.spheres = std::make_shared<const SphereGrid>(molecule->spheres, untouchable);
  const SphereGrid& spheres = *stage.spheres;
  std::size_t felt = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) felt += spheres.touchable(i);
  for (std::size_t i = 0; i < spheres.size(); ++i)
    if (felt == 0 || spheres.touchable(i))
      stage.middle.A += spheres[i].centre_A / double(felt == 0 ? spheres.size() : felt);
  stage.molecule = std::move(molecule);
  stage.workspace = fitWorkspace(spheres);
  stage.reach_A = 0.5 * glm::distance(spheres.low_A(), spheres.high_A()) +
                  std::max(kMaxProbe_A, stage.body ? stage.body->reach_A : 0.0);
  return stage;
}

}  // namespace

Expected<TouchableModel> makeTouchableModel(Molecule molecule, const std::filesystem::path& file) {
  if (molecule.atoms.empty())
    return Problem{file.string(), 0, 0, tr("there are no atoms to touch"),
                   tr("open a structure file with coordinates")};
  return stageOf(std::make_shared<const Molecule>(std::move(molecule)), {}, {});
}

TouchableModel withUntouchable(const TouchableModel& stage, const std::vector<std::uint32_t>& atoms,
                               const std::vector<std::uint32_t>& held) {
  if (!stage) return stage;
  const std::vector<std::uint32_t> holds = stage.body ? stage.body->atoms : std::vector<std::uint32_t>();
  return stage.spheres->untouchable() == atoms && holds == held ? stage : stageOf(stage.molecule, atoms, held);
}

HandShape handShape(const TouchableModel& stage, double probe_A, const Quat& orientation) {
  return stage.body ? HandShape(*stage.body, orientation) : HandShape(probe_A);
}

TouchableModel movedModel(const TouchableModel& model, SharedArray<Sphere> places) {
  TouchableModel out = model;
  out.spheres = std::make_shared<const SphereGrid>(std::move(places), model.spheres->untouchable());
  return out;
}

TouchableModel movedModel(const TouchableModel& model, const SphereMotion& motion, SharedArray<Sphere> places) {
  TouchableModel out = model;
  out.spheres = std::make_shared<const SphereGrid>(SphereGrid::within(motion.sweptSpheres(), std::move(places)));
  return out;
}

void leadToContact(Interaction& made, const Contact& contact, const PoseA& hand) {
  const Vec3 outward = contact.scp.A - hand.place.A;
  const double depth = glm::length(outward);
  if (!contact.touching() || !(depth > 0.0)) return;
  // Another method's surface may be slightly higher, so the start is moved outward until it is free.
  for (double out_A = kOutside_A; out_A < kFarthestOutside_A; out_A *= 1.5)
    if (made.respond({{contact.scp.A + outward * (out_A / depth)}, hand.orientation}).contact.fault == Fault::None)
      break;
  made.respond(hand);
}

void leadFrom(Interaction& made, const ServoSample& latest) {
  const PoseA hand{latest.hip, latest.orientation}, body = latest.shownBody();
  // A probe lies on the surface up to rounding: the start is moved outward until it is free. A body overlaps nothing.
  Vec3 outward(0.0);
  if (!latest.holds_body)
    for (const Vec3& normal : latest.contact.normals) outward += normal;
  for (double out_A = 0.0; out_A < kFarthestOutside_A; out_A = std::max(kOutside_A, 1.5 * out_A)) {
    made.reset();
    if (made.respond({{body.place.A + out_A * outward}, body.orientation}).contact.fault == Fault::None) break;
    if (outward == Vec3(0.0)) break;
  }
  made.respond(hand);
}

std::unique_ptr<Interaction> interactionAt(const TouchableModel& stage, const TouchSetup& touch, const Contact& contact,
                                           const PoseA& hand, const DeviceSpecs& device,
                                           std::shared_ptr<const PairField>* pairs) {
  if (pairs) pairs->reset();
  if (!stage) return nullptr;
  InteractionInput input = interactionInput(touch, *stage.molecule, stage.spheres, stage.body);
  if (pairs) *pairs = input.pairs;
  if (stage.body) {
    const double lever_A =
        springLever_A(radiusOfGyration_A(*stage.body), stage.workspace.A_per_mm, touch.stiffness_N_per_mm, device);
    input.rotational_stiffness_N_A = lever_A * lever_A;
  }
  std::unique_ptr<Interaction> felt = makeInteraction(input);
  if (felt) leadToContact(*felt, contact, hand);
  return felt;
}

}  // namespace moltact
