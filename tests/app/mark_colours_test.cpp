// The colours of the marks in every scene of every lesson, for each kind of colour vision.
#include <algorithm>
#include <filesystem>
#include <set>

#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/reader.h"
#include "engine/molecule/elements.h"
#include "engine/render/colour_legend.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/structure/seen_colours.h"

namespace moltact {
namespace {

// CIEDE2000. Two colours side by side are one to most eyes below 2; at 10 they are two even across a picture.
constexpr double kBetweenMarks = 10.0, kToElements = 5.0;

struct ShownScene {
  std::string where;
  SceneSpec scene;
  std::shared_ptr<const Molecule> molecule;
};

// Every scene of every shipped lesson that marks or highlights something.
std::vector<ShownScene> shippedScenes() {
  std::vector<ShownScene> out;
  LessonMolecules molecules;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(MOLTACT_SOURCE_DIR) + "/lessons")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".md") || name.ends_with(".de.md") || name == "README.md" || name == "glossary.md") continue;
    const LessonReading read = readLesson(entry.path());
    REQUIRE(read.lesson);
    for (const Step& step : read.lesson->steps) {
      if (!step.states_scene || (step.scene.marks.empty() && !step.scene.highlight.given())) continue;
      const auto molecule = molecules.find(entry.path(), step.scene.molecule);
      REQUIRE(molecule);
      out.push_back({name + ", " + step.title, step.scene, *molecule});
    }
  }
  return out;
}

const std::vector<ShownScene>& scenes() {
  static const std::vector<ShownScene> all = shippedScenes();
  return all;
}

Rgb8 eightBits(const Colour& c) {
  Rgb8 out;
  for (int k = 0; k < 3; ++k) out[std::size_t(k)] = std::uint8_t(std::lround(255.0f * c[k]));
  return out;
}

}  // namespace

TEST_CASE(
    "in every scene of every lesson, for every kind of colour vision, marks differ from one another "
    "and from targets by 10 of CIEDE2000, and from neighbouring elements by 5") {
  std::size_t pairs = 0;
  double least = 1e9;
  for (const ShownScene& shown : scenes()) {
    const auto marks = marksOf(shown.scene, *shown.molecule);
    if (!marks) continue;
    CAPTURE(shown.where);
    std::vector<std::pair<std::string, Rgb8>> reported;
    for (const OwnColour& m : *marks) reported.emplace_back(m.name, m.colour);
    const std::size_t count = reported.size();
    reported.emplace_back("target, light", eightBits(lightTheme().target));
    reported.emplace_back("target, dark", eightBits(darkTheme().target));
    const auto check = [&](const std::string& one, const Rgb8& a, const std::string& other, const Rgb8& b,
                           double most) {
      CAPTURE(one);
      CAPTURE(other);
      for (const test::Sight sight : test::kSights) {
        CAPTURE(test::nameOf(sight));
        const double far = test::seenDistance(sight, a, b);
        CHECK(far > most);
        if (most == kBetweenMarks) least = std::min(least, far);
      }
      ++pairs;
    };
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t k = j + 1; k < reported.size(); ++k)
        check(reported[j].first, reported[j].second, reported[k].first, reported[k].second, kBetweenMarks);
    if (shown.scene.colour != "element") continue;
    std::set<std::uint8_t> beside;
    std::vector<bool> marked(shown.molecule->atoms.size());
    for (const OwnColour& m : *marks)
      for (const std::uint32_t a : m.atoms) marked[a] = true;
    for (std::size_t a = 0; a < marked.size(); ++a)
      if (!marked[a]) beside.insert(shown.molecule->atoms[a].atomic_number);
    const ElementColours drawn = shownColours(ElementColours::Customary, shown.molecule->atoms.size());
    for (std::size_t j = 0; j < count; ++j)
      for (const std::uint8_t e : beside)
        check(reported[j].first, reported[j].second, std::string(element(e).name), eightBits(elementColour(e, drawn)),
              kToElements);
  }
  MESSAGE("least distance between marks and targets: " << least << ", pairs: " << pairs);
  CHECK(pairs > 100);
}

TEST_CASE("the legend of no scene of a lesson shows a colour twice, and the virus's names no chain of its 420") {
  for (const ShownScene& shown : scenes()) {
    CAPTURE(shown.where);
    const AtomsLook look = looksOf(shown.scene, *shown.molecule);
    const auto legend = legendOf(*shown.molecule, colourBy(shown.scene), ElementColours::Customary, look);
    std::set<Rgb8> colours;
    for (const LegendEntry& e : legend) {
      CAPTURE(e.name);
      CHECK(colours.insert(eightBits(e.colour)).second);
      if (shown.where.starts_with("a-virus")) CHECK_FALSE(contains(e.name, "chain "));
    }
  }
}

TEST_CASE("every atom that a lesson highlights in a ribbon is drawn as a sphere of its own size") {
  std::size_t seen = 0;
  for (const ShownScene& shown : scenes()) {
    if (!shown.scene.highlight.given()) continue;
    CAPTURE(shown.where);
    const AtomsLook look = looksOf(shown.scene, *shown.molecule);
    std::set<std::uint32_t> hidden, not_ribbon;
    if (look.hidden) hidden.insert(look.hidden->begin(), look.hidden->end());
    bool ribbons = false;
    for (const StyledAtoms& s : look.styles) {
      if (s.style == DrawStyle::Cartoon) {
        ribbons = true;
        continue;
      }
      if (!s.atoms) not_ribbon.clear(), ribbons = false;
      if (!s.atoms) break;
      not_ribbon.insert(s.atoms->begin(), s.atoms->end());
    }
    if (!ribbons) continue;
    for (const std::uint32_t a : shown.scene.highlight.select(*shown.molecule)) {
      if (hidden.contains(a)) continue;
      CHECK(not_ribbon.contains(a));
      ++seen;
    }
  }
  CHECK(seen > 10);
}

}  // namespace moltact
