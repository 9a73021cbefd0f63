// The IMD protocol without a socket. Oracle: the bytes of a server and the reading of a client's messages in
// imd_bytes.h, and the closed form of a spring.
#include "engine/dynamics/imd/imd_session.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "tests/dynamics/imd_bytes.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::vector<Vec3> kStart{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};  // the centre is at (1/3, 2/3, 0)

struct SessionBench {
  ImdServerBytes server;
  ImdSession session{kStart, 0.0};

  explicit SessionBench(int version = 2, bool little = true) : server{version, little} {}
  std::vector<ImdSent> sent() { return takeSent(session.toSend(), server.little); }
  void begin() {
    session.received(server.greeting(), 0.0);
    session.received(server.frame(kStart), 0.0);
    sent();
  }
  SimulationCommand grip(std::uint32_t atom, const Vec3& to_A, double stiffness) {
    SimulationCommand out;
    out.pushes.push_back({atom, to_A, Vec3(0.0), stiffness});
    return out;
  }
};

}  // namespace

TEST_CASE("version 3 says whether the server wraps its atoms into the box; version 2 does not") {
  for (const auto& [version, wrapped, says] :
       {std::tuple(2, true, false), std::tuple(3, false, false), std::tuple(3, true, true)}) {
    SessionBench b(version);
    b.server.wrapped = wrapped;
    b.begin();
    CHECK(b.session.frame().wrapped == says);
  }
}

TEST_CASE(
    "both versions in both byte orders: the client answers GO, no forces and a rate of 10 steps; positions arrive to "
    "1e-6 A, moved so that the centre of the first ones is the molecule's") {
  for (const int version : {2, 3})
    for (const bool little : {true, false}) {
      SessionBench b(version, little);
      CAPTURE(version);
      CAPTURE(little);
      b.session.received(b.server.greeting(), 0.0);
      CHECK(wordsOf(b.sent()) == "3:0 6:0 8:10");
      std::vector<Vec3> far = kStart;
      for (Vec3& v : far) v += Vec3(100, -200, 300);
      b.session.received(b.server.frame(far), 0.1);
      far[1].x += 0.5;
      b.session.received(b.server.frame(far, 4.0), 0.2);
      const SimulationFrame& frame = b.session.frame();
      CHECK(frame.serial == 2);
      CHECK(frame.starts == 1);
      CHECK(glm::distance(frame.positions_A[0], kStart[0]) < 1e-6);
      CHECK(glm::distance(frame.positions_A[1], kStart[1] + Vec3(0.5, 0, 0)) < 1e-6);
      CHECK(frame.has_time == (version == 3));
      CHECK(frame.has_energy == (version == 3));
      if (version == 2) continue;
      CHECK(frame.time_ps == doctest::Approx(4.0));
      CHECK(frame.energies.temperature_K == doctest::Approx(300.0));
      CHECK(frame.energies.potential_kcal_mol == doctest::Approx(-10.0));
    }
}

TEST_CASE("200 streams cut into pieces of 1 to 40 bytes give the same positions as whole ones") {
  std::mt19937 random(11);
  MESSAGE("seed 11");
  for (int round = 0; round < 200; ++round) {
    SessionBench whole(2 + round % 2, round % 3 > 0), cut(2 + round % 2, round % 3 > 0);
    Bytes bytes = whole.server.greeting();
    for (int k = 0; k < 5; ++k) {
      std::vector<Vec3> at = kStart;
      for (Vec3& v : at) v += Vec3(0.001 * double(random() % 1000), 0, 0);
      const Bytes frame = whole.server.frame(at, k);
      bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    whole.session.received(bytes, 0.0);
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t some = std::min<std::size_t>(1 + random() % 40, bytes.size() - at);
      cut.session.received(std::span(bytes).subspan(at, some), 0.0);
      at += some;
    }
    REQUIRE(whole.session.frame().serial == 5);
    CHECK(cut.session.frame().serial == 5);
    CHECK(cut.session.frame().positions_A == whole.session.frame().positions_A);
  }
}

TEST_CASE(
    "a spring of 2 kcal/mol/A^2 over 3 A is 6 kcal/mol/A, 25.1 kJ/mol/A in version 3, follows the atom with each "
    "frame, "
    "and is never more than 28.8; two springs on an atom are one force; an atom beyond the last is never named") {
  for (const int version : {2, 3}) {
    const double unit = version == 3 ? 4.184 : 1.0;
    SessionBench b(version, version == 2);
    CAPTURE(version);
    b.begin();
    b.session.command(b.grip(1, {4, 0, 0}, 2.0), 0.0);
    CHECK(b.sent().empty());  // until the next positions
    b.session.received(b.server.frame(kStart), 0.01);
    std::vector<ImdSent> sent = b.sent();
    REQUIRE(wordsOf(sent) == "6:1");
    CHECK(sent[0].atoms[0] == 1);
    CHECK(sent[0].forces[0].x == doctest::Approx(6.0 * unit));
    CHECK(sent[0].forces[0].y == doctest::Approx(0.0));
    std::vector<Vec3> at = kStart;
    at[1].x = 3.0;
    b.session.received(b.server.frame(at), 0.02);
    sent = b.sent();
    CHECK(sent[0].forces[0].x == doctest::Approx(2.0 * unit));
    b.session.command(b.grip(1, {400, 0, 0}, 2.0), 0.03);
    b.session.received(b.server.frame(at), 0.04);
    CHECK(b.sent()[0].forces[0].x == doctest::Approx(28.8 * unit));
    SimulationCommand two = b.grip(0, {0, 1, 0}, 2.0);
    two.pushes.push_back({0, Vec3(0, 0, 1), Vec3(0.0), 3.0});
    two.pushes.push_back({3, Vec3(0, 0, 1), Vec3(0.0), 3.0});
    two.pushes.push_back({4'000'000'000u, Vec3(0, 0, 1), Vec3(0.0), 3.0});
    b.session.command(two, 0.05);
    b.session.received(b.server.frame(kStart), 0.06);
    sent = b.sent();
    REQUIRE(wordsOf(sent) == "6:1");
    CHECK(sent[0].atoms[0] == 0);
    CHECK(glm::distance(sent[0].forces[0], unit * Vec3(0, 2, 3)) < 1e-5);
    SimulationCommand nowhere = b.grip(0, Vec3(std::nan("")), 1.0);
    b.session.command(nowhere, 0.07);
    b.session.received(b.server.frame(kStart), 0.08);
    CHECK(wordsOf(b.sent()) == "6:0");
  }
}

TEST_CASE(
    "a contact pushes in its direction only until the atom has given way: 3 kcal/mol/A, 1.5 after half the way, then "
    "none") {
  SessionBench b;
  b.begin();
  SimulationCommand wanted;
  wanted.pushes.push_back(pushOf(0, {0, 0, 0}, {0, 0, 3}, 1.5));
  b.session.command(wanted, 0.0);
  for (const auto& [z, force] : {std::pair(0.0, 3.0), std::pair(1.0, 1.5)}) {
    std::vector<Vec3> at = kStart;
    at[0].z = z;
    b.session.received(b.server.frame(at), 0.01);
    const std::vector<ImdSent> sent = b.sent();
    REQUIRE(sent.size() == 1);
    CHECK(sent[0].forces[0].z == doctest::Approx(force));
  }
  std::vector<Vec3> at = kStart;
  at[0].z = 2.5;
  b.session.received(b.server.frame(at), 0.02);
  CHECK(wordsOf(b.sent()) == "6:0");
}

TEST_CASE(
    "forces end at once when the hand lets go or pauses, after 0.5 s without a command and after 1 s without "
    "positions, by one message of length 0 each time; positions after the silence count as a new start") {
  for (const std::string how : {"let go", "pause", "no command", "silence"}) {
    SessionBench b;
    CAPTURE(how);
    b.begin();
    const SimulationCommand pull = b.grip(1, {4, 0, 0}, 2.0);
    b.session.command(pull, 0.0);
    b.session.received(b.server.frame(kStart), 0.0);
    CHECK(wordsOf(b.sent()) == "6:1");
    SimulationCommand wanted;
    if (how == "let go") {
      b.session.command(wanted, 0.01);
      CHECK(wordsOf(b.sent()) == "6:0");
      b.session.command(wanted, 0.02);
    } else if (how == "pause") {
      wanted = pull;
      wanted.running = false;
      b.session.command(wanted, 0.01);
      CHECK(wordsOf(b.sent()) == "6:0 7:0");
      b.session.received(b.server.frame(kStart), 0.02);  // on the way
      b.session.command(wanted, 30.0);
      b.session.passed(30.0);  // a pause may last
      CHECK(b.sent().empty());
      CHECK_FALSE(b.session.frame().silent);
      wanted.running = true;
      wanted.pushes.clear();
      b.session.command(wanted, 30.1);
      CHECK(wordsOf(b.sent()) == "7:0");
    } else if (how == "no command") {
      b.session.passed(0.49);
      CHECK(b.sent().empty());
      b.session.passed(0.51);
      CHECK(wordsOf(b.sent()) == "6:0");
      b.session.received(b.server.frame(kStart), 0.52);
    } else {
      b.session.command(pull, 0.9);
      b.session.passed(0.99);
      CHECK(b.sent().empty());
      CHECK_FALSE(b.session.frame().silent);
      b.session.command(pull, 1.0);
      b.session.passed(1.01);
      CHECK(wordsOf(b.sent()) == "6:0");
      CHECK(b.session.frame().silent);
      b.session.received(b.server.frame(kStart), 1.5);
      CHECK_FALSE(b.session.frame().silent);
      CHECK(b.session.frame().starts == 2);
    }
    b.session.passed(1.0);
    CHECK(b.sent().empty());
  }
}

TEST_CASE(
    "what no server may send ends the session with a sentence; its last messages end the forces and disconnect, and "
    "before a handshake nothing is sent") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto tail = [](const ImdServerBytes& server, Bytes bytes) {
    Bytes out = server.greeting();
    out.insert(out.end(), bytes.begin(), bytes.end());
    return out;
  };
  const ImdServerBytes two, three{3, true};
  Bytes old, blind = three.greeting();
  ImdServerBytes::append(old, std::int32_t(4), false);
  ImdServerBytes::append(old, std::int32_t(1), true);
  blind[8 + 8 + 3] = 0;
  const std::string http = "HTTP/1.0 400 Bad Request\r\n\r\n";
  struct Case {
    Bytes bytes;
    std::string says;
    bool greeted;
  };
  const std::vector<Vec3> four(4), nowhere{{0, 0, 0}, {0, nan, 0}, {0, 0, 0}}, far{{0, 0, 0}, {0, 0, 0}, {0, 2e6, 0}};
  const std::vector<Case> cases{
      {{http.begin(), http.end()}, "does not speak IMD", false},
      {old, "a version of IMD", false},
      {blind, "send no positions", false},
      {tail(ImdServerBytes{3, true}, {}), "", true},
      {tail(two, ImdServerBytes::header(2, 0x7fffffff)), "sends 2147483647 atoms, and the molecule has 3", true},
      {tail(two, ImdServerBytes::header(2, -1)), "sends -1 atoms", true},
      {tail(two, ImdServerBytes::header(1, 500'000'000)), "type 1 with the length 500000000", true},
      {tail(three, ImdServerBytes::header(14, 0x7fffffff)), "atoms", true},
      {tail(two, ImdServerBytes::header(99, 1)), "unknown type 99", true},
      {tail(two, two.places(four)), "sends 4 atoms, and the molecule has 3", true},
      {tail(two, two.places(nowhere)), "an impossible position of atom 2", true},
      {tail(two, two.places(far)), "an impossible position of atom 3", true},
      {tail(two, ImdServerBytes::header(0, 0)), "has ended the session", true},
  };
  for (const Case& c : cases) {
    CAPTURE(c.says);
    ImdSession session(kStart, 0.0);
    session.received(c.bytes, 0.0);
    const std::string words = wordsOf(takeSent(session.toSend()));
    if (c.says.empty()) {
      CHECK_FALSE(session.ended());
      CHECK(words == "3:0 6:0 8:10");
      continue;
    }
    REQUIRE(session.problem());
    CHECK_MESSAGE(session.problem()->text().find(c.says) != std::string::npos, session.problem()->text());
    CHECK_FALSE(session.problem()->remedy.empty());
    CHECK(session.frame().dead);
    CHECK(words == (c.greeted ? "3:0 6:0 8:10 6:0 0:0" : ""));
    session.received(c.bytes, 1.0);
    session.passed(100.0);
    session.leave();
    CHECK(session.toSend().empty());
  }
}

TEST_CASE(
    "no answer for 10 s, positions that stop for 20 s and a lost connection end the session; leaving ends the forces, "
    "resumes what was paused, and disconnects") {
  for (const bool greeted : {false, true}) {
    ImdSession session(kStart, 0.0);
    if (greeted) session.received(ImdServerBytes().greeting(), 0.0);
    session.passed(9.9);
    CHECK_FALSE(session.ended());
    session.passed(10.1);
    REQUIRE(session.problem());
    CHECK(session.problem()->message ==
          (greeted ? "the server sends no positions" : "what listens there does not answer as IMD servers do"));
  }
  SessionBench silent, lost, paused, left;
  silent.begin();
  silent.session.passed(19.9);
  CHECK_FALSE(silent.session.ended());
  silent.session.passed(20.1);
  CHECK(silent.session.problem()->message == "the server has sent nothing for 20 s");
  CHECK(wordsOf(silent.sent()) == "6:0 0:0");
  lost.begin();
  lost.session.lost();
  CHECK(lost.session.problem()->message == "the connection to the server is lost");
  CHECK(lost.session.frame().dead);
  CHECK(lost.sent().empty());
  for (const int version : {2, 3}) {
    SessionBench b(version);
    b.begin();
    CHECK(b.session.lastWords().size() == 16);
    SimulationCommand rests;
    rests.running = false;
    b.session.command(rests, 0.0);
    b.sent();
    b.session.leave();
    CHECK(wordsOf(b.sent()) == (version == 2 ? "6:0 7:0 0:0" : "6:0 11:0 0:0"));
    CHECK_FALSE(b.session.problem());
    CHECK(b.session.lastWords().empty());
  }
  left.session.leave();
  CHECK(left.session.toSend().empty());
}

TEST_CASE(
    "an atom that moves by 11 A from one frame to the next counts as a new start, one that moves by 9 A does not") {
  SessionBench b;
  b.begin();
  std::vector<Vec3> at = kStart;
  at[2].y += 9.0;
  b.session.received(b.server.frame(at), 0.0);
  CHECK(b.session.frame().starts == 1);
  at[2].y -= 11.0;
  b.session.received(b.server.frame(at), 0.0);
  CHECK(b.session.frame().starts == 2);
}
