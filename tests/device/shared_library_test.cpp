// Reports why a library cannot be loaded from any of several places.
#include "engine/platform/shared_library.h"

#include <doctest/doctest.h>

#include <vector>

using namespace moltact;

TEST_CASE(
    "of several places where a library may be, the one that has it and lacks what it needs is "
    "reported, with the name of what is lacking") {
  const std::string needy = MOLTACT_NEEDY_LIBRARY;
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"libnowhere.so", needy, "/nowhere/libnowhere.so"},
        {needy, "libnowhere.so"},
        {needy}}) {
    const auto library = SharedLibrary::open(names);
    REQUIRE_FALSE(library);
    const std::string message = library.problem().message;
    CHECK_MESSAGE(message.find(needy) == 0, message);
    CHECK_MESSAGE(message.find("absent_dependency") != std::string::npos, message);
  }
}

TEST_CASE("a library that is nowhere is reported by its first name") {
  const std::vector<std::string> names{"libnowhere.so", "/nowhere/libnowhere.so"};
  const auto library = SharedLibrary::open(names);
  REQUIRE_FALSE(library);
  CHECK(library.problem().message.find("libnowhere.so: ") == 0);
}

TEST_CASE("a file that is there and is no library is reported before one that is not there") {
  const std::vector<std::string> names{"libnowhere.so", MOLTACT_SOURCE_DIR "/tests/device/shared_library_test.cpp"};
  const auto library = SharedLibrary::open(names);
  REQUIRE_FALSE(library);
  CHECK(library.problem().message.find("shared_library_test.cpp") != std::string::npos);
}
