// contacts: touch several atoms at once with the probe or with what the hand holds, for a time.
#include <algorithm>

#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

class Contacts : public Task {
 public:
  Contacts(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        target_(spec.values["contacts"].selection, molecule),
        name_(spec, "contacts"),
        least_(std::size_t(spec.values["least"].number)),
        for_s_(spec.values["for"].number) {}

  void reset() override {
    Task::reset();
    watch_.restart();
    now_ = most_ = 0;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    now_ = 0;
    if (s.contact.touching() && s.contact.fault == Fault::None)
      for (std::size_t k = 0; k < s.touched.count; ++k) now_ += target_.has(s.touched.atoms[k]);
    most_ = std::max(most_, now_);
    watch_.tick(now_ >= least_, dt_s, kSlip_s);
    setProgress(watch_.elapsed_s() / for_s_);
    if (watch_.elapsed_s() >= for_s_) finish();
  }

  // A body is pressed from another side and in another orientation at each attempt, a probe into the places between
  // atoms.
  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    HandPlanInput turned = view;
    std::uint64_t random = std::uint64_t(view.attempt);
    if (view.body && view.attempt > 0) turned.orientation = randomOrientation(random);
    const char* feature = view.body || least_ < 2 ? "" : least_ == 2 ? "crease" : "pit";
    const auto place = placeFor(view, placesToTouch(turned, target_, feature));
    if (!place) return plan;
    if (view.body) {
      const double far_A = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.body->reach_A;
      plan.push_back({.to = PointA{place->scp_A + place->outward * far_A}, .placed = true, .wait_s = 0.1});
      plan.push_back({.turned_to = turned.orientation});
    }
    comeTo(plan, *place, 0.5 + 0.25 * (view.attempt % 6), for_s_ + 0.5);
    return plan;
  }

  std::string guidance() const override {
    const std::string name = name_.text();
    if (now_ >= least_) return trf("Hold it: {0} of {1}.", timeText(watch_.elapsed_s()), timeText(for_s_));
    if (now_ > 0)
      return trnf("You touch {0} atom at once; {1} are asked for.", "You touch {0} atoms at once; {1} are asked for.",
                  now_, now_, least_);
    return holdsBody() ? trf("Move what you hold to {0} until it stops you.", name)
                       : trf("Move the probe to {0} until it stops you.", name);
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("most atoms at once"), double(most_), ""});
  }

  AtomSet target_;
  TargetName name_;
  std::size_t least_ = 3;
  double for_s_ = 1.0;
  Stopwatch watch_;
  std::size_t now_ = 0, most_ = 0;
};

void checkContactsScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  constexpr double kMostOfProbe = 3.0;
  const Value& least = spec.values["least"];
  if (!scene.in_hand.given() && least.number > kMostOfProbe)
    problems.push_back(problemAt(least.place, tr("a probe touches three atoms at once at most"),
                                 tr("write 3 or less, or give the hand a body with 'in-hand: …'")));
}

void checkContactsAtoms(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                std::vector<Problem>& problems) {
  const Value& contacts = spec.values["contacts"];
  if (!contacts.selection.given()) return;
  const std::vector<std::uint32_t> atoms = contacts.selection.select(molecule);
  const auto felt = std::size_t(std::count_if(atoms.begin(), atoms.end(), [&](std::uint32_t a) {
    return !std::binary_search(untouchable.begin(), untouchable.end(), a);
  }));
  if (felt > 0 && double(felt) < spec.values["least"].number)
    problems.push_back(problemAt(spec.values["least"].place.line ? spec.values["least"].place : contacts.place,
                                 trf("only {0} of these atoms can be touched", felt),
                                 tr("name more atoms, or ask for fewer at once")));
}

}  // namespace

TaskKind contactsKind() {
  return {.name = "contacts",
          .meaning = "Touch several atoms at once, for a time.",
          .keys = {{.name = "contacts",
                    .type = ValueType::Target,
                    .meaning = "The atoms that count, or anywhere.",
                    .required = true,
                    .words = {"anywhere"}},
                   {.name = "least",
                    .type = ValueType::Count,
                    .meaning = "How many of them at once, at least; a probe touches three at most.",
                    .fallback = "3",
                    .least = 1,
                    .most = double(TouchedAtoms::kMax)},
                   {.name = "for",
                    .type = ValueType::Quantity,
                    .meaning = "How long; slips under 0.3 s are forgiven.",
                    .fallback = "1 s",
                    .dimension = Dimension::Time,
                    .least = 0.1,
                    .most = 600.0}},
          .make = [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
            return std::make_unique<Contacts>(s, m);
          },
          .check_molecule = &checkContactsAtoms,
          .check_scene = &checkContactsScene,
          .of_body = "every atom counts that any of the body's atoms touches."};
}

}  // namespace moltact
