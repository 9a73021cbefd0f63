// order: feel several places in turn, in the dark unless the author says otherwise, and put them in order. The places
// come in a different order for each student and each round.
#include <algorithm>
#include <array>
#include <numeric>

#include "engine/core/random.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxPlaces = 6;
constexpr std::string_view kByEnergy = "energy";
constexpr double kApart_kcal_mol = 0.5;  // between the wells of two places, at least

struct PlaceWords {
  std::string_view word, label;
  char key;
};
constexpr std::array<PlaceWords, kMaxPlaces> kPlaceWords{{{"place-1", N_("Place 1"), '1'},
                                                          {"place-2", N_("Place 2"), '2'},
                                                          {"place-3", N_("Place 3"), '3'},
                                                          {"place-4", N_("Place 4"), '4'},
                                                          {"place-5", N_("Place 5"), '5'},
                                                          {"place-6", N_("Place 6"), '6'}}};

/// The energy of the probe's deepest well at these atoms, 0 if there is none.
double wellEnergy_kcal_mol(const SceneForces& forces, const AtSurface& surface) {
  constexpr int kFallsAtPlace = 12;
  const double probe_A = forces.touch().probe_A;
  const auto near = [&](const Vec3& place) { return surface.near(place, probe_A); };
  double lowest = 0.0;
  for (const Well& w : forces.wells(kFallsAtPlace, {}, near))
    if (near(w.pose.place.A)) lowest = std::min(lowest, w.energy.total_kcal_mol());
  return lowest;
}

class Order : public Task {
 public:
  Order(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        first_(spec.values["first"].text),
        time_s_(spec.values["for"].number),
        by_energy_(spec.values["by"].text == kByEnergy),
        dark_(spec.values["dark"].text == "yes"),
        meter_(spec.values["meter"].text == "on") {
    for (const Selection& part : spec.values["order"].path) {
      if (places_.size() == kMaxPlaces) break;
      PointA middle;
      const std::vector<std::uint32_t> atoms = part.select(molecule);
      for (const std::uint32_t a : atoms) middle.A += molecule.spheres[a].centre_A / double(atoms.size());
      places_.push_back({part, AtomSet(part, molecule), middle, TargetName(part)});
    }
    shuffle();
  }

  // By energy the order is that of the wells, the deepest first, whatever the author wrote.
  void takeForces(std::shared_ptr<const SceneForces> forces) override {
    for (Place& p : places_) p.surface.emplace(p.part, forces->molecule());
    if (!by_energy_) return;
    for (Place& p : places_) p.energy_kcal_mol = wellEnergy_kcal_mol(*forces, *p.surface);
    std::stable_sort(places_.begin(), places_.end(),
                     [](const Place& a, const Place& b) { return a.energy_kcal_mol < b.energy_kcal_mol; });
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
    again();
  }

 private:
  struct Place {
    Selection part;
    AtomSet atoms;
    PointA middle;
    TargetName name;
    std::optional<AtSurface> surface = {};  // if forces between atoms act in the scene
    double energy_kcal_mol = 0.0;           // of the probe's deepest well there, if that orders the places
  };

  void shuffle() {
    shown_.resize(places_.size());
    std::iota(shown_.begin(), shown_.end(), std::size_t{0});
    // Fisher-Yates shuffle.
    for (std::size_t k = shown_.size(); k > 1; --k) std::swap(shown_[k - 1], shown_[nextRandom(state_) % k]);
  }

  void again() {
    shuffle();
    feelFromTheFirst();
  }

  void feelFromTheFirst() {
    at_ = 0;
    picked_.clear();
    present();
    setProgress(0.0);
  }

  void present() {
    ++presentation_;
    felt_s_ = 0.0;
    touching_ = beside_ = false;
  }

  bool feeling() const { return at_ < places_.size(); }
  const Place& shownPlace(std::size_t k) const { return places_[shown_[std::min(k, places_.size() - 1)]]; }

  void onSample(const TouchSample& s, double dt_s) override {
    // In a field each place counts as felt under the same conditions, whatever the forces there.
    const Place* place = feeling() ? &shownPlace(at_) : nullptr;
    const bool here = place && (place->surface ? place->surface->has(s) : place->atoms.touchedBy(s.contact));
    touching_ = here || s.contact.touching();
    if (!place) return;
    beside_ = touching_ && !here;
    if (touching_ && !beside_) felt_s_ = std::min(time_s_, felt_s_ + dt_s);
  }

  std::vector<TaskButton> currentButtons() const override {
    if (feeling()) {
      if (felt_s_ < time_s_) return {};
      return {{"next", at_ + 1 < places_.size() ? N_("Feel the next place") : N_("Put them in order")}};
    }
    std::vector<TaskButton> out;
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (std::find(picked_.begin(), picked_.end(), k) == picked_.end())
        out.push_back({kPlaceWords[k].word, kPlaceWords[k].label, kPlaceWords[k].key});
    out.push_back({"again", N_("Feel them once more"), 'L'});
    return out;
  }

  TaskStage requestedStage() const override {
    if (places_.empty()) return {};
    TaskStage stage{.dark = dark_, .unnamed = true, .force_meter = meter_, .presentation = presentation_};
    stage.facing = shownPlace(at_).middle;
    return stage;
  }

  void onAnswer(const TaskAnswer& answer) override {
    if (answer.word == "again") {
      feelFromTheFirst();
      return;
    }
    if (answer.word == "next") {
      ++at_;
      // The last place stays in view while the student enters the order.
      if (feeling()) present();
      setProgress(0.5 * double(at_) / double(places_.size()));
      return;
    }
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (kPlaceWords[k].word == answer.word) picked_.push_back(k);
    setProgress(0.5 + 0.5 * double(picked_.size()) / double(places_.size()));
    if (picked_.size() + 1 < places_.size()) return;
    // The remaining place is the last one.
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (std::find(picked_.begin(), picked_.end(), k) == picked_.end()) picked_.push_back(k);
    std::size_t right = 0;
    for (std::size_t k = 0; k < picked_.size(); ++k) right += shown_[picked_[k]] == k;
    if (first_right_ < 0) first_right_ = static_cast<int>(right);
    if (right == places_.size()) {
      finish();
      return;
    }
    if (missedLast()) return;
    failed_ = true;
    ++rounds_;
    again();
  }

  std::string guidance() const override {
    const std::size_t n = places_.size();
    if (!feeling()) return picked_.empty() ? trf("Which place is {0}?", first_) : tr("And which one comes next?");
    if (felt_s_ >= time_s_)
      return at_ + 1 < n ? trf("That was place {0} of {1}. Go on to the next.", at_ + 1, n)
                         : tr("You have felt them all. Now put them in order.");
    if (beside_) return tr("You are beside the place. It lies in the middle of the view: let go, and push there.");
    if (touching_) return trf("Feel place {0} of {1}: {2} of {3}.", at_ + 1, n, timeText(felt_s_), timeText(time_s_));
    const std::string touch = trf("Touch place {0} of {1}: push in the middle of the view.", at_ + 1, n);
    return failed_ && at_ == 0
               ? trf("That was not the order. Feel the places again, they are numbered anew. {0}", touch)
               : touch;
  }

  std::string solution() const override {
    std::string names;
    for (const Place& p : places_) names += (names.empty() ? "" : ", ") + p.name.text();
    return trf("The order is: {0}.", names);
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    if (feeling()) {
      const auto place = placeFor(view, placesToTouch(view, shownPlace(at_).atoms));
      if (!place) return plan;
      comeTo(plan, *place, depthFor(view, 0.4), time_s_ + 0.1);
      plan.push_back({.answer = TaskAnswer{.word = "next"}});
      return plan;
    }
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (shown_[k] == picked_.size()) plan.push_back({.answer = TaskAnswer{.word = std::string(kPlaceWords[k].word)}});
    return plan;
  }

  void measure(std::vector<TaskFigure>& out) const override {
    if (first_right_ >= 0) out.push_back({N_("places in order at first"), double(first_right_), ""});
    out.push_back({N_("rounds"), double(rounds_), ""});
  }

  std::vector<Place> places_;        // in the right order
  std::vector<std::size_t> shown_;   // the indices of place 1, 2, … in `places_`
  std::vector<std::size_t> picked_;  // numbers of the places in the student's order
  std::string first_;
  double time_s_ = 1.0, felt_s_ = 0.0;
  bool by_energy_ = false;
  bool dark_ = true, meter_ = true, touching_ = false, beside_ = false, failed_ = false;
  std::uint64_t state_ = 0;  // of the random generator
  std::size_t at_ = 0;       // the place that is being felt; the number of places while the student enters the order
  int presentation_ = 1, rounds_ = 1, first_right_ = -1;
};

void checkOrder(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value& order = spec.values["order"];
  const std::size_t n = order.path.size();
  if (n < 2)
    problems.push_back(problemAt(order.place, tr("at least two places are needed for an order"),
                                 tr("write them parted by 'then': 'order: residue 4 then residue 9'")));
  else if (n > kMaxPlaces)
    problems.push_back(problemAt(order.place, trf("more than {0} places", kMaxPlaces),
                                 tr("remove some: students cannot remember so many")));
}

// Checks against the atoms: places that coincide, and sizes in the stated order.
void checkOrderedPlaces(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> /*untouchable*/,
                        std::vector<Problem>& problems) {
  const Value& order = spec.values["order"];
  std::vector<std::vector<std::uint32_t>> atoms;
  std::vector<double> radii_A;
  for (std::size_t k = 0; k < order.path.size(); ++k) {
    atoms.push_back(order.path[k].select(molecule));
    if (atoms.back().empty()) return;  // reported elsewhere
    double sum = 0.0;
    for (const std::uint32_t a : atoms.back()) sum += molecule.spheres[a].radius_A;
    radii_A.push_back(sum / double(atoms.back().size()));
    for (std::size_t before = 0; before < k; ++before)
      if (atoms[before] == atoms[k])
        problems.push_back(
            problemAt(order.places[k], tr("two of the places are the same atoms"), tr("name another place")));
  }
  const std::string& by = spec.values["by"].text;
  if (by != "size") return;
  const bool up = std::is_sorted(radii_A.begin(), radii_A.end()),
             down = std::is_sorted(radii_A.rbegin(), radii_A.rend());
  if (!up && !down)
    problems.push_back(problemAt(order.place, tr("the radii of the places' atoms neither grow nor fall in this order"),
                                 tr("write them from the smallest to the largest, or the other way round")));
  else if (up && down)
    problems.push_back(problemAt(order.place, tr("the atoms of all places are of one size"),
                                 tr("choose atoms of different elements")));
}

void checkOrderScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (spec.values["by"].text == kByEnergy && !forceChoice(scene.touch.forces).any())
    problems.push_back(
        problemAt(spec.values["by"].place, tr("no forces between atoms act in this scene"),
                  tr("write 'forces: all' in this step's scene, or order the places by something else")));
}

// The molecule is needed to find the places, and the check of forces gets it from them.
void checkOrderForces(const TaskSpec& spec, const SceneForces& forces, std::vector<Problem>& problems) {
  if (spec.values["by"].text != kByEnergy || forces.body()) return;
  std::vector<std::pair<double, std::size_t>> energies;
  const Value& order = spec.values["order"];
  for (std::size_t k = 0; k < order.path.size(); ++k)
    energies.emplace_back(wellEnergy_kcal_mol(forces, AtSurface(order.path[k], forces.molecule())), k);
  std::sort(energies.begin(), energies.end());
  for (std::size_t k = 1; k < energies.size(); ++k)
    if (energies[k].first - energies[k - 1].first < kApart_kcal_mol)
      problems.push_back(problemAt(order.places[energies[k].second],
                                   trf("two places bind the probe nearly alike, by {0} and {1}",
                                       energyText(energies[k - 1].first), energyText(energies[k].first)),
                                   tr("name another place, or give the probe another charge")));
}

}  // namespace

TaskKind orderKind() {
  return {
      "order",
      "Feel several places one after the other and put them in order.",
      {.base_s = 15.0, .each_s = 25.0, .each = "order", .each_what = "place"},
      {{.name = "order",
        .type = ValueType::Path,
        .meaning =
            "The places in the right order, two to six, separated by 'then'; by energy the program finds the right "
            "order itself. The student feels them in a different order.",
        .required = true},
       {.name = "first",
        .type = ValueType::Text,
        .meaning = "A description of the first place, inside a sentence: 'the deepest', 'the smallest'.",
        .required = true},
       {.name = "by",
        .type = ValueType::Word,
        .meaning =
            "The property that orders the places: by size, `check` compares the atoms' radii. By energy, in a scene "
            "with `forces`, the place with the probe's deepest well is the first; the program computes the wells.",
        .fallback = "touch",
        .words = {"touch", "depth", "size", kByEnergy}},
       {.name = "for",
        .type = ValueType::Quantity,
        .meaning = "The minimum time to touch each place.",
        .fallback = "1 s",
        .dimension = Dimension::Time,
        .min = 0.1,
        .max = 60.0},
       darkKey(),
       meterKey(),
       attemptsKey("How many orders the student may give; by default unlimited. After the last wrong one the right "
                   "one is shown, and the student continues.")},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Order>(s, m); },
      &checkOrder,
      &checkOrderedPlaces,
      &checkOrderScene,
      {},
      nullptr,
      nullptr,
      &checkOrderForces};
}

}  // namespace moltact
