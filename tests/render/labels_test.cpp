// Labels, arrows and measurements in a picture: their places, that they neither overlap nor show through atoms, and
// their lines. Expected places come from the projection.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/render/colour_legend.h"
#include "engine/render/label_painter.h"
#include "engine/structure/colouring.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// Every letter 8 pixels wide, 16 high.
const LabelRoom kRoom{400, 300, 1.0,
                      [](const std::string& text) { return glm::dvec2(8.0 * double(text.size()), 16.0); }};

ViewScene sceneWith(Annotations annotations, std::vector<PlacedAtom> atoms = {atom(Vec3(0), 2.0, 6)}) {
  ViewScene scene;
  scene.molecule = molecule(std::move(atoms));
  scene.camera = frontCamera(40);
  scene.shown = {ViewPart::Atoms};
  scene.annotations.push_back(std::make_shared<const Annotations>(std::move(annotations)));
  return scene;
}

Annotations named(std::vector<Annotations::Label> labels) {
  Annotations a;
  a.labels = std::move(labels);
  return a;
}

bool apart(const PlacedLabel& a, const PlacedLabel& b) {
  return a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y;
}

}  // namespace

TEST_CASE("a name stands over its place; an arrow's name stands 58 pixels beside it and its head touches the place") {
  const ViewScene scene =
      sceneWith(named({{.at = {Vec3(-4, 2, 0)}, .clear_A = 1, .text = "plain"},
                       {.at = {Vec3(3, -2, 0)}, .clear_A = 1, .text = "pointed", .arrow = true, .always = true}}));
  const auto placed = layOutLabels(scene, nullptr, kRoom);
  REQUIRE(placed.size() == 2);
  for (const PlacedLabel& l : placed) {
    const Vec3 px = scene.camera.project({l.arrow ? Vec3(3, -2, 0) : Vec3(-4, 2, 0)}, 400, 300);
    CHECK(glm::distance(l.tip, glm::dvec2(px)) < 1e-9);
    const ArrowShape arrow = arrowOf(l, 1.0);
    CHECK(arrow.drawn == l.arrow);
    if (!l.arrow) {
      CHECK(glm::distance(0.5 * (l.low + l.high), l.tip) < 1.5);
      continue;
    }
    const double reach = glm::distance(glm::clamp(l.tip, l.low, l.high), l.tip);
    CHECK(reach > 40.0);
    CHECK(reach < 62.0);
    CHECK(glm::distance(arrow.neck, l.tip) == doctest::Approx(11.0));
  }
}

TEST_CASE("of 300 names at random places none overlaps another or leaves the picture, and the nearest are there") {
  const unsigned seed = 3;
  CAPTURE(seed);
  std::vector<Annotations::Label> labels;
  std::uint32_t state = seed;
  const auto random = [&] { return double((state = state * 1664525u + 1013904223u) >> 8) / double(1u << 24) - 0.5; };
  for (int k = 0; k < 300; ++k)
    labels.push_back({.at = {16.0 * Vec3(random(), random(), random())}, .clear_A = 1, .text = std::to_string(k)});
  const ViewScene scene = sceneWith(named(labels));
  const auto placed = layOutLabels(scene, nullptr, kRoom);
  CHECK(placed.size() > 15);
  for (std::size_t a = 0; a < placed.size(); ++a) {
    CHECK(placed[a].low.x >= 0);
    CHECK(placed[a].low.y >= 0);
    CHECK(placed[a].high.x <= 400);
    CHECK(placed[a].high.y <= 300);
    for (std::size_t b = 0; b < a; ++b) CHECK(apart(placed[a], placed[b]));
  }
}

TEST_CASE(
    "what an atom hides is not named; an author's own name for it is faint, and at full strength from the other side") {
  const std::vector<PlacedAtom> two{atom(Vec3(0, 0, 6), 3.0, 6), atom(Vec3(0, 0, -6), 1.5, 7)};
  const SphereGrid spheres(molecule(two)->spheres);
  for (const bool own : {false, true}) {
    ViewScene scene =
        sceneWith(named({{.at = {Vec3(0, 0, -6)}, .clear_A = 1.5, .text = "behind", .always = own}}), two);
    const auto hidden = layOutLabels(scene, &spheres, kRoom);
    CHECK(hidden.size() == (own ? 1 : 0));
    if (own) CHECK(hidden[0].strength < 1.0);
    scene.camera.orbit(3.14159265, 0.0);
    const auto seen = layOutLabels(scene, &spheres, kRoom);
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].strength == 1.0);
    // A cartoon hides nothing that its spheres would.
    scene.camera.orbit(3.14159265, 0.0);
    scene.look.styles = {{.style = DrawStyle::Cartoon}};
    CHECK(layOutLabels(scene, &spheres, kRoom).size() == 1);
  }
}

TEST_CASE("a measure is written in the middle of a length, at the corner of an angle and on the bond of a torsion") {
  const auto point = [](double x, double y) { return PointA{Vec3(x, y, 0)}; };
  for (const auto& [places, where] :
       {std::pair{std::vector{point(-4, 0), point(2, 0)}, point(-1, 0)},
        std::pair{std::vector{point(-4, 0), point(0, 3), point(4, 0)}, point(0, 3)},
        std::pair{std::vector{point(-6, 0), point(-2, 3), point(2, 3), point(6, 0)}, point(0, 3)}}) {
    Annotations a;
    a.measures.push_back({places, "value"});
    const ViewScene scene = sceneWith(std::move(a));
    const auto placed = layOutLabels(scene, nullptr, kRoom);
    REQUIRE(placed.size() == 1);
    CHECK(placed[0].measure);
    CHECK(glm::distance(placed[0].tip, glm::dvec2(scene.camera.project(where, 400, 300))) < 1e-6);
  }
}

TEST_CASE("names written into a picture change it within their boxes and along their arrows, and nowhere else") {
  const ViewScene scene =
      sceneWith(named({{.at = {Vec3(3, -2, 0)}, .clear_A = 1, .text = "haem", .arrow = true, .always = true}}));
  const Picture before = drawn(scene, 400, 300);
  Picture after = before;
  if (!paintLabels(after, scene, nullptr, 1.0)) {
    MESSAGE("no font is installed: nothing could be written");
    return;
  }
  int within = 0, beyond = 0;
  const Vec3 tip = scene.camera.project({Vec3(3, -2, 0)}, 400, 300);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const bool changed = !std::equal(before.at(x, y), before.at(x, y) + 3, after.at(x, y));
      const bool near = glm::distance(glm::dvec2(x, y), glm::dvec2(tip)) < 160.0;
      (near ? within : beyond) += changed;
    }
  CHECK(within > 400);
  CHECK(beyond == 0);
}

TEST_CASE(
    "a measure's dashes and a hydrogen bond's lie on the way between their places, also behind an atom, faintly") {
  ViewScene bare = sceneWith({}, {atom(Vec3(0, 0, 3), 1.2, 6)});
  bare.annotations.clear();
  const RenderOptions plain{.smooth_edges = false};
  const Picture without = drawn(bare, 400, 300, plain);
  for (const bool bond : {false, true}) {
    CAPTURE(bond);
    ViewScene scene = bare;
    auto a = std::make_shared<Annotations>();
    const PointA left{Vec3(-6, 0, 0)}, right{Vec3(6, 0, 0)};
    if (bond)
      a->bonds.emplace_back(left, right);
    else
      a->measures.push_back({{left, right}, ""});
    scene.annotations.push_back(a);
    const Picture with = drawn(scene, 400, 300, plain);
    const Vec3 from = scene.camera.project(left, 400, 300), to = scene.camera.project(right, 400, 300);
    int on = 0, off = 0, behind = 0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x) {
        if (std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y))) continue;
        const bool near = std::abs(y - from.y) < 5 && x > from.x - 5 && x < to.x + 5;
        (near ? on : off) += 1;
        behind += std::abs(x - 200) < 8;
      }
    CHECK(on > 200);
    CHECK(off == 0);
    CHECK(behind > 0);
  }
}

TEST_CASE("what is written into the picture stays when the probe moves: the atoms are not drawn again for it") {
  ViewScene scene = sceneWith(named({{.at = {Vec3(0)}, .clear_A = 2, .text = "C"}}));
  scene.shown = {ViewPart::Atoms, ViewPart::Probe};
  scene.hip = PointA{Vec3(0, 0, 6)};
  drawn(scene, 200, 150);
  scene.hip->A.x += 0.5;
  drawn(scene, 200, 150);
  CHECK_FALSE(renderer().count().atoms_redrawn);
}

TEST_CASE(
    "an atom that was touched is lightly painted, at once or with the molecule, in the same colour to 12 levels") {
  ViewScene scene = sceneWith({}, {atom(Vec3(-3, 0, 0), 2.0, 6), atom(Vec3(3, 0, 0), 2.0, 6)});
  scene.annotations.clear();
  const Picture bare = drawn(scene, 300, 200);
  const auto left = std::make_shared<const std::vector<std::uint32_t>>(1, 0u);
  scene.touched_now = left;
  const Picture now = drawn(scene, 300, 200);
  CHECK_FALSE(renderer().count().atoms_redrawn);
  scene.touched_now = nullptr;
  scene.touched = left;
  const Picture later = drawn(scene, 300, 200);
  CHECK(renderer().count().atoms_redrawn);
  const Vec3 first = scene.camera.project({Vec3(-3, 0, 0)}, 300, 200),
             second = scene.camera.project({Vec3(3, 0, 0)}, 300, 200);
  const auto blueOver = [](const Picture& p, const Vec3& px) {
    return int(p.at(int(px.x), int(px.y))[2]) - int(p.at(int(px.x), int(px.y))[1]);
  };
  CHECK(blueOver(now, first) > blueOver(bare, first) + 25);
  CHECK(std::abs(blueOver(now, first) - blueOver(later, first)) <= 12);
  CHECK(blueOver(later, second) == blueOver(bare, second));
}

TEST_CASE("a mark's colour stands over the element's, the later over the earlier") {
  ViewScene scene = sceneWith({}, {atom(Vec3(-3, 0, 0), 2.0, 8), atom(Vec3(3, 0, 0), 2.0, 8)});
  scene.annotations.clear();
  scene.look.marks = std::make_shared<const std::vector<OwnColour>>(
      std::vector<OwnColour>{{{0, 1}, {0, 150, 150}, "one"}, {{1}, {190, 60, 150}, "two"}});
  const Picture p = drawn(scene, 300, 200);
  const Vec3 first = scene.camera.project({Vec3(-3, 0, 0)}, 300, 200),
             second = scene.camera.project({Vec3(3, 0, 0)}, 300, 200);
  CHECK(p.at(int(first.x), int(first.y))[1] > p.at(int(first.x), int(first.y))[0] + 40);
  CHECK(p.at(int(second.x), int(second.y))[0] > p.at(int(second.x), int(second.y))[1] + 40);
}

TEST_CASE(
    "of what is drawn over atoms no two look alike, in the light and in the dark theme; targets, bonds, measures and "
    "paint "
    "look like no phosphorus and no iron, targets like no own colour") {
  const auto byte = [](const Colour& c) {
    return Rgb8{std::uint8_t(std::lround(255 * c.x)), std::uint8_t(std::lround(255 * c.y)),
                std::uint8_t(std::lround(255 * c.z))};
  };
  constexpr double kApart = 25.0;
  for (const Theme& theme : {lightTheme(), darkTheme()}) {
    const std::vector<std::pair<std::string, Colour>> on_atoms{
        {"target", theme.target}, {"bond", theme.bond}, {"measure", theme.measure}, {"touched", theme.touched}};
    std::vector<std::pair<std::string, Colour>> all = on_atoms;
    all.insert(
        all.end(),
        {{"probe", theme.probe}, {"hand", theme.hip}, {"no force", theme.force}, {"all force", theme.strongest}});
    for (std::size_t a = 0; a < all.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        CAPTURE(all[a].first);
        CAPTURE(all[b].first);
        CHECK(colourDistance(byte(all[a].second), byte(all[b].second)) > kApart);
      }
    for (const auto& [name, colour] : on_atoms)
      for (const int number : {15, 26})
        for (const ElementColours colours :
             {ElementColours::Customary, ElementColours::Calm, ElementColours::ColourBlindSafe}) {
          CAPTURE(name);
          CAPTURE(number);
          CHECK(colourDistance(byte(colour), byte(elementColour(std::uint8_t(number), colours))) > kApart);
        }
    for (const NamedColour& own : namedColours()) {
      CAPTURE(own.name);
      CHECK(colourDistance(byte(theme.target), own.colour) > kApart);
    }
  }
}

// With letters, whose shapes another version of the font may round otherwise: as shapes_test.cpp allows, and 2.5 % of the
// pixels.
TEST_CASE("names, an arrow, a length, an angle, a hydrogen bond and a legend are written as they were approved") {
  const auto file = std::filesystem::path(MOLTACT_SOURCE_DIR) / "tests/render/golden/names-and-measures.png";
  Annotations a;
  a.labels = {{.at = {Vec3(-5, 2, 0)}, .clear_A = 2, .text = "Glu 35"},
              {.at = {Vec3(5, 3, 0)}, .clear_A = 2, .text = "the cleft", .arrow = true, .always = true}};
  a.measures = {{{{Vec3(-5, -3, 2)}, {Vec3(0, -4, 2)}}, "5.1 Å"},
                {{{Vec3(2, -5, 2)}, {Vec3(4, -1, 2)}, {Vec3(7, -4, 2)}}, "76°"}};
  a.bonds = {{{Vec3(-5, 2, 2)}, {Vec3(5, 3, 2)}}};
  ViewScene scene =
      sceneWith(a, {atom(Vec3(-5, 2, 0), 1.7, 6), atom(Vec3(5, 3, 0), 1.55, 7), atom(Vec3(0, -3, -3), 1.52, 8)});
  scene.theme = lightTheme();
  scene.look.marks =
      std::make_shared<const std::vector<OwnColour>>(std::vector<OwnColour>{{{2}, {0, 150, 150}, "acid"}});
  Picture now = drawn(scene, 320, 240, {.samples = 2});
  if (!paintLabels(now, scene, nullptr, 1.0)) {
    MESSAGE("no font is installed: nothing could be written");
    return;
  }
  REQUIRE(paintLegend(now, legendOf(*scene.molecule, ColourBy::Element, scene.elements, scene.look), scene.theme, 1.0));
  if (std::getenv("MOLTACT_UPDATE_GOLDEN"))
    if (const auto problem = writePng(file, now)) FAIL(problem->text());
  const auto golden = readPng(file);
  if (!golden) FAIL(golden.problem().text());
  const Difference difference = compare(now, *golden, 24);
  CHECK(difference.mean < 1.5);
  CHECK(difference.pixels < 320 * 240 * 25 / 1000);
}

TEST_CASE("a legend has the marks with names first, then elements from the commonest on, at most nine") {
  std::vector<PlacedAtom> atoms{atom(Vec3(0), 1, 8), atom(Vec3(3, 0, 0), 1, 6), atom(Vec3(6, 0, 0), 1, 6)};
  AtomsLook look;
  const auto names = [&] {
    std::vector<std::string> out;
    for (const LegendEntry& e : legendOf(*molecule(atoms), ColourBy::Element, ElementColours::Customary, look))
      out.push_back(e.name);
    return out;
  };
  CHECK(names() == std::vector<std::string>{"carbon", "oxygen"});
  look.marks = std::make_shared<const std::vector<OwnColour>>(
      std::vector<OwnColour>{{{0}, {0, 150, 150}, "acid"}, {{1}, {9, 9, 9}, ""}});
  CHECK(names() == std::vector<std::string>{"acid", "carbon", "oxygen"});
  for (int number = 9; number < 30; ++number) atoms.push_back(atom(Vec3(3.0 * number, 0, 0), 1, number));
  CHECK(names().size() == 10);
}
