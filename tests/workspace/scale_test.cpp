// Scales between a device and a molecule, and their description for users, in closed form.
#include "engine/workspace/scale.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace moltact;

TEST_CASE("carbon's push is the slope of the van der Waals energy, and nothing where they touch and beyond 1 A") {
  // Independent of the formula's derivative: the energy itself, e ((R/r)^12 - 2 (R/r)^6), differenced; SI through
  // Avogadro's number.
  const auto energy_J = [](double r_A) {
    const double x6 = std::pow(3.40 / r_A, 6);
    return 0.107 * 4184.0 / 6.02214076e23 * (x6 * x6 - 2 * x6);
  };
  for (const double overlap_A : {0.01, 0.1, 0.3, 0.5, 0.8, 1.0}) {
    const double r = 3.40 - overlap_A, h = 1e-5;
    const double pN = 1e12 * (energy_J(r - h) - energy_J(r + h)) / (2 * h * 1e-10);
    REQUIRE(carbonPush_pN(overlap_A));
    CHECK(*carbonPush_pN(overlap_A) == doctest::Approx(pN).epsilon(1e-4));
  }
  CHECK(*carbonPush_pN(0.0) == 0.0);
  CHECK(*carbonPush_pN(0.6) > 2 * *carbonPush_pN(0.3));
  for (const double none : {-0.01, 1.001, 3.4, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_FALSE(carbonPush_pN(none));
}

TEST_CASE("a spring of 0.5 N/mm that is pressed 0.4 A deep at 0.2 A a mm, so by 2 mm, stores 1 mJ") {
  CHECK(springEnergy_J(0.5 * 0.4 * 0.4, 0.5, 0.2) == doctest::Approx(1e-3));
}

TEST_CASE(
    "the scale is described by a length and a force with two significant digits: 0.2 A a mm under "
    "0.5 N/mm is 71 pN a newton") {
  Workspace workspace;
  workspace.A_per_mm = 0.2;  // 1 N: 2 mm, 0.4 A
  CHECK(scaleSentence(workspace, 0.5) ==
        "1\u00a0mm here is 0.2\u00a0Å there, 1\u00a0N here would be 71\u00a0pN there.");
  CHECK(scaleReason(workspace, 0.5)
            .find("With 1\u00a0N the probe is 0.4\u00a0Å under the surface. Two carbon atoms pressed that far into "
                  "each other "
                  "would push back with 71\u00a0pN.") == 0);
  workspace.A_per_mm = 0.0362;  // 0.0724 A
  CHECK(scaleSentence(workspace, 0.5) ==
        "1\u00a0mm here is 0.036\u00a0Å there, 1\u00a0N here would be 4.2\u00a0pN there.");
  workspace.A_per_mm = 1.0;  // 1.0 A under 1 N/mm
  CHECK(scaleSentence(workspace, 1.0) ==
        "1\u00a0mm here is 1\u00a0Å there, 1\u00a0N here would be 2100\u00a0pN there.");
  workspace.A_per_mm = 4.0;
  CHECK(scaleSentence(workspace, 0.5) ==
        "1\u00a0mm here is 4\u00a0Å there; 1\u00a0N here presses deeper than atoms can go there.");
  CHECK(scaleReason(workspace, 0.5) ==
        "With 1\u00a0N the probe is 8\u00a0Å under the surface: so far into each other no two atoms can be pressed.");
  for (const double none : {0.0, -1.0, std::nan("")})
    CHECK(scaleSentence(workspace, none) == "1\u00a0mm here is 4\u00a0Å there; nothing pushes back.");
}

TEST_CASE(
    "a sphere of 7 A round a selection fills the Omni's 70 mm: 0.2 A a mm, centred there; garbage changes nothing") {
  const DeviceSpecs omni = phantomOmniFigures();
  const Workspace now, then = magnified(now, {{1, 2, 3}}, 7.0, omni);
  CHECK(then.A_per_mm == doctest::Approx(0.2));
  CHECK(then.centre_A == Vec3(1, 2, 3));
  CHECK(glm::distance(then.toDevice({{1, 9, 3}}).mm, Vec3(0, 35, 0)) < 1e-9);
  CHECK(magnified(now, {{0, 0, 0}}, 1e9, omni).A_per_mm == now.A_per_mm);  // never coarser than the whole
  CHECK(magnified(now, {{0, 0, 0}}, 0, omni).A_per_mm == kMinScale_A_per_mm);
  CHECK(magnified(now, {{0, 0, 0}}, std::nan(""), omni).A_per_mm == now.A_per_mm);
  CHECK(magnified(now, {{std::nan(""), 0, 0}}, 7, omni).centre_A == now.centre_A);
}

TEST_CASE(
    "rescaled: the hand and the probe stay, whatever the turn, and 10 mm farther it is 1 A farther; a scale that is "
    "none changes nothing") {
  Workspace workspace;
  workspace.centre_A = {5, -3, 8};
  workspace.rotation = glm::dmat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));
  const PointMm hand{{40, -12, 7}};
  const PointA hip = workspace.toMolecule(hand);
  const Workspace fine = rescaled(workspace, 0.1, hand, hip);
  CHECK(glm::distance(fine.toMolecule(hand).A, hip.A) < 1e-12);
  CHECK(glm::distance(fine.toMolecule({hand.mm + Vec3(10, 0, 0)}).A, hip.A + Vec3(0, 1, 0)) < 1e-12);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK(rescaled(workspace, bad, hand, hip).A_per_mm == workspace.A_per_mm);
  CHECK(rescaled(workspace, 0.1, {{std::nan(""), 0, 0}}, hip).A_per_mm == workspace.A_per_mm);
}
