// The first hour apart from the molecule: messages that disappear by themselves, familiar words, tool tips that cover
// nothing, menus in the order of use.
#include <array>
#include <cstdlib>
#include <set>

#include "app/ui/files/library.h"
#include "app/ui/files/user_folders.h"
#include "app/ui/scene/contact_text.h"
#include "engine/molecule/residue_names.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// Of everything on the screen, what says one of these words; one a line.
std::string saying(const std::vector<std::string>& words) {
  std::string out;
  for (const auto& [name, record] : widgets().all())
    for (const std::string& word : words)
      if (contains(record.text, word)) out += name + ": " + record.text + "\n";
  return out;
}

// How long a message is shown, in steps of a tenth of a second; 1000 s for one that stays.
double shownFor_s(Messages messages) {
  double s = 0.0;
  for (; s < 1000.0 && !messages.all().empty(); s += 0.1) messages.age(0.1);
  return s;
}

bool overlap(const WidgetRecord& a, const WidgetRecord& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

}  // namespace

TEST_CASE(
    "a notice goes after 6 s, a warning after 14 s, and long ones after as long as 14 letters a second take; an error "
    "and what asks for something stay") {
  const std::string shorter = "Saved.", longer(420, 'x');
  const auto shown = [](auto say) {
    Messages messages;
    say(messages);
    return shownFor_s(std::move(messages));
  };
  CHECK(shown([&](Messages& m) { m.notice(shorter); }) == doctest::Approx(6.0).epsilon(0.03));
  CHECK(shown([&](Messages& m) { m.warning(shorter); }) == doctest::Approx(14.0).epsilon(0.02));
  CHECK(shown([&](Messages& m) { m.notice(longer); }) == doctest::Approx(30.0).epsilon(0.01));
  CHECK(shown([&](Messages& m) { m.error(shorter); }) >= 999.0);
  CHECK(shown([&](Messages& m) { m.ask(MessageKind::Notice, shorter, {"device"}); }) >= 999.0);
}

TEST_CASE("residues are called by plain names: benzene and thymine, not BNZ and DT; a code without a name stays") {
  CHECK(plainResidueName("BNZ") == "benzene");
  CHECK(plainResidueName("DT") == "thymine");
  CHECK(plainResidueName("HEM") == "haem");
  CHECK(plainResidueName("ALA").empty());
  CHECK(plainResidueName("XYZ").empty());
  CHECK(plainResidueName("").empty());
  for (const auto& [molecule, code] : {std::pair{"benzene", "BNZ"}, {"b-dna", "DT"}, {"stearic-oleic", "FAT"}}) {
    CAPTURE(molecule);
    auto d = startWith(molecule);
    const Molecule& m = *d->app().scene.stage().molecule;
    for (std::size_t k = 0; k < m.atoms.size(); ++k) {
      Contact on;
      on.feature = Feature::Sphere;
      on.atoms = {std::int32_t(k), -1, -1};
      const std::string text = touchedText(m, on);
      CAPTURE(text);
      REQUIRE_FALSE(text.empty());
      CHECK_FALSE(contains(text, std::string(code) + " "));
    }
  }
}

TEST_CASE("a student sees no terms of the servo loop, its points and its ticks; the expert switch shows them") {
  const std::vector<std::string> expert_words{"HIP", "SCP", "modelled", "Hz", "1000 ", "Time for a tick", "Cones"};
  auto d = startWith("1ubq");
  d->app().panels.touch_details = true;
  d->point("view");
  d->press();
  d->frames(60);
  CHECK(saying(expert_words) == "");
  CHECK_FALSE(d->shows("show/cones"));
  CHECK_FALSE(d->shows("plot/tick"));
  d->app().settings.expert = true;
  d->frames(5);
  CHECK(d->shows("status/loop"));
  CHECK(d->shows("show/cones"));
}

TEST_CASE(
    "the lessons' menu begins with the newcomer's lesson and continues in the order that the lessons state, each "
    "number "
    "once") {
  const std::vector<LibraryItem>& all = lessons();
  REQUIRE(all.size() > 10);
  CHECK(all.front().id == kFirstLesson);
  for (std::size_t k = 1; k < all.size(); ++k) {
    CAPTURE(all[k].id);
    CHECK(all[k - 1].order + 1 == all[k].order);
  }
  std::set<std::string> levels;
  for (const LibraryItem& l : all) levels.insert(l.level);
  CHECK(levels.size() > 1);
  auto d = startWith("1ubq");
  d->click("menu/lesson");
  d->frames(3);
  d->click("menu/lesson/lessons");
  d->frames(3);
  float y = 0.0f;
  for (const LibraryItem& l : all) {
    const WidgetRecord* item = widgets().find("menu/lesson/lessons/" + l.id);
    REQUIRE(item);
    CHECK(item->low.y > y);
    y = item->low.y;
  }
}

TEST_CASE("a tip stands beside its panel or below its bar, and covers none of the controls there") {
  auto d = startWith("1ubq");
  d->app().panels.touch_details = true;
  d->frames(5);
  int tips = 0;
  std::vector<std::string> names;
  for (const auto& [name, record] : widgets().all())
    if (record.visible() && (name.starts_with("show/") || name.starts_with("tool/") || name == "probe" ||
                             name == "stiffness" || name == "force"))
      names.push_back(name);
  REQUIRE(names.size() > 8);
  for (const std::string& name : names) {
    CAPTURE(name);
    d->point(name);
    d->frames(3);
    const WidgetRecord* tip = widgets().find("tip");
    if (!tip) continue;
    ++tips;
    const Rectangle& touch = d->app().layout().touch;
    for (const auto& [other, record] : widgets().all()) {
      const bool in_panel = record.low.x >= touch.low.x && record.high.x <= touch.high.x && record.low.y >= touch.low.y;
      const bool neighbour =
          name.starts_with("tool/") ? other.starts_with("tool/") || other.starts_with("menu/") : in_panel;
      if (other == "tip" || !record.visible() || !neighbour) continue;
      CAPTURE(other);
      CHECK_FALSE(overlap(*tip, record));
    }
    const glm::vec2 all(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
    CHECK(tip->low.x >= 0.0f);
    CHECK(tip->high.x <= all.x);
    CHECK(tip->high.y <= all.y);
  }
  CHECK(tips > 8);
}

TEST_CASE(
    "pictures go where the desktop keeps them, then to Pictures, then home, and never where the program was begun") {
  const Scratch scratch;
  namespace fs = std::filesystem;
  const auto with = [&](const char* lines) {
    fs::create_directories(scratch.folder / ".config");
    std::ofstream(scratch.folder / ".config" / "user-dirs.dirs") << lines;
    return pictureFolder();
  };
  const char* home = std::getenv("HOME");
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const std::string home_was = home ? home : "", config_was = config ? config : "";
  setenv("HOME", scratch.folder.c_str(), 1);
  unsetenv("XDG_CONFIG_HOME");
  CHECK(pictureFolder() == scratch.folder);
  fs::create_directories(scratch.folder / "Pictures");
  CHECK(pictureFolder() == scratch.folder / "Pictures");
  CHECK(with("XDG_PICTURES_DIR=\"$HOME/Bilder\"\n") == scratch.folder / "Pictures");  // is not there
  fs::create_directories(scratch.folder / "Bilder");
  CHECK(with("# of the desktop\nXDG_MUSIC_DIR=\"$HOME/Musik\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n") ==
        scratch.folder / "Bilder");
  CHECK(with(("XDG_PICTURES_DIR=\"" + (scratch.folder / "Bilder").string() + "\"").c_str()) ==
        scratch.folder / "Bilder");
  for (const char* odd :
       {"XDG_PICTURES_DIR=\"\n", "XDG_PICTURES_DIR=\"\"", "XDG_PICTURES_DIR=\"Bilder\"", "\n\n", ""}) {
    CAPTURE(odd);
    CHECK(with(odd) == scratch.folder / "Pictures");
  }
  home_was.empty() ? unsetenv("HOME") : setenv("HOME", home_was.c_str(), 1);
  if (!config_was.empty()) setenv("XDG_CONFIG_HOME", config_was.c_str(), 1);
}

}  // namespace moltact
