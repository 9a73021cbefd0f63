// Oracles: closed forms, and the distances of the atoms from a tip lowered onto them, in long double.
#include "engine/haptics/height_field/scanning_tip.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/bench/scenes.h"

using namespace moltact;

namespace {

HeightField scanned(const std::vector<Sphere>& spheres, const ScanSetup& setup) {
  auto tip = ScanningTip::over(spheres, setup);
  REQUIRE(tip);
  tip->scanAll();
  return std::move(*tip).take();
}

// The gap between an atom and the tip whose apex is at (x, y, height): a ball, above it the cone that touches it.
long double gapOf(const Vec3& centre, double radius_A, double x, double y, long double height, const ScanSetup& s) {
  const long double angle = s.cone_deg * acosl(-1.0L) / 180.0L, sine = sinl(angle), cosine = cosl(angle);
  const long double dx = x - centre.x, dy = y - centre.y, d = sqrtl(dx * dx + dy * dy),
                    z = centre.z - (height + s.tip_A);
  if (s.cone_deg > 0.0 && d * sine + z * cosine >= 0.0L) return d * cosine - z * sine - s.tip_A - radius_A;
  return sqrtl(d * d + z * z) - s.tip_A - radius_A;
}

}  // namespace

TEST_CASE(
    "a tip of 10 A over one atom of 1.7 A draws a cap of radius 11.7 A, 3.4 A high and "
    "2 sqrt((R + r)^2 - R^2) = 12.15 A wide at half its height") {
  const std::vector<Sphere> atom{{{3, -2, 5}, 1.7}};
  const HeightField field = scanned(atom, {.tip_A = 10, .spacing_A = 0.05, .margin_A = 12});
  double worst = 0, highest = 0;
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const Vec3 node = field.frame.toMolecule({field.spacing_A * column, field.spacing_A * row, 0});
      CHECK(std::abs(node.z - 3.3) < 1e-12);  // the substrate
      const double d = std::hypot(node.x - 3, node.y + 2);
      const double cap = d < 11.7 ? 1.7 - 10 + std::sqrt(11.7 * 11.7 - d * d) : 0.0;
      worst = std::max(worst, std::abs(field.at(column, row) - std::max(0.0, cap)));
      highest = std::max(highest, field.at(column, row));
    }
  CHECK(worst < 1e-12);
  CHECK(std::abs(highest - 3.4) < 1e-3);
  const int middle = field.rows / 2;
  double width = 0;
  for (int column = 0; column + 1 < field.columns; ++column) {
    const double a = field.at(column, middle) - 1.7, b = field.at(column + 1, middle) - 1.7;
    if ((a < 0) != (b < 0)) width = field.spacing_A * (column + a / (a - b)) - width;
  }
  CHECK(std::abs(width - 2 * std::sqrt(11.7 * 11.7 - 100)) < 0.01);
}

TEST_CASE("two atoms 3 A apart meet in a crease, where a sharp tip sinks deeper than a blunt one") {
  const std::vector<Sphere> atoms{{{-1.5, 0, 0}, 1.7}, {{1.5, 0, 0}, 1.7}};
  double last = 10;
  for (const double tip_A : {20.0, 10.0, 5.0, 0.0}) {
    const HeightField field = scanned(atoms, {.tip_A = tip_A, .spacing_A = 0.1, .margin_A = 1});
    const Vec3 place = field.frame.toScan({0, 0, 0});
    const int column = int(std::lround(place.x / 0.1)), row = int(std::lround(place.y / 0.1));
    REQUIRE(std::abs(place.x - 0.1 * column) < 1e-9);
    const double crease = 1.7 - tip_A + std::sqrt((tip_A + 1.7) * (tip_A + 1.7) - 1.5 * 1.5);
    const double off = place.y - 0.1 * row;  // no node lies on the axis of the two atoms
    CHECK(std::abs(field.at(column, row) -
                   (1.7 - tip_A + std::sqrt((tip_A + 1.7) * (tip_A + 1.7) - 2.25 - off * off))) < 1e-12);
    CHECK(crease < last);
    last = crease;
  }
}

TEST_CASE(
    "at each node of five scans of 40 atoms in any orientation the tip, with a cone or without, overlaps no atom, and "
    "0.000001 A lower it overlaps one or the substrate") {
  scenes::Random random(11);
  for (int round = 0; round < 5; ++round) {
    const std::vector<Sphere> spheres = scenes::cluster(40, 20 + std::uint64_t(round)).spheres;
    const ScanSetup setup{.tip_A = random.uniform(0.0, 12.0),
                          .cone_deg = round % 2 ? random.uniform(5.0, 50.0) : 0.0,
                          .spacing_A = 0.7,
                          .margin_A = 8,
                          .orientation = glm::angleAxis(random.uniform(0.0, 3.0), random.direction())};
    CAPTURE(round);
    const HeightField field = scanned(spheres, setup);
    int overlapping = 0, floating = 0, wrong_atom = 0, on_atoms = 0;
    for (int row = 0; row < field.rows; ++row)
      for (int column = 0; column < field.columns; ++column) {
        const double x = field.spacing_A * column, y = field.spacing_A * row, height = field.at(column, row);
        long double gap = 1e9L, lower = 1e9L;
        for (const Sphere& s : spheres) {
          const Vec3 centre = field.frame.toScan(s.centre_A);
          gap = std::min(gap, gapOf(centre, s.radius_A, x, y, height, setup));
          lower = std::min(lower, gapOf(centre, s.radius_A, x, y, height - 1e-6L, setup));
        }
        overlapping += gap < -1e-10L;
        const std::int32_t atom = field.atoms[field.index(column, row)];
        floating += atom < 0 ? height != 0.0 : lower >= 0.0L;
        if (atom < 0) continue;
        ++on_atoms;
        const Sphere& s = spheres[std::size_t(atom)];
        wrong_atom += gapOf(field.frame.toScan(s.centre_A), s.radius_A, x, y, height, setup) > 1e-10L;
      }
    CHECK(overlapping + floating + wrong_atom == 0);
    CHECK(on_atoms > 200);
  }
}

TEST_CASE("100 pN press the tip 1 A into an atom's contact of 1 N/m, and into several as far as their sum carries") {
  const std::vector<Sphere> atom{{{0, 0, 0}, 1.7}};
  ScanSetup setup{.tip_A = 8, .spacing_A = 0.3, .margin_A = 4, .force_pN = 100, .contact_N_per_m = 1};
  CHECK(setup.sink_A() == 1.0);
  const HeightField pressed = scanned(atom, setup);
  setup.force_pN = 0;
  const HeightField contact = scanned(atom, setup);
  for (std::size_t k = 0; k < contact.heights_A.size(); ++k)
    CHECK(std::abs(pressed.heights_A[k] - std::max(0.0, contact.heights_A[k] - 1.0)) < 1e-12);

  const std::vector<Sphere> spheres = scenes::cluster(40, 7).spheres;
  setup.force_pN = 250;
  setup.contact_N_per_m = 2;
  const HeightField field = scanned(spheres, setup);
  int several = 0;
  double worst = 0;
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const double x = field.spacing_A * column, y = field.spacing_A * row;
      std::vector<long double> stops;
      for (const Sphere& s : spheres) {
        const Vec3 c = field.frame.toScan(s.centre_A);
        const long double reach = s.radius_A + 8.0L, d2 = (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y);
        if (d2 < reach * reach) stops.push_back(c.z - 8.0L + sqrtl(reach * reach - d2));
      }
      const auto force_pN = [&](long double z) {
        long double sum = 0;
        for (const long double stop : stops) sum += 200.0L * std::max(0.0L, stop - z);
        return sum;
      };
      long double low = 0, high = 60;
      if (force_pN(0) >= 250)
        for (int k = 0; k < 80; ++k) (force_pN((low + high) / 2) >= 250 ? low : high) = (low + high) / 2;
      else
        high = 0;
      worst = std::max(worst, double(fabsl(field.at(column, row) - high)));
      several += std::count_if(stops.begin(), stops.end(), [&](long double stop) { return stop > high; }) > 1;
    }
  CHECK(worst < 1e-9);
  CHECK(several > 100);
}

TEST_CASE("a scan grows line by line: after 3 of its lines they are final and the others 0") {
  const std::vector<Sphere> spheres = scenes::cluster(20, 5).spheres;
  const ScanSetup setup{.tip_A = 5, .spacing_A = 1.0, .margin_A = 0};
  const HeightField whole = scanned(spheres, setup);
  auto tip = ScanningTip::over(spheres, setup);
  REQUIRE(tip);
  for (int k = 0; k < 3; ++k) tip->scanLine();
  CHECK(tip->linesDone() == 3);
  CHECK_FALSE(tip->done());
  double after = 0;
  for (int row = 0; row < whole.rows; ++row)
    for (int column = 0; column < whole.columns; ++column)
      if (row < 3)
        CHECK(tip->field().at(column, row) == whole.at(column, row));
      else
        after += tip->field().at(column, row);
  CHECK(after == 0.0);
}

TEST_CASE("a scan leaves atoms out, and one without an atom, of 10^9 nodes or with NaN gives a problem with a remedy") {
  const std::vector<Sphere> atoms{{{0, 0, 0}, 1.7}, {{9, 0, 4}, 1.7}};
  const std::vector<std::uint32_t> second{1}, both{0, 1};
  auto one = ScanningTip::over(atoms, {}, second);
  REQUIRE(one);
  one->scanAll();
  CHECK(*std::max_element(one->field().heights_A.begin(), one->field().heights_A.end()) < 3.41);
  CHECK(ScanningTip::over(atoms, {}, both).problem().message == "there is no atom to scan");
  const std::vector<Sphere> apart{{{0, 0, 0}, 1.7}, {{1e6, 1e6, 0}, 1.7}};
  const auto large = ScanningTip::over(apart, {});
  REQUIRE_FALSE(large);
  CHECK(large.problem().message == "the scan would have more than 4000000 nodes");
  CHECK(large.problem().remedy == "choose a larger spacing");
  CHECK_FALSE(ScanningTip::over(atoms, {.tip_A = std::nan("")}));
  CHECK_FALSE(ScanningTip::over(atoms, {.spacing_A = 0}));
  CHECK_FALSE(ScanningTip::over(atoms, {.orientation = Quat(0, 0, 0, 0)}));
}
