// The welcome page: cards, their pictures, progress, keys.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/files/library.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/reader.h"
#include "engine/platform/folders.h"
#include "engine/results/attempt_lines.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

std::unique_ptr<ScriptedUser> startAtWelcome(ScriptedUser::Options options = {}) {
  auto d = startWith("", std::move(options));
  d->app().panels.pages.welcome = true;
  d->frames(60);
  return d;
}

}  // namespace

TEST_CASE("the welcome page has a card with title, minutes and level for every lesson, and one for every molecule") {
  auto d = startAtWelcome();
  REQUIRE(d->shows("welcome/title"));
  CHECK(contains(d->text("welcome/lesson/first-touch"), "First touch"));
  CHECK(contains(d->text("welcome/lesson/first-touch"), "20\u00a0min · beginner"));
  for (const LibraryItem& l : lessons()) CHECK_FALSE(d->text("welcome/lesson/" + l.id).empty());
  for (const LibraryItem& m : library()) CHECK_FALSE(d->text("welcome/molecule/" + m.id).empty());
  CHECK_FALSE(d->shows("view"));
  CHECK_FALSE(d->shows("touch"));
}

TEST_CASE(
    "of lessons with one file name in several folders that of the first counts; all stand by level, length and name, "
    "the newcomer's first") {
  const std::filesystem::path top = std::filesystem::temp_directory_path() / "moltact-shared-lessons";
  const auto put = [&](const char* file, const char* title, const char* more = "") {
    std::filesystem::create_directories((top / file).parent_path());
    std::ofstream(top / file) << "---\ntitle: " << title << "\n" << more << "---\n\n## A step\n\nText.\n";
  };
  put("school/enzymes/enzymes.md", "Enzymes");
  put("school/first-touch.md", "First touch at our school");
  put("program/first-touch.md", "First touch");
  put("program/water.md", "Water", "level: beginner\nminutes: 12\n");
  put("program/ice.md", "Ice", "level: intermediate\nminutes: 3\n");
  put("program/salt.md", "Salt", "minutes: 7\n");
  std::string listed;
  for (const LibraryItem& l : lessonsOf({top / "school", top / "absent", top / "program"}))
    listed += l.id + ": " + l.label + "; ";
  CHECK(listed == "first-touch: First touch at our school; enzymes: Enzymes; salt: Salt; water: Water; ice: Ice; ");
  std::filesystem::remove_all(top);
}

TEST_CASE(
    "a click on a card opens its lesson, which Escape does not leave; Ctrl+H leads to the page, and Escape back to the "
    "lesson") {
  auto d = startAtWelcome();
  CHECK(d->click("welcome/lesson/first-touch"));
  d->frames(5);
  CHECK_FALSE(d->shows("welcome/title"));
  CHECK(contains(d->text("lesson/place"), "Step 1 of"));
  CHECK(d->click("lesson/next"));
  d->tap("Escape");
  CHECK_FALSE(d->shows("welcome/title"));
  d->tap("Ctrl+H");
  CHECK(d->shows("welcome/title"));
  CHECK(contains(d->text("welcome/next"), "Back to First touch"));
  d->tap("Escape");
  CHECK(contains(d->text("lesson/place"), "Step 2 of"));
}

TEST_CASE("arrow keys and Enter alone open the first lesson, and a molecule far down the page") {
  auto d = startAtWelcome();
  d->tap("Right");
  d->tap("Enter");
  d->frames(5);
  CHECK(contains(d->text("lesson/title"), "First touch"));
  d->tap("Ctrl+H");
  for (std::size_t k = 0; k < lessons().size() + library().size() + 8; ++k) d->tap("Right");  // to the last card
  d->tap("Enter");
  d->frames(5);
  CHECK_FALSE(d->shows("welcome/title"));
  CHECK(d->app().scene.molecule().file == library().back().file);
}

TEST_CASE("while the welcome page is open the hand feels nothing") {
  auto d = startWith("argon");
  d->point("view");
  d->hold("Space");
  d->frames(60);
  REQUIRE(d->app().scene.log().force_N() > 0.1);
  d->app().panels.pages.welcome = true;
  d->frames(10);
  CHECK(d->app().scene.log().force_N() == 0.0);
  CHECK(d->app().scene.servo_settings.force_on);
}

TEST_CASE("only cards in sight get pictures; those below when the page scrolls to them; none while a lesson is open") {
  auto d = startWith("");
  d->app().panels.pages.welcome = true;
  const CardPictures& pictures = d->app().extensions().card_pictures;
  d->frames(60);
  const std::size_t first = pictures.drawn();
  CHECK(first >= 3);
  CHECK(first < lessons().size() + library().size());
  CHECK_FALSE(pictures.live());
  REQUIRE(d->point("welcome/lesson/first-touch"));
  for (int k = 0; k < 60; ++k) {
    d->wheel(-3.0);
    d->frames(12);
  }
  CHECK(pictures.drawn() > lessons().size());
  CHECK_FALSE(pictures.live());
  d->app().settings.colour_blind_safe = true;  // all pictures are wanted anew
  d->frames(2);
  const std::size_t before = pictures.drawn();
  CHECK(pictures.live());
  d->app().panels.pages.welcome = false;
  d->frames(30);
  CHECK(pictures.drawn() <= before + 1);
  CHECK_FALSE(pictures.live());
}

TEST_CASE("pictures of cards are drawn once and found in the cache at the next start; broken ones are drawn again") {
  Scratch scratch;
  ScriptedUser::Options options;
  options.application.cache_folder = scratch.folder / "cache";
  std::size_t drawn = 0, other_colours = 0;
  {
    auto d = startAtWelcome(options);
    drawn = d->app().extensions().card_pictures.drawn();
    CHECK(drawn >= 3);
    CHECK_FALSE(d->app().extensions().card_pictures.live());
  }
  {
    auto d = startAtWelcome(options);
    CHECK(d->app().extensions().card_pictures.drawn() == 0);
    d->app().settings.colour_blind_safe = true;
    d->frames(60);
    other_colours = d->app().extensions().card_pictures.drawn();
    CHECK(other_colours >= 3);
  }
  for (const auto& file : std::filesystem::directory_iterator(options.application.cache_folder))
    std::ofstream(file.path()) << "no picture";
  auto d = startAtWelcome(options);
  d->app().settings.colour_blind_safe = true;
  d->frames(60);
  CHECK(d->app().extensions().card_pictures.drawn() == drawn + other_colours);
}

TEST_CASE("in every language the title and the line of each shipped lesson are whole on its card at 1280x800") {
  auto d = startAtWelcome();
  for (const Language& language : languages(translationsFolder())) {
    d->app().settings.language = language.code;
    d->frames(60);
    REQUIRE(moltact::language() == language.code);
    CAPTURE(language.code);
    std::size_t cards = 0;
    for (const LessonCard& card : d->app().extensions().lesson_list.cards()) {
      if (card.own) continue;
      ++cards;
      // Only the end of a text is cut, from its second line.
      for (const std::string& cut : widgets().cut())
        CHECK_MESSAGE((!card.title.ends_with(cut) && !card.description.ends_with(cut)), card.title << ": " << cut);
    }
    CHECK(cards == lessons().size());
  }
}

TEST_CASE("lessons of one's own have cards, and one that cannot be read says why") {
  Scratch scratch;
  std::stringstream text;
  text << std::ifstream(std::string(MOLTACT_SOURCE_DIR) + "/lessons/first-touch.md").rdbuf();
  scratch.file("mine.md", text.str().replace(text.str().find("First touch"), 11, "My own"));
  scratch.file("broken.md", "---\ntitle: Broken\n---\n\n## Step\n\n```touch\npress: all\nuntil: 0.5\n```\n");
  auto d = startWith("");
  d->app().settings.lesson_folder = scratch.folder.string();
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(contains(d->text("welcome/own/mine"), "My own"));
  CHECK(contains(d->text("welcome/own/broken"), "cannot be opened"));
  CHECK(d->click("welcome/own/mine"));
  d->frames(5);
  CHECK(contains(d->text("lesson/title"), "My own"));
}

TEST_CASE("a lesson that was left at its third step is offered first and continues there") {
  Scratch scratch;
  LessonReading reading = readLesson(std::string(MOLTACT_SOURCE_DIR) + "/lessons/first-touch.md");
  REQUIRE(reading.lesson);
  AttemptHeader header;
  header.program = "test";
  header.began = "2026-11-21T10:00:00Z";
  header.lesson = outlineOf(*reading.lesson, "0");
  const std::size_t parts = header.lesson.parts();
  std::string lines = lineOf(header);
  lines += lineOf(AttemptEvent{1.0, StepEntered{reading.lesson->steps[2].id}});
  lines += lineOf(AttemptEvent{2.0, ProgressMade{reading.lesson->steps[2].id, 2, parts}});
  scratch.file("attempt.jsonl", lines);
  ScriptedUser::Options options;
  options.application.attempts_folder = scratch.folder;
  auto d = startAtWelcome(options);
  CHECK(contains(d->text("welcome/next"), "Go on with First touch"));
  CHECK(d->click("welcome/next"));
  d->frames(5);
  CHECK(contains(d->text("lesson/place"), "Step 3 of"));
}

}  // namespace moltact
