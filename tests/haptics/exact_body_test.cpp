// The exact rigid body against closed forms. All sums of radii include the body's skin.
#include "engine/haptics/body/exact_body.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kSkin = ExactBody::kSkin_A;
const Vec3 kY(0, 1, 0), kZ(0, 0, 1);

std::shared_ptr<const HeldBody> dumbbell(double l, double r) {
  return bodyOfSpheres({{{l, 0, 0}, r}, {{-l, 0, 0}, r}});
}

// The root of a function that changes its sign between the two arguments.
double root(const std::function<double(double)>& f, double low, double high) {
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == (f(low) > 0.0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Moves the hand straight from one pose to the other in equal steps and returns the last response.
Response walkTo(Interaction& felt, const PoseA& from, const PoseA& to, int steps) {
  Response last;
  for (int k = 0; k <= steps; ++k) {
    const double t = double(k) / steps;
    last = felt.respond(
        {{from.place.A + (to.place.A - from.place.A) * t}, glm::slerp(from.orientation, to.orientation, t)});
  }
  return last;
}

double angleBetween(const Quat& a, const Quat& b) { return glm::length(rotationBetween(a, b)); }

}  // namespace

TEST_CASE("a dumbbell across a sphere rests where the derivative of its energy is zero: 24 hands, to 1e-9 A and rad") {
  const double R = 3.0, r = 1.2, l = 1.5, rho = std::sqrt((R + r + kSkin) * (R + r + kSkin) - l * l);
  const auto scene = test::makeScene({{{0, 0, 0}, R}});
  double worst = 0.0;
  for (int n = 0; n < 24; ++n) {
    const double hx = -0.5 + 0.04 * n, hz = 3.4 - 0.05 * n, beta = 0.02 * (n % 9) - 0.08;
    ExactBody felt(scene, dumbbell(l, r));
    const double L2 = felt.lever_A() * felt.lever_A();
    CHECK(L2 == doctest::Approx(l * l));
    const Quat turned = glm::angleAxis(beta, kY);
    walkTo(felt, {{{0, 0, 8}}, kNoRotation}, {{{0, 0, 3.7}}, kNoRotation}, 100);
    const Response at = walkTo(felt, {{{0, 0, 3.7}}, kNoRotation}, {{{hx, 0, hz}}, turned}, 100);
    const double psi =
        root([&](double p) { return -rho * hx * std::cos(p) + rho * hz * std::sin(p) + L2 * (p - beta); }, -1.2, 1.2);
    REQUIRE(at.at_rest);
    REQUIRE(at.body_pose);
    worst = std::max({worst, glm::distance(at.body_pose->place.A, rho * Vec3(std::sin(psi), 0, std::cos(psi))),
                      angleBetween(at.body_pose->orientation, glm::angleAxis(psi, kY))});
    // Force and torque are the springs' own.
    CHECK(glm::distance(at.contact.displacement_A, at.body_pose->place.A - Vec3(hx, 0, hz)) < 1e-12);
    CHECK(at.torque_A2.y == doctest::Approx(L2 * (psi - beta)).epsilon(1e-7));
    CHECK(felt.contactCount() == 2);
  }
  CHECK(worst < 1e-9);
}

TEST_CASE(
    "a dumbbell pressed straight onto a sphere stands until the hand has passed the sphere's centre, then slides off") {
  const double R = 3.0, r = 1.2, l = 1.5, rho = std::sqrt((R + r + kSkin) * (R + r + kSkin) - l * l);
  const auto scene = test::makeScene({{{0, 0, 0}, R}});
  for (const double depth : {0.5, 0.9, 0.999}) {  // as a part of rho: the curvature across the stick is 1 - depth
    ExactBody felt(scene, dumbbell(l, r));
    const Response at = walkTo(felt, {{{0, 0, 9}}, kNoRotation}, {{{0, 0, rho * (1.0 - depth)}}, kNoRotation}, 300);
    CHECK(at.at_rest);
    CHECK(glm::distance(at.body_pose->place.A, Vec3(0, 0, rho)) < 1e-7);
  }
  ExactBody felt(scene, dumbbell(l, r));
  walkTo(felt, {{{0, 0, 9}}, kNoRotation}, {{{0, 0, -0.05}}, kNoRotation}, 300);
  Response at;
  for (int k = 0; k < 20; ++k) at = felt.respond({{{0, 0, -0.05}}, kNoRotation});
  CHECK(at.at_rest);
  CHECK(at.body_pose->place.A.z < 0.0);
}

TEST_CASE("a dumbbell turned about its middle between two spheres stops at the angle at which both ends touch") {
  const double R = 1.5, r = 0.8, l = 3.0, H = 2.7, reach = R + r + kSkin;
  ExactBody felt(test::makeScene({{{0, 0, H}, R}, {{0, 0, -H}, R}}), dumbbell(l, r));
  const double a = std::asin((l * l + H * H - reach * reach) / (2.0 * H * l));
  CHECK(felt.respond({{{0, 0, 0}}, kNoRotation}).contact.fault == Fault::None);
  for (const double beyond : {0.1, 0.2, 0.3}) {
    const Response at = walkTo(felt, {{{0, 0, 0}}, kNoRotation}, {{{0, 0, 0}}, glm::angleAxis(-(a + beyond), kY)}, 200);
    CHECK(at.at_rest);
    CHECK(glm::length(at.body_pose->place.A) < 1e-9);
    CHECK(std::abs(angleBetween(at.body_pose->orientation, kNoRotation) - a) < 1e-9);
    CHECK(std::abs(at.torque_A2.y - beyond * felt.lever_A() * felt.lever_A()) < 1e-7);
    CHECK(glm::length(at.contact.displacement_A) < 1e-9);
  }
}

TEST_CASE(
    "a stick of 21 spheres across two spheres, twisted, lies at z^2 = D^2 - 2 x0^2 (1 - cos a): 20 hands, to 1e-9 A "
    "and "
    "rad") {
  const double R = 2.5, r = 1.2, x0 = 3.0, D = R + r + kSkin;
  std::vector<Sphere> balls;
  for (int k = -10; k <= 10; ++k) balls.push_back({{k, 0, 0}, r});
  const auto scene = test::makeScene({{{x0, 0, 0}, R}, {{-x0, 0, 0}, R}});
  double worst = 0.0;
  for (int n = 0; n < 20; ++n) {
    const double height = 3.2 - 0.03 * n, beta = 0.05 + 0.02 * (n % 7);
    ExactBody felt(scene, bodyOfSpheres(balls));
    const double L2 = felt.lever_A() * felt.lever_A();
    CHECK(L2 == doctest::Approx(770.0 / 21.0));
    walkTo(felt, {{{0, 0, 8}}, kNoRotation}, {{{0, 0, 3.4}}, kNoRotation}, 100);
    const Response at = walkTo(felt, {{{0, 0, 3.4}}, kNoRotation}, {{{0, 0, height}}, glm::angleAxis(beta, kZ)}, 100);
    const auto z = [&](double a) { return std::sqrt(D * D - 2.0 * x0 * x0 * (1.0 - std::cos(a))); };
    // The derivative of (z - height)^2 / 2 + L^2 (a - beta)^2 / 2.
    const double a =
        root([&](double t) { return -(z(t) - height) * x0 * x0 * std::sin(t) / z(t) + L2 * (t - beta); }, 0.0, 0.5);
    REQUIRE(at.at_rest);
    worst = std::max({worst, glm::distance(at.body_pose->place.A, Vec3(0, 0, z(a))),
                      angleBetween(at.body_pose->orientation, glm::angleAxis(a, kZ))});
    CHECK(a > beta);  // pressed down, it twists on
    CHECK(felt.contactCount() == 2);
  }
  CHECK(worst < 1e-9);
}

TEST_CASE(
    "one sphere in the general search is the exact tracker with its radius and the skin, to 1e-9 A on 9 paths, but for "
    "leaps to another rest, at most 1 tick in 500") {
  int ticks = 0, pressed = 0, leaps = 0;
  double worst = 0.0;
  for (int n = 0; n < 9; ++n) {
    CAPTURE(n);
    const auto spheres = scenes::cluster(60 + 20 * n, std::uint64_t(40 + n)).spheres;
    const auto grid = test::makeScene(spheres);
    const double radius_A = 1.0 + 0.1 * n;
    const auto body = bodyOfSpheres({{{0, 0, 0}, radius_A}});
    const auto tracker = referenceMethod().make(grid, radius_A + kSkin);
    ExactBody felt(grid, body);
    Vec3 before(0.0);
    for (const PoseA& hand : test::bodyPath(spheres, body->reach_A, 1000, std::uint64_t(n), 0.03, 0.004, 2.0)) {
      const Response is = felt.respond(hand);
      const Contact should = tracker->step(hand.place);
      REQUIRE(is.contact.fault == should.fault);
      if (should.fault != Fault::None) continue;
      ++ticks, pressed += should.touching();
      const double off = glm::distance(is.contact.scp.A, should.scp.A);
      if (is.at_rest && off > 1e-6) {
        // Another of several rests: both have moved by much more than the hand. Both are led to the hand anew.
        ++leaps;
        CHECK(glm::distance(should.scp.A, before) > 0.15);
        felt.reset(), tracker->reset();
        const Vec3 from = 60.0 * glm::normalize(hand.place.A);
        for (int k = 0; k <= 3000; ++k) {
          const PoseA at{{from + (hand.place.A - from) * (k / 3000.0)}, hand.orientation};
          felt.respond(at), tracker->step(at.place);
        }
      } else if (is.at_rest) {
        worst = std::max(worst, off);
        CHECK(is.contact.touching() == should.touching());
      }
      before = should.scp.A;
    }
  }
  MESSAGE(ticks << " ticks, " << pressed << " pressed, " << leaps << " leaps to another rest, else within " << worst
                << " A");
  CHECK(pressed > ticks / 3);
  CHECK(worst < 1e-9);
  CHECK(leaps * 500 <= ticks);
}

TEST_CASE(
    "a row of three spheres passes a ring of six with 1.01e-10 A to spare, and stops at the exact height with less") {
  const auto row = bodyOfSpheres({{{0, 0, -2.4}, 1.4}, {{0, 0, 0}, 1.4}, {{0, 0, 2.4}, 1.4}});
  for (const double slack : {0.1, 1e-3, 1e-6, 1e-9, 1.01e-10, 1e-11, 0.0, -1e-9, -1e-3}) {
    CAPTURE(slack);
    ExactBody felt(test::makeScene(scenes::ring(6, slack).spheres), row);
    Response at;
    // Pressed by less than bends the row over.
    const double low = slack > kSkin ? -8.0 : 1.5;
    for (int k = 0; k <= 400; ++k) at = felt.respond({{{0, 0, 8.0 + (low - 8.0) * k / 400.0}}, kNoRotation});
    CHECK(at.at_rest);
    const double across = 3.1 + slack, touching = 3.1 + kSkin;
    if (slack > kSkin)
      CHECK(glm::distance(at.body_pose->place.A, Vec3(0, 0, -8)) < 1e-8);
    else
      CHECK(std::abs(at.body_pose->place.A.z - 2.4 - std::sqrt(touching * touching - across * across)) < 1e-7);
  }
}

TEST_CASE("sixteen spheres in the hollows of a lattice rest on 64 contacts at once, to 1e-9 A") {
  std::vector<Sphere> lattice, body;
  const double apart = 2.6, R = 1.5, r = 1.2;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) lattice.push_back({{apart * (i - 2), apart * (j - 2), 0}, R});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) body.push_back({{apart * (i - 1.5), apart * (j - 1.5), 0}, r});
  ExactBody felt(test::makeScene(lattice), bodyOfSpheres(body));
  const double height = std::sqrt((R + r + kSkin) * (R + r + kSkin) - 0.5 * apart * apart);
  walkTo(felt, {{{0.3, -0.2, 7}}, kNoRotation}, {{{0.3, -0.2, 2}}, kNoRotation}, 200);
  const Response at = walkTo(felt, {{{0.3, -0.2, 2}}, kNoRotation}, {{{0.1, 0, 1}}, glm::angleAxis(0.02, kZ)}, 50);
  CHECK(at.at_rest);
  CHECK(glm::distance(at.body_pose->place.A, Vec3(0, 0, height)) < 1e-9);
  CHECK(angleBetween(at.body_pose->orientation, kNoRotation) < 1e-9);
  CHECK(felt.steps() <= 12);
}

TEST_CASE("sixteen spheres on sixteen crests stand while they are pressed by less than the sum of radii, then slide") {
  std::vector<Sphere> lattice, body;
  const double apart = 2.6, R = 1.5, r = 1.2, D = R + r + kSkin;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      lattice.push_back({{apart * (i - 1.5), apart * (j - 1.5), 0}, R});
      body.push_back({{apart * (i - 1.5), apart * (j - 1.5), 0}, r});
    }
  ExactBody felt(test::makeScene(lattice), bodyOfSpheres(body));
  const Response stands = walkTo(felt, {{{0, 0, 6}}, kNoRotation}, {{{0, 0, 0.1 * D}}, kNoRotation}, 200);
  CHECK(stands.at_rest);
  CHECK(glm::distance(stands.body_pose->place.A, Vec3(0, 0, D)) < 1e-8);
  Response slid = walkTo(felt, {{{0, 0, 0.1 * D}}, kNoRotation}, {{{0, 0, -0.2 * D}}, kNoRotation}, 50);
  for (int k = 0; k < 20; ++k) slid = felt.respond({{{0, 0, -0.2 * D}}, kNoRotation});
  CHECK(slid.at_rest);
  CHECK(slid.body_pose->place.A.z < 0.9 * D);
}

TEST_CASE(
    "away from the scene the body has the hand's pose to the last bit, without force, also after jumps of 500 A") {
  const auto body = test::chainBody(12, 3);
  ExactBody felt(test::makeScene(scenes::cluster(100, 5).spheres), body);
  for (const Vec3& place : {Vec3(500, 0, 0), Vec3(-500, 20, 0), Vec3(60, 60, 60)}) {
    const PoseA hand{{place}, glm::normalize(Quat(0.3, place.x, 1.0, place.y))};
    Response at;
    for (int k = 0; k < 60; ++k) at = felt.respond(hand);
    CHECK(at.at_rest);
    CHECK_FALSE(at.acts());
    CHECK(at.body_pose->place.A == place);
    CHECK(angleBetween(at.body_pose->orientation, hand.orientation) < 1e-15);
  }
}

TEST_CASE(
    "the coupling slips at 2 rad: the torque of a body that cannot turn grows to 2 L^2, stays, and never changes "
    "sign") {
  // Each end of a cross has 0.02 A of room above, below and at its sides; the hand turns on by more than a whole turn.
  const double R = 30.0, r = 0.8, l = 3.0, room = 0.02;
  std::vector<Sphere> cross, cage;
  for (const Vec3& end : {Vec3(l, 0, 0), Vec3(-l, 0, 0), Vec3(0, l, 0), Vec3(0, -l, 0)}) {
    cross.push_back({end, r});
    const Vec3 side = glm::cross(kZ, end) / l;
    for (const double sign : {1.0, -1.0}) {
      cage.push_back({end + sign * (R + r + room) * kZ, R});
      cage.push_back({end + sign * (0.5 + r + room) * side, 0.5});
    }
  }
  ExactBody felt(test::makeScene(cage), bodyOfSpheres(cross));
  felt.respond({{{0, 0, 0}}, kNoRotation});
  const double L2 = felt.lever_A() * felt.lever_A();
  double most = 0.0, least = 1e9;
  for (int k = 0; k < 700; ++k) {
    const Response at = felt.respond({{{0, 0, 0}}, glm::angleAxis(-0.01 * k, kY)});
    most = std::max(most, at.torque_A2.y);
    if (k > 300) least = std::min(least, at.torque_A2.y);
  }
  CHECK(most < 2.0 * L2 * (1.0 + 1e-9));
  CHECK(least > 1.99 * L2);
}

TEST_CASE("a body that has come free after its coupling slipped takes on the hand's orientation while the hand moves") {
  // A stick between two pegs, turned by 3 rad and pulled out.
  ExactBody felt(test::makeScene({{{1.5, 2.5, 0}, 1.5}, {{-1.5, -2.5, 0}, 1.5}}), dumbbell(3.0, 0.9));
  felt.respond({{{0, 0, 0}}, kNoRotation});
  double most = 0.0;
  for (int k = 0; k <= 300; ++k) {
    const Response turned = felt.respond({{{0, 0, 0}}, glm::angleAxis(0.01 * k, kZ)});
    most = std::max(most, glm::length(turned.torque_A2));
  }
  CHECK(most > 0.5);
  Response at;
  for (int k = 0; k < 1000; ++k) at = felt.respond({{{0, 0, 0.02 * k}}, glm::angleAxis(3.0, kZ)});
  CHECK_FALSE(at.acts());
  CHECK(angleBetween(at.body_pose->orientation, glm::angleAxis(3.0, kZ)) < 1e-9);
}

TEST_CASE("a body that starts in the scene, or gets no pose, gives no force") {
  ExactBody felt(test::makeScene({{{0, 0, 0}, 3.0}}), dumbbell(1.0, 1.2));
  CHECK(felt.respond({{{0, 0, 2}}, kNoRotation}).contact.fault == Fault::StartedInside);
  CHECK_FALSE(felt.respond({{{0, 0, 3}}, kNoRotation}).acts());
  CHECK(felt.respond({{{0, 0, 6}}, kNoRotation}).contact.fault == Fault::None);
  const Response in = walkTo(felt, {{{0, 0, 6}}, kNoRotation}, {{{0, 0, 2}}, kNoRotation}, 100);
  CHECK(in.acts());
  for (const PoseA& bad : {PoseA{{{std::nan(""), 0, 0}}}, PoseA{{{0, 0, 2}}, Quat(0, 0, 0, 0)}, PoseA{{{2e9, 0, 0}}}}) {
    const Response r = felt.respond(bad);
    CHECK(r.contact.fault == Fault::NotFinite);
    CHECK_FALSE(r.acts());
  }
  CHECK(felt.respond({{{0, 0, 2}}, kNoRotation}).contact.displacement_A == in.contact.displacement_A);
  felt.reset();
  CHECK(felt.respond({{{0, 0, 2}}, kNoRotation}).contact.fault == Fault::StartedInside);
}

TEST_CASE(
    "a sphere that comes by 1 A pushes the body along by as much; one that grows raises it; two that close let it go") {
  const std::vector<Sphere> from{{{0, 0, 0}, 3.0}, {{0, 0, 40}, 3.0}};
  const auto moved = [&](Vec3 by, double growth, Vec3 other) {
    std::vector<Sphere> to = from;
    to[0].centre_A += by, to[0].radius_A += growth, to[1].centre_A += other;
    auto motion = SphereMotion::make(from, to, 30);
    REQUIRE(motion);
    return std::move(*motion);
  };
  const double rest = std::sqrt((4.2 + kSkin) * (4.2 + kSkin) - 1.0);
  const auto follow = [&](ExactBody& felt, const SphereMotion& motion, const PoseA& hand) {
    CHECK(felt.setMotion(&motion));
    Response at;
    for (int k = 0; k <= 30; ++k) felt.advanceTo(k / 30.0), at = felt.respond(hand);
    return at;
  };
  const PoseA hand{{{0, 0, 3.5}}, kNoRotation};
  const auto pressed = [&](ExactBody& felt) {
    const Response at = walkTo(felt, {{{0, 0, 9}}, kNoRotation}, hand, 100);
    CHECK(std::abs(at.body_pose->place.A.z - rest) < 1e-9);
  };
  const auto scene = test::makeScene(from);
  {
    ExactBody felt(scene, dumbbell(1.0, 1.2));
    pressed(felt);
    const auto motion = moved({0, 0, 1}, 0.0, Vec3(0.0));
    const Response at = follow(felt, *motion, hand);
    CHECK(at.at_rest);
    CHECK(std::abs(at.body_pose->place.A.z - 1.0 - rest) < 1e-9);
  }
  {
    ExactBody felt(scene, dumbbell(1.0, 1.2));
    pressed(felt);
    const auto motion = moved(Vec3(0.0), 0.5, Vec3(0.0));
    const Response at = follow(felt, *motion, hand);
    CHECK(std::abs(at.body_pose->place.A.z - std::sqrt((4.7 + kSkin) * (4.7 + kSkin) - 1.0)) < 1e-9);
  }
  {
    const auto held = dumbbell(1.0, 1.2);
    ExactBody felt(scene, held);
    pressed(felt);
    // Flat between two spheres, straight above each other: there is no way out to the first order. The body is held until
    // the gap is as wide as the body, at z = 2 rest, and let go in the next tick.
    const auto motion = moved(Vec3(0.0), 0.0, {0, 0, -36});
    CHECK(felt.setMotion(motion.get()));
    for (int k = 0; k <= 30; ++k) {
      CAPTURE(k);
      felt.advanceTo(k / 30.0);
      const Response at = felt.respond(hand);
      if (40.0 - 1.2 * k < 2.0 * rest) {
        CHECK(at.contact.fault == Fault::StartedInside);
        CHECK_FALSE(at.acts());
      } else {
        CHECK(at.contact.fault == Fault::None);
        CHECK(at.acts());
        CHECK(std::abs(at.body_pose->place.A.z - rest) < 1e-9);
      }
    }
  }
  {
    // Half a radius aside and slower, it pushes the body out instead. No tick overlaps or lets go.
    const auto held = dumbbell(1.0, 1.2);
    ExactBody felt(scene, held);
    pressed(felt);
    std::vector<Sphere> to = from;
    to[1].centre_A = {0, 1.5, 40};
    auto aside = SphereMotion::make(from, to, 30);
    REQUIRE(aside);
    follow(felt, **aside, hand);
    to[1].centre_A.z = 4.0;
    auto down = SphereMotion::after(**aside, to, 600);
    REQUIRE(down);
    CHECK(felt.setMotion(down->get()));
    Response at;
    for (int k = 0; k <= 600; ++k) {
      CAPTURE(k);
      felt.advanceTo(k / 600.0);
      at = felt.respond(hand);
      REQUIRE(at.contact.fault == Fault::None);
      for (const Sphere& s : (*down)->at(k / 600.0))
        for (const Sphere& b : held->spheres)
          REQUIRE(glm::distance(at.body_pose->place.A + at.body_pose->orientation * b.centre_A, s.centre_A) >
                  s.radius_A + b.radius_A - 1e-9);
    }
    CHECK(at.acts());
    CHECK(at.body_pose->place.A.y < -1.0);
  }
}

TEST_CASE("a body of spheres crushed from six sides is let go: StartedInside, no force, until its pose is free again") {
  std::vector<Sphere> from, to;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3 far(0.0), near(0.0);
      far[axis] = 12.0 * side, near[axis] = 8.5 * side;
      from.push_back({far, 8.0}), to.push_back({near, 8.0});
    }
  const auto motion = SphereMotion::make(from, to, 100);
  REQUIRE(motion);
  ExactBody felt(test::makeScene(from), bodyOfSpheres({{{0.9, 0, 0}, 1.0}, {{-0.9, 0, 0}, 1.0}}));
  CHECK(felt.respond({}).contact.fault == Fault::None);
  felt.setMotion(motion->get());
  bool let_go = false;
  for (int k = 0; k <= 100; ++k) {
    felt.advanceTo(0.01 * k);
    const Response at = felt.respond({});
    let_go = at.contact.fault == Fault::StartedInside;
    if (let_go) CHECK_FALSE(at.acts());
  }
  CHECK(let_go);
  felt.advanceTo(0.0);
  CHECK(felt.respond({}).contact.fault == Fault::None);
}
