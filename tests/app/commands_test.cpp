// What the headless commands share, as users call them: options, errors, the exit status; and `moltact info`.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command_place.h"

using namespace moltact::test;
namespace fs = std::filesystem;

TEST_CASE("a --content-scale that is no number or out of range ends with status 2 and the range") {
  const CommandPlace place;
  for (const char* scale : {"nan", "inf", "0", "-1", "9"}) {
    const Run run = place.run("--screenshot '" + (place / "a.png") + "' --content-scale " + scale);
    CAPTURE(scale);
    CHECK(run.status == 2);
    CHECK(run.err.find("0.5 to 8") != std::string::npos);
  }
}

TEST_CASE("options that are NaN, infinite or out of range end with 2 and name the range") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", "0 0 0 1.6\n");
  writeBytes(place / "hip.csv", "x,y,z\n0,0,5\n");
  const std::string one = " '" + (place / "one.xyzr") + "' ";
  const std::string replay = "replay" + one + "--time --path '" + (place / "hip.csv") + "' ";
  const std::string render = "render" + one + "--out '" + (place / "x.png") + "' ";
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
    const Run run = place.run(c.command + c.option + "=" + c.value);
    CAPTURE(c.option);
    CAPTURE(c.value);
    CHECK(run.status == 2);
    CHECK(run.err.find(std::string("'") + c.value + "' is not a number from " + c.range) != std::string::npos);
  }
  CHECK_FALSE(fs::exists(place / "x.png"));
  CHECK(place.run(replay + "--probe +1.5e0 --stiffness 1e6").status == 0);
  for (const char* model : {"0", "-1", "100001", "nan"}) {
    const Run run = place.run("info" + one + "--model=" + model);
    CHECK(run.status == 2);
    CHECK(run.err.size() < 200);
  }
}

TEST_CASE(
    "wrong usage ends with 2, a missing molecule or an unwritable trace with 1, --help with 0 for every command") {
  const CommandPlace place;
  writeBytes(place / "one.xyzr", "0 0 0 1.6\n");
  writeBytes(place / "hip.csv", "x,y,z\n0,0,5\n");
  const std::string path = " --path '" + (place / "hip.csv") + "'", one = "'" + (place / "one.xyzr") + "'";
  CHECK(place.run("replay").status == 2);
  CHECK(place.run("replay " + one + path).status == 2);
  CHECK(place.run("replay " + one + path + " --out x.csv --method magic").status == 2);
  CHECK(place.run("replay " + one + path + " --out x.csv --probe 21").status == 2);
  CHECK(place.run("no-such-command --flag").status == 2);
  CHECK(place.run("replay /no/such/file.pdb" + path + " --out x.csv").status == 1);
  CHECK(place.run("replay " + one + path + " --out /no/such/folder/x.csv").status == 1);
  CHECK(place.run("info " + (place.folder.string())).status == 1);
  for (const char* command : {"", "info", "replay", "render", "fetch"}) {
    const Run help = place.run(std::string(command) + " --help");
    CHECK(help.status == 0);
    CHECK(help.out.find("Usage") != std::string::npos);
  }
}

TEST_CASE("the window's command without a display ends with 1 and names the commands that need none") {
  const CommandPlace place;
  const std::string out = place / "o", err = place / "e";
  const int status =
      std::system(("env -u DISPLAY -u WAYLAND_DISPLAY '" MOLTACT_BINARY "' >'" + out + "' 2>'" + err + "'").c_str());
  CHECK(WEXITSTATUS(status) == 1);
  const std::string text = contents(err);
  for (const char* command : {"info", "render", "check", "play", "report", "bench"})
    CHECK(text.find(command) != std::string::npos);
}

TEST_CASE("info counts 602 atoms of ubiquitin, as text and as JSON") {
  const CommandPlace place;
  CHECK(place.run("info 1ubq").out.find("602") != std::string::npos);
  CHECK(nlohmann::json::parse(place.run("info 1ubq --json").out)["atoms"] == 602);
}

TEST_CASE(
    "info --charges of 1HPV: 4 e, 336 placed hydrogens, the proton of histidine 69 on ND1, a net charge of 0 for "
    "amprenavir") {
  const CommandPlace place;
  const std::string text = place.run("info 1hpv --charges").out;
  CHECK(text.find("net       4 e by AMBER ff14SB, OL15 and OL3; 336 polar hydrogens placed\n") != std::string::npos);
  CHECK(text.find("histidine HID: 69 A, 69 B\n") != std::string::npos);
  CHECK(text.find("ligand    478 (0 e by Gasteiger): 200\n") != std::string::npos);
  CHECK(place.run("info 1hpv").out.find("net ") == std::string::npos);
  const auto assigned = nlohmann::json::parse(place.run("info 1hpv --charges --json").out)["assigned"];
  CHECK(assigned["net_charge_e"] == 4.0);
  CHECK(assigned["histidines"]["HID"] == nlohmann::json{"69 A", "69 B"});
  CHECK(text.find("ends      CPHE: 99 A, 99 B\n") != std::string::npos);
  CHECK(text.find("sidechain ASP: 25 A, 29 A, 30 A, 60 A, ") != std::string::npos);
  CHECK(assigned["side_chains"]["ASP"].size() == 8);
  CHECK(assigned["ends"]["NPRO"] == nlohmann::json{"1 A", "1 B"});
  CHECK(assigned["inner_ends"].empty());
}
