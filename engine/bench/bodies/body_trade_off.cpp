#include "engine/bench/bodies/body_trade_off.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "engine/core/quantile.h"

namespace moltact::bench {
namespace {

constexpr int kMaxContinued = 50;  // ticks with a standing hand until the exact body is at rest
constexpr double kConfirmed_A = 1e-9;

struct PoseErrors {
  std::vector<double> position, turn, force, torque, overlap;
};

PoseA asPose(const oracle::BodyOracle::Pose& p) {
  const auto& t = p.turn;
  glm::dmat3 axes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) axes[j][i] = double(t[std::size_t(i)][std::size_t(j)]);
  return {{{double(p.place[0]), double(p.place[1]), double(p.place[2])}}, glm::normalize(glm::quat_cast(axes))};
}

// The spheres that the body can touch on the path.
std::vector<Sphere> nearPath(const SphereGrid& scene, const HeldBody& body, const std::vector<PoseA>& path) {
  constexpr double kMaxLag_A = 8.0;  // at most so far the body stays behind the hand
  Vec3 low(1e300), high(-1e300);
  for (const PoseA& p : path) low = glm::min(low, p.place.A), high = glm::max(high, p.place.A);
  std::vector<Sphere> out;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const Sphere& b = scene[i];
    if (glm::distance(b.centre_A, glm::clamp(b.centre_A, low, high)) <= b.radius_A + body.reach_A + kMaxLag_A)
      out.push_back(b);
  }
  return out;
}

void judge(const BodyTask& task, const BodyTradeOffOptions& options, const std::vector<PoseA>& path,
           std::vector<BodyTradeOff>& points) {
  RightBody right(task.scene, task.body, nearPath(*task.scene, *task.body, path));
  std::vector<std::unique_ptr<Interaction>> felt;
  for (const BodyTradeOff& p : points) felt.push_back(p.method->make(task.scene, task.body));
  right.tick({{task.home}}, false);
  for (const auto& f : felt) f->respond({{task.home}});
  std::vector<PoseErrors> errors(points.size());
  std::size_t judged = 0, unconfirmed = 0, touching = 0;
  double force = 0, torque = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool look = int(k) % options.judge_every == 0;
    const RightBody::Answer is = right.tick(path[k], look);
    touching += is.touching;
    const bool count = look && is.touching && is.known;
    if (look && is.touching) ++(is.known ? judged : unconfirmed);
    if (count) force += glm::length(is.force_N), torque += glm::length(is.torque_NA);
    for (std::size_t m = 0; m < points.size(); ++m) {
      const Response r = felt[m]->respond(path[k]);
      if (!count) continue;
      const PoseA shown = r.shownBody(path[k]);
      PoseErrors& e = errors[m];
      e.position.push_back(glm::distance(shown.place.A, is.pose.place.A));
      e.turn.push_back(glm::length(rotationBetween(is.pose.orientation, shown.orientation)));
      e.force.push_back(glm::distance(r.contact.displacement_A, is.force_N));
      e.torque.push_back(glm::distance(r.torque_A2, is.torque_NA));
      e.overlap.push_back(overlap_A(*task.scene, *task.body, shown));
    }
  }
  for (std::size_t m = 0; m < points.size(); ++m) {
    BodyTradeOff& p = points[m];
    p.judged = judged, p.unconfirmed = unconfirmed;
    p.touching = double(touching) / double(path.size());
    if (judged) p.right_force_N = force / double(judged), p.right_torque_NA = torque / double(judged);
    p.position_A = statisticsOf(std::move(errors[m].position));
    p.turn_rad = statisticsOf(std::move(errors[m].turn));
    p.force_N = statisticsOf(std::move(errors[m].force));
    p.torque_NA = statisticsOf(std::move(errors[m].torque));
    p.overlap_A = statisticsOf(std::move(errors[m].overlap));
  }
}

template <class Spheres>
double deepest_A(const HeldBody& body, const PoseA& at, Spheres&& near) {
  double deepest = 0.0;
  for (const Sphere& b : body.spheres) {
    const Vec3 c = at.place.A + at.orientation * b.centre_A;
    near(c, b.radius_A,
         [&](const Sphere& s) { deepest = std::max(deepest, b.radius_A + s.radius_A - glm::distance(c, s.centre_A)); });
  }
  return deepest;
}

}  // namespace

double overlap_A(const SphereGrid& scene, const HeldBody& body, const PoseA& at) {
  return deepest_A(body, at, [&](const Vec3& c, double radius_A, auto&& look) {
    scene.visitNear(c, radius_A, [&](std::uint32_t, const Sphere& s) { look(s); });
  });
}

double overlap_A(const std::vector<Sphere>& scene, const HeldBody& body, const PoseA& at) {
  return deepest_A(body, at, [&](const Vec3&, double, auto&& look) {
    for (const Sphere& s : scene) look(s);
  });
}

RightBody::RightBody(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body,
                     std::vector<Sphere> near)
    : body_(std::move(body)),
      exact_(std::move(scene), body_),
      oracle_(std::move(near), body_->spheres, exact_.lever_A()) {}

void RightBody::advanceTo(const SphereMotion& motion, double fraction) {
  exact_.advanceTo(fraction);
  oracle_ = oracle::BodyOracle(motion.at(fraction), body_->spheres, exact_.lever_A());
}

RightBody::Answer RightBody::tick(const PoseA& hand, bool judged) {
  using oracle::BodyOracle;
  Response r = exact_.respond(hand);
  for (int k = 0; k < kMaxContinued && !r.at_rest; ++k) r = exact_.respond(hand);
  Answer out{.touching = r.contact.touching(), .pose = r.shownBody(hand)};
  out.force_N = r.contact.displacement_A, out.torque_NA = r.torque_A2;
  if (!judged || !r.at_rest || r.contact.fault != Fault::None) return out;
  const BodyOracle::Pose at = BodyOracle::pose(out.pose), to = BodyOracle::pose(exact_.coupledHand());
  if (!out.touching) {
    out.known = oracle_.minGap_A(at) > -kConfirmed_A;
    return out;
  }
  const auto rest = oracle_.rest(at, to);
  if (!rest) return out;
  out.known = true;
  out.pose = asPose(*rest);
  const auto pull = oracle_.pull(*rest, to);
  for (std::size_t i = 0; i < 3; ++i) {
    out.force_N[int(i)] = -double(pull[i]);
    out.torque_NA[int(i)] = -double(pull[3 + i]) * exact_.lever_A();
  }
  return out;
}

std::vector<double> bodyTickTimes_ns(const BodyTask& task, const std::function<std::unique_ptr<Interaction>()>& make,
                                     const std::vector<PoseA>& path, int runs) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> least(path.size(), 1e12);
  for (int k = 0; k < runs; ++k) {
    const auto felt = make();
    felt->respond({{task.home}});
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto from = Clock::now();
      [[maybe_unused]] const volatile bool touching = felt->respond(path[i]).contact.touching();
      least[i] = std::min(least[i], std::chrono::duration<double, std::nano>(Clock::now() - from).count());
    }
  }
  std::sort(least.begin(), least.end());
  return least;
}

Expected<std::vector<BodyTradeOff>> measureBodies(const BodyTradeOffOptions& options, const OpenMolecule& open,
                                                  const Progress& progress) {
  std::vector<BodyTradeOff> out;
  for (std::size_t k = 0; k < options.bodies.size(); ++k) {
    const auto at = [&](double part) {
      if (progress) progress((double(k) + part) / double(options.bodies.size()), options.bodies[k] + " atoms");
    };
    at(0);
    const auto task = bodyTask(options.bodies[k], open);
    if (!task) return task.problem();
    const std::vector<PoseA> path = pathOf(*task, options.ticks);
    const double loop_ns = distanceLoop_ns();
    std::vector<BodyTradeOff> points;
    for (const BodyMethod* m : options.methods) {
      BodyTradeOff one{task->name, task->body->spheres.size(), task->scene->size(), m};
      const std::vector<double> ns = bodyTickTimes_ns(
          *task, [&] { return m->make(task->scene, task->body); }, path, options.runs);
      one.mean_ns = std::accumulate(ns.begin(), ns.end(), 0.0) / double(ns.size());
      one.p999_ns = percentile(ns, 0.999);
      one.loop_ns = loop_ns;
      points.push_back(std::move(one));
    }
    at(0.3);
    judge(*task, options, path, points);
    std::move(points.begin(), points.end(), std::back_inserter(out));
  }
  if (progress) progress(1, "");
  return out;
}

}  // namespace moltact::bench
