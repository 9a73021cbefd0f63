// The lever of a held body's rotational spring, from what is known of a device.
#include <doctest/doctest.h>

#include <limits>

#include "engine/servo/safety_stage.h"

using namespace moltact;

TEST_CASE(
    "the lever of a rotational spring is the radius of gyration where no torque is driven, else at most what the "
    "device shows") {
  DeviceSpecs device = phantomOmniFigures();
  device.gives_force = true;
  device.dof_in = 6;
  CHECK(SafetyStage(device).rotationalBound_N_mm() == 0.0);
  for (const double gyration_A : {0.5, 4.74, 14.6}) CHECK(springLever_A(gyration_A, 0.3, 0.5, device) == gyration_A);
  device.dof_out = 6;
  device.max_torque_N_mm = 100.0;
  const double bound = SafetyStage(device).rotationalBound_N_mm();
  CHECK(bound > 0.0);
  int shortened = 0;
  for (const double gyration_A : {0.5, 4.74, 14.6, 60.0})
    for (const double A_per_mm : {0.15, 0.3}) {
      const double lever_A = springLever_A(gyration_A, A_per_mm, 0.5, device);
      const double stiffness = steadyStiffness_N_per_mm(0.5, device);
      CHECK(lever_A > 0.0);
      CHECK(lever_A <= gyration_A);
      CHECK(stiffness * (lever_A / A_per_mm) * (lever_A / A_per_mm) <= bound * (1.0 + 1e-12));
      if (lever_A < gyration_A) {
        ++shortened;
        CHECK(stiffness * (lever_A / A_per_mm) * (lever_A / A_per_mm) == doctest::Approx(bound));
        // The stage then leaves the stiffness as it is.
        SafetyStage stage(device);
        CHECK(stage.stiffness(0.5, {.rotational_mm2 = lever_A * lever_A / (A_per_mm * A_per_mm)}) ==
              doctest::Approx(stiffness));
      }
    }
  CHECK(shortened > 0);
}

TEST_CASE(
    "a rotational damping of 0.6 N mm s bounds the rotational stiffness to half of 0.6 / (0.5 ms + 1 ms) = 200 N mm; "
    "one "
    "of 100 N mm s and one that is not known leave the bound of the lever") {
  DeviceSpecs device = phantomOmniFigures();
  device.gives_force = true;
  device.dof_in = device.dof_out = 6;
  device.max_torque_N_mm = 100.0;
  const double of_lever = SafetyStage(device).rotationalBound_N_mm();
  REQUIRE(of_lever > 200.0);
  device.rotational_damping_N_mm_s = 100.0;
  CHECK(SafetyStage(device).rotationalBound_N_mm() == of_lever);
  device.rotational_damping_N_mm_s = 0.6;
  CHECK(SafetyStage(device).rotationalBound_N_mm() == doctest::Approx(200.0));
  const double lever_A = springLever_A(60.0, 0.3, 0.5, device), K = steadyStiffness_N_per_mm(0.5, device);
  CHECK(K * (lever_A / 0.3) * (lever_A / 0.3) == doctest::Approx(200.0));
  for (const double nonsense : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    device.rotational_damping_N_mm_s = nonsense;
    CHECK(SafetyStage(device).rotationalBound_N_mm() == of_lever);
  }
}
