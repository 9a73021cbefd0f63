// trace: follow the creases between atoms, in any order.
#include <algorithm>
#include <limits>

#include "engine/language/catalogue.h"
#include "engine/lesson/surface_places.h"
#include "engine/lesson/tasks/trace.h"

namespace moltact {
namespace {

constexpr double kSpacing_A = 0.2;     // spacing of the sampled points of a crease
constexpr double kBrush_A = 0.25;      // half width of the part of a crease that a contact covers
constexpr double kBrushed_A = 1.0;     // minimum length of a slide that covers anything
constexpr double kBrushedShare = 0.1;  // or this share of the crease, if that is shorter

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
      // The creases are moved with the surface.
      std::vector<Sphere> points;
      for (const SurfacePlace& p : creasePlaces(*scene_, atoms_, probe_A, kSpacing_A)) points.push_back({p.scp_A, 0.0});
      places_ = std::make_unique<const SphereGrid>(std::move(points));
      probe_A_ = probe_A;
      forget();
    }
    const double off_A = nearest(contact.scp.A);
    // Corrects for the distance to the next sampled point.
    const double off = off_A < kSpacing_A ? std::max(0.0, off_A - 0.5 * kSpacing_A) : off_A;
    if (off > within_A || put_down_) {
      dropBrushed();
      on_since_A_ = slide_.pathLength_A();
    }
    if (off > within_A) return {off, false};
    begun_ = true;
    places_->visitCentresNear(contact.scp.A, off_A + kBrush_A, [&](std::uint32_t k, const Sphere& p) {
      if (passed_[k] || glm::distance(p.centre_A, contact.scp.A) > off_A + kBrush_A) return;
      passed_[k] = kBrushed;
      brushed_.push_back(k);
    });
    // Covering a crease requires sliding along it; single touches do not count.
    if (slide_.pathLength_A() - on_since_A_ <
        std::min(kBrushed_A, kBrushedShare * kSpacing_A * double(places_->size())))
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

  // Along each part of a crease; if the next point is far, the hand comes down there again.
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

  // The distance to the nearest point of the creases, searched in a growing box.
  double nearest(const Vec3& scp) const {
    const double far =
        empty() ? 0.0 : glm::distance(places_->low_A(), places_->high_A()) + glm::distance(scp, places_->low_A()) + 1.0;
    for (double reach_A = 0.5; !empty(); reach_A *= 2.0) {
      double min = std::numeric_limits<double>::max();
      places_->visitCentresNear(
          scp, reach_A, [&](std::uint32_t, const Sphere& p) { min = std::min(min, glm::distance(scp, p.centre_A)); });
      if (min <= reach_A || reach_A > far) return min;
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
  std::unique_ptr<const SphereGrid> places_;  // the sampled points
  static constexpr char kBrushed = 1, kPassed = 2;
  std::vector<char> passed_;
  std::vector<std::uint32_t> brushed_;  // covered by the present slide, while it is too short to count
  double on_since_A_ = 0.0;             // length of the slide when it reached the crease
  std::size_t count_ = 0;
  double probe_A_ = -1.0;
  bool begun_ = false;
};

}  // namespace

std::unique_ptr<Task> makeTraceCrease(const TaskSpec& spec, const Molecule& molecule) {
  return std::make_unique<TraceCrease>(spec, molecule);
}

}  // namespace moltact
