// The window's panels, files and themes, off-screen.
#include <filesystem>
#include <new>
#include <stdexcept>

#include "app/ui/files/settings.h"
#include "app/ui/scene/loader.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

}  // namespace

TEST_CASE("a broken file leaves the scene and shows the reason until it is dismissed") {
  Scratch scratch;
  auto d = startWith();
  const auto before = d->app().scene.stage().molecule;
  while (d->click("message/0/dismiss")) {
  }
  d->app().open(
      scratch.file("broken.pdb", "ATOM      1  N   ALA A   1      xx.xxx  13.207   2.100  1.00  0.00           N\n"));
  d->frames(2);
  CHECK(d->app().scene.stage().molecule == before);
  CHECK(contains(d->text("message/0"), "broken.pdb"));
  d->app().open(scratch.folder / "missing.pdb");
  d->frames(2);
  CHECK(d->app().scene.stage().molecule == before);
  CHECK(contains(d->text("message/1"), "missing.pdb"));
  CHECK(d->click("message/0/dismiss"));
  CHECK(d->click("message/0/dismiss"));
  CHECK_FALSE(d->shows("message/0"));
}

TEST_CASE("a name that is not in the library is answered with the name that was meant") {
  auto d = startWith("");
  d->app().open("1ubp");
  d->frames(2);
  CHECK(contains(d->text("message/0"), "1ubq"));
  CHECK_FALSE(bool(d->app().scene.stage()));
}

TEST_CASE(
    "the parts of a file that were not read are reported for 6 s when the user opens it, and not in "
    "a lesson's step") {
  auto d = startWith("1ubq");
  CHECK(contains(d->text("message/0"), "left out"));
  d->frames(6 * 60 + 2);
  CHECK_FALSE(d->shows("message/0"));
  openFirst(*d);
  d->frames(5);
  REQUIRE(d->app().lesson.follow("#a-protein"));
  d->frames(20);
  REQUIRE(d->app().lesson.session()->step().title == "A protein");
  CHECK_FALSE(d->shows("message/0"));
}

TEST_CASE("an exception while a file is read becomes a problem that names the file") {
  Loader starved([](const MoleculeKey&) -> Loaded { throw std::bad_alloc(); });
  starved.begin({"huge.pdb"});
  const std::optional<Loaded> none = starved.wait();
  REQUIRE(none);
  REQUIRE_FALSE(none->stage);
  CHECK(contains(none->stage.problem().text(), "huge.pdb"));
  CHECK(contains(none->stage.problem().text(), "memory"));
  Loader failing([](const MoleculeKey&) -> Loaded { throw std::runtime_error("disk on fire"); });
  failing.begin({"a.pdb"});
  const std::optional<Loaded> reported = failing.wait();
  REQUIRE(reported);
  CHECK(contains(reported->stage.problem().text(), "disk on fire"));
}

TEST_CASE("a broken lesson is reported with its line and leaves the one that is open") {
  Scratch scratch;
  auto d = startWith("");
  openFirst(*d);
  d->frames(5);
  const std::string title = d->text("lesson/title");
  REQUIRE_FALSE(title.empty());
  d->app().open(scratch.file("bad.md", "---\ntitle: Bad\n---\n\n## Step\n\n```touch\npress: all\nuntil: 0.5\n```\n"));
  d->frames(2);
  CHECK(d->text("lesson/title") == title);
  CHECK(contains(d->text("lesson-problems"), "bad.md"));
}

TEST_CASE("the first lesson opens with its molecule, and Next and Back walk through its steps") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(20);
  CHECK(bool(d->app().scene.stage()));
  CHECK(contains(d->text("lesson/place"), "Step 1 of"));
  CHECK(d->click("lesson/next"));
  CHECK(contains(d->text("lesson/place"), "Step 2 of"));
  d->tap("Alt+Right");
  CHECK(contains(d->text("lesson/place"), "Step 3 of"));
  d->tap("Alt+Left");
  CHECK(d->click("lesson/back"));
  CHECK(contains(d->text("lesson/place"), "Step 1 of"));
}

TEST_CASE("pressing the molecule of the first lesson completes its first task") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(20);
  CHECK(contains(d->text("task/0"), "current: Touch the rings.\n"));
  CHECK(d->text("task/1") == "waiting: Push into the rings until they push back with 0.8 N.");
  d->point("view");
  d->press();
  d->frames(120);
  CHECK(contains(d->text("task/0"), "done: "));
}

TEST_CASE("in all 7 steps of the first lesson every atom lies in the view, with room for the probe beside it") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(20);
  const std::vector<Step> steps = d->app().lesson.session()->lesson().steps;
  REQUIRE(steps.size() == 7);
  for (const Step& step : steps) {
    CAPTURE(step.title);
    REQUIRE(d->app().lesson.follow('#' + step.id));
    d->frames(20);
    const Camera& camera = d->app().scene.camera;
    const glm::vec2 size = d->app().layout().view.size();
    const double probe_A = d->app().scene.servo_settings.probe_A;
    int outside = 0;
    for (const Sphere& a : d->app().scene.stage().molecule->spheres) {
      const Vec3 at = camera.project(PointA{a.centre_A}, int(size.x), int(size.y));
      const double room = (a.radius_A + 2.0 * probe_A) / camera.pixel_A(at.z, int(size.y));
      outside += at.x < room || at.y < room || at.x > double(size.x) - room || at.y > double(size.y) - room;
    }
    CHECK(outside == 0);
  }
}

TEST_CASE("a step whose molecule is not open says so, and a button brings it back") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(20);
  CHECK_FALSE(d->shows("task/0/bring back"));
  d->app().open("benzene");
  d->frames(5);
  REQUIRE(d->app().scene.stage().molecule->atoms.size() == 12);
  CHECK(contains(d->text("task/0"), "This step uses pentacene."));
  CHECK(d->click("task/0/bring back"));
  d->frames(5);
  CHECK(d->app().scene.stage().molecule->atoms.size() == 36);
  CHECK_FALSE(d->shows("task/0/bring back"));
  CHECK_FALSE(contains(d->text("task/0"), "This step uses"));
}

TEST_CASE("the theme switches from the menu, and most of the window changes with it") {
  auto d = startWith();
  const Picture light = d->picture();
  CHECK(d->click("menu/view"));
  CHECK(d->click("menu/view/dark"));
  d->frames(20);
  CHECK(d->app().settings.theme == ThemeChoice::Dark);
  CHECK(difference(light, d->picture()) > 0.5);
}

TEST_CASE("resizing down to 64 by 64 and up again keeps the program running") {
  auto d = startWith();
  for (const auto& [width, height] : {std::pair{640, 480}, {64, 64}, {3000, 200}, {200, 1500}, {1280, 800}})
    d->resize(width, height);
  CHECK(d->shows("view"));
}

TEST_CASE("Ctrl+O opens a page in which a typed path is opened") {
  auto d = startWith();
  d->tap("Ctrl+O");
  d->frames(3);
  REQUIRE(d->shows("open/path"));
  d->type(std::string(MOLTACT_SOURCE_DIR) + "/molecules/benzene.pdb");
  d->tap("Enter");
  d->frames(10);
  CHECK_FALSE(d->shows("open/path"));
  CHECK(d->app().scene.stage().molecule->atoms.size() == 12);
}

TEST_CASE("while a text field has the keyboard, arrows and space neither move nor push the probe") {
  auto d = startWith();
  d->tap("Ctrl+O");
  d->frames(3);
  const Vec3 before = d->app().scene.log().latest().hip.A;
  d->hold("Right");
  d->hold("Space");
  d->frames(60);
  CHECK_FALSE(d->app().scene.controls.pressing());
  CHECK(glm::distance(d->app().scene.log().latest().hip.A, before) < 1e-3);
}

TEST_CASE("a molecule of the library opens from the File menu") {
  auto d = startWith("");
  CHECK(d->click("menu/file"));
  CHECK(d->click("menu/file/library"));
  CHECK(d->click("menu/file/library/benzene"));
  d->frames(10);
  REQUIRE(bool(d->app().scene.stage()));
  CHECK(d->app().scene.stage().molecule->atoms.size() == 12);
}

TEST_CASE("the probe's slider sets the radius, and the shape switches change the picture") {
  auto d = startWith();
  d->drag("probe", 400, 0);
  CHECK(d->app().scene.servo_settings.probe_A == doctest::Approx(6.0));
  CHECK(d->text("probe") == "6.0\u00a0Å");
  const Picture before = d->picture();
  const bool spheres = d->app().scene.look.shown.has(ViewPart::Spheres);
  CHECK(d->click("show/spheres"));
  CHECK(d->app().scene.look.shown.has(ViewPart::Spheres) != spheres);
  d->frames(20);
  CHECK(difference(before, d->picture()) > 0.002);
}

TEST_CASE(
    "a number of a script that is none, or that no window and no patience holds, ends it with its line and range") {
  auto d = startWith();
  CHECK_FALSE(d->run("size 400 300\nwheel -2\ndrag view 5 -5 right\nwait 2\npoint view 0.5 0.5\n", "s"));
  for (const char* act :
       {"size 1e300 300", "size 400 -1", "size 400 nan", "scale 0", "text-size 1e37", "drag view 1e300 0",
        "point view inf 0", "wheel -1e37", "wait 1e37", "wait -1", "wait for it", "wait 0x10"}) {
    CAPTURE(std::string(act));
    const auto problem = d->run(std::string("wait 1\n") + act + "\n", "s");
    REQUIRE(problem);
    CHECK(problem->line == 2);
    CHECK(contains(problem->message, "is no number from "));
  }
}

TEST_CASE("Ctrl+Q leaves") {
  auto d = startWith();
  d->tap("Ctrl+Q");
  CHECK(d->app().leaving());
}

TEST_CASE("two windows that change different settings keep both, and what a newer version has set stays") {
  Scratch scratch;
  const fs::path file = scratch.file("settings.json", R"({"theme": "dark", "scale": 1.25, "of a newer one": [1, 2]})");
  const Settings read = loadSettings(file).settings;
  Settings one = read, two = read;
  one.sound = true;
  two.scale = 2.0;
  REQUIRE(saveSettings(one, file, read).empty());
  REQUIRE(saveSettings(two, file, read).empty());
  const Settings now = loadSettings(file).settings;
  CHECK(now.sound);
  CHECK(now.scale == 2.0);
  CHECK(now.theme == ThemeChoice::Dark);
  std::ifstream in(file);
  CHECK(contains({std::istreambuf_iterator<char>(in), {}}, "of a newer one"));
  // A failure to write is reported.
  CHECK(contains(saveSettings(two, scratch.folder / "settings.json" / "x" / "settings.json"), "could not be saved"));
}

TEST_CASE("settings come back as they were kept, and a broken file gives the defaults and says so") {
  Scratch scratch;
  const fs::path file = scratch.folder / "deep" / "settings.json";
  Settings s;
  s.theme = ThemeChoice::Dark;
  s.scale = 1.5;
  s.remember("/tmp/a.pdb");
  REQUIRE(saveSettings(s, file).empty());
  const LoadedSettings again = loadSettings(file);
  CHECK(again.settings == s);
  CHECK(again.fault.empty());
  CHECK(loadSettings(scratch.folder / "none.json").fault.empty());
  for (const char* broken : {"", "{", "[1,2]", "{\"scale\": 1e999}", "\xff\xfe"}) {
    const LoadedSettings reported = loadSettings(scratch.file("broken.json", broken));
    CHECK(reported.settings == Settings());
    CAPTURE(broken);
    CHECK_FALSE(reported.fault.empty());
  }
  const LoadedSettings odd =
      loadSettings(scratch.file("odd.json", R"({"scale": 900, "theme": 7, "recent": [1, "/x"]})"));
  CHECK(odd.settings.scale == 3.0);
  CHECK(odd.settings.recent.size() == 1);
}

}  // namespace moltact
