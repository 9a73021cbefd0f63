// cross: slide from one atom to another without leaving the surface, over the crease between them.
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/guided.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/touch_limits.h"

namespace moltact {
namespace {

class Cross : public Task {
 public:
  Cross(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        from_(spec.values["cross"].selection, molecule),
        to_(spec.values["to"].selection, molecule),
        from_name_(spec, "cross"),
        to_name_(spec, "to", "arrival"),
        limits_(spec, "cross", molecule),
        wrong_(spec, molecule),
        either_(spec.values["direction"].text == "either"),
        named_(spec.values.has("called") || spec.values.has("arrival")),
        times_(static_cast<int>(spec.values["times"].number)) {}

  bool takesUpSlide() const override { return true; }

  void reset() override {
    Task::reset();
    away_s_ = from_s_ = 0.0;
    crossed_ = lifts_ = 0;
    on_from_ = lost_ = touching_ = false;
    said_.clear();
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    if (!touching_) {
      // A hop of the hand at the crease is too short to count as leaving the surface.
      away_s_ += dt_s;
      if (away_s_ > kTouch_s) from_s_ = 0.0;
      if (on_from_ && away_s_ > kTouch_s) {
        on_from_ = false;
        lost_ = true;
        ++lifts_;
      }
      return;
    }
    away_s_ = 0.0;
    // If either direction counts, the slide starts on the side that the student touches first.
    if (either_ && !on_from_ && to_.holds(s.contact)) {
      std::swap(from_, to_);
      std::swap(from_name_, to_name_);
      from_s_ = 0.0;
    }
    const bool here = limits_.allow(s.contact, s.probe_A);
    const bool from = here && from_.holds(s.contact), to = here && to_.holds(s.contact);
    // A press on one atom that slips off to the other does not count as a slide across.
    from_s_ = from ? from_s_ + dt_s : on_from_ ? from_s_ : 0.0;
    if (on_from_ && to && !from) {
      ++crossed_;
      on_from_ = false;
    } else if (from && from_s_ >= kTouch_s) {
      on_from_ = true;
      lost_ = false;
    } else if (!here || (!from_.touchedBy(s.contact) && !to_.touchedBy(s.contact))) {
      on_from_ = false;
    }
    said_ = on_from_ ? std::string() : wrong_.about(s.contact);
    setProgress((crossed_ + (on_from_ ? 0.5 : 0.0)) / times_);
    if (crossed_ >= times_) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    std::vector<std::uint32_t> both = from_.atoms();
    for (const std::uint32_t a : to_.atoms()) both.push_back(a);
    const auto between = [&](const SurfacePlace& p) {
      return limits_.allow(p.scp_A, view.probe_A) &&
             ((from_.has(p.atoms[0]) && to_.has(p.atoms[1])) || (from_.has(p.atoms[1]) && to_.has(p.atoms[0])));
    };
    HandPlan plan;
    const auto crease = placeFor(view, openPlaces(view, both, Feature::Circle, 40, between));
    if (!crease) return plan;
    const bool first = from_.has(crease->atoms[0]);
    const SurfacePlace a = beside(view, *crease, crease->atoms[first ? 0 : 1], crease->atoms[first ? 1 : 0]);
    const SurfacePlace b = beside(view, *crease, crease->atoms[first ? 1 : 0], crease->atoms[first ? 0 : 1]);
    const double depth_A = depthFor(view, 0.3);
    comeTo(plan, a, depth_A, 0.2);
    for (int k = crossed_; k < times_; ++k) {
      slide(plan, view, a, *crease, depth_A);
      slide(plan, view, *crease, b, depth_A);
      plan.back().wait_s = 0.2;
      if (k + 1 < times_) slide(plan, view, b, a, depth_A);
    }
    return plan;
  }

  // A place on the face of one atom, at a small distance from its crease with another.
  static SurfacePlace beside(const HandPlanInput& view, const SurfacePlace& crease, std::int32_t atom,
                             std::int32_t other) {
    constexpr double kBeside_A = 0.6;
    const Sphere &on = view.spheres[static_cast<std::size_t>(atom)],
                 &from = view.spheres[static_cast<std::size_t>(other)];
    const Vec3 up = crease.scp_A - on.centre_A, away = glm::normalize(on.centre_A - from.centre_A);
    const Vec3 tangent = away - glm::normalize(up) * glm::dot(away, glm::normalize(up));
    const Vec3 u = glm::normalize(up + (glm::length(tangent) > 1e-6 ? glm::normalize(tangent) * kBeside_A : Vec3(0.0)));
    return {on.centre_A + u * (on.radius_A + view.probe_A), u, {atom, -1, -1}, Feature::Sphere};
  }

  std::string guidance() const override {
    if (!said_.empty() && touching_) return said_;
    // If the atoms on both sides are equal, they need no names.
    const bool alike = either_ && !named_;
    // Translators: "one atom" and "the other atom" are objects of "touch".
    if (on_from_)
      return counted(N_("Now slide to {0} without letting go."),
                     N_("Now slide to {0} without letting go ({1} of {2})."),
                     alike ? tr("the other atom") : to_name_.text());
    const std::string begin = alike     ? tr("one atom")
                              : either_ ? trf("{0} or {1}", from_name_.text(), to_name_.text())
                                        : from_name_.text();
    if (lost_)
      return counted(N_("You left the surface. Start again on {0}."),
                     N_("You left the surface. Start again on {0} ({1} of {2})."), begin);
    if (touching_) return counted(N_("Slide to {0} to begin."), N_("Slide to {0} to begin ({1} of {2})."), begin);
    return counted(N_("Touch {0} to begin."), N_("Touch {0} to begin ({1} of {2})."), begin);
  }

  // The sentence with the number of repetitions done, if more than one is required.
  std::string counted(const char* once, const char* several, const std::string& place) const {
    return times_ > 1 ? trf(several, place, crossed_, times_) : trf(once, place);
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("crossings"), double(crossed_), ""});
    out.push_back({N_("lifts"), double(lifts_), ""});
  }

  AtomSet from_, to_;
  TargetName from_name_, to_name_;
  TouchLimits limits_;
  WrongTouches wrong_;
  std::string said_;
  double away_s_ = 0.0, from_s_ = 0.0;  // time off the surface; uninterrupted time on the start
  bool either_ = false, named_ = false;
  int times_ = 1, crossed_ = 0, lifts_ = 0;
  bool on_from_ = false, lost_ = false, touching_ = false;
};

void checkSides(const TaskSpec& task, const Molecule& molecule, std::span<const std::uint32_t> /*untouchable*/,
                std::vector<Problem>& problems) {
  const Value &from_value = task.values["cross"], &to_value = task.values["to"];
  if (!from_value.selection.given() || !to_value.selection.given()) return;
  const AtomSet from(from_value.selection, molecule), to(to_value.selection, molecule);
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const auto atom = static_cast<std::int32_t>(i);
    if (!from.has(atom) || !to.has(atom)) continue;
    problems.push_back({"", to_value.place.line, to_value.place.column,
                        tr("the start and the end of the crossing have atoms in common"),
                        tr("choose atoms that are only in one")});
    return;
  }
}

}  // namespace

TaskKind crossKind() {
  std::vector<KeySpec> keys{
      {.name = "cross",
       .type = ValueType::Selection,
       .meaning = "The atoms on which the slide starts.",
       .required = true},
      {.name = "to",
       .type = ValueType::Selection,
       .meaning = "The atoms on which it must end; resting on them alone counts.",
       .required = true},
      {.name = "arrival",
       .type = ValueType::Text,
       .meaning = "The name of the atoms of 'to' inside a sentence, like 'called' for the start."},
      {.name = "direction",
       .type = ValueType::Word,
       .meaning = "Whether the opposite direction also counts; 'either' suits atoms that look alike.",
       .fallback = "forward",
       .words = {"forward", "either"}},
      {.name = "times", .type = ValueType::Count, .meaning = "How often.", .fallback = "1", .min = 1, .max = 100}};
  for (KeySpec& key : TouchLimits::keys()) keys.push_back(std::move(key));
  keys.push_back(WrongTouches::key());
  addGuideKeys(keys);
  return {"cross",
          "Slide from one atom to another without leaving the surface.",
          {.base_s = 15.0, .each_s = 15.0, .each = "times", .each_what = "crossing"},
          std::move(keys),
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Cross>(s, m); },
          &checkGuideKeys,
          checkSides};
}

}  // namespace moltact
