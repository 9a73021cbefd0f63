// `moltact scan` as users call it: exit status, files and their heights.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/render/picture.h"

using namespace moltact;

namespace {

namespace fs = std::filesystem;

const fs::path kScanFolder = fs::temp_directory_path() / "moltact-scan-command";

int runScanCommand(const std::string& arguments) {
  fs::remove_all(kScanFolder);
  fs::create_directories(kScanFolder);
  return WEXITSTATUS(std::system(("'" MOLTACT_BINARY "' scan " + arguments + " >/dev/null 2>&1").c_str()));
}

std::string scanOut(const char* name) { return " --out '" + (kScanFolder / name).string() + "'"; }

std::string textOfScan(const char* name) {
  std::ifstream file(kScanFolder / name, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

double highestOfScan(const char* name) {
  std::istringstream lines(textOfScan(name));
  std::string line;
  std::getline(lines, line);
  CHECK(line == "x_A,y_A,height_A,atom");
  double highest = 0, x = 0, y = 0, height = 0;
  char comma = 0;
  while (std::getline(lines, line)) {
    std::istringstream(line) >> x >> comma >> y >> comma >> height;
    highest = std::max(highest, height);
  }
  return highest;
}

}  // namespace

TEST_CASE(
    "scan writes a table, a simple field and a picture of one scan; flat benzene is 3.4 A high, and from the side "
    "higher") {
  REQUIRE(runScanCommand("benzene --view front --tip 10 --spacing 0.5" + scanOut("b.csv") + scanOut("b.GSF") +
                         scanOut("b.png")) == 0);
  const double flat = highestOfScan("b.csv");
  CHECK(std::abs(flat - 3.4) < 0.05);
  CHECK(textOfScan("b.GSF").starts_with("Gwyddion Simple Field 1.0\nXRes = "));
  const auto picture = readPng(kScanFolder / "b.png");
  REQUIRE(picture);
  CHECK(picture->height_px >= 600);
  REQUIRE(runScanCommand("benzene --view top" + scanOut("b.csv")) == 0);
  CHECK(highestOfScan("b.csv") > flat + 2.0);
  REQUIRE(runScanCommand("benzene --view front --force 100 --contact 1" + scanOut("b.csv")) == 0);
  CHECK(highestOfScan("b.csv") < flat - 0.2);
}

TEST_CASE(
    "scan with another ending, a tip of NaN, a wrong view, all atoms removed or no file gives a status and no file") {
  CHECK(runScanCommand("benzene" + scanOut("b.tif")) == 2);
  CHECK(runScanCommand("benzene --tip nan" + scanOut("b.csv")) == 2);
  CHECK(runScanCommand("benzene --tip 101" + scanOut("b.csv")) == 2);
  CHECK(runScanCommand("benzene --view sideways" + scanOut("b.csv")) == 2);
  CHECK(runScanCommand("benzene --remove all" + scanOut("b.csv")) == 1);
  CHECK(runScanCommand("no-such-molecule" + scanOut("b.csv")) == 1);
  CHECK(runScanCommand("2hhb --spacing 0.02" + scanOut("b.csv")) == 1);
  CHECK(runScanCommand("benzene") != 0);
  CHECK(fs::is_empty(kScanFolder));
}
