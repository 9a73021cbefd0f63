// Oracle: a round table.
#include "engine/results/turns.h"

#include <doctest/doctest.h>

#include <limits>

namespace moltact {
namespace {

using State = Turns::State;

TEST_CASE("three students in turns of 60 s: each is called, starts when ready, and hands on when the time is over") {
  Turns turns;
  CHECK_FALSE(turns.on());
  CHECK(turns.current().empty());
  turns.begin(Turns::namesIn(" A \n\nB\r\nC\nA"), 60.0);
  REQUIRE(turns.names() == std::vector<std::string>{"A", "B", "C"});
  CHECK(turns.state() == State::HandOver);
  CHECK_FALSE(turns.tick(100.0));
  CHECK(turns.left_s() == 60.0);
  turns.start();
  CHECK(turns.current() == "A");
  CHECK(turns.waiting() == std::vector<std::string>{"B", "C"});
  CHECK_FALSE(turns.tick(59.5));
  turns.pause();
  CHECK_FALSE(turns.tick(10.0));
  turns.resume();
  CHECK(turns.tick(0.6));
  CHECK(turns.state() == State::HandOver);
  CHECK(turns.current() == "B");
  turns.passOn();
  turns.start();
  CHECK(turns.current() == "C");
  CHECK(turns.next() == "A");
  turns.passOn();
  CHECK(turns.current() == "A");
  CHECK(turns.turnsBegun() == 2);
}

TEST_CASE("a student who leaves, one who is called out of turn, a minute more, and turns without anyone") {
  Turns turns;
  turns.begin({}, 60.0);
  CHECK_FALSE(turns.on());
  turns.begin({"A", "B", "C", "D"}, 1.0);
  CHECK(turns.turn_s() == Turns::kShortest_s);
  turns.start();
  turns.call("C");
  CHECK(turns.current() == "C");
  CHECK(turns.next() == "D");
  turns.call("nobody");
  CHECK(turns.current() == "C");
  turns.start();
  turns.extend(60.0);
  CHECK(turns.left_s() == 75.0);
  turns.leave("A");
  CHECK(turns.current() == "C");
  CHECK(turns.state() == State::Running);
  turns.leave("C");
  CHECK(turns.current() == "D");
  CHECK(turns.state() == State::HandOver);
  turns.leave("D");
  CHECK(turns.current() == "B");
  CHECK(turns.next() == "B");
  CHECK(turns.waiting().empty());
  turns.leave("B");
  CHECK_FALSE(turns.on());
  turns.begin({"A"}, std::numeric_limits<double>::quiet_NaN());
  CHECK(turns.turn_s() == Turns::kShortest_s);
}

}  // namespace
}  // namespace moltact
