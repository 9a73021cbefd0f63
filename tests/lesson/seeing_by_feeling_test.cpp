// The program's lesson on the scanning tip: its dents, widths and angles follow from two touching spheres, from the
// scan and from the tracker.
#include <algorithm>
#include <map>

#include "engine/haptics/height_field/scanning_tip.h"
#include "engine/haptics/methods.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

HeightField scanBy(std::span<const Sphere> spheres, double tip_A, double spacing_A, Quat orientation = kNoRotation) {
  auto tip = ScanningTip::over(
      spheres, {.tip_A = tip_A, .spacing_A = spacing_A, .margin_A = tip_A + 1.0, .orientation = orientation});
  REQUIRE(tip);
  tip->scanAll();
  return tip->field();
}

HeightField scanOf(const char* molecule, double tip_A, double spacing_A) {
  return scanBy((*shippedMolecule({molecule, {}}))->spheres, tip_A, spacing_A);
}

double highestOf(const HeightField& f) { return *std::max_element(f.heights_A.begin(), f.heights_A.end()); }

/// The extent along x and y of what is higher than half of the highest node (unit: angstrom).
std::pair<double, double> extentAtHalfHeight(const HeightField& f) {
  const double half = 0.5 * highestOf(f);
  int low_x = f.columns, high_x = -1, low_y = f.rows, high_y = -1;
  for (int y = 0; y < f.rows; ++y)
    for (int x = 0; x < f.columns; ++x)
      if (f.at(x, y) > half) {
        low_x = std::min(low_x, x), high_x = std::max(high_x, x);
        low_y = std::min(low_y, y), high_y = std::max(high_y, y);
      }
  return {f.spacing_A * (high_x - low_x), f.spacing_A * (high_y - low_y)};
}

/// The same along y, across the middle of the scan.
double widthInTheMiddle(const HeightField& f) {
  const double half = 0.5 * highestOf(f);
  int low = f.rows, high = -1;
  for (int y = 0; y < f.rows; ++y)
    if (f.at(f.columns / 2, y) > half) low = std::min(low, y), high = std::max(high, y);
  return f.spacing_A * (high - low);
}

/// How far the tip sinks from the highest to the lowest place along the middle of the row, within the five rings.
double dent(const HeightField& f, double half_row_A) {
  const int y = f.rows / 2, middle = f.columns / 2, reach = int(half_row_A / f.spacing_A);
  double low = 1e9, high = -1e9;
  for (int x = middle - reach; x <= middle + reach; ++x)
    low = std::min(low, f.at(x, y)), high = std::max(high, f.at(x, y));
  return high - low;
}

}  // namespace

TEST_CASE(
    "seeing-by-feeling.md, and the same in German, asks a dark task before and after with the same tip, in a core of 6 "
    "steps and 4 extra ones") {
  for (const char* file : {"seeing-by-feeling", "seeing-by-feeling.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 4);
    CHECK(lesson.steps.size() == 10);
    CHECK(tasksOf(lesson, "same") == 2);
    CHECK(tasksOf(lesson, "find") == 1);
    CHECK(tasksOf(lesson, "trace") == 3);
    // While a prediction is open or the screen is dark, no scan draws the answer.
    for (const Step& step : lesson.steps) {
      CAPTURE(step.title);
      const bool asks =
          std::any_of(step.questions.begin(), step.questions.end(), [](const Question& q) { return q.prediction; });
      const bool dark = std::any_of(step.tasks.begin(), step.tasks.end(),
                                    [](const TaskSpec& t) { return t.kind == "same" || t.kind == "find"; });
      if (asks || dark) CHECK(step.scene.scan_A == 0.0);
    }
  }
}

TEST_CASE(
    "into each ring of pentacene a tip of 0.5 A sinks by 0.39 A, one of 5 A by 0.11 A and one of 20 A by 0.03 A, by "
    "the "
    "closed form for two carbons at a bond and six round a ring, and in the scan") {
  SAYS(
      linesSaying("seeing-by-feeling", {"sinks by 0.39 Å from the bond before it",
                                        "by 0.11 Å with 5 Å and by 0.03 Å with 20 Å", "0.03 Å deep, instead of 0.39"}));
  const std::map<double, double> said_A{{0.5, 0.39}, {5.0, 0.11}, {20.0, 0.03}};
  for (const auto& [tip_A, dent_A] : said_A) {
    CAPTURE(tip_A);
    const double reach = tip_A + 1.70, at_bond = 0.5 * 1.397, at_ring = 1.397;
    const double closed = std::sqrt(reach * reach - at_bond * at_bond) - std::sqrt(reach * reach - at_ring * at_ring);
    CHECK(std::round(closed * 100) / 100 == doctest::Approx(dent_A));
    CHECK(dent(scanOf("pentacene", tip_A, 0.1), 5.0) == doctest::Approx(closed).epsilon(0.02));
  }
}

TEST_CASE(
    "half way up, pentacene is drawn 8.2 A, 12.2 A and 19.6 A wide by tips of 0.5 A, 5 A and 20 A, the last one 29 A "
    "long, and it is 3.4 A high in every picture") {
  SAYS(linesSaying("seeing-by-feeling", {"8.2 Å wide with the tip of 0.5 Å, 12.2 Å with 5 Å and 19.6 Å with 20 Å",
                                         "its balls alone are 7.2 Å wide there", "and 29 Å long"}));
  const std::map<double, double> said_A{{0.0, 7.2}, {0.5, 8.2}, {5.0, 12.2}, {20.0, 19.6}};
  for (const auto& [tip_A, wide_A] : said_A) {
    CAPTURE(tip_A);
    const HeightField f = scanOf("pentacene", tip_A, 0.1);
    CHECK(widthInTheMiddle(f) == doctest::Approx(wide_A).epsilon(0.012));
    CHECK(highestOf(f) == doctest::Approx(3.40).epsilon(0.01));
    if (tip_A == 20.0) CHECK(extentAtHalfHeight(f).first == doctest::Approx(29).epsilon(0.01));
  }
}

TEST_CASE(
    "an argon atom on flat ground is drawn 4.7 A, 9.5 A and 17.7 A wide half way up, by the closed form and in the "
    "scan, and as high as it is") {
  SAYS(linesSaying("seeing-by-feeling", {"these are 4.7 Å with a tip of 0.5 Å, 9.5 Å with 5 Å and 17.7 Å with 20 Å",
                                         "number: 17.7 Å", "21.88 Å: 20 Å of the tip and 1.88 Å of the atom"}));
  const std::map<double, double> said_A{{0.0, 3.8}, {0.5, 4.7}, {5.0, 9.5}, {20.0, 17.7}};
  for (const auto& [tip_A, wide_A] : said_A) {
    CAPTURE(tip_A);
    const double reach = tip_A + 1.88;
    const double closed = 2.0 * std::sqrt(reach * reach - tip_A * tip_A);
    CHECK(std::round(closed * 10) / 10 == doctest::Approx(wide_A));
    const HeightField f = scanOf("argon", tip_A, 0.05);
    CHECK(extentAtHalfHeight(f).first == doctest::Approx(closed).epsilon(0.015));
    CHECK(highestOf(f) == doctest::Approx(3.76).epsilon(0.001));
  }
}

TEST_CASE(
    "in the crease between two argon atoms the force of the exact method turns by 104 degrees under a tip of 0.5 A, by "
    "32 under 5 A and by 10 under 20 A, and the pair is drawn 3.76 A high") {
  SAYS(lineSaying("seeing-by-feeling",
                  "turned by 32° at once. With the tip of 0.5 Å it turns by 104°, with that of 20"));
  const ShippedScene pair("argon-pair");
  const auto spheres = std::make_shared<const SphereGrid>(pair.molecule->spheres);
  const std::map<double, double> said_deg{{0.5, 104}, {5.0, 32}, {20.0, 10}};
  for (const auto& [tip_A, turn_deg] : said_deg) {
    CAPTURE(tip_A);
    const double closed = 2.0 * std::asin(1.88 / (1.88 + tip_A)) * 180 / std::numbers::pi;
    CHECK(std::round(closed) == turn_deg);
    // The hand slides along the pair at a depth of 0.001 A under the crease; the contact's normal jumps there.
    const auto exact = findMethod("exact")->make(spheres, tip_A);
    const double reach = tip_A + 1.88, low = std::sqrt(reach * reach - 1.88 * 1.88) - 0.001;
    exact->step({Vec3(-0.5, 0.003, reach + 1.0)});
    double greatest = 0.0;
    std::optional<Vec3> before;
    for (double x = -0.5; x <= 0.5; x += 0.002) {
      const Contact c = exact->step({Vec3(x, 0.003, low)});
      if (c.feature != Feature::Sphere) continue;
      const Vec3 normal = glm::normalize(c.scp.A - (*spheres)[std::size_t(c.atoms[0])].centre_A);
      if (before) greatest = std::max(greatest, std::acos(std::min(1.0, glm::dot(*before, normal))));
      before = normal;
    }
    CHECK(greatest * 180 / std::numbers::pi == doctest::Approx(closed).epsilon(0.02));
    CHECK(highestOf(scanOf("argon-pair", tip_A, 0.1)) == doctest::Approx(3.76).epsilon(0.002));
  }
}

TEST_CASE(
    "pressed in the middle of the view, where the dark tasks put the hand, a tip of 5 A rests on the single atom, or "
    "in "
    "the crease of the pair, and slides up and down over both") {
  const Lesson lesson = shippedLesson("seeing-by-feeling");
  const ShippedScene s("argon-shapes");
  const auto spheres = std::make_shared<const SphereGrid>(s.molecule->spheres);
  for (const char* step : {"what-does-your-hand-tell-already", "one-atom-or-two"}) {
    const auto at = lesson.find(step);
    REQUIRE(at);
    CHECK(lesson.steps[*at].scene.touch.probe_A == 5.0);
    CHECK(lesson.steps[*at].tasks.at(0).values["trials"].number == 8);
  }
  const auto press = [&](Vec3 out, Vec3 aside) {
    const auto exact = findMethod("exact")->make(spheres, 5.0);
    Contact contact;
    for (double r = 17.0; r > 14.0; r -= 0.01) contact = exact->step({out * r + aside});
    return contact;
  };
  const Contact one = press({0, 0, 1}, {0.02, 0.01, 0}), two = press({1, 0, 0}, {0, 0.0, 0.01});
  CHECK(one.feature == Feature::Sphere);
  CHECK(two.feature == Feature::Circle);
  // 1 A up or down the single atom still holds the tip alone, and one of the pair.
  CHECK(press({0, 0, 1}, {0.02, 1.0, 0}).atoms[0] == one.atoms[0]);
  CHECK(press({1, 0, 0}, {0, 1.0, 0.01}).feature == Feature::Sphere);
  CHECK(press({1, 0, 0}, {0, 1.0, 0.01}).atoms[0] != press({1, 0, 0}, {0, -1.0, 0.01}).atoms[0]);
}

TEST_CASE(
    "the end of ubiquitin's tail has the fewest atoms round it, and a tip of 5 A meets it over more than twice the "
    "area "
    "of one of 0.5 A") {
  SAYS(linesSaying("seeing-by-feeling", {"Its narrowest part is a tail, and the tail ends in amino acid 76",
                                         "A blunt tip would meet it more often"}));
  const ShippedScene u("1ubq");
  std::vector<std::pair<int, int>> crowd;
  for (int residue = 1; residue <= 76; ++residue) {
    const Vec3 ca = u.atom("residue " + std::to_string(residue) + " and name CA").position.A;
    int near = 0;
    for (const Sphere& a : u.molecule->spheres) near += glm::distance(a.centre_A, ca) < 8.0;
    crowd.emplace_back(near, residue);
  }
  std::sort(crowd.begin(), crowd.end());
  CHECK(crowd[0].second == 76);
  CHECK(crowd[1].second == 75);
  CHECK(crowd[3].first > 1.5 * crowd[0].first);
  Vec3 middle(0.0), tail(0.0);
  for (const Sphere& a : u.molecule->spheres) middle += a.centre_A / double(u.molecule->spheres.size());
  const auto end = u.select("residue 76");
  for (const std::uint32_t i : end) tail += u.molecule->spheres[i].centre_A / double(end.size());
  const Vec3 to_eye = glm::normalize(tail - middle), up(0, 0, 1);
  const Quat facing = glm::normalize(Quat(1.0 + glm::dot(up, to_eye), glm::cross(up, to_eye)));
  const auto area = [&](double tip_A) {
    const HeightField f = scanBy(u.molecule->spheres, tip_A, 0.5, facing);
    return 0.25 * double(std::count_if(f.atoms.begin(), f.atoms.end(), [&](std::int32_t a) {
             return a >= 0 && std::binary_search(end.begin(), end.end(), std::uint32_t(a));
           }));
  };
  const double sharp = area(0.5), blunt = area(5.0);
  MESSAGE("the end of the tail is met over " << sharp << " A2 with a tip of 0.5 A, " << blunt << " A2 with 5 A");
  CHECK(sharp > 5.0);
  CHECK(blunt > 2.0 * sharp);
}

TEST_CASE("the helix that is scanned unseen is 35 A long, and three times as high as pentacene") {
  SAYS(linesSaying("seeing-by-feeling", {"35 Å long", "three times as high"}));
  const ShippedScene helix("alpha-helix");
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& a : helix.molecule->spheres)
    low = glm::min(low, a.centre_A - a.radius_A), high = glm::max(high, a.centre_A + a.radius_A);
  const Vec3 extent = high - low;
  std::array<double, 3> sides{extent.x, extent.y, extent.z};
  std::sort(sides.begin(), sides.end());
  CHECK(sides[2] == doctest::Approx(35).epsilon(0.02));
  CHECK(sides[0] / 3.4 == doctest::Approx(3).epsilon(0.1));
  CHECK(sides[1] / 3.4 == doctest::Approx(3).epsilon(0.1));
}
