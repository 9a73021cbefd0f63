// The observer of a device's energy when its forces take effect late.
#include "engine/servo/passivity_control.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace moltact;

TEST_CASE(
    "forces of 1 N, 2 N, 3 N …: what is felt 0 to 255 ticks late is booked against the force of that tick, in newtons "
    "and in newton millimetres, also after the history has gone round twice") {
  for (const int ticks : {300, 600}) {
    PassivityControl control;
    control.restart();
    for (int k = 1; k <= ticks; ++k) control.give(Vec3(k, 0, 0), Vec3(0, 0, 1000.0 * k));
    double booked_J = 0;
    for (std::size_t late = 0; late <= 255; ++late) {
      CAPTURE(late);
      const double felt = ticks - double(late);
      control.observe(Vec3(1e-3, 0, 0), Vec3(0), 0, 0, late);
      booked_J += 1e-3 * felt;
      CHECK(control.debt_J() == doctest::Approx(booked_J).epsilon(1e-12));
      control.observe(Vec3(0), Vec3(0, 0, 1e-3), 0, 0, late);
      booked_J += 1e-3 * felt;
      CHECK(control.debt_J() == doctest::Approx(booked_J).epsilon(1e-12));
    }
    // An implausible delay reads nothing beyond the history.
    control.observe(Vec3(1e-3, 0, 0), Vec3(0), 0, 0, std::size_t{1} << 60);
    CHECK(control.debt_J() == doctest::Approx(booked_J + 1e-3 * (ticks - 255)).epsilon(1e-12));
  }
}

TEST_CASE("before as many ticks have passed as the delay is long nothing was felt, and nothing is booked") {
  PassivityControl control;
  control.restart();
  for (int k = 0; k < 50; ++k) control.give(Vec3(2, 0, 0), Vec3(0));
  control.observe(Vec3(1, 0, 0), Vec3(0), 0, 0, 50);
  CHECK(control.debt_J() == 0.0);
  control.observe(Vec3(1, 0, 0), Vec3(0), 0, 0, 49);
  CHECK(control.debt_J() == 2.0);
}
