// contacts: press what the hand holds against the molecule so that several of its atoms touch at once, for a time. Judged
// from the body's pose and the atoms' radii, where the atoms are at the start of the scene.
#include <algorithm>

#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kTouching_A = 0.05;  // an atom of the body with a smaller gap touches

class Contacts : public Task {
 public:
  Contacts(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        target_(spec.values["contacts"].selection, molecule),
        name_(spec, "contacts"),
        count_(std::size_t(spec.values["count"].number)),
        for_s_(spec.values["for"].number),
        spheres_(molecule.spheres) {}

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    left_out_.assign(untouchable.begin(), untouchable.end());
  }

  void takeInHand(std::shared_ptr<const HeldBody> body) override {
    body_ = std::move(body);
    std::vector<std::uint32_t> out;
    std::set_union(left_out_.begin(), left_out_.end(), body_->atoms.begin(), body_->atoms.end(),
                   std::back_inserter(out));
    scene_ = std::make_shared<const SphereGrid>(spheres_, out);
  }

  void reset() override {
    Task::reset();
    watch_.restart();
    now_ = most_ = 0;
  }

 private:
  std::size_t touchingAt(const PoseA& pose) const {
    std::size_t count = 0;
    for (const Sphere& s : body_->spheres) {
      const Vec3 centre = pose.place.A + pose.orientation * s.centre_A;
      bool touches = false;
      scene_->visitNear(centre, s.radius_A + kTouching_A, [&](std::uint32_t atom, const Sphere& other) {
        touches = target_.has(std::int32_t(atom)) &&
                  glm::distance(centre, other.centre_A) < s.radius_A + other.radius_A + kTouching_A;
        return !touches;
      });
      count += touches;
    }
    return count;
  }

  void onSample(const TouchSample& s, double dt_s) override {
    const bool touches =
        scene_ && s.body && finite(s.body->place.A) && s.contact.touching() && s.contact.fault == Fault::None;
    now_ = touches ? touchingAt(*s.body) : 0;
    most_ = std::max(most_, now_);
    watch_.tick(now_ >= count_, dt_s, kSlip_s);
    setProgress(watch_.elapsed_s() / for_s_);
    if (watch_.elapsed_s() >= for_s_) finish();
  }

  // The body is pressed in another orientation and deeper at each attempt, so that it tilts until more atoms touch.
  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlanInput turned = view;
    std::uint64_t random = std::uint64_t(view.attempt);
    if (view.attempt > 0) turned.orientation = randomOrientation(random);
    const auto place = placeFor(view, placesToTouch(turned, target_));
    if (!place) return {};
    const double far_A = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.hand().reach_A();
    HandPlan plan{{.to = PointA{place->scp_A + place->outward * far_A}, .placed = true, .wait_s = 0.1},
                  {.turned_to = turned.orientation}};
    comeTo(plan, *place, 1.0 + 0.5 * (view.attempt % 6), for_s_ + 0.5);
    return plan;
  }

  std::string guidance() const override {
    if (now_ >= count_) return trf("Hold it: {0} of {1}.", timeText(watch_.elapsed_s()), timeText(for_s_));
    // A body of a made molecule has balls and not atoms, so the sentence names neither.
    if (now_ > 0) return trf("Touching at once: {0} of {1}.", now_, count_);
    return trf("Move what you hold to {0} until it stops you.", name_.text());
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("most atoms at once"), double(most_), ""});
  }

  AtomSet target_;
  TargetName name_;
  std::size_t count_ = 3;
  double for_s_ = 1.0;
  SharedArray<Sphere> spheres_;
  std::vector<std::uint32_t> left_out_;
  std::shared_ptr<const HeldBody> body_;
  std::shared_ptr<const SphereGrid> scene_;  // without what the hand holds
  Stopwatch watch_;
  std::size_t now_ = 0, most_ = 0;
};

void checkContactsScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (!scene.in_hand.given())
    problems.push_back(problemAt(spec.place, tr("'contacts' needs a body in the hand"),
                                 tr("write 'in-hand: …' with its atoms in this step's scene")));
  if (!scene.then.molecule.empty())
    problems.push_back(problemAt(
        spec.place, tr("'contacts' judges the atoms where they are at the start of the scene, and 'then' moves them"),
        tr("leave out 'then', or use 'dock'")));
}

void checkContactsBody(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                       std::span<const StructureChoice>, std::vector<Problem>& problems) {
  const Value &count = spec.values["count"], &contacts = spec.values["contacts"];
  if (double(body->spheres.size()) < count.number)
    problems.push_back(problemAt((count.place.line ? count : contacts).place,
                                 trf("the body has only {0} atoms", body->spheres.size()),
                                 tr("ask for fewer at once, or take more atoms in the hand")));
}

}  // namespace

TaskKind contactsKind() {
  return {.name = "contacts",
          .meaning = "Press what the hand holds so that several of its atoms touch at once, for a time.",
          .time = {.base_s = 40.0},
          .keys = {{.name = "contacts",
                    .type = ValueType::Target,
                    .meaning = "The atoms of the molecule to touch, where they are at the start of the scene; or "
                               "anywhere.",
                    .required = true,
                    .words = {"anywhere"}},
                   {.name = "count",
                    .type = ValueType::Count,
                    .meaning = "How many atoms of the body touch at once, at least. An atom touches within 0.05 Å.",
                    .fallback = "3",
                    .min = 1.0,
                    .max = 100.0},
                   {.name = "for",
                    .type = ValueType::Quantity,
                    .meaning = "How long; interruptions shorter than 0.3 s are ignored.",
                    .fallback = "1 s",
                    .dimension = Dimension::Time,
                    .min = 0.1,
                    .max = 600.0}},
          .make = [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            return std::make_unique<Contacts>(s, m);
          },
          .check_scene = &checkContactsScene,
          .of_body = "each of its atoms that touches counts once.",
          .check_body = &checkContactsBody};
}

}  // namespace moltact
