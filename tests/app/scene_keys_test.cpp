// The effects of a scene's keys in the window: hidden and untouchable atoms, the cut, views, the motion between two
// structures, and the links to them.
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "engine/lesson/reader.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kSceneKeysHead =
    "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1ubq\nauthor: A\nlicence: L\n---\n";

// A bend of ten residues; in the other state the last three have turned away.
std::string bend(double lifted_A) {
  std::string out;
  for (int k = 0; k < 10; ++k) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM  %5d  CA  GLY A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C  \n", k + 1,
                  k + 1, 3.0 * k, k % 2 ? 1.5 : 0.0,
                  k == 3  ? 2.0
                  : k > 6 ? lifted_A
                          : 0.0);
    out += line;
  }
  return out + "END\n";
}

}  // namespace

TEST_CASE(
    "a hand that presses where it met ubiquitin meets nothing once all of it is untouchable, and the molecule again in "
    "the next step; what is removed is not in the picture either") {
  Scratch scratch;
  const auto file =
      scratch.file("mine.md", kSceneKeysHead +
                                  "## One\n```scene\nmolecule: 1ubq\n```\nText.\n"
                                  "## Two\n```scene\nuntouchable: all\n```\nText.\n"
                                  "## Three\n```scene\nuntouchable: none\nremove: residue 1-40\n```\nText.\n");
  auto d = startWith(file.string());
  const auto presses = [&] {
    d->point("view");
    d->press();
    d->frames(40);
    const bool touching = d->app().scene.log().touching();
    d->release();
    d->frames(10);
    return touching;
  };
  CHECK(presses());
  const Picture whole = d->picture();
  d->app().lesson.next();
  d->frames(20);
  CHECK(difference(whole, d->picture()) < 0.3);  // it is still seen
  CHECK_FALSE(presses());
  d->app().lesson.next();
  d->frames(20);
  const TouchableModel& stage = d->app().scene.stage();
  CHECK(presses());
  CHECK(d->app().scene.look.atoms.hidden->size() == stage.spheres->untouchable().size());
  for (const std::int32_t atom : d->app().scene.log().latest().contact.atoms)
    if (atom >= 0) CHECK(stage.spheres->touchable(std::size_t(atom)));
  d->app().lesson.back();
  d->app().lesson.back();
  d->frames(20);
  CHECK_FALSE(d->app().scene.stage().spheres->hasUntouchable());
  CHECK(presses());
}

TEST_CASE(
    "a scene's cut faces the student through the atoms that it names; a view from the menu and a link in the text turn "
    "and "
    "come close, and undo goes back") {
  Scratch scratch;
  const auto file = scratch.file(
      "mine.md",
      kSceneKeysHead +
          "## One\n```scene\nmolecule: 1ubq\nview: top\ncut: residue 30\nview the tail: facing residue 76, zoom "
          "residue 74-76\n```\n[the tail](#view:the-tail) and [Lys 48](<#zoom:residue 48>).\n");
  auto d = startWith(file.string());
  Application& app = d->app();
  const Molecule& molecule = *app.scene.stage().molecule;
  REQUIRE(app.scene.look.atoms.cut);
  Vec3 middle(0.0);
  const auto atoms = parseSelection("residue 30")->select(molecule);
  for (const auto a : atoms) middle += molecule.spheres[a].centre_A / double(atoms.size());
  CHECK(glm::distance(app.scene.look.atoms.cut->normal, app.scene.camera.back()) < 1e-9);
  CHECK(app.scene.look.atoms.cut->offset_A == doctest::Approx(glm::dot(app.scene.camera.back(), middle)));
  const Camera home = app.scene.camera;
  CHECK(d->click("lesson/0/the tail"));
  d->frames(3);
  const Camera tail = app.scene.camera;
  CHECK(tail.distance_A < 0.6 * home.distance_A);
  CHECK(d->click("lesson/0/Lys 48"));
  d->frames(3);
  Vec3 lysine(0.0);
  const auto of_48 = parseSelection("residue 48")->select(molecule);
  for (const auto a : of_48) lysine += molecule.spheres[a].centre_A / double(of_48.size());
  CHECK(glm::distance(app.scene.camera.target.A, lysine) < 1e-6);
  CHECK(d->click("tool/undo"));
  d->frames(3);
  CHECK(glm::distance(app.scene.camera.target.A, tail.target.A) < 1e-9);
}

TEST_CASE("the view that is copied for a lesson is the one that the lesson shows, to a tenth of a degree") {
  auto d = startWith("1ubq");
  Camera turned = d->app().scene.camera;
  turned.orbit(0.7, -0.4);
  turned.roll(0.3);
  const LessonReading reading =
      readLessonText("l.md", kSceneKeysHead + "## S\n```scene\nmolecule: 1ubq\nview: " + viewText(turned) + "\n```\n");
  REQUIRE(reading.lesson);
  Camera read;
  const SceneSpec& spec = reading.lesson->steps[0].scene;
  faceView(read, *d->app().scene.stage().molecule, spec.view, spec);
  CHECK(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(read.orientation, turned.orientation)))) < 0.003);
}

TEST_CASE("the page for zooming to atoms shows errors during typing, and zooms to them") {
  auto d = startWith("2hhb");
  const double far_A = d->app().scene.camera.distance_A;
  d->tap("Ctrl+F");
  d->frames(3);
  d->type("residue 9999");
  d->frames(3);
  CHECK(contains(d->text("zoom/fault"), "9999"));
  CHECK(d->click("zoom/ligand HEM"));
  d->frames(3);
  CHECK(d->app().panels.zoom_atoms == "ligand HEM");
  d->app().panels.zoom_atoms = "ligand HEM and chain A";
  d->frames(2);
  CHECK(d->click("zoom/go"));
  d->frames(3);
  CHECK_FALSE(d->app().panels.pages.zoom);
  CHECK(d->app().scene.camera.distance_A < 0.7 * far_A);
}

TEST_CASE(
    "the window can include waters; a wrong assembly is reported with the existing ones, and the "
    "molecule stays") {
  auto d = startWith("1ubq");
  Application& app = d->app();
  const std::size_t dry = app.scene.stage().molecule->atoms.size();
  findAction("reading")->run(app);
  d->frames(3);
  CHECK(d->click("reading/waters"));
  CHECK(d->click("reading/open"));
  d->frames(3);
  CHECK(app.scene.stage().molecule->atoms.size() == dry + 58);
  CHECK(app.scene.molecule().reading.waters);
  app.openMolecule({app.scene.molecule().file, {.assembly = "7"}});
  d->frames(3);
  REQUIRE_FALSE(app.messages.all().empty());
  CHECK(app.scene.molecule().reading.waters);
}

TEST_CASE(
    "the slider between two structures moves the atoms at no more than 8 A/s to exactly the other state, halfway to "
    "the mean "
    "of both; what is felt and drawn goes with them, within the force's limits; the step begins again in the first") {
  Scratch scratch;
  scratch.file("open.pdb", bend(0.0));
  scratch.file("shut.pdb", bend(6.0));
  const auto file = scratch.file(
      "mine.md",
      "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: open.pdb, shut.pdb\nauthor: A\nlicence: L\n---\n"
      "## One\n```scene\nmolecule: open.pdb\nthen: shut.pdb, superposed on residue 1-7\nstates: open, shut\n```\n"
      "[half](#state:50%)\n## Two\n```scene\nstate: shut\n```\nText.\n## Three\n```scene\nmolecule: "
      "open.pdb\n```\nText.\n");
  auto d = startWith(file.string());
  Application& app = d->app();
  const auto last = [&] { return app.scene.atoms().seen()->spheres[9].centre_A; };
  const Vec3 open = app.scene.stage().molecule->spheres[9].centre_A;
  REQUIRE(d->shows("view/states"));
  CHECK(glm::distance(last(), open) == 0.0);
  d->point("view");
  d->hold("Space");
  d->frames(30);
  CHECK(d->click("lesson/0/half"));
  double fastest_A = 0.0, greatest_N = 0.0;
  Vec3 before = last();
  for (int frame = 0; frame < 120; ++frame) {
    d->frames(1);
    for (const ServoSample& s : app.scene.servo().everyTick())
      greatest_N = std::max(greatest_N, glm::length(s.force.N));
    fastest_A = std::max(fastest_A, glm::distance(last(), before));
    before = last();
  }
  CHECK(glm::distance(last(), open + Vec3(0, 0, 3)) < 1e-3);
  CHECK(fastest_A <= 8.0 * 3 / 60.0);  // a picture is at most three frames behind
  CHECK(greatest_N <= app.scene.servo_settings.max_force_N + 1e-9);
  d->letGo("Space");
  CHECK(d->click("view/state/1"));
  d->frames(120);
  CHECK(glm::distance(last(), open + Vec3(0, 0, 6)) < 1e-3);
  CHECK(d->text("view/states") == "100\u00a0%");
  const SphereGrid& spheres = *app.scene.stage().spheres;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    CHECK(glm::distance(spheres[i].centre_A, app.scene.atoms().seen()->spheres[i].centre_A) == 0.0);
  app.lesson.next();
  d->frames(5);
  CHECK(glm::distance(last(), open + Vec3(0, 0, 6)) < 1e-3);  // it begins there
  app.lesson.next();
  d->frames(5);
  CHECK_FALSE(d->shows("view/states"));
  CHECK(last() == open);
}

TEST_CASE(
    "a lesson's protein is a cartoon where its scene does not say how it is drawn, with what is bound or highlighted "
    "as "
    "spheres; a small molecule, and a protein opened by itself, are spheres") {
  Scratch scratch;
  const auto opened = [&](const std::string& molecule, const std::string& more) {
    const auto file =
        scratch.file("drawn.md", "---\ntitle: Drawn\nminutes: 1\ngoals: G\nmolecules: " + molecule +
                                     "\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: " + molecule + "\n" +
                                     more + "```\nRead.\n");
    auto d = startWith(file.string());
    return d->app().scene.look.atoms.styles;
  };
  const std::vector<StyledAtoms> haemoglobin = opened("2hhb", "highlight: residue 58 and chain A\n");
  REQUIRE(haemoglobin.size() == 2);
  CHECK(haemoglobin[0].style == DrawStyle::Cartoon);
  CHECK(haemoglobin[0].atoms->size() == 4384);  // those of the four chains
  CHECK(haemoglobin[1].style == DrawStyle::Spheres);
  CHECK(haemoglobin[1].atoms->size() == 4 * 43 + 2 + 10);  // haems, two phosphates' atoms, His 58
  CHECK(opened("1ubq", "").size() == 1);
  CHECK(opened("1ubq", "style: spheres\n") == std::vector<StyledAtoms>{StyledAtoms{}});
  CHECK(opened("benzene", "").empty());
  CHECK(startWith("1ubq")->app().scene.look.atoms.styles.empty());
}

}  // namespace moltact
