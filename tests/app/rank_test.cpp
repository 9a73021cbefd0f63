// The task rank in the window: the mouse and a device hold each ligand in its place, in the dark, and no word tells one
// ligand from another. Ticks run on the frames' clock.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "app/ui/extensions/extensions.h"
#include "tests/app/rank_window.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// A device whose stylus stays where the test puts it.
class StillStylus final : public Device {
 public:
  struct Place {
    std::atomic<double> x{0.0};
    std::atomic<std::uint32_t> buttons{0};
  };
  explicit StillStylus(std::shared_ptr<Place> place) : place_(std::move(place)) {
    info_ = {shownForceFigures()};
    info_.name = "Still stylus";
    info_.dof_in = 6;
    info_.gives_force = true;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override {
    return {.position = {Vec3(place_->x.load(), 7.0, -5.0)},
            .buttons = place_->buttons.load(),
            .orientation = glm::normalize(Quat(0.8, 0.1, -0.5, 0.3))};
  }
  void write(ForceN) noexcept override {}

 private:
  DeviceInfo info_;
  std::shared_ptr<Place> place_;
};

}  // namespace

TEST_CASE(
    "the mouse's hand begins in each ligand's place, in the dark; pressed and led aside it pulls, and the words are "
    "the same for all three; the attempt knows which it holds; afterwards the hand holds the scene's ligand again") {
  RankWindow w;
  std::vector<std::set<std::string>> words;
  std::set<std::vector<std::uint32_t>> held;
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    REQUIRE(w.scene().stage().body);
    held.insert(w.scene().stage().body->atoms);
    CHECK(w.scene().stage().body->atoms == w.session().taskStage().in_hand);
    CHECK(w.scene().stage().spheres->untouchable() == std::vector<std::uint32_t>{5, 6, 7, 8});
    CHECK(w.d->app().extensions().task_stager.dark());
    w.d->point("view", 0.5, 0.5);
    w.d->frames(5);
    CHECK(w.offPlace_A() < 0.5);
    words.emplace_back();
    w.d->press();
    for (int n = 0; n < 10; ++n) {
      w.d->frames(2);
      w.read(words.back());
    }
    CHECK_FALSE(w.offers("next"));
    // Sideways, until the hand is 1.5 A off; where a ligand is bound firmly the mouse's hand gives way.
    for (double x = 0.5; x < 0.9 && w.offPlace_A() < 1.5; x += 0.004) {
      w.d->point("view", x, 0.5);
      w.d->frames(2);
    }
    CHECK(w.offPlace_A() >= 0.5);
    for (int n = 0; n < 60 && !w.offers("next"); ++n) {
      w.d->frames(1);
      if (n > 5) w.read(words.back());
    }
    REQUIRE(w.offers("next"));
    w.d->release();
    w.d->frames(5);
    w.session().answerTask({"next"});
    w.d->frames(10);
  }
  CHECK(held == std::set<std::vector<std::uint32_t>>{{5}, {6}, {7, 8}});
  for (std::size_t k = 1; k < words.size(); ++k) {
    std::string telling;
    for (const std::string& word : words[k])
      if (!words[0].contains(word) && !contains(word, "That was ligand") && !contains(word, "have felt them all"))
        telling += word + '\n';
    CHECK(telling == "");
  }
  // Whoever knows the order gives it: by the demonstration.
  const TouchableModel& stage = w.scene().stage();
  for (int guard = 0; guard < 3 && !w.session().taskDone(0, 0); ++guard) {
    const HandPlan plan = w.session().taskAt(0)->demonstrate({.spheres = *stage.spheres, .body = stage.body.get()});
    for (const HandAct& act : plan)
      if (act.answer) w.session().answerTask(*act.answer);
    w.d->frames(5);
  }
  CHECK(w.session().taskDone(0, 0));
  w.d->frames(10);
  CHECK(w.scene().stage().body->atoms == std::vector<std::uint32_t>{6});
  CHECK_FALSE(w.d->app().extensions().task_stager.dark());
}

TEST_CASE(
    "a device's hand stays where it is and has each ligand's place and orientation within 1e-6, also with a clutch "
    "used before; it pulls by 2 A") {
  RankWindow w;
  auto stylus = std::make_shared<StillStylus::Place>();
  w.scene().servo().setDevice(std::make_unique<StillStylus>(stylus));
  w.scene().servo_settings.clutch.buttons = 1;
  w.d->frames(20);
  stylus->buttons = 1;
  w.d->frames(5);
  stylus->x = 12.0;  // the hand moves, what it holds stays
  w.d->frames(5);
  stylus->buttons = 0;
  w.d->frames(5);
  w.session().answerTask({"anew"});
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    w.d->frames(10);
    const ServoSample& now = w.scene().log().latest();
    CHECK(w.offPlace_A() < 1e-6);
    CHECK(glm::length(rotationBetween(now.orientation, w.place().orientation)) < 1e-6);
    // A hand that jumps would begin anew.
    const double back_mm = stylus->x, way_mm = 2.0 / w.scene().servo_settings.workspace.A_per_mm;
    for (int n = 1; n <= 40; ++n) {
      stylus->x = back_mm + way_mm * n / 40.0;
      w.d->frames(1);
    }
    w.d->frames(40);
    CHECK(w.offPlace_A() == doctest::Approx(2.0).epsilon(0.01));
    REQUIRE(w.offers("next"));
    stylus->x = back_mm;
    w.session().answerTask({"next"});
  }
}

TEST_CASE("a body is taken back to a pose in a device's hand, within 1e-6 A, and the force rises from zero") {
  const Scratch scratch;
  auto d = startWith(
      scratch
          .file("mine.md",
                "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - 1hpv\nauthor: A\nlicence: L\n---\n## One\n"
                "```scene\nmolecule: 1hpv\nin-hand: ligand\nforces: all\n```\nText.\n")
          .string());
  HapticSession& scene = d->app().scene;
  HeldPoses& poses = d->app().extensions().held_poses;
  d->app().panels.tabs.open("touch");
  d->point("view", 0.5, 0.5);
  d->frames(10);
  d->press();
  d->frames(240);
  d->release();
  d->frames(10);
  REQUIRE_FALSE(poses.list().empty());
  auto stylus = std::make_shared<StillStylus::Place>();
  scene.servo().setDevice(std::make_unique<StillStylus>(stylus));
  d->frames(30);
  poses.select(0);
  const PoseA pose = poses.list()[0].pose;
  REQUIRE(rmsdBetween_A(*scene.stage().body, scene.log().latest().shownBody(), pose) > 1.0);
  REQUIRE(poses.canTake());
  poses.take();
  double before_N = 0.0;
  for (int frame = 0; frame < 60; ++frame) {
    d->frames(1);
    const double now_N = glm::length(scene.log().latest().force.N);
    CHECK(now_N - before_N < 0.1);  // of 17 ticks
    before_N = now_N;
  }
  const ServoSample& now = scene.log().latest();
  CHECK(now.contact.fault == Fault::None);
  CHECK(glm::distance(now.hip.A, pose.place.A) < 1e-6);
  CHECK(glm::length(rotationBetween(now.orientation, pose.orientation)) < 1e-6);
  CHECK(rmsdBetween_A(*scene.stage().body, now.shownBody(), pose) < 1.5);
}

}  // namespace moltact
