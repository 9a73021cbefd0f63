// Words, tables and pictures of a lesson in its panel, by mouse, by keys and in the lines for screen readers.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_focus.h"
#include "engine/render/picture.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

const std::string kLessonTextHead =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: "
    "argon\n```\n";

struct OpenedText {
  ScratchFolder scratch;
  std::unique_ptr<ScriptedUser> user;

  explicit OpenedText(const std::string& text, const std::string& words = {}, double scale = 1.0) {
    if (!words.empty()) writeFile(file("glossary.md"), words);
    Picture red{64, 32, std::vector<std::uint8_t>(std::size_t(3) * 64 * 32)};
    for (std::size_t k = 0; k < red.rgb.size(); k += 3) red.rgb[k] = 255;
    writePng(file("red.png"), red);
    writeFile(file("l.md"), kLessonTextHead + text);
    ScriptedUser::Options options;
    options.content_scale = scale;
    user = startWith({}, std::move(options));
    user->app().open(file("l.md"));
    user->app().finishLoading();
    user->frames(10);
  }
  std::string file(const std::string& name) const { return (scratch.path / name).string(); }
};

const std::string kWords =
    "- **pit**, pits: Three atoms at once; see [a crease](#word:crease).\n- **crease**: Two atoms.\n";

// How many pixels of a recorded rectangle are red.
std::size_t redIn(ScriptedUser& user, const char* name) {
  const Picture picture = user.picture();
  const WidgetRecord* at = widgets().find(name);
  REQUIRE(at);
  std::size_t out = 0;
  for (int y = int(at->low.y); y < int(at->high.y); ++y)
    for (int x = int(at->low.x); x < int(at->high.x); ++x) {
      const std::uint8_t* p = picture.at(x, y);
      out += p[0] > 240 && p[1] < 16 && p[2] < 16;
    }
  return out;
}

}  // namespace

TEST_CASE("a click on a word opens its meaning below its paragraph, a second one or the cross closes it") {
  OpenedText opened("Feel the pits.\n\nMore.\n", kWords);
  ScriptedUser& user = *opened.user;
  REQUIRE(user.shows("lesson/0/pits"));
  CHECK(user.text("lesson/0/pits") == "pits");
  CHECK(!user.shows("lesson/0/meaning"));
  user.click("lesson/0/pits");
  CHECK(user.text("lesson/0/word") == "pit");
  CHECK(user.text("lesson/0/meaning") == "Three atoms at once; see a crease.");
  CHECK(widgets().find("lesson/0/meaning")->low.y < widgets().find("lesson/1")->low.y);
  user.click("lesson/0/meaning/a crease");
  CHECK(user.text("lesson/0/word") == "crease");
  user.click("lesson/0/close word");
  user.frames(2);
  CHECK(!user.shows("lesson/0/meaning"));
  user.click("lesson/0/pits");
  user.click("lesson/0/pits");
  user.frames(2);
  CHECK(!user.shows("lesson/0/meaning"));
  CHECK(user.missing().empty());
}

TEST_CASE("Tab and Enter open a word's meaning, and the lines for screen readers contain it") {
  OpenedText opened("Feel the pits.\n", kWords);
  ScriptedUser& user = *opened.user;
  const std::string lines = opened.file("state.txt");
  REQUIRE(!user.app().extensions().state_text.writeTo(lines));
  for (int k = 0; k < 60 && !user.shows("lesson/0/meaning"); ++k) {
    user.tap("Tab");
    user.frames(1);
    if (controlOfKeys() == "lesson/0/pits") user.tap("Enter");
  }
  REQUIRE(user.shows("lesson/0/meaning"));
  user.frames(4);
  std::ifstream in(lines);
  std::stringstream reported;
  reported << in.rdbuf();
  CHECK(contains(reported.str(), "pit: Three atoms at once; see a crease."));
}

TEST_CASE("the meaning closes with the step, and a lesson that is read again has the words of its file") {
  OpenedText opened("Feel the pits.\n\n## Two\n\nText.\n", kWords);
  ScriptedUser& user = *opened.user;
  user.click("lesson/0/pits");
  user.click("lesson/next");
  user.frames(4);
  user.click("lesson/back");
  user.frames(4);
  CHECK(!user.shows("lesson/0/meaning"));
  writeFile(opened.file("l.md"), kLessonTextHead + "Feel the pits and one crease.\n\n## Two\n\nText.\n");
  user.frames(120);
  CHECK(user.shows("lesson/0/crease"));
}

TEST_CASE(
    "a picture is shown in its own size, as wide as the panel at most, and large by a click; its words are read out") {
  for (const double scale : {1.0, 2.0}) {
    OpenedText opened("Text.\n\n![A red field](red.png \"Figure 1\")\n", {}, scale);
    ScriptedUser& user = *opened.user;
    user.frames(4);
    CHECK(user.text("lesson/1") == "Picture: A red field");
    CHECK(user.text("lesson/1/caption") == "Figure 1");
    const WidgetRecord* at = widgets().find("lesson/1");
    REQUIRE(at);
    CHECK(at->high.x - at->low.x == doctest::Approx(64 * scale).epsilon(0.02));
    CHECK(at->high.y - at->low.y == doctest::Approx(32 * scale).epsilon(0.04));
    const std::size_t small = redIn(user, "lesson/1");
    CHECK(double(small) > 0.9 * 64 * 32 * scale * scale);
    user.click("lesson/1");
    user.frames(4);
    REQUIRE(user.shows("picture/shown"));
    CHECK(redIn(user, "picture/shown") > 10 * small);
    user.tap("Escape");
    user.frames(4);
    CHECK(!user.shows("picture/shown"));
  }
}

TEST_CASE("in the place of a picture that cannot be shown stand its words and why") {
  OpenedText opened("Text.\n\n![A ring](ring.png)\n");
  opened.user->frames(4);
  CHECK(opened.user->text("lesson/1") == "A ring");
  CHECK(opened.user->text("lesson/1/fault") == "'ring.png' cannot be shown: there is no such file");
}

TEST_CASE("a table's cells stand in rows and columns within the panel, at 100 % and at 200 %") {
  for (const double scale : {1.0, 2.0}) {
    OpenedText opened(
        "| atom | how large it is | r |\n|---|---|---:|\n| H | it is the smallest one of them all, and so on | 1.2 Å "
        "|\n| C | "
        "Donaudampfschifffahrtsgesellschaftskapitän | 1.7 Å |\n",
        {}, scale);
    const auto at = [&](int row, int column) {
      const WidgetRecord* r = widgets().find("lesson/0/" + std::to_string(row) + "/" + std::to_string(column));
      REQUIRE(r);
      return *r;
    };
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        INFO(row << " " << column << " at " << scale);
        CHECK(at(row, column).high.x <= at(row, column).clip_high.x + 1);
        if (column > 0) CHECK(at(row, column).low.x >= at(row, column - 1).high.x - 1);
        if (row > 0) CHECK(at(row, column).low.y >= at(row - 1, column).high.y - 8 * scale);
        if (column > 0) CHECK(at(row, column).low.y == at(row, 0).low.y);
      }
  }
}

}  // namespace moltact
