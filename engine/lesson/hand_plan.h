// The movements by which a hand carries out a task: the scripted learner follows it (engine/lesson/scripted_learner),
// and each kind of task offers it. A plan may fail, for the molecule's shape is judged only roughly; the next attempt
// then takes other places. Not for the haptic thread. Units: angstrom, second, newton.
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

/// One thing to do. The hand first goes, then waits, then answers.
struct HandAct {
  std::optional<PointA> to = {};  ///< where the HIP goes in a straight line
  double speed_A_per_s = 3.0;
  /// How the hand is turned at the end: evenly on the way there, by the shorter arc. Empty: it is not turned.
  std::optional<Quat> turned_to = {};
  double turn_deg_per_s = 60.0;
  bool placed = false;  ///< it is there at once, as a mouse's hand that hovers over another place
  double wait_s = 0.0;
  /// The scene's atoms move first to this share of the way to its second structure (0 to 1), while the hand stays.
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
  double N_per_A = 1.0;  ///< the spring's force for a HIP so deep under the surface
  PointA hip{};
  int attempt = 0;                 ///< 0 for the first plan of a task; each further one should differ
  const HeldBody* body = nullptr;  ///< what the hand holds; null: the probe
  Quat orientation = kNoRotation;  ///< of the hand
  /// The scene's structures; empty where it has only one.
  std::vector<StructureChoice> structures = {};

  HandShape hand() const { return body ? HandShape(*body, orientation) : HandShape(probe_A); }
};

/// The way of the hand in an act that does not place it: straight and evenly, place and orientation together, in so
/// many ticks.
struct HandWay {
  PoseA from, to;
  std::size_t ticks = 0;  ///< 0: the hand stays

  /// After tick `k`, 1 to `ticks`; the last one is `to` exactly.
  PoseA at(std::size_t k) const;
};
HandWay wayOf(const HandAct& act, const PoseA& from, double tick_s);

/// The atoms of the scene, 0 to n - 1.
std::vector<std::uint32_t> everyAtom(const SphereGrid& spheres);

/// Places of this kind that these atoms alone make and a probe reaches straight from outside, the roomiest first and no
/// two within 0.5 A. `at_most` of them; where `wanted` is given, of those for which it says true.
/// With a body in the hand: where the body, oriented as it is, first meets one of these atoms on a straight way of its
/// middle from outside, the most frontal first; `scp_A` is then the place of its middle. A body has places of
/// Feature::Sphere only.
std::vector<SurfacePlace> openPlaces(const HandPlanInput& view, std::span<const std::uint32_t> atoms, Feature feature,
                                     std::size_t at_most = 40,
                                     const std::function<bool(const SurfacePlace&)>& wanted = {});

/// The place for an attempt: the first, then others in turn. Nothing where there is none.
std::optional<SurfacePlace> placeFor(const HandPlanInput& view, const std::vector<SurfacePlace>& places);

/// How deep under the surface the spring gives so much force.
double depthFor(const HandPlanInput& view, double force_N);

/// Puts the hand before the place, brings it down and `depth_A` under the surface, and waits there.
void comeTo(HandPlan& plan, const SurfacePlace& place, double depth_A, double wait_s);

/// From one place to another over the surface, `depth_A` under it all the way.
void slide(HandPlan& plan, const HandPlanInput& view, const SurfacePlace& from, const SurfacePlace& to, double depth_A,
           double speed_A_per_s = 3.0);

}  // namespace moltact
