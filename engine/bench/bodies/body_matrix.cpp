#include "engine/bench/bodies/body_matrix.h"

#include <algorithm>
#include <cmath>

#include "engine/bench/bodies/body_trade_off.h"
#include "engine/bench/bodies/path_watch.h"
#include "engine/bench/many_threads.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact::bench {
namespace {

constexpr double kHeldBack_A = 0.5, kFast_A = 1.0;
constexpr int kSettling = 5;            // ticks after a fast one in which errors are not judged
constexpr std::size_t kStanding = 100;  // final ticks

// Moves a scene's spheres back and forth.
class Swelling {
 public:
  explicit Swelling(const BodyScene& scene) : scene_(scene) {}
  /// The motion and its fraction in a tick; null: the spheres stand still.
  const SphereMotion* at(std::size_t tick, double& fraction) {
    if (scene_.swollen.empty()) return nullptr;
    const auto n = std::size_t(scene_.motion_ticks);
    if (tick >= n * std::size_t(scene_.motions)) {
      fraction = 1.0;
      return now_.get();
    }
    const bool back = tick / n % 2;
    if (tick % n == 0) {
      auto next = now_ ? SphereMotion::after(*now_, back ? scene_.spheres : scene_.swollen, scene_.motion_ticks)
                       : SphereMotion::make(scene_.spheres, scene_.swollen, scene_.motion_ticks);
      if (!next) return nullptr;
      before_ = std::move(now_);  // the interactions still use it
      now_ = std::move(*next);
    }
    fraction = double(tick % n + 1) / double(n);
    return now_.get();
  }

 private:
  const BodyScene& scene_;
  std::unique_ptr<const SphereMotion> before_, now_;
};

// Root mean square.
struct Rms {
  double squares = 0;
  std::size_t n = 0;
  void add(double x) { squares += x * x, ++n; }
  double value() const { return n ? std::sqrt(squares / double(n)) : 0; }
};

}  // namespace

BodyResult runBodyScene(const BodyScene& scene, const BodyMethod& method) {
  BodyResult out{.scene = scene.name, .method = &method};
  const auto grid = std::make_shared<const SphereGrid>(scene.spheres);
  const auto felt = method.test(grid, scene.body);
  RightBody right(grid, scene.body, scene.spheres);
  PathWatch way(scene.spheres, scene.body, BodyLimits().overlap_A);
  const bool watched = felt->observe(&way);
  Swelling swelling(scene);
  std::vector<Sphere> spheres = scene.spheres;
  Rms force, torque, position;
  bool behind = false;
  int settling = 0;
  Vec3 low(1e300), high(-1e300), last(0.0);
  for (std::size_t k = 0; k < scene.path.size(); ++k) {
    const PoseA& hand = scene.path[k];
    double fraction = 0, made = 0;
    const SphereMotion* const motion = swelling.at(k, fraction);
    if (motion) {
      felt->interaction().setMotion(motion), right.setMotion(motion);
      felt->interaction().advanceTo(fraction), right.advanceTo(*motion, fraction);
      spheres = motion->at(fraction);
    }
    if (k && glm::distance(hand.place.A, scene.path[k - 1].place.A) > kFast_A) settling = kSettling;
    const Response r = felt->tick(hand, made);
    const RightBody::Answer is = right.tick(hand, true);
    const PoseA shown = r.shownBody(hand);
    ++out.ticks;
    if (!finite(shown.place.A) || !finite(r.contact.displacement_A) || !finite(r.torque_A2)) {
      ++out.broken;
      continue;
    }
    const bool held = r.contact.fault == Fault::None;
    if (held) out.overlap_A = std::max(out.overlap_A, overlap_A(spheres, *scene.body, shown));
    if (!motion) out.energy_NA = std::max(out.energy_NA, made);
    // The right answer is an exact body's own, so that one is also judged by the places along its steps.
    if (watched) out.tunnelled += held && way.tunnelled(shown, motion);
    const bool free_behind = held && !r.contact.touching() && is.touching &&
                             glm::distance(is.pose.place.A, hand.place.A) > kHeldBack_A &&
                             overlap_A(spheres, *scene.body, hand) == 0;
    out.tunnelled += free_behind && !behind;
    behind = free_behind;
    if (is.touching || r.contact.touching()) {
      ++out.contact_ticks;
      if (is.known && settling == 0) {
        force.add(glm::distance(r.contact.displacement_A, is.force_N));
        torque.add(glm::distance(r.torque_A2, is.torque_NA));
        position.add(glm::distance(shown.place.A, is.pose.place.A));
      }
    }
    settling = std::max(0, settling - 1);
    if (k + kStanding >= scene.path.size()) {
      low = glm::min(low, r.contact.displacement_A), high = glm::max(high, r.contact.displacement_A);
      out.unrested += !r.at_rest || glm::distance(last, shown.place.A) > BodyLimits().rest_A;
    }
    last = shown.place.A;
  }
  out.force_N = force.value(), out.torque_NA = torque.value(), out.position_A = position.value();
  out.judged = force.n;
  out.jitter_N = glm::length(glm::max(Vec3(0.0), high - low));
  return out;
}

std::string failuresOf(const BodyResult& r, const BodyLimits& limits) {
  std::string out;
  if (r.overlap_A > limits.overlap_A) out += 'O';
  if (r.tunnelled) out += 'T';
  if (r.energy_NA > limits.energy_NA) out += 'E';
  if (r.unrested) out += 'U';
  if (r.force_N > limits.force_N) out += 'F';
  if (r.jitter_N > limits.jitter_N) out += 'J';
  if (r.broken) out += 'N';
  return out;
}

std::vector<BodyResult> measureBodyMatrix(const BodyMatrixOptions& options, const Progress& progress) {
  std::vector<std::vector<BodyScene>> drawn;
  for (std::size_t draw = 0; draw < options.draws; ++draw) drawn.push_back(drawnBodyScenes(options.seed, draw));
  if (drawn.empty()) return {};
  const std::size_t scenes = drawn.front().size(), methods = options.methods.size();
  std::vector<BodyResult> out(scenes * methods * options.draws);
  inScenesAndDraws(
      scenes, methods, options.draws,
      [&](std::size_t scene, std::size_t method, std::size_t draw, std::size_t k) {
        out[k] = runBodyScene(drawn[draw][scene], *options.methods[method]);
        out[k].draw = draw;
      },
      [&](double share, std::size_t scene) {
        if (progress) progress(share, drawn.front()[scene].name);
      });
  return out;
}

}  // namespace moltact::bench
