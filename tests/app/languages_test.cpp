// The window in German: selected while it runs, at the start, and by the environment; its numbers; back to English.
#include <imgui.h>

#include <cstdlib>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// The language of other tests, afterwards.
struct EnglishAgain {
  ~EnglishAgain() { setLanguage("en", {}); }
};

}  // namespace

TEST_CASE("German is chosen in the preferences and holds at once, with a decimal comma, and English again") {
  const EnglishAgain at_end;
  auto d = startWith("argon");
  CHECK(d->text("menu/file") == "File");
  CHECK(d->text("probe") == "1.4\u00a0Å");
  d->tap("Ctrl+,");
  d->frames(3);
  CHECK(d->text("preferences/language/As the system") == "on");
  CHECK(d->click("preferences/language/Deutsch"));
  d->frames(2);
  CHECK(d->app().settings.language == "de");
  CHECK(d->text("preferences/smaller") == "Kleiner");
  CHECK(d->text("preferences/language/Deutsch") == "on");
  d->tap("Escape");
  d->frames(3);
  CHECK(d->text("menu/file") == "Datei");
  CHECK(d->text("probe") == "1,4\u00a0Å");
  CHECK(d->text("status/contact") == "frei");
  CHECK(keysText("Ctrl+Shift+S") == "Strg+Umschalt+S");
  // A decimal sign in the settings takes precedence over the language's.
  d->app().settings.decimal_sign = DecimalSign::Point;
  d->frames(2);
  CHECK(d->text("probe") == "1.4\u00a0Å");
  d->app().settings.decimal_sign = DecimalSign::OfLanguage;
  d->app().settings.language = "en";
  d->frames(2);
  CHECK(d->text("menu/file") == "File");
}

TEST_CASE("a touch is reported in German as in English, atom for atom") {
  const EnglishAgain at_end;
  ScriptedUser::Options options;
  options.application.language = "de";
  auto d = startWith("argon", options);
  CHECK(d->text("menu/file") == "Datei");
  d->point("view");
  d->press();
  d->frames(120);
  REQUIRE(d->app().scene.log().touching());
  CHECK(d->text("view/state").starts_with("berührt: "));
  CHECK(contains(d->text("view/state"), "\u00a0N"));
  CHECK(contains(d->text("view/state"), ","));
  d->release();
}

TEST_CASE("what is asked for at the start stands before the settings until another language is chosen") {
  const EnglishAgain at_end;
  Scratch scratch;
  ScriptedUser::Options options;
  options.application.settings_file = scratch.file("settings.json", R"({"language": "de"})");
  ::unsetenv("MOLTACT_LANGUAGE");
  { CHECK(startWith("argon", options)->text("menu/file") == "Datei"); }
  ::setenv("MOLTACT_LANGUAGE", "en", 1);
  { CHECK(startWith("argon", options)->text("menu/file") == "File"); }
  options.application.language = "de";
  auto d = startWith("argon", options);
  CHECK(d->text("menu/file") == "Datei");
  d->app().settings.language = "en";
  d->frames(2);
  CHECK(d->text("menu/file") == "File");
}

TEST_CASE("the shelf has one card for a lesson in two languages, in the language in use, also when that changes") {
  const EnglishAgain at_end;
  Scratch scratch;
  const auto text = [](const char* title) {
    return std::string("---\ntitle: ") + title +
           "\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: "
           "argon\n```\nText.\n";
  };
  scratch.file("mine.md", text("Mine"));
  scratch.file("mine.de.md", text("Meine"));
  auto d = startWith("argon");
  d->app().settings.lesson_folder = scratch.folder.string();
  d->app().panels.pages.welcome = true;
  d->frames(60);
  CHECK(d->text("welcome/own/mine").starts_with("Mine\n"));
  CHECK(d->text("welcome/own/mine.de").empty());
  d->app().settings.language = "de";
  d->frames(60);
  CHECK(d->text("welcome/own/mine").starts_with("Meine\n1\u00a0min"));
}

TEST_CASE("signs of another script are loaded when they are first to be shown, and no others") {
  auto d = startWith("argon");
  const auto has = [](ImWchar c) {
    const ImFont* font = look().font(Font::Body);
    return font->FindGlyphNoFallback(c) != nullptr;
  };
  CHECK(has(u'ß'));
  CHECK(has(u'α'));
  CHECK_FALSE(has(u'Ж'));
  d->app().messages.notice("Ж, 中");
  d->frames(4);
  CHECK(has(u'Ж'));
  CHECK(has(u'а'));
  CHECK_FALSE(has(u'中'));
  CHECK_FALSE(has(u'ש'));
}

TEST_CASE("a language that has no texts is reported once, and the window stays English") {
  const EnglishAgain at_end;
  auto d = startWith("argon");
  d->app().settings.language = "xx";
  d->frames(5);
  REQUIRE(d->app().messages.all().size() == 1);
  CHECK(contains(d->app().messages.all().front().text, "there are no texts in the language 'xx'"));
  CHECK(d->text("menu/file") == "File");
}

}  // namespace moltact
