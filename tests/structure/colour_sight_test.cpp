// Shades that are distinguishable with every kind of colour vision.
#include "engine/structure/colour_sight.h"

#include <doctest/doctest.h>

#include "tests/structure/seen_colours.h"

using namespace moltact;
using test::ciede2000;

namespace {

double least(const Rgb8& a, const Rgb8& b) {
  double out = 1e9;
  for (const test::Sight s : test::kSights) out = std::min(out, test::seenDistance(s, a, b));
  return out;
}

Rgb8 colourSightNamed(std::string_view name) { return *parseColour(name); }

}  // namespace

TEST_CASE(
    "the distance of the tests gives the values of pairs 1, 7, 13, 17, 21 and 34 of Sharma, Wu and Dalal (2005)") {
  CHECK(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}) == doctest::Approx(2.0425).epsilon(1e-4));
  CHECK(ciede2000({50, 0, 0}, {50, -1, 2}) == doctest::Approx(2.3669).epsilon(1e-4));
  CHECK(ciede2000({50, -0.001, 2.49}, {50, 0.0009, -2.49}) == doctest::Approx(4.8045).epsilon(1e-4));
  CHECK(ciede2000({50, 2.5, 0}, {73, 25, -18}) == doctest::Approx(27.1492).epsilon(1e-4));
  CHECK(ciede2000({50, 2.5, 0}, {50, 3.1736, 0.5854}) == doctest::Approx(1.0).epsilon(1e-4));
  CHECK(ciede2000({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}) == doctest::Approx(0.9082).epsilon(1e-3));
}

TEST_CASE("named colours that are nearer than 10 by one simulation of sight are nearer than 18 by the other") {
  // A colour-blind eye takes green for red, and for normal sight the two are far apart.
  CHECK(test::seenDistance(test::Sight::Normal, colourSightNamed("green"), colourSightNamed("red")) > 50.0);
  CHECK(minSeenDistance(colourSightNamed("green"), colourSightNamed("red")) < 10.0);
  CHECK(least(colourSightNamed("green"), colourSightNamed("red")) < 10.0);
  for (const NamedColour& a : namedColours())
    for (const NamedColour& b : namedColours()) {
      CAPTURE(a.name);
      CAPTURE(b.name);
      const double ours = minSeenDistance(a.colour, b.colour), others = least(a.colour, b.colour);
      if (std::min(ours, others) < 10.0) CHECK(std::max(ours, others) < 18.0);
    }
}

TEST_CASE(
    "colours that are distinct stay unchanged; green and red are shaded until they differ by 10 for "
    "every kind of colour vision") {
  const Rgb8 apart[] = {colourSightNamed("sky"), colourSightNamed("yellow")};
  CHECK(shadesApart(apart, {}, {}) == std::vector<Rgb8>{colourSightNamed("sky"), colourSightNamed("yellow")});
  const Rgb8 near[] = {colourSightNamed("green"), colourSightNamed("red")};
  const std::vector<Rgb8> shaded = shadesApart(near, {}, {});
  REQUIRE(shaded.size() == 2);
  CHECK(least(near[0], near[1]) < 10.0);
  CHECK(least(shaded[0], shaded[1]) > 10.0);
  for (int k = 0; k < 2; ++k) {
    // A shade is a mixture with white or black, so that the strongest channel stays the strongest.
    const auto strongest = [](const Rgb8& c) { return std::max_element(c.begin(), c.end()) - c.begin(); };
    CHECK(strongest(shaded[std::size_t(k)]) == strongest(near[k]));
  }
}

TEST_CASE("a mark of the target's own colour moves away from it, and one of an atom's colour from the atom") {
  const Rgb8 target{0xFF, 0xB0, 0x00}, carbon{144, 144, 144}, wanted[] = {target};
  const std::vector<Rgb8> shaded = shadesApart(wanted, wanted, {});
  CHECK(least(shaded[0], target) > 10.0);
  const Rgb8 grey[] = {carbon};
  CHECK(least(shadesApart(grey, {}, grey)[0], carbon) > 5.0);
}

TEST_CASE("of 40 marks none is lost, and ten of one colour become at least three shades") {
  std::vector<Rgb8> many;
  for (int k = 0; k < 40; ++k) many.push_back(namedColours()[std::size_t(k) % namedColours().size()].colour);
  CHECK(shadesApart(many, {}, {}).size() == 40);
  const std::vector<Rgb8> ten(10, colourSightNamed("blue"));
  std::vector<Rgb8> shades = shadesApart(ten, {}, {});
  std::sort(shades.begin(), shades.end());
  CHECK(std::unique(shades.begin(), shades.end()) - shades.begin() >= 3);
}
