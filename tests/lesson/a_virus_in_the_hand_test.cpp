// The program's lesson on a virus: its axes, its sixty subunits and the places to feel agree with the entry.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kAVirusInTheHandLesson = "a-virus-in-the-hand";

const Molecule& shell() {
  static const Molecule molecule = [] {
    auto read = readMolecule(MOLTACT_SOURCE_DIR "/molecules/1rb8.pdb", {.assembly = "1"});
    REQUIRE(read);
    return *std::move(read);
  }();
  return molecule;
}

std::vector<Vec3> placesOf(const std::string& text) {
  std::vector<Vec3> out;
  for (const auto i : parseSelection(text)->select(shell())) out.push_back(shell().spheres[i].centre_A);
  return out;
}

/// From the middle of the shell through the middle of these.
Vec3 axisOf(const std::vector<Vec3>& places) {
  return glm::normalize(std::accumulate(places.begin(), places.end(), Vec3(0.0)));
}

double offAxis_A(const Vec3& place, const Vec3& axis) { return glm::length(place - axis * glm::dot(place, axis)); }

/// How high over the middle a sphere on this axis is stopped that comes from outside.
double stop_A(const Vec3& axis, double sphere_A) {
  double highest = 0.0;
  for (const Sphere& a : shell().spheres) {
    const double off = offAxis_A(a.centre_A, axis), grown = a.radius_A + sphere_A, up = glm::dot(a.centre_A, axis);
    if (off < grown) highest = std::max(highest, up + std::sqrt(grown * grown - off * off));
  }
  return highest;
}

}  // namespace

TEST_CASE("a-virus-in-the-hand.md has 7 steps, a ring to trace, a search and trials in the dark") {
  const Lesson lesson = shippedLesson(kAVirusInTheHandLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 7);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "find") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
}

TEST_CASE(
    "the shell has 60 pieces of 635 amino acids and nearly 300 000 atoms, 34 nm from tip to tip, which no single gene "
    "could write") {
  SAYS(lineSaying(kAVirusInTheHandLesson, "300 000 atoms, 34 nm from tip to tip"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "60 × 635 × 3 = 114 300"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "together 635 amino acids"));
  const auto alpha = placesOf("protein and name CA");
  CHECK(60 * 635 * 3 == 114300);
  CHECK(635 * 3 == 1905);
  SAYS(lineSaying(kAVirusInTheHandLesson, "about twenty times what such a virus has"));
  CHECK(114300.0 / 5386.0 == doctest::Approx(20.0).epsilon(0.1));
  // A page of a book has some 2000 letters.
  SAYS(lineSaying(kAVirusInTheHandLesson, "It has 5386 letters, three pages of a book"));
  CHECK(std::ceil(5386.0 / 2000.0) == 3.0);
  double farthest = 0.0;
  for (const Vec3& p : alpha) farthest = std::max(farthest, glm::length(p));
  CHECK(2.0 * farthest == doctest::Approx(340.0).epsilon(0.01));
}

TEST_CASE(
    "the shell is that of the phage alpha3 and its small protein J that of phiX174, as lesson, title and SOURCE say") {
  SAYS(lineSaying(kAVirusInTheHandLesson, "This is the shell of its close relative **α3**"));
  SAYS(lineSaying(kAVirusInTheHandLesson,
                  "shell and spikes (F and G) of the phage α3 with the small protein J of φX174"));
  std::ifstream in(MOLTACT_SOURCE_DIR "/molecules/1rb8.pdb");
  std::string title, line;
  std::map<char, std::string> molecule_of_chain;            // "1" for F
  std::map<std::string, std::string> organism_of_molecule;  // "ENTEROBACTERIA PHAGE ALPHA3" for "1"
  for (std::string number; std::getline(in, line);) {
    if (line.rfind("TITLE ", 0) == 0) title = line;
    const auto after = [&](const std::string& key) {
      const auto at = line.find(key), end = line.find(';', at);
      return line.substr(at + key.size(), end - at - key.size());
    };
    if (line.find("MOL_ID: ") != std::string::npos) number = after("MOL_ID: ");
    if (line.rfind("COMPND", 0) == 0 && line.find(" CHAIN: ") != std::string::npos)
      molecule_of_chain[after(" CHAIN: ").at(0)] = number;
    if (line.find("ORGANISM_SCIENTIFIC: ") != std::string::npos)
      organism_of_molecule[number] = after("ORGANISM_SCIENTIFIC: ");
  }
  CHECK(title.find("ALPHA3 WITH PROTEIN J OF PHIX174") != std::string::npos);
  CHECK(organism_of_molecule[molecule_of_chain['F']] == "ENTEROBACTERIA PHAGE ALPHA3");
  CHECK(organism_of_molecule[molecule_of_chain['G']] == "ENTEROBACTERIA PHAGE ALPHA3");
  CHECK(organism_of_molecule[molecule_of_chain['J']] == "ENTEROBACTERIA PHAGE PHIX174");
}

TEST_CASE(
    "five knobs 72 degrees apart stand round the tip of a spike, three round a place of three, two across a border") {
  SAYS(lineSaying(kAVirusInTheHandLesson,
                  "stand 10 Å from the five-fold axis, of Ser 188 (F) 4.3 Å from the three-fold, of Asp 80 (F) 7.4 "
                  "Å from the two-fold"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "threonine 92 (an amino acid; the number is its place in the chain)"));
  struct Place {
    const char* text;
    std::size_t count;
    double off_A;
  };
  for (const Place& place : {Place{"chain G G-2 G-3 G-4 G-5 and residue 92 and resname THR and name CA", 5, 9.8},
                             Place{"chain F F-10 F-23 and residue 188 and resname SER and name CA", 3, 4.3},
                             Place{"chain F F-6 and residue 80 and resname ASP and name CA", 2, 7.4}}) {
    CAPTURE(place.text);
    const auto knobs = placesOf(place.text);
    REQUIRE(knobs.size() == place.count);
    const Vec3 axis = axisOf(knobs);
    for (const Vec3& k : knobs) CHECK(std::abs(offAxis_A(k, axis) - place.off_A) < 0.06);
    // A turn about the axis by the whole angle's share carries every alpha carbon of these onto one of them.
    const double turn = 2.0 * 3.14159265358979 / double(place.count);
    for (const Vec3& k : knobs) {
      const Vec3 turned = k * std::cos(turn) + glm::cross(axis, k) * std::sin(turn) +
                          axis * (glm::dot(axis, k) * (1.0 - std::cos(turn)));
      CHECK(std::any_of(knobs.begin(), knobs.end(), [&](const Vec3& o) { return glm::distance(o, turned) < 0.01; }));
    }
  }
}

TEST_CASE("there are 12 spikes, 20 places of three and 30 of two") {
  SAYS(lineSaying(kAVirusInTheHandLesson, "12 spikes, 20 places of three, 30 of two"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "number: 12"));
  const auto different = [](const std::vector<Vec3>& places, double nearer_A) {
    std::vector<std::vector<Vec3>> groups;
    for (const Vec3& p : places) {
      const auto own = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& g) { return glm::distance(g.front(), p) < nearer_A; });
      if (own == groups.end())
        groups.push_back({p});
      else
        own->push_back(p);
    }
    return groups;
  };
  const auto spikes = different(placesOf("residue 92 and resname THR and name CA"), 25.0);
  CHECK(spikes.size() == 12);
  for (const auto& s : spikes) CHECK(s.size() == 5);
  const auto threes = different(placesOf("residue 188 and resname SER and name CA"), 10.0);
  CHECK(threes.size() == 20);
  for (const auto& t : threes) CHECK(t.size() == 3);
  const auto twos = different(placesOf("residue 80 and resname ASP and name CA"), 16.0);
  CHECK(twos.size() == 30);
  for (const auto& t : twos) CHECK(t.size() == 2);
}

TEST_CASE(
    "on the three-fold axis a sphere of 1.4 A comes 10 A below its rest on the knobs and a point goes through the "
    "shell; "
    "at "
    "the tip of a spike the sphere comes more than 40 A below; between two pieces lies a valley") {
  SAYS(lineSaying(kAVirusInTheHandLesson, "Between the three serines it sinks in about 10 Å, and then it is shut"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "a channel between them, more than 40 Å deep"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "how deep does it let you in before it stops you"));
  SAYS(lineSaying(kAVirusInTheHandLesson, "They look at each other across a valley"));
  // Below the middle of a sphere that rests on the top of the outermost knob.
  const auto depth_A = [](const std::string& knobs) {
    const Vec3 axis = axisOf(placesOf(knobs));
    double top_A = 0.0;
    for (const auto i : parseSelection(knobs)->select(shell()))
      top_A = std::max(top_A, glm::dot(shell().spheres[i].centre_A, axis) + shell().spheres[i].radius_A + 1.4);
    return top_A - stop_A(axis, 1.4);
  };
  const std::string three = "chain F F-10 F-23 and residue 188";
  CHECK(depth_A("chain G G-2 G-3 G-4 G-5 and residue 92") > 40.0);
  CHECK(depth_A(three) == doctest::Approx(10.0).epsilon(0.06));
  CHECK(depth_A("chain F F-6 and residue 80") > 3.0);
  // The shell's inner face lies farther in than 100 A.
  const Vec3 axis = axisOf(placesOf(three));
  CHECK(stop_A(axis, 0.0) < 100.0);
  CHECK(stop_A(axis, 1.4) == doctest::Approx(132.7).epsilon(0.005));
}
