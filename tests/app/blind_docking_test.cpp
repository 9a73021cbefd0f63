// Docking without eyes: a scripted hand at a device that knows nothing but the arrow of the force and the hum of the
// energy finds a well. Ticks run on the frames' clock.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "app/ui/extensions/extensions.h"
#include "engine/bench/energies/double_sum.h"
#include "engine/core/random.h"
#include "engine/sound/touch_synth.h"
#include "tests/app/rank_window.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// A device whose stylus stays where the test puts it.
class BlindStylus final : public Device {
 public:
  struct Place {
    std::array<std::atomic<double>, 3> mm{0.0, 0.0, 0.0};
  };
  explicit BlindStylus(std::shared_ptr<Place> place) : place_(std::move(place)) {
    info_ = {shownForceFigures()};
    info_.name = "Blind stylus";
    info_.dof_in = 6;
    info_.gives_force = true;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override {
    return {.position = {Vec3(place_->mm[0].load(), place_->mm[1].load(), place_->mm[2].load())},
            .orientation = kNoRotation};
  }
  void write(ForceN) noexcept override {}

 private:
  DeviceInfo info_;
  std::shared_ptr<Place> place_;
};

// Three chloride ions whose middle binds a potassium ion, and sodium ions that repel it.
struct BlindWindow {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;
  std::shared_ptr<BlindStylus::Place> stylus = std::make_shared<BlindStylus::Place>();

  explicit BlindWindow(const std::string& more = "hide: all\n") {
    std::string pdb;
    int serial = 0;
    const auto ion = [&](const char* name, char chain, const Vec3& at) {
      ++serial;
      pdb += pdbIon(serial, name, chain, serial, at);
    };
    for (int k = 0; k < 3; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / 3.0;
      ion("CL", 'A', {2.6 * std::cos(turn), 2.6 * std::sin(turn), 0.0});
    }
    // One closes the well's mirror image on the other side.
    ion("NA", 'A', {0.0, 0.0, -4.0});
    ion("NA", 'A', {-9.0, 0.0, 0.0});
    ion(" K", 'C', {0.0, 0.0, 7.0});
    scratch.file("ions.pdb", pdb);
    d = startWith(scratch
                      .file("mine.md",
                            "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - ions\nauthor: A\nlicence: L\n---\n"
                            "## One\n```scene\nmolecule: ions\nin-hand: chain C\nforces: all\ndielectric: distance\n" +
                                more + "```\nText.\n")
                      .string());
    d->app().settings.sound = true;
    d->app().settings.sound_volume = 1.0;
    scene().servo().setDevice(std::make_unique<BlindStylus>(stylus));
    d->frames(30);
  }
  HapticSession& scene() { return d->app().scene; }
  const std::vector<float>& heard() { return d->app().extensions().touch_sound.heard(); }
  /// Moves the stylus by this way in the molecule, along the view's axes, in small steps.
  void move(const Vec3& way_A) {
    const double mm_per_A = 1.0 / scene().servo_settings.workspace.A_per_mm;
    const int steps = std::max(1, int(std::ceil(glm::length(way_A) / 0.05)));
    for (int n = 0; n < steps; ++n) {
      for (int axis = 0; axis < 3; ++axis)
        stylus->mm[std::size_t(axis)] = stylus->mm[std::size_t(axis)] + way_A[axis] * mm_per_A / steps;
      d->frames(1);
    }
    d->frames(10);
  }
  PointA body() { return scene().log().latest().shownBody().place; }
};

// The pitch of the hum in the last eighth of a second; none if there is none. Below the lowest note of the force there is
// nothing but the hum.
std::optional<double> heardHum_Hz(const std::vector<float>& heard) {
  constexpr std::size_t kPiece = kSamples_per_s / 8;
  if (heard.size() < kPiece) return std::nullopt;
  const auto level = [&](double hertz) {
    double re = 0.0, im = 0.0;
    for (std::size_t k = 0; k < kPiece; ++k) {
      const double turn = 2.0 * std::numbers::pi * double(k) / double(kPiece);
      const double window = 0.5 - 0.5 * std::cos(turn),
                   phase = 2.0 * std::numbers::pi * hertz * double(k) / kSamples_per_s;
      const double sample = window * double(heard[heard.size() - kPiece + k]);
      re += sample * std::cos(phase);
      im += sample * std::sin(phase);
    }
    return 4.0 * std::hypot(re, im) / double(kPiece);
  };
  double best = 0.0, loudest = 0.0;
  for (double hertz = 90.0; hertz < 322.0; hertz += 2.0)
    if (const double here = level(hertz); here > loudest) loudest = here, best = hertz;
  if (loudest < 0.1 * kHumLevel) return std::nullopt;
  const double a = level(best - 2.0), b = level(best), c = level(best + 2.0);
  return a - 2.0 * b + c < 0.0 ? best + (a - c) / (a - 2.0 * b + c) : best;
}

// The place of lowest energy among those where the ion overlaps no other, by the sum in double precision on a grid.
PointA deepestPlace(BlindWindow& w) {
  const PairField& f = *w.scene().forces().field();
  bench::DoubleSum sum(f.places, f.atoms, f.held, f.model.cutoff_A, false);
  const double radius_A = w.scene().stage().body->spheres[0].radius_A;
  PointA best;
  double lowest = 0.0;
  for (double x = -8.0; x <= 8.0; x += 0.25)
    for (double y = -8.0; y <= 8.0; y += 0.25)
      for (double z = -8.0; z <= 8.0; z += 0.25) {
        const PointA at{{x, y, z}};
        bool free = true;
        for (std::uint32_t i = 0; i < 5; ++i)
          free = free && glm::distance(w.scene().stage().molecule->spheres[i].centre_A, at.A) >=
                             w.scene().stage().molecule->spheres[i].radius_A + radius_A;
        const double energy = free ? sum.at({at}).energy.total_kcal_mol() : 0.0;
        if (energy < lowest) lowest = energy, best = at;
      }
  return best;
}

constexpr int kMoves = 120;

// Follows the arrow and keeps a step if the hum has become lower.
void dockByEarAndArrow(BlindWindow& w) {
  double step_A = 0.6;
  for (int n = 0; n < kMoves && step_A > 0.05; ++n) {
    const Vec3 arrow = pushInView(w.scene());
    if (arrow == Vec3(0.0)) return;
    const auto before = heardHum_Hz(w.heard());
    w.move(step_A * arrow);
    const auto now = heardHum_Hz(w.heard());
    if (before && (!now || *now >= *before)) {
      w.move(-step_A * arrow);
      step_A *= 0.5;
    }
  }
}

void dockDeafAndBlind(BlindWindow& w, std::uint64_t seed) {
  for (int n = 0; n < kMoves; ++n) {
    const auto share = [&] { return double(nextRandom(seed) % 2001) / 1000.0 - 1.0; };
    const Vec3 way(share(), share(), share());
    w.move(0.6 * (glm::length(way) > 0.0 ? glm::normalize(way) : Vec3(1.0, 0.0, 0.0)));
  }
}

const std::array<Vec3, 5> kStarts{Vec3(0.0), Vec3(-4.0, 3.0, 0.0), Vec3(-3.0, 1.0, 0.0), Vec3(0.0, 4.0, 1.0),
                                  Vec3(1.0, -4.0, -1.0)};

}  // namespace

TEST_CASE(
    "in a scene that draws nothing a hand that has only the arrow and the hum finds the well: within 0.7 A of the "
    "lowest "
    "energy on a grid, from five starts; one without either does not in three of them or more") {
  int found_by_chance = 0;
  for (std::size_t k = 0; k < kStarts.size(); ++k) {
    CAPTURE(k);
    PointA deepest;
    {
      BlindWindow w;
      REQUIRE(w.d->app().extensions().reveal_policy.all());
      w.move(kStarts[k]);
      deepest = deepestPlace(w);
      const double from_A = glm::distance(w.body().A, deepest.A);
      CHECK(from_A > 2.0);
      dockByEarAndArrow(w);
      const double off_A = glm::distance(w.body().A, deepest.A);
      MESSAGE("from " << from_A << " A to " << off_A << " A");
      CHECK(off_A < 0.7);
    }
    BlindWindow other;  // one window at a time
    other.move(kStarts[k]);
    dockDeafAndBlind(other, k + 1);
    found_by_chance += glm::distance(other.body().A, deepest.A) < 0.7;
  }
  CHECK(found_by_chance <= 2);
}

TEST_CASE("a scene that draws nothing and hides the force shows no energy, and nothing hums; with the force both do") {
  for (const bool shown : {false, true}) {
    CAPTURE(shown);
    BlindWindow w(shown ? "hide: all\n" : "hide: all\nshow: atoms\n");
    w.move({0.0, 0.0, -1.0});
    REQUIRE(w.scene().log().latest().molecular_energy);
    REQUIRE(w.scene().log().latest().molecular_energy->total_kcal_mol() < -1.0);
    CHECK(w.d->shows("view/energy") == shown);
    CHECK(heardHum_Hz(w.heard()).has_value() == shown);
  }
}

}  // namespace moltact
