// Measurements of methods from synthetic ticks.
#include "app/ui/scene/method_watch.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace moltact {
namespace {

TouchableModel oneSphere() {
  Molecule molecule;
  PlacedAtom atom;
  atom.radius_A = 1.6;
  molecule.setAtoms({atom});
  auto made = makeTouchableModel(std::move(molecule), "ball.pdb");
  REQUIRE(made);
  return *std::move(made);
}

}  // namespace

TEST_CASE("of 900 ticks of 0.2 us and 100 of 20 us the median is 0.2 us and the 99th percentile 20 us, to a bin") {
  TickHistogram h;
  CHECK(h.empty());
  CHECK(h.quantile_us(0.5) == 0.0);
  for (int k = 0; k < 900; ++k) h.add(0.2);
  for (int k = 0; k < 100; ++k) h.add(20.0);
  h.add(0.0);
  const double bin = std::pow(10.0, 1.0 / TickHistogram::kBinsADecade);
  CHECK(h.quantile_us(0.5) > 0.2 / bin);
  CHECK(h.quantile_us(0.5) < 0.2 * bin);
  CHECK(h.quantile_us(0.99) > 20.0 / bin);
  CHECK(h.quantile_us(0.99) < 20.0 * bin);
  double sum = 0.0;
  for (int k = 0; k < TickHistogram::kBins; ++k) sum += h.share(k);
  CHECK(sum == doctest::Approx(1.0));
  for (int k = 0; k < 20000; ++k) h.add(1e9);  // old times fade, and what is beyond the axis is kept at its end
  CHECK(h.quantile_us(0.5) > TickHistogram::kMax_us / bin);
}

TEST_CASE(
    "tick times of 1e37 us and infinity count at the axis' far end, 1e-37 us at its near end, and NaN and negative "
    "ones not at all") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  TickHistogram h;
  for (const double none : {std::nan(""), -1.0, -1e37, -kInfinity, 0.0}) h.add(none);
  CHECK(h.empty());
  for (const double long_us : {51.0, 1e37, 1.7e308, kInfinity}) h.add(long_us);
  CHECK(h.share(TickHistogram::kBins - 1) == 1.0);
  for (const double short_us : {0.04, 1e-37, 5e-324, 0.04}) h.add(short_us);
  CHECK(h.share(TickHistogram::kBins - 1) == 0.5);
  CHECK(h.share(0) == 0.5);
}

TEST_CASE("the error against the exact SCP is the distance of the two, and 0 where the method is exact") {
  const TouchableModel stage = oneSphere();
  MethodWatch watch;
  watch.begin(stage, {});
  ServoSample s;
  s.probe_A = 1.4;
  s.has_interaction = true;
  const auto tick = [&](Vec3 hip, Vec3 scp, const char* method) {
    s.hip = {hip};
    s.contact.scp = {scp};
    s.contact.atoms[0] = 0;
    s.contact.feature = Feature::Sphere;
    stretchToScp(s.contact, s.hip);
    s.work_us = 0.5f;
    return watch.add(s, *findMethod(method));
  };
  s.hip = s.contact.scp = {Vec3(0, 0, 4)};
  watch.feelWith({.method = "mesh80"});
  watch.add(s, *findMethod("mesh80"));
  CHECK(watch.tried().empty());  // nothing is said of a hand in the open
  for (int k = 0; k < 200; ++k) CHECK(glm::distance(tick({0, 0, 2.5}, {0, 0.25, 3}, "mesh80").scp.A, {0, 0, 3}) < 1e-9);
  watch.feelWith({.method = "exact"});
  for (int k = 0; k < 200; ++k) tick({0, 0, 2.5}, {0, 0, 3}, "exact");
  REQUIRE(watch.find("mesh80"));
  CHECK(watch.find("mesh80")->error_A == doctest::Approx(0.25));
  CHECK(watch.find("mesh80")->ticks == 200);
  CHECK(watch.find("exact")->error_A < 1e-9);
  CHECK(watch.find("penalty") == nullptr);
  // From (0, 0.25, 0.5) to (0, 0, 0.5): 26.6 degrees.
  CHECK(watch.greatestTurn_deg() == doctest::Approx(26.565).epsilon(1e-4));
  watch.begin(stage, {});
  CHECK(watch.tried().empty());
}

TEST_CASE("a hand that is placed again takes the exact tracker with it") {
  const TouchableModel stage = oneSphere();
  MethodWatch watch;
  watch.begin(stage, {.method = "paper"});
  const Method& m = *findMethod("paper");
  ServoSample s;
  s.probe_A = 1.4;
  s.has_interaction = true;
  const auto tick = [&](Vec3 hip) {
    s.hip = s.contact.scp = {hip};
    return watch.add(s, m);
  };
  tick({0, 0, 4});
  CHECK(tick({0, 0, 0}).touching());
  s.contact_reset = true;
  CHECK_FALSE(tick({0, 0, -4}).touching());
  s.contact_reset = false;
  CHECK_FALSE(tick({0, 0, -4}).touching());
}

TEST_CASE(
    "while the exact method is in use its contacts are the ticks' own; a change to another judges that one from the "
    "contact at which the hand is") {
  const TouchableModel stage = oneSphere();
  MethodWatch watch;
  watch.begin(stage, {});
  ServoSample s;
  s.probe_A = 1.4;
  s.has_interaction = true;
  s.hip = {Vec3(0, 0, 2.5)};
  s.contact.scp = {Vec3(0, 0, 3)};
  s.contact.atoms[0] = 0;
  s.contact.feature = Feature::Sphere;
  stretchToScp(s.contact, s.hip);
  CHECK(watch.add(s, *findMethod("exact")).scp == s.contact.scp);
  watch.feelWith({.method = "penalty"});
  // Pressed through the middle: without the contact at which it began the exact tracker would start inside.
  s.hip = {Vec3(0, 0, 0.5)};
  const Contact exact = watch.add(s, *findMethod("penalty"));
  CHECK(exact.fault == Fault::None);
  CHECK(glm::distance(exact.scp.A, Vec3(0, 0, 3)) < 1e-6);
}

}  // namespace moltact
