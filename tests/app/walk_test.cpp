// A student's whole session: the welcome page, a lesson, a wrong answer, a hint, preferences, resuming, a lesson that
// its author saves again meanwhile, and the report.
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// A class's folder: a lesson of its own, a copy of the first one, and the attempts at it.
struct ClassFolder {
  ScratchFolder scratch;
  fs::path lesson = scratch.path / "lessons" / "first-touch.md", attempts = scratch.path / "attempts";
  std::string text = bytesOf(MOLTACT_SOURCE_DIR "/lessons/first-touch.md");

  ClassFolder() {
    fs::create_directories(lesson.parent_path());
    save(text);
  }
  // A file system may keep times by the second: each save is a second later than the one before.
  void save(const std::string& bytes) {
    writeFile(lesson, bytes);
    fs::last_write_time(lesson, fs::file_time_type::clock::now() + std::chrono::seconds(++saves_));
  }
  // The text with a part of it changed.
  std::string with(const std::string& old, const std::string& put) const {
    std::string out = text;
    REQUIRE(out.find(old) != std::string::npos);
    return out.replace(out.find(old), old.size(), put);
  }
  std::string report() const {
    const std::string folder = scratch.path.string();
    const std::string command = "'" MOLTACT_BINARY "' report '" + attempts.string() + "' --csv '" + folder +
                                "/class.csv' --html '" + folder + "/class.html' >'" + folder + "/said'";
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 0);
    return bytesOf(scratch.path / "said");
  }

 private:
  int saves_ = 0;
};

void runAll(ScriptedUser& d, const std::string& script, const char* part) {
  const std::optional<Problem> problem = d.run(script, part);
  REQUIRE_MESSAGE(!problem, problem->text());
}

// The cell of a table's only row, by its column.
std::string cell(const std::string& csv, const std::string& column) {
  std::vector<std::vector<std::string>> rows(1);
  bool quoted = false;
  std::string field;
  for (std::size_t k = csv.starts_with("\xEF\xBB\xBF") ? 3 : 0; k < csv.size(); ++k) {
    if (csv[k] == '"')
      quoted = !quoted;
    else if (!quoted && (csv[k] == ',' || csv[k] == '\n')) {
      rows.back().push_back(std::exchange(field, {}));
      if (csv[k] == '\n') rows.emplace_back();
    } else if (csv[k] != '\r') {
      field += csv[k];
    }
  }
  REQUIRE(rows.size() == 3);  // head, row, and nothing after the last line
  for (std::size_t k = 0; k < rows[0].size(); ++k)
    if (rows[0][k] == column) return rows[1][k];
  FAIL("no column " << column);
  return {};
}

}  // namespace

TEST_CASE(
    "a student goes from the welcome page through a step, a wrong and a right answer, a hint and the preferences; his "
    "lesson is reloaded, his class reported") {
  ClassFolder klass;
  ScriptedUser::Options options;
  options.application.attempts_folder = klass.attempts;
  auto d = startWith("", options);
  d->app().settings.lesson_folder = klass.lesson.parent_path().string();
  d->app().panels.pages.welcome = true;
  runAll(*d, R"(
wait 40
point welcome/own/first-touch
expect welcome/own/first-touch First touch
click welcome/own/first-touch
wait 20
expect lesson/place Step 1 of
expect lesson/more Touch the rings.
point task/0
expect task/0 current: Touch the rings.
point view 0.5 0.5
press
wait 150
release
expect task/0 done:
click lesson/next
wait 20
expect lesson/place Step 2 of
click question/0/0
wait 3
expect question/0/feedback That is what you feel on a round face.
click question/0/1
wait 3
expect question/0/feedback Yes. It touches both
key Alt+Left
wait 3
expect lesson/place Step 1 of
)",
         "walk");

  // The first hint of the step opens and closes.
  std::string hint;
  for (const auto& [name, record] : widgets().all())
    if (hint.empty() && name.ends_with("/hint")) hint = name;
  REQUIRE_FALSE(hint.empty());
  CHECK(d->text(hint) == "closed");
  CHECK(d->click(hint));
  CHECK(d->text(hint) == "open");
  CHECK_FALSE(d->text(hint + " text").empty());

  runAll(*d, R"(
key Ctrl+,
wait 3
click preferences/theme/Dark
click preferences/numbers/1,4
wait 3
key Escape
wait 3
expect probe 1,4 Å
key Alt+Right
wait 3
point question/0/feedback
expect question/0/feedback Yes. It touches both
)",
         "walk on");
  CHECK(d->app().settings.theme == ThemeChoice::Dark);

  // The author saves: the step, its answers and the view stay. An error keeps the last good version until it is mended.
  const Camera camera = d->app().scene.camera;
  klass.save(klass.with("Here are two atoms of argon", "Here, said anew, are two atoms of argon"));
  runAll(*d, R"(
wait 60
expect message/0 Read again: first-touch.md
point lesson/place
expect lesson/place Step 2 of
expect lesson/0 Here, said anew
point question/0/feedback
expect question/0/feedback Yes. It touches both
)",
         "reload");
  CHECK(d->app().scene.camera == camera);
  klass.save(klass.with("feel: pit", "feel: pitt"));
  runAll(*d, R"(
wait 60
expect lesson-problems first-touch.md: 1 problem. You see the last good version
point lesson/0
expect lesson/0 Here, said anew
click lesson-problems/show
wait 3
expect lesson-problem/0 pit
)",
         "reload with an error");
  klass.save(klass.text);
  runAll(*d, R"(
wait 60
expect-not lesson-problems problem
point lesson/place
expect lesson/place Step 2 of
point question/0/feedback
expect question/0/feedback Yes. It touches both
key Ctrl+H
wait 3
point welcome/next
expect welcome/next Back to First touch
click welcome/molecule/benzene
wait 10
expect status/molecule benzene
)",
         "mended, and away");
  CHECK_FALSE(d->shows("lesson-problems"));

  REQUIRE(d->app().extensions().recorder.flush());
  CHECK(contains(klass.report(), "1 lesson, 1 attempt, all without a name"));
  const std::string csv = bytesOf(klass.scratch.path / "class.csv"), html = bytesOf(klass.scratch.path / "class.html");
  CHECK(cell(csv, "lesson_file") == "first-touch.md");
  CHECK(cell(csv, "answered") == "1");
  CHECK(cell(csv, "right_at_first_try") == "0");
  CHECK(cell(csv, "hints") == "1");
  CHECK(cell(csv, "finished") == "no");
  CHECK(std::stod(cell(csv, "peak_force_N")) > 0.05);
  const Question& question = d->app().lesson.session()->lesson().steps[1].questions[0];
  const std::string column = "first-touch.md#" + d->app().lesson.session()->lesson().steps[1].id + "/" + question.id;
  CHECK(cell(csv, column + " first answer") == plainText(question.choices[0].text));
  CHECK(cell(csv, column + " tries") == "2");
  for (const std::string& part :
       {std::string("First touch"), plainText(question.title), plainText(question.choices[0].text)})
    CHECK(contains(html, part));
}

TEST_CASE("with keys alone the preferences are reached, walked through and changed") {
  auto d = startWith("argon");
  d->tap("Ctrl+,");
  d->frames(3);
  REQUIRE(d->shows("preferences/close"));
  const Settings before = d->app().settings;
  bool changed = false;
  for (int k = 0; k < 12 && !changed; ++k) {
    d->tap("Down");
    d->frames(2);
    d->tap("Space");
    d->frames(2);
    changed = !(d->app().settings == before);
  }
  CHECK(changed);
  d->tap("Escape");
  d->frames(3);
  CHECK_FALSE(d->shows("preferences/close"));
}

}  // namespace moltact
