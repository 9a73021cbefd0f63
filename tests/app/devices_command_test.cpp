// The output of `moltact devices` for faulty installations of OpenHaptics.
#include <doctest/doctest.h>

#include "tests/app/command_place.h"

using namespace moltact::test;

TEST_CASE(
    "an empty MOLTACT_LIBHD is as good as none: the library is looked for where it may be, and the remedy names the "
    "variable") {
  const CommandPlace place;
  for (const char* variable : {"env MOLTACT_LIBHD=''", "env -u MOLTACT_LIBHD"}) {
    const std::string out = place.run("devices", variable).out;
    CHECK(out.find("hdInitDevice") == std::string::npos);
    // With OpenHaptics installed, nothing is reported.
    if (out.find("could not be loaded") != std::string::npos)
      CHECK(out.find("MOLTACT_LIBHD=/path/libHD.so") != std::string::npos);
  }
}

TEST_CASE("a MOLTACT_LIBHD that names no file, or another library, is reported with the remedy to correct it") {
  const CommandPlace place;
  const std::string nothing = place.run("devices", "env MOLTACT_LIBHD=/nowhere/libHD.so").out;
  CHECK(nothing.find("/nowhere/libHD.so: cannot open") != std::string::npos);
  CHECK(nothing.find("correct or unset MOLTACT_LIBHD") != std::string::npos);
  const std::string other = place.run("devices", "env MOLTACT_LIBHD=libz.so.1").out;
  CHECK(other.find("libz.so.1 has no function hdInitDevice") != std::string::npos);
  CHECK(other.find("correct or unset it") != std::string::npos);
}
