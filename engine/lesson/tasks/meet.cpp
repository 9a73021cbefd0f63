// meet: provoke a failure of the haptic method in use, judged against the exact tracker with the same hand path.
#include <cmath>
#include <numbers>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kLasting_s = 0.1;   // a shorter deviation does not count as a perceptible failure
constexpr double kThrown_s = 0.005;  // a pop-through needs only this time
constexpr double kHeld_A = 0.1;      // minimum length of the exact spring when the method in use has lost the surface
constexpr double kJump_deg = 5.0;    // a fingertip notices at once when the force changes its direction by this angle
constexpr double kSteady_deg = 1.0;  // largest change of the exact force's direction in that time
constexpr double kPull_A = 0.02;     // the direction of a shorter spring is undefined

double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

class Meet : public Task {
 public:
  explicit Meet(const TaskSpec& spec)
      : Task(spec), what_(spec.values["meet"].words[0]), off_A_(spec.values["by"].number) {}

  void reset() override {
    Task::reset();
    watch_.restart();
    before_ = exact_before_ = Vec3(0.0);
    touching_ = false;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    const bool judged = s.exact.touching() && s.contact.fault == Fault::None;
    const Vec3& now = s.contact.displacement_A;
    const Vec3 exact = judged ? s.exact.displacement_A : Vec3(0.0);
    if (what_ == "jump") {
      const auto felt = [](const Vec3& v) { return glm::length(v) > kPull_A; };
      const bool all = dt_s > 0.0 && felt(now) && felt(before_) && felt(exact) && felt(exact_before_);
      if (all && angle_deg(now, before_) > kJump_deg && angle_deg(exact, exact_before_) < kSteady_deg) finish();
      before_ = now;
      exact_before_ = exact;
      return;
    }
    bool here = false;
    if (what_ == "lost")
      here = judged && !touching_ && glm::length(exact) > kHeld_A;
    else if (what_ == "wrong-side")
      here = judged && touching_ && glm::length(now) > kPull_A && glm::dot(now, exact) < 0.0;
    else
      here = judged && touching_ && glm::distance(s.contact.scp.A, s.exact.scp.A) > off_A_;
    watch_.tick(here, dt_s, 0.0);
    const double enough_s = what_ == "wrong-side" ? kThrown_s : kLasting_s;
    setProgress(watch_.elapsed_s() / enough_s);
    if (watch_.elapsed_s() >= enough_s) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const std::vector<std::uint32_t> all = everyAtom(view.spheres);
    if (what_ == "lost" || what_ == "wrong-side") {
      // Straight through a pit from one side to the other, along slightly different lines in each attempt.
      const auto pit = placeFor(view, openPlaces(view, all, Feature::Point));
      if (!pit) return plan;
      comeTo(plan, *pit, 0.5, 0.0);
      const Vec3 aside = Vec3(0.02, 0.01, 0.0) * double(1 + view.attempt);
      plan.push_back({.to = PointA{pit->scp_A + aside - pit->outward * 3.0}, .wait_s = 0.3});
      return plan;
    }
    const Feature wanted = what_ == "off" ? Feature::Circle : Feature::Sphere;
    const auto place = placeFor(view, openPlaces(view, all, wanted));
    if (!place) return plan;
    // Deep under the surface from place to place, so that the force changes its direction strongly.
    comeTo(plan, *place, 1.0, 0.3);
    const Vec3 x =
        glm::normalize(glm::cross(place->outward, std::abs(place->outward.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    for (const double turn : {0.0, 0.7, 1.4, -0.7, -1.4}) {
      const Vec3 way = x * std::cos(turn) + glm::cross(place->outward, x) * std::sin(turn);
      plan.push_back({.to = PointA{place->scp_A - place->outward + way * 1.5}, .speed_A_per_s = 2.0, .wait_s = 0.2});
      plan.push_back({.to = PointA{place->scp_A - place->outward - way * 1.5}, .speed_A_per_s = 2.0, .wait_s = 0.2});
    }
    return plan;
  }

  std::string guidance() const override {
    if (!touching_) return tr("Touch the surface and push in.");
    if (what_ == "jump") return tr("Slide slowly until the force turns with a jerk.");
    if (what_ == "lost") return tr("Push further in until the method loses the surface.");
    if (what_ == "wrong-side") return tr("Push further in until the force throws you out of the far side.");
    return tr("Slide until the contact point lies off the true one, and rest there.");
  }

  std::string what_;
  double off_A_ = 0.1;
  Stopwatch watch_;
  Vec3 before_{0.0}, exact_before_{0.0};
  bool touching_ = false;
};

}  // namespace

TaskKind meetKind() {
  return {"meet",
          "Provoke a failure of the haptic method in use, judged against the exact tracker.",
          {.base_s = 40.0},
          {{.name = "meet",
            .type = ValueType::Word,
            .meaning = "The failure: the force changes its direction abruptly, the surface is lost, the force points "
                       "out of the far side, or the contact point is off the surface.",
            .required = true,
            .words = {"jump", "lost", "wrong-side", "off"}},
           {.name = "by",
            .type = ValueType::Quantity,
            .meaning = "For 'off': the minimum distance of the contact point from the true one.",
            .fallback = "0.1 Å",
            .dimension = Dimension::Length,
            .min = 0.001,
            .max = 10.0}},
          [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Meet>(s); }};
}

}  // namespace moltact
