// A user's own molecule in a chosen style: the menus' colours, and the page with a scene's keys.
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "app/ui/panels/view_overlays.h"
#include "engine/render/molecule_model.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {

TEST_CASE(
    "the page takes a scene's keys: a style, what is hidden, colours, marks, names and hydrogen bonds are drawn") {
  auto d = startWith("1ubq");
  Application& app = d->app();
  d->click("menu/view");
  d->frames(3);
  REQUIRE(d->click("menu/view/look"));
  d->frames(3);
  OwnLook& own = app.extensions().own_look;
  d->type("cartoon");  // the first field is written in at once
  own.values = {own.values[0], "residue 1-4", "charge", "teal \"patch\" for residue 48", "residue for residue 48",
                "helix"};
  d->frames(3);
  for (const OwnLookKey& key : OwnLook::keys()) {
    CHECK(d->shows("look/" + std::string(key.key)));
    CHECK(d->text("look/" + std::string(key.key) + "/fault") == "");
  }
  REQUIRE(d->click("look/show"));
  d->frames(10);
  CHECK_FALSE(app.panels.pages.look);
  // The ribbon, and lysine 48 with its 9 atoms as spheres: in a ribbon a mark would be a spot.
  REQUIRE(app.scene.look.atoms.styles.size() == 2);
  CHECK(app.scene.look.atoms.styles[0].style == DrawStyle::Cartoon);
  CHECK(app.scene.look.atoms.styles[1].style == DrawStyle::Spheres);
  REQUIRE(app.scene.look.atoms.styles[1].atoms);
  CHECK(app.scene.look.atoms.styles[1].atoms->size() == 9);
  REQUIRE(app.scene.look.atoms.hidden);
  CHECK(app.scene.look.atoms.hidden->size() > 25);  // 1-4 are Met, Gln, Ile, Phe
  CHECK(app.scene.look.atoms.colouring);
  REQUIRE(app.scene.look.atoms.marks);
  CHECK(app.scene.look.atoms.marks->at(0).name == "patch");
  REQUIRE(app.scene.look.atoms.annotations);
  CHECK(app.scene.look.atoms.annotations->labels.size() == 1);
  CHECK(app.scene.look.atoms.annotations->bonds.size() > 5);
  // Another molecule has none of it.
  app.open("benzene");
  app.finishLoading();
  d->frames(5);
  CHECK(app.scene.look.atoms.styles.empty());
  CHECK_FALSE(app.scene.look.atoms.annotations);
  CHECK(own.values[0].empty());
}

TEST_CASE("names alone are one change, which undo takes back; a lesson on the same molecule shows none of them") {
  auto d = startWith("alpha-helix");
  Application& app = d->app();
  d->frames(5);
  OwnLook& own = app.extensions().own_look;
  own.values = {"", "", "", "", "residue for residue 3", ""};
  own.show(app.scene);
  d->frames(3);
  REQUIRE(app.scene.look.atoms.annotations);
  REQUIRE(d->click("tool/undo"));
  d->frames(3);
  CHECK_FALSE(app.scene.look.atoms.annotations);
  CHECK(d->click("tool/redo"));
  d->frames(3);
  REQUIRE(app.scene.look.atoms.annotations);
  const ScratchFolder scratch;
  std::string lesson = argonLesson("Helix", "  - A goal\n", "Text.\n");
  for (std::size_t at; (at = lesson.find("argon")) != std::string::npos;) lesson.replace(at, 5, "alpha-helix");
  writeFile(scratch.path / "helix.md", lesson);
  app.open((scratch.path / "helix.md").string());
  app.finishLoading();
  d->frames(5);
  REQUIRE(app.lesson.onStage());
  CHECK_FALSE(app.scene.look.atoms.annotations);
  CHECK(seenScene(app).annotations.empty());
}

TEST_CASE(
    "without a style or colours on the page the picture keeps those of the menus; what is hidden there is added") {
  auto d = startWith("1ubq");
  Application& app = d->app();
  d->frames(5);
  OwnLook& own = app.extensions().own_look;
  app.scene.look.atoms.styles = {{.style = DrawStyle::Sticks}};
  app.scene.look.atoms.colouring = schemeColouring(*app.scene.stage().molecule, "charge");
  own.values = {"", "residue 1", "", "", "", ""};
  own.show(app.scene);
  REQUIRE(app.scene.look.atoms.styles.size() == 1);
  CHECK(app.scene.look.atoms.styles[0].style == DrawStyle::Sticks);
  REQUIRE(app.scene.look.atoms.colouring);
  CHECK(app.scene.look.atoms.colouring->scheme == "charge");
  CHECK(app.scene.look.atoms.hidden);
  own.values = {"cartoon", "", "element", "", "", ""};
  own.show(app.scene);
  CHECK(app.scene.look.atoms.styles[0].style == DrawStyle::Cartoon);
  CHECK_FALSE(app.scene.look.atoms.colouring);
  CHECK_FALSE(app.scene.look.atoms.hidden);
}

TEST_CASE("where a lesson locks what is shown the page stays shut, with another molecule on the stage too") {
  auto d = startWith("");
  Application& app = d->app();
  const ScratchFolder scratch;
  std::string lesson = argonLesson("Locked", "  - A goal\n", "Text.\n");
  lesson.replace(lesson.find("\n```\n"), 1, "\nlocked: show\n");
  writeFile(scratch.path / "locked.md", lesson);
  app.open((scratch.path / "locked.md").string());
  app.finishLoading();
  app.open("1ubq");
  app.finishLoading();
  d->frames(5);
  REQUIRE_FALSE(app.lesson.onStage());
  REQUIRE(app.lesson.locks("show"));
  CHECK_FALSE(enabled(*findAction("look"), app));
}

TEST_CASE("the page says what is wrong with a value, and shows nothing then") {
  auto d = startWith("1ubq");
  Application& app = d->app();
  app.panels.pages.look = true;
  d->frames(3);
  d->type("cartoons");
  d->frames(3);
  CHECK(contains(d->text("look/style/fault"), "cartoon"));
  d->tap("Enter");
  d->frames(3);
  CHECK(app.panels.pages.look);
  CHECK(app.scene.look.atoms.styles.empty());
  app.extensions().own_look.values = {"", "chain Q", "", "", "", ""};
  d->frames(3);
  CHECK(contains(d->text("look/hide/fault"), "Q"));
}

TEST_CASE("colours are chosen in the menu; in a lesson only those that reveal nothing but elements and chains") {
  auto d = startWith("1ubq");
  d->frames(5);
  d->click("menu/view");
  d->frames(3);
  CHECK(d->click("menu/view/colours"));
  d->frames(3);
  REQUIRE(d->click("menu/view/colours/hydrophobicity"));
  d->frames(10);
  REQUIRE(d->app().scene.look.atoms.colouring);
  CHECK(d->shows("view/legend"));
  CHECK(d->click("tool/undo"));
  d->frames(5);
  CHECK_FALSE(d->app().scene.look.atoms.colouring);
  openFirst(*d);
  d->app().finishLoading();
  d->frames(5);
  d->click("menu/view");
  d->frames(3);
  d->click("menu/view/look");
  d->frames(3);
  CHECK_FALSE(d->app().panels.pages.look);
  d->click("menu/view/colours");
  d->frames(3);
  CHECK(d->shows("menu/view/colours/chain"));
  CHECK_FALSE(d->shows("menu/view/colours/charge"));
}

}  // namespace moltact
