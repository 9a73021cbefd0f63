// reach: touch one of the selected atoms, or a place near them.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/touch_limits.h"

namespace moltact {
namespace {

class Reach : public Task {
 public:
  Reach(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        target_(spec.values["reach"].selection, molecule),
        name_(spec, "reach"),
        limits_(spec, "reach", molecule),
        wrong_(spec, molecule) {
    if (!spec.values.has("near")) return;
    near_A_ = spec.values["near"].number;
    for (const std::uint32_t i : spec.values["reach"].selection.select(molecule))
      centres_.push_back(molecule.spheres[i].centre_A);
  }

  void reset() override {
    Task::reset();
    watch_.restart();
    touching_ = beside_ = false;
    said_.clear();
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    const bool on_target = reached(s.contact), counts = on_target && limits_.allow(s.contact, s.probe_A);
    beside_ = on_target && !counts;
    said_ = touching_ && !counts ? wrong_.about(s.contact) : std::string();
    watch_.tick(counts, dt_s, 0.0);
    setProgress(watch_.elapsed_s() / kTouch_s);
    if (watch_.elapsed_s() >= kTouch_s) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    std::vector<SurfacePlace> places = placesToTouch(view, target_);
    if (places.empty() && near_A_ > 0.0)
      for (const SurfacePlace& p : openPlaces(view, everyAtom(view.spheres), Feature::Sphere, 4000))
        if (std::any_of(centres_.begin(), centres_.end(),
                        [&](const Vec3& c) { return glm::distance(c, p.scp_A) < near_A_; }))
          places.push_back(p);
    std::erase_if(places, [&](const SurfacePlace& p) { return !limits_.allow(p.scp_A, view.probe_A); });
    HandPlan plan;
    if (const auto place = placeFor(view, places)) comeTo(plan, *place, depthFor(view, 0.3), 0.3);
    return plan;
  }

  bool reached(const Contact& contact) const {
    if (target_.touchedBy(contact)) return true;
    if (!contact.touching()) return false;
    for (const Vec3& c : centres_)
      if (glm::distance(c, contact.scp.A) <= near_A_) return true;
    return false;
  }

  std::string guidance() const override {
    if (watch_.elapsed_s() > 0.0) return tr("Stay there a moment.");
    if (!said_.empty()) return said_;
    if (beside_) return trf("That is {0}, but not the place on it that is meant. Slide on.", name_.text());
    if (touching_) return trf("You are on the surface. Slide on to find {0}.", name_.text());
    return holdsBody() ? trf("Move what you hold to {0} until it stops you.", name_.text())
                       : trf("Move the probe to {0} until it stops you.", name_.text());
  }

  AtomSet target_;
  TargetName name_;
  TouchLimits limits_;
  WrongTouches wrong_;
  std::string said_;
  std::vector<Vec3> centres_;
  double near_A_ = 0.0;
  Stopwatch watch_;
  bool touching_ = false, beside_ = false;
};

}  // namespace

TaskKind reachKind() {
  std::vector<KeySpec> keys{{.name = "reach",
                             .type = ValueType::Selection,
                             .meaning = "The atoms, one of which must be touched.",
                             .required = true},
                            {.name = "near",
                             .type = ValueType::Quantity,
                             .meaning = "A touch within this distance of a selected atom's centre also counts.",
                             .dimension = Dimension::Length,
                             .max = 1000.0}};
  for (KeySpec& key : TouchLimits::keys()) keys.push_back(std::move(key));
  keys.push_back(WrongTouches::key());
  return {.name = "reach",
          .meaning = "Touch one of the selected atoms.",
          .time = {.base_s = 20.0},
          .keys = std::move(keys),
          .make = [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            return std::make_unique<Reach>(s, m);
          },
          .of_body =
              "what counts are the atoms against which the body presses hardest; `near`, `side` and `region` use the "
              "position of "
              "the body's centre."};
}

}  // namespace moltact
