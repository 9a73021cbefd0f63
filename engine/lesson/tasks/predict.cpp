// predict: draw the force curve first, then feel it by pressing or sliding; both are displayed together.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/curve_overlap.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr std::size_t kPoints = 25;  // number of points of each curve
constexpr double kFeltEnough = 0.9;  // share of the axis that must be felt
constexpr double kSlideShare = 0.2;  // share of the path; shorter slides do not count
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Predict : public Task {
 public:
  Predict(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        from_(spec.values["predict"].selection, molecule),
        goal_atoms_(spec.values["along"].selection, molecule),
        name_(spec, "predict"),
        goal_(spec.values["along"].selection),
        agree_(0.01 * spec.values["agree"].number),
        slides_(spec.values["along"].selection.given()) {
    curves_.x_name = slides_ ? "way" : N_("depth");
    curves_.x_max_A = spec.values["deep"].number;
    curves_.max_N = spec.values["most"].number;
    if (slides_) {
      start_A_ = middle(spec.values["predict"].selection, molecule);
      const Vec3 way = middle(spec.values["along"].selection, molecule) - start_A_;
      curves_.x_max_A = std::max(1e-3, glm::length(way));
      along_ = way / curves_.x_max_A;
    }
    forget();
  }

  void reset() override {
    Task::reset();
    forget();
    first_agreement_ = -1.0;
    predictions_ = 0;
  }

  const TaskCurves* curves() const override { return &curves_; }

 private:
  static Vec3 middle(const Selection& selection, const Molecule& molecule) {
    Vec3 sum(0.0);
    const std::vector<std::uint32_t> atoms = selection.select(molecule);
    for (const std::uint32_t a : atoms) sum += molecule.spheres[a].centre_A / double(atoms.size());
    return sum;
  }

  void forget() {
    curves_.drawing = true;
    curves_.drawn.assign(kPoints, kNone);
    forgetFelt();
  }
  void forgetFelt() {
    curves_.felt.assign(kPoints, kNone);
    curves_.agreement.reset();
    counts_.assign(kPoints, 0.0);
    sums_.assign(kPoints, 0.0);
    waiting_ = {};
    slide_.restart();
  }

  void onAnswer(const TaskAnswer& answer) override {
    forgetFelt();
    curves_.drawn = answer.curve;
    curves_.drawing = missed_ = false;
    ++predictions_;
    setProgress(0.5);
  }

  void onSample(const TouchSample& s, double dt_s) override {
    if (slide_.tick(s.contact, dt_s)) waiting_ = {};
    touching_ = s.contact.touching();
    on_place_ = touching_ && (slides_ || from_.touchedBy(s.contact));
    if (curves_.drawing || !on_place_) return;
    const double x = slides_ ? glm::dot(s.contact.scp.A - start_A_, along_) : s.contact.depth_A();
    const double at = x / curves_.x_max_A * double(kPoints - 1);
    if (!(at > -0.5) || !(at < double(kPoints) - 0.5)) return;
    const auto k = static_cast<std::size_t>(std::lround(std::max(0.0, at)));
    ++waiting_[k].count;
    waiting_[k].sum_N += glm::length(s.force.N);
    // Feeling a path requires sliding along it; single touches do not count.
    if (slides_ && slide_.pathLength_A() < kSlideShare * curves_.x_max_A) return;
    for (std::size_t point = 0; point < kPoints; ++point) {
      if (waiting_[point].count == 0.0) continue;
      counts_[point] += waiting_[point].count;
      sums_[point] += waiting_[point].sum_N;
      curves_.felt[point] = sums_[point] / counts_[point];
    }
    waiting_ = {};
    const double felt = feltShare();
    setProgress(0.5 + 0.5 * felt / kFeltEnough);
    if (felt >= kFeltEnough) compare();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const double depth_A = depthFor(view, 0.5);
    const auto start = placeFor(view, placesToTouch(view, from_));
    if (!start) return plan;
    if (curves_.drawing) {
      TaskAnswer expected;
      for (std::size_t k = 0; k < kPoints; ++k)
        expected.curve.push_back(
            slides_ ? 0.5 : std::min(curves_.max_N, view.N_per_A * curves_.x_max_A * double(k) / double(kPoints - 1)));
      plan.push_back({.answer = std::move(expected)});
    }
    if (!slides_) {
      comeTo(plan, *start, 0.01, 0.0);
      plan.push_back({.to = PointA{start->scp_A - start->outward * (1.02 * curves_.x_max_A)},
                      .speed_A_per_s = 0.5,
                      .wait_s = 0.1});
      return plan;
    }
    const auto end = placeFor(view, placesToTouch(view, goal_atoms_));
    if (!end) return plan;
    comeTo(plan, *start, depth_A, 0.1);
    slide(plan, view, *start, *end, depth_A, 1.5);
    return plan;
  }

  double feltShare() const {
    return double(std::count_if(counts_.begin(), counts_.end(), [](double c) { return c > 0.0; })) / double(kPoints);
  }

  void compare() {
    curves_.agreement = curveOverlap(curves_.drawn, curves_.felt);
    if (first_agreement_ < 0.0) first_agreement_ = *curves_.agreement;
    if (*curves_.agreement >= agree_) {
      finish();
      return;
    }
    if (missedLast()) return;
    curves_.drawing = missed_ = true;
    setProgress(0.0);
  }

  std::string agreement() const { return percentText(curves_.agreement.value_or(0.0)); }

  // A press must reach the full depth.
  bool tooLight() const override { return !slides_ && !curves_.drawing && on_place_; }

  std::string guidance() const override {
    const std::string name = name_.text(), goal = goal_.text();
    if (missed_) {
      const std::string wanted = percentText(agree_);
      return slides_ ? trf("The two curves agree by {0}; {1} are asked for. Draw again what you expect on the way from "
                           "{2} to {3}.",
                           agreement(), wanted, name, goal)
                     : trf("The two curves agree by {0}; {1} are asked for. Draw again what you expect for pressing "
                           "into {2}.",
                           agreement(), wanted, name);
    }
    if (curves_.drawing)
      return slides_ ? trf("First draw the force that you expect on the way from {0} to {1}.", name, goal)
                     : trf("First draw the force that you expect for pressing into {0}.", name);
    const std::string felt = percentText(std::min(1.0, feltShare() / kFeltEnough));
    if (slides_)
      return touching_ ? trf("Slide from {0} to {1} and press evenly. {2} felt.", name, goal, felt)
                       : trf("Now touch {0}. {1} felt.", name, felt);
    if (!on_place_)
      return touching_ ? trf("Slide on to {0} and press in slowly. {1} felt.", name, felt)
                       : trf("Now touch {0} and press in slowly. {1} felt.", name, felt);
    return trf("Press in slowly and ease off again. {0} felt.", felt);
  }

  std::string solution() const override {
    return trf("The two curves agree by {0}; {1} were asked for.", agreement(), percentText(agree_));
  }
  std::string afterwards() const override {
    return trf("Your curve and the one that you felt agree by {0}.", agreement());
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("predictions"), double(predictions_), ""});
    if (first_agreement_ >= 0.0 && predictions_ > 1)
      out.push_back({N_("agreement of the first prediction"), 100.0 * first_agreement_, "%"});
    if (curves_.agreement) out.push_back({N_("agreement"), 100.0 * *curves_.agreement, "%"});
  }

  AtomSet from_, goal_atoms_;
  TargetName name_, goal_;
  double agree_ = 0.0, first_agreement_ = -1.0;
  bool slides_ = false, touching_ = false, on_place_ = false, missed_ = false;
  Vec3 start_A_{0.0}, along_{1, 0, 0};
  TaskCurves curves_;
  std::vector<double> counts_, sums_;
  Slide slide_;
  struct Waiting {
    double count = 0.0, sum_N = 0.0;
  };
  std::array<Waiting, kPoints> waiting_{};  // felt in a slide that is still too short to count
  int predictions_ = 0;
};

void checkPredict(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &along = spec.values["along"], &deep = spec.values["deep"], &predict = spec.values["predict"];
  if (along.selection.given() && deep.place.line)
    problems.push_back(
        problemAt(deep.place, tr("'deep' belongs to pressing in and 'along' to sliding"), tr("take one of them out")));
  if (spec.values.has("attempts") && !spec.values.has("agree"))
    problems.push_back(problemAt(spec.values["attempts"].place, tr("any prediction will do here, so none can be wrong"),
                                 tr("add a line 'agree: …', or take 'attempts' out")));
  if (along.selection.given() && !predict.selection.given())
    problems.push_back(
        problemAt(predict.place, tr("the way has no start"), tr("name the atoms where it begins in 'predict'")));
}

}  // namespace

TaskKind predictKind() {
  return {"predict",
          "Draw the curve of the force first, then feel it.",
          {.base_s = 90.0},
          {{.name = "predict",
            .type = ValueType::Target,
            .meaning = "Where to press, or where the path begins: atoms, or anywhere on the surface.",
            .required = true,
            .words = {"anywhere"}},
           {.name = "along",
            .type = ValueType::Selection,
            .meaning = "The force is felt along the path to these atoms; by default against the depth of a press."},
           {.name = "deep",
            .type = ValueType::Quantity,
            .meaning = "The depth of the press.",
            .fallback = "1 Å",
            .dimension = Dimension::Length,
            .min = 0.1,
            .max = 3.0},
           {.name = "most",
            .type = ValueType::Quantity,
            .meaning = "The upper end of the force axis.",
            .fallback = "3.3 N",
            .dimension = Dimension::Force,
            .min = 0.1,
            .max = 20.0},
           {.name = "agree",
            .type = ValueType::Count,
            .meaning =
                "The required agreement of the areas under both curves, in percent; by default any prediction counts.",
            .max = 100},
           attemptsKey("For 'agree': how many curves may be drawn, each before it is felt; by default unlimited. After "
                       "the last one the student continues.")},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Predict>(s, m); },
          &checkPredict};
}

}  // namespace moltact
