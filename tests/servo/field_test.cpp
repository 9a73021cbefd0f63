// Fields in the servo loop: the stiffness slider does not change them. A conservative field is neither cut nor damped,
// one that creates energy is. A stiff one is scaled to what the device permits. Their force is felt without contact.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/device/simulated_device.h"
#include "engine/haptics/methods.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_loop.h"
#include "engine/servo/step_state.h"
#include "tests/haptics/fields.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

// A device that a test leads, and which keeps the force.
struct LedDevice final : Device {
  DeviceInfo is{phantomOmniFigures()};
  PointMm place;
  Vec3 given_N{0.0};
  LedDevice() { is.gives_force = true, is.delay_s = 0.0; }
  const DeviceInfo& info() const noexcept override { return is; }
  DevicePose read(double) noexcept override { return {.position = place}; }
  void write(ForceN force) noexcept override { given_N = force.N; }
};

// A loop on a virtual clock with a hand that follows its target.
class Led {
 public:
  LedDevice device;
  ServoSettings settings;
  ServoLoop loop{device};
  ServoSample last;
  int cut = 0, braked = 0;
  double worked_J = 0.0;  // by the device on the hand

  explicit Led(std::unique_ptr<Interaction> felt, const DeviceInfo* info = nullptr) {
    if (info) device.is = *info;
    settings.workspace.A_per_mm = 0.25;
    felt_ = std::move(felt);
  }
  void begin(PointMm at) {
    device.place = at;
    loop.setDevice(nullptr);
    loop.setSettings(settings);
    loop.begin(0);
    loop.setInteraction(std::move(felt_));
  }
  void tick(const Vec3& place_mm) {
    // The force of the last tick acted on the way here.
    worked_J += 1e-3 * glm::dot(device.given_N, place_mm - device.place.mm);
    device.place = {place_mm};
    loop.setSettings(settings);
    loop.tick(now_ns_ += ServoLoop::kPeriod_ns, std::nullopt, nullptr);
    loop.drain([&](const ServoSample& s) { last = s; });
    cut += last.limits.has(Limit::EnergyCut);
    braked += last.limits.has(Limit::Damping);
  }
  void rest(int ticks) {
    for (int k = 0; k < ticks; ++k) tick(device.place.mm);
  }
  void go(const Vec3& to_mm, double mm_per_s) {
    const Vec3 from = device.place.mm;
    const int ticks = std::max(1, int(std::ceil(glm::distance(from, to_mm) / (1e-3 * mm_per_s))));
    for (int k = 1; k <= ticks; ++k) tick(from + (to_mm - from) * (double(k) / ticks));
  }

 private:
  std::unique_ptr<Interaction> felt_;
  std::int64_t now_ns_ = 0;
};

std::unique_ptr<test::LennardJones> wellRound(const Vec3& place_A, std::unique_ptr<Interaction> inner = nullptr,
                                              test::LennardJonesPair pair = {}) {
  if (!inner) inner = std::make_unique<test::OpenSpace>();
  return std::make_unique<test::LennardJones>(std::move(inner), pair,
                                              std::vector<test::LennardJones::Atom>{{0, place_A}});
}

}  // namespace

TEST_CASE(
    "the stiffness of the springs, 0.1 or 0.7 N/mm, changes no bit of a field's force along 30 mm, and where a wall is "
    "pressed beside the field only the wall's part") {
  std::vector<Vec3> forces[2];
  double pressed_N[2] = {};
  for (const int k : {0, 1}) {
    const double stiffness = k ? 0.7 : 0.1;
    // The wall at z = 2 A; the atom 3 A under it, whose well so lies before the wall.
    Led hand(wellRound({0, 0, -3}, std::make_unique<WallTracker>(2.0)));
    hand.settings.stiffness_N_per_mm = stiffness;
    hand.begin({{1, 2, 40}});
    hand.rest(600);
    for (double z = 40; z > 10; z -= 0.05) {
      hand.tick({1, 2, z});
      forces[k].push_back(hand.device.given_N);
    }
    hand.go({0, 0, 7.9}, 5);
    REQUIRE(hand.last.contact.touching());
    hand.rest(300);
    const Vec3 field = hand.last.field->force_N;
    pressed_N[k] = hand.device.given_N.z - field.z;
    CHECK(pressed_N[k] == doctest::Approx(stiffness * 0.1).epsilon(1e-6));
  }
  CHECK(forces[0] == forces[1]);
  CHECK(glm::length(forces[0].back()) > 0.04);
}

TEST_CASE(
    "a field is felt without touching: 0.4 N that pull to the atom are given and felt, and the contact stays free; "
    "under 0.02 N nothing is felt") {
  Led hand(wellRound({0, 0, 0}, nullptr, {.depth_N_A = 0.6}));
  hand.begin({{0, 0, 17}});
  hand.rest(700);
  const double r_A = 17 * 0.25, q6 = std::pow(3.8 / r_A, 6);
  const double pull_N = 12.0 * 0.6 / r_A * (q6 - q6 * q6);
  REQUIRE(pull_N > 0.35);
  CHECK_FALSE(hand.last.contact.touching());
  CHECK(hand.last.felt());
  CHECK(hand.device.given_N.z == doctest::Approx(-pull_N).epsilon(1e-9));
  CHECK(hand.last.wanted().force_N.z == doctest::Approx(-pull_N).epsilon(1e-9));
  CHECK(hand.last.wanted().energy_N_A == doctest::Approx(0.6 * (q6 * q6 - 2.0 * q6)).epsilon(1e-9));
  hand.go({0, 0, 60}, 100);
  hand.rest(100);
  CHECK(glm::length(hand.device.given_N) > 0.0);
  CHECK_FALSE(hand.last.felt());
}

TEST_CASE(
    "a well with its wall, and a harmonic well, both pressed beyond the greatest force, in fast and out slowly, 40 "
    "times at 4 speeds: no cut, and the hand gains less than half of a friction of 0.02 N takes; with half as much "
    "force again wherever it drives the hand it is braked, and cut by a device that cannot brake") {
  for (const bool harmonic : {false, true})
    for (const bool brakes : {true, false})
      for (const double driving : {1.0, 1.5}) {
        CAPTURE(harmonic);
        CAPTURE(brakes);
        CAPTURE(driving);
        DeviceInfo info{phantomOmniFigures()};
        info.gives_force = true;
        info.delay_s = 0.0;
        // A mechanism that takes hardly anything, so that what comes out of nothing is seen.
        info.friction_N = 0.02;
        info.damping_N_s_per_m = 0.0;
        info.resolution_mm = 0.001;
        if (!brakes) info.max_damping_N_s_per_m = 0.0;
        std::unique_ptr<Interaction> felt;
        if (harmonic) {
          auto well = std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{1.2},
                                                       std::vector<test::Harmonic::Atom>{{0, Vec3(0.0)}});
          well->driving = driving;
          felt = std::move(well);
        } else {
          auto well = wellRound({0, 0, 0}, nullptr, {.depth_N_A = 0.25});
          well->driving = driving;
          felt = std::move(well);
        }
        const double far_mm = harmonic ? 18.0 : 40.0, near_mm = harmonic ? -18.0 : 11.0;
        const double max_N = harmonic ? 2.0 : 0.3;
        Led hand(std::move(felt), &info);
        hand.settings.max_force_N = max_N;
        hand.begin({{0, 0, far_mm}});
        hand.rest(700);
        hand.worked_J = 0.0;
        bool clamped = false;
        for (int k = 0; k < 40; ++k) {
          hand.go({0, 0, near_mm}, 40 + 40 * (k % 4));
          clamped = clamped || hand.last.limits.has(Limit::Clamp) || hand.last.limits.has(Limit::Heat);
          hand.rest(20);
          hand.go({0, 0, far_mm}, 20 + 15 * (k % 3));
        }
        CHECK(clamped);
        const double friction_J = 1e-3 * 0.5 * info.friction_N * 80 * (far_mm - near_mm);
        if (driving == 1.0) {
          CHECK(hand.cut == 0);
          CHECK(hand.worked_J < friction_J);
        } else if (brakes) {
          CHECK(hand.braked + hand.cut > 0);
        } else {
          CHECK(hand.cut > 0);
        }
      }
}

TEST_CASE(
    "a field as a spring, pressed 12 mm beyond the greatest force and let out, is cut, braked and stored as the same "
    "spring of a contact: the debts differ by less than a microjoule") {
  const double k_N_per_mm = 0.3, A_per_mm = 0.25;
  DeviceSpecs info = phantomOmniFigures();
  info.gives_force = true;
  double debts_J[2] = {};
  Vec3 forces[2];
  for (const bool field : {false, true}) {
    // Half a spring: the wall at z = 0, and a harmonic well whose middle is there.
    WallTracker wall(0.0);
    test::Harmonic well(std::make_unique<test::OpenSpace>(), {k_N_per_mm / A_per_mm}, {{0, Vec3(0.0)}});
    Interaction& felt = field ? static_cast<Interaction&>(well) : wall;
    ServoStep step(info);
    ServoSettings settings;
    settings.workspace.A_per_mm = A_per_mm;
    settings.stiffness_N_per_mm = k_N_per_mm;
    double greatest_J = 0.0;
    for (int k = 0; k < 600; ++k) step.tick(settings, &felt, {.position = {{0, 0, -0.01}}});
    for (int k = 0; k < 4000; ++k) {
      const double z = -10.01 + 10.0 * std::cos(0.02 * k);
      forces[field] = step.tick(settings, &felt, {.position = {{0, 0, z}}}).force.N;
      greatest_J = std::max(greatest_J, step.safety().debt_J());
    }
    debts_J[field] = greatest_J;
  }
  CHECK(debts_J[1] == doctest::Approx(debts_J[0]).epsilon(1e-6));
  CHECK(std::abs(debts_J[1] - debts_J[0]) < 1e-6);
  CHECK(glm::distance(forces[0], forces[1]) < 1e-6);
}

TEST_CASE("where the energy of a field has its zero changes no force: with 1 J more everywhere all is as without") {
  std::vector<Vec3> forces[2];
  for (const bool offset : {false, true}) {
    auto well = wellRound({0, 0, 0});
    if (offset) well->offset_N_A = 250.0;
    Led hand(std::move(well));
    hand.begin({{0, 0, 18}});
    for (int k = 0; k < 3000; ++k) {
      hand.tick({0, 0, 16 + 2 * std::cos(0.03 * k)});
      forces[offset].push_back(hand.device.given_N);
    }
    CHECK(hand.cut == 0);
  }
  double apart = 0.0;
  for (std::size_t k = 0; k < forces[0].size(); ++k) apart = std::max(apart, glm::distance(forces[0][k], forces[1][k]));
  CHECK(apart < 1e-6);
}

TEST_CASE(
    "a harmonic well of 3 N/mm round a slippery device in a hand of 100 N/m is scaled to half of the "
    "bound, and the device rests below 2 mm/s; with its stiffness given as zero it shakes at more "
    "than 0.1 m/s or is cut") {
  struct Soft final : WrappedInteraction {
    using WrappedInteraction::WrappedInteraction;
    Response respond(const PoseA& pose) noexcept override {
      Response out = inner().respond(pose);
      if (out.field) out.field->stiffness_N_per_A = 0.0;
      return out;
    }
  };
  DeviceParameters parameters;
  parameters.friction_N = 0.03;
  parameters.damping_N_s_per_m = 0.05;
  parameters.resolution_mm = 0.02;
  parameters.delay_ticks = 2;
  for (const bool honest : {true, false}) {
    CAPTURE(honest);
    std::unique_ptr<Interaction> felt =
        std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{12.0},
                                         std::vector<test::Harmonic::Atom>{{0, Vec3(0.0)}});
    if (!honest) felt = std::make_unique<Soft>(std::move(felt));
    const auto target = [](int k) { return PointMm{{0.2, 0.1, 1.0 + std::max(0.0, 0.5 - 0.001 * k)}}; };
    DeviceModel model(parameters, {100, 2}, target(0));
    ServoStep step(describe(parameters));
    ServoSettings settings;
    settings.workspace.A_per_mm = 0.25;
    double greatest_m_per_s = 0.0, share = 1.0;
    int cut = 0;
    for (int k = 0; k < 3000; ++k) {
      const ServoSample s = step.tick(settings, felt.get(), {.position = model.sensed()});
      model.tick(s.force, target(k));
      share = s.field_share;
      cut += s.limits.has(Limit::EnergyCut);
      if (k > 2000) greatest_m_per_s = std::max(greatest_m_per_s, glm::length(model.velocity_m_per_s()));
    }
    if (honest) {
      CHECK(greatest_m_per_s < 0.002);
      CHECK(cut == 0);
      CHECK(share == doctest::Approx(0.5 * step.safety().stiffnessBound_N_per_mm() / 3.0));
    } else {
      CHECK(share == 1.0);
      CHECK((greatest_m_per_s > 0.1 || cut > 0));
    }
  }
}

TEST_CASE("a contact beside a field has what the field leaves of the bound, 0.73 N/mm: 0.53 of 0.2, and half of 3") {
  DeviceSpecs info = phantomOmniFigures();
  info.gives_force = true;
  SafetyStage stage(info);
  stage.beginTick({}, {});
  const double bound = stage.stiffnessBound_N_per_mm();
  CHECK(stage.stiffness(5.0, {.field = true, .field_N_per_mm = 0.2}) == doctest::Approx(bound - 0.2));
  CHECK(stage.fieldShare() == 1.0);
  CHECK(stage.stiffness(5.0, {.field = true, .field_N_per_mm = 3.0}) == doctest::Approx(0.5 * bound));
  CHECK(stage.fieldShare() == doctest::Approx(0.5 * bound / 3.0));
  CHECK(stage.acted().has(Limit::Stiffness));
  CHECK(stage.stiffness(5.0, {.field = true, .field_N_per_mm = std::nan("")}) == 0.0);
  CHECK(stage.fieldShare() == 0.0);
  CHECK(stage.stiffness(5.0, {.stiffness_factor = 2.0}) == doctest::Approx(0.5 * bound));
  CHECK(stage.fieldShare() == 1.0);
}

TEST_CASE(
    "a device that drives 60 N mm and 3.3 N bears 0.73 N/mm at a lever of 18 mm round an axis: springs that are "
    "stiffer "
    "are softer, a field is scaled down; a device without torque bears any") {
  DeviceSpecs info = phantomOmniFigures();
  info.gives_force = true;
  for (const bool drives : {true, false}) {
    if (drives)
      info.dof_out = 6, info.max_torque_N_mm = 60.0;
    else
      info.dof_out = 3;
    SafetyStage stage(info);
    stage.beginTick({}, {});
    const double bound = stage.stiffnessBound_N_per_mm(), lever_mm = 60.0 / 3.3;
    const double most = bound * lever_mm * lever_mm;
    CHECK(stage.stiffness(0.5, {.rotational_mm2 = 2000.0}) == doctest::Approx(drives ? most / 2000.0 : 0.5));
    CHECK(stage.stiffness(0.5, {.rotational_mm2 = 100.0}) == doctest::Approx(0.5));
    stage.stiffness(0.5, {.field = true, .field_rotational_N_mm = 10.0 * most});
    CHECK(stage.fieldShare() == doctest::Approx(drives ? 0.05 : 1.0));
  }
}

TEST_CASE(
    "the loop hands over the reactions of its newest tick: wall and field together the opposite of the force, on their "
    "atoms; none while the force is off, without the wish, or from the interaction before") {
  Led hand(wellRound({0, 0, -3}, std::make_unique<WallTracker>(2.0)));
  hand.begin({{0, 0, 30}});
  hand.rest(10);
  CHECK(hand.loop.reactions().count == 0);
  hand.loop.wantReactions(true);
  for (double z = 30; z > 7; z -= 0.01) {
    hand.tick({0, 0, z});
    const Reactions& to = hand.loop.reactions();
    CHECK(to.tick == hand.last.tick);
    Vec3 sum = hand.last.wanted().force_N;
    for (const AtomForce& a : to.forces()) sum += a.force_N;
    CHECK(glm::length(sum) < 1e-9);
    CHECK(to.count == (hand.last.contact.touching() ? 2u : 1u));
  }
  CHECK(hand.last.contact.touching());
  hand.settings.force_on = false;
  hand.rest(1);
  CHECK(hand.loop.reactions().count == 0);
  hand.settings.force_on = true;
  hand.rest(1);
  CHECK(hand.loop.reactions().count == 2);
  hand.loop.setInteraction(wellRound({0, 0, -3}));
  CHECK(hand.loop.reactions().count == 0);
  hand.rest(1);
  CHECK(hand.loop.reactions().count == 1);
}

TEST_CASE(
    "a step that is written as text in a field and read again continues with the same forces to the last bit, at any "
    "of "
    "16 ticks") {
  DeviceSpecs info = phantomOmniFigures();
  info.gives_force = true;
  const auto well = wellRound({0, 0, 0}, nullptr, {.depth_N_A = 0.25});
  ServoSettings settings;
  settings.workspace.A_per_mm = 0.25;
  ServoStep step(info);
  const auto tick = [&](ServoStep& one, int k) {
    return one.tick(settings, well.get(), {.position = {{0, 0, 15.0 + 3.0 * std::cos(0.05 * k)}}}).force.N;
  };
  for (int k = 0; k < 1500; ++k) {
    tick(step, k);
    if (k % 50 != 49 || k < 700) continue;
    const std::string text = stateText(step);
    CHECK(text.find("safety.field_energy_N_mm=") != std::string::npos);
    Expected<ServoStep> read = stepFromText(text);
    REQUIRE(bool(read));
    // Neither remembers the interaction, so that both begin as softly.
    ServoStep copy = step;
    copy.forgetInteraction();
    for (int n = 1; n < 40; ++n) REQUIRE(tick(copy, k + n) == tick(*read, k + n));
  }
  CHECK(stateText(ServoStep(info)).find("field") == std::string::npos);
}
