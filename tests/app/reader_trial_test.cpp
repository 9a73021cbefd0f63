// A fourth student without touch, the reader, uses only the words in the window, the kinds of sound, and the state text
// read aloud. In every task of the lessons that is done in the dark, in both languages, the words must not depend on
// what is touched. The reader then answers like the guesser, who passes by chance
// (tests/lesson/scripted_learner/fair_trials_test.cpp). The meter's figure and the direction of the push represent the
// force itself and are not words; fluctuating figures are not either.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/scene/contact_text.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/sound/touch_synth.h"
#include "tests/app/lesson_hand.h"
#include "tests/app/rank_window.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using Words = std::set<std::string>;

std::string withoutFigures(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ','; });
  return text;
}

// The directions in words are the arrow's.
std::string withoutPush(std::string text) {
  for (int k = -1; k < 9; ++k) {
    const double turn = std::numbers::pi / 4.0 * k;
    const Vec3 way = k < 0 ? Vec3(0, 0, 1) : k == 8 ? Vec3(0, 0, -1) : Vec3(std::cos(turn), std::sin(turn), 0.0);
    const std::string push = ", " + pushText(way);
    if (text.size() > push.size() && text.ends_with(push)) text.resize(text.size() - push.size());
  }
  return text;
}

// How loud one pitch is at the end of what was heard.
double loudness(const std::vector<float>& heard, std::size_t from, std::size_t count, double hertz) {
  double re = 0.0, im = 0.0;
  const std::size_t to = std::min(heard.size(), from + count);
  for (std::size_t k = from; k < to; ++k) {
    const double t = 2.0 * std::numbers::pi * hertz * double(k) / kSamples_per_s;
    re += double(heard[k]) * std::cos(t);
    im += double(heard[k]) * std::sin(t);
  }
  return to > from ? 2.0 * std::hypot(re, im) / double(to - from) : 0.0;
}

class Reader {
 public:
  Reader(ScriptedUser& d, bool whole) : d_(d), whole_(whole) {
    d_.app().settings.sound = true;
    d_.app().settings.sound_volume = 1.0;
  }

  // Reads the words on the screen in this frame while the probe touches.
  void look(Words& words) const {
    if (!d_.app().scene.log().touching() && !d_.app().extensions().reveal_policy.hidesTouch()) return;
    for (const auto& [name, record] : widgets().all()) {
      if (name == "view/force meter" || name == "view/push" || name == "view/force" || name == "view/depth" ||
          name == "plot/force" || name == "lesson/more" || name.ends_with("/trials") || record.text.empty())
        continue;
      // A way that is to be slid along says how far the hand has come: that is the act itself.
      if (!whole_ && !name.starts_with("view/state") && !name.starts_with("status/") &&
          !name.starts_with("view/legend") && !name.starts_with("view/label"))
        continue;
      words.insert(name + ": " + withoutFigures(withoutPush(record.text)));
    }
    words.insert("spoken: " + withoutFigures(withoutPush(d_.app().extensions().state_text.line(d_.app().scene))));
  }

  // Which kinds of sound there were in the touch that ends here, and in how many notes it sounds.
  void listen(Words& words, std::size_t from) const {
    const std::vector<float>& heard = d_.app().extensions().touch_sound.heard();
    constexpr std::size_t kPiece = kSamples_per_s / 50, kEnd = kSamples_per_s / 10;
    for (std::size_t k = from; k + kPiece < heard.size(); k += kPiece) {
      if (loudness(heard, k, kPiece, kThud_Hz) > 0.03) words.insert("heard: thud");
      if (loudness(heard, k, kPiece, kClick_Hz) > 0.03) words.insert("heard: click");
    }
    if (heard.size() < from + kEnd || !d_.app().scene.log().touching()) return;
    const double pitch = pitch_Hz(d_.app().scene.log().force_N());
    for (const auto& [name, note] : {std::pair("third", kChord[1]), std::pair("fifth", kChord[2])})
      if (loudness(heard, heard.size() - kEnd, kEnd, pitch * note) > 0.02) words.insert("heard: " + std::string(name));
  }
  std::size_t heardSoFar() const { return d_.app().extensions().touch_sound.heard().size(); }

 private:
  ScriptedUser& d_;
  bool whole_;
};

// What distinguishes two things: words that occur for one but not for the other at the same position of the row.
std::string telling(const std::vector<std::pair<std::string, Words>>& presented) {
  std::map<std::string, std::vector<const Words*>> slots;
  for (const auto& [slot, words] : presented) slots[slot].push_back(&words);
  std::ostringstream out;
  for (const auto& [slot, all] : slots)
    for (const Words* one : all)
      for (const Words* other : all)
        for (const std::string& word : *one)
          if (!other->contains(word)) out << slot << ": " << word << '\n';
  std::set<std::string> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.insert(line);
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

// The words of a task by what is touched; as many things as there were.
struct Read {
  std::string telling;
  std::size_t things = 0, presentations = 0;
};

LessonSession& session(ScriptedUser& d) { return *d.app().lesson.session(); }

void dwell(HandPlan& plan, double most_s) {
  for (HandAct& act : plan) act.wait_s = std::min(act.wait_s, most_s);
}

// Feels each thing of a row for the required time, continues with `next`, and answers correctly where required.
Read readRow(ScriptedUser& d, int rounds) {
  LessonHand hand(d, LessonHand::By::Mouse);
  const Reader reader(d, true);
  std::vector<std::pair<std::string, Words>> presented;
  std::vector<TaskStage> things;
  for (int round = 0; round < rounds; ++round) {
    if (round > 0) session(d).restartTask(0);
    d.frames(5);
    for (int place = 0; place < 40 && session(d).currentTask() == 0; ++place) {
      TaskStage stage = session(d).taskStage();
      stage.presentation = 0;
      if (std::find(things.begin(), things.end(), stage) == things.end()) things.push_back(stage);
      const std::string slot =
          withoutFigures(session(d).task(0).sentence) + (place == 3 && rounds > 1 ? " the last of an order" : "");
      Words words;
      std::optional<TaskAnswer> answer;
      // Until it has been felt for its time, as the task sees it.
      for (int tries = 0; tries < 8 && session(d).currentTask() == 0; ++tries) {
        HandPlan touch;
        for (const HandAct& act : session(d).taskAt(0)->demonstrate(hand.planInput(tries)))
          if (act.answer)
            answer = act.answer;
          else
            touch.push_back(act);
        const std::vector<TaskButton> offered = session(d).taskAt(0)->buttons();
        if (!offered.empty() && answer) break;
        hand.watch = [&] { reader.look(words); };
        const std::size_t from = reader.heardSoFar();
        hand.follow(touch, 0);
        reader.listen(words, from);
        hand.lift();
        d.frames(5);
      }
      // An order is felt to its end; then another round of it.
      if (!answer || answer->word.starts_with("place-")) break;
      presented.emplace_back(slot, std::move(words));
      session(d).answerTask(*answer);
      d.frames(5);
    }
  }
  return {telling(presented), things.size(), presented.size()};
}

// The place that is looked for, and one elsewhere.
Read readPlaces(ScriptedUser& d) {
  LessonHand hand(d, LessonHand::By::Mouse);
  const Reader reader(d, true);
  std::vector<std::pair<std::string, Words>> presented;
  for (int k = 0; k < 4; ++k) {
    HandPlan plan = k % 2 ? hand.wrongPlan(0) : session(d).taskAt(0)->demonstrate(hand.planInput(k));
    std::erase_if(plan, [](const HandAct& act) { return act.answer.has_value(); });
    dwell(plan, 0.5);
    if (plan.empty()) continue;
    Words words;
    hand.watch = [&] { reader.look(words); };
    const std::size_t from = reader.heardSoFar();
    hand.follow(plan, 0);
    reader.listen(words, from);
    hand.lift();
    d.frames(30);
    if (!words.empty()) presented.emplace_back("place", std::move(words));
  }
  return {telling(presented), 2, presented.size()};
}

// Over a molecule that is not drawn: by the kind of place that holds the probe.
Read readWay(ScriptedUser& d) {
  LessonHand hand(d, LessonHand::By::Mouse);
  const Reader reader(d, false);
  std::map<Feature, Words> by_kind;
  hand.watch = [&] {
    const Contact& contact = d.app().scene.log().latest().contact;
    // The line rests for a moment before it says something new.
    if (contact.touching() && d.app().scene.look.touchesUnseen(contact) &&
        d.app().extensions().state_text.tellsContact())
      reader.look(by_kind[contact.feature]);
  };
  hand.follow(session(d).taskAt(0)->demonstrate(hand.planInput(0)), 0);
  hand.lift();
  std::vector<std::pair<std::string, Words>> presented;
  for (auto& [kind, words] : by_kind) presented.emplace_back("way", std::move(words));
  return {telling(presented), by_kind.size(), presented.size()};
}

Lesson alone(const Lesson& lesson, std::size_t step, std::size_t task) {
  Lesson out = lesson;
  out.steps = {lesson.steps[step]};
  Step& s = out.steps[0];
  s.tasks = {lesson.steps[step].tasks[task]};
  s.questions.clear();
  s.aside = false;
  s.blocks = {Block(TaskHere{0})};
  return out;
}

struct Counts {
  std::size_t rows = 0, places = 0, ways = 0;
};

Counts readFiles(const std::vector<fs::path>& files, const std::string& language);

void readLessons(const std::string& ending, const std::string& language) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    const std::string name = entry.path().filename().string();
    const bool german = name.ends_with(".de.md");
    if (looksLikeLesson(entry.path()) && german == (ending == ".de.md")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 14);
  const Counts read = readFiles(files, language);
  CHECK(read.rows >= 12);
  CHECK(read.places >= 9);
  CHECK(read.ways >= 4);
  MESSAGE(read.rows << " rows, " << read.places << " places and " << read.ways << " ways, " << language);
}

Counts readFiles(const std::vector<fs::path>& files, const std::string& language) {
  Counts counts;
  for (const fs::path& file : files) {
    const LessonReading reading = readLesson(file);
    REQUIRE(reading.lesson);
    const Lesson& lesson = *reading.lesson;
    std::unique_ptr<ScriptedUser> d;
    for (std::size_t s = 0; s < lesson.steps.size(); ++s)
      for (std::size_t t = 0; t < lesson.steps[s].tasks.size(); ++t) {
        const std::string& kind = lesson.steps[s].tasks[t].kind;
        const bool row = kind == "same" || kind == "order", place = kind == "find",
                   way = !row && !place && lesson.steps[s].scene.hide.given() && kind == "trace" &&
                         lesson.steps[s].scene.locks("show");
        if (!row && !place && !way) continue;
        CAPTURE(file.filename().string());
        CAPTURE(lesson.steps[s].title);
        CAPTURE(kind);
        if (!d) {
          ScriptedUser::Options options;
          options.application.language = language;
          d = startWith(file.string(), std::move(options));
        }
        d->app().lesson.replace(alone(lesson, s, t));
        d->frames(3);
        d->app().finishLoading();
        d->frames(10);
        REQUIRE(session(*d).taskAt(0));
        const Read read = row ? readRow(*d, kind == "order" ? 3 : 1) : place ? readPlaces(*d) : readWay(*d);
        CHECK(read.telling == "");
        CHECK(read.things >= 2);
        CHECK(read.presentations >= 2);
        counts.rows += row;
        counts.places += place;
        counts.ways += way;
      }
  }
  return counts;
}

}  // namespace

TEST_CASE(
    "the reader learns nothing from words, speech and sound in any task of the English lessons that is done unseen") {
  readLessons(".md", "en");
}

TEST_CASE(
    "the reader learns nothing from words, speech and sound in any task of the German lessons that is done unseen") {
  readLessons(".de.md", "de");
}

TEST_CASE("the reader learns nothing in an order by energy and in pairs with and without forces between atoms") {
  const Counts read = readFiles({MOLTACT_SOURCE_DIR "/tests/lesson/in_the_forces.md"}, "en");
  CHECK(read.rows == 2);
}

TEST_CASE(
    "the reader learns nothing in the task rank: screen and sound are the same for all three ligands, neither shows "
    "nor "
    "hums their energy, and who only reads passes in at most 2 of 6 rounds; who knows the order passes") {
  RankWindow w;
  const Reader reader(*w.d, true);
  std::vector<std::pair<std::string, Words>> presented;
  int passed = 0;
  for (int round = 0; round < 6; ++round) {
    CAPTURE(round);
    if (round > 0) w.session().restartTask(0);
    w.d->frames(10);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      Words words;
      const std::size_t from = reader.heardSoFar();
      double hum = 0.0;
      w.feel([&] {
        reader.look(words);
        CHECK_FALSE(w.d->shows("view/energy"));
        CHECK_FALSE(w.d->shows("plot/energy"));
        REQUIRE(w.scene().log().latest().molecular_energy);
        const std::vector<float>& heard = w.d->app().extensions().touch_sound.heard();
        constexpr std::size_t kPiece = kSamples_per_s / 10;
        if (heard.size() < from + kPiece) return;
        const double energy = w.scene().log().latest().molecular_energy->total_kcal_mol();
        hum = std::max(hum, loudness(heard, heard.size() - kPiece, kPiece, hum_Hz(energy)));
      });
      CHECK(hum < 0.01);
      reader.listen(words, from);
      w.d->release();
      w.d->frames(5);
      // The words of the last ligand are those of an end.
      presented.emplace_back(k < 2 ? "ligand" : "last", std::move(words));
      w.session().answerTask({"next"});
      w.d->frames(10);
    }
    // Nothing has told them apart, so the order is that in which they came.
    for (const char* word : {"ligand-1", "ligand-2"}) w.session().answerTask({word});
    w.d->frames(5);
    passed += w.session().taskDone(0, 0);
  }
  CHECK(telling(presented) == "");
  CHECK(passed <= 2);
  w.session().restartTask(0);
  w.d->frames(10);
  const TouchableModel& stage = w.scene().stage();
  for (int k = 0; k < 3; ++k) {
    w.feel([] {});
    w.d->release();
    w.d->frames(5);
    w.session().answerTask({"next"});
    w.d->frames(10);
  }
  for (int guard = 0; guard < 3 && !w.session().taskDone(0, 0); ++guard) {
    for (const HandAct& act : w.session().taskAt(0)->demonstrate({.spheres = *stage.spheres, .body = stage.body.get()}))
      if (act.answer) w.session().answerTask(*act.answer);
    w.d->frames(5);
  }
  CHECK(w.session().taskDone(0, 0));
}

TEST_CASE(
    "with the molecule visible, the same reader distinguishes a crease from a face by its words and "
    "by a fifth in its sound") {
  auto d = startWith(MOLTACT_SOURCE_DIR "/lessons/first-touch.md");
  REQUIRE(session(*d).goTo("two-atoms-and-a-crease"));
  d->frames(5);
  d->app().finishLoading();
  d->frames(10);
  const Reader reader(*d, true);
  Words face, crease;
  // Lines through the pair along and across it meet both.
  for (int k = 0; k < 40 && (face.empty() || crease.empty()); ++k) {
    Words words;
    const double at = 0.2 + 0.6 * (k / 2) / 20.0;
    d->point("view", k % 2 ? at : 0.5, k % 2 ? 0.5 : at);
    d->frames(10);
    const std::size_t from = reader.heardSoFar();
    d->press();
    for (int frame = 0; frame < 60; ++frame) {
      d->frames(1);
      if (frame > 30) reader.look(words);
    }
    reader.listen(words, from);
    const Feature found = d->app().scene.log().latest().contact.feature;
    d->release();
    d->frames(30);
    if (found == Feature::Sphere) face = words;
    if (found == Feature::Circle) crease = words;
  }
  REQUIRE_FALSE(face.empty());
  REQUIRE_FALSE(crease.empty());
  CHECK(crease.contains("heard: fifth"));
  CHECK_FALSE(face.contains("heard: fifth"));
  CHECK(telling({{"touch", face}, {"touch", crease}}) != "");
}

}  // namespace moltact
