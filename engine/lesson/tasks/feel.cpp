// feel: find places of several kinds (sphere, crease, pit), or a number of different atoms.
#include <algorithm>
#include <utility>

#include "engine/haptics/sphere_grid.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

// After this many presses or this time on the surface without a find, the student gets a hint and the view zooms in;
// later, examples are marked.
constexpr int kHint_presses = 4, kExamples_presses = 8;
constexpr double kHint_s = 15.0, kExamples_s = 30.0;

// Atoms of up to three places of this kind near a contact point that a probe reaches from outside. None for the face of
// an atom, which is everywhere.
std::vector<std::uint32_t> examplesNear(const std::vector<Sphere>& spheres, const AtomSet& where, std::string_view kind,
                                        const Vec3& near_A, double probe_A) {
  constexpr double kAround_A = 16.0, kLooked_A = 9.0, kApart_A = 3.0;
  constexpr std::size_t kMax = 3;
  std::vector<Sphere> round;
  std::vector<std::uint32_t> index, among;
  for (std::uint32_t a = 0; a < spheres.size(); ++a) {
    const double far_A = glm::distance(spheres[a].centre_A, near_A);
    if (far_A > kAround_A) continue;
    if (far_A < kLooked_A && where.has(std::int32_t(a))) among.push_back(std::uint32_t(round.size()));
    index.push_back(a);
    round.push_back(spheres[a]);
  }
  const SphereGrid scene(std::move(round));
  std::vector<SurfacePlace> places = kind == "pit"      ? pitPlaces(scene, among, probe_A)
                                     : kind == "crease" ? creasePlaces(scene, among, probe_A, 1.0)
                                                        : std::vector<SurfacePlace>();
  std::sort(places.begin(), places.end(), [&](const SurfacePlace& a, const SurfacePlace& b) {
    return glm::distance(a.scp_A, near_A) < glm::distance(b.scp_A, near_A);
  });
  std::vector<Vec3> taken;
  std::vector<std::uint32_t> out;
  for (const SurfacePlace& place : places) {
    const bool beside = std::any_of(taken.begin(), taken.end(),
                                    [&](const Vec3& t) { return glm::distance(t, place.scp_A) < kApart_A; });
    if (taken.size() == kMax || beside || !openFromOutside(scene, place, probe_A)) continue;
    taken.push_back(place.scp_A);
    for (const std::int32_t a : place.atoms)
      if (a >= 0) out.push_back(index[std::size_t(a)]);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Requires one place of each kind, in any order.
class FeelPlaces : public Task {
 public:
  FeelPlaces(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), where_(spec.values["of"].selection, molecule), spheres_(molecule.spheres.copy()) {
    for (const std::string& word : spec.values["feel"].words)
      if (std::none_of(places_.begin(), places_.end(), [&](const Wanted& w) { return w.word == word; }))
        places_.push_back({word, PlaceKind(word, where_, molecule), {}});
  }

  void reset() override {
    Task::reset();
    for (Wanted& w : places_) w.watch.restart();
    on_wanted_ = touching_ = false;
    beginSearch();
  }

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    for (const std::uint32_t a : untouchable)
      if (a < spheres_.size()) spheres_[a].centre_A = Vec3(1e9);  // so far away that it forms no place
  }

  std::vector<std::uint32_t> exampleAtoms() const override { return examples_; }

 private:
  struct Wanted {
    std::string word;
    PlaceKind kind;
    Stopwatch watch;
    bool felt() const { return watch.elapsed_s() >= kTouch_s; }
  };

  void beginSearch() {
    presses_ = 0;
    searched_s_ = away_s_ = 0.0;
    close_to_.reset();
    examples_.clear();
  }

  // Measures how long the search for the next missing kind has lasted, and gives help.
  void search(const TouchSample& s, double dt_s) {
    if (!touching_) {
      away_s_ += dt_s;
      return;
    }
    if (std::exchange(away_s_, 0.0) > kSlip_s || presses_ == 0) ++presses_;
    searched_s_ += dt_s;
    if (!close_to_ && (presses_ > kHint_presses || searched_s_ >= kHint_s)) close_to_ = s.contact.scp;
    if (!examples_.empty() || !(presses_ > kExamples_presses || searched_s_ >= kExamples_s)) return;
    for (const Wanted& w : places_)
      if (!w.felt()) {
        examples_ = examplesNear(spheres_, where_, w.word, s.contact.scp.A, s.probe_A);
        return;
      }
  }

  TaskStage requestedStage() const override { return {.close_to = close_to_}; }

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    on_wanted_ = false;
    std::size_t felt = 0;
    const std::size_t felt_before = felt_;
    for (Wanted& w : places_) {
      const bool here = w.kind.at(s.contact, where_, s.probe_A);
      if (!w.felt()) {
        w.watch.tick(here, dt_s, 0.0);
        on_wanted_ = on_wanted_ || here;
      }
      felt += w.felt();
    }
    felt_ = felt;
    if (felt_ != felt_before)
      beginSearch();
    else
      search(s, dt_s);
    setProgress(static_cast<double>(felt) / static_cast<double>(places_.size()));
    if (felt == places_.size()) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    for (const Wanted& w : places_)
      if (!w.felt())
        if (const auto place = placeFor(view, placesToTouch(view, where_, w.word)))
          comeTo(plan, *place, depthFor(view, 0.2), 0.3);
    return plan;
  }

  std::string guidance() const override {
    if (on_wanted_) return tr("You have it. Stay there a moment.");
    if (!examples_.empty()) return tr("Some such places are marked near your hand. Push into the middle of one.");
    std::string missing;
    for (const Wanted& w : places_)
      if (close_to_ && !w.felt()) return howToFind(w.word);
    for (const Wanted& w : places_)
      if (!w.felt()) missing = missing.empty() ? placeName(w.word) : trf("{0} and {1}", missing, placeName(w.word));
    if (touching_) return trf("Slide over the surface until you feel {0}.", missing);
    return trf("Touch the surface, then slide until you feel {0}.", missing);
  }

  static const char* howToFind(std::string_view word) {
    if (word == "pit")
      return tr("A pit is a dent between three balls. Push into the middle of one: there the probe does not slide.");
    if (word == "crease")
      return tr("A crease is where two balls meet. Push beside that line: the probe slides into it.");
    return tr("A round face is the part of a ball that stands out most. Push lightly on its middle.");
  }

  AtomSet where_;
  std::vector<Wanted> places_;
  std::vector<Sphere> spheres_;
  std::vector<std::uint32_t> examples_;
  std::optional<PointA> close_to_;
  std::size_t felt_ = 0;
  int presses_ = 0;                         // during the search for the next missing kind
  double searched_s_ = 0.0, away_s_ = 0.0;  // time on the surface; time off it since the last press
  bool touching_ = false, on_wanted_ = false;
};

/// Requires a number of different atoms.
class FeelAtoms : public Task {
 public:
  FeelAtoms(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), where_(spec.values["of"].selection, molecule), watches_(molecule.atoms.size()) {
    // The author may require more atoms than the molecule has; then all of them are enough.
    wanted_ = std::clamp<std::size_t>(static_cast<std::size_t>(spec.values["count"].number), 1,
                                      std::max<std::size_t>(where_.count(), 1));
  }

  void reset() override {
    Task::reset();
    std::fill(watches_.begin(), watches_.end(), 0.0);
    felt_ = 0;
    touching_ = false;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    for (const std::int32_t atom : s.contact.atoms) {
      if (!touching_ || !where_.has(atom) || static_cast<std::size_t>(atom) >= watches_.size()) continue;
      double& time_s = watches_[static_cast<std::size_t>(atom)];
      if (time_s >= kTouch_s) continue;
      time_s += dt_s;
      if (time_s >= kTouch_s) ++felt_;
    }
    setProgress(static_cast<double>(felt_) / static_cast<double>(wanted_));
    if (felt_ >= wanted_) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    std::vector<std::uint32_t> left;
    for (const std::uint32_t a : where_.atoms())
      if (watches_[a] < kTouch_s) left.push_back(a);
    std::size_t planned = felt_;
    // One atom after the other, the most exposed first; another attempt begins with other atoms.
    std::vector<SurfacePlace> places = openPlaces(view, left, Feature::Sphere, 20 * wanted_);
    if (!places.empty())
      std::rotate(places.begin(), places.begin() + view.attempt % static_cast<int>(places.size()), places.end());
    for (const SurfacePlace& place : places) {
      if (planned >= wanted_) break;
      const auto atom = std::find(left.begin(), left.end(), static_cast<std::uint32_t>(place.atoms[0]));
      if (atom == left.end()) continue;
      left.erase(atom);
      comeTo(plan, place, depthFor(view, 0.2), 0.2);
      ++planned;
    }
    return plan;
  }

  std::string guidance() const override {
    return touching_ ? trf("{0} of {1} atoms felt. Slide on to the next one.", felt_, wanted_)
                     : trf("{0} of {1} atoms felt. Touch the surface and slide from atom to atom.", felt_, wanted_);
  }

  void measure(std::vector<TaskFigure>& out) const override { out.push_back({N_("atoms felt"), double(felt_), ""}); }

  AtomSet where_;
  std::vector<double> watches_;  // time on each atom (unit: second)
  std::size_t wanted_ = 1, felt_ = 0;
  bool touching_ = false;
};

bool feelsAtoms(const TaskSpec& spec) {
  const std::vector<std::string>& words = spec.values["feel"].words;
  return !words.empty() && words[0] == "atoms";
}

void checkFeel(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value& places = spec.values["feel"];
  const bool atoms = std::find(places.words.begin(), places.words.end(), "atoms") != places.words.end();
  if (atoms && places.words.size() > 1)
    problems.push_back(problemAt(places.place, tr("'atoms' stands alone"),
                                 tr("write a touch block of its own for sphere, crease and pit")));
  const Value& count = spec.values["count"];
  if (!atoms && count.place.line)
    problems.push_back(
        problemAt(count.place, tr("'count' belongs to 'feel: atoms'"), tr("take it out or write 'feel: atoms'")));
}

}  // namespace

TaskKind feelKind() {
  return {
      "feel",
      "Find kinds of place on the surface, or a number of different atoms.",
      {.base_s = 10.0, .each_s = 12.0, .each = "count", .each_what = "place"},
      {{.name = "feel",
        .type = ValueType::WordList,
        .meaning =
            "What to find, in any order: sphere (one atom), crease (two atoms meet), pit (three atoms meet); or atoms.",
        .required = true,
        .words = {"sphere", "crease", "pit", "atoms"}},
       {.name = "count",
        .type = ValueType::Count,
        .meaning = "For 'feel: atoms': the number of different atoms.",
        .fallback = "3",
        .min = 1,
        .max = 1000},
       {.name = "of", .type = ValueType::Selection, .meaning = "Only places formed by these atoms count."}},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
        if (feelsAtoms(s)) return std::make_unique<FeelAtoms>(s, m);
        return std::make_unique<FeelPlaces>(s, m);
      },
      &checkFeel,
      nullptr,
      nullptr,
      "`feel: atoms` alone; what counts are the atoms against which the body presses hardest.",
      &feelsAtoms};
}

}  // namespace moltact
