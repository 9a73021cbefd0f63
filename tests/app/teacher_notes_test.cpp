// The lesson's notes for the teacher: to whom they are visible, and when they are hidden.
#include <algorithm>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/lesson/lesson.h"
#include "engine/lesson/reader.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

const std::string kNote = "> [!NOTE]\n> Teacher: Let them push first.\n>\n> Most expect a [flat](#one-step) floor.\n";

// The texts of the notes that are drawn.
std::string notes() {
  std::string out;
  for (const auto& [name, record] : widgets().all())
    if (name.ends_with("/note/0") || name.ends_with("/note/1") || name.ends_with("/teacher")) out += record.text + "|";
  return out;
}

struct TeacherNotesOpened {
  ScratchFolder scratch;
  std::unique_ptr<ScriptedUser> driver;
  explicit TeacherNotesOpened(const std::string& body) {
    writeFile(scratch.path / "notes.md", argonLesson("Notes", "  - A goal\n", body));
    ScriptedUser::Options options;
    options.application.attempts_folder = scratch.path / "attempts";
    driver = startWith((scratch.path / "notes.md").string(), std::move(options));
  }
  bool offered() const { return enabled(*findAction("teacher-notes"), driver->app()); }
};

}  // namespace

TEST_CASE(
    "a note for the teacher is not seen until the Lesson menu's Teacher's notes is chosen; it stands in a box among "
    "the "
    "text then, and is gone when it is chosen again") {
  TeacherNotesOpened o("Text.\n\n" + kNote + "\nMore.\n");
  ScriptedUser& d = *o.driver;
  CHECK(notes().empty());
  const Picture without = d.picture();
  d.click("menu/lesson");
  d.frames(3);
  CHECK(d.text("menu/lesson/teacher-notes").empty());
  CHECK(d.click("menu/lesson/teacher-notes"));
  d.frames(5);
  CHECK(notes() == "Let them push first.|Most expect a flat floor.|For the teacher|");
  CHECK(difference(without, d.picture()) > 0.005);
  d.click("menu/lesson");
  d.frames(3);
  CHECK(d.text("menu/lesson/teacher-notes") == "on");
  CHECK(d.click("menu/lesson/teacher-notes"));
  d.frames(5);
  CHECK(notes().empty());
}

TEST_CASE("a lesson without notes for the teacher, and the welcome page, offer no such view") {
  TeacherNotesOpened o("> [!TIP]\n> A hint.\n\n> [!NOTE]\n> A note for all.\n");
  CHECK_FALSE(o.offered());
  o.driver->app().panels.pages.welcome = true;
  CHECK_FALSE(o.offered());
}

TEST_CASE("the notes go when turns begin and when a student is asked for a name, and cannot be shown meanwhile") {
  TeacherNotesOpened o(kNote);
  ScriptedUser& d = *o.driver;
  REQUIRE(o.offered());
  findAction("teacher-notes")->run(d.app());
  d.frames(3);
  REQUIRE_FALSE(notes().empty());
  d.app().extensions().turns.begin({"Ana", "Bo"}, 60.0);
  d.frames(3);
  CHECK(notes().empty());
  CHECK_FALSE(o.offered());
  d.app().extensions().turns.end();
  d.frames(3);
  CHECK(notes().empty());
  CHECK(o.offered());
  findAction("teacher-notes")->run(d.app());
  d.app().extensions().name_asker.ask(false);
  d.frames(3);
  CHECK(notes().empty());
  CHECK_FALSE(o.offered());
  d.app().extensions().name_asker.give("Ana");
  d.frames(3);
  CHECK(notes().empty());
  CHECK(o.offered());
}

TEST_CASE("the notes go when a lesson is opened, by whomever; they stay when its author saves it") {
  TeacherNotesOpened o(kNote);
  ScriptedUser& d = *o.driver;
  findAction("teacher-notes")->run(d.app());
  d.frames(3);
  REQUIRE_FALSE(notes().empty());
  openFirst(d);
  d.frames(5);
  CHECK(notes().empty());
  findAction("teacher-notes")->run(d.app());
  const std::filesystem::path file = o.scratch.path / "notes.md";
  d.app().open(file.string());
  d.frames(3);
  CHECK(notes().empty());
  findAction("teacher-notes")->run(d.app());
  LessonReading again = readLesson(file);
  REQUIRE(again.lesson);
  d.app().lesson.replace(*std::move(again.lesson));
  d.frames(3);
  CHECK_FALSE(notes().empty());
}

TEST_CASE("the newcomer's lesson has notes for the teacher, none of which is seen at its start") {
  auto d = startWith("");
  openFirst(*d);
  d->frames(5);
  REQUIRE(hasTeacherNotes(d->app().lesson.session()->lesson()));
  CHECK(notes().empty());
}

TEST_CASE(
    "the teacher's kit of the open lesson is written into the chosen folder; it is offered in a lesson only, and not "
    "during turns or while a student is asked for a name") {
  TeacherNotesOpened o("Text.\n\n" + kNote);
  ScriptedUser& d = *o.driver;
  const Action& kit = *findAction("teachers-kit");
  REQUIRE(enabled(kit, d.app()));
  const std::filesystem::path folder = o.scratch.path / "attempts", page = folder / "notes.kit.html";
  std::filesystem::create_directories(folder);
  kit.run(d.app());
  d.frames(5);
  CHECK(d.click("file/choose"));
  d.frames(5);
  REQUIRE(std::filesystem::exists(page));
  CHECK(std::filesystem::file_size(page) > 4000);
  d.app().extensions().turns.begin({"Ana", "Bo"}, 60.0);
  CHECK_FALSE(enabled(kit, d.app()));
  d.app().extensions().turns.end();
  CHECK(enabled(kit, d.app()));
  d.app().extensions().name_asker.ask(false);
  CHECK_FALSE(enabled(kit, d.app()));
  d.app().extensions().name_asker.give("Ana");
  CHECK(enabled(kit, d.app()));
  d.app().panels.pages.welcome = true;
  CHECK_FALSE(enabled(kit, d.app()));
}

}  // namespace moltact
