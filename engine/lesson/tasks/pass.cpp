// pass: lead the probe, or the centre of what the hand holds, through an opening in a ring of atoms, from one side to
// the other. A hand that is put down on the far side, or goes round the ring, has not passed.
#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/passable.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kPiece_A = 0.1;      // of a step between two samples, looked at by itself
constexpr double kStretched_A = 2.0;  // springs that are longer (root mean square) say that the atoms are elsewhere

/// An opening, and the two sides of it.
struct Opening {
  AtomRing ring;
  double deep_A = 2.0;  ///< from its plane to where a side begins

  double height_A(const Vec3& place) const { return glm::dot(place - ring.centre_A, ring.axis); }
  /// Within the cylinder of the ring.
  bool within(const Vec3& place) const {
    const Vec3 from = place - ring.centre_A;
    return glm::length(from - ring.axis * glm::dot(from, ring.axis)) < ring.radius_A;
  }
};

class Pass : public Task {
 public:
  Pass(const TaskSpec& spec, const Molecule& molecule) : Task(spec), name_(spec, "pass") {
    const SphereGrid scene(molecule.spheres);
    if (const auto ring = ringOf(scene, spec.values["pass"].selection.select(molecule)))
      opening_ = Opening{*ring, spec.values["deep"].number};
  }

  void takeInHand(std::shared_ptr<const HeldBody> body) override { body_goal_.emplace(body, PoseA{body->middle}); }

  void reset() override {
    Task::reset();
    way_.restart();
    side_ = 0;
    in_ = left_ = false;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    if (!opening_) return;
    bool continues = way_.tick(s, dt_s);
    if (body_goal_ && s.body && body_goal_->stretched(s, kStretched_A)) continues = false;
    const Vec3 to = way_.pose().place.A, from = continues ? way_.before().place.A : to;
    if (!continues) side_ = 0, in_ = false;
    const int pieces = std::max(1, saturateToInteger<int>(std::ceil(glm::distance(from, to) / kPiece_A)));
    for (int k = 1; k <= pieces && !passed_; ++k) look(from + (to - from) * (double(k) / pieces));
    setProgress(in_ ? 0.5 : 0.0);
    if (std::exchange(passed_, false)) finish();
  }

  void look(const Vec3& place) {
    const double height_A = opening_->height_A(place);
    if (std::abs(height_A) >= opening_->deep_A) {
      const int side = height_A > 0.0 ? 1 : -1;
      passed_ = in_ && side == -side_;
      side_ = side;
      in_ = false;
      return;
    }
    left_ = side_ != 0 && !opening_->within(place) ? in_ || left_ : left_ && !in_;
    in_ = side_ != 0 && opening_->within(place);
    if (!in_) side_ = 0;
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    if (!opening_) return {};
    const auto probe = bodyOfSpheres({{Vec3(0.0), view.probe_A}});
    const HeldBody& held = view.body ? *view.body : *probe;
    std::vector<StructureChoice> choices = view.structures;
    choices.insert(choices.begin(), {-1.0, &view.spheres});
    for (const StructureChoice& choice : choices) {
      const std::vector<PoseA> way =
          wayThroughOpening(PoseSpace(*choice.spheres, held), std::uint64_t(view.attempt) + 1);
      if (way.empty()) continue;
      HandPlan plan{{.to = way.front().place, .placed = true, .wait_s = 0.3}};
      if (choice.share >= 0.0) plan.push_back({.share = choice.share});
      plan.push_back({.turned_to = way.front().orientation});
      for (std::size_t k = 1; k < way.size(); ++k)
        plan.push_back({.to = way[k].place, .speed_A_per_s = k == 1 ? 30.0 : 5.0, .turned_to = way[k].orientation});
      plan.back().wait_s = 0.3;
      return plan;
    }
    return {};
  }

  // From outside through the opening: two searches that begin in it, toward either side.
  std::vector<PoseA> wayThroughOpening(const PoseSpace& space, std::uint64_t seed) const {
    constexpr int kStarts = 2000, kBest = 4;
    constexpr double kBack_A = 0.5;
    const Opening& o = *opening_;
    std::uint64_t random = seed;
    std::vector<std::pair<double, PoseA>> starts;
    const Vec3 across =
        glm::normalize(glm::cross(o.ring.axis, std::abs(o.ring.axis.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    const Vec3 up = glm::cross(o.ring.axis, across);
    for (int k = 0; k < kStarts; ++k) {
      const double r = o.ring.radius_A * 0.8 * std::sqrt(nextFraction(random)),
                   angle = 6.283185307179586 * nextFraction(random);
      const PoseA pose{{o.ring.centre_A + r * (across * std::cos(angle) + up * std::sin(angle))},
                       randomOrientation(random)};
      if (const double gap = space.gap_A(pose); gap >= PoseSpace::kClear_A) starts.emplace_back(gap, pose);
    }
    std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (int k = 0; k < kBest && std::size_t(k) < starts.size(); ++k)
      for (const double side : {1.0, -1.0}) {
        const auto stays = [&](double toward) {
          return [&o, toward](const PoseA& pose) {
            const double height_A = toward * o.height_A(pose.place.A);
            return height_A >= -kBack_A && (height_A >= o.deep_A || o.within(pose.place.A));
          };
        };
        const PoseA& start = starts[std::size_t(k)].second;
        std::vector<PoseA> beyond =
            freePath(space, start,
                     {.allowed = stays(-side),
                      .reached = [&](const PoseA& p) { return -side * o.height_A(p.place.A) >= o.deep_A + 0.3; },
                      .reach_A = o.deep_A + 3.0,
                      .seed = seed,
                      .max_tests = 100'000});
        if (beyond.empty()) continue;
        std::vector<PoseA> way = freePath(space, start, {.allowed = stays(side), .seed = seed, .max_tests = 200'000});
        if (way.empty()) continue;
        std::reverse(way.begin(), way.end());
        way.insert(way.end(), beyond.begin() + 1, beyond.end());
        return way;
      }
    return {};
  }

  std::string_view noPlan() const override { return N_("no free path was found through the opening"); }

  std::string guidance() const override {
    const std::string name = name_.text();
    if (in_) return tr("You are in the opening. Go on, through to the other side.");
    if (left_) return trf("You left the opening. Start again before {0}.", name);
    return holdsBody() ? trf("Lead what you hold through {0}.", name) : trf("Lead the probe through {0}.", name);
  }

  TargetName name_;
  std::optional<Opening> opening_;
  std::optional<PoseGoal> body_goal_;
  HeldWay way_;
  int side_ = 0;  // from which the opening was entered, or on which the hand is; 0: neither
  bool in_ = false, left_ = false, passed_ = false;
};

void checkPassRing(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> /*untouchable*/,
                   std::vector<Problem>& problems) {
  const Value& pass = spec.values["pass"];
  if (pass.selection.given() && pass.selection.select(molecule).size() < 3)
    problems.push_back(
        problemAt(pass.place, tr("three atoms at least make a ring to go through"), tr("name more of its atoms")));
}

}  // namespace

TaskKind passKind() {
  return {.name = "pass",
          .meaning = "Go through an opening from one side to the other, without a jump.",
          .time = {.base_s = 60.0},
          .keys = {{.name = "pass",
                    .type = ValueType::Selection,
                    .meaning = "The atoms round the opening, where they are at the start of the scene.",
                    .required = true},
                   {.name = "deep",
                    .type = ValueType::Quantity,
                    .meaning = "From the plane of these atoms to where either side begins.",
                    .fallback = "2 Å",
                    .dimension = Dimension::Length,
                    .min = 0.1,
                    .max = 100.0}},
          .make = [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            return std::make_unique<Pass>(s, m);
          },
          .check_molecule = &checkPassRing,
          .of_body = "its centre goes through."};
}

}  // namespace moltact
