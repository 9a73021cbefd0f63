// The haptic shapes, glyphs and reference pictures. Expected places come from closed forms and the projection.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/core/sphere_intersections.h"
#include "engine/gltf/gltf_file.h"
#include "engine/haptics/mesh/sphere_mesh.h"
#include "engine/molecule/reader.h"
#include "engine/render/glyphs.h"
#include "engine/render/haptic_shapes.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// Two argon-like spheres, the HIP 0.5 A under the circle in which the inflated ones meet.
ViewScene crease() {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(-1.6, 0, 0), 1.88, 18), atom(Vec3(1.6, 0, 0), 1.88, 16)});
  const double a = std::sqrt(std::pow(1.88 + 1.4, 2) - 1.6 * 1.6);
  scene.contact.scp.A = Vec3(0, a, 0);
  scene.contact.feature = Feature::Circle;
  scene.contact.atoms = {0, 1, -1};
  scene.hip = PointA{Vec3(0, a - 0.5, 0)};
  stretchToScp(scene.contact, *scene.hip);
  scene.force_N = 0.5;
  scene.camera = frontCamera(24);
  scene.camera.lookFrom(0.6, 0.35);
  return scene;
}

int brightest(const Picture& with, const Picture& without, double x, double y, int reach) {
  int most = 0;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      for (int k = 0; k < 3; ++k)
        most = std::max(most, std::abs(with.at(int(x) + dx, int(y) + dy)[k] - without.at(int(x) + dx, int(y) + dy)[k]));
  return most;
}

}  // namespace

TEST_CASE(
    "atoms that are not drawn get no ring where they are touched: the picture is that of a contact with nothing") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Atoms, ViewPart::Probe, ViewPart::Force};
  const Picture seen = drawn(scene, 500, 400);
  scene.look.hidden = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{0, 1});
  const Picture unseen = drawn(scene, 500, 400);
  scene.contact.atoms = {-1, -1, -1};
  const Picture nothing = drawn(scene, 500, 400);
  CHECK(unseen.rgb == nothing.rgb);
  CHECK(seen.rgb != nothing.rgb);
}

TEST_CASE("the circle in use passes within 1 pixel of where its closed form is projected, all round") {
  ViewScene scene = crease();
  scene.shown = {};
  const Picture without = drawn(scene, 500, 400);
  scene.shown = {ViewPart::Circles};
  const Picture with = drawn(scene, 500, 400);
  const auto circle = circleOf({Vec3(-1.6, 0, 0), 3.28}, {Vec3(1.6, 0, 0), 3.28});
  REQUIRE(circle);
  for (int i = 0; i < 90; ++i) {
    const double t = i * 3.14159265358979 / 45;
    const Vec3 px =
        scene.camera.project({Vec3(0, circle->radius_A * std::cos(t), circle->radius_A * std::sin(t))}, 500, 400);
    CHECK(brightest(with, without, px.x, px.y, 1) > 60);
  }
  // Nothing is drawn in the circle's middle.
  const Vec3 middle = scene.camera.project({Vec3(0)}, 500, 400);
  CHECK(brightest(with, without, middle.x, middle.y, 3) == 0);
}

TEST_CASE("the outline of an inflated sphere lies where its perspective image ends") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0), 1.7, 6)});
  scene.camera = frontCamera(20);
  scene.haptic_atoms = {0};
  scene.shown = {};
  const Picture without = drawn(scene, 400, 400);
  scene.shown = {ViewPart::Spheres};
  const Picture with = drawn(scene, 400, 400);
  const double r = std::tan(std::asin(3.1 / 20)) / scene.camera.tanHalfY() * 200;
  for (int i = 0; i < 60; ++i) {
    const double t = i * 3.14159265358979 / 30;
    CHECK(brightest(with, without, 200 + r * std::cos(t), 200 + r * std::sin(t), 1) > 40);
    CHECK(brightest(with, without, 200 + (r + 5) * std::cos(t), 200 + (r + 5) * std::sin(t), 1) == 0);
  }
}

TEST_CASE("no line of an inflated sphere runs inside another one, and all lie on their spheres") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Spheres};
  const MoleculeModel model(scene.molecule);
  Strokes strokes;
  std::vector<LooseSphere> dots;
  addHapticShapes(scene, model, strokes, dots);
  std::size_t points = 0;
  for (const Strokes::Line& line : strokes.lines())
    for (std::size_t i = line.begin; i < line.end; ++i, ++points) {
      const Vec3 p = scene.camera.fromView(Vec3(strokes[i])).A;
      const double left = glm::length(p - Vec3(-1.6, 0, 0)), right = glm::length(p - Vec3(1.6, 0, 0));
      CHECK(std::min(left, right) == doctest::Approx(3.28).epsilon(1e-5));
    }
  CHECK(points > 1000);
}

TEST_CASE("facets are the mesh's edges, outside the other sphere, and few however fine the mesh is") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Facets};
  const MoleculeModel model(scene.molecule);
  std::vector<LooseSphere> dots;
  const auto linesOf = [&](std::shared_ptr<const SphereMesh> mesh) {
    scene.facets = std::move(mesh);
    Strokes strokes;
    addHapticShapes(scene, model, strokes, dots);
    return strokes;
  };
  CHECK(linesOf(nullptr).lines().empty());
  const Strokes coarse = linesOf(SphereMesh::ofTriangles(80));
  CHECK(coarse.lines().size() > 120);  // 2 x 120 edges less those inside
  CHECK(coarse.lines().size() < 240);
  const double least = 3.28 * (1.0 - SphereMesh::ofTriangles(80)->sagitta());
  for (const Strokes::Line& line : coarse.lines())
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const Vec3 p = scene.camera.fromView(Vec3(coarse[i])).A;
      const double near = std::min(glm::length(p - Vec3(-1.6, 0, 0)), glm::length(p - Vec3(1.6, 0, 0)));
      CHECK(near > least - 0.15);  // cut at the other sphere to a piece's length
      CHECK(near < 3.28 + 1e-5);
    }
  CHECK(linesOf(SphereMesh::ofTriangles(5120)).lines().size() < 6000);
}

TEST_CASE(
    "facets of spheres as large as a file may have them, 1e9 A, are cut at the other sphere to a 24th of an edge") {
  constexpr double kRadius_A = 1e9;
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(-0.55e9, 0, 0), kRadius_A, 18), atom(Vec3(0.55e9, 0, 0), kRadius_A, 16)});
  scene.contact.scp.A = Vec3(0, std::sqrt(1.0 - 0.55 * 0.55) * kRadius_A, 0);
  scene.contact.feature = Feature::Circle;
  scene.contact.atoms = {0, 1, -1};
  scene.camera = frontCamera(4e9);
  scene.shown = {ViewPart::Facets};
  const auto mesh = SphereMesh::ofTriangles(80);
  scene.facets = mesh;
  double longest = 0.0;
  for (const SphereMesh::Face& f : mesh->faces())
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh->vertices()[std::size_t(f.corners[k])],
                                                mesh->vertices()[std::size_t(f.corners[(k + 1) % 3])]));
  const MoleculeModel model(scene.molecule);
  Strokes strokes;
  std::vector<LooseSphere> dots;
  addHapticShapes(scene, model, strokes, dots);
  CHECK(strokes.lines().size() > 120);
  // A piece is drawn where its middle is outside: an end lies no deeper than half of it.
  const double least = 1.0 - std::max(mesh->sagitta(), longest / 48.0);
  for (const Strokes::Line& line : strokes.lines())
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const Vec3 p = scene.camera.fromView(Vec3(strokes[i])).A;
      const double near = std::min(glm::length(p - Vec3(-0.55e9, 0, 0)), glm::length(p - Vec3(0.55e9, 0, 0)));
      CHECK(near / kRadius_A > least - 1e-5);
      CHECK(near / kRadius_A < 1.0 + 1e-5);
    }
}

TEST_CASE("a contact at the limit of an attempt's numbers, 2e9 A, gives finite lines and dots") {
  ViewScene scene = crease();
  for (const ViewPartInfo& part : viewParts()) scene.shown.set(part.part);
  scene.facets = SphereMesh::ofTriangles(80);
  const MoleculeModel model(scene.molecule);
  for (const double far_A : {2e9, -2e9}) {
    scene.contact.scp.A = Vec3(far_A, -far_A, far_A);
    scene.hip = PointA{Vec3(-far_A, far_A, -far_A)};
    stretchToScp(scene.contact, *scene.hip);
    Strokes strokes;
    std::vector<LooseSphere> dots;
    addHapticShapes(scene, model, strokes, dots);
    for (const Strokes::Line& line : strokes.lines())
      for (std::size_t i = line.begin; i < line.end; ++i) CHECK(finite(Vec3(strokes[i])));
    for (const LooseSphere& dot : dots) CHECK(finite(Vec3(dot.centre)));
  }
}

TEST_CASE("each part that is switched on changes the picture, and only the ones of its own") {
  const ViewScene base = crease();
  ViewScene scene = base;
  scene.shown = {ViewPart::Atoms};
  scene.targets.push_back({{Vec3(0, 0, 4)}, 0.8, false});
  scene.facets = SphereMesh::ofTriangles(80);
  const Picture bare = drawn(scene, 300, 240);
  for (const ViewPartInfo& s : viewParts()) {
    if (s.part == ViewPart::Atoms || s.part == ViewPart::Points) continue;  // two spheres meet in no points
    scene.shown = {ViewPart::Atoms, s.part};
    CAPTURE(s.name);
    CHECK(compare(drawn(scene, 300, 240), bare, 12).pixels > 8);
  }
  scene.shown = {ViewPart::Atoms};
  CHECK(compare(drawn(scene, 300, 240), bare, 0).pixels == 0);
}

TEST_CASE("a dark screen shows nothing of the scene") {
  ViewScene scene = crease();
  scene.blank = true;
  const Picture dark = drawn(scene, 120, 90);
  for (std::size_t i = 3; i < dark.rgb.size(); ++i) CHECK(dark.rgb[i] == dark.rgb[i % 3]);
  CHECK(dark.rgb[0] < 16);
}

TEST_CASE("the probe is a water molecule: O at the SCP, two H at 0.9572 A with 104.52 degrees, away from the surface") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Probe};
  Glyphs glyphs;
  addGlyphs(scene, nullptr, glyphs);
  REQUIRE(glyphs.solid.size() == 3);
  const glm::vec3 o = glyphs.solid[0].centre, h1 = glyphs.solid[1].centre - o, h2 = glyphs.solid[2].centre - o;
  CHECK(glm::length(Vec3(o) - scene.camera.toView(scene.contact.scp)) < 1e-5);
  CHECK(glm::length(h1) == doctest::Approx(0.9572).epsilon(1e-5));
  CHECK(glm::length(h2) == doctest::Approx(0.9572).epsilon(1e-5));
  CHECK(std::acos(glm::dot(h1, h2) / 0.9572 / 0.9572) * 180 / 3.14159265358979 ==
        doctest::Approx(104.52).epsilon(1e-4));
  const glm::vec3 outward(scene.camera.toView({scene.contact.scp.A + Vec3(0, 1, 0)}) -
                          scene.camera.toView(scene.contact.scp));
  CHECK(glm::dot(h1 + h2, outward) > 1.0f);
  REQUIRE(glyphs.shell.size() == 1);
  CHECK(glyphs.shell[0].radius == doctest::Approx(1.4));
}

TEST_CASE("twice the force makes the arrow's shaft twice as long, outward from the SCP") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Force};
  const auto shaft = [&](double force_N) {
    scene.force_N = force_N;
    Glyphs glyphs;
    addGlyphs(scene, nullptr, glyphs);
    REQUIRE(glyphs.cones.size() == 2);
    return glyphs.cones[0].b - glyphs.cones[0].a;
  };
  CHECK(glm::length(shaft(2)) == doctest::Approx(2 * glm::length(shaft(1))).epsilon(1e-5));
  CHECK(glm::length(shaft(1)) == doctest::Approx(2.0).epsilon(1e-5));
}

TEST_CASE(
    "in place of an arrow within 30 degrees of the line to the eye stands a ring with a dot, or a cross where it "
    "points away") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Force};
  scene.force_N = 1.0;
  for (const double degrees : {10.0, 50.0, 170.0}) {
    scene.camera.lookFrom(0.0, (90.0 - degrees) * 3.14159265358979 / 180);  // the force points up
    scene.camera.target = scene.contact.scp;
    Glyphs glyphs;
    addGlyphs(scene, nullptr, glyphs);
    CAPTURE(degrees);
    CHECK(glyphs.cones.size() == (degrees == 50 ? 2 : 0));
    // Two strokes a line: the ring round the probe; the sign's ring; its cross.
    CHECK(glyphs.strokes.lines().size() == (degrees < 30 ? 4 : degrees == 50 ? 2 : 8));
    CHECK(glyphs.solid.size() == (degrees < 30 ? 1 : 0));
    // The sign lies nearer to the eye than the probe does (z grows toward the eye).
    for (const LooseSphere& dot : glyphs.solid)
      CHECK(double(dot.centre.z) > scene.camera.toView(scene.contact.scp).z + scene.probe_A);
  }
}

TEST_CASE("the ring of the force is wider, thicker and warmer at 3 N than at 0.3 N, and lies round the probe") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Force};
  const auto ring = [&](double force_N, float& width, Colour& colour) {
    scene.force_N = force_N;
    Glyphs glyphs;
    addGlyphs(scene, nullptr, glyphs);
    const Strokes::Line& line = glyphs.strokes.lines()[1];
    width = line.stroke.width_px;
    colour = line.stroke.colour;
    return glm::length(scene.camera.fromView(Vec3(glyphs.strokes[line.begin])).A - scene.contact.scp.A);
  };
  float weak_px = 0, strong_px = 0;
  Colour weak, strong;
  const double weak_A = ring(0.3, weak_px, weak), strong_A = ring(3.0, strong_px, strong);
  CHECK(weak_A > 1.4);
  CHECK(strong_A > weak_A + 0.2);
  CHECK(strong_px > 2 * weak_px);
  CHECK(strong.r - strong.g > weak.r - weak.g + 0.5f);
  CHECK(strong == scene.theme.strongest);
}

TEST_CASE("out-of-range atoms in a scene are passed over") {
  ViewScene scene = crease();
  scene.highlighted = {0, 77};
  scene.haptic_atoms = {1, 99};
  scene.contact.atoms = {0, 1, 5000};
  for (const ViewPartInfo& s : viewParts()) scene.shown.set(s.part);
  CHECK(drawn(scene, 64, 64).rgb.size() == 64 * 64 * 3);
}

TEST_CASE(
    "highlighted atoms are distinguishable in shades of grey alone: a ring a third as bright as its "
    "background") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(-2, 0, 0), 1.7, 6), atom(Vec3(2, 0, 0), 1.7, 6)});
  scene.camera = frontCamera(14);
  scene.shown = {ViewPart::Atoms, ViewPart::Target};
  scene.highlighted = {1};
  const Picture picture = drawn(scene, 400, 300, {.samples = 2});
  // From the upper left through the sphere's middle.
  const auto contrast = [&](double x_A) {
    double low = 255, high = 0;
    for (double k = -1.25; k <= 0.2; k += 0.02) {
      const Vec3 px = scene.camera.project({Vec3(x_A + k * 0.7, -k * 0.7, 1.0)}, 400, 300);
      const auto c = picture.at(int(px.x), int(px.y));
      const double grey = 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
      low = std::min(low, grey);
      high = std::max(high, grey);
    }
    return low / high;
  };
  CHECK(contrast(2) < 0.45);
  CHECK(contrast(-2) > 0.6);
}

TEST_CASE("each atom that holds the probe has a bright ring on a dark one; without a touch none has") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Atoms};
  const MoleculeModel model(scene.molecule);
  Glyphs glyphs;
  addGlyphs(scene, &model, glyphs);
  REQUIRE(glyphs.strokes.lines().size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const Strokes::Line& ring = glyphs.strokes.lines()[k];
    for (std::size_t i = ring.begin; i < ring.end; ++i) {
      const double from = glm::length(scene.camera.fromView(Vec3(glyphs.strokes[i])).A - model.spheres[k / 2].centre_A);
      CHECK(from == doctest::Approx(model.spheres[k / 2].radius_A + 0.10).epsilon(1e-4));
    }
    CHECK((glm::length(ring.stroke.colour) > 1.0f) == (k % 2 == 1));
  }
  scene.contact = {};
  glyphs.clear();
  addGlyphs(scene, &model, glyphs);
  CHECK(glyphs.strokes.lines().empty());
}

TEST_CASE(
    "a model of 0.1 units stands with its tip at the HIP and is 170 pixels long in a picture 800 high; left-handed it "
    "is mirrored") {
  ViewScene scene = crease();
  scene.shown = {ViewPart::Probe};
  SolidModel rod;
  rod.corners.resize(3);
  rod.high = {0, 0.1f, 0};
  scene.hand = std::make_shared<const SolidModel>(rod);
  Glyphs glyphs;
  addGlyphs(scene, nullptr, glyphs);
  REQUIRE(glyphs.models.size() == 1);
  const glm::vec3 tip(glyphs.models[0].to_view * glm::vec4(0, 0, 0, 1)),
      end(glyphs.models[0].to_view * glm::vec4(0, 0.1f, 0, 1));
  CHECK(glm::length(Vec3(tip) - scene.camera.toView(*scene.hip)) < 1e-5);
  const double depth = -scene.camera.toView(*scene.hip).z;
  CHECK(double(glm::length(end - tip)) == doctest::Approx(170 * scene.camera.pixel_A(depth, 800)).epsilon(1e-4));
  CHECK(glm::determinant(glyphs.models[0].to_view) > 0);
  scene.left_hand = true;
  glyphs.clear();
  addGlyphs(scene, nullptr, glyphs);
  const glm::vec3 left(glyphs.models[0].to_view * glm::vec4(0, 0.1f, 0, 1));
  CHECK(left.x - tip.x == doctest::Approx(-(end.x - tip.x)).epsilon(1e-4));
  CHECK(glm::determinant(glyphs.models[0].to_view) > 0);
  scene.hip.reset();
  glyphs.clear();
  addGlyphs(scene, nullptr, glyphs);
  CHECK(glyphs.models.empty());
}

TEST_CASE("the golden pictures are drawn as they were approved") {
  const std::filesystem::path folder = std::filesystem::path(MOLTACT_SOURCE_DIR) / "tests/render/golden";
  const auto check = [&](const std::string& name, const ViewScene& scene) {
    CAPTURE(name);
    const Picture now = drawn(scene, 320, 240, {.samples = 2});
    const auto file = folder / (name + ".png");
    if (std::getenv("MOLTACT_UPDATE_GOLDEN")) {
      const auto problem = writePng(file, now);
      if (problem) FAIL(problem->text());
    }
    const auto golden = readPng(file);
    if (!golden) FAIL(golden.problem().text());
    const Difference difference = compare(now, *golden, 24);
    CHECK(difference.mean < 1.5);
    CHECK(difference.pixels < 320 * 240 * 15 / 1000);
  };
  ViewScene scene = crease();
  scene.shown = {ViewPart::Atoms, ViewPart::Force, ViewPart::Probe, ViewPart::Hip};
  check("water-in-a-crease", scene);
  check("body-and-hand", rodInHand());
  auto stylus = readGltf(std::filesystem::path(MOLTACT_SOURCE_DIR) / "assets/models/stylus.glb");
  if (!stylus) FAIL(stylus.problem().text());
  ViewScene held = scene;
  held.hand = std::make_shared<const SolidModel>(*std::move(stylus));
  check("hand-stylus", held);
  ViewScene marked = crease();
  marked.shown = {ViewPart::Atoms, ViewPart::Target};
  marked.contact = {};
  marked.highlighted = {1};
  check("marked-atom", marked);
  scene.shown = *parseViewParts("atoms,haptic,force");
  scene.theme = lightTheme();
  check("haptic-shapes", scene);
  auto protein = readMolecule(std::filesystem::path(MOLTACT_SOURCE_DIR) / "molecules/1ubq.pdb");
  if (!protein) FAIL(protein.problem().text());
  ViewScene ubiquitin;
  ubiquitin.molecule = std::make_shared<const Molecule>(*std::move(protein));
  ubiquitin.camera.fit(*ubiquitin.molecule, 320.0 / 240);
  ubiquitin.highlighted = {10, 11};
  check("ubiquitin", ubiquitin);
  ubiquitin.highlighted.clear();
  for (const DrawStyleInfo& style : drawStyles()) {
    ubiquitin.look.styles = {{.style = style.style}};
    if (style.style != DrawStyle::Spheres) check("style-" + std::string(style.name), ubiquitin);
  }
}
