// A process that ends while it applies a force, in every way but SIGKILL: the last force its device receives is zero.
// The stand-in for libHD.so records each force with its time (STAND_IN_FORCES).
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/device/dying.h"
#include "tests/device/omni/stand_in.h"

using namespace moltact;
using namespace moltact::test;
namespace fs = std::filesystem;

namespace {

// What the stand-in was given: forces, and whether its output was on, in the order of their times.
struct ForceLog {
  double last_N = -1;    // what drives the motors at the end
  double forced_ms = 0;  // time after the end during which a force was still present
  double peak_N = 0;
  double before_N = 0;    // what there was then
  double steepest_N = 0;  // the greatest change from then on, of forces that came within kLate_ns of each other
  int falling = 0;        // forces from then on that are smaller than the one before, and not 0
};
constexpr long long kLate_ns = 15'000'000;
ForceLog readForces(const fs::path& file, std::int64_t from_ns) {
  ForceLog out;
  std::ifstream in(file);
  long long at_ns = 0, before_ns = 0;
  std::string what;
  bool on = false;
  double force_N = 0;
  while (in >> at_ns >> what) {
    const double before_N = on ? force_N : 0.0;
    if (what == "on")
      on = true;
    else if (what == "off")
      on = false;
    else
      force_N = std::strtod(what.c_str(), nullptr);
    out.last_N = on ? force_N : 0.0;
    out.peak_N = std::max(out.peak_N, out.last_N);
    if (at_ns <= from_ns)
      out.before_N = out.last_N;
    else if (at_ns - before_ns < kLate_ns)
      out.steepest_N = std::max(out.steepest_N, std::abs(out.last_N - before_N));
    out.falling += at_ns > from_ns && out.last_N > 0.0 && out.last_N < before_N - 0.5;
    before_ns = at_ns;
    if (before_N > 0.0 && at_ns > from_ns) out.forced_ms = 1e-6 * double(at_ns - from_ns);
  }
  return out;
}

struct StandInProcess {
  StandInProcess()
      : folder(fs::temp_directory_path() / ("moltact_dying_" + std::to_string(::getpid()))), forces(folder / "forces") {
    fs::create_directories(folder);
    setenv("MOLTACT_LIBHD", MOLTACT_STAND_IN_LIBHD, 1);
    setenv("STAND_IN_LOG", (folder / "log").c_str(), 1);
    setenv("STAND_IN_FORCES", forces.c_str(), 1);
  }
  ~StandInProcess() {
    unsetenv("STAND_IN_LOG");
    unsetenv("STAND_IN_FORCES");
    std::error_code error;
    fs::remove_all(folder, error);
  }
  fs::path folder, forces;
};

}  // namespace

TEST_CASE(
    "Omni: a process that gives force and is killed by any signal that can be seen, crashes on any thread, in its tick "
    "or by a full "
    "stack, exits or throws: the last is no force, and it ends as it would have") {
  const StandInProcess omni;
  double worst_ms = 0;
  for (const WayToDie& one : kWaysToDie) {
    CAPTURE(std::string(one.way));
    CAPTURE(one.signal);
    fs::remove(omni.forces);
    Dying child("omni", one.way);
    REQUIRE(child.line(20'000) == "pressing");
    if (std::string(one.way) == "wait")
      child.send(one.signal);
    else
      child.go();
    for (int k = 0; k < 20'000 && !child.over(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK((one.signal ? child.killedBy(one.signal) : child.exitedWith(7)));
    const ForceLog log = readForces(omni.forces, child.at_ns());
    CHECK(log.peak_N > 0.3);
    CHECK(log.last_N == 0.0);
    CHECK(log.forced_ms < kBusy_ms);
    if (std::string(one.way) != "stack") worst_ms = std::max(worst_ms, log.forced_ms);  // filling it takes time
    if (std::getenv("MOLTACT_TELL_MS"))
      MESSAGE(std::string(one.way) << ' ' << one.signal << ": " << log.forced_ms << " ms");
  }
  MESSAGE(std::size(kWaysToDie) << " ways, at most " << worst_ms << " ms");
}

TEST_CASE(
    "Omni: a process that crashes, is killed or exits while no frame can be begun, in 6 ways: the output is off before "
    "it ends, and stays off") {
  const StandInProcess omni;
  const fs::path fails = omni.folder / "frames fail";
  setenv("STAND_IN_FRAMES_FAIL", fails.c_str(), 1);
  const WayToDie ways[] = {{"segv", SIGSEGV}, {"tick", SIGABRT}, {"segv elsewhere", SIGSEGV},
                           {"exit", 0},       {"wait", SIGTERM}, {"wait", SIGRTMIN}};
  for (const bool at_once : {false, true}) {
    for (const WayToDie& one : ways) {
      CAPTURE(std::string(one.way));
      CAPTURE(at_once);
      fs::remove(omni.forces);
      fs::remove(fails);
      Dying child("omni", one.way);
      REQUIRE(child.line(20'000) == "pressing");
      std::ofstream(fails).put('1');
      // Long after the first frame that fails, or in the very moment.
      for (int k = 0; !at_once && k < 2'000 && readForces(omni.forces, 0).last_N > 0.0; ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (std::string(one.way) == "wait")
        child.send(one.signal);
      else
        child.go();
      for (int k = 0; k < 20'000 && !child.over(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      CHECK((one.signal ? child.killedBy(one.signal) : child.exitedWith(7)));
      const ForceLog log = readForces(omni.forces, child.at_ns());
      CHECK(log.peak_N > 0.3);
      CHECK(log.last_N == 0.0);
    }
  }
  unsetenv("STAND_IN_FRAMES_FAIL");
}

TEST_CASE(
    "Omni: a device that is closed, and a program that is left, under 2 N or more: the force goes by no more than 1 N "
    "a tick, and the last is none") {
  const StandInProcess omni;
  for (const char* way : {"close", "leave"}) {
    CAPTURE(std::string(way));
    // If the machine stalls for 20 ms at that moment the force correctly ends at once; the run is then repeated.
    bool gently = false;
    for (int tries = 0; tries < 8 && !gently; ++tries) {
      fs::remove(omni.forces);
      Dying child("omni", way);
      REQUIRE(child.line(20'000) == "pressing");
      for (int k = 0; k < 20'000 && !child.over(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      CHECK(child.exitedWith(0));
      const ForceLog log = readForces(omni.forces, child.at_ns());
      CHECK(log.last_N == 0.0);
      CHECK(log.forced_ms < kBusy_ms);
      gently = log.before_N > 2.0 && log.steepest_N <= 1.0 + 1e-3 && log.falling >= 1;
      if (gently) MESSAGE(std::string(way) << ": from " << log.before_N << " N in " << log.forced_ms << " ms");
    }
    CHECK(gently);
  }
}

TEST_CASE(
    "Omni: a process that is stopped by Ctrl-Z gives no force while it stands, and begins softly when it continues") {
  const StandInProcess omni;
  Dying child("omni", "wait");
  REQUIRE(child.line(20'000) == "pressing");
  child.send(SIGTSTP);
  int status = 0;
  for (int k = 0; k < 5000 && ::waitpid(child.pid(), &status, WUNTRACED | WNOHANG) == 0; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  REQUIRE(WIFSTOPPED(status));
  const ForceLog stopped = readForces(omni.forces, child.at_ns());
  CHECK(stopped.peak_N > 0.3);
  CHECK(stopped.last_N == 0.0);
  CHECK(stopped.forced_ms < kBusy_ms);
  child.send(SIGCONT);
  double back_N = 0;
  for (int k = 0; k < 10'000 && back_N < 0.3; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    back_N = readForces(omni.forces, child.at_ns()).last_N;
  }
  CHECK(back_N >= 0.3);
}
