// The lever of a held body's rotational spring, from what is known of a device.
#include <doctest/doctest.h>

#include "engine/servo/safety_stage.h"

using namespace moltact;

TEST_CASE(
    "the lever of a rotational spring is the radius of gyration where no torque is driven, else at most what the "
    "device shows") {
  DeviceSpecs device = phantomOmniFigures();
  device.gives_force = true;
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
