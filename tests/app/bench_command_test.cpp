// `moltact bench hands`, `moltact bench bodies`, `moltact bench energies` and `moltact device path` as users call them.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/command_place.h"

using namespace moltact::test;

namespace {

// A press on one argon atom, in the device's millimetres: straight in from in front, 4 mm deep, along and out.
void writePress(const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "# a made-up hand\n# columns: t x y z fx fy fz\n";
  int row = 0;
  const auto add = [&](double x, double z) {
    out << 0.001 * row++ << ' ' << x << " 0 " << z << " 0 0 " << (z < 4 ? 1 : 0) << '\n';
  };
  for (int k = 0; k <= 400; ++k) add(0, 20 - 0.05 * k);
  for (int k = 0; k <= 400; ++k) add(0.01 * k, 0);
  for (int k = 0; k <= 400; ++k) add(4, 0.05 * k);
}

std::size_t lines(const std::string& text) { return std::size_t(std::count(text.begin(), text.end(), '\n')); }

}  // namespace

TEST_CASE("a user's recorded hand, rows of numbers placed on a molecule, is replayed through the requested methods") {
  const CommandPlace place;
  writePress(place.folder / "press.txt");
  const Run run = place.run("bench hands --quick --recording press.txt --molecule argon --methods mesh80 --csv out");
  CHECK_MESSAGE(run.status == 0, run.err);
  const std::string csv = contents(place.folder / "out" / "hands_figures.csv");
  // The head, exact, its two noise floors, and mesh80.
  CHECK(lines(csv) == 5);
  CHECK(csv.find("press,mesh80,") != std::string::npos);
  const std::string hands = contents(place.folder / "out" / "hands.csv");
  CHECK(hands.find("press,") != std::string::npos);
  // More than the third that slides, because the approaches also end in contact.
  const double touching = std::stod(hands.substr(hands.rfind(',') + 1));
  CHECK(touching > 33);
  CHECK(touching < 80);
}

TEST_CASE(
    "a hand without a molecule, a broken row, and --docs together with --recording are errors with "
    "status 1 or 2") {
  const CommandPlace place;
  writePress(place.folder / "press.txt");
  Run run = place.run("bench hands --quick --recording press.txt");
  CHECK(run.status == 1);
  CHECK(run.err.find("--molecule") != std::string::npos);
  std::ofstream(place.folder / "broken.txt") << "1 2 3\n4 five 6\n";
  run = place.run("bench hands --quick --recording broken.txt --molecule argon");
  CHECK(run.status == 1);
  CHECK(run.err.find("broken.txt:2") != std::string::npos);
  run = place.run("bench --recording press.txt --molecule argon --docs .");
  CHECK(run.status != 0);
  CHECK(run.err.find("--docs") != std::string::npos);
}

TEST_CASE(
    "the way of a recorded hand is written as rows of numbers, from before the first touch to the last, and is "
    "replayed like any") {
  const CommandPlace place;
  REQUIRE(place.run("device record simulated argon-triangle --seconds 2.5 --out hand.recording").status == 0);
  const Run run = place.run("device path hand.recording --out hand.hand --touching 0.05 --label 'hand=a test'");
  CHECK_MESSAGE(run.status == 0, run.err);
  const std::string text = contents(place.folder / "hand.hand");
  CHECK(text.find("# hand: a test") != std::string::npos);
  CHECK(text.find("# molecule: argon-triangle") != std::string::npos);
  CHECK(lines(text) < 2500);
  CHECK(lines(text) > 500);
  CHECK(place.run("device path hand.recording --out x.hand --label nothing").status == 1);
  CHECK(place.run("device path no.recording --out x.hand").status == 1);
  CHECK(place.run("bench hands --quick --recording hand.hand hand.recording --methods penalty").status == 0);
}

TEST_CASE("the tables and sentences of the hands are written between the markers of a page") {
  const CommandPlace place;
  std::filesystem::create_directories(place.folder / "docs");
  std::filesystem::copy(MOLTACT_SOURCE_DIR "/docs/hands.md", place.folder / "docs" / "hands.md");
  const Run run = place.run("bench hands --quick --methods penalty --docs docs");
  CHECK_MESSAGE(run.status == 0, run.err);
  const std::string page = contents(place.folder / "docs" / "hands.md");
  for (const char* name : {"hands", "hands_felt", "hands_sentences"}) {
    const std::size_t begin = page.find(std::string("<!-- ") + name + ":begin"),
                      end = page.find(std::string("<!-- ") + name + ":end");
    REQUIRE(begin != std::string::npos);
    CHECK(end > begin + 200);
    CHECK(page.substr(begin, end - begin).find("mesh80") == std::string::npos);
  }
}

TEST_CASE(
    "bench bodies writes the bodies of 1, 10, 35, 200 and 1069 atoms and the 10 scenes for the exact body and the "
    "named "
    "method, and its chart; the exact body overlaps nothing by more than 1e-9 A") {
  const CommandPlace place;
  const Run run = place.run("bench bodies --quick --methods springs --csv out --svg out --json out/all.json");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  CHECK(run.out.find("Rigid bodies: speed against accuracy") != std::string::npos);
  CHECK(run.out.find("Rigid bodies: failures by scene") != std::string::npos);
  std::istringstream rows(contents(place.folder / "out" / "body_trade_off.csv"));
  std::string head, row;
  std::getline(rows, head);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
  };
  const std::vector<std::string> names = cells(head);
  const auto column = [&](const char* name) {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::size_t method = column("method"), overlap = column("overlap_max_A"), judged = column("judged");
  REQUIRE(std::max({method, overlap, judged}) < names.size());
  std::vector<std::string> exact, springs;
  while (std::getline(rows, row)) {
    const std::vector<std::string> one = cells(row);
    REQUIRE(one.size() == names.size());
    (one[method] == "exact-body" ? exact : springs).push_back(one[0]);
    CHECK(std::stod(one[judged]) > 20);
    if (one[method] == "exact-body") CHECK(std::stod(one[overlap]) < 1e-9);
  }
  CHECK(exact == std::vector<std::string>{"1", "10", "35", "200", "1069"});
  CHECK(springs == exact);
  CHECK(lines(contents(place.folder / "out" / "body_matrix.csv")) == 11);
  CHECK(lines(contents(place.folder / "out" / "body_matrix_values.csv")) == 21);
  CHECK(contents(place.folder / "out" / "rigid-bodies.svg").starts_with("<svg "));
  CHECK(contents(place.folder / "out" / "all.json").find("\"body_trade_off\"") != std::string::npos);
}

TEST_CASE(
    "bench energies writes three bodies with sums at six cut-offs and grids: a sum differs from that in double "
    "precision "
    "by less than 1e-3 of the force, the error falls from a cut-off of 6 A to 10 A, and on a ligand the trilinear "
    "force "
    "jumps at a face while the tricubic one does not") {
  const CommandPlace place;
  std::ofstream(place.folder / "page.csv") << "body,method,mean_us,p999_us\nligand,float 10 A,123,456\n";
  const Run run = place.run("bench energies --quick --csv out --svg out --page-ticks page.csv");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  CHECK(contents(place.folder / "out" / "energies.svg").starts_with("<svg "));
  std::istringstream rows(contents(place.folder / "out" / "energy_trade_off.csv"));
  std::vector<std::string> names;
  std::map<std::string, std::map<std::string, double>> found;  // by body and method, then by column
  for (std::string row; std::getline(rows, row);) {
    std::vector<std::string> cells;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    REQUIRE(cells.size() == names.size());
    for (std::size_t k = 2; k < cells.size(); ++k)
      if (!cells[k].empty()) found[cells[0] + ' ' + cells[1]][names[k]] = std::stod(cells[k]);
  }
  CHECK(found.size() == 30);
  CHECK(found["ligand float 10 A"].at("page_mean_us") == 123);
  CHECK(found["ligand float 10 A"].at("page_p999_us") == 456);
  CHECK(found["chain float 10 A"].count("page_mean_us") == 0);
  CHECK(contents(place.folder / "out" / "energies.svg").find("in a page") != std::string::npos);
  for (const std::string body : {"ligand", "200", "chain"}) {
    CAPTURE(body);
    for (const char* method :
         {" float 6 A", " float 8 A", " float 10 A", " float 12 A", " float 14 A", " double 10 A"}) {
      const auto& one = found[body + method];
      CHECK(one.at("own_force_rms") < 1e-3 * one.at("right_force"));
      CHECK(one.at("jump_max") < 0.01);
    }
    CHECK(found[body + " float 10 A"]["force_rms"] < found[body + " float 6 A"]["force_rms"]);
    CHECK(found[body + " tricubic 0.5 A"]["own_force_rms"] < found[body + " tricubic 0.75 A"]["own_force_rms"]);
    CHECK(found[body + " tricubic 0.5 A"]["jump_max"] < 0.01);
  }
  CHECK(found["ligand trilinear 0.5 A"]["jump_max"] > 0.5);
}
