// The headless commands as users call them: their output, their errors, the exit status.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
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
    "replay on one sphere of 3 A writes the SCP 3 A from the centre, 17 digits that read back the same, and k (SCP - "
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
    "replay leads a body of one atom as it leads a probe of the same radius: place, force and contact agree to 1e-9, "
    "its "
    "torque is nothing, and its quaternion comes back normalised") {
  const Folder folder;
  write(folder / "scene.csv", "x,y,z,r\n0,0,0,1.6\n2.2,0.5,0,1.5\n");
  write(folder / "scene.xyzr", "0 0 0 1.6\n2.2 0.5 0 1.5\n");
  write(folder / "body.csv", "x,y,z,r\n0,0,0,1.4\n");
  std::string path = "x,y,z\n", turned = "x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k < 400; ++k) {
    const std::string place = std::to_string(0.01 * k - 1.0) + "," + std::to_string(0.2 + 0.001 * k) + "," +
                              std::to_string(4.0 - 0.006 * std::min(k, 300));
    path += place + "\n";
    // The quaternion has length 2; the program normalizes it.
    turned += place + "," + std::to_string(2.0 * std::cos(0.005 * k)) + ",0,0," +
              std::to_string(2.0 * std::sin(0.005 * k)) + "\n";
  }
  write(folder / "hip.csv", path);
  write(folder / "pose.csv", turned);
  REQUIRE(moltact(folder, "replay '" + (folder / "scene.xyzr") + "' --path '" + (folder / "hip.csv") +
                              "' --probe 1.4 --stiffness 2 --out '" + (folder / "probe.csv") + "'")
              .status == 0);
  const Run run = moltact(folder, "replay --from-spheres '" + (folder / "scene.csv") + "' '" + (folder / "body.csv") +
                                      "' --path '" + (folder / "pose.csv") + "' --stiffness 2 --out '" +
                                      (folder / "bodied.csv") + "'");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = contents(folder / "bodied.csv");
  CHECK(text.starts_with(
      "hand_x,hand_y,hand_z,hand_qw,hand_qx,hand_qy,hand_qz,body_x,body_y,body_z,body_qw,body_qx,body_qy,"
      "body_qz,force_x_N,force_y_N,force_z_N,torque_x_NA,torque_y_NA,torque_z_NA,at_rest\n"));
  const auto probe = rows(contents(folder / "probe.csv")), body = rows(text);
  REQUIRE(probe.size() == 401);
  REQUIRE(body.size() == 401);
  std::size_t touched = 0;
  double greatest = 0.0, torque = 0.0;
  for (std::size_t k = 1; k < 401; ++k) {
    REQUIRE(body[k].size() == 21);
    touched += probe[k][4] == "1";
    for (std::size_t i = 0; i < 3; ++i) {
      greatest = std::max(greatest, std::abs(std::stod(body[k][i]) - std::stod(probe[k][1 + i])));
      greatest = std::max(greatest, std::abs(std::stod(body[k][7 + i]) - std::stod(probe[k][5 + i])));
      greatest = std::max(greatest, std::abs(std::stod(body[k][14 + i]) - std::stod(probe[k][8 + i])));
      torque = std::max(torque, std::abs(std::stod(body[k][17 + i])));
    }
    const double w = std::stod(body[k][3]), z = std::stod(body[k][6]);
    CHECK(w * w + z * z == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(std::atan2(z, w) == doctest::Approx(0.005 * double(k - 1)).epsilon(1e-5));
    CHECK(body[k][20] == "1");
  }
  CHECK(touched > 100);
  CHECK(greatest < 1e-9);
  CHECK(torque < 1e-9);
}

TEST_CASE(
    "replay holds a molecule's atoms: where they are in the file a body of two presses nothing, and led against the "
    "rest "
    "its torque is lever times force") {
  const Folder folder;
  // Atoms 1 and 2 are held: 3 A apart along x with the middle at the origin of z = 9; in the hand their radii are 1 A.
  write(folder / "three.xyzr", "1.5 0 0 2.0\n-1.5 0 9 1.5\n1.5 0 9 1.5\n");
  write(folder / "pose.csv", "x,y,z,qw,qx,qy,qz\n0,0,9,1,0,0,0\n0,0,4,1,0,0,0\n0,0,2.6,1,0,0,0\n");
  const std::string replay =
      "replay '" + (folder / "three.xyzr") + "' --in-hand 'atom 1 or atom 2' --path '" + (folder / "pose.csv") + "' ";
  const Run run =
      moltact(folder, replay + "--stiffness 3 --rotational-stiffness 1e6 --out '" + (folder / "out.csv") + "'");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const auto out = rows(contents(folder / "out.csv"));
  REQUIRE(out.size() == 4);
  for (const std::size_t quiet : {1u, 2u})
    for (std::size_t i = 14; i < 20; ++i) CHECK(std::stod(out[quiet][i]) == 0.0);
  // The atom at (1.5, 0, 2.6) is 0.4 A within 2 + 1 of the one below it: 3 N/A times 0.4 A, at 1.5 A from the middle.
  CHECK(std::stod(out[3][16]) == doctest::Approx(1.2).epsilon(1e-4));
  CHECK(std::stod(out[3][18]) == doctest::Approx(-1.8).epsilon(1e-4));
  CHECK(std::stod(out[3][9]) == doctest::Approx(3.0).epsilon(1e-4));
  CHECK(moltact(folder, replay + "--time").status == 0);

  // The spheres that it writes are those that are felt: the held ones 0.5 A smaller, and replayed alone they feel alike.
  const std::string files = "'" + (folder / "scene.csv") + "' '" + (folder / "body.csv") + "'";
  REQUIRE(moltact(folder, replay + "--stiffness 3 --rotational-stiffness 1e6 --out '" + (folder / "out.csv") +
                              "' --spheres " + files)
              .status == 0);
  CHECK(contents(folder / "scene.csv") == "x,y,z,r\n1.5,0,0,2\n");
  CHECK(contents(folder / "body.csv") == "x,y,z,r\n-1.5,0,0,1\n1.5,0,0,1\n");
  REQUIRE(moltact(folder, "replay --from-spheres " + files + " --path '" + (folder / "pose.csv") +
                              "' --stiffness 3 --rotational-stiffness 1e6 --out '" + (folder / "again.csv") + "'")
              .status == 0);
  CHECK(contents(folder / "again.csv") == contents(folder / "out.csv"));
  CHECK(moltact(folder, replay + "--time --spheres '" + (folder / "pose.csv") + "' x.csv").status == 1);  // an input

  const std::string path = " --path '" + (folder / "pose.csv") + "' --time";
  const Run probe = moltact(folder, "replay '" + (folder / "three.xyzr") + "'" + path);
  CHECK(probe.status == 1);
  CHECK(probe.err.find(
            "pose.csv:1:7: the probe has no orientation; write the header x,y,z, or name what the hand holds") !=
        std::string::npos);
  CHECK(moltact(folder, "replay" + path).status == 2);
  CHECK(moltact(folder, "replay '" + (folder / "three.xyzr") + "' --from-spheres a.csv b.csv" + path).status == 2);
  CHECK(moltact(folder, "replay --from-spheres a.csv b.csv --remove 'atom 1'" + path).status == 2);
  CHECK(moltact(folder, "replay '" + (folder / "three.xyzr") + "' --spheres a.csv b.csv" + path).status == 2);
  CHECK(moltact(folder, "replay '" + (folder / "three.xyzr") + "' --in-hand 'atom 9'" + path).status == 2);
  CHECK(moltact(folder, "replay '" + (folder / "three.xyzr") + "' --in-hand 'atom 1' --rotational-stiffness -1" + path)
            .status == 2);
}

TEST_CASE("broken poses and lists of spheres end with 1 and name file, line, column and what would mend it") {
  const Folder folder;
  write(folder / "one.csv", "x,y,z,r\n0,0,0,1.6\n");
  write(folder / "good.csv", "x,y,z,qw,qx,qy,qz\n0,0,5,1,0,0,0\n");
  const struct {
    const char* text;
    const char* place;
    const char* says;
  } poses[] = {
      {"x,y,z,qw,qx,qy\n0,0,5,1,0,0\n", ":1:1:", "the first line is not the header x,y,z or x,y,z,qw,qx,qy,qz"},
      {"x,y,z,qw,qx,qy,qz\n0,0,5\n", ":2:6:", "a comma was expected here; a row is 7 numbers"},
      {"x,y,z,qw,qx,qy,qz\n0,0,5,1,0,0,0,0\n", ":2:14:", "there is more than x,y,z,qw,qx,qy,qz in this row"},
      {"x,y,z,qw,qx,qy,qz\n0,0,5,1,0,0,0\n0,0,5,0,0,0,0\n", ":3:7:", "these four numbers are no rotation"},
      {"x,y,z,qw,qx,qy,qz\n0,0,5,nan,0,0,0\n", ":2:7:", "these four numbers are no rotation"},
      {"x,y,z,qw,qx,qy,qz\n0,0,5,1,0,inf,0\n", ":2:7:", "these four numbers are no rotation"},
      {"x,y,z,qw,qx,qy,qz\n", ":", "there is no row in this file"},
  };
  const auto replay = [&](const std::string& scene, const std::string& body, const std::string& path) {
    return moltact(folder, "replay --from-spheres '" + (folder / scene) + "' '" + (folder / body) + "' --path '" +
                               (folder / path) + "' --out '" + (folder / "t.csv") + "'");
  };
  for (const auto& one : poses) {
    write(folder / "pose.csv", one.text);
    const Run run = replay("one.csv", "one.csv", "pose.csv");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.err.find((folder / "pose.csv") + one.place) != std::string::npos);
    CHECK(run.err.find(one.says) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "t.csv"));
  }
  // Quaternions of any size turn alike, also where their squares would be no numbers.
  write(folder / "pose.csv", "x,y,z,qw,qx,qy,qz\n0,0,5,1e-200,0,0,1e-200\n0,0,5,1e200,0,0,1e200\n");
  REQUIRE(replay("one.csv", "one.csv", "pose.csv").status == 0);
  const auto turned = rows(contents(folder / "t.csv"));
  for (const std::size_t k : {1u, 2u}) CHECK(std::stod(turned[k][6]) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-12));
  fs::remove(folder / "t.csv");

  std::string many = "x,y,z,r\n";
  for (int k = 0; k < 5001; ++k) many += "0,0," + std::to_string(k) + ",1\n";
  const std::pair<std::string, const char*> lists[] = {
      {"x,y,z\n0,0,0\n", ":1:1: the first line is not the header x,y,z,r"},
      {"x,y,z,r\n0,0,0,0\n", ":2:7: no sphere has this number"},
      {"x,y,z,r\n0,0,0,-1\n", ":2:7: no sphere has this number"},
      {"x,y,z,r\n0,nan,0,1\n", ":2:3: no sphere has this number"},
      {"x,y,z,r\n0,0,2e9,1\n", ":2:5: no sphere has this number"},
      {many, ":5002:1: more than 5000 spheres"}};
  for (const auto& [text, says] : lists) {
    write(folder / "list.csv", text);
    const Run run = replay("one.csv", "list.csv", "good.csv");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.err.find((folder / "list.csv") + says) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "t.csv"));
  }
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

TEST_CASE(
    "info --charges of 1HPV: 4 e, 336 placed hydrogens, the proton of histidine 69 on ND1, a net charge of 0 for "
    "amprenavir") {
  const Folder folder;
  const std::string text = moltact(folder, "info 1hpv --charges").out;
  CHECK(text.find("net       4 e by AMBER ff14SB, OL15 and OL3; 336 polar hydrogens placed\n") != std::string::npos);
  CHECK(text.find("histidine HID: 69 A, 69 B\n") != std::string::npos);
  CHECK(text.find("ligand    478 (0 e by Gasteiger): 200\n") != std::string::npos);
  CHECK(moltact(folder, "info 1hpv").out.find("net ") == std::string::npos);
  const auto assigned = nlohmann::json::parse(moltact(folder, "info 1hpv --charges --json").out)["assigned"];
  CHECK(assigned["net_charge_e"] == 4.0);
  CHECK(assigned["histidines"]["HID"] == nlohmann::json{"69 A", "69 B"});
  CHECK(text.find("ends      CPHE: 99 A, 99 B\n") != std::string::npos);
  CHECK(text.find("sidechain ASP: 25 A, 29 A, 30 A, 60 A, ") != std::string::npos);
  CHECK(assigned["side_chains"]["ASP"].size() == 8);
  CHECK(assigned["ends"]["NPRO"] == nlohmann::json{"1 A", "1 B"});
  CHECK(assigned["inner_ends"].empty());
}
