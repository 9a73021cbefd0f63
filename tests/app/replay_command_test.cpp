// `moltact replay` as users call it: its output, its errors, the exit status.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/command_place.h"

using namespace moltact::test;
namespace fs = std::filesystem;

namespace {

// A carbon-like sphere of 1.6 A at the origin; with the probe's 1.4 A the surface lies at 3 A.
constexpr const char* kOneSphere = "0 0 0 1.6\n";

}  // namespace

TEST_CASE(
    "replay on one sphere of 3 A writes the SCP 3 A from the centre, 17 digits that read back the same, and k (SCP - "
    "HIP)") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  writeBytes(place / "hip.csv", "x,y,z\n0,0,5\n0,0.3,2.5\n0.1,0.3,2.4\n0,0,7\n");
  const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --out '" +
                            (place / "trace.csv") + "' --stiffness 2");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = contents(place / "trace.csv");
  CHECK(text.starts_with(
      "tick,hip_x,hip_y,hip_z,contact,scp_x,scp_y,scp_z,force_x,force_y,force_z,feature,atom1,atom2,atom3\n"));
  const auto trace = csvRows(text);
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
  const CommandPlace place;
  writeBytes(place / "scene.csv", "x,y,z,r\n0,0,0,1.6\n2.2,0.5,0,1.5\n");
  writeBytes(place / "scene.xyzr", "0 0 0 1.6\n2.2 0.5 0 1.5\n");
  writeBytes(place / "body.csv", "x,y,z,r\n0,0,0,1.4\n");
  std::string path = "x,y,z\n", turned = "x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k < 400; ++k) {
    const std::string at = std::to_string(0.01 * k - 1.0) + "," + std::to_string(0.2 + 0.001 * k) + "," +
                           std::to_string(4.0 - 0.006 * std::min(k, 300));
    path += at + "\n";
    // The quaternion has length 2; the program normalizes it.
    turned += at + "," + std::to_string(2.0 * std::cos(0.005 * k)) + ",0,0," +
              std::to_string(2.0 * std::sin(0.005 * k)) + "\n";
  }
  writeBytes(place / "hip.csv", path);
  writeBytes(place / "pose.csv", turned);
  REQUIRE(place
              .run("replay '" + (place / "scene.xyzr") + "' --path '" + (place / "hip.csv") +
                   "' --probe 1.4 --stiffness 2 --out '" + (place / "probe.csv") + "'")
              .status == 0);
  const Run run =
      place.run("replay --from-spheres '" + (place / "scene.csv") + "' '" + (place / "body.csv") + "' --path '" +
                (place / "pose.csv") + "' --stiffness 2 --out '" + (place / "bodied.csv") + "'");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = contents(place / "bodied.csv");
  CHECK(text.starts_with(
      "hand_x,hand_y,hand_z,hand_qw,hand_qx,hand_qy,hand_qz,body_x,body_y,body_z,body_qw,body_qx,body_qy,"
      "body_qz,force_x_N,force_y_N,force_z_N,torque_x_NA,torque_y_NA,torque_z_NA,at_rest\n"));
  const auto probe = csvRows(contents(place / "probe.csv")), body = csvRows(text);
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
  const CommandPlace place;
  // Atoms 1 and 2 are held: 3 A apart along x with the middle at the origin of z = 9; in the hand their radii are 1 A.
  writeBytes(place / "three.xyzr", "1.5 0 0 2.0\n-1.5 0 9 1.5\n1.5 0 9 1.5\n");
  writeBytes(place / "pose.csv", "x,y,z,qw,qx,qy,qz\n0,0,9,1,0,0,0\n0,0,4,1,0,0,0\n0,0,2.6,1,0,0,0\n");
  const std::string replay =
      "replay '" + (place / "three.xyzr") + "' --in-hand 'atom 1 or atom 2' --path '" + (place / "pose.csv") + "' ";
  const Run run = place.run(replay + "--stiffness 3 --rotational-stiffness 1e6 --out '" + (place / "out.csv") + "'");
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const auto out = csvRows(contents(place / "out.csv"));
  REQUIRE(out.size() == 4);
  for (const std::size_t quiet : {1u, 2u})
    for (std::size_t i = 14; i < 20; ++i) CHECK(std::stod(out[quiet][i]) == 0.0);
  // The atom at (1.5, 0, 2.6) is 0.4 A within 2 + 1 of the one below it: 3 N/A times 0.4 A, at 1.5 A from the middle.
  CHECK(std::stod(out[3][16]) == doctest::Approx(1.2).epsilon(1e-4));
  CHECK(std::stod(out[3][18]) == doctest::Approx(-1.8).epsilon(1e-4));
  CHECK(std::stod(out[3][9]) == doctest::Approx(3.0).epsilon(1e-4));
  CHECK(place.run(replay + "--time").status == 0);

  // The spheres that it writes are those that are felt: the held ones 0.5 A smaller, and replayed alone they feel alike.
  const std::string files = "'" + (place / "scene.csv") + "' '" + (place / "body.csv") + "'";
  REQUIRE(place
              .run(replay + "--stiffness 3 --rotational-stiffness 1e6 --out '" + (place / "out.csv") + "' --spheres " +
                   files)
              .status == 0);
  CHECK(contents(place / "scene.csv") == "x,y,z,r\n1.5,0,0,2\n");
  CHECK(contents(place / "body.csv") == "x,y,z,r\n-1.5,0,0,1\n1.5,0,0,1\n");
  REQUIRE(place
              .run("replay --from-spheres " + files + " --path '" + (place / "pose.csv") +
                   "' --stiffness 3 --rotational-stiffness 1e6 --out '" + (place / "again.csv") + "'")
              .status == 0);
  CHECK(contents(place / "again.csv") == contents(place / "out.csv"));
  CHECK(place.run(replay + "--time --spheres '" + (place / "pose.csv") + "' x.csv").status == 1);  // an input

  const std::string path = " --path '" + (place / "pose.csv") + "' --time";
  const Run probe = place.run("replay '" + (place / "three.xyzr") + "'" + path);
  CHECK(probe.status == 1);
  CHECK(probe.err.find(
            "pose.csv:1:7: the probe has no orientation; write the header x,y,z, or name what the hand holds") !=
        std::string::npos);
  CHECK(place.run("replay" + path).status == 2);
  CHECK(place.run("replay '" + (place / "three.xyzr") + "' --from-spheres a.csv b.csv" + path).status == 2);
  CHECK(place.run("replay --from-spheres a.csv b.csv --remove 'atom 1'" + path).status == 2);
  CHECK(place.run("replay '" + (place / "three.xyzr") + "' --spheres a.csv b.csv" + path).status == 2);
  CHECK(place.run("replay '" + (place / "three.xyzr") + "' --in-hand 'atom 9'" + path).status == 2);
  CHECK(
      place.run("replay '" + (place / "three.xyzr") + "' --in-hand 'atom 1' --rotational-stiffness -1" + path).status ==
      2);
}

TEST_CASE("broken poses and lists of spheres end with 1 and name file, line, column and what would mend it") {
  const CommandPlace place;
  writeBytes(place / "one.csv", "x,y,z,r\n0,0,0,1.6\n");
  writeBytes(place / "good.csv", "x,y,z,qw,qx,qy,qz\n0,0,5,1,0,0,0\n");
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
    return place.run("replay --from-spheres '" + (place / scene) + "' '" + (place / body) + "' --path '" +
                     (place / path) + "' --out '" + (place / "t.csv") + "'");
  };
  for (const auto& one : poses) {
    writeBytes(place / "pose.csv", one.text);
    const Run run = replay("one.csv", "one.csv", "pose.csv");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.err.find((place / "pose.csv") + one.place) != std::string::npos);
    CHECK(run.err.find(one.says) != std::string::npos);
    CHECK_FALSE(fs::exists(place / "t.csv"));
  }
  // Quaternions of any size turn alike, also where their squares would be no numbers.
  writeBytes(place / "pose.csv", "x,y,z,qw,qx,qy,qz\n0,0,5,1e-200,0,0,1e-200\n0,0,5,1e200,0,0,1e200\n");
  REQUIRE(replay("one.csv", "one.csv", "pose.csv").status == 0);
  const auto turned = csvRows(contents(place / "t.csv"));
  for (const std::size_t k : {1u, 2u}) CHECK(std::stod(turned[k][6]) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-12));
  fs::remove(place / "t.csv");

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
    writeBytes(place / "list.csv", text);
    const Run run = replay("one.csv", "list.csv", "good.csv");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.err.find((place / "list.csv") + says) != std::string::npos);
    CHECK_FALSE(fs::exists(place / "t.csv"));
  }
}

TEST_CASE(
    "replay --time prints one JSON object with ticks, contact_ticks and mean, p50, p99, p99.99, max for free and "
    "contact") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  std::string path = "x,y,z\n";
  for (int k = 0; k < 2000; ++k) path += "0,0," + std::to_string(5.0 - 0.0015 * k) + "\n";
  writeBytes(place / "hip.csv", path);
  const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --time");
  REQUIRE(run.status == 0);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["ticks"] == 2000);
  CHECK(json["contact_ticks"] == 2000 - 1334);  // the surface is reached at tick 1333.3
  CHECK(json["measured"] == "each tick's least of three passes, less the clock's own cost");
  for (const char* state : {"free", "contact"})
    for (const char* figure : {"mean", "p50", "p99", "p99.99", "max"}) CHECK(json[state][figure].is_number());
}

TEST_CASE("replay says on stderr that the HIP starts inside and that a place was not a number; both give no force") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  writeBytes(place / "hip.csv", "x,y,z\n0,0,1\n0,0,1.1\n0,0,4\n0,0,2.5\nnan,0,0\n0,0,2.4\n");
  const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --out '" +
                            (place / "t.csv") + "'");
  REQUIRE(run.status == 0);
  CHECK(run.err.find("starts inside the molecule: no force for the first 2 ticks") != std::string::npos);
  CHECK(run.err.find("1 places were not finite") != std::string::npos);
  const auto trace = csvRows(contents(place / "t.csv"));
  for (const std::size_t quiet : {1u, 2u, 3u, 5u}) {
    CHECK(trace[quiet][4] == "0");
    CHECK(trace[quiet][10] == "0");
  }
  CHECK(trace[4][4] == "1");
  CHECK(trace[6][4] == "1");
}

TEST_CASE("a broken path file ends with 1 and names file, line, column and what would mend it") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
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
    writeBytes(place / "hip.csv", one.text);
    const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --out '" +
                              (place / "t.csv") + "'");
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(run.out.empty());
    CHECK(run.err.find((place / "hip.csv") + one.place) != std::string::npos);
    CHECK(run.err.find(one.says) != std::string::npos);
    CHECK(run.err.find("; ") != std::string::npos);
    CHECK_FALSE(fs::exists(place / "t.csv"));
  }
}

TEST_CASE("a path file that is a device, a pipe, a folder or larger than 1 GiB is refused at once, with a remedy") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  REQUIRE(::mkfifo((place / "pipe").c_str(), 0600) == 0);
  writeBytes(place / "large.csv", "x,y,z\n");
  fs::resize_file(place / "large.csv", (std::uintmax_t{1} << 30) + 1);
  const struct {
    std::string path;
    const char* says;
  } cases[] = {
      {"/dev/zero", "it is not an ordinary file; copy the data into one"},
      {place / "pipe", "it is not an ordinary file; copy the data into one"},
      {place.folder.string(), "it is a folder; name a file in it"},
      {place / "large.csv", "it is larger than 1024 MiB; split it into shorter paths"},
      {place / "none.csv", "there is no such file; check the name and the folder"},
  };
  for (const auto& one : cases) {
    // A pipe that is read would block for ever.
    const Run run = place.run("replay '" + (place / "one.xyzr") + "' --time --path '" + one.path + "'", "timeout 60 ");
    CHECK(run.status == 1);
    CHECK(run.err == "moltact: " + one.path + ": " + one.says + "\n");
  }
}

// The sanitizers reserve more address space than any limit here.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE(
    "1000 MiB under a limit of 900 MiB end with 1: a path for want of memory, a molecule at its first line, which is "
    "too long") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  for (const char* name : {"large.pdb", "large.csv"}) {
    writeBytes(place / name, "");
    fs::resize_file(place / name, std::uintmax_t{1000} << 20);
  }
  const std::string limit = "ulimit -c 0; ulimit -v 921600; ";
  const Run info = place.run("info '" + (place / "large.pdb") + "'", limit);
  CHECK(info.status == 1);
  CHECK(info.err.starts_with("moltact: " + (place / "large.pdb") + ":1: the line is longer than 16 MiB"));
  const Run replay =
      place.run("replay '" + (place / "one.xyzr") + "' --time --path '" + (place / "large.csv") + "'", limit);
  CHECK(replay.status == 1);
  CHECK(replay.err == "moltact: not enough memory for this; close other programs, or take a smaller file\n");
}
#endif

TEST_CASE("a path file may begin with a byte order mark and have blanks around its fields and plus signs") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", kOneSphere);
  const auto trace = [&](const std::string& text) {
    writeBytes(place / "hip.csv", text);
    const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --out '" +
                              (place / "t.csv") + "'");
    CAPTURE(run.err);
    CHECK(run.status == 0);
    return contents(place / "t.csv");
  };
  const std::string plain = trace("x,y,z\n0,1,5\n0,-2.5,1\n");
  CHECK(trace("\xEF\xBB\xBFx,y,z\n0,1,5\n0,-2.5,1\n") == plain);
  CHECK(trace(" x, y,\tz \r\n0, 1 ,5\r\n\t0,\t-2.5, 1\r\n") == plain);
  CHECK(trace("x,y,z\n+0,+1,+5.0\n0,-2.5,+1e0\n") == plain);
  for (const char* row : {"+,1,2", "+-1,1,2", "++1,1,2", "+ 1,1,2"}) {
    writeBytes(place / "hip.csv", std::string("x,y,z\n") + row + "\n");
    const Run run = place.run("replay '" + (place / "one.xyzr") + "' --path '" + (place / "hip.csv") + "' --time");
    CAPTURE(row);
    CHECK(run.status == 1);
    CHECK(run.err.find("a number was expected here") != std::string::npos);
  }
}
