// feel: visit kinds of place (sphere, crease, pit), or a number of different atoms.
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

/// Each kind of place once, in any order.
class FeelPlaces : public Task {
 public:
  FeelPlaces(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), where_(spec.values["of"].selection, molecule) {
    for (const std::string& word : spec.values["feel"].words)
      if (std::none_of(places_.begin(), places_.end(), [&](const Wanted& w) { return w.word == word; }))
        places_.push_back({word, PlaceKind(word, where_, molecule), {}});
  }

  void reset() override {
    Task::reset();
    for (Wanted& w : places_) w.watch.restart();
    on_wanted_ = touching_ = false;
  }

 private:
  struct Wanted {
    std::string word;
    PlaceKind kind;
    Stopwatch watch;
    bool felt() const { return watch.elapsed_s() >= kTouch_s; }
  };

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    on_wanted_ = false;
    std::size_t felt = 0;
    for (Wanted& w : places_) {
      const bool here = w.kind.at(s.contact, where_, s.probe_A);
      if (!w.felt()) {
        w.watch.tick(here, dt_s, 0.0);
        on_wanted_ = on_wanted_ || here;
      }
      felt += w.felt();
    }
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
    std::string missing;
    for (const Wanted& w : places_)
      if (!w.felt()) missing = missing.empty() ? placeName(w.word) : trf("{0} and {1}", missing, placeName(w.word));
    if (touching_) return trf("Slide over the surface until you feel {0}.", missing);
    return trf("Touch the surface, then slide until you feel {0}.", missing);
  }

  AtomSet where_;
  std::vector<Wanted> places_;
  bool touching_ = false, on_wanted_ = false;
};

/// A number of different atoms.
class FeelAtoms : public Task {
 public:
  FeelAtoms(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), where_(spec.values["of"].selection, molecule), watches_(molecule.atoms.size()) {
    // An author may ask for more atoms than the molecule has; all of them are then enough.
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
    // Atom by atom, those that stick out first; another attempt begins with others.
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
  std::vector<double> watches_;  // time on each atom, in seconds
  std::size_t wanted_ = 1, felt_ = 0;
  bool touching_ = false;
};

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
      {{.name = "feel",
        .type = ValueType::WordList,
        .meaning =
            "What to find: sphere (one atom), crease (where two meet), pit (where three meet), in any order; or atoms.",
        .required = true,
        .words = {"sphere", "crease", "pit", "atoms"}},
       {.name = "count",
        .type = ValueType::Count,
        .meaning = "How many different atoms 'feel: atoms' asks for.",
        .fallback = "3",
        .least = 1,
        .most = 1000},
       {.name = "of", .type = ValueType::Selection, .meaning = "Only places that are made by these atoms count."}},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
        const std::vector<std::string>& words = s.values["feel"].words;
        if (!words.empty() && words[0] == "atoms") return std::make_unique<FeelAtoms>(s, m);
        return std::make_unique<FeelPlaces>(s, m);
      },
      &checkFeel};
}

}  // namespace moltact
