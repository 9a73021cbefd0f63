// `moltact devices` and `moltact device` as users call them.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Run {
  int status = -1;
  std::string out, err;
};

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path scratch(const char* name) {
  return fs::temp_directory_path() / ("moltact-device-" + std::to_string(::getpid()) + name);
}

Run moltact(const std::string& arguments, const std::string& before = "", const std::string& input = "</dev/null") {
  const fs::path out = scratch(".out"), err = scratch(".err");
  const int status = std::system((before + " '" MOLTACT_BINARY "' " + arguments + ' ' + input + " >'" + out.string() +
                                  "' 2>'" + err.string() + "'")
                                     .c_str());
  const Run run{WEXITSTATUS(status), contents(out), contents(err)};
  fs::remove(out);
  fs::remove(err);
  return run;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("moltact devices lists every driver, one default, and a reason for each that cannot be used") {
  const Run json = moltact("devices --json");
  REQUIRE(json.status == 0);
  const auto all = nlohmann::json::parse(json.out);
  CHECK(all.size() >= 6);
  int defaults = 0;
  for (const auto& one : all) {
    defaults += one["default"].get<bool>();
    CHECK(one["usable"].get<bool>() == one["why_not"].get<std::string>().empty());
  }
  CHECK(defaults == 1);
  CHECK(all.back()["name"] == "mouse");
  // The rotational damping: a figure of the model, of no real device.
  for (const auto& one : all) {
    const bool simulated = one["name"] == "simulated";
    CHECK(one["max_torque_N_mm"] == (simulated ? 170.0 : 0.0));
    CHECK(one["rotational_damping_N_mm_s"].is_null() != simulated);
  }
  const std::string text = moltact("devices").out;
  CHECK(contains(text, "simulated"));
  CHECK(contains(text, "torque up to 170 N mm, rotational damping 1 N mm s/rad"));
}

TEST_CASE("moltact device check passes the simulated stylus with --yes, and without an answer gives no force") {
  const Run yes = moltact("device check simulated --yes --seconds 0.6");
  CHECK(yes.status == 0);
  CHECK(contains(yes.out, "passed   wall"));
  const Run none = moltact("device check simulated --seconds 0.2");
  CHECK(none.status == 3);
  CHECK(contains(none.out, "passed   places at rest"));
  CHECK(contains(none.out, "left out gentle pull"));
  CHECK(contains(none.err, "the device's force was not checked"));
  const Run unknown = moltact("device check phantom");
  CHECK(unknown.status == 1);
  CHECK(contains(unknown.err, "these are known"));
}

// The stand-in for the maker's library, in the program's own process.
std::string standIn(const fs::path& log, const char* style = "") {
  fs::remove(log);
  return "MOLTACT_LIBHD='" MOLTACT_STAND_IN_LIBHD "' STAND_IN_LOG='" + log.string() + "' " + style;
}

TEST_CASE(
    "an Omni that is calibrated by the person: the terminal shows what to do and Enter says that it is done; then the "
    "places are checked, and without "
    "an answer nothing else is, which the exit status says") {
  const fs::path log = scratch(".log"), keys = scratch(".keys");
  std::ofstream(keys) << "\n";
  const Run run =
      moltact("device check omni --seconds 2", standIn(log, "STAND_IN_STYLE=1"), "<'" + keys.string() + "'");
  CHECK(contains(
      run.out,
      "Hold the arm in its resting place, all joints at right angles as in the maker's picture. Then press Enter."));
  CHECK_FALSE(contains(run.out, "inkwell"));
  CHECK(contains(run.out, "passed   places at rest"));
  CHECK(contains(run.out, "left out gentle pull"));
  CHECK(run.status == 3);
  CHECK(contains(contents(log), "closed, 0 N at most, 0 N at the stop, 0 errors"));
  fs::remove(log);
  fs::remove(keys);
}

// Runs it, and interrupts it when it has written `sign`.
Run interrupted(const std::string& arguments, const std::string& before, const std::string& sign) {
  const fs::path out = scratch(".out"), err = scratch(".err");
  fs::remove(out);
  const std::string command = before + " '" MOLTACT_BINARY "' " + arguments + " </dev/null >'" + out.string() +
                              "' 2>'" + err.string() + "' & pid=$!; " + "for k in $(seq 600); do grep -q '" + sign +
                              "' '" + out.string() +
                              "' 2>/dev/null && break; sleep 0.1; done; sleep 0.5; kill -INT $pid; wait $pid";
  const int status = std::system(command.c_str());
  const Run run{WEXITSTATUS(status), contents(out), contents(err)};
  fs::remove(out);
  fs::remove(err);
  return run;
}

TEST_CASE(
    "Ctrl-C in a check and in a recording: the device is closed in order, without force, and what was recorded until "
    "then is kept") {
  const fs::path log = scratch(".log"), file = scratch(".recording");
  const Run check = interrupted("device check omni --yes --seconds 600", standIn(log), "Lay the stylus down");
  CHECK(check.status == 130);
  CHECK(contains(check.out, "FAILED   places at rest: broken off"));
  CHECK(contains(check.out, "left out gentle pull"));
  CHECK(contains(check.err, "broken off; the device was closed without force"));
  CHECK(contains(contents(log), " N at most, 0 N at the stop, 0 errors"));
  const Run record =
      interrupted("device record omni 1ubq --seconds 600 --out '" + file.string() + "'", standIn(log), "Recording");
  CHECK(record.status == 0);
  CHECK(contains(contents(log), " N at most, 0 N at the stop"));
  CHECK(contains(moltact("device replay '" + file.string() + "'").out, "the same forces and torques to the last bit"));
  fs::remove(log);
  fs::remove(file);
}

TEST_CASE("moltact device check says of the mouse that it gives no force, and no figures of one") {
  const Run run = moltact("device check mouse --yes --seconds 0.2");
  CHECK(contains(run.out, "it gives no force"));
  CHECK_FALSE(contains(run.out, "for a moment"));
}
