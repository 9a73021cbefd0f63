// Speed against accuracy of methods for a rigid body: time per tick, and errors of position, orientation, force, torque and
// overlap, for bodies of 1 to 1069 atoms. Units: angstrom, radian, newton (for a spring of 1 N per A), nanosecond.
//
// The right answer of a tick is the rest of an exact body that follows the same path and is led to rest in every tick
// (RightBody). The brute-force oracle (body_oracle.h: long double, all pairs) verifies each judged one: no overlap, balance
// of force and torque. From it the oracle's own Newton's method finds the rest to 1e-15 A. Ticks that it does not confirm
// are not judged.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/bench/bodies/body_oracle.h"
#include "engine/bench/bodies/body_tasks.h"
#include "engine/bench/methods/body_methods.h"
#include "engine/bench/report_table.h"
#include "engine/bench/statistics.h"
#include "engine/bench/timing.h"
#include "engine/haptics/body/exact_body.h"

namespace moltact::bench {

/// The right answer per tick; see above.
class RightBody {
 public:
  struct Answer {
    bool known = false;     ///< the oracle has confirmed the rest
    bool touching = false;  ///< else the pose is the hand's
    PoseA pose;
    Vec3 force_N{0.0}, torque_NA{0.0};  ///< of springs of 1 N per A and lever^2 N A
  };
  /// `near`: the spheres of the scene that the oracle examines.
  RightBody(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body, std::vector<Sphere> near);

  /// Performs one tick. Only with `judged` does the oracle look.
  Answer tick(const PoseA& hand, bool judged);
  const ExactBody& exact() const { return exact_; }
  void setMotion(const SphereMotion* motion) { exact_.setMotion(motion); }
  /// Moves the spheres; the oracle then examines those of the motion.
  void advanceTo(const SphereMotion& motion, double fraction);

 private:
  std::shared_ptr<const HeldBody> body_;
  ExactBody exact_;
  oracle::BodyOracle oracle_;
};

/// Depth of the deepest overlap of a body at a pose (unit: angstrom); 0 where it is free.
double overlap_A(const std::vector<Sphere>& scene, const HeldBody& body, const PoseA& at);
double overlap_A(const SphereGrid& scene, const HeldBody& body, const PoseA& at);

struct BodyTradeOff {
  std::string body;
  std::size_t atoms = 0, scene_spheres = 0;
  const BodyMethod* method = nullptr;
  double mean_ns = 0, p999_ns = 0, loop_ns = 1;  ///< loop_ns: distanceLoop_ns() of the same run
  double touching = 0;                           ///< fraction of ticks
  std::size_t judged = 0, unconfirmed = 0;       ///< ticks in contact; those of which the oracle confirmed no rest
  Statistics position_A{}, turn_rad{}, force_N{}, torque_NA{}, overlap_A{};
  double right_force_N = 0, right_torque_NA = 0;  ///< mean of the right answer
  double meanLoops() const { return mean_ns / loop_ns; }
  double p999Loops() const { return p999_ns / loop_ns; }
};

struct BodyTradeOffOptions {
  std::vector<const BodyMethod*> methods;
  std::vector<std::string> bodies{kBodyChartTasks.begin(), kBodyChartTasks.end()};
  int ticks = 4000;
  int judge_every = 4;
  int runs = 3;  ///< of the timing; each tick's time is the minimum
};

/// Measures the methods on all bodies, ordered by body and method. Fails if a molecule cannot be opened.
Expected<std::vector<BodyTradeOff>> measureBodies(const BodyTradeOffOptions& options, const OpenMolecule& open,
                                                  const Progress& progress);

/// Times of the ticks of an interaction (unit: nanosecond, ascending): of each tick the minimum of `runs`, each with a new
/// interaction.
std::vector<double> bodyTickTimes_ns(const BodyTask& task, const std::function<std::unique_ptr<Interaction>()>& make,
                                     const std::vector<PoseA>& path, int runs);

ReportTable bodyTradeOffTable(const std::vector<BodyTradeOff>& points, const BodyTradeOffOptions& options);
/// Markdown sentences that state the table's results.
std::string bodyTradeOffSentences(const std::vector<BodyTradeOff>& points);
/// Five panels of errors against time, and one of time against the number of atoms, as SVG.
std::string bodyTradeOffChart(const std::vector<BodyTradeOff>& points);

}  // namespace moltact::bench
