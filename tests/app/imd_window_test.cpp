// A molecule that another program simulates, in the window: connected, pushed, lost, asked for. The server is that of
// tests/dynamics/imd_test_server.h.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/live_molecule.h"
#include "tests/app/small_window.h"
#include "tests/dynamics/imd_test_server.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using test::ImdFault;
using test::ImdTestServer;

// The places in molecules/argon-triangle.pdb do not matter: the window shifts the server's to them.
const std::vector<Vec3> kAtomsAtServer{{100, 0, 0}, {103.8, 0, 0}, {101.9, 3.29, 0}};

ScriptedUser::Options windowFor(const std::string& imd) {
  ScriptedUser::Options options = smallWindow();
  options.application.simulation = imd;
  return options;
}

std::string addressOf(const ImdTestServer& server) { return "imd://127.0.0.1:" + std::to_string(server.port()); }

LiveMolecule& liveIn(ScriptedUser& user) { return user.app().extensions().movers.get<LiveMolecule>(); }

// Frames until something happens, at most a minute of them.
template <class Done>
bool becomes(ScriptedUser& user, Done done) {
  for (int k = 0; k < 20'000 && !done(); ++k) {
    user.frames(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return done();
}

std::string lessonAt(const std::string& address) {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: argon-triangle\nauthor: A\nlicence: L\n---\n## One\n"
         "```scene\nmolecule: argon-triangle\nsimulation: " +
         address + "\n```\n\n> [!TIP]\n> Look.\n";
}

}  // namespace

TEST_CASE(
    "the molecule of the command line connects by itself; a press pushes the server's atoms; when the server hangs up "
    "during the press the force is 0 in the frame that says so, the atoms are back, and the user can connect again") {
  for (const ImdFault fault :
       {ImdFault::HangsUp, ImdFault::CutsFrame, ImdFault::Resets, ImdFault::Disconnects, ImdFault::Garbage,
        ImdFault::NotANumber, ImdFault::TooManyAtoms, ImdFault::TwoGigabytes}) {
    CAPTURE(int(fault));
    ImdTestServer server({}, kAtomsAtServer);
    const auto user = startWith("argon-triangle", windowFor(addressOf(server)));
    LiveMolecule& live = liveIn(*user);
    REQUIRE_MESSAGE(live.ready(), live.problem());
    CHECK_FALSE(live.obeysAll());
    user->point("view", 0.5, 0.5);
    user->press();
    CHECK(becomes(*user, [&] { return server.pushed > 0 && user->app().scene.log().shownForce_N() > 0.1; }));
    server.frames_before_fault = 0;
    server.fault = fault;
    for (int k = 0; k < 20'000 && live.ready(); ++k) {
      user->frames(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE_FALSE(live.ready());
    CHECK(user->app().scene.log().shownForce_N() == 0.0);
    CHECK(user->app().scene.pull().atoms().empty());
    CHECK_FALSE(live.problem().empty());
    CHECK(user->app().messages.all().back().text == live.problem());
    const SharedArray<Sphere>& rest = user->app().scene.atoms().resting().spheres->spheres();
    const SharedArray<Sphere>& now = user->app().scene.atoms().seen()->spheres;
    CHECK(std::equal(rest.begin(), rest.end(), now.begin(),
                     [](const Sphere& a, const Sphere& b) { return a.centre_A == b.centre_A; }));
    user->release();
    server.fault = ImdFault::None;
    live.connect();
    CHECK_MESSAGE(becomes(*user, [&] { return live.ready(); }), live.problem());
    live.end();
    CHECK(becomes(*user, [&] { return server.gone == server.clients; }));
    CHECK(server.forceEnded());
    CHECK(server.disconnected());
  }
}

TEST_CASE("a server of version 3 that wraps its atoms is named with the remedy, once; one that does not is not") {
  for (const bool wrapped : {true, false}) {
    ImdTestServer server({3, true, wrapped}, kAtomsAtServer);
    const auto user = startWith("argon-triangle", windowFor(addressOf(server)));
    REQUIRE_MESSAGE(liveIn(*user).ready(), liveIn(*user).problem());
    CHECK(becomes(*user, [&] { return liveIn(*user).frame().serial > 20; }));
    int said = 0;
    for (const auto& message : user->app().messages.all()) said += contains(message.text, "LAMMPS: 'unwrap on'");
    CHECK(said == (wrapped ? 1 : 0));
  }
}

TEST_CASE("a server that stalls while the hand presses: the force on the hand ends, and comes again with the server") {
  ImdTestServer server({3, true}, kAtomsAtServer);
  const auto user = startWith("argon-triangle", windowFor(addressOf(server)));
  LiveMolecule& live = liveIn(*user);
  REQUIRE_MESSAGE(live.ready(), live.problem());
  user->point("view", 0.5, 0.5);
  user->press();
  CHECK(becomes(*user, [&] { return user->app().scene.log().shownForce_N() > 0.1; }));
  server.frames_before_fault = 0;
  server.fault = ImdFault::Stalls;
  for (int k = 0; k < 20'000 && !live.frame().silent; ++k) {
    user->frames(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(user->app().scene.log().shownForce_N() == 0.0);
  CHECK(live.ready());
  server.fault = ImdFault::None;
  CHECK(becomes(*user, [&] { return !live.frame().silent; }));
  CHECK(live.frame().has_energy);
}

TEST_CASE(
    "a lesson with an address on this computer connects; one elsewhere connects to nothing until the button that names "
    "it is pressed, and ends with the lesson") {
  const ScratchFolder scratch;
  {
    ImdTestServer server({}, kAtomsAtServer);
    writeFile(scratch.path / "here.md", lessonAt(addressOf(server)));
    const auto user = startWith((scratch.path / "here.md").string(), windowFor({}));
    CHECK_MESSAGE(liveIn(*user).ready(), liveIn(*user).problem());
    user->app().open("benzene");
    user->app().finishLoading();
    user->frames(5);
    CHECK_FALSE(liveIn(*user).on());
    CHECK(becomes(*user, [&] { return server.gone == 1; }));
  }
  // An address that no network routes (RFC 5737).
  writeFile(scratch.path / "there.md", lessonAt("imd://192.0.2.1:8888"));
  const auto user = startWith((scratch.path / "there.md").string(), windowFor({}));
  LiveMolecule& live = liveIn(*user);
  CHECK(live.asks());
  CHECK_FALSE(live.ready());
  CHECK_FALSE(live.opening());
  user->frames(60);
  CHECK(live.asks());
  CHECK(contains(user->app().messages.all().back().text, "192.0.2.1:8888"));
  user->app().panels.tabs.open("motion");
  user->frames(3);
  CHECK(user->shows("simulation/connect"));
}

TEST_CASE("no server, and the structure of another molecule: the window says so with the address") {
  {
    const auto user = startWith("argon-triangle", windowFor("imd://127.0.0.1:1"));
    CHECK_FALSE(liveIn(*user).ready());
    CHECK(contains(liveIn(*user).problem(), "there is no connection to 127.0.0.1:1"));
  }
  ImdTestServer server({}, kAtomsAtServer);
  const auto user = startWith("benzene", windowFor(addressOf(server)));
  CHECK_FALSE(liveIn(*user).ready());
  CHECK(contains(liveIn(*user).problem(), "the server sends 3 atoms, and the molecule has 12"));
}

}  // namespace moltact
