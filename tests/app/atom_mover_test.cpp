// A mover of four frames, which only this file knows: recorded, played back and felt. Oracle: its frames in closed form.
#include "app/ui/extensions/atom_mover.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "engine/haptics/methods.h"
#include "tests/app/small_window.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// Frame k lifts the atom number i by k^2 times the height, the odd atoms by twice as much.
class AtomMoverFrames final : public AtomMover {
 public:
  using AtomMover::AtomMover;
  static constexpr double kLast = 3.0, kHeight_A = 0.5, kPerFrame_s = 0.5;
  double wanted = 0.0;

  double lift_A(std::size_t atom) const { return lift_A(atom, at_); }
  static double lift_A(std::size_t atom, double at) {
    const auto frame = [&](double k) { return kHeight_A * k * k * (atom % 2 ? 2.0 : 1.0); };
    const double k = std::floor(at);
    return frame(k) + (at - k) * (frame(k + 1.0) - frame(k));
  }

  std::string_view kind() const override { return "test-frames"; }
  std::optional<AtomsMoved> position() const override {
    if (!scene_.stage()) return std::nullopt;
    return AtomsMoved{{}, {}, "lifted", at_};
  }
  bool moving() const override { return at_ != wanted; }
  bool live() const override { return moving(); }
  void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey&) override {
    if (at_ == position.position || !scene_.placeAtoms(source, at(position.position))) return;
    at_ = wanted = position.position;
    shown_detail = position.detail;
  }
  void beforeTicks() override {
    constexpr int kTicks = 33;
    if (!moving()) return;
    const double step = kTicks * kTick_s / kPerFrame_s, next = at_ + std::clamp(wanted - at_, -step, step);
    if (own_.claim() && scene_.moveAtoms(own_, at(next), kTicks)) at_ = next;
  }
  std::string shown_detail;

 private:
  std::vector<Sphere> at(double frame) const {
    const SharedArray<Sphere>& resting = scene_.atoms().resting().spheres->spheres();
    std::vector<Sphere> out(resting.begin(), resting.end());
    for (std::size_t i = 0; i < out.size(); ++i) out[i].centre_A.z += lift_A(i, frame);
    return out;
  }
  double at_ = 0.0;
};

// Notes the events that it receives.
class Listener final : public AtomMover {
 public:
  using AtomMover::AtomMover;
  std::string heard;
  bool answers = false;

  std::string_view kind() const override { return "test-listener"; }
  std::optional<AtomsMoved> position() const override { return std::nullopt; }
  bool moving() const override { return false; }
  void show(const MotionSource&, const AtomsMoved&, const MoleculeKey&) override {}

  void atStart() override { heard += "atStart "; }
  void beforeTicks() override { heard += "beforeTicks "; }
  void ticks(const FeltTicks&) override { heard += "ticks "; }
  void lessonEvents(std::span<const SessionEvent>) override { heard += "lessonEvents "; }
  void afterPanels() override { heard += "afterPanels "; }
  void beforeOpening(FileKind) override { heard += "beforeOpening "; }
  bool open(FileKind, const fs::path&) override {
    heard += "open ";
    return answers;
  }
  void lessonRefused(const fs::path&) override { heard += "lessonRefused "; }
  void sceneChanged() override { heard += "sceneChanged "; }
  void lessonChanged() override { heard += "lessonChanged "; }
  void stepChanged() override { heard += "stepChanged "; }
  void viewReset(const Camera&) override { heard += "viewReset "; }
  void atEnd() override { heard += "atEnd "; }
  bool live() const override { return answers; }
  bool leadsHand() const override { return answers; }
  bool hidesLesson() const override { return answers; }
};

// Counts how often it began and ended.
class Counter final : public AtomMover {
 public:
  using AtomMover::AtomMover;
  std::string why;
  int begun = 0, ended = 0;

  std::string_view kind() const override { return "test-counter"; }
  std::optional<AtomsMoved> position() const override { return std::nullopt; }
  bool moving() const override { return false; }
  void show(const MotionSource&, const AtomsMoved&, const MoleculeKey&) override {}
  std::string unavailable() const override { return why; }
  void end() override { ++ended; }

 private:
  void onStart() override { ++begun; }
};

std::string chain() {
  std::string out;
  for (int k = 0; k < 6; ++k) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM  %5d  CA  GLY A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C  \n", k + 1,
                  k + 1, 3.0 * k, k % 2 ? 1.5 : 0.0, k == 2 ? 2.0 : 0.0);
    out += line;
  }
  return out + "END\n";
}

double z(ScriptedUser& user, std::size_t atom) { return user.app().scene.atoms().seen()->spheres[atom].centre_A.z; }

TEST_CASE("a mover receives each of the 13 events of an extension once, and its 3 answers are those of all movers") {
  const auto user = startWith("1ubq", smallWindow({}));
  AtomMovers movers({user->app().scene, user->app().lesson, user->app().messages, user->app().options()});
  Listener& listener = movers.add<Listener>();
  Extension& all = movers;
  const std::string events[] = {"atStart ",       "beforeTicks ", "ticks ",         "lessonEvents ", "afterPanels ",
                                "beforeOpening ", "open ",        "lessonRefused ", "sceneChanged ", "lessonChanged ",
                                "stepChanged ",   "viewReset ",   "atEnd "};
  std::string wanted;
  for (const std::string& event : events) wanted += event;
  all.atStart();
  all.beforeTicks();
  all.ticks({{}, methods().front()});
  all.lessonEvents({});
  all.afterPanels();
  all.beforeOpening(FileKind{});
  CHECK_FALSE(all.open(FileKind{}, "nothing.txt"));
  all.lessonRefused("nothing.md");
  all.sceneChanged();
  all.lessonChanged();
  all.stepChanged();
  all.viewReset(Camera{});
  all.atEnd();
  CHECK(listener.heard == wanted);
  for (const bool answer : {false, true}) {
    listener.answers = answer;
    CHECK(all.live() == answer);
    CHECK(all.leadsHand() == answer);
    CHECK(all.hidesLesson() == answer);
  }
}

TEST_CASE("a mover that starts ends each other mover once before it begins; while it is unavailable it does neither") {
  const auto user = startWith("1ubq", smallWindow({}));
  AtomMovers movers({user->app().scene, user->app().lesson, user->app().messages, user->app().options()});
  Counter &first = movers.add<Counter>(), &second = movers.add<Counter>();
  CHECK(first.start());
  CHECK(first.begun == 1);
  CHECK(first.ended == 0);
  CHECK(second.ended == 1);
  second.why = "Not here.";
  CHECK_FALSE(second.start());
  CHECK(second.begun == 0);
  CHECK(first.ended == 0);
  second.why.clear();
  CHECK(second.start());
  CHECK(first.ended == 1);
}

TEST_CASE(
    "a mover of four frames that is added by one line: its way is recorded in frames, the task of touching an atom is "
    "judged where frame 3 has lifted it by 9 A, and a playback puts the atoms to any recorded frame; a program without "
    "this mover leaves them") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "chain.pdb", chain());
  writeFile(
      scratch.path / "mine.md",
      "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: chain.pdb\nauthor: A\nlicence: L\n---\n## One\n"
      "```scene\nmolecule: chain.pdb\n```\n```touch\nreach: residue 4\nsay: Touch it.\n```\n\n> [!TIP]\n> Look.\n");
  fs::path file;
  std::vector<double> first(6);
  {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    Application& app = user->app();
    AtomMoverFrames& frames = app.extensions().movers.add<AtomMoverFrames>();
    user->frames(10);
    CHECK(app.extensions().movers.present() == &frames);
    CHECK_FALSE(app.extensions().movers.get<MovingStates>().position());
    for (std::size_t i = 0; i < 6; ++i) first[i] = z(*user, i);
    app.lesson.session()->openHints(1);
    user->frames(5);
    REQUIRE_FALSE(app.lesson.session()->taskDone(0, 0));
    frames.wanted = AtomMoverFrames::kLast;
    user->frames(240);
    for (std::size_t i = 0; i < 6; ++i) CHECK(z(*user, i) == doctest::Approx(first[i] + (i % 2 ? 9.0 : 4.5)));
    // The hand meets the atoms where they are now.
    const PointA lifted{app.scene.atoms().seen()->spheres[3].centre_A};
    app.scene.view().beginAgainAt(lifted);
    user->frames(30);
    user->point("view", 0.5, 0.5);
    user->press();
    user->frames(120);
    CHECK(app.scene.log().touching());
    CHECK(app.scene.log().latest().contact.atoms[0] == 3);
    CHECK(glm::distance(app.scene.log().latest().contact.scp.A, lifted.A) < 4.0);
    user->release();
    user->frames(30);
    CHECK(app.lesson.session()->taskDone(0, 0));
    REQUIRE(app.extensions().recorder.flush());
    file = app.extensions().recorder.file();
  }
  const Expected<Attempt> attempt = readAttempt(file);
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  double at = -1.0, middle_s = 0.0, middle = 0.0;
  std::size_t lines = 0;
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what)) {
      CHECK(moved->by == "test-frames");
      CHECK(moved->detail == "lifted");
      if (moved->position > at) ++lines;
      at = moved->position;
      if (at > 1.0 && at < 2.5) middle_s = e.t_s, middle = at;
    }
  CHECK(at == AtomMoverFrames::kLast);
  CHECK(lines > 4);
  REQUIRE(middle_s > 0.0);

  {
    const auto user = startWith("1ubq", smallWindow({}));
    AtomMoverFrames& frames = user->app().extensions().movers.add<AtomMoverFrames>();
    user->app().open(file);
    user->app().finishLoading();
    user->frames(5);
    Playback& playback = user->app().extensions().playback;
    playback.setRunning(false);
    const auto isAt = [&](double t_s, double position) {
      playback.seek(t_s);
      user->app().finishLoading();
      user->frames(5);
      for (std::size_t i = 0; i < 6; ++i)
        CHECK(z(*user, i) == doctest::Approx(first[i] + AtomMoverFrames::lift_A(i, position)).epsilon(1e-4));
    };
    isAt(playback.timeline().length_s(), AtomMoverFrames::kLast);
    isAt(middle_s + 1e-3, middle);
    isAt(0.1, 0.0);
    isAt(playback.timeline().length_s(), AtomMoverFrames::kLast);
    CHECK(frames.shown_detail == "lifted");
    // The playback owns the atoms.
    frames.wanted = 0.0;
    user->frames(60);
    CHECK(z(*user, 5) == doctest::Approx(first[5] + 9.0));
  }
  const auto other = startWith("1ubq", smallWindow({}));
  other->app().open(file);
  other->app().finishLoading();
  other->frames(5);
  other->app().extensions().playback.seek(attempt->end_s());
  other->frames(5);
  CHECK(z(*other, 5) == doctest::Approx(first[5]));
  const auto& messages = other->app().messages.all();
  CHECK(std::count_if(messages.begin(), messages.end(), [](const Message& m) {
          return contains(m.text, "cannot move the atoms of this attempt (“test-frames”)");
        }) == 1);
}

}  // namespace
}  // namespace moltact
