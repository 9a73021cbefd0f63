// trace: follow a way over the surface in contact: from atom to atom in order, or along the creases between atoms.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kSpacing_A = 0.2;    // of the places along a crease
constexpr double kBrush_A = 0.25;     // a contact covers so much of a crease to either side
constexpr double kAhead_A = 5.0;      // round a bend the nearest place of a way may leap so far
constexpr double kAheadShare = 0.25;  // but never over so much of the whole way
// The front of a way moves on by no more than the hand has slid since it stood there, as seen from the surface, which
// may be longer or shorter than the way between the centres; and the hand begins again so near to where it left it.
constexpr double kWayShare = 2.0, kResume_A = 1.5;
constexpr double kBrushed_A = 1.0;     // only what a slide of so much goes over is covered
constexpr double kBrushedShare = 0.1;  // or of so much of the crease, where that is shorter
constexpr double kStart_A = 1.0;       // so near to its end a way may be begun
constexpr double kStartShare = 0.1;    // and within so much of the whole

// What the two forms of the way have in common: how far the hand is off it, and how often it let go.
class Trace : public Task {
 public:
  explicit Trace(const TaskSpec& spec)
      : Task(spec),
        called_(spec.values["called"].text),
        within_A_(spec.values["within"].number),
        cover_(0.01 * spec.values["cover"].number),
        limited_(spec.values.has("lifts")),
        lifts_allowed_(static_cast<int>(spec.values["lifts"].number)) {}

  void reset() override {
    Task::reset();
    forget();
    slide_.restart();
    lifts_ = 0;
    over_A_s_ = on_s_ = greatest_A_ = 0.0;
    state_ = State::Away;
  }

 protected:
  enum class State { Away, Elsewhere, On, Off, Lifted, Again };
  enum class Begin { Start, EitherEnd, Anywhere };

  struct Step {
    double off_A = 0.0;  // of the contact point from the way
    bool on = false;     // on the part of the way that is to be followed now
  };

  /// The stretch of surface that the hand slides over now.
  Slide slide_;
  /// The hand has been put down again since the tick before.
  bool put_down_ = false;

  /// Moves on along the way where the contact point is on it within the tolerance.
  virtual Step follow(const Contact& contact, double probe_A, double within_A) = 0;
  virtual bool begun() const = 0;
  virtual double covered() const = 0;  // 0 to 1
  virtual void forget() = 0;
  virtual Begin begin() const = 0;
  // What is to be touched first, where the author gave it no name.
  virtual const char* unnamed() const { return tr("the way"); }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    put_down_ = slide_.tick(s.contact, dt_s);
    if (!s.contact.touching()) {
      away_s_ += dt_s;
      if (away_s_ > kSlip_s && begun() && state_ != State::Lifted && state_ != State::Again) letGo();
      return;
    }
    away_s_ = 0.0;
    const Step step = follow(s.contact, s.probe_A, within_A_);
    if (begun()) {
      over_A_s_ += step.off_A * dt_s;
      on_s_ += dt_s;
      greatest_A_ = std::max(greatest_A_, step.off_A);
      state_ = step.on ? State::On : State::Off;
    } else if (state_ != State::Again) {
      state_ = State::Elsewhere;
    }
    setProgress(covered() / cover_);
    if (covered() >= cover_) finish();
  }

  void letGo() {
    ++lifts_;
    state_ = State::Lifted;
    if (!limited_ || lifts_ <= lifts_allowed_) return;
    forget();
    lifts_ = 0;
    over_A_s_ = on_s_ = greatest_A_ = 0.0;
    setProgress(0.0);
    state_ = State::Again;
  }

  std::string guidance() const override {
    const std::string so_far = percentText(std::floor(100.0 * covered()) / 100.0);
    switch (state_) {
      case State::Away:
        switch (begin()) {
          case Begin::Start:
            return trf("Touch the start of {0} to begin.", name());
          case Begin::EitherEnd:
            return trf("Touch either end of {0} to begin.", name());
          case Begin::Anywhere:
            return trf("Touch {0} to begin.", name());
        }
        break;
      case State::Elsewhere:
        switch (begin()) {
          case Begin::Start:
            return trf("You are on the surface. Slide to the start of {0} to begin.", name());
          case Begin::EitherEnd:
            return trf("You are on the surface. Slide to either end of {0} to begin.", name());
          case Begin::Anywhere:
            return trf("You are on the surface. Slide to {0} to begin.", name());
        }
        break;
      case State::On:
        return trf("Follow {0}: {1} of the way.", way(), so_far);
      case State::Off:
        return trf("You are off {0}. Go back to where you left it: {1} of the way.", way(), so_far);
      case State::Lifted:
        return trf("You let go. Touch {0} where you left it: {1} of the way.", way(), so_far);
      case State::Again:
        break;
    }
    switch (begin()) {
      case Begin::Start:
        return trf("You let go too often. Begin again at the start of {0}.", name());
      case Begin::EitherEnd:
        return trf("You let go too often. Begin again at either end of {0}.", name());
      case Begin::Anywhere:
        break;
    }
    return trf("You let go too often. Begin again at {0}.", name());
  }

  // As the author called it.
  std::string name() const { return called_.empty() ? std::string(unnamed()) : called_; }
  std::string way() const { return called_.empty() ? tr("the way") : called_; }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("coverage"), 100.0 * covered(), "%"});
    if (on_s_ > 0.0) out.push_back({N_("mean deviation"), over_A_s_ / on_s_, "Å"});
    out.push_back({N_("greatest deviation"), greatest_A_, "Å"});
    out.push_back({N_("lifts"), double(lifts_), ""});
  }

  std::string called_;
  double within_A_ = 1.0, cover_ = 0.9;
  bool limited_ = false;
  int lifts_allowed_ = 0, lifts_ = 0;
  double away_s_ = 0.0, over_A_s_ = 0.0, on_s_ = 0.0, greatest_A_ = 0.0;
  State state_ = State::Away;
};

/// From atom to atom: the way is the line through their centres, seen from the surface.
class TraceAtoms : public Trace {
 public:
  TraceAtoms(const TaskSpec& spec, const Molecule& molecule)
      : Trace(spec), either_(spec.values["direction"].text == "either") {
    for (const PathPlace& p : pathPlaces(spec.values["trace"].path, molecule)) {
      if (!stops_.empty() && glm::distance(stops_.back().place.centre_A, p.centre_A) < 1e-9) continue;
      if (!stops_.empty()) length_A_ += glm::distance(stops_.back().place.centre_A, p.centre_A);
      stops_.push_back({p, length_A_});
    }
    ahead_A_ = std::min(kAhead_A, kAheadShare * length_A_);
    forget();
  }

 private:
  struct Stop {
    PathPlace place;
    double at_A = 0.0;  // along the way
  };
  struct Near {
    double off_A = 0.0, at_A = 0.0;
    bool inside = true;  // not at an end of the part that was looked at, unless the way itself ends there
  };

  // The nearest place of the way on the part of it from `from_A` to `to_A`.
  Near nearest(const Vec3& scp, double probe_A, double from_A, double to_A) const {
    Near best{std::numeric_limits<double>::max(), from_A, true};
    for (std::size_t k = 0; k + 1 < stops_.size(); ++k) {
      const Stop &a = stops_[k], &b = stops_[k + 1];
      if (b.at_A < from_A || a.at_A > to_A) continue;
      const double length = b.at_A - a.at_A;
      const Vec3 along = (b.place.centre_A - a.place.centre_A) / length;
      const double at = std::clamp(glm::dot(scp - a.place.centre_A, along), std::max(0.0, from_A - a.at_A),
                                   std::min(length, to_A - a.at_A));
      const double reach_A = a.place.reach_A + (b.place.reach_A - a.place.reach_A) * at / length + probe_A;
      const double off = glm::distance(scp, a.place.centre_A + along * at) - reach_A;
      if (off < best.off_A) best = {off, a.at_A + at};
    }
    constexpr double kAtEnd_A = 1e-6;
    const bool cut_low = from_A > 0.0 && best.at_A <= from_A + kAtEnd_A,
               cut_high = to_A < length_A_ && best.at_A >= to_A - kAtEnd_A;
    return {std::max(0.0, best.off_A), best.at_A, !cut_low && !cut_high};
  }

  Step follow(const Contact& contact, double probe_A, double within_A) override {
    if (stops_.size() < 2) {
      begun_ = true;
      front_A_ = length_A_ = 1.0;
      return {0.0, true};
    }
    const Vec3& scp = contact.scp.A;
    const double off_A = nearest(scp, probe_A, 0.0, length_A_).off_A;
    if (!begun_) {
      resumed_ = true;
      slid_A_ = slide_.way_A();
      budget_A_ = std::min(kResume_A, kAheadShare * length_A_);
      if (rests(contact, stops_.front()) || (either_ && rests(contact, stops_.back()))) {
        begun_ = true;
        backward_ = !rests(contact, stops_.front());
        budget_A_ = std::max(budget_A_, (backward_ ? stops_.back() : stops_.front()).place.reach_A);
        return {off_A, true};
      }
      const double reach = std::min(kStart_A, kStartShare * length_A_);
      const Near start = nearest(scp, probe_A, 0.0, reach), end = nearest(scp, probe_A, length_A_ - reach, length_A_);
      const bool at_start = start.inside && start.off_A <= within_A,
                 at_end = either_ && end.inside && end.off_A <= within_A;
      if (!at_start && !at_end) return {off_A, false};
      begun_ = true;
      backward_ = !at_start;
      front_A_ = backward_ ? length_A_ - end.at_A : start.at_A;
      return {off_A, true};
    }
    const double here_A = backward_ ? length_A_ - front_A_ : front_A_;
    if (put_down_) {
      resumed_ = false;
      slid_A_ = budget_A_ = 0.0;
    }
    // A press moves the contact point a little too: what is shorter than that is no slide.
    if (slide_.way_A() >= std::min(kBrushed_A, kBrushedShare * length_A_))
      budget_A_ += kWayShare * (slide_.way_A() - std::exchange(slid_A_, slide_.way_A()));
    if (!resumed_) {
      // The way goes on where it was left: whoever is put down there, or slides back to it, has found it again.
      const double reach = std::min(kResume_A, ahead_A_);
      const Near left = nearest(scp, probe_A, std::max(0.0, here_A - reach), std::min(length_A_, here_A + reach));
      resumed_ = (left.inside && left.off_A <= within_A) || restsNear(contact, reach);
      budget_A_ = 0.0;
      if (!resumed_) return {off_A, false};
    }
    const Near here = nearest(scp, probe_A, std::max(0.0, here_A - ahead_A_), std::min(length_A_, here_A + ahead_A_));
    const bool on = here.inside && here.off_A <= within_A;
    if (on) advance(backward_ ? length_A_ - here.at_A : here.at_A);
    return {off_A, comesTo(contact) || on};
  }

  void advance(double to_A) {
    const double on_A = std::min(to_A, front_A_ + budget_A_) - front_A_;
    if (on_A <= 0.0) return;
    front_A_ += on_A;
    budget_A_ -= on_A;
  }

  // A place of several atoms is reached where one of them is touched: the line through its middle may be out of reach.
  bool comesTo(const Contact& contact) {
    bool reached = false;
    for (const Stop& stop : stops_) {
      const double at_A = alongOf(stop);
      if (at_A - front_A_ > ahead_A_ + stop.place.reach_A || front_A_ - at_A > stop.place.reach_A ||
          !rests(contact, stop))
        continue;
      // Its atoms reach so far before its middle.
      if (at_A - front_A_ <= budget_A_ + stop.place.reach_A && at_A > front_A_) {
        budget_A_ = std::max(0.0, budget_A_ - (at_A - front_A_));
        front_A_ = at_A;
      }
      reached = true;
    }
    return reached;
  }

  double alongOf(const Stop& stop) const { return backward_ ? length_A_ - stop.at_A : stop.at_A; }

  // On a place of several atoms that begins no farther ahead than this, or ends no farther behind.
  bool restsNear(const Contact& contact, double within_A) const {
    return std::any_of(stops_.begin(), stops_.end(), [&](const Stop& stop) {
      return std::abs(alongOf(stop) - front_A_) <= stop.place.reach_A + within_A && rests(contact, stop);
    });
  }

  static bool rests(const Contact& contact, const Stop& stop) {
    const std::vector<std::uint32_t>& of = stop.place.atoms;
    return of.size() > 1 && std::any_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) {
             return a >= 0 && std::find(of.begin(), of.end(), std::uint32_t(a)) != of.end();
           });
  }

  // Over the faces of the path's atoms that are open, one after the other, each the one nearest to the last.
  HandPlan demonstrate(const HandPlanInput& view) const override {
    std::vector<SurfacePlace> way;
    for (const Stop& stop : stops_) {
      const std::vector<SurfacePlace> open = openPlaces(view, stop.place.atoms, Feature::Sphere);
      if (open.empty()) continue;
      const auto nearer = [&](const SurfacePlace& a, const SurfacePlace& b) {
        return glm::distance(a.scp_A, way.back().scp_A) < glm::distance(b.scp_A, way.back().scp_A);
      };
      way.push_back(way.empty() ? *placeFor(view, open) : *std::min_element(open.begin(), open.end(), nearer));
    }
    HandPlan plan;
    if (way.empty()) return plan;
    const double depth_A = depthFor(view, 0.4);
    comeTo(plan, way.front(), depth_A, 0.2);
    for (std::size_t k = 1; k < way.size(); ++k) slide(plan, view, way[k - 1], way[k], depth_A);
    plan.back().wait_s = 0.2;
    return plan;
  }

  bool begun() const override { return begun_; }
  double covered() const override { return begun_ ? front_A_ / length_A_ : 0.0; }
  void forget() override {
    begun_ = backward_ = false;
    front_A_ = budget_A_ = slid_A_ = 0.0;
  }
  Begin begin() const override { return either_ ? Begin::EitherEnd : Begin::Start; }

  std::vector<Stop> stops_;
  double length_A_ = 0.0, ahead_A_ = 0.0, front_A_ = 0.0;
  double slid_A_ = 0.0, budget_A_ = 0.0;  // of the slide until the last tick; so far the front may move on
  bool either_ = false, begun_ = false, backward_ = false, resumed_ = false;
};

/// Along the creases between atoms, in any order.
class TraceCrease : public Trace {
 public:
  TraceCrease(const TaskSpec& spec, const Molecule& molecule)
      : Trace(spec), scene_(std::make_shared<const BallScene>(molecule.balls())) {
    atoms_ = spec.values["of"].selection.select(molecule);
  }

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    const std::span<const Ball> balls = scene_->balls();
    scene_ = std::make_shared<const BallScene>(std::vector<Ball>(balls.begin(), balls.end()), untouchable);
  }

 private:
  Step follow(const Contact& contact, double probe_A, double within_A) override {
    if (probe_A != probe_A_) {
      // The creases move with the surface.
      std::vector<Ball> points;
      for (const SurfacePlace& p : creasePlaces(*scene_, atoms_, probe_A, kSpacing_A)) points.push_back({p.scp_A, 0.0});
      places_ = std::make_unique<const BallScene>(std::move(points));
      probe_A_ = probe_A;
      forget();
    }
    const double off_A = nearest(contact.scp.A);
    // Between two of the places the crease is still there.
    const double off = off_A < kSpacing_A ? std::max(0.0, off_A - 0.5 * kSpacing_A) : off_A;
    if (off > within_A || put_down_) {
      dropBrushed();
      on_since_A_ = slide_.way_A();
    }
    if (off > within_A) return {off, false};
    begun_ = true;
    places_->visitCentresNear(contact.scp.A, off_A + kBrush_A, [&](std::uint32_t k, const Ball& p) {
      if (passed_[k] || glm::distance(p.centre_A, contact.scp.A) > off_A + kBrush_A) return;
      passed_[k] = kBrushed;
      brushed_.push_back(k);
    });
    // A hand that is only put down here and there has not followed it.
    if (slide_.way_A() - on_since_A_ < std::min(kBrushed_A, kBrushedShare * kSpacing_A * double(places_->size())))
      return {off, true};
    for (const std::uint32_t k : brushed_) passed_[k] = kPassed;
    count_ += brushed_.size();
    brushed_.clear();
    return {off, true};
  }

  void dropBrushed() {
    for (const std::uint32_t k : brushed_) passed_[k] = 0;
    brushed_.clear();
  }

  // Along each stretch of crease; where the next place is far, the hand comes down anew.
  HandPlan demonstrate(const HandPlanInput& view) const override {
    constexpr double kNext_A = 0.8;
    HandPlan plan;
    const SurfacePlace* last = nullptr;
    const double depth_A = depthFor(view, 0.4);
    const std::vector<SurfacePlace> places = creasePlaces(view.balls, atoms_, view.probe_A, kSpacing_A);
    for (const SurfacePlace& p : places) {
      if (last && glm::distance(last->scp_A, p.scp_A) < kNext_A) {
        plan.push_back({.to = PointA{p.scp_A - p.outward * depth_A}});
      } else if (openFromOutside(view.balls, p, view.probe_A)) {
        comeTo(plan, p, depth_A, 0.1);
      } else {
        continue;
      }
      last = &p;
    }
    return plan;
  }

  bool empty() const { return !places_ || places_->size() == 0; }

  // How far the nearest place of the creases is, looked for in a growing box.
  double nearest(const Vec3& scp) const {
    const double far =
        empty() ? 0.0 : glm::distance(places_->low_A(), places_->high_A()) + glm::distance(scp, places_->low_A()) + 1.0;
    for (double reach_A = 0.5; !empty(); reach_A *= 2.0) {
      double least = std::numeric_limits<double>::max();
      places_->visitCentresNear(
          scp, reach_A, [&](std::uint32_t, const Ball& p) { least = std::min(least, glm::distance(scp, p.centre_A)); });
      if (least <= reach_A || reach_A > far) return least;
    }
    return 1e3;  // there is no crease
  }

  bool begun() const override { return begun_; }
  double covered() const override { return empty() ? 0.0 : double(count_) / double(places_->size()); }
  void forget() override {
    passed_.assign(empty() ? 0 : places_->size(), 0);
    brushed_.clear();
    count_ = 0;
    begun_ = false;
  }
  Begin begin() const override { return Begin::Anywhere; }
  const char* unnamed() const override { return tr("the crease"); }

  std::shared_ptr<const BallScene> scene_;
  std::vector<std::uint32_t> atoms_;
  std::unique_ptr<const BallScene> places_;  // a grid of points
  static constexpr char kBrushed = 1, kPassed = 2;
  std::vector<char> passed_;
  std::vector<std::uint32_t> brushed_;  // by the slide that goes on, as long as it is too short
  double on_since_A_ = 0.0;             // of the slide, when it came onto the crease
  std::size_t count_ = 0;
  double probe_A_ = -1.0;
  bool begun_ = false;
};

void checkTrace(const TaskSpec& spec, std::vector<Problem>& problems) {
  const bool crease = !spec.values["trace"].words.empty();
  const Value &of = spec.values["of"], &trace = spec.values["trace"];
  if (crease && !of.selection.given())
    problems.push_back({{},
                        trace.place.line,
                        trace.place.column,
                        tr("nothing says between which atoms the creases lie"),
                        tr("add 'of'; for a small molecule 'of: all'")});
  if (!crease && of.place.line)
    problems.push_back({{},
                        of.place.line,
                        of.place.column,
                        tr("'of' belongs to 'trace: crease'"),
                        tr("take it out or write 'trace: crease'")});
  const Value& direction = spec.values["direction"];
  if (crease && direction.place.line)
    problems.push_back(
        {{}, direction.place.line, direction.place.column, tr("a crease has no direction"), tr("take the line out")});
}

}  // namespace

TaskKind traceKind() {
  return {"trace",
          "Follow a way over the surface without letting go.",
          {{.name = "trace",
            .type = ValueType::Path,
            .meaning = "The way: one selection, whose atoms are followed in the order of the file; places parted by "
                       "'then'; or 'crease'.",
            .required = true,
            .words = {"crease"}},
           {.name = "of",
            .type = ValueType::Selection,
            .meaning = "For 'trace: crease': the atoms between which the creases lie."},
           {.name = "within",
            .type = ValueType::Quantity,
            .meaning = "How far off the way the contact point may be.",
            .fallback = "1 Å",
            .dimension = Dimension::Length,
            .least = 0.05,
            .most = 50.0},
           {.name = "cover",
            .type = ValueType::Count,
            .meaning = "How much of the way is to be followed, in percent.",
            .fallback = "90",
            .least = 1,
            .most = 100},
           {.name = "direction",
            .type = ValueType::Word,
            .meaning = "Whether the way may be begun at its end as well.",
            .fallback = "forward",
            .words = {"forward", "either"}},
           {.name = "lifts",
            .type = ValueType::Count,
            .meaning = "How often the student may let go before the way begins again; without it as often as need be.",
            .most = 100}},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            if (!s.values["trace"].words.empty()) return std::make_unique<TraceCrease>(s, m);
            return std::make_unique<TraceAtoms>(s, m);
          },
          &checkTrace};
}

}  // namespace moltact
