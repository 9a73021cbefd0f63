// Plans by which a scripted hand carries out a task. Each kind of task makes them; the scripted learner follows them
// (engine/lesson/scripted_learner). A plan may fail, because the molecule's shape is judged only roughly; the next
// attempt then uses other places. Not for the haptic thread. Units: angstrom, second, newton.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/task_answer.h"

namespace moltact {

/// One act: the hand first moves, then waits, then answers.
struct HandAct {
  std::optional<PointA> to = {};  ///< target of the HIP, in a straight line
  double speed_A_per_s = 3.0;
  /// The orientation at the end, by the shorter arc at constant speed. Empty: unchanged.
  std::optional<Quat> turned_to = {};
  double turn_deg_per_s = 60.0;
  bool placed = false;  ///< the hand jumps to `to` in one tick, as a mouse pointer does
  double wait_s = 0.0;
  /// Before the hand moves, the atoms move to this fraction between the scene's two structures (0: first, 1: second).
  std::optional<double> share = {};
  std::string method = {};  ///< a haptic method to be chosen before anything else; empty: none
  std::optional<TaskAnswer> answer = {};
};

using HandPlan = std::vector<HandAct>;

/// A structure to which the scene's atoms can be moved (its key `then`).
struct StructureChoice {
  double share = 0.0;  ///< for HandAct
  const SphereGrid* spheres = nullptr;
};

/// The input from which a plan is made.
struct HandPlanInput {
  const SphereGrid& spheres;
  double probe_A = kWaterProbe_A;
  double N_per_A = 1.0;  ///< the spring's force per depth of the HIP under the surface
  PointA hip{};
  int attempt = 0;                 ///< 0 for the first plan of a task; each further one should differ
  const HeldBody* body = nullptr;  ///< what the hand holds; null: a probe
  Quat orientation = kNoRotation;  ///< of the hand
  /// The scene's structures; empty where it has only one.
  std::vector<StructureChoice> structures = {};

  HandShape hand() const { return body ? HandShape(*body, orientation) : HandShape(probe_A); }
};

/// The path of the hand in an act without a jump: position and orientation change together at constant speed, in this
/// number of ticks.
struct HandWay {
  PoseA from, to;
  std::size_t ticks = 0;  ///< 0: the hand does not move

  /// The pose after tick `k`, 1 to `ticks`; the last one is exactly `to`.
  PoseA at(std::size_t k) const;
};
HandWay wayOf(const HandAct& act, const PoseA& from, double tick_s);

/// The atoms of the scene, 0 to n - 1.
std::vector<std::uint32_t> everyAtom(const SphereGrid& spheres);

/// Returns up to `max_count` places of this kind, at least 0.5 A apart. Only the given atoms form them, and a probe
/// reaches each from outside in a straight line. Places with more clearance come first. With `wanted`, only places for
/// which it returns true. With a body in the hand: places where the body, in its present orientation, first meets one
/// of these atoms on a straight path from outside, the most frontal first; `scp_A` is then the position of its middle.
/// A body has only places of Feature::Sphere.
std::vector<SurfacePlace> openPlaces(const HandPlanInput& view, std::span<const std::uint32_t> atoms, Feature feature,
                                     std::size_t max_count = 40,
                                     const std::function<bool(const SurfacePlace&)>& wanted = {});

/// The place for an attempt: the first one, then the others in turn. Empty if there is none.
std::optional<SurfacePlace> placeFor(const HandPlanInput& view, const std::vector<SurfacePlace>& places);

/// The depth of the HIP under the surface (unit: angstrom) at which the spring exerts this force.
double depthFor(const HandPlanInput& view, double force_N);

/// Appends acts that put the hand before the place, move it to `depth_A` under the surface, and wait there.
void comeTo(HandPlan& plan, const SurfacePlace& place, double depth_A, double wait_s);

/// Appends acts that lead the hand over the surface from one place to another, at `depth_A` under it.
void slide(HandPlan& plan, const HandPlanInput& view, const SurfacePlace& from, const SurfacePlace& to, double depth_A,
           double speed_A_per_s = 3.0);

}  // namespace moltact
