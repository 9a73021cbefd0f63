// The program's lesson on porin: what passes its eyelet, and which atoms surround it, agrees with the entry. What stands
// here cannot be a fact of the lesson. Facts know neither a path through a ring, nor where a sphere comes to rest, nor an
// area, nor a side of a ring. Nor do they know the record of strands, or a hand that does a task.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "engine/lesson/passable.h"
#include "tests/lesson/room_for_a_ball.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kLesson = "a-hole-in-the-membrane";

// The barrel's middle; its axis is that of the file's z, along which the entry's three barrels are turned into one
// another.
constexpr double kMiddleX_A = 4.5, kMiddleY_A = -23.4;

bool inBarrel(const Vec3& p) { return std::hypot(p.x - kMiddleX_A, p.y - kMiddleY_A) < 13.0; }

/// Whether a sphere comes through the narrow part of one barrel, from the mouth's side.
bool passesEyelet(const ShippedScene& porin, double sphere_A) {
  RoomForASphere room(porin.spheres, sphere_A, {-8.5, -36.4, 14.0}, {17.5, -10.4, 36.0}, 0.15);
  room.fillFromAbove(inBarrel);
  return room.through();
}

/// The radius of a sphere with the volume of one molecule in a crystal of this density (unit: A).
double radiusOfVolume_A(double g_per_mol, double g_per_cm3) {
  const double volume_A3 = g_per_mol / (0.602214 * g_per_cm3);
  return std::cbrt(3.0 * volume_A3 / (4.0 * std::numbers::pi));
}

}  // namespace

TEST_CASE(
    "a-hole-in-the-membrane.md has 8 steps and an aside, a largest sphere, a search and trials in the dark, and scenes "
    "with "
    "1 A to 7 A") {
  const Lesson lesson = shippedLesson(kLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 9);
  CHECK(lesson.steps.back().aside);
  CHECK(tasksOf(lesson, "find") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
  CHECK(tasksOf(lesson, "cross") == 2);
  CHECK(tasksOf(lesson, "fit") == 1);
  for (const double probe : {1.0, 1.4, 3.0, 3.6, 7.0}) {
    bool met = false;
    for (const Step& s : lesson.steps) met = met || s.scene.touch.probe_A == probe;
    CHECK_MESSAGE(met, probe);
  }
}

TEST_CASE("the largest sphere that passes the eyelet has 4.2 A: 4.1 A passes and 4.3 A does not; sugar of 3.6 A does") {
  SAYS(lineSaying(kLesson, "The largest ball has 4.2 Å"));
  SAYS(lineSaying(kLesson, "takes as much room as a ball of 3.6 Å"));
  const ShippedScene porin("2por");
  for (const double sphere_A : {1.0, 1.4, 3.0, 3.6, 4.1}) CHECK_MESSAGE(passesEyelet(porin, sphere_A), sphere_A);
  for (const double sphere_A : {4.3, 5.0, 7.0}) CHECK_MESSAGE(!passesEyelet(porin, sphere_A), sphere_A);
}

TEST_CASE(
    "at the narrowest place a sphere of 4.1 A lies within 0.3 A of Asp 93, Asp 108, Arg 26 and a calcium ion at once") {
  SAYS(lineSaying(kLesson, "it lies against Asp 93, Asp 108, Arg 26 and a calcium ion at once"));
  SAYS(lineSaying(kLesson, "between arginine 26 on the one side and aspartates 93 and 108 on the other"));
  const ShippedScene porin("2por");
  const Vec3 narrowest_A(0.54, -17.88, 24.0);
  const auto gapTo = [&](const Sphere& b) { return glm::distance(narrowest_A, b.centre_A) - b.radius_A - 4.1; };
  for (std::size_t i = 0; i < porin.spheres.size(); ++i) CHECK(gapTo(porin.spheres[i]) > -0.05);
  for (const char* by :
       {"residue 26 and name NH1", "residue 93 and name OD2", "residue 108 and name OD1", "residue 303"}) {
    CAPTURE(by);
    CHECK(gapTo(porin.spheres[porin.select(by).at(0)]) < 0.3);
  }
}

TEST_CASE(
    "a sphere of 7 A gets into the barrel and rests about 9 A above the eyelet, on Glu 109, Asp 95 and Asp 96; the "
    "mouth "
    "is open to one of 8 A") {
  SAYS(lineSaying(kLesson, "The eyelet is some 9 Å below you"));
  SAYS(lineSaying(kLesson, "A ball of 7 Å is stopped by Glu 109, Asp 95 and Asp 96"));
  SAYS(lineSaying(kLesson, "So wide is the mouth of the barrel"));
  const ShippedScene porin("2por");
  const auto lowestOf = [&](double sphere_A) {
    RoomForASphere room(porin.spheres, sphere_A, {-12.0, -38.0, 20.0}, {22.0, -8.0, 68.0}, 0.25);
    room.fillFromAbove([](const Vec3& p) { return std::hypot(p.x - kMiddleX_A, p.y - kMiddleY_A) < 11.0; });
    REQUIRE(room.lowest());
    return *room.lowest();
  };
  const Vec3 rest = lowestOf(7.0), eyelet = lowestOf(4.3);
  const double ring_z_A =
      (porin.atom("residue 26 and name NH1").position.A.z + porin.atom("residue 93 and name OD2").position.A.z +
       porin.atom("residue 108 and name OD1").position.A.z) /
      3.0;
  CHECK(rest.z - ring_z_A == doctest::Approx(9.0).epsilon(0.06));
  CHECK(eyelet.z > ring_z_A);
  CHECK(lowestOf(8.0).z < 42.0);
  for (const char* holds : {"residue 109 and name OE1", "residue 95", "residue 96"}) {
    CAPTURE(holds);
    double gap_A = 1e9;
    for (const auto i : porin.select(holds))
      gap_A = std::min(gap_A, glm::distance(rest, porin.spheres[i].centre_A) - porin.spheres[i].radius_A - 7.0);
    CHECK(gap_A < 0.5);
  }
}

TEST_CASE(
    "in the middle between the three barrels, where a 1.4 A probe is stopped by Val 51, there is no way for water") {
  SAYS(lineSaying(kLesson, "Along the axis between the three chains the narrowest place takes a ball of 0.7 Å"));
  SAYS(lineSaying(kLesson, "called: the bottom of the hollow in the middle"));
  auto molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/2por.pdb", {.assembly = "1"});
  REQUIRE(molecule);
  const SphereGrid spheres(molecule->spheres);
  CHECK(spheres.size() == 3 * 2222);
  double narrowest_A = 1e9;
  for (double z = 0.0; z < 50.0; z += 0.05)
    for (std::size_t i = 0; i < spheres.size(); ++i)
      narrowest_A = std::min(narrowest_A, glm::distance(Vec3(0, 0, z), spheres[i].centre_A) - spheres[i].radius_A);
  CHECK(narrowest_A == doctest::Approx(0.7).epsilon(0.1));
  RoomForASphere room(spheres, 1.4, {-9.0, -9.0, 4.0}, {9.0, 9.0, 40.0}, 0.2);
  room.fillFromAbove([](const Vec3& p) { return std::hypot(p.x, p.y) < 8.0; });
  CHECK_FALSE(room.through());
  REQUIRE(room.lowest());
  const Vec3 stopped = *room.lowest();
  CHECK(std::hypot(stopped.x, stopped.y) < 8.0);
}

TEST_CASE("the arginines 9, 24, 26 and lysine 46 stand on one side of the eyelet, six acids on the other") {
  SAYS(lineSaying(kLesson, "Round the eyelet stand Arg 9, Arg 24, Arg 26 and Lys 46 on one side"));
  SAYS(lineSaying(kLesson, "and Glu 80, Asp 93, Asp 95, Asp 101, Asp 108 and Glu 109 on the other"));
  const ShippedScene porin("2por");
  const auto middleOf = [&](const std::string& text) {
    Vec3 sum(0.0);
    const auto atoms = porin.select(text);
    for (const auto i : atoms) sum += porin.spheres[i].centre_A / double(atoms.size());
    return sum;
  };
  const auto endsOf = [&](const std::string& residue) {
    return middleOf("residue " + residue + " and name NH1 NH2 NZ OD1 OD2 OE1 OE2");
  };
  const Vec3 positive = 0.25 * (endsOf("9") + endsOf("24") + endsOf("26") + endsOf("46"));
  Vec3 negative(0.0);
  for (const char* r : {"80", "93", "95", "101", "108", "109"}) negative += endsOf(r) / 6.0;
  Vec3 across = negative - positive;
  across.z = 0.0;
  across = glm::normalize(across);
  double most_positive = -1e9, least_negative = 1e9;
  for (const char* r : {"9", "24", "26", "46"}) most_positive = std::max(most_positive, glm::dot(endsOf(r), across));
  for (const char* r : {"80", "93", "95", "101", "108", "109"})
    least_negative = std::min(least_negative, glm::dot(endsOf(r), across));
  CHECK(least_negative > most_positive);
}

TEST_CASE("of the belt between 6 A and 30 A over two thirds are greasy and less than a tenth is charged; 16 strands") {
  SAYS(lineSaying(kLesson, "more than two thirds belong to Ala, Val, Leu, Ile, Pro, Met, Phe and Trp"));
  SAYS(lineSaying(kLesson, "Each barrel has 16 strands"));
  const ShippedScene porin("2por");
  const auto shareOf = [&](const std::string& text) {
    double area = 0.0;
    for (const auto i : porin.select(text)) {
      const std::uint32_t one[] = {i};
      const double grown = porin.spheres[i].radius_A + 1.4;
      for (SurfacePlace p : facePlaces(porin.spheres, one, 1.4, 100)) {
        if (p.scp_A.z < 6.0 || p.scp_A.z > 30.0) continue;
        p.outward = glm::normalize(Vec3(p.scp_A.x - kMiddleX_A, p.scp_A.y - kMiddleY_A, 0.0));
        if (openFromOutside(porin.spheres, p, 1.4)) area += grown * grown;
      }
    }
    return area;
  };
  const double all = shareOf("protein"), greasy = shareOf("hydrophobic"), charged = shareOf("charged");
  CHECK(greasy > 0.667 * all);
  CHECK(charged < 0.1 * all);
  std::ifstream in(MOLTACT_SOURCE_DIR "/molecules/2por.pdb");
  std::string line;
  int strands = 0;
  for (; std::getline(in, line);) strands += line.rfind("SHEET ", 0) == 0;
  CHECK(strands - 1 == 16);  // the first strand is repeated at the end, because the sheet is closed
}

TEST_CASE(
    "spheres of the room that a molecule takes up in its crystal: glucose 3.6 A, sucrose 4.4 A, vancomycin 7.3 A") {
  CAPTURE(
      lineSaying(kLesson, "glucose 180 g/mol at 1.55 g/cm³ gives 3.6 Å, sucrose 342 g/mol at 1.59 g/cm³ gives 4.4 Å"));
  SAYS(lineSaying(kLesson, "at 1.4 g/cm³ to 1.5 g/cm³ that is a ball of 7.3 Å"));
  SAYS(lineSaying(kLesson, "Vancomycin is eight times as heavy as glucose"));
  CHECK(radiusOfVolume_A(180.16, 1.55) == doctest::Approx(3.6).epsilon(0.01));
  CHECK(radiusOfVolume_A(342.30, 1.59) == doctest::Approx(4.4).epsilon(0.01));
  CHECK(radiusOfVolume_A(1449.3, 1.5) == doctest::Approx(7.3).epsilon(0.015));
  CHECK(radiusOfVolume_A(1449.3, 1.4) == doctest::Approx(7.3).epsilon(0.02));
  CHECK(1449.3 / 180.16 == doctest::Approx(8.0).epsilon(0.01));
}

TEST_CASE(
    "the largest sphere that the program leads through the ring has 3.9 A, and answers from 3.5 A count: what the grid "
    "finds, 4.2 A, lies 0.3 A above it") {
  SAYS(lineSaying(kLesson, "finds 3.9 Å. It takes any answer that lies at most 0.4 Å below that"));
  const Lesson lesson = shippedLesson(kLesson);
  const ShippedScene porin("2por");
  const TaskSpec& spec = taskOf(lesson, "the-largest-ball-that-passes", "fit");
  CHECK(spec.values["way"].text == "through");
  CHECK(spec.values["within"].number == doctest::Approx(0.4));
  const auto ring = ringOf(porin.spheres, porin.select(spec.values["fit"].selection.text()));
  REQUIRE(ring);
  CHECK(ring->centre_A.z == doctest::Approx(24.0).epsilon(0.1));
  CHECK(pathThrough(porin.spheres, *ring, 3.85));
  CHECK_FALSE(pathThrough(porin.spheres, *ring, 3.95));
}

TEST_CASE("of the belt's atoms at least 24 look outward, and all lie between 4 A and 32 A along the axis") {
  const Lesson lesson = shippedLesson(kLesson);
  const ShippedScene porin("2por");
  const std::string belt = taskOf(lesson, "what-holds-a-barrel-in-an-oily-wall", "feel").values["of"].selection.text();
  SAYS(lineSaying(kLesson, "highlight: " + belt));
  const auto atoms = porin.select(belt);
  std::size_t open = 0;
  for (const auto i : atoms) {
    CHECK(porin.spheres[i].centre_A.z > 4.0);
    CHECK(porin.spheres[i].centre_A.z < 32.0);
    const std::uint32_t one[] = {i};
    const auto places = facePlaces(porin.spheres, one, 1.4, 300);
    open += std::any_of(places.begin(), places.end(), [&](SurfacePlace p) {
      p.outward = glm::normalize(Vec3(p.scp_A.x - kMiddleX_A, p.scp_A.y - kMiddleY_A, 0.0));
      return openFromOutside(porin.spheres, p, 1.4);
    });
  }
  CHECK(open >= 24);  // twice as many as are asked for
}

TEST_CASE("from the ring to what lies below it comes a hand that slides, none that jabs or stays on the ring") {
  const Lesson lesson = shippedLesson(kLesson);
  const ShippedScene porin("2por");
  const TaskSpec& spec = taskOf(lesson, "sugar", "cross");
  const std::vector<std::string> down{"residue 26 and name NH1", "residue 46 and name NZ"};
  const Vec3 out(0, 0, 1);
  CHECK(passes(spec, porin, down, out, false));
  CHECK_FALSE(passes(spec, porin, down, out, true));
  CHECK_FALSE(passes(spec, porin, {down[0]}, out, false));
  CHECK_FALSE(passes(spec, porin, {down[1]}, out, false));
}
