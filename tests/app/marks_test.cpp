// Labels, marks and measurements of a scene in the window, measurements by clicks and by touch, and traces of touch.
#include "app/ui/extensions/extensions.h"
#include "app/ui/lesson/scene_marks.h"
#include "app/ui/panels/actions.h"
#include "app/ui/panels/view_overlays.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const char* kMarksLesson = R"(---
title: Marks
minutes: 5
goals: See names.
molecules: benzene
author: A
licence: CC0
---

## Named

```scene
molecule: benzene
label: "ring" for element C
arrow: "one hydrogen" for atom 6
mark: teal "first carbon" for atom 0
distance: atom 0 - atom 3
angle: atom 0 - atom 1 - atom 2, atom 0 - atom 1 - atom 2 - atom 3
paint: touched
```

Names.

## Bare

```scene
label: none
arrow: none
mark: none
distance: none
angle: none
paint: none
```

None.
)";

std::unique_ptr<ScriptedUser> marksOpenLesson(const Scratch& scratch, const char* text) {
  auto d = startWith("");
  d->app().open(scratch.file("marks.md", text));
  d->app().finishLoading();
  d->frames(20);
  return d;
}

// All that stands over the view, one a line.
std::string written(ScriptedUser& d) {
  std::string out;
  for (int k = 0; k < 20; ++k)
    for (const char* kind : {"view/label/", "view/measure/"})
      if (const std::string name = kind + std::to_string(k); d.shows(name)) out += d.text(name) + '\n';
  return out;
}

void clickAtom(ScriptedUser& d, std::uint32_t atom) {
  const auto size = d.app().layout().view.size();
  const Vec3 px = d.app().scene.camera.project(PointA{d.app().scene.stage().molecule->spheres[atom].centre_A},
                                               int(size.x), int(size.y));
  d.point("view", px.x / double(size.x), px.y / double(size.y));
  d.press();
  d.frames(2);
  d.release();
  d.frames(2);
}

}  // namespace

TEST_CASE(
    "a scene's names, arrow, length, angle and torsion stand over the view: in benzene 2.79 Å across, 120.0° and 0.0°; "
    "the "
    "legend names its mark; the next step takes all of it away") {
  const Scratch scratch;
  auto d = marksOpenLesson(scratch, kMarksLesson);
  const std::string text = written(*d);
  CHECK(contains(text, "ring\n"));
  CHECK(contains(text, "one hydrogen\n"));
  const Molecule& benzene = *d->app().scene.stage().molecule;
  const double across = glm::distance(benzene.spheres[0].centre_A, benzene.spheres[3].centre_A);
  CHECK(across == doctest::Approx(2.79).epsilon(0.02));
  CHECK(contains(text, "120.0°\n"));
  CHECK(contains(text, "0.0°\n"));
  CHECK(contains(d->text("view/legend"), "first carbon"));
  const Picture named = d->picture();
  CHECK(writePng(scratch.folder / "named.png", named) == std::nullopt);
  d->tap("Alt+Right");
  d->frames(20);
  CHECK(written(*d).empty());
  CHECK_FALSE(contains(d->text("view/legend"), "first carbon"));
}

TEST_CASE(
    "Ctrl+E, then clicks on two carbons of benzene give their distance, a third the angle, a fourth the torsion; a "
    "click "
    "pushes nothing meanwhile; Ctrl+E again, and a click pushes") {
  auto d = startWith("benzene");
  const Molecule& m = *d->app().scene.stage().molecule;
  d->tap("Ctrl+E");
  CHECK(contains(d->text("view/measuring"), "Click two atoms"));
  clickAtom(*d, 0);
  CHECK_FALSE(d->app().scene.controls.pressing());
  clickAtom(*d, 1);
  const auto measure = [&](std::vector<std::uint32_t> atoms) { return measureBetween(m, atoms).text; };
  CHECK(contains(written(*d), measure({0, 1})));
  CHECK(contains(d->text("view/measuring"), measure({0, 1})));
  clickAtom(*d, 2);
  CHECK(written(*d) == measure({0, 1, 2}) + '\n');
  clickAtom(*d, 3);
  CHECK(written(*d) == measure({0, 1, 2, 3}) + '\n');
  // The fifth begins another; the first stays.
  clickAtom(*d, 4);
  clickAtom(*d, 5);
  CHECK(contains(written(*d), measure({4, 5})));
  CHECK(contains(written(*d), measure({0, 1, 2, 3})));
  // The same atom once more ends it: the next two are a length of their own.
  clickAtom(*d, 5);
  clickAtom(*d, 0);
  clickAtom(*d, 2);
  CHECK(contains(written(*d), measure({4, 5})));
  CHECK(d->app().extensions().measuring.drawn()->measures.size() == 3);
  d->tap("Ctrl+E");
  CHECK_FALSE(d->shows("view/measuring"));
  d->point("view");
  d->press();
  d->frames(5);
  CHECK(d->app().scene.controls.pressing());
  d->release();
  d->frames(2);
  findAction("measure-clear")->run(d->app());
  d->frames(2);
  CHECK(written(*d).empty());
}

TEST_CASE("Ctrl+Shift+E measures from the touched atom; without a touch a message says so") {
  auto d = startWith("benzene");
  d->tap("Ctrl+Shift+E");
  CHECK_FALSE(d->app().extensions().measuring.any());
  clickAtom(*d, 0);
  d->point("view");
  d->press();
  for (int k = 0; k < 200 && !d->app().scene.log().touching(); ++k) d->frames(1);
  REQUIRE(d->app().scene.log().touching());
  d->tap("Ctrl+Shift+E");
  CHECK(d->app().extensions().measuring.any());
  d->release();
}

TEST_CASE("another molecule has no measures of the one before") {
  auto d = startWith("benzene");
  d->app().extensions().measuring.take(*d->app().scene.stage().molecule, 0);
  d->app().extensions().measuring.take(*d->app().scene.stage().molecule, 1);
  d->frames(2);
  CHECK_FALSE(written(*d).empty());
  d->app().open("argon");
  d->app().finishLoading();
  d->frames(5);
  CHECK_FALSE(d->app().extensions().measuring.any());
}

TEST_CASE("atoms that were touched stay painted once the probe has left them, until a step that does not ask for it") {
  const Scratch scratch;
  auto d = marksOpenLesson(scratch, kMarksLesson);
  const TouchPaint& paint = d->app().extensions().touch_paint;
  CHECK_FALSE(paint.painted());
  d->point("view");
  d->press();
  for (int k = 0; k < 200 && !d->app().scene.log().touching(); ++k) d->frames(1);
  REQUIRE(d->app().scene.log().touching());
  d->frames(2);
  REQUIRE(paint.fresh());
  const std::int32_t touched = d->app().scene.log().latest().contact.atoms[0];
  CHECK(std::binary_search(paint.fresh()->begin(), paint.fresh()->end(), std::uint32_t(touched)));
  d->release();
  for (int k = 0; k < 200 && d->app().scene.log().touching(); ++k) d->frames(1);
  d->frames(5);
  REQUIRE(paint.painted());
  CHECK_FALSE(paint.fresh());
  CHECK(std::binary_search(paint.painted()->begin(), paint.painted()->end(), std::uint32_t(touched)));
  CHECK(contains(d->text("view/legend"), "touched"));
  CHECK(seenScene(d->app()).touched == paint.painted());
  d->tap("Alt+Right");
  d->frames(20);
  CHECK_FALSE(paint.painted());
}

TEST_CASE(
    "hydrogen bonds of a selection have an end in it, and their number in ubiquitin's helix is that of its turns") {
  auto d = startWith("1ubq");
  const Molecule& m = *d->app().scene.stage().molecule;
  SceneSpec scene;
  scene.hydrogen_bonds = *parseSelection("residue 23-34 and backbone");
  const auto annotations = annotationsOf(scene, m);
  REQUIRE(annotations);
  // Residues 23 to 34 are a helix of 12: i to i+4 within it 8, a few more at its ends.
  CHECK(annotations->bonds.size() >= 8);
  CHECK(annotations->bonds.size() <= 24);
  for (const auto& [a, b] : annotations->bonds) CHECK(glm::distance(a.A, b.A) <= 3.5);
}

}  // namespace moltact
