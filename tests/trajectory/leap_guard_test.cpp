// A molecule that leaves the periodic cell on one side and comes back on the other. Oracles: a hand on the straight way
// between the two places, which must feel nothing, and closed forms of the mean over frames.
#include "engine/trajectory/leap_guard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_store.h"

using namespace moltact;

namespace {

constexpr double kCell_A = 20.0, kProbe_A = 1.4, kIon_A = 1.5;

// An atom at rest far below, and an ion.
std::vector<Sphere> withIon(double x_A) { return {{Vec3(0, 0, -30), 1.7}, {Vec3(x_A, 0, 0), kIon_A}}; }

// A probe beside pieces of motion, each of which the guard prepares.
struct Played {
  std::vector<std::uint32_t> part_of{0, 1};
  LeapGuard guard{part_of, 2};
  ExactTracker tracker;
  std::unique_ptr<const SphereMotion> motion;
  Vec3 hand;
  int ticks;                              // of a piece
  double greatest_A = 0.0, last_A = 0.0;  // displacement of the SCP from the hand: so far, and in the last tick
  bool touching = false;
  std::vector<Sphere> now;

  Played(double x_A, const Vec3& at, int piece_ticks = 33)
      : tracker(std::make_shared<SphereGrid>(withIon(x_A)), kProbe_A), hand(at), ticks(piece_ticks) {
    now = withIon(x_A);
    guard.place(now);
    tracker.step({Vec3(at.x, at.y, 40)});
    tracker.step({at});
  }
  void piece(std::vector<Sphere> to, bool guarded = true) {
    const auto occupied = [&](const Sphere& s, double room_A) {
      return glm::distance(hand, s.centre_A) < s.radius_A + kProbe_A + room_A;
    };
    if (guarded) REQUIRE(guard.step(to, 0.5 * kCell_A, 1e-3 * ticks, occupied));
    auto next = motion ? SphereMotion::after(*motion, to, ticks) : SphereMotion::make(now, to, ticks);
    REQUIRE(next);
    const auto before = std::move(motion);
    motion = *std::move(next);
    REQUIRE(tracker.setMotion(motion.get()));
    for (int tick = 1; tick <= ticks; ++tick) {
      tracker.advanceTo(double(tick) / ticks);
      const Contact c = tracker.step({hand});
      touching = c.touching();
      last_A = glm::length(c.displacement_A);
      greatest_A = std::max(greatest_A, last_A);
    }
    now = to;
  }
};

}  // namespace

TEST_CASE(
    "an ion that leaps by 19 A passes a hand on its straight way without a touch in 33 ms; a straight motion would "
    "push "
    "the hand by over 1 A; back at full size after 5 pieces of growth") {
  const Vec3 hand(0, 0, 1);
  Played straight(-9.5, hand);
  straight.piece(withIon(9.5), false);
  CHECK(straight.greatest_A > 1.0);

  Played played(-9.5, hand);
  int pieces = 0;
  do {
    played.piece(withIon(9.5));
    ++pieces;
    CHECK(played.greatest_A == 0.0);
  } while (played.guard.unsettled() && pieces < 50);
  // One to shrink, one to go, five to grow by 0.33 A each.
  CHECK(pieces == 2 + 5);
  CHECK(played.now[1].radius_A == kIon_A);
  CHECK(played.now[1].centre_A.x == 9.5);
  // It can be touched there: the hand sinks in from above.
  played.hand = Vec3(9.5, 0, 2.5);
  played.piece(withIon(9.5));
  CHECK(played.last_A == doctest::Approx(kIon_A + kProbe_A - 2.5).epsilon(1e-6));
}

TEST_CASE(
    "an ion that comes back grows by 10 A/s whatever the length of a piece: in pieces of 20, 33 and 100 ms it has its "
    "1.5 A after 150 ms and what is left of that piece; a room of 120 A/s in a piece and a frame stays free") {
  for (const int ticks : {20, 33, 100}) {
    CAPTURE(ticks);
    Played played(-9.5, Vec3(0, 0, 25), ticks);
    played.piece(withIon(9.5));  // shrinks
    played.piece(withIon(9.5));  // goes
    CHECK(played.now[1].radius_A == 0.0);
    int pieces = 0;
    while (played.guard.unsettled() && pieces < 50) {
      const double before_A = played.now[1].radius_A;
      played.piece(withIon(9.5));
      ++pieces;
      const double grown_A = played.now[1].radius_A - before_A, whole_A = 0.01 * ticks;
      CHECK(grown_A == doctest::Approx(std::min(whole_A, kIon_A - before_A)));
    }
    CHECK(pieces == (150 + ticks - 1) / ticks);
    // The room: (20, 33, 100 ms + 17 ms) of 120 A/s beyond the touch.
    const double room_A = 0.12 * (ticks + 17), touch_A = kIon_A + kProbe_A;
    for (const double beyond_A : {-0.01, 0.01}) {
      Played near(-9.5, Vec3(9.5, 0, touch_A + room_A + beyond_A), ticks);
      for (int k = 0; k < 3; ++k) near.piece(withIon(9.5));
      CHECK((near.now[1].radius_A > 0.0) == (beyond_A > 0.0));
    }
  }
}

TEST_CASE(
    "a way of 1 s to a far frame shows no ion before its end: the hand might come there meanwhile; then it grows in "
    "pieces of 33 ms") {
  Played played(-9.5, Vec3(0, 0, 12));
  played.piece(withIon(9.5));
  played.ticks = 990;
  played.piece(withIon(9.5));
  CHECK(played.now[1].radius_A == 0.0);
  played.ticks = 33;
  played.piece(withIon(9.5));
  CHECK(played.now[1].radius_A == 0.0);
  played.piece(withIon(9.5));
  CHECK(played.now[1].radius_A == doctest::Approx(0.33));
}

TEST_CASE(
    "an ion does not appear where the hand is, at any of 30 pieces; it grows once the hand has gone, and steps below "
    "half the cell's edge are left as they are") {
  Played played(-9.5, Vec3(9.5, 0, 1));
  for (int k = 0; k < 30; ++k) played.piece(withIon(9.5 - 0.01 * k));
  CHECK(played.greatest_A == 0.0);
  CHECK(played.now[1].radius_A == 0.0);
  CHECK(played.guard.unsettled());
  played.hand = Vec3(0, 0, 12);
  for (int k = 0; k < 5; ++k) played.piece(withIon(9.0));
  CHECK(played.now[1].radius_A == kIon_A);
  CHECK_FALSE(played.guard.unsettled());
  CHECK(played.greatest_A == 0.0);
  for (const double x : {0.5, -8.0, 1.9}) {
    played.piece(withIon(x));
    CHECK(played.now[1].centre_A.x == x);
    CHECK(played.now[1].radius_A == kIon_A);
  }
}

TEST_CASE("a hand that rests on an ion which leaps away sinks to where it is: its displacement only falls") {
  Played played(-9.5, Vec3(-9.5, 0, 2.0));
  played.piece(withIon(-9.5));
  REQUIRE(played.touching);
  const double rests_A = kIon_A + kProbe_A - 2.0;
  CHECK(played.greatest_A == doctest::Approx(rests_A).epsilon(1e-6));
  for (int k = 0; k < 10; ++k) played.piece(withIon(9.5));
  CHECK_FALSE(played.touching);
  CHECK(played.greatest_A <= rests_A + 1e-9);
}

TEST_CASE(
    "a sphere that is gone is not felt in its motion only: what comes after feels it again, but not an untouchable "
    "one") {
  const std::vector<Sphere> here{{Vec3(0.0), 1.7}, {Vec3(6, 0, 0), 1.7}, {Vec3(12, 0, 0), 1.7}};
  std::vector<Sphere> away = here;
  away[0].radius_A = away[2].radius_A = 0.0;
  const std::vector<std::uint32_t> untouchable{2};
  auto shrinks = SphereMotion::make(here, away, 10, untouchable);
  REQUIRE(shrinks);
  auto gone = SphereMotion::after(**shrinks, away, 10);
  REQUIRE(gone);
  auto grows = SphereMotion::after(**gone, here, 10);
  REQUIRE(grows);
  using Indices = std::vector<std::uint32_t>;
  CHECK((*shrinks)->sweptSpheres().untouchable() == Indices{2});
  CHECK((*gone)->sweptSpheres().untouchable() == Indices{0, 2});
  CHECK((*grows)->sweptSpheres().untouchable() == Indices{2});
  CHECK_FALSE((*gone)->continues(**shrinks));
  CHECK_FALSE((*grows)->continues(**gone));
  CHECK((*gone)->maxMotion_A() == 0.0);
}

TEST_CASE(
    "smoothed over two frames on either side, an ion that leaps after frame 4 is the mean of the frames on its own "
    "side") {
  // Two bonded carbons at rest, and an ion that moves on by 2.4 A from frame to frame in a cell of 20 A.
  std::string pdb, gro;
  char line[120];
  for (int atom = 0; atom < 2; ++atom) {
    std::snprintf(line, sizeof line, "HETATM%5d  C%d  LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n", atom + 1,
                  atom + 1, 1.5 * atom, 0.0, 0.0);
    pdb += line;
  }
  std::snprintf(line, sizeof line, "HETATM%5d NA    NA A   2    %8.3f%8.3f%8.3f  1.00  0.00          NA\n", 3, 0.0, 6.0,
                0.0);
  pdb += line + std::string("END\n");
  for (int frame = 0; frame < 8; ++frame) {
    gro += "f\n    3\n";
    for (int atom = 0; atom < 3; ++atom) {
      std::snprintf(line, sizeof line, "%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n", atom < 2 ? 1 : 2, atom < 2 ? "LIG" : "NA",
                    atom == 0   ? "C1"
                    : atom == 1 ? "C2"
                                : "NA",
                    atom + 1, atom < 2 ? 0.15 * atom : 0.24 * frame, atom < 2 ? 0.0 : 0.6, 0.0);
      gro += line;
    }
    gro += "   2.0   2.0   2.0\n";
  }
  auto molecule = readMoleculeBytes(pdb, "a.pdb");
  REQUIRE(molecule);
  const auto shared = std::make_shared<const Molecule>(*std::move(molecule));
  auto file = openTrajectoryBytes(gro, "a.gro");
  REQUIRE(file);
  (*file)->findMore(1 << 20);
  REQUIRE((*file)->frames() == 8);
  auto placer = FramePlacer::make(shared, 3, "a.gro", {false, {}});
  REQUIRE(placer);
  REQUIRE(placer->parts() == 2);
  FrameStore store(*std::move(file), *std::move(placer));
  const auto x = [&](std::size_t frame, std::size_t smoothing) {
    auto at = store.at(frame, smoothing);
    REQUIRE(at);
    return (**at)[2].x;
  };
  CHECK(x(4, 0) == doctest::Approx(9.6));
  CHECK(x(5, 0) == doctest::Approx(12.0 - kCell_A));
  CHECK(store.leapLimit_A(4) == doctest::Approx(10.0));
  CHECK(x(4, 2) == doctest::Approx((4.8 + 7.2 + 9.6) / 3.0));
  CHECK(x(5, 2) == doctest::Approx((12.0 + 14.4 + 16.8) / 3.0 - kCell_A));
  CHECK(x(2, 2) == doctest::Approx(4.8));
  const auto four = *store.at(4), five = *store.at(5);
  const std::vector<bool> leaps =
      leapsBetween(*four, *five, store.placer().partOf(), store.placer().parts(), store.leapLimit_A(4));
  CHECK(leaps[store.placer().partOf()[2]]);
  CHECK_FALSE(leaps[store.placer().partOf()[0]]);
}
