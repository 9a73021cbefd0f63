// Safety of a device in the window: the panic key and the test force in every scene, the message of each active limit,
// and the device's own messages. Oracle: the forces that a test device received.
#include <algorithm>
#include <cmath>
#include <functional>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "engine/servo/plain_trackers.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// A stylus with an Omni's properties that follows the test's path and records its force.
class Led final : public Device {
 public:
  using Path = std::function<DevicePose(double t_s)>;
  /// In the second second, the hand moves this far behind the middle of its workspace; then it is led.
  explicit Led(Path path = {}, double deep_mm = 0.0) : path_(std::move(path)), deep_mm_(deep_mm) {
    info_.name = "Led stylus";
    info_.gives_force = true;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override {
    t_s_ += dt_s;
    const double led_s = deep_mm_ > 0.0 ? t_s_ - 2.0 : t_s_;
    DevicePose pose = path_ && led_s >= 0.0 ? path_(led_s) : DevicePose{};
    pose.position.mm.z -= deep_mm_ * std::clamp(t_s_ - 1.0, 0.0, 1.0);
    return pose;
  }
  void write(ForceN force) noexcept override { given_N = force.N; }
  DeviceStatus status() override { return said; }
  void calibrate() override { calibrated = true; }

  Vec3 given_N{0.0};
  DeviceStatus said;
  bool calibrated = false;

 private:
  DeviceInfo info_{phantomOmniFigures()};
  Path path_;
  double deep_mm_, t_s_ = 0.0;
};

Led& lead(ScriptedUser& d, Led::Path path = {}, double deep_mm = 0.0) {
  auto made = std::make_unique<Led>(std::move(path), deep_mm);
  Led& led = *made;
  d.app().scene.servo().setDevice(std::move(made));
  d.frames(deep_mm > 0.0 ? 119 : 3);
  return led;
}

// So deep that the hand is inside the molecule and a pulling method is not taken for a contact left behind.
constexpr double kDeep_mm = 80.0;

// Pulls toward the molecule's +x with this force at the scene's own stiffness.
std::unique_ptr<Tracker> pull(ScriptedUser& d, double N) {
  const ServoSettings& s = d.app().scene.servo_settings;
  return std::make_unique<ConstantForceTracker>(N / s.stiffness_N_per_mm * s.workspace.A_per_mm);
}

// A method whose SCP the test defines.
class ScriptedScp final : public PlainTracker {
 public:
  explicit ScriptedScp(std::function<Vec3(Vec3)> scp) : scp_(std::move(scp)) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {scp_(hip.A)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    return out;
  }

 private:
  std::function<Vec3(Vec3)> scp_;
};

// The widget of the message that contains `part`; empty if there is none.
std::string message(ScriptedUser& d, const std::string& part) {
  for (std::size_t k = 0; k < d.app().messages.all().size(); ++k)
    if (contains(d.app().messages.all()[k].text, part)) return "message/" + std::to_string(k);
  return {};
}

bool deviceSafetyReported(ScriptedUser& d, const std::string& part) { return !message(d, part).empty(); }

}  // namespace

TEST_CASE(
    "while a recorded hand is shown no gentle force begins; one that pulls when it is shown ends at once, and the "
    "force is 0 from then on") {
  auto d = startWith();
  Led& stylus = lead(*d);
  d->tap("Ctrl+D");
  d->frames(3);
  DeviceLink& link = d->app().extensions().device;
  d->app().scene.playedHand().show(ServoSample());
  d->frames(3);
  d->click("device/try");
  link.tryForce();
  CHECK(link.tryingLeft_s() == 0.0);
  d->frames(120);
  CHECK(stylus.given_N == Vec3(0));
  // The other order.
  d->app().scene.playedHand().show(std::nullopt);
  d->frames(3);
  REQUIRE(d->click("device/try"));
  d->frames(60);
  CHECK(stylus.given_N.x == doctest::Approx(0.4));
  d->app().scene.playedHand().show(ServoSample());
  d->frames(3);
  CHECK(stylus.given_N == Vec3(0));
  d->frames(60 * 5);
  CHECK(stylus.given_N == Vec3(0));
  CHECK(link.tryingLeft_s() == 0.0);
}

TEST_CASE("a class takes turns while a force is tried: as the device changes hands nothing pulls any more") {
  auto d = startWith(MOLTACT_SOURCE_DIR "/lessons/first-touch.md");
  Led& stylus = lead(*d);
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/try"));
  d->frames(60);
  CHECK(stylus.given_N.x == doctest::Approx(0.4));
  d->app().extensions().turns.begin({"K1", "K2"}, 30.0);
  d->frames(4);
  CHECK(stylus.given_N == Vec3(0));
  d->frames(60 * 5);
  CHECK(stylus.given_N == Vec3(0));
}

TEST_CASE(
    "F9 stops all force within two frames whatever is shown: the scene, a try, a recorded hand, the welcome page, a "
    "page, a field that is typed into, "
    "another step, another molecule") {
  struct Case {
    const char* name;
    std::function<void(ScriptedUser&)> begin;
  };
  const std::vector<Case> cases{
      {"the scene", [](ScriptedUser&) {}},
      {"a try", [](ScriptedUser& d) { d.app().extensions().device.tryForce(); }},
      {"a recorded hand", [](ScriptedUser& d) { d.app().scene.playedHand().show(ServoSample()); }},
      {"turns",
       [](ScriptedUser& d) {
         d.app().extensions().turns.begin({"K1", "K2"}, 30.0);
       }},
      {"welcome", [](ScriptedUser& d) { d.app().panels.pages.welcome = true; }},
      {"open page", [](ScriptedUser& d) { d.app().panels.pages.open = true; }},
      {"preferences", [](ScriptedUser& d) { d.app().panels.pages.preferences = true; }},
      {"a field",
       [](ScriptedUser& d) {
         d.app().panels.pages.turns = true;
         d.frames(3);
         d.click("turns/names");
         d.type("K");
       }},
      {"a file dialog", [](ScriptedUser& d) { d.tap("Ctrl+Shift+S"); }},
      {"another step", [](ScriptedUser& d) { d.app().lesson.next(); }},
      {"another molecule", [](ScriptedUser& d) { d.app().open("1hel"); }},
      {"another view", [](ScriptedUser& d) { d.tap("Home"); }},
  };
  for (const Case& c : cases) {
    CAPTURE(std::string(c.name));
    auto d = startWith(MOLTACT_SOURCE_DIR "/lessons/first-touch.md");
    Led& stylus = lead(*d);
    d->app().panels.pages.device = std::string(c.name) == "a try";
    c.begin(*d);
    d->frames(3);
    // A method that pulls hard, so that nothing but the key holds it back.
    if (!d->app().scene.force().trying()) d->app().scene.servo().setInteraction(pull(*d, 1.0));
    d->frames(20);
    d->tap("F9");
    d->frames(2);
    CHECK(d->app().scene.servo_settings.panic);
    CHECK(d->app().scene.servo().newest().limits.has(Limit::Panic));
    CHECK(stylus.given_N == Vec3(0));
    d->frames(60 * 5);
    CHECK(stylus.given_N == Vec3(0));
  }
}

TEST_CASE(
    "the gentle force is 0.4 N to the device's right although the view was turned, the spring is soft, the lesson "
    "wants no force and the page of welcome "
    "stands there; F9 ends it, and it does not come back") {
  auto d = startWith();
  Led& stylus = lead(*d);
  d->drag("view", 200, 60, 1);
  d->app().scene.servo_settings.stiffness_N_per_mm = 0.05;
  d->app().scene.servo_settings.force_on = false;
  d->app().panels.pages.welcome = true;
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/try"));
  d->frames(60);
  CHECK(stylus.given_N.x == doctest::Approx(0.4));
  CHECK(std::abs(stylus.given_N.y) + std::abs(stylus.given_N.z) < 1e-9);
  d->tap("F9");
  d->frames(2);
  CHECK(stylus.given_N == Vec3(0));
  d->tap("F9");
  d->frames(60);
  CHECK(stylus.given_N == Vec3(0));
  CHECK(d->app().extensions().device.tryingLeft_s() == 0.0);
}

TEST_CASE("each limit is named on the device page and says its sentence over the view while it acts") {
  struct Case {
    Limit limit;
    std::function<void(ScriptedUser&)> set;  // the settings and the method
    Led::Path path;                          // the hand
    double for_s = 1.0;
  };
  const double turn = 2 * 3.14159265358979;
  const auto strong = [](double N) {
    return [N](ScriptedUser& d) { d.app().scene.servo().setInteraction(pull(d, N)); };
  };
  const auto method = [](std::function<Vec3(Vec3)> scp) {
    return [scp](ScriptedUser& d) { d.app().scene.servo().setInteraction(std::make_unique<ScriptedScp>(scp)); };
  };
  const Led::Path still = [](double) { return DevicePose{}; };
  // To and fro along x, up to `fast_mm_per_s`.
  const auto shaken = [turn](double fast_mm_per_s, double Hz) {
    return [=](double t) {
      return DevicePose{.position = {{fast_mm_per_s / (turn * Hz) * std::sin(turn * Hz * t), 0, 0}}};
    };
  };
  const std::vector<Case> cases{
      {Limit::Clamp, strong(9.0), still},
      {Limit::Heat, strong(3.2), still, 8.0},
      {Limit::Slew, method([side = 1.0](Vec3 hip) mutable { return hip + Vec3(side = -side, 0, 0); }), still},
      {Limit::StalePlace, strong(1.0), [](double t) { return DevicePose{.position = {}, .fresh = t < 0.5}; }},
      {Limit::Speed, strong(0.5), shaken(950, 3)},
      {Limit::Stiffness,
       [](ScriptedUser& d) {
         d.app().scene.servo_settings.stiffness_N_per_mm = 2.0;
         d.app().scene.servo().setInteraction(pull(d, 1.0));
       },
       still},
      // A force along the hand's motion in every direction generates energy without limit.
      {Limit::Damping, strong(1.0),
       [](double t) {
         return DevicePose{.position = {{20 * t, 0, 0}}};
       }},
      {Limit::EnergyCut, strong(3.0),
       [](double t) {
         return DevicePose{.position = {{300 * t, 0, 0}}};
       }},
      {Limit::NotFinite, method([](Vec3) { return Vec3(std::nan("")); }), still},
      {Limit::LateLoop, strong(1.0), still},
      {Limit::Jump, strong(1.0),
       [](double t) {
         return DevicePose{.position = {{t < 0.8 ? 0.0 : 60.0, 0, 0}}};
       }},
      {Limit::DeviceFault, strong(1.0), [](double) { return DevicePose{.position = {}, .fault = true}; }},
      {Limit::SoftStart, strong(1.0), still, 0.2},
  };
  for (const Case& c : cases) {
    const auto words =
        std::find_if(limitWords().begin(), limitWords().end(), [&](const LimitWords& w) { return w.limit == c.limit; });
    CAPTURE(words->name);
    for (const bool page : {true, false}) {
      auto d = startWith();
      d->app().panels.pages.device = page;
      lead(*d, c.path, kDeep_mm);
      c.set(*d);
      bool seen = false;
      for (int k = 0; k < int(c.for_s * 12) && !seen; ++k) {
        if (c.limit == Limit::LateLoop) d->app().scene.servo().simulateStall(0.05);
        d->frames(5);
        seen = page ? contains(d->text("device/acting"), std::string(words->name))
                    : d->shows("limits") && contains(d->text("limits"), std::string(words->sentence));
      }
      // A soft start begins every touch and has no word over the view.
      CHECK(seen == (page || c.limit != Limit::SoftStart));
    }
  }
}

TEST_CASE("a soft start that begins again and again for 1.5 s is reported over the view") {
  auto d = startWith();
  lead(*d, {}, kDeep_mm);
  d->app().scene.servo().setInteraction(pull(*d, 1.0));
  for (int k = 0; k < 30; ++k) {
    ++d->app().scene.servo_settings.discontinuities;
    d->frames(6);
  }
  CHECK(contains(d->text("limits"), "The force grows slowly from nothing."));
}

TEST_CASE("the soft start of a gentle force shows on the page, although its ticks belong to no scene") {
  auto d = startWith();
  lead(*d);
  d->tap("Ctrl+D");
  d->frames(90);
  CHECK(d->text("device/acting") == "No limit acts.");
  REQUIRE(d->click("device/try"));
  d->frames(10);
  CHECK(contains(d->text("device/acting"), "Soft start"));
  d->frames(120);
  CHECK(d->text("device/acting") == "No limit acts.");
}

TEST_CASE(
    "the stiffness in force stands on the page: half of 2.2 N s/m over 1.5 ms, less as soon as the device is slower "
    "than its figures say") {
  auto d = startWith();
  lead(*d);
  d->tap("Ctrl+D");
  d->frames(5);
  CHECK(contains(d->text("device/limits"), "the surface is at most 0.73\u00a0N/mm stiff"));
  CHECK(d->app().scene.servo().newest().stiffness_bound_N_per_mm == doctest::Approx(0.5 * 2.2 / 1.5));
}

TEST_CASE(
    "a device that needs calibration shows instructions over the view, with a button; once it is "
    "ready, a message says so and the instructions disappear") {
  auto d = startWith();
  Led& stylus = lead(
      *d, [](double t) { return DevicePose{.position = {}, .fault = t < 2.0}; }, kDeep_mm);
  d->app().scene.servo().setInteraction(pull(*d, 1.0));
  stylus.said = {.ready = false, .text = "Put the stylus into the inkwell.", .asks_calibrate = true};
  d->frames(20);
  CHECK(deviceSafetyReported(*d, "Led stylus gives no force yet. Put the stylus into the inkwell."));
  // Once, not in the notice below as well.
  CHECK_FALSE(contains(d->text("limits"), "calibrated"));
  CHECK(d->click(message(*d, "inkwell") + "/calibrate"));
  CHECK(stylus.calibrated);
  CHECK(d->click(message(*d, "inkwell") + "/device"));
  d->frames(3);
  CHECK(d->app().panels.pages.device);
  d->tap("Escape");
  d->frames(3);
  // After the notice is dismissed, the limit still displays the words.
  d->click(message(*d, "inkwell") + "/dismiss");
  d->frames(3);
  CHECK(contains(d->text("limits"), "Put the stylus into the inkwell."));
  stylus.said = {};
  d->frames(150);
  CHECK_FALSE(deviceSafetyReported(*d, "inkwell"));
  CHECK_FALSE(d->shows("limits"));
  stylus.said = {.ready = false, .text = "Put the stylus into the inkwell.", .asks_calibrate = true};
  d->frames(20);
  stylus.said = {};
  d->frames(20);
  CHECK(deviceSafetyReported(*d, "Led stylus is ready."));
  CHECK_FALSE(deviceSafetyReported(*d, "inkwell"));
}

TEST_CASE("a fault that a device reports is displayed for as long as it lasts") {
  auto d = startWith();
  Led& stylus = lead(*d);
  stylus.said.text = "The motors are too warm.";
  d->frames(20);
  CHECK(deviceSafetyReported(*d, "The motors are too warm."));
  stylus.said.text.clear();
  d->frames(20);
  CHECK_FALSE(deviceSafetyReported(*d, "The motors are too warm."));
}

}  // namespace moltact
