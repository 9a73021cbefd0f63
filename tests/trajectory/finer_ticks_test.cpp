// A hand that slides on a protein which a trajectory moves. Oracle: the same hand and the same frames in ticks eight times
// as fine.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_store.h"

using namespace moltact;

namespace {

constexpr int kFrames = 12, kPiece_ticks = 33, kFiner = 8;
constexpr double kBreath = 0.03;  // of the distance from the middle
constexpr double kFrames_per_s = 6.0, kTick_seconds = 0.001;
constexpr double kSpring_N_per_A = 0.1;  // of the hand: 0.5 N/mm, 5 A per mm
constexpr double kHand_A_per_tick = 0.02;

// 1HPV, and a trajectory in which it breathes about its middle.
std::unique_ptr<FrameStore> breathing() {
  std::ifstream in(MOLTACT_SOURCE_DIR "/molecules/1hpv.pdb");
  std::string structure, models;
  std::vector<std::string> atoms;
  std::vector<Vec3> places;
  Vec3 middle(0.0);
  for (std::string line; std::getline(in, line);) {
    structure += line + '\n';
    if (!line.starts_with("ATOM") && !line.starts_with("HETATM")) continue;
    atoms.push_back(line);
    places.emplace_back(std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8)));
    middle += places.back();
  }
  middle /= double(places.size());
  for (int f = 0; f < kFrames; ++f) {
    models += "MODEL\n";
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const Vec3 at = middle + (places[i] - middle) * (1.0 - kBreath * std::sin(kTwoPi * f / kFrames));
      char text[40];
      std::snprintf(text, sizeof text, "%8.3f%8.3f%8.3f", at.x, at.y, at.z);
      models += std::string(atoms[i]).replace(30, 24, text) + '\n';
    }
    models += "ENDMDL\n";
  }
  auto molecule = readMoleculeBytes(structure, "1hpv.pdb");
  REQUIRE(molecule);
  auto file = openTrajectoryBytes(models, "breath.pdb");
  REQUIRE(file);
  (*file)->findMore(1 << 30);
  REQUIRE((*file)->frames() == kFrames);
  auto placer = FramePlacer::make(std::make_shared<const Molecule>(*std::move(molecule)), (*file)->atoms(),
                                  "breath.pdb", {false, {}});
  REQUIRE(placer);
  return std::make_unique<FrameStore>(*std::move(file), *std::move(placer));
}

}  // namespace

TEST_CASE(
    "a probe that is led over a protein which breathes by 3 %, 6 frames a second, pressed 1 A deep: in each tick of 1 "
    "ms "
    "the SCP of the exact tracker is within 1e-9 A, and the force within 1e-10 N, of where ticks of 1/8 ms leave them "
    "for "
    "the same hand and frames; a tracker that is one tick late is farther off by a factor of 1e5") {
  const auto store = breathing();
  const std::vector<Sphere> rest = store->placer().molecule().spheres.copy();
  const auto spheresAt = [&](double frame) {
    const auto low = std::size_t(std::floor(frame)) % kFrames, high = (low + 1) % kFrames;
    const auto from = store->at(low), to = store->at(high);
    REQUIRE(from);
    REQUIRE(to);
    const std::vector<Vec3> places = between(**from, **to, frame - std::floor(frame));
    std::vector<Sphere> out = rest;
    for (std::size_t i = 0; i < out.size(); ++i) out[i].centre_A = places[i];
    return out;
  };
  const std::vector<Sphere> first = spheresAt(0.0);
  const auto grid = std::make_shared<const SphereGrid>(first);
  ExactTracker coarse(grid, kWaterProbe_A), fine(grid, kWaterProbe_A), late(grid, kWaterProbe_A);
  Vec3 middle(0.0);
  for (const Sphere& s : first) middle += s.centre_A / double(first.size());
  Vec3 hand = middle + Vec3(0, 0, 60);
  for (ExactTracker* tracker : {&coarse, &fine, &late}) tracker->step({hand});
  std::unique_ptr<const SphereMotion> motion, before;
  double frame = 0.0, worst_A = 0.0, late_A = 0.0, step_A = 0.0;
  int judged = 0;
  Contact c, last;
  for (int tick = 0; tick < 12'000; ++tick) {
    const int in_piece = tick % kPiece_ticks;
    if (in_piece == 0) {
      frame += kFrames_per_s * kPiece_ticks * kTick_seconds;
      const std::vector<Sphere> to = spheresAt(frame);
      auto next = motion ? SphereMotion::after(*motion, to, kPiece_ticks) : SphereMotion::make(first, to, kPiece_ticks);
      REQUIRE(next);
      before = std::exchange(motion, *std::move(next));
      for (ExactTracker* tracker : {&coarse, &fine, &late}) REQUIRE(tracker->setMotion(motion.get()));
    }
    // The hand is drawn to 1 A below the surface at the SCP, and on around the protein by a spiral.
    const Vec3 at = c.touching() ? c.scp.A : hand, outward = glm::normalize(at - middle),
               axis = glm::normalize(Vec3(std::sin(2e-4 * tick), 1.0, std::cos(3e-4 * tick))),
               aim = (c.touching() ? at - outward : middle) + 1.5 * glm::cross(axis, outward);
    const Vec3 next = hand + std::min(1.0, kHand_A_per_tick / std::max(1e-9, glm::distance(aim, hand))) * (aim - hand);
    coarse.advanceTo(double(in_piece + 1) / kPiece_ticks);
    c = coarse.step({next});
    late.advanceTo(double(in_piece) / kPiece_ticks);
    const Contact l = late.step({next});
    Contact f;
    for (int k = 1; k <= kFiner; ++k) {
      const double share = double(k) / kFiner;
      fine.advanceTo((in_piece + share) / kPiece_ticks);
      f = fine.step({hand + (next - hand) * share});
    }
    hand = next;
    REQUIRE(c.touching() == f.touching());
    if (c.touching()) {
      ++judged;
      worst_A = std::max(worst_A, glm::distance(c.displacement_A, f.displacement_A));
      if (l.touching()) late_A = std::max(late_A, glm::distance(c.displacement_A, l.displacement_A));
      if (last.touching()) step_A = std::max(step_A, glm::distance(c.displacement_A, last.displacement_A));
    }
    last = c;
  }
  MESSAGE(judged, " ticks in contact, at most ", worst_A, " A (", kSpring_N_per_A * worst_A,
          " N) apart; a tracker one tick late up to ", late_A, " A; greatest step of the spring ", step_A, " A");
  CHECK(judged > 8000);
  CHECK(worst_A < 1e-9);
  CHECK(kSpring_N_per_A * worst_A < 1e-10);
  CHECK(late_A > 1e-4);
  // The hand moves by 0.02 A in a tick, the fastest atom by 0.003 A.
  CHECK(step_A < 0.03);
}
