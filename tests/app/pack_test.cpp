// A pack in the window: opened, listed, resumed, used under a name, and reported.
#include <sys/wait.h>

#include <cstdlib>

#include "app/ui/extensions/extensions.h"
#include "app/ui/files/own_lessons.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_lesson.h"
#include "engine/results/progress.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::string lessonText(const std::string& title, const std::string& front = "") {
  return "---\ntitle: " + title + "\n" + front +
         "minutes: 1\ngoals: G\nmolecules: mine.xyzr\nauthor: A\nlicence: L\n---\n"
         "## One\n```scene\nmolecule: mine.xyzr\n```\n### Question: Q?\n- [x] yes → Right.\n- [ ] no → No.\n\n"
         "## Two\nText.\n\n### Question: R?\n- [x] yes → Right.\n- [ ] no → No.\n";
}

// A teacher's folder with a lesson, and a student's computer.
struct Handed {
  ScratchFolder scratch;
  fs::path teacher = scratch.path / "teacher", packs = scratch.path / "packs", attempts = scratch.path / "attempts";

  Handed() {
    fs::create_directories(teacher);
    writeFile(teacher / "mine.xyzr", "0 0 0 1.5\n3 0 0 1.5\n0 3 0 1.5\n");
  }
  fs::path pack(const std::string& text, const std::string& name = "haem") const {
    writeFile(teacher / (name + ".md"), text);
    const PackedLesson made = packLesson(teacher / (name + ".md"));
    REQUIRE_MESSAGE(made.pack, made.errors.front().text());
    writeFile(scratch.path / (name + ".moltact"), made.pack->bytes);
    return scratch.path / (name + ".moltact");
  }
  ScriptedUser::Options options() const {
    ScriptedUser::Options o;
    o.application.packs_folder = packs;
    o.application.attempts_folder = attempts;
    return o;
  }
};

void answer(ScriptedUser& d) {
  d.app().lesson.session()->choose(0, {0});
  d.frames(5);
}

}  // namespace

TEST_CASE("a pack that is dropped shows its lesson with its own molecule, and has a card when the file is gone") {
  const Handed h;
  const fs::path pack = h.pack(lessonText("Haem pockets"));
  auto d = startWith("", h.options());
  d->app().settings.lesson_folder = (h.scratch.path / "none").string();
  d->app().drop({pack});
  d->frames(10);
  CHECK(d->text("lesson/title") == "Haem pockets");
  REQUIRE(d->app().scene.stage());
  CHECK(d->app().scene.stage().molecule->atoms.size() == 3);
  CHECK(d->app().scene.molecule().file.string().starts_with(h.packs.string()));
  fs::remove(pack);
  fs::remove_all(h.teacher);
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(contains(d->text("welcome/own/haem"), "Haem pockets"));
}

TEST_CASE(
    "a lesson that was left continues when its pack is opened again, and from its card; a newer version has its "
    "place") {
  const Handed h;
  const fs::path pack = h.pack(lessonText("Haem pockets"));
  {
    auto d = startWith(pack.string(), h.options());
    answer(*d);
    d->app().lesson.next();
    d->frames(5);
  }
  {
    auto d = startWith(pack.string(), h.options());
    CHECK(contains(d->text("lesson/place"), "Step 2 of 2"));
    CHECK(d->app().lesson.session()->question(0, 0).answered_right);
  }
  h.pack(lessonText("Haem pockets") + "\nAnd more.\n");
  auto d = startWith(pack.string(), h.options());
  d->app().settings.lesson_folder = (h.scratch.path / "none").string();
  CHECK(contains(d->text("lesson/place"), "Step 2 of 2"));
  d->app().panels.pages.welcome = true;
  d->frames(60);
  std::size_t cards = 0;
  for (const LessonCard& c : d->app().extensions().lesson_list.cards()) cards += c.own;
  CHECK(cards == 1);
  CHECK(std::distance(fs::directory_iterator(h.packs), fs::directory_iterator()) == 2);
}

TEST_CASE("a lesson opened from anywhere has a card once something was done in it, which continues where it was left") {
  const Handed h;
  h.pack(lessonText("Elsewhere"));
  auto d = startWith("", h.options());
  d->app().settings.lesson_folder = (h.scratch.path / "none").string();
  d->app().open(h.teacher / "haem.md");
  d->frames(5);
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(d->text("welcome/own/haem").empty());
  d->app().panels.pages.welcome = false;
  d->frames(5);
  answer(*d);
  d->app().lesson.next();
  d->frames(5);
  d->app().extensions().recorder.flush();
  d->app().open("argon");
  d->frames(5);
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(contains(d->text("welcome/own/haem"), "Elsewhere"));
  CHECK(d->click("welcome/own/haem"));
  d->frames(5);
  CHECK(contains(d->text("lesson/place"), "Step 2 of 2"));
}

TEST_CASE("two lessons of the same file name and different titles do not share what was done in them") {
  const Handed h;
  const fs::path one = h.pack(lessonText("One teacher's"));
  {
    auto d = startWith(one.string(), h.options());
    answer(*d);
    d->app().lesson.next();
    d->frames(5);
  }
  auto d = startWith(h.pack(lessonText("Another teacher's")).string(), h.options());
  CHECK(contains(d->text("lesson/place"), "Step 1 of 2"));
}

TEST_CASE("Add a lesson puts a pack on the shelf without opening it; of a lesson file a copy, with what it needs") {
  const Handed h;
  h.pack(lessonText("A pack"), "packed");
  writeFile(h.scratch.path / "letter.txt", "");
  auto d = startWith("", h.options());
  d->app().settings.lesson_folder = (h.scratch.path / "none").string();
  d->app().files.look(h.scratch.path);
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(d->click("welcome/add"));
  d->frames(5);
  CHECK_FALSE(d->shows("open/library/1ubq"));
  CHECK_FALSE(d->shows("open/entry/letter.txt"));
  CHECK(d->click("open/entry/packed.moltact"));
  d->frames(60);
  CHECK(d->shows("welcome/title"));
  CHECK_FALSE(d->app().lesson.session());
  CHECK(contains(d->text("welcome/own/packed"), "A pack"));

  writeFile(h.teacher / "file.md", lessonText("A file"));
  d->app().extensions().lesson_list.add(h.teacher / "file.md");
  fs::remove_all(h.teacher);
  d->frames(60);
  CHECK(contains(d->text("welcome/own/file"), "A file"));
  CHECK(d->click("welcome/own/file"));
  d->frames(5);
  CHECK(d->app().scene.stage().molecule->atoms.size() == 3);

  // The page that opens files opens again.
  d->tap("Ctrl+O");
  d->frames(5);
  CHECK_FALSE(d->text("open/library/1ubq").empty());  // perhaps farther down than is seen
}

TEST_CASE("a damaged pack and a lesson with a fault are reported and change nothing") {
  const Handed h;
  const std::string bytes = bytesOf(h.pack(lessonText("Haem pockets")));
  writeFile(h.scratch.path / "cut.moltact", bytes.substr(0, bytes.size() / 2));
  writeFile(h.teacher / "bad.md", lessonText("Bad") + "\n![no](gone.png)\n");
  auto d = startWith("argon", h.options());
  for (const fs::path& file : {h.scratch.path / "cut.moltact", h.scratch.path / "none.moltact", h.teacher / "bad.md"}) {
    CAPTURE(file);
    d->app().messages = {};
    if (file.extension() == ".md")
      d->app().extensions().lesson_list.add(file);
    else
      d->app().open(file);
    d->frames(5);
    REQUIRE(d->app().messages.all().size() == 1);
    CHECK(d->app().messages.all().front().kind == MessageKind::Error);
    CHECK(contains(d->app().messages.all().front().text, file.filename().string()));
    CHECK_FALSE(fs::exists(h.packs));
    CHECK_FALSE(d->app().lesson.session());
  }
}

TEST_CASE("a lesson that asks for a name keeps it with the attempt, offers it next time and continues under it") {
  const Handed h;
  const fs::path pack = h.pack(lessonText("Haem pockets", "ask: name\n"));
  {
    auto d = startWith(pack.string(), h.options());
    REQUIRE(d->shows("name/field"));
    d->type("  Ana Müller ");
    CHECK(d->click("name/begin"));
    d->frames(5);
    CHECK_FALSE(d->shows("name/field"));
    CHECK(d->app().extensions().recorder.student() == "Ana Müller");
    answer(*d);
    d->app().lesson.next();
    d->frames(5);
  }
  {
    auto d = startWith(pack.string(), h.options());
    d->frames(5);
    CHECK(d->text("name/field") == "Ana Müller");
    d->tap("Enter");
    d->frames(5);
    CHECK_FALSE(d->shows("name/field"));
    CHECK(contains(d->text("lesson/place"), "Step 2 of 2"));
  }
  {
    auto d = startWith(pack.string(), h.options());
    d->tap("Ctrl+A");
    d->type("Bo");
    CHECK(d->click("name/begin"));
    d->frames(5);
    CHECK(contains(d->text("lesson/place"), "Step 1 of 2"));
    answer(*d);
    // A lesson that does not ask is kept without the name.
    d->app().open(h.pack(lessonText("No name"), "other"));
    d->frames(5);
    CHECK_FALSE(d->shows("name/field"));
    answer(*d);
  }
  const std::string folder = h.scratch.path.string();
  const std::string command = "'" MOLTACT_BINARY "' report '" + h.attempts.string() + "' --csv '" + folder +
                              "/class.csv' --html '" + folder + "/class.html' >/dev/null";
  REQUIRE(WEXITSTATUS(std::system(command.c_str())) == 0);
  const std::string csv = bytesOf(h.scratch.path / "class.csv");
  CHECK(contains(csv, "\nAna Müller,Haem pockets,haem.md,"));
  CHECK(contains(csv, "\nBo,Haem pockets,haem.md,"));
  CHECK_FALSE(contains(csv, "Bo,No name"));
  CHECK(contains(csv, ",No name,other.md,"));
  CHECK(contains(bytesOf(h.scratch.path / "class.html"), "Haem pockets"));
}

TEST_CASE("a name may be omitted: the lesson begins, and no student resumes another's nameless attempt") {
  const Handed h;
  const fs::path pack = h.pack(lessonText("Haem pockets", "ask: code\n"));
  auto d = startWith(pack.string(), h.options());
  CHECK(d->click("name/without"));
  d->frames(5);
  answer(*d);
  d->app().open(pack);
  d->frames(5);
  REQUIRE(d->shows("name/field"));
  d->tap("Escape");
  d->frames(5);
  CHECK_FALSE(d->shows("name/field"));
  CHECK_FALSE(d->app().lesson.session()->question(0, 0).answered_right);
  answer(*d);
  d->app().extensions().recorder.flush();
  std::size_t nameless = 0;
  for (const LessonProgress& p : readProgress(h.attempts, "")) nameless += p.attempts;
  CHECK(nameless == 2);
}

TEST_CASE("where nothing is kept, no name is asked for") {
  const Handed h;
  ScriptedUser::Options options = h.options();
  options.application.attempts_folder.clear();
  auto d = startWith(h.pack(lessonText("Haem pockets", "ask: name\n")).string(), options);
  CHECK(d->text("lesson/title") == "Haem pockets");
  CHECK_FALSE(d->shows("name/field"));
}

TEST_CASE("an attempt at a packed lesson is played back with the molecule of the pack") {
  const Handed h;
  fs::path attempt;
  {
    auto d = startWith(h.pack(lessonText("Haem pockets")).string(), h.options());
    d->point("view", 0.5, 0.5);
    d->press();
    d->frames(40);
    d->release();
    d->frames(10);
    answer(*d);
    d->app().extensions().recorder.flush();
    attempt = d->app().extensions().recorder.file();
  }
  REQUIRE_FALSE(attempt.empty());
  auto d = startWith("argon", h.options());
  d->app().open(attempt);
  d->frames(30);
  CHECK(d->app().scene.molecule().file.filename() == "mine.xyzr");
}

}  // namespace moltact
