// First actions of users who explore a molecule: the pointer over an atom, a double click, an element's name, Escape;
// and the order of lessons in lists.
#include <algorithm>

#include "app/ui/extensions/extensions.h"
#include "app/ui/files/library.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/scene/contact_text.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// Points at an atom from in front of it, and gives whether it is in the view.
bool pointAt(ScriptedUser& d, std::uint32_t atom) {
  const auto size = d.app().layout().view.size();
  const Vec3 px = d.app().scene.camera.project(PointA{d.app().scene.stage().molecule->spheres[atom].centre_A},
                                               int(size.x), int(size.y));
  return d.point("view", px.x / double(size.x), px.y / double(size.y));
}

std::unique_ptr<ScriptedUser> openLesson(const Scratch& scratch, const std::string& text) {
  auto d = startWith("");
  d->app().open(scratch.file("asks.md", text));
  d->app().finishLoading();
  d->frames(20);
  return d;
}

}  // namespace

TEST_CASE("a pointer over an atom names it without a push, in a lesson only once nothing is asked any more") {
  auto d = startWith("benzene");
  REQUIRE(pointAt(*d, 0));
  d->frames(3);
  CHECK(contains(d->text("view/under the pointer"), "carbon"));
  d->press();
  d->frames(10);
  CHECK_FALSE(d->shows("view/under the pointer"));
  d->release();
  d.reset();  // one window at a time

  Scratch scratch;
  const std::string asks = argonLesson("Asks", "  - G\n", "```touch\nreach: atom 0\nsay: Touch it.\n```\n");
  auto asked = openLesson(scratch, asks);
  REQUIRE(pointAt(*asked, 0));
  asked->frames(3);
  CHECK_FALSE(asked->shows("view/under the pointer"));
  asked->press();
  asked->frames(60);
  asked->release();
  REQUIRE(asked->app().lesson.session()->stepDone());
  REQUIRE(pointAt(*asked, 0));
  asked->frames(60);
  CHECK(contains(asked->text("view/under the pointer"), "argon"));

  asked.reset();
  auto hidden = openLesson(scratch,
                           "---\ntitle: T\nminutes: 5\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
                           "## One\n```scene\nmolecule: argon\nhide: all\n```\nText.\n");
  REQUIRE(pointAt(*hidden, 0));
  hidden->frames(3);
  CHECK_FALSE(hidden->shows("view/under the pointer"));
}

TEST_CASE("two clicks on an atom bring the camera closer than half of its way and that atom to the view's middle") {
  auto d = startWith("1ubq");
  const double before_A = d->app().scene.camera.distance_A;
  d->point("view", 0.45, 0.45);
  const auto size = d->app().layout().view.size();
  const auto atom = atomAt(d->app().scene, {0.45 * double(size.x), 0.45 * double(size.y)}, {size.x, size.y});
  REQUIRE(atom);
  for (int k = 0; k < 2; ++k) {
    d->press();
    d->frames(2);
    d->release();
    d->frames(2);
  }
  d->frames(60);
  CHECK(d->app().scene.camera.distance_A < 0.5 * before_A);
  const Vec3 px = d->app().scene.camera.project(PointA{d->app().scene.stage().molecule->spheres[*atom].centre_A},
                                                int(size.x), int(size.y));
  CHECK(std::abs(px.x - 0.5 * double(size.x)) < 0.1 * double(size.x));
  CHECK(std::abs(px.y - 0.5 * double(size.y)) < 0.1 * double(size.y));
}

TEST_CASE("'iron', 'Eisen' and 'IRON' are the iron of haemoglobin; 'ion' and an unknown word are no element") {
  auto d = startWith("2hhb");
  const auto faultOf = [&](const char* written) {
    d->app().panels.pages.zoom = true;
    d->app().panels.zoom_atoms = written;
    d->frames(4);
    const std::string fault = d->text("zoom/fault");
    d->tap("Escape");
    d->frames(3);
    return fault;
  };
  CHECK(faultOf("iron") == "");
  CHECK(faultOf("IRON") == "");
  CHECK(faultOf("sulfur") == "");
  CHECK_FALSE(faultOf("irom").empty());
  CHECK_FALSE(faultOf("gold").empty());  // an element that the molecule lacks
  d->app().settings.language = "de";
  d->frames(3);
  CHECK(faultOf("Eisen") == "");
  CHECK(faultOf("eisen") == "");
}

TEST_CASE("Escape four times over leaves an explored molecule where it is, and leads back from the welcome page") {
  auto d = startWith("1ubq");
  for (int k = 0; k < 4; ++k) {
    d->tap("Escape");
    d->frames(2);
  }
  CHECK(d->shows("view"));
  CHECK_FALSE(d->shows("welcome/title"));
  d->tap("Ctrl+H");
  d->frames(3);
  CHECK(d->shows("welcome/title"));
  d->tap("Escape");
  d->frames(3);
  CHECK(d->shows("view"));
}

TEST_CASE("the shelf has the order of the Lesson menu before the first lesson is read and after the last") {
  auto d = startWith("1ubq");
  const auto shelf = [&] {
    std::vector<std::string> out;
    for (const LessonCard& c : d->app().extensions().lesson_list.cards())
      if (!c.own) out.push_back(c.id);
    return out;
  };
  d->tap("Ctrl+H");
  d->frames(1);
  const std::vector<std::string> at_first = shelf();
  d->frames(60);
  std::vector<std::string> menu;
  for (const LibraryItem& l : lessons()) menu.push_back(l.id);
  REQUIRE(at_first.size() > 5);
  CHECK(at_first == menu);
  CHECK(shelf() == menu);
}

TEST_CASE(
    "an English lesson in a German window says 'Atom 0' in German sentences, and what its author wrote in English "
    "ones") {
  Scratch scratch;
  const std::string text = argonLesson(
      "Spike", "  - G\n", "```touch\nreach: atom 0\ncalled: the red spike\nsay: Touch the red spike.\n```\n");
  scratch.file("spike.de.md", text);
  for (const char* language : {"en", "de"}) {
    auto d = startWith("");
    d->app().settings.language = language;
    d->frames(3);
    d->app().open(scratch.file("spike.md", text));
    d->app().finishLoading();
    d->frames(20);
    const TaskStatus status = d->app().lesson.session()->task(0);
    CAPTURE(status.sentence);
    CHECK(status.say == "Touch the red spike.");
    CHECK(contains(status.sentence, "the red spike") == (std::string(language) == "en"));
    CHECK(contains(status.sentence, "Sonde") == (std::string(language) == "de"));
  }
}

TEST_CASE("a lesson for beginners shows no figures of a task that is done, one for the advanced does") {
  Scratch scratch;
  for (const char* level : {"beginner", "advanced"}) {
    std::string text = argonLesson("Figures", "  - G\n", "```touch\nfeel: atoms\ncount: 1\nsay: Touch it.\n```\n");
    text.insert(text.find("minutes:"), std::string("level: ") + level + "\n");
    auto d = openLesson(scratch, text);
    REQUIRE(pointAt(*d, 0));
    d->press();
    d->frames(60);
    d->release();
    d->frames(3);
    CAPTURE(level);
    REQUIRE(d->app().lesson.session()->stepDone());
    CHECK(d->shows("task/0/figures") == (std::string(level) == "advanced"));
  }
}

TEST_CASE("the rings lie round the atoms that the line below names, at a crease too") {
  auto d = startWith("argon");
  REQUIRE(pointAt(*d, 0));
  d->press();
  for (int k = 0; k < 90; ++k) {
    d->frames(1);
    const auto named = d->app().extensions().state_text.namedAtoms();
    if (!named) continue;
    Contact contact = d->app().scene.log().latest().contact;
    contact.atoms = *named;
    contact.feature =
        static_cast<Feature>(std::count_if(named->begin(), named->end(), [](std::int32_t a) { return a >= 0; }));
    const std::string reported = touchedText(*d->app().scene.stage().molecule, contact);
    if (d->shows("view/state")) CHECK(contains(d->text("view/state"), reported));
  }
  CHECK(d->app().extensions().state_text.namedAtoms());
}

}  // namespace moltact
