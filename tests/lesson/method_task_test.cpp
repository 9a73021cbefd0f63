// The kinds of tasks about haptic methods, with synthetic samples at 1 kHz.
#include <doctest/doctest.h>

#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

Contact at(Vec3 scp_A) {
  Contact c;
  c.scp.A = scp_A;
  c.atoms[0] = 0;
  c.feature = Feature::Sphere;
  stretchToScp(c, {});  // from the hand at the origin
  return c;
}
Contact nowhere() { return {}; }

/// Feeds ticks of one state with the hand at the origin.
struct MethodHand {
  Task& task;
  double time_s = 0.0;
  void ticks(int n, const Contact& contact, const Contact& exact, std::string_view method = "paper") {
    TouchSample s;
    s.contact = contact;
    s.exact = exact;
    s.method = method;
    for (; n > 0; --n) {
      s.time_s = time_s += 0.001;
      task.feed(s);
    }
  }
};

}  // namespace

TEST_CASE("compare wants 1 s of touch with each method, in any order, and says which to choose next") {
  auto t = task("compare", {{"compare", "mesh80, exact"}, {"for", "1 s"}});
  MethodHand hand{*t};
  hand.ticks(1, nowhere(), nowhere(), "grid04");
  CHECK(t->sentence() == "Now choose Mesh 80 in the panel Methods.");
  hand.ticks(2000, at({0, 0, 1}), at({0, 0, 1}), "grid04");
  CHECK(t->progress() == 0.0);
  hand.ticks(1010, at({0, 0, 1}), at({0, 0, 1}), "exact");
  CHECK(t->progress() == doctest::Approx(0.5).epsilon(0.01));
  CHECK(t->sentence() == "Now choose Mesh 80 in the panel Methods.");
  hand.ticks(500, nowhere(), nowhere(), "mesh80");
  CHECK(t->progress() == doctest::Approx(0.5).epsilon(0.01));
  CHECK(t->sentence() == "Touch the surface with Mesh 80.");
  hand.ticks(500, at({0, 0, 1}), at({0, 0, 1}), "mesh80");
  CHECK_FALSE(t->done());
  hand.ticks(510, at({0, 0, 1}), at({0, 0, 1}), "mesh80");
  CHECK(t->done());
}

TEST_CASE("compare does not know a method that there is not") {
  const TaskKind* kind = findTaskKind("compare");
  REQUIRE(kind);
  CHECK_FALSE(parseValue(kind->keys[0], "mesh81"));
}

TEST_CASE("meet lost is done after 0.1 s without contact where the exact method holds, and not without its contact") {
  auto t = task("meet", {{"meet", "lost"}});
  MethodHand hand{*t};
  hand.ticks(300, nowhere(), nowhere());
  hand.ticks(300, at({0, 0, 1}), at({0, 0, 1}));
  hand.ticks(90, nowhere(), at({0, 0, 1}));
  hand.ticks(5, at({0, 0, 1}), at({0, 0, 1}));
  CHECK_FALSE(t->done());
  hand.ticks(110, nowhere(), at({0, 0, 1}));
  CHECK(t->done());
}

TEST_CASE("meet wrong-side is done when the force points against the exact one, not at 80 degrees from it") {
  auto t = task("meet", {{"meet", "wrong-side"}});
  MethodHand hand{*t};
  hand.ticks(300, at({0.985, 0, 0.174}), at({0, 0, 1}));
  CHECK_FALSE(t->done());
  hand.ticks(20, at({0, 0.2, -1}), at({0, 0, 1}));
  CHECK(t->done());
}

TEST_CASE("meet jump wants 5 degrees in a tick while the exact force keeps its direction") {
  auto t = task("meet", {{"meet", "jump"}});
  MethodHand hand{*t};
  hand.ticks(10, at({0, 0, 1}), at({0, 0, 1}));
  hand.ticks(10, at({0.05, 0, 1}), at({0, 0, 1}));  // 2.9 degrees
  CHECK_FALSE(t->done());
  hand.ticks(10, at({0.25, 0, 1}), at({0.2, 0, 1}));  // both turn by 11 degrees
  CHECK_FALSE(t->done());
  hand.ticks(1, at({0.1, 0, 1}), at({0.2, 0, 1}));  // 8.3 degrees, alone
  CHECK(t->done());
}

TEST_CASE("meet off by 0.03 A wants contact points farther apart than that for 0.1 s") {
  auto t = task("meet", {{"meet", "off"}, {"by", "0.03 Å"}});
  MethodHand hand{*t};
  hand.ticks(300, at({0, 0.029, 1}), at({0, 0, 1}));
  CHECK_FALSE(t->done());
  hand.ticks(110, at({0, 0.031, 1}), at({0, 0, 1}));
  CHECK(t->done());
}
