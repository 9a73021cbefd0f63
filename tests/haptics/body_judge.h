// Judges the ticks of an exact body with the oracle over all pairs: overlap, balance of forces, second order, energy.
// Longer runs by the environment: MOLTACT_BODY_TICKS.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "engine/bench/bodies/body_oracle.h"
#include "engine/haptics/body/exact_body.h"
#include "tests/haptics/walk.h"

namespace moltact::test {

inline int ticksPerScene() {
  const char* const set = std::getenv("MOLTACT_BODY_TICKS");
  return set ? std::max(1, std::atoi(set)) : 300;
}

/// True if the environment asks for long runs.
inline bool longRun() { return std::getenv("MOLTACT_BODY_TICKS") != nullptr; }

struct Verdict {
  int ticks = 0, pressed = 0, unrested = 0, lower = 0, judged = 0;
  long steps = 0;
  double meanSteps() const { return ticks ? double(steps) / ticks : 0.0; }
  long double least_gap_A = 1.0L, residual = 0.0L, energy_gained_A2 = 0.0L, off_force = 0.0L, off_hand = 0.0L;
};

/// Judges each tick, or one of `every`; of those at rest, one of `second_order_every` for lower neighbours too. The path
/// begins where the body is free.
inline Verdict judge(const std::vector<Sphere>& spheres, const std::shared_ptr<const HeldBody>& body,
                     const std::vector<PoseA>& path, int second_order_every, int every = 1) {
  using oracle::BodyOracle;
  ExactBody felt(makeScene(spheres), body);
  const BodyOracle oracle(spheres, body->spheres, felt.lever_A());
  std::mt19937_64 random(5);
  Verdict out;
  std::optional<PoseA> before;
  bool slipped = false;
  for (const PoseA& hand : path) {
    const Response r = felt.respond(hand);
    if (r.contact.fault != Fault::None) {
      before.reset();
      continue;
    }
    REQUIRE(r.body_pose);
    const BodyOracle::Pose at = BodyOracle::pose(*r.body_pose), to = BodyOracle::pose(felt.coupledHand());
    // The springs pull to the hand itself until the body is 2 rad behind it.
    const BodyOracle::Pose led = BodyOracle::pose(hand);
    if (before) {
      const auto behind = BodyOracle::rotationVector(BodyOracle::pose(*before), led);
      slipped = slipped || std::hypot(behind[0], behind[1], behind[2]) > SlipCoupling::kSlip_rad - 1e-9;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      out.off_hand = std::max(out.off_hand, std::abs(to.place[i] - led.place[i]));
      for (std::size_t j = 0; j < 3 && !slipped; ++j)
        out.off_hand = std::max(out.off_hand, std::abs(to.turn[i][j] - led.turn[i][j]));
    }
    ++out.ticks;
    out.pressed += r.contact.touching();
    out.unrested += !r.at_rest;
    out.steps += felt.steps();
    const std::optional<PoseA> was = std::exchange(before, r.body_pose);
    if (out.ticks % every != 0) continue;
    out.least_gap_A = std::min(out.least_gap_A, oracle.minGap_A(at));
    if (was)
      out.energy_gained_A2 =
          std::max(out.energy_gained_A2, oracle.energy_A2(at, to) - oracle.energy_A2(BodyOracle::pose(*was), to));
    if (!r.at_rest) continue;
    out.residual = std::max(out.residual, oracle.residual(at, to));
    ++out.judged;
    if (out.judged % second_order_every == 0) out.lower += oracle.hasLowerNeighbour(at, to, 16, random);
    if (!r.contact.touching()) continue;
    const auto pull = oracle.pull(at, to);
    for (std::size_t i = 0; i < 3; ++i) {
      out.off_force = std::max(out.off_force, std::abs(pull[i] + r.contact.displacement_A[int(i)]));
      out.off_force = std::max(out.off_force, std::abs(pull[3 + i] * felt.lever_A() + r.torque_A2[int(i)]));
    }
  }
  return out;
}

inline void check(const Verdict& v) {
  CHECK(double(v.least_gap_A) > -1e-9);
  CHECK(double(v.residual) < 1e-6);
  CHECK(double(v.energy_gained_A2) < 1e-9);
  CHECK(double(v.off_force) < 1e-9);
  CHECK(double(v.off_hand) < 1e-9);
  CHECK(v.lower == 0);
}

}  // namespace moltact::test
