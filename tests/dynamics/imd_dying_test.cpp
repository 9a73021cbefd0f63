// A client that pulls an atom and dies: the server's last word about forces is that there are none. Oracle: the server
// of imd_test_server.h.
#include <doctest/doctest.h>

#include "tests/dynamics/child_program.h"
#include "tests/dynamics/imd_test_server.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "a client that dies while it pulls, by a segmentation fault, abort(), SIGTERM, exit() or the end of main(), ends "
    "the force and disconnects") {
  const std::vector<Vec3> atoms{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  ImdTestServer server({}, atoms);
  int clients = 0;
  for (const std::string way : {"segv", "abort", "term", "exit", "return"}) {
    CAPTURE(way);
    ++clients;
    ChildProgram client({MOLTACT_DYING_CLIENT, std::to_string(server.port()), "3", way}, "/tmp", "/dev/null");
    for (int k = 0; k < 60'000 && server.gone < clients; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    REQUIRE(server.gone == clients);
    CHECK(server.words().find("6:1") != std::string::npos);
    CHECK(server.forceEnded());
    CHECK(server.disconnected());
  }
}
