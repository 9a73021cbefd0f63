// avoid: move over the surface for a time without touching a region.
#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

class Avoid : public Task {
 public:
  Avoid(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        region_(spec.values["avoid"].selection, molecule),
        name_(spec, "avoid"),
        time_s_(spec.values["for"].number) {}

  void reset() override {
    Task::reset();
    touched_s_ = 0.0;
    on_region_ = erred_ = false;
    touches_ = 0;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    const bool before = on_region_;
    on_region_ = region_.touchedBy(s.contact);
    touches_ += on_region_ && !before;
    if (on_region_) {
      erred_ = erred_ || touched_s_ > 0.0;
      touched_s_ = 0.0;
    } else if (s.contact.touching()) {
      touched_s_ += dt_s;
    }
    setProgress(touched_s_ / time_s_);
    if (touched_s_ >= time_s_) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    std::vector<std::uint32_t> others;
    for (const std::uint32_t a : everyAtom(view.spheres))
      if (!region_.has(static_cast<std::int32_t>(a))) others.push_back(a);
    HandPlan plan;
    if (const auto place = placeFor(view, openPlaces(view, others, Feature::Sphere)))
      comeTo(plan, *place, depthFor(view, 0.2), time_s_ + 0.5);
    return plan;
  }

  std::string guidance() const override {
    if (on_region_) return trf("That is {0}. Move away from it; the time starts again.", name_.text());
    if (touched_s_ > 0.0 || erred_)
      return trf("Keep feeling the surface without touching {0}: {1} of {2}.", name_.text(), timeText(touched_s_),
                 timeText(time_s_));
    return trf("Touch the surface anywhere except {0}.", name_.text());
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("touches of the region"), double(touches_), ""});
  }

  AtomSet region_;
  TargetName name_;
  double time_s_ = 1.0, touched_s_ = 0.0;
  bool on_region_ = false, erred_ = false;
  int touches_ = 0;
};

}  // namespace

TaskKind avoidKind() {
  return {
      "avoid",
      "Feel the surface for a time without touching a region.",
      {.base_s = 30.0},
      {{.name = "avoid",
        .type = ValueType::Selection,
        .meaning = "The atoms that must not be touched.",
        .required = true},
       {.name = "for",
        .type = ValueType::Quantity,
        .meaning = "The time for which the rest of the surface must be touched; motion in free space does not count.",
        .fallback = "10 s",
        .dimension = Dimension::Time,
        .min = 0.1,
        .max = 600.0}},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Avoid>(s, m); }};
}

}  // namespace moltact
