// The headless commands as users call them: their output, their errors, the exit status.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, removed at its end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("moltact-commands-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Run {
  int status = -1;
  std::string out, err;
};

// `before` is shell text in front of the program, such as a limit.
Run moltact(const Folder& folder, const std::string& arguments, const std::string& before = "") {
  const std::string out = folder / "stdout", err = folder / "stderr";
  const int status =
      std::system((before + "'" MOLTACT_BINARY "' " + arguments + " >'" + out + "' 2>'" + err + "'").c_str());
  return {WEXITSTATUS(status), contents(out), contents(err)};
}

std::vector<std::vector<std::string>> rows(const std::string& csv) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    all.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) all.back().push_back(field);
  }
  return all;
}

}  // namespace

TEST_CASE("a --content-scale that is no number or out of range ends with status 2 and the range") {
  Folder folder;
  for (const char* scale : {"nan", "inf", "0", "-1", "9"}) {
    const Run run = moltact(folder, "--screenshot '" + (folder / "a.png") + "' --content-scale " + scale);
    CAPTURE(scale);
    CHECK(run.status == 2);
    CHECK(run.err.find("0.5 to 8") != std::string::npos);
  }
}

namespace {

// One carbon-like sphere of 1.6 A at the origin; with the probe's 1.4 A the surface lies at 3 A.
constexpr const char* kOneSphere = "0 0 0 1.6\n";

}  // namespace

TEST_CASE(
    "replay on one ball of 3 A writes the SCP 3 A from the centre, 17 digits that read back the same, and k (SCP - "
    "HIP)") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  write(folder / "hip.csv", "x,y,z\n0,0,5\n0,0.3,2.5\n0.1,0.3,2.4\n0,0,7\n");
  const Run run = moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") +
                                      "' --out '" + (folder / "trace.csv") + "' --stiffness 2");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = contents(folder / "trace.csv");
  CHECK(text.starts_with(
      "tick,hip_x,hip_y,hip_z,contact,scp_x,scp_y,scp_z,force_x,force_y,force_z,feature,atom1,atom2,atom3\n"));
  const auto trace = rows(text);
  REQUIRE(trace.size() == 5);
  CHECK(trace[1][4] == "0");
  CHECK(trace[1][11] == "free");
  CHECK(trace[1][12] == "-1");
  CHECK(trace[2][0] == "1");
  CHECK(trace[2][4] == "1");
  CHECK(trace[2][11] == "sphere");
  CHECK(trace[2][12] == "0");
  const double y = std::stod(trace[2][6]), z = std::stod(trace[2][7]);
  CHECK(y * y + z * z == doctest::Approx(9.0).epsilon(1e-14));
  CHECK(std::stod(trace[2][10]) == doctest::Approx(2.0 * (z - 2.5)).epsilon(1e-12));
  CHECK(std::stod(trace[3][1]) == 0.1);
  CHECK(trace[4][4] == "0");
}

TEST_CASE(
    "replay --time prints one JSON object with ticks, contact_ticks and mean, p50, p99, p99.99, max for free and "
    "contact") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  std::string path = "x,y,z\n";
  for (int k = 0; k < 2000; ++k) path += "0,0," + std::to_string(5.0 - 0.0015 * k) + "\n";
  write(folder / "hip.csv", path);
  const Run run =
      moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") + "' --time");
  REQUIRE(run.status == 0);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["ticks"] == 2000);
  CHECK(json["contact_ticks"] == 2000 - 1334);  // the surface is reached at tick 1333.3
  CHECK(json["measured"] == "each tick's least of three passes, less the clock's own cost");
  for (const char* state : {"free", "contact"})
    for (const char* figure : {"mean", "p50", "p99", "p99.99", "max"}) CHECK(json[state][figure].is_number());
}

TEST_CASE("replay says on stderr that the HIP starts inside and that a place was not a number; both give no force") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  write(folder / "hip.csv", "x,y,z\n0,0,1\n0,0,1.1\n0,0,4\n0,0,2.5\nnan,0,0\n0,0,2.4\n");
  const Run run = moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") +
                                      "' --out '" + (folder / "t.csv") + "'");
  REQUIRE(run.status == 0);
  CHECK(run.err.find("starts inside the molecule: no force for the first 2 ticks") != std::string::npos);
  CHECK(run.err.find("1 places were not finite") != std::string::npos);
  const auto trace = rows(contents(folder / "t.csv"));
  for (const std::size_t quiet : {1u, 2u, 3u, 5u}) {
    CHECK(trace[quiet][4] == "0");
    CHECK(trace[quiet][10] == "0");
  }
  CHECK(trace[4][4] == "1");
  CHECK(trace[6][4] == "1");
}

TEST_CASE("a broken path file ends with 1 and names file, line, column and what would mend it") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  const struct {
    const char* text;
    const char* place;
    const char* says;
  } cases[] = {
      {"", "", "there is no row in this file"},
      {"0,0,1\n", ":1:1:", "the first line is not the header x,y,z"},
      {"x,y,z\n0,0,1\n0,zero,1\n", ":3:3:", "a number was expected here"},
      {"x,y,z\n0,0\n", ":2:4:", "a comma was expected here"},
      {"x,y,z\n0,0,1,2\n", ":2:6:", "there is more than x,y,z in this row"},
      {"x,y,z\n0,0,1e999\n", ":2:5:", "too large or too small"},
  };
  for (const auto& one : cases) {
    write(folder / "hip.csv", one.text);
    const Run run = moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") +
                                        "' --out '" + (folder / "t.csv") + "'");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.out.empty());
    CHECK(run.err.find((folder / "hip.csv") + one.place) != std::string::npos);
    CHECK(run.err.find(one.says) != std::string::npos);
    CHECK(run.err.find("; ") != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "t.csv"));
  }
}

TEST_CASE("a path file that is a device, a pipe, a folder or larger than 1 GiB is refused at once, with a remedy") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  write(folder / "large.csv", "x,y,z\n");
  fs::resize_file(folder / "large.csv", (std::uintmax_t{1} << 30) + 1);
  const struct {
    std::string path;
    const char* says;
  } cases[] = {
      {"/dev/zero", "it is not an ordinary file; copy the data into one"},
      {folder / "pipe", "it is not an ordinary file; copy the data into one"},
      {folder.path.string(), "it is a folder; name a file in it"},
      {folder / "large.csv", "it is larger than 1024 MiB; split it into shorter paths"},
      {folder / "none.csv", "there is no such file; check the name and the folder"},
  };
  for (const auto& one : cases) {
    // A pipe that is read would block for ever.
    const Run run =
        moltact(folder, "replay '" + (folder / "one.xyzr") + "' --time --path '" + one.path + "'", "timeout 60 ");
    CHECK(run.status == 1);
    CHECK(run.err == "moltact: " + one.path + ": " + one.says + "\n");
  }
}

// The sanitizers reserve more address space than any limit here.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE(
    "1000 MiB under a limit of 900 MiB end with 1: a path for want of memory, a molecule at its first line, which is "
    "too long") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  for (const char* name : {"large.pdb", "large.csv"}) {
    write(folder / name, "");
    fs::resize_file(folder / name, std::uintmax_t{1000} << 20);
  }
  const std::string limit = "ulimit -c 0; ulimit -v 921600; ";
  const Run info = moltact(folder, "info '" + (folder / "large.pdb") + "'", limit);
  CHECK(info.status == 1);
  CHECK(info.err.starts_with("moltact: " + (folder / "large.pdb") + ":1: the line is longer than 16 MiB"));
  const Run replay =
      moltact(folder, "replay '" + (folder / "one.xyzr") + "' --time --path '" + (folder / "large.csv") + "'", limit);
  CHECK(replay.status == 1);
  CHECK(replay.err == "moltact: not enough memory for this; close other programs, or take a smaller file\n");
}
#endif

TEST_CASE("a path file may begin with a byte order mark and have blanks around its fields and plus signs") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  const auto trace = [&](const std::string& text) {
    write(folder / "hip.csv", text);
    const Run run = moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") +
                                        "' --out '" + (folder / "t.csv") + "'");
    CAPTURE(run.err);
    CHECK(run.status == 0);
    return contents(folder / "t.csv");
  };
  const std::string plain = trace("x,y,z\n0,1,5\n0,-2.5,1\n");
  CHECK(trace("\xEF\xBB\xBFx,y,z\n0,1,5\n0,-2.5,1\n") == plain);
  CHECK(trace(" x, y,\tz \r\n0, 1 ,5\r\n\t0,\t-2.5, 1\r\n") == plain);
  CHECK(trace("x,y,z\n+0,+1,+5.0\n0,-2.5,+1e0\n") == plain);
  for (const char* row : {"+,1,2", "+-1,1,2", "++1,1,2", "+ 1,1,2"}) {
    write(folder / "hip.csv", std::string("x,y,z\n") + row + "\n");
    const Run run =
        moltact(folder, "replay '" + (folder / "one.xyzr") + "' --path '" + (folder / "hip.csv") + "' --time");
    CAPTURE(row);
    CHECK(run.status == 1);
    CHECK(run.err.find("a number was expected here") != std::string::npos);
  }
}

TEST_CASE("options that are NaN, infinite or out of range end with 2 and name the range") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  write(folder / "hip.csv", "x,y,z\n0,0,5\n");
  const std::string one = " '" + (folder / "one.xyzr") + "' ";
  const std::string replay = "replay" + one + "--time --path '" + (folder / "hip.csv") + "' ";
  const std::string render = "render" + one + "--out '" + (folder / "x.png") + "' ";
  const struct {
    std::string command;
    const char* option;
    const char* value;
    const char* range;
  } cases[] = {
      {replay, "--probe", "nan", "0 to 20"},         {replay, "--probe", "-0.1", "0 to 20"},
      {replay, "--probe", "wide", "0 to 20"},        {replay, "--stiffness", "nan", "0 to 1e+06"},
      {replay, "--stiffness", "inf", "0 to 1e+06"},  {render, "--probe", "-nan", "0 to 20"},
      {render, "--stiffness", "nan", "0 to 1e+06"},  {render, "--zoom", "nan", "0.01 to 1000"},
      {render, "--zoom", "0", "0.01 to 1000"},       {render, "--azimuth", "nan", "-360 to 360"},
      {render, "--azimuth", "1e300", "-360 to 360"}, {render, "--elevation", "nan", "-360 to 360"},
  };
  for (const auto& c : cases) {
    const Run run = moltact(folder, c.command + c.option + "=" + c.value);
    CAPTURE(c.option);
    CAPTURE(c.value);
    CHECK(run.status == 2);
    CHECK(run.err.find(std::string("'") + c.value + "' is not a number from " + c.range) != std::string::npos);
  }
  CHECK_FALSE(fs::exists(folder / "x.png"));
  CHECK(moltact(folder, replay + "--probe +1.5e0 --stiffness 1e6").status == 0);
  for (const char* model : {"0", "-1", "100001", "nan"}) {
    const Run run = moltact(folder, "info" + one + "--model=" + model);
    CHECK(run.status == 2);
    CHECK(run.err.size() < 200);
  }
}

TEST_CASE(
    "wrong usage ends with 2, a missing molecule or an unwritable trace with 1, --help with 0 for every command") {
  const Folder folder;
  write(folder / "one.xyzr", kOneSphere);
  write(folder / "hip.csv", "x,y,z\n0,0,5\n");
  const std::string path = " --path '" + (folder / "hip.csv") + "'", one = "'" + (folder / "one.xyzr") + "'";
  CHECK(moltact(folder, "replay").status == 2);
  CHECK(moltact(folder, "replay " + one + path).status == 2);
  CHECK(moltact(folder, "replay " + one + path + " --out x.csv --method magic").status == 2);
  CHECK(moltact(folder, "replay " + one + path + " --out x.csv --probe 21").status == 2);
  CHECK(moltact(folder, "no-such-command --flag").status == 2);
  CHECK(moltact(folder, "replay /no/such/file.pdb" + path + " --out x.csv").status == 1);
  CHECK(moltact(folder, "replay " + one + path + " --out /no/such/folder/x.csv").status == 1);
  CHECK(moltact(folder, "info " + (folder.path.string())).status == 1);
  for (const char* command : {"", "info", "replay", "render", "fetch"}) {
    const Run help = moltact(folder, std::string(command) + " --help");
    CHECK(help.status == 0);
    CHECK(help.out.find("Usage") != std::string::npos);
  }
}

TEST_CASE("the window's command without a display ends with 1 and names the commands that need none") {
  const Folder folder;
  const std::string out = folder / "o", err = folder / "e";
  const int status =
      std::system(("env -u DISPLAY -u WAYLAND_DISPLAY '" MOLTACT_BINARY "' >'" + out + "' 2>'" + err + "'").c_str());
  CHECK(WEXITSTATUS(status) == 1);
  const std::string text = contents(err);
  for (const char* command : {"info", "render", "check", "play", "report", "bench"})
    CHECK(text.find(command) != std::string::npos);
}

TEST_CASE("info counts 602 atoms of ubiquitin, as text and as JSON") {
  const Folder folder;
  CHECK(moltact(folder, "info 1ubq").out.find("602") != std::string::npos);
  CHECK(nlohmann::json::parse(moltact(folder, "info 1ubq --json").out)["atoms"] == 602);
}
