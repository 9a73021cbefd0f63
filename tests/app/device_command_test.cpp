// `moltact devices` and `moltact device` as a person calls them.
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

fs::path scratch(const char* name) { return fs::temp_directory_path() / ("moltact-device-" + std::to_string(::getpid()) + name); }

Run moltact(const std::string& arguments) {
  const fs::path out = scratch(".out"), err = scratch(".err");
  const int status = std::system(("'" MOLTACT_BINARY "' " + arguments + " </dev/null >'" + out.string() + "' 2>'" + err.string() + "'").c_str());
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
  CHECK(contains(moltact("devices").out, "simulated"));
}

TEST_CASE("moltact device check passes the simulated stylus with --yes, and without an answer gives no force") {
  const Run yes = moltact("device check simulated --yes --seconds 0.6");
  CHECK(yes.status == 0);
  CHECK(contains(yes.out, "passed   wall"));
  const Run none = moltact("device check simulated --seconds 0.2");
  CHECK(none.status == 0);
  CHECK(contains(none.out, "left out gentle pull"));
  const Run unknown = moltact("device check phantom");
  CHECK(unknown.status == 1);
  CHECK(contains(unknown.err, "these are known"));
}

TEST_CASE("moltact device check says of the mouse that it gives no force, and no figures of one") {
  const Run run = moltact("device check mouse --yes --seconds 0.2");
  CHECK(contains(run.out, "it gives no force"));
  CHECK_FALSE(contains(run.out, "for a moment"));
}
