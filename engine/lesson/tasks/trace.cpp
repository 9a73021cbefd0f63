// trace: follow a path of atoms over the surface in contact, in order. The other form of the task is in
// trace_crease.cpp.
#include "engine/lesson/tasks/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/guided.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kAhead_A = 5.0;      // at a bend, the nearest point of the path may jump ahead by this distance
constexpr double kAheadShare = 0.25;  // but at most by this share of the whole path
// The front advances by at most this multiple of the slide since it stood there. The path on the surface may be longer
// or shorter than that between the centres. The hand must resume within this distance of the front.
constexpr double kWayShare = 2.0, kResume_A = 1.5;
constexpr double kSlid_A = 1.0;      // minimum length of a slide that advances the front
constexpr double kSlidShare = 0.1;   // or this share of the path, if that is shorter
constexpr double kStart_A = 1.0;     // the path may be begun within this distance of its end
constexpr double kStartShare = 0.1;  // and within this share of its length

/// The path is the polyline through the atoms' centres, compared with the contact point at the surface.
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
    double at_A = 0.0;  // position along the path
  };
  struct Near {
    double off_A = 0.0, at_A = 0.0;
    bool inside = true;  // false at an end of the examined part that is not an end of the path
  };

  // The nearest point of the path between `from_A` and `to_A`.
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
      slid_A_ = slide_.pathLength_A();
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
    // A press also moves the contact point slightly; shorter motions do not count as a slide.
    if (slide_.pathLength_A() >= std::min(kSlid_A, kSlidShare * length_A_))
      budget_A_ += kWayShare * (slide_.pathLength_A() - std::exchange(slid_A_, slide_.pathLength_A()));
    if (!resumed_) {
      // The path continues where it was left: a hand that comes down there, or slides back to it, resumes.
      const double reach = std::min(kResume_A, ahead_A_);
      const Near left = nearest(scp, probe_A, std::max(0.0, here_A - reach), std::min(length_A_, here_A + reach));
      resumed_ = (left.inside && left.off_A <= within_A) || restsNear(contact, reach);
      budget_A_ = 0.0;
      if (!resumed_) return {off_A, false};
    }
    const Near here = nearest(scp, probe_A, std::max(0.0, here_A - ahead_A_), std::min(length_A_, here_A + ahead_A_));
    const bool on = here.inside && here.off_A <= within_A;
    if (on) advance(backward_ ? length_A_ - here.at_A : here.at_A);
    return {off_A, reaches(contact) || on};
  }

  void advance(double to_A) {
    const double on_A = std::min(to_A, front_A_ + budget_A_) - front_A_;
    if (on_A <= 0.0) return;
    front_A_ += on_A;
    budget_A_ -= on_A;
  }

  // A point of several atoms counts as reached if one of them is touched, because the line through their centre may be
  // out of reach.
  bool reaches(const Contact& contact) {
    bool reached = false;
    for (const Stop& stop : stops_) {
      const double at_A = alongOf(stop);
      if (at_A - front_A_ > ahead_A_ + stop.place.reach_A || front_A_ - at_A > stop.place.reach_A ||
          !rests(contact, stop))
        continue;
      // Its atoms extend this far in front of their centre.
      if (at_A - front_A_ <= budget_A_ + stop.place.reach_A && at_A > front_A_) {
        budget_A_ = std::max(0.0, budget_A_ - (at_A - front_A_));
        front_A_ = at_A;
      }
      reached = true;
    }
    return reached;
  }

  double alongOf(const Stop& stop) const { return backward_ ? length_A_ - stop.at_A : stop.at_A; }

  // Whether the contact is on a point of several atoms that begins at most this far ahead, or ends at most this far
  // behind.
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

  // Over the exposed faces of the path's atoms in order, each nearest to the previous one.
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

  std::vector<std::uint32_t> answerAtoms() const override {
    std::vector<std::uint32_t> out;
    for (const Stop& stop : stops_) out.insert(out.end(), stop.place.atoms.begin(), stop.place.atoms.end());
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  std::string solution() const override { return tr("The way is marked in the view."); }

  bool begun() const override { return begun_; }
  double covered() const override { return begun_ ? front_A_ / length_A_ : 0.0; }
  void forget() override {
    begun_ = backward_ = false;
    front_A_ = budget_A_ = slid_A_ = 0.0;
  }
  Begin begin() const override { return either_ ? Begin::EitherEnd : Begin::Start; }

  std::vector<Stop> stops_;
  double length_A_ = 0.0, ahead_A_ = 0.0, front_A_ = 0.0;
  double slid_A_ = 0.0, budget_A_ = 0.0;  // length of the slide up to the last tick; how far the front may advance
  bool either_ = false, begun_ = false, backward_ = false, resumed_ = false;
};

void checkTrace(const TaskSpec& spec, std::vector<Problem>& problems) {
  const bool crease = !spec.values["trace"].words.empty();
  const Value &of = spec.values["of"], &trace = spec.values["trace"];
  if (crease && !of.selection.given())
    problems.push_back(problemAt(trace.place, tr("nothing says between which atoms the creases lie"),
                                 tr("add 'of'; for a small molecule 'of: all'")));
  if (!crease && of.place.line)
    problems.push_back(
        problemAt(of.place, tr("'of' belongs to 'trace: crease'"), tr("take it out or write 'trace: crease'")));
  if (const Value& attempts = spec.values["attempts"]; attempts.place.line && !spec.values.has("lifts"))
    problems.push_back(problemAt(attempts.place, tr("without 'lifts' there is no wrong try at a way"),
                                 tr("add a line 'lifts: …', or take 'attempts' out")));
  const Value& direction = spec.values["direction"];
  if (crease && direction.place.line)
    problems.push_back(problemAt(direction.place, tr("a crease has no direction"), tr("take the line out")));
  checkGuideKeys(spec, problems);
}

}  // namespace

TaskKind traceKind() {
  std::vector<KeySpec> keys{
      {.name = "trace",
       .type = ValueType::Path,
       .meaning = "The path: one selection, whose atoms are followed in the order of the file; places separated "
                  "by 'then'; or 'crease'.",
       .required = true,
       .words = {"crease"}},
      {.name = "of",
       .type = ValueType::Selection,
       .meaning = "For 'trace: crease': the atoms between which the creases lie."},
      {.name = "within",
       .type = ValueType::Quantity,
       .meaning = "The largest distance of the contact point from the path.",
       .fallback = "1 Å",
       .dimension = Dimension::Length,
       .min = 0.05,
       .max = 50.0},
      {.name = "cover",
       .type = ValueType::Count,
       .meaning = "The share of the path that must be followed, in percent.",
       .fallback = "90",
       .min = 1,
       .max = 100},
      {.name = "direction",
       .type = ValueType::Word,
       .meaning = "Whether the path may also be begun at its end.",
       .fallback = "forward",
       .words = {"forward", "either"}},
      {.name = "lifts",
       .type = ValueType::Count,
       .meaning = "How often the student may lose contact before the path restarts; by default unlimited.",
       .max = 100},
      attemptsKey("For 'lifts': how often the path may be begun; by default unlimited. If contact is lost too "
                  "often the last time as well, the student continues, and a path from atom to atom is marked.")};
  addGuideKeys(keys);
  return {"trace",
          "Follow a path over the surface without losing contact.",
          {.base_s = 60.0},
          std::move(keys),
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            if (!s.values["trace"].words.empty()) return makeTraceCrease(s, m);
            return std::make_unique<TraceAtoms>(s, m);
          },
          &checkTrace};
}

}  // namespace moltact
