// rank: hold several ligands in turn, each in its own place, in the dark unless the author chooses otherwise. Pull at
// each and put them in order of how firmly the forces between atoms bind them. The ligands come in a different order
// for each student and each round. What counts as felt depends on the hand's way alone, never on a force, so that no
// word tells how firmly a ligand is bound.
#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "engine/core/random.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxLigands = 4;
// Between the wells of two ligands lie at least so many kcal/mol, or the deeper one is so many times as deep.
constexpr double kFirmer_kcal_mol = 2.0, kFirmerTimes = 3.0;
constexpr double kBesidePlace_A = 2.0;   // so far from the file's pose a well belongs to it (rms of the atoms)
constexpr int kFallsAtLigand = 6;        // into the well of each
constexpr double kPulls_A = 0.5;         // so far from the place a hand pulls; nearer it holds the ligand there
constexpr double kDemonstrated_A = 0.5;  // of a demonstrated pull, as a share of `within`
constexpr double kPulled_A_per_s = 2.0;

struct LigandWords {
  std::string_view word, label;
  char key;
};
constexpr std::array<LigandWords, kMaxLigands> kLigandWords{{{"ligand-1", N_("Ligand 1"), '1'},
                                                             {"ligand-2", N_("Ligand 2"), '2'},
                                                             {"ligand-3", N_("Ligand 3"), '3'},
                                                             {"ligand-4", N_("Ligand 4"), '4'}}};

/// The deepest well at the place that the ligand has in the molecule's file; empty if it overlaps other atoms there, or no
/// force reaches it.
std::optional<Well> wellOf(const SceneForces& forces) {
  const std::vector<Well> wells = wellsBeside(PoseGoal(forces.body(), PoseA{forces.body()->middle}),
                                              {kBesidePlace_A, std::numbers::pi}, forces, kFallsAtLigand);
  return wells.empty() ? std::nullopt : std::optional(wells.front());
}

class Rank : public Task {
 public:
  explicit Rank(const TaskSpec& spec)
      : Task(spec),
        parts_(spec.values["rank"].path),
        first_(spec.values["first"].text),
        time_s_(spec.values["for"].number),
        within_A_(spec.values["within"].number),
        dark_(spec.values["dark"].text == "yes"),
        meter_(spec.values["meter"].text == "on") {
    if (parts_.size() > kMaxLigands) parts_.resize(kMaxLigands);
  }

  // The order is that of the wells, the deepest first, whatever the author wrote.
  void takeForces(std::shared_ptr<const SceneForces> forces) override {
    ligands_.clear();
    for (const Selection& part : parts_) {
      const auto body = heldBody(forces->molecule(), part.select(forces->molecule()));
      if (!body) continue;
      const std::optional<Well> well = wellOf(*forces->holding(body));
      ligands_.push_back({TargetName(part, forces->molecule()), body, well ? well->pose : PoseA{body->middle},
                          well ? well->energy.total_kcal_mol() : 0.0});
    }
    outside_ = 0.5 * (forces->spheres().low_A() + forces->spheres().high_A());
    std::stable_sort(ligands_.begin(), ligands_.end(),
                     [](const Ligand& a, const Ligand& b) { return a.energy_kcal_mol < b.energy_kcal_mol; });
    shuffle();
  }

  void drawBy(std::uint64_t seed) override {
    state_ = seed;
    shuffle();
  }

  void reset() override {
    Task::reset();
    rounds_ = 1;
    failed_ = false;
    shuffle();
    feelFromTheFirst();
  }

 private:
  struct Ligand {
    TargetName name;
    std::shared_ptr<const HeldBody> body;
    PoseA place;  // its well's
    double energy_kcal_mol = 0.0;
  };

  void shuffle() {
    shown_.resize(ligands_.size());
    std::iota(shown_.begin(), shown_.end(), std::size_t{0});
    // Fisher-Yates shuffle.
    for (std::size_t k = shown_.size(); k > 1; --k) std::swap(shown_[k - 1], shown_[nextRandom(state_) % k]);
  }

  void feelFromTheFirst() {
    at_ = 0;
    picked_.clear();
    felt_s_ = 0.0;
    present();
    setProgress(0.0);
  }

  // The hand begins in the ligand's place again.
  void present() {
    ++presentation_;
    put_down_ = begun_ = pulled_ = false;
    off_A_ = 0.0;
  }

  bool feeling() const { return at_ < ligands_.size(); }
  const Ligand& shownLigand(std::size_t k) const { return ligands_[shown_[std::min(k, ligands_.size() - 1)]]; }

  // Ticks of the ligand before may arrive until this one is put into the hand.
  void onSample(const TouchSample& s, double dt_s) override {
    if (s.contact_reset) put_down_ = true, begun_ = false;
    if (!feeling() || !put_down_ || !s.body) return;
    off_A_ = glm::distance(s.hip.A, shownLigand(at_).place.place.A);
    begun_ = !s.hovering && (begun_ || off_A_ <= kPulls_A);
    // Once it has pulled: a mouse's hand yields in a well, however far away its target is.
    pulled_ = begun_ && (pulled_ || off_A_ >= kPulls_A);
    if (pulling()) felt_s_ = std::min(time_s_, felt_s_ + dt_s);
  }

  bool pulling() const { return pulled_ && off_A_ <= within_A_; }

  std::vector<TaskButton> currentButtons() const override {
    if (ligands_.empty()) return {};
    std::vector<TaskButton> out;
    if (feeling()) {
      if (felt_s_ >= time_s_)
        out.push_back({"next", at_ + 1 < ligands_.size() ? N_("Take the next ligand") : N_("Put them in order")});
      out.push_back({"anew", N_("Hold it in its place again"), 'L'});
      return out;
    }
    for (std::size_t k = 0; k < ligands_.size(); ++k)
      if (std::find(picked_.begin(), picked_.end(), k) == picked_.end())
        out.push_back({kLigandWords[k].word, kLigandWords[k].label, kLigandWords[k].key});
    out.push_back({"again", N_("Feel them once more"), 'L'});
    return out;
  }

  TaskStage requestedStage() const override {
    if (ligands_.empty()) return {};
    TaskStage stage{.dark = dark_, .unnamed = true, .force_meter = meter_, .presentation = presentation_};
    const Ligand& held = shownLigand(at_);
    stage.in_hand = held.body->atoms;
    stage.facing = held.place.place;
    stage.body_begins = held.place.place;
    stage.body_turned = held.place.orientation;
    return stage;
  }

  void onAnswer(const TaskAnswer& answer) override {
    if (answer.word == "again") return feelFromTheFirst();
    if (answer.word == "anew") return present();
    if (answer.word == "next") {
      ++at_;
      // The last ligand stays in the hand while the student enters the order.
      if (feeling()) {
        felt_s_ = 0.0;
        present();
      }
      return setProgress(0.5 * double(at_) / double(ligands_.size()));
    }
    for (std::size_t k = 0; k < ligands_.size(); ++k)
      if (kLigandWords[k].word == answer.word) picked_.push_back(k);
    setProgress(0.5 + 0.5 * double(picked_.size()) / double(ligands_.size()));
    if (picked_.size() + 1 < ligands_.size()) return;
    // The remaining ligand is the last one.
    for (std::size_t k = 0; k < ligands_.size(); ++k)
      if (std::find(picked_.begin(), picked_.end(), k) == picked_.end()) picked_.push_back(k);
    std::size_t right = 0;
    for (std::size_t k = 0; k < picked_.size(); ++k) right += shown_[picked_[k]] == k;
    if (first_right_ < 0) first_right_ = static_cast<int>(right);
    if (right == ligands_.size()) return finish();
    if (missedLast()) return;
    failed_ = true;
    ++rounds_;
    shuffle();
    feelFromTheFirst();
  }

  std::string guidance() const override {
    const std::size_t n = ligands_.size();
    if (n == 0) return tr("There is no ligand to hold.");
    if (!feeling()) return picked_.empty() ? trf("Which ligand is {0}?", first_) : tr("And which one comes next?");
    if (felt_s_ >= time_s_)
      return at_ + 1 < n ? trf("That was ligand {0} of {1}. Take the next one.", at_ + 1, n)
                         : tr("You have felt them all. Now put them in order.");
    if (begun_ && off_A_ > within_A_)
      return trf("The hand is {0} from the place. Come back to within {1}.", lengthText(off_A_), lengthText(within_A_));
    if (pulling() || felt_s_ > 0.0)
      return trf("Pull at ligand {0} of {1} in every direction: {2} of {3}.", at_ + 1, n, timeText(felt_s_),
                 timeText(time_s_));
    const std::string pull = trf("Take ligand {0} of {1} in its place and pull at it.", at_ + 1, n);
    return failed_ && at_ == 0
               ? trf("That was not the order. Feel the ligands again, they are numbered anew. {0}", pull)
               : pull;
  }

  static std::string lengthText(double length_A) { return quantityText(length_A, Dimension::Length, decimals(1)); }

  std::string solution() const override {
    std::string names;
    for (const Ligand& l : ligands_) names += (names.empty() ? "" : ", ") + l.name.text();
    return trf("The order is: {0}.", names);
  }

  HandPlan demonstrate(const HandPlanInput&) const override {
    HandPlan plan;
    if (ligands_.empty()) return plan;
    if (feeling()) {
      const PoseA& place = shownLigand(at_).place;
      Vec3 way = place.place.A - outside_;
      way = glm::length(way) > 1e-6 ? glm::normalize(way) : Vec3(0.0, 0.0, 1.0);
      plan.push_back({.to = place.place, .turned_to = place.orientation, .placed = true, .wait_s = 0.2});
      plan.push_back({.to = PointA{place.place.A + way * std::max(kPulls_A + 0.2, kDemonstrated_A * within_A_)},
                      .speed_A_per_s = kPulled_A_per_s,
                      .wait_s = time_s_ + 0.1});
      plan.push_back({.answer = TaskAnswer{.word = "next"}});
      return plan;
    }
    for (std::size_t k = 0; k < ligands_.size(); ++k)
      if (shown_[k] == picked_.size())
        plan.push_back({.answer = TaskAnswer{.word = std::string(kLigandWords[k].word)}});
    return plan;
  }

  void measure(std::vector<TaskFigure>& out) const override {
    if (first_right_ >= 0) out.push_back({N_("ligands in order at first"), double(first_right_), ""});
    out.push_back({N_("rounds"), double(rounds_), ""});
  }

  std::vector<Selection> parts_;
  std::vector<Ligand> ligands_;      // in the right order
  std::vector<std::size_t> shown_;   // the indices of ligand 1, 2, … in `ligands_`
  std::vector<std::size_t> picked_;  // numbers of the ligands in the student's order
  std::string first_;
  double time_s_ = 3.0, within_A_ = 4.0, felt_s_ = 0.0;
  bool dark_ = true, meter_ = true, failed_ = false;
  bool put_down_ = false;    // this ligand is in the hand
  bool begun_ = false;       // the hand took it in its place and has not let go since
  bool pulled_ = false;      // and it has been kPulls_A off since
  double off_A_ = 0.0;       // from the hand to the place
  Vec3 outside_{0.0};        // the scene's middle: a demonstrated pull leads away from it
  std::uint64_t state_ = 0;  // of the random generator
  std::size_t at_ = 0;       // the ligand that is being felt; their number while the student enters the order
  int presentation_ = 1, rounds_ = 1, first_right_ = -1;
};

void checkRank(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value& rank = spec.values["rank"];
  const std::size_t n = rank.path.size();
  if (n < 2)
    problems.push_back(problemAt(rank.place, tr("at least two ligands are needed for an order"),
                                 tr("write them parted by 'then': 'rank: residue 201 then residue 202'")));
  else if (n > kMaxLigands)
    problems.push_back(problemAt(rank.place, trf("more than {0} ligands", kMaxLigands),
                                 tr("remove some: students cannot remember so many")));
}

// While one ligand is in the hand the others must not be there: each is what the scene puts into the hand or removes.
void checkRankedLigands(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                        std::vector<Problem>& problems) {
  const Value& rank = spec.values["rank"];
  std::vector<std::vector<std::uint32_t>> all;
  for (std::size_t k = 0; k < rank.path.size(); ++k) {
    all.push_back(rank.path[k].select(molecule));
    const std::vector<std::uint32_t>& atoms = all.back();
    if (atoms.empty()) return;  // reported elsewhere
    if (!std::includes(untouchable.begin(), untouchable.end(), atoms.begin(), atoms.end()))
      problems.push_back(problemAt(rank.places[k],
                                   tr("this ligand would be in the way of the others: it is part of the scene"),
                                   tr("add it to 'remove' in this step's scene, or to 'in-hand'")));
    if (atoms.size() > kMaxHeldAtoms)
      problems.push_back(problemAt(
          rank.places[k], trf("{0} atoms are more than a hand can hold; {1} are the most", atoms.size(), kMaxHeldAtoms),
          tr("name fewer: a ligand, a side chain")));
    for (std::size_t before = 0; before < k; ++before)
      if (std::find_first_of(atoms.begin(), atoms.end(), all[before].begin(), all[before].end()) != atoms.end())
        problems.push_back(problemAt(rank.places[k], tr("two of the ligands share atoms"), tr("name another ligand")));
  }
}

void checkRankScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (!scene.in_hand.given())
    problems.push_back(problemAt(spec.place, tr("'rank' needs a body in the hand"),
                                 tr("write 'in-hand: …' with one of the ligands in this step's scene")));
  else if (!forceChoice(scene.touch.forces).any())
    problems.push_back(problemAt(spec.place, tr("nothing holds the ligands: no forces between atoms act in this scene"),
                                 tr("write 'forces: all' in this step's scene")));
  else if (!(scene.touch.coupling_N_per_mm > 0.0))
    problems.push_back(problemAt(spec.place,
                                 tr("each ligand would hang on a spring of another stiffness, by its number of atoms"),
                                 tr("write one for all in this step's scene, such as 'coupling: 30 N/m'")));
}

void checkRankForces(const TaskSpec& spec, const SceneForces& forces, std::vector<Problem>& problems) {
  const Value& rank = spec.values["rank"];
  std::vector<std::pair<double, std::size_t>> energies;
  for (std::size_t k = 0; k < rank.path.size(); ++k) {
    const auto body = heldBody(forces.molecule(), rank.path[k].select(forces.molecule()));
    if (!body) return;
    const std::optional<Well> well = wellOf(*forces.holding(body));
    if (!well || well->energy.total_kcal_mol() >= 0.0) {
      problems.push_back(
          problemAt(rank.places[k],
                    tr("this ligand is not bound in its place: it overlaps other atoms there, or nothing "
                       "attracts it"),
                    tr("give the file another pose of it, or name another ligand")));
      continue;
    }
    energies.emplace_back(well->energy.total_kcal_mol(), k);
  }
  std::sort(energies.begin(), energies.end());
  for (std::size_t k = 1; k < energies.size(); ++k)
    if (energies[k].first - energies[k - 1].first < kFirmer_kcal_mol &&
        energies[k - 1].first > kFirmerTimes * energies[k].first)
      problems.push_back(problemAt(rank.places[energies[k].second],
                                   trf("two ligands are bound nearly alike, by {0} and {1}",
                                       energyText(energies[k - 1].first), energyText(energies[k].first)),
                                   tr("name another ligand, or choose other forces")));
}

}  // namespace

TaskKind rankKind() {
  return {
      .name = "rank",
      .meaning = "Hold several ligands in turn, each in its place, and put them in order of how firmly they are bound.",
      .time = {.base_s = 20.0, .each_s = 35.0, .each = "rank", .each_what = "ligand"},
      .keys = {{.name = "rank",
                .type = ValueType::Path,
                .meaning =
                    "The ligands, two to four, separated by 'then', each in its pose of the molecule's file; they "
                    "may overlap each other. One is the scene's `in-hand`, the others are in `remove`; the program "
                    "computes the right order from their energies.",
                .required = true},
               {.name = "first",
                .type = ValueType::Text,
                .meaning = "A description of the first ligand, inside a sentence: 'the one bound most firmly'.",
                .required = true},
               {.name = "for",
                .type = ValueType::Quantity,
                .meaning =
                    "The minimum time to feel each ligand, from when the hand has first pulled by 0.5 Å from the "
                    "place in which it took it.",
                .fallback = "3 s",
                .dimension = Dimension::Time,
                .min = 0.1,
                .max = 60.0},
               {.name = "within",
                .type = ValueType::Quantity,
                .meaning = "So far the hand may be from the place meanwhile.",
                .fallback = "4 Å",
                .dimension = Dimension::Length,
                .min = 1.0,
                .max = 20.0},
               darkKey(),
               meterKey(),
               attemptsKey("How many orders the student may give; by default unlimited. After the last wrong one the "
                           "right one is shown, and the student continues.")},
      .make = [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Rank>(s); },
      .check = &checkRank,
      .check_molecule = &checkRankedLigands,
      .check_scene = &checkRankScene,
      .of_body = "each ligand is held in turn; the hand's distance from its place counts.",
      .check_forces = &checkRankForces,
      .names_held = true};
}

}  // namespace moltact
