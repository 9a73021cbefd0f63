// What the window shows of forces between atoms, and a change of these forces while something is held. Ticks run on the
// frames' clock.
#include <algorithm>
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/residue_forces.h"
#include "app/ui/panels/view_overlays.h"
#include "engine/haptics/field/coupled_field.h"
#include "engine/haptics/field/force_choices.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kHead =
    "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - 1hpv\n  - 1ubq\n  - argon\nauthor: A\nlicence: L\n---\n";

struct Window {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;

  explicit Window(const std::string& steps) {
    ScriptedUser::Options tall;
    tall.height = 1100;  // the whole touch tab is in view
    d = startWith(scratch.file("mine.md", kHead + steps).string(), std::move(tall));
    d->app().panels.tabs.open("touch");
    d->frames(5);
  }
  HapticSession& scene() { return d->app().scene; }
  void pressInView(int frames) {
    d->point("view");
    d->frames(10);
    d->press();
    d->frames(frames);
  }
  /// Every tick of this number of frames.
  std::vector<ServoSample> ticks(int frames) {
    std::vector<ServoSample> out;
    for (int k = 0; k < frames; ++k) {
      d->frames(1);
      for (const ServoSample& s : scene().servo().everyTick()) out.push_back(s);
    }
    return out;
  }
};

const std::string kDrug = "```scene\nmolecule: 1hpv\nin-hand: ligand\nforces: all\n```\n";
const std::string kProbe = "```scene\nmolecule: 1ubq\nforces: all\nprobe-charge: 1\n```\n";

double energy(const ServoSample& s) {
  const double k = s.molecular_energy->coupling_kcal_mol_A2;
  const Vec3 away = s.contact.scp.A - s.hip.A;
  return 0.5 * k * glm::dot(away, away) + s.molecular_energy->felt_kcal_mol;
}

}  // namespace

TEST_CASE(
    "van der Waals forces and charges are switched while a probe is held: it stays within 0.25 A a tick, the force "
    "rises from zero, and with the hand at rest the energy of coupling and field never rises") {
  Window w("## One\n" + kProbe + "Text.\n");
  w.pressInView(150);
  REQUIRE(w.scene().log().latest().molecular_energy);
  REQUIRE(w.scene().log().felt());
  std::size_t compared = 0;
  for (const char* forces : {"van-der-waals", "electrostatic", "all", "electrostatic", "van-der-waals", "all"}) {
    CAPTURE(forces);
    ServoSample last = w.scene().log().latest();
    TouchSetup touch = w.scene().touch();
    touch.forces = forces;
    w.scene().setTouch(touch);
    const std::vector<ServoSample> ticks = w.ticks(60);
    REQUIRE(ticks.size() > 500);
    bool first = true;
    double greatest_N = 0.0;
    for (const ServoSample& now : ticks) {
      REQUIRE(now.molecular_energy);
      CHECK(now.contact.fault == Fault::None);
      // The new interaction is led to the place of the old one and makes a step of its own before its first tick.
      CHECK(glm::distance(now.contact.scp.A, last.contact.scp.A) <= (first ? 2.0 : 1.0) * CoupledField::kStep_A + 1e-9);
      if (first)
        CHECK(glm::length(now.force.N) < 0.02);
      else if (now.hip == last.hip) {
        CHECK(energy(now) <= energy(last) + 3e-3);
        ++compared;
      }
      greatest_N = std::max(greatest_N, glm::length(now.force.N));
      first = false;
      last = now;
    }
    CHECK(greatest_N > 0.1);  // it is still held
  }
  CHECK(compared > 1000);
}

TEST_CASE(
    "amprenavir in the hand keeps its place and its turn while the forces are switched, also where it touches "
    "nothing") {
  Window w("## One\n" + kDrug + "Text.\n");
  w.pressInView(120);
  for (const bool pressed : {true, false}) {
    CAPTURE(pressed);
    if (!pressed) {
      w.d->release();
      w.d->frames(60);
    }
    for (const char* forces : {"electrostatic", "van-der-waals", "all"}) {
      CAPTURE(forces);
      const PoseA before = w.scene().log().latest().shownBody();
      TouchSetup touch = w.scene().touch();
      touch.forces = forces;
      w.scene().setTouch(touch);
      const std::vector<ServoSample> ticks = w.ticks(2);
      const PoseA after = ticks.front().shownBody();
      CHECK(glm::distance(after.place.A, before.place.A) <= 2.0 * CoupledField::kStep_A + 1e-9);
      CHECK(glm::length(rotationBetween(before.orientation, after.orientation)) < 0.2);
      w.d->frames(20);
    }
  }
}

TEST_CASE(
    "the touch tab switches the forces by one control, shows the curve of the felt energy with the highest energy of "
    "an "
    "atom on it, and nothing of it where no forces act") {
  Window w("## One\n" + kDrug + "Text.\n## Two\n```scene\nmolecule: argon\n```\nText.\n");
  w.pressInView(90);
  REQUIRE(w.d->shows("plot/felt_energy"));
  REQUIRE(w.scene().forces().highest_kcal_mol());
  CHECK_FALSE(w.d->text("plot/felt_energy").empty());
  w.d->release();
  w.d->frames(30);
  REQUIRE(w.d->shows("forces_felt/Van der Waals"));
  REQUIRE(w.d->click("forces_felt/Van der Waals"));
  w.d->frames(5);
  CHECK(w.scene().touch().forces == "van-der-waals");
  w.pressInView(90);
  CHECK_FALSE(w.scene().forces().residues().empty());
  for (const EnergyShare& one : w.scene().forces().residues()) CHECK(one.parts[EnergyPart::Electrostatic] == 0.0);
  w.d->release();
  w.d->frames(30);
  REQUIRE(w.d->click("forces_felt/All"));
  w.d->frames(5);
  CHECK(w.scene().touch().forces == "all");
  w.d->app().lesson.next();
  w.d->frames(10);
  for (const char* widget : {"plot/felt_energy", "forces_felt/All", "residue_forces"}) CHECK_FALSE(w.d->shows(widget));
  CHECK_FALSE(w.scene().forces().on());
}

TEST_CASE(
    "the residues that act most add up to the energy of the sample and are listed by their amounts, and their atoms "
    "glow") {
  Window w("## One\n" + kDrug + "Text.\n");
  w.pressInView(120);
  const ForceWatch& forces = w.scene().forces();
  REQUIRE(forces.residues().size() > kListedResidues);
  EnergyByPart sum;
  double before = 1e300;
  for (const EnergyShare& one : forces.residues()) {
    CHECK(std::abs(one.total_kcal_mol()) <= before);
    before = std::abs(one.total_kcal_mol());
    sum += one.parts;
  }
  const MolecularEnergy& whole = *w.scene().log().latest().molecular_energy;
  // Residues below 0.05 kcal/mol are left out.
  for (const EnergyPartInfo& part : energyParts())
    CHECK(sum[part.part] == doctest::Approx(whole.parts[part.part]).epsilon(0.02).scale(10.0));
  REQUIRE(w.d->shows("residue_forces"));
  const std::string list = w.d->text("residue_forces");
  const Residue& first = w.scene().stage().molecule->residues[forces.residues().front().index];
  CHECK(list.find(" " + std::to_string(first.number) + " ") < list.find(';'));
  CHECK(std::count(list.begin(), list.end(), ';') == std::ptrdiff_t(kListedResidues) - 1);
  const ViewScene picture = seenScene(w.d->app());
  CHECK_FALSE(picture.attracting.empty());
  for (const LoadedAtom& one : picture.attracting) {
    const std::uint32_t residue = picture.molecule->atoms[one.atom].residue;
    const auto top = std::find_if(forces.residues().begin(), forces.residues().begin() + kListedResidues,
                                  [&](const EnergyShare& r) { return r.index == residue; });
    REQUIRE(top != forces.residues().begin() + kListedResidues);
    CHECK(top->total_kcal_mol() < 0.0);
  }
}

TEST_CASE(
    "while a question of the step is open, no residue is listed, none glows and no line is drawn; once it is answered "
    "they are") {
  Window w("## One\n" + kDrug + "Text.\n\n### Question: Which one?\n\n- [x] This → Yes.\n- [ ] That → No.\n");
  w.pressInView(120);
  const auto shown = [&] {
    w.d->frames(3);
    const ViewScene picture = seenScene(w.d->app());
    const bool list = w.d->shows("residue_forces");
    CHECK(list == !picture.attracting.empty());
    if (!list) CHECK((picture.repelling.empty() && !picture.held_lines));
    return list;
  };
  REQUIRE(w.scene().forces().on());
  CHECK_FALSE(shown());
  CHECK(w.d->shows("plot/energy"));  // names nothing
  LessonSession& session = *w.d->app().lesson.session();
  for (std::size_t choice = 0; choice < 2 && !session.question(0).done(); ++choice) session.choose(0, {choice});
  REQUIRE(session.question(0).done());
  CHECK(shown());
}

TEST_CASE("what is wrong with the charges of a scene with forces is said once, and not where no forces act") {
  for (const bool forces : {true, false}) {
    CAPTURE(forces);
    Scratch scratch;
    scratch.file(
        "ions.pqr",
        "ATOM 1 N ALA A 1 0 0 0 -0.5 1.8\nATOM 2 CA ALA A 1 1.5 0 0 0.5 1.8\nATOM 3 CB ALA A 1 3 0 0 0.3 1.8\n");
    const auto d = startWith(
        scratch
            .file("mine.md",
                  "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - ions.pqr\nauthor: A\nlicence: L\n---\n"
                  "## One\n```scene\nmolecule: ions.pqr\n" +
                      std::string(forces ? "forces: all\nprobe-charge: 1\n" : "") + "```\nText.\n")
            .string());
    d->frames(30);
    const auto& messages = d->app().messages.all();
    CHECK(std::count_if(messages.begin(), messages.end(), [](const Message& m) {
            return contains(m.text, "the net charge is 0.30 e from a whole number");
          }) == (forces ? 1 : 0));
  }
}

}  // namespace moltact
