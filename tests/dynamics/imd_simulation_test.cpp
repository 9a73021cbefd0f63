// An IMD client over TCP on the loopback address: positions, forces, pauses and every way in which a session ends.
// Oracle: a server whose pulled atom rests where the spring ends. MOLTACT_IMD_FAULTS=10000 repeats the faults as often.
#include "engine/dynamics/imd/imd_simulation.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

#include "tests/dynamics/imd_test_server.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::vector<Vec3> kAtoms{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};

// Waits for another thread, for a minute at most, so that no result depends on the speed of the machine.
template <class Done>
bool imdSimulationComes(Done done) {
  for (int k = 0; k < 60'000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return done();
}

Expected<std::unique_ptr<LiveSimulation>> connectTo(const ImdTestServer& server, std::vector<Vec3> atoms = kAtoms) {
  return ImdSimulation::connect({"127.0.0.1", server.port()}, std::move(atoms), nullptr);
}

SimulationCommand pull(std::uint32_t atom, const Vec3& to_A) {
  SimulationCommand out;
  out.pushes.push_back({atom, to_A, Vec3(0.0), 2.0});
  return out;
}

}  // namespace

TEST_CASE(
    "over TCP, both versions in both byte orders: an atom that is pulled comes to rest where the spring ends, within "
    "0.01 A; a pause stops it; leaving ends the forces and disconnects") {
  for (const int version : {2, 3})
    for (const bool little : {true, false}) {
      ImdTestServer server({version, little}, kAtoms);
      auto made = connectTo(server);
      REQUIRE_MESSAGE(made, made.problem().text());
      LiveSimulation& live = **made;
      CHECK_FALSE(live.obeysAll());
      SimulationCommand wanted = pull(1, {3, 4, 0});
      CHECK(imdSimulationComes([&] {
        live.command(wanted);
        return live.newest().serial > 0 && glm::distance(live.newest().positions_A[1], Vec3(3, 4, 0)) < 0.01;
      }));
      CHECK(glm::distance(live.newest().positions_A[0], kAtoms[0]) < 1e-6);
      CHECK(glm::distance(server.place_A(1), Vec3(3, 4, 0)) < 0.02);
      wanted = {};
      live.command(wanted);
      CHECK(imdSimulationComes([&] { return server.pushed == 0; }));
      wanted.running = false;
      live.command(wanted);
      CHECK(imdSimulationComes([&] { return server.paused.load(); }));
      made->reset();
      CHECK(imdSimulationComes([&] { return server.gone == 1; }));
      CHECK(server.forceEnded());
      CHECK_FALSE(server.paused);
      CHECK(server.disconnected());
    }
}

TEST_CASE(
    "a window that stops commanding while it pulls: the server hears within a second that the forces have ended") {
  ImdTestServer server({}, kAtoms);
  auto made = connectTo(server);
  REQUIRE(made);
  const SimulationCommand wanted = pull(0, {0, 0, 500});
  CHECK(imdSimulationComes([&] {
    (*made)->command(wanted);
    return server.pushed == 1;
  }));
  CHECK(imdSimulationComes([&] { return server.pushed == 0; }));
  CHECK_FALSE((*made)->newest().dead);
}

TEST_CASE(
    "faults at random places, in half of the runs while the server feels the hand's pull: each ends the session with a "
    "sentence; where the server still listened, the last word about forces was that there are none") {
  const char* flag = std::getenv("MOLTACT_IMD_FAULTS");
  const int runs = flag ? std::atoi(flag) : 200;
  std::mt19937 random(3);
  MESSAGE("seed 3, ", runs, " runs");
  constexpr ImdFault kinds[] = {ImdFault::HangsUp,      ImdFault::CutsFrame,   ImdFault::Resets,
                                ImdFault::Disconnects,  ImdFault::Garbage,     ImdFault::NotANumber,
                                ImdFault::TooManyAtoms, ImdFault::TwoGigabytes};
  ImdTestServer two({2, true}, kAtoms), three({3, false}, kAtoms);
  two.frame_us = three.frame_us = 100;
  int pulled = 0;
  for (int run = 0; run < runs; ++run) {
    ImdTestServer& server = run % 2 ? two : three;
    const ImdFault kind = kinds[random() % std::size(kinds)];
    const bool while_pulling = random() % 2 == 0;
    server.fault = while_pulling ? ImdFault::None : kind;
    server.frames_before_fault = while_pulling ? 0 : int(random() % 12);
    server.cut_at = std::uint32_t(random() % 300);
    CAPTURE(run);
    const int kind_number = int(kind);
    CAPTURE(kind_number);
    CAPTURE(while_pulling);
    const int gone = server.gone;
    auto made = connectTo(server);
    if (made) {
      const SimulationCommand wanted = pull(std::uint32_t(random() % 4), {9, 9, 9});
      (*made)->command(wanted);
      if (while_pulling) {
        const bool felt = imdSimulationComes([&] {
          (*made)->command(wanted);
          return server.pushed == 1;
        });
        CHECK(felt);
        pulled += felt;
        server.fault = kind;
      }
      CHECK(imdSimulationComes([&] {
        (*made)->command(wanted);
        return (*made)->newest().dead;
      }));
      CHECK_FALSE((*made)->newest().fault.empty());
      CHECK(finite((*made)->newest().positions_A[0]));
      made->reset();
    } else {
      CHECK_FALSE(made.problem().message.empty());
    }
    CHECK(imdSimulationComes([&] { return server.gone > gone; }));
    if (kind > ImdFault::Resets) CHECK(server.forceEnded());
  }
  MESSAGE(pulled, " of them while the server felt a pull");
  CHECK(pulled > runs / 3);
}

TEST_CASE("a server that stalls: the forces end, the frame says so, and the session can still be left") {
  ImdTestServer server({}, kAtoms);
  server.fault = ImdFault::Stalls;
  server.frames_before_fault = 50;
  auto made = connectTo(server);
  REQUIRE(made);
  const SimulationCommand wanted = pull(0, {0, 0, 5});
  CHECK(imdSimulationComes([&] {
    (*made)->command(wanted);
    return (*made)->newest().silent;
  }));
  CHECK(imdSimulationComes([&] { return server.pushed == 0; }));
  CHECK_FALSE((*made)->newest().dead);
  made->reset();
  CHECK(imdSimulationComes([&] { return server.gone == 1; }));
  CHECK(server.disconnected());
}

TEST_CASE(
    "no server, a server of another molecule, one that does not answer, and a wait that is given up: each a sentence "
    "with the address") {
  {
    ImdTestServer server({}, kAtoms);
    const auto other = connectTo(server, std::vector<Vec3>(7));
    REQUIRE_FALSE(other);
    CHECK(other.problem().file == "127.0.0.1:" + std::to_string(server.port()));
    CHECK(other.problem().message == "the server sends 4 atoms, and the molecule has 7");
    CHECK(imdSimulationComes([&] { return server.gone == 1; }));
    CHECK(server.disconnected());
    CHECK_FALSE(connectTo(server, {}));
    CHECK_FALSE(connectTo(server, std::vector<Vec3>(ImdSimulation::kMaxAtoms + 1)));
  }
  ImdTestServer server({}, kAtoms);
  server.fault = ImdFault::Stalls;
  server.frames_before_fault = 0;
  auto given_up = std::make_shared<std::atomic<bool>>(false);
  std::thread later([given_up] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    *given_up = true;
  });
  const auto made = ImdSimulation::connect({"127.0.0.1", server.port()}, kAtoms, given_up);
  later.join();
  REQUIRE_FALSE(made);
  CHECK(made.problem().message == "the connection was given up");
}

TEST_CASE("latency: the mean times from a command to its force at the server, and to the moved atom, are printed") {
  ImdTestServer server({}, kAtoms);
  auto made = connectTo(server);
  REQUIRE(made);
  LiveSimulation& live = **made;
  using Clock = std::chrono::steady_clock;
  const auto ms = [](Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); };
  double force_ms = 0.0, moved_ms = 0.0;
  constexpr int kRounds = 100;
  for (int k = 0; k < kRounds; ++k) {
    live.command({});
    REQUIRE(imdSimulationComes([&] { return server.pushed == 0; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    const double x_A = live.newest().positions_A[0].x;
    const auto began = Clock::now();
    live.command(pull(0, {1e3, 0, 0}));
    while (server.pushed == 0) std::this_thread::sleep_for(std::chrono::microseconds(20));
    force_ms += ms(Clock::now() - began) / kRounds;
    while (live.newest().positions_A[0].x < x_A + 0.1) std::this_thread::sleep_for(std::chrono::microseconds(20));
    moved_ms += ms(Clock::now() - began) / kRounds;
  }
  MESSAGE("a frame each ms: ", force_ms, " ms to the force, ", moved_ms, " ms to the moved atom");
}
