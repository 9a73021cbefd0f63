// The list of devices: which exist, which is chosen, and the message for an unknown name.
#include <doctest/doctest.h>

#include "engine/device/driver.h"

using namespace moltact;

TEST_CASE(
    "the mouse is the last driver, always found and usable; every device has a name of its own and a reason or is "
    "usable") {
  const std::vector<FoundDevice> found = findDevices();
  CHECK(found.back().name == "mouse");
  CHECK(found.back().usable);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(found[k].name);
    CHECK(found[k].usable == found[k].why.empty());
    CHECK_FALSE(found[k].title.empty());
    for (std::size_t j = 0; j < k; ++j) CHECK(found[j].name != found[k].name);
  }
  for (const DeviceDriver& driver : deviceDrivers()) CHECK(driver.sentence.back() == '.');
}

TEST_CASE("the default is the first device that is usable and may be chosen unasked; without one it is the mouse") {
  const FoundDevice simulated{.name = "simulated", .usable = true, .gives_force = true},
      mouse{.name = "mouse", .usable = true, .auto_selectable = true};
  FoundDevice omni{.name = "omni", .usable = true, .gives_force = true, .auto_selectable = true};
  CHECK(defaultDevice({omni, simulated, mouse}).name == "omni");
  omni.usable = false;
  CHECK(defaultDevice({omni, simulated, mouse}).name == "mouse");
}

TEST_CASE("a name that no device has is answered with the names there are") {
  const auto none = openDevice("phantom");
  REQUIRE_FALSE(none);
  CHECK(none.problem().message == "there is no device \"phantom\"");
  CHECK(none.problem().remedy.find("simulated") != std::string::npos);
  CHECK(none.problem().remedy.find("mouse") != std::string::npos);
}

TEST_CASE("the simulated stylus opens by name and says that it gives 3.3 N for a moment and 0.88 N for good") {
  const auto device = openDevice("simulated");
  REQUIRE(device);
  CHECK((*device)->info().gives_force);
  CHECK((*device)->info().max_force_N == 3.3);
  CHECK((*device)->info().continuous_force_N == 0.88);
  CHECK((*device)->status().connected);
}
