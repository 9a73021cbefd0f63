// What is held in forces between atoms: its lines and figures in the window against the test's own sums, the energy
// balance of a change while it is held, and the mouse that a well leads. Ticks run on the frames' clock.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "engine/bench/energies/double_sum.h"
#include "engine/haptics/field/minimise_pose.h"
#include "engine/render/glyphs.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

constexpr double kNewtonsPerKcalMolA = 4184.0 / 6.02214076e23 / 1e-10;  // 6.9477e-11

const std::string kHead =
    "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - 1hpv\n  - 1ubq\nauthor: A\nlicence: L\n---\n";
const std::string kDrug = "```scene\nmolecule: 1hpv\nin-hand: ligand\nforces: all\n";
const std::string kProbe = "```scene\nmolecule: 1ubq\nforces: all\nprobe-charge: 1\n";

struct HeldWindow {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;

  explicit HeldWindow(const std::string& scene, const std::string& more = "") {
    ScriptedUser::Options tall;
    tall.height = 1100;  // the whole touch tab is in view
    d = startWith(scratch.file("mine.md", kHead + "## One\n" + scene + more + "```\nText.\n").string(),
                  std::move(tall));
    d->app().panels.tabs.open("touch");
    d->frames(5);
  }
  HapticSession& scene() { return d->app().scene; }
  ServoSample latest() { return scene().log().latest(); }
  void pressAt(double x, double y, int frames) {
    d->point("view", x, y);
    d->frames(10);
    d->press();
    d->frames(frames);
  }
  /// Puts the mouse's hand and the body here, in the file's orientation, where they wait for a press.
  void placeAt(const Vec3& place) {
    d->app().scene.view().holdAt({PointA{place}, kNoRotation});
    d->frames(10);
  }
  /// Every tick of the last frame.
  const std::vector<ServoSample>& lastTicks() { return scene().servo().everyTick(); }
  /// Every tick of this number of frames.
  std::vector<ServoSample> ticks(int frames) {
    std::vector<ServoSample> out;
    for (int k = 0; k < frames; ++k) {
      d->frames(1);
      for (const ServoSample& s : scene().servo().everyTick()) out.push_back(s);
    }
    return out;
  }
  const PairField& field() { return *scene().forces().field(); }
  bench::DoubleSum sum(std::vector<PairAtom> held) {
    REQUIRE(field().model.kind == Dielectric::MehlerSolmajer);
    return bench::DoubleSum(field().places, field().atoms, std::move(held), field().model.cutoff_A, false);
  }
  double energyAt(const PoseA& pose) { return sum(field().held).at(pose).energy.total_kcal_mol(); }
};

// The numbers in a sentence, in order.
std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> out;
  for (std::size_t at = 0; at < text.size();) {
    const bool sign = text[at] == '-' && at + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 1]));
    if (!sign && !std::isdigit(static_cast<unsigned char>(text[at]))) {
      ++at;
      continue;
    }
    std::size_t length = 0;
    out.push_back(std::stod(text.substr(at), &length));
    at += length;
  }
  return out;
}

}  // namespace

TEST_CASE(
    "the clashes drawn are all pairs of atoms whose own Lennard-Jones sum is 1 kcal/mol or more, the hydrogen bonds "
    "lie "
    "between nitrogen and oxygen within 3.5 A, each line is dashed and says its length") {
  HeldWindow w(kDrug);
  std::size_t bonds = 0, clashes = 0;
  // In the crystal's pose, and pulled aside against its walls.
  for (const double aside : {0.0, 0.03, -0.03, 0.06}) {
    CAPTURE(aside);
    w.placeAt(w.scene().stage().body->middle.A);
    w.d->point("view", 0.5, 0.5);
    w.d->frames(3);
    w.d->press();
    w.d->frames(60);
    for (int k = 1; k <= 10 && aside != 0.0; ++k) w.d->point("view", 0.5 + aside * k / 10, 0.5);
    const ForceWatch& forces = w.scene().forces();
    const ViewScene picture = seenScene(w.d->app());
    const PoseA pose = w.latest().shownBody();
    const HeldBody& body = *w.scene().stage().body;
    const Molecule& m = *w.scene().stage().molecule;
    // Every pair of the forces' atoms, hydrogens with the atom that carries them.
    std::set<std::pair<std::uint32_t, std::uint32_t>> right, bonded, clashing;
    for (std::size_t a = 0; a < w.field().held.size(); ++a)
      for (std::size_t b = 0; b < w.field().atoms.size(); ++b) {
        const PairAtom &held = w.field().held[a], &other = w.field().atoms[b];
        const double r = glm::distance(pose.place.A + pose.orientation * held.centre_A, other.centre_A);
        const double six = std::pow((double(held.half_minimum_A) + double(other.half_minimum_A)) / r, 6.0);
        const double energy =
            std::sqrt(double(held.depth_kcal_mol) * double(other.depth_kcal_mol)) * (six * six - 2.0 * six);
        if (energy >= 1.0) right.insert({body.atoms[w.field().held_carriers[a]], w.field().carriers[b]});
      }
    for (const HeldLine& line : forces.lines()) {
      (line.clash ? clashing : bonded).insert({line.held, line.scene});
      CHECK(glm::distance(line.to.A, m.spheres[line.scene].centre_A) < 1e-9);
      if (line.clash) continue;
      CHECK(glm::distance(line.from.A, line.to.A) <= 3.5);
      for (const std::uint32_t atom : {line.held, line.scene})
        CHECK((m.atoms[atom].atomic_number == 7 || m.atoms[atom].atomic_number == 8));
    }
    for (const auto& pair : bonded) right.erase(pair);
    CHECK(clashing == right);
    bonds += bonded.size(), clashes += clashing.size();
    REQUIRE((picture.held_lines != nullptr) == !forces.lines().empty());
    if (picture.held_lines) {
      REQUIRE(picture.held_lines->measures.size() == forces.lines().size());
      for (std::size_t k = 0; k < forces.lines().size(); ++k) {
        const Annotations::Measure& drawn = picture.held_lines->measures[k];
        const HeldLine& line = forces.lines()[k];
        CHECK(drawn.line == (line.clash ? Annotations::Line::Clash : Annotations::Line::Bond));
        const std::vector<double> says = numbersIn(drawn.text);
        REQUIRE(says.size() == 1);
        CHECK(std::abs(says[0] - glm::distance(line.from.A, line.to.A)) < 0.0501);
      }
      ViewScene without = picture;
      without.held_lines.reset();
      Glyphs with_lines, bare;
      addGlyphs(picture, nullptr, with_lines);
      addGlyphs(without, nullptr, bare);
      CHECK(with_lines.strokes.lines().size() > bare.strokes.lines().size() + forces.lines().size());
    }
    w.d->release();
    w.d->frames(30);
  }
  MESSAGE(bonds, " hydrogen bonds and ", clashes, " clashes in four poses");
  CHECK(bonds > 0);
  CHECK(clashes > 0);
}

TEST_CASE(
    "the touch tab's figures: 1 N in the hand is the coupling's force in pN and kcal/mol/A, the force between the "
    "atoms "
    "is the slope of the sum in double precision, and the point on the curve is the atom of highest energy and its "
    "asinh") {
  // 100 N/m are 10 000 pN for each angstrom between hand and body.
  for (const auto& [more, coupling_pN_per_A] :
       {std::pair{"coupling: 100 N/m\n", 1e4}, std::pair{"coupling: 20 N/m\n", 2e3}}) {
    const std::string more_keys = more;
    CAPTURE(more_keys);
    HeldWindow w(kDrug, more_keys);
    w.placeAt(w.scene().stage().body->middle.A);
    w.pressAt(0.5, 0.5, 60);
    for (int k = 1; k <= 12; ++k) w.d->point("view", 0.5 + 0.004 * k, 0.5);
    const ServoSample s = w.latest();
    REQUIRE(glm::length(s.force.N) > 0.1);
    const double apart_A = glm::distance(s.shownBody().place.A, s.hip.A), felt_N = glm::length(s.wanted().force_N);
    const std::vector<double> scale = numbersIn(w.d->text("force_scale"));  // "1 N in the hand is 7,200 pN or ..."
    REQUIRE(scale.size() == 3);
    CHECK(scale[0] == 1.0);
    CHECK(scale[1] == doctest::Approx(coupling_pN_per_A * apart_A / felt_N).epsilon(0.01));
    CHECK(scale[2] == doctest::Approx(scale[1] * 1e-12 / kNewtonsPerKcalMolA).epsilon(0.01));

    // The slope of the energy without the bound of walls, by differences of 1e-4 A.
    bench::DoubleSum sum = w.sum(w.field().held);
    Vec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      PoseA up = s.shownBody(), down = up;
      up.place.A[axis] += 1e-4, down.place.A[axis] -= 1e-4;
      slope[axis] = (sum.at(up).energy.total_kcal_mol() - sum.at(down).energy.total_kcal_mol()) / 2e-4;
    }
    const std::vector<double> between = numbersIn(w.d->text("force_between"));
    REQUIRE(between.size() == 3);
    CHECK(std::abs(between[1] - glm::length(slope)) < 0.051 + 1e-3 * glm::length(slope));
    CHECK(between[0] == doctest::Approx(between[1] * kNewtonsPerKcalMolA * 1e12).epsilon(0.01).scale(10.0));
    CHECK(between[2] == doctest::Approx(scale[1] * glm::length(s.force.N)).epsilon(0.02));

    double highest = -1e300;
    for (const PairAtom& one : w.field().held)
      highest = std::max(highest, w.sum({one}).at(s.shownBody()).energy.total_kcal_mol());
    const std::vector<double> point = numbersIn(w.d->text("plot/felt_energy"));
    REQUIRE(point.size() == 2);
    CHECK(std::abs(point[0] - highest) < 0.051 + 1e-3 * std::abs(highest));
    CHECK(std::abs(point[1] - (highest > 0.0 ? std::asinh(highest) : highest)) < 0.052);
  }
}

namespace {

// The work of the force on the hand and the energy that coupling and field lose, from tick to tick at the scale and gain
// of the tick (unit: N mm).
struct Balance {
  double work = 0.0, lost = 0.0, greatest_step_N = 0.0, greatest_N = 0.0;

  void add(const ServoSample& from, const ServoSample& to, double A_per_mm) {
    const double k = to.molecular_energy->coupling_kcal_mol_A2, N_per_kcal_mol_A = to.spring_N_per_A / k;
    const Vec3 moved_mm = to.hand.mm - from.hand.mm;
    const double wanted_N = glm::length(to.wanted().force_N);
    const double gain = wanted_N > 1e-6 ? std::min(1.0, glm::length(to.force.N) / wanted_N) : 0.0;
    work += glm::dot(to.force.N, moved_mm);
    lost += gain * N_per_kcal_mol_A * (stored(from) - stored(to)) / A_per_mm;
    greatest_step_N = std::max(greatest_step_N, glm::distance(from.force.N, to.force.N));
    greatest_N = std::max(greatest_N, glm::length(to.force.N));
  }
  static double stored(const ServoSample& s) {
    const Vec3 away = s.shownBody().place.A - s.hip.A;
    return 0.5 * s.molecular_energy->coupling_kcal_mol_A2 * glm::dot(away, away) + s.molecular_energy->felt_kcal_mol;
  }
};

}  // namespace

TEST_CASE(
    "gain of weak forces, medium, coupling and stiffness are changed while a probe is held and pulled about: each "
    "change "
    "begins with less than 0.02 N or follows by less than 0.05 N in a tick, and the hand gets no more work than "
    "coupling "
    "and field lose") {
  HeldWindow w(kProbe);
  w.pressAt(0.5, 0.5, 150);
  REQUIRE(w.latest().molecular_energy);
  struct Change {
    std::string what;
    std::function<void(TouchSetup&)> make;
    bool begins;  // a new interaction, whose force starts softly
  };
  const auto gain = [](double g) { return [g](TouchSetup& t) { t.weak_gain = g; }; };
  const auto medium = [](const char* name) { return [name](TouchSetup& t) { t.dielectric = name; }; };
  const auto coupling = [](double c) { return [c](TouchSetup& t) { t.coupling_N_per_mm = c; }; };
  const auto stiffness = [](double k) { return [k](TouchSetup& t) { t.stiffness_N_per_mm = k; }; };
  const std::vector<Change> changes{{"gain 4", gain(4.0), true},
                                    {"stiffness 1.5", stiffness(1.5), false},
                                    {"gain 8", gain(8.0), true},
                                    {"gain 1", gain(1.0), true},
                                    {"vacuum", medium("vacuum"), true},
                                    {"stiffness 0.1", stiffness(0.1), false},
                                    {"water", medium("water"), true},
                                    {"coupling 50 N/m", coupling(0.05), true},
                                    {"distance", medium("distance"), true},
                                    {"coupling 2 N/m", coupling(0.002), true},
                                    {"stiffness 0.5", stiffness(0.5), false},
                                    {"water again", medium("water"), true}};
  double x = 0.5;
  double greatest_N = 0.0, moved_mm = 0.0;
  for (const Change& change : changes) {
    CAPTURE(change.what);
    ServoSample last = w.latest();
    TouchSetup touch = w.scene().touch();
    change.make(touch);
    w.scene().setTouch(touch);
    const double A_per_mm = w.scene().servo_settings.workspace.A_per_mm;
    Balance balance;
    // The old interaction may act in one more tick.
    int before_new = change.begins ? 2 : 0;
    std::size_t count = 0;
    for (int frame = 0; frame < 90; ++frame) {
      // The pointer wanders, so that the hand is pulled out of its balance and gives way. Each motion is one frame.
      x += frame % 30 < 15 ? 0.001 : -0.001;
      w.d->point("view", x, 0.5);
      for (const ServoSample& now : w.lastTicks()) {
        REQUIRE(now.molecular_energy);
        CHECK(now.contact.fault == Fault::None);
        if (before_new > 0) {
          if (glm::length(now.force.N) < 0.02)
            before_new = 0;
          else
            REQUIRE(--before_new > 0);
        } else if (now.tick == last.tick + 1 && now.scene == last.scene) {
          balance.add(last, now, A_per_mm);
        }
        moved_mm += glm::distance(now.hand.mm, last.hand.mm);
        last = now;
        ++count;
      }
    }
    CHECK(count > 1000);
    CAPTURE(balance.lost);
    CHECK(balance.work <= balance.lost + 0.01);  // 10 microjoules
    CHECK(balance.greatest_step_N < 0.05);
    greatest_N = std::max(greatest_N, balance.greatest_N);
    MESSAGE(change.what, ": work ", balance.work, " N mm, lost ", balance.lost, ", greatest step ",
            balance.greatest_step_N, " N of ", balance.greatest_N);
  }
  CHECK(greatest_N > 0.3);
  CHECK(moved_mm > 5.0);
}

namespace {

// Presses where the hand is, with the pointer at rest, until the well has drawn the hand in.
struct DrawnIn {
  ServoSample start, rest;
  double moved_A = 0.0, pull_N = 0.0, apart_A = 0.0;

  explicit DrawnIn(HeldWindow& w) {
    w.d->point("view", 0.5, 0.5);
    w.d->frames(20);
    start = w.latest();
    REQUIRE(start.molecular_energy);
    w.d->press();
    w.d->frames(400);
    rest = w.latest();
    REQUIRE(rest.contact.fault == Fault::None);
    moved_A = glm::distance(start.hip.A, rest.hip.A);
    pull_N = glm::length(rest.wanted().force_N);
    apart_A = glm::distance(rest.shownBody().place.A, rest.hip.A);
    // It stays there.
    w.d->frames(120);
    CHECK(glm::distance(w.latest().hip.A, rest.hip.A) < 0.1);
    CHECK(pull_N < PointerHand::kWell_N);
    CHECK(apart_A < 0.1);
  }
};

}  // namespace

TEST_CASE(
    "a mouse with the button held is drawn into wells of 1HPV and 1UBQ while the pointer stands still: amprenavir "
    "outside "
    "and a positive probe beside an acid, to an energy of the sum in double precision that is lower by 0.4 kcal/mol or "
    "more") {
  for (const bool drug : {true, false}) {
    CAPTURE(drug);
    HeldWindow w(drug ? kDrug : kProbe);
    if (!drug) {
      // 5 A outside the carboxyl carbon of glutamate 18.
      const Molecule& m = *w.scene().stage().molecule;
      Vec3 middle(0.0), carboxyl(0.0);
      for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
        middle += m.spheres[i].centre_A / double(m.atoms.size());
        if (m.residues[m.atoms[i].residue].number == 18 && m.atoms[i].nameText() == "CD")
          carboxyl = m.spheres[i].centre_A;
      }
      w.d->app().beginSceneAgain(PointA{carboxyl + 5.0 * glm::normalize(carboxyl - middle)});
      w.d->frames(10);
    }
    const DrawnIn drawn(w);
    const double before = w.energyAt(drawn.start.shownBody()), after = w.energyAt(drawn.rest.shownBody());
    MESSAGE((drug ? "drug" : "probe"), ": energy ", before, " to ", after, " kcal/mol, hand moved ", drawn.moved_A,
            " A, pull ", drawn.pull_N, " N, body ", drawn.apart_A, " A from the hand");
    CHECK(after < before - 0.4);
    CHECK(after < 0.0);
    CHECK(drawn.moved_A > 0.2);
  }
}

}  // namespace moltact
