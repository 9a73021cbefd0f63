// trace: follow the creases between atoms, in any order.
#include <algorithm>
#include <limits>

#include "engine/language/catalogue.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/trace.h"

namespace moltact {
namespace {

constexpr double kSpacing_A = 0.2;     // of the places along a crease
constexpr double kBrush_A = 0.25;      // a contact covers so much of a crease to either side
constexpr double kBrushed_A = 1.0;     // only what a slide of so much goes over is covered
constexpr double kBrushedShare = 0.1;  // or of so much of the crease, where that is shorter

class TraceCrease : public Trace {
 public:
  TraceCrease(const TaskSpec& spec, const Molecule& molecule)
      : Trace(spec), scene_(std::make_shared<const SphereGrid>(molecule.spheres)) {
    atoms_ = spec.values["of"].selection.select(molecule);
  }

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    const std::span<const Sphere> spheres = scene_->spheres();
    scene_ = std::make_shared<const SphereGrid>(std::vector<Sphere>(spheres.begin(), spheres.end()), untouchable);
  }

 private:
  Step follow(const Contact& contact, double probe_A, double within_A) override {
    if (probe_A != probe_A_) {
      // The creases move with the surface.
      std::vector<Sphere> points;
      for (const SurfacePlace& p : creasePlaces(*scene_, atoms_, probe_A, kSpacing_A)) points.push_back({p.scp_A, 0.0});
      places_ = std::make_unique<const SphereGrid>(std::move(points));
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
    places_->visitCentresNear(contact.scp.A, off_A + kBrush_A, [&](std::uint32_t k, const Sphere& p) {
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
    const std::vector<SurfacePlace> places = creasePlaces(view.spheres, atoms_, view.probe_A, kSpacing_A);
    for (const SurfacePlace& p : places) {
      if (last && glm::distance(last->scp_A, p.scp_A) < kNext_A) {
        plan.push_back({.to = PointA{p.scp_A - p.outward * depth_A}});
      } else if (openFromOutside(view.spheres, p, view.probe_A)) {
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
      places_->visitCentresNear(scp, reach_A, [&](std::uint32_t, const Sphere& p) {
        least = std::min(least, glm::distance(scp, p.centre_A));
      });
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

  std::shared_ptr<const SphereGrid> scene_;
  std::vector<std::uint32_t> atoms_;
  std::unique_ptr<const SphereGrid> places_;  // a grid of points
  static constexpr char kBrushed = 1, kPassed = 2;
  std::vector<char> passed_;
  std::vector<std::uint32_t> brushed_;  // by the slide that goes on, as long as it is too short
  double on_since_A_ = 0.0;             // of the slide, when it came onto the crease
  std::size_t count_ = 0;
  double probe_A_ = -1.0;
  bool begun_ = false;
};

}  // namespace

std::unique_ptr<Task> makeTraceCrease(const TaskSpec& spec, const Molecule& molecule) {
  return std::make_unique<TraceCrease>(spec, molecule);
}

}  // namespace moltact
