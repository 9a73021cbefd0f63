// same: feel two things in turn in the dark and decide whether they are the same. Each pair is drawn independently, so
// earlier pairs reveal nothing.
#include <algorithm>
#include <array>
#include <iterator>

#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/sensitivity.h"
#include "engine/lesson/touch_keys.h"

namespace moltact {
namespace {

constexpr double kNear_A = 2.0;  // distance from the probe's surface to the surfaces of the place's atoms
constexpr std::string_view kPlace = "place", kRemove = "remove";

// The properties in one of which the second thing differs.
std::vector<std::string_view> differences() {
  std::vector<std::string_view> out;
  for (const KeySpec& key : comparedTouchKeys()) out.push_back(key.name);
  out.push_back(kPlace);
  out.push_back(kRemove);
  return out;
}

class Same : public Task {
 public:
  Same(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        here_(spec.values["same"].selection, molecule),
        there_(spec.values["place"].selection, molecule),
        trials_(static_cast<std::size_t>(spec.values["trials"].number)),
        fixed_(spec.values.has("seed")),
        seed_(static_cast<std::uint64_t>(spec.values["seed"].number)),
        time_s_(spec.values["for"].number),
        tell_(spec.values["tell"].text == "yes"),
        meter_(spec.values["meter"].text == "on"),
        before_(spec.values["asked"].text == "before"),
        asked_(!spec.values["asked"].text.empty()),
        by_place_(spec.values["place"].selection.given()),
        places_{spec.values["same"].selection, spec.values["place"].selection} {
    if (spec.values["forces"].place.line) feelField(molecule);
    if (before_) tell_ = false;
    // The second asking draws other pairs, also if the author gives the seed.
    if (fixed_ && asked_ && !before_) ++seed_;
    for (const auto& [key, spheres] : {std::pair(std::string_view("same"), &here_spheres_), {kPlace, &there_spheres_}})
      if (spec.values[key].selection.given())
        for (const std::uint32_t a : spec.values[key].selection.select(molecule))
          spheres->push_back(molecule.spheres[a]);
    needed_ = spec.values.has("right") ? std::min(trials_, static_cast<std::size_t>(spec.values["right"].number))
                                       : (3 * trials_ + 3) / 4;
    for (const TouchProperty& p : touchProperties())
      if (spec.values.has(p.key)) other_.touch.set(p, touchValueOf(p, spec.values[p.key]));
    // If atoms are removed from one of the two, both are felt at the same place, in the view of the scene.
    if (spec.values["remove"].selection.given())
      other_.removed = spec.values["remove"].selection.select(molecule);
    else if (spec.values["same"].selection.given())
      one_.facing = middle(spec.values["same"].selection, molecule);
    other_.facing = by_place_ ? middle(spec.values["place"].selection, molecule) : one_.facing;
    draw();
  }

  void drawBy(std::uint64_t seed) override {
    if (fixed_) return;
    seed_ = seed;
    drawn_ = 0;
    draw();
  }

  // Draws another order, because the student has learned the previous pairs.
  void reset() override {
    Task::reset();
    round_ = 0;
    first_round_.reset();
    presentation_ += 2;
    answered_ = failed_ = false;
    begin();
  }

  // A body is felt as long as the hand holds it. Contact or nearness would depend on the forces, and the words on the
  // screen would then tell the two apart. It begins before each place as it lies before the first one in the file.
  void takeInHand(std::shared_ptr<const HeldBody> body) override {
    body_ = std::move(body);
    const std::optional<PointA> one = one_.facing, other = other_.facing;
    if (!one || !other) return;  // not a form that judges a body
    middles_A_ = {one->A, other->A};
    for (const bool second : {false, true}) {
      TaskStage& stage = second ? other_ : one_;
      stage.facing.reset();
      stage.turned = stage.body_turned = kNoRotation;
      stage.body_begins = PointA{body_->middle.A + middles_A_[second] - middles_A_[0]};
      stage.in_hand = body_->atoms;
    }
  }

  void takeForces(std::shared_ptr<const SceneForces> forces) override { feelField(forces->molecule()); }

  TaskTrials trials() const override { return {trials_, tell_ ? judged_ : std::vector<bool>()}; }

 private:
  void feelField(const Molecule& molecule) {
    for (std::size_t k = 0; k < surfaces_.size(); ++k) surfaces_[k].emplace(places_[k], molecule);
  }

  struct Trial {
    bool second_first = false, differ = false;
  };

  static std::optional<PointA> middle(const Selection& selection, const Molecule& molecule) {
    const std::vector<std::uint32_t> atoms = selection.select(molecule);
    if (atoms.empty()) return std::nullopt;
    PointA sum;
    for (const std::uint32_t a : atoms) sum.A += molecule.spheres[a].centre_A / double(atoms.size());
    return sum;
  }

  void begin() {
    trial_ = right_ = 0;
    hits_ = alarms_ = 0;
    second_ = false;
    felt_s_ = 0.0;
    draw();
  }

  // Draws at random, for each pair, whether it differs and which of the two comes first.
  void draw() {
    std::uint64_t state = mixedSeed(seed_, drawn_++);
    order_.assign(trials_, {});
    for (Trial& t : order_) {
      t.differ = nextFraction(state) < 0.5;
      t.second_first = nextFraction(state) < 0.5;
    }
    judged_.clear();
  }

  bool showsOther() const {
    const Trial& t = order_[trial_];
    return t.second_first != (second_ && t.differ);
  }

  void onSample(const TouchSample& s, double dt_s) override {
    const bool there = by_place_ && showsOther();
    if (body_) {
      touching_ = s.body && !s.hovering;
      beside_ = false;
      if (touching_) felt_s_ = std::min(time_s_, felt_s_ + dt_s);
      return;
    }
    if (const auto& surface = surfaces_[there ? 1 : 0]) {
      // Only one of the two may have forces, so what counts depends on the place alone.
      const bool near = surface->has(s);
      touching_ = near || s.contact.touching();
      beside_ = touching_ && !near;
      if (near) felt_s_ = std::min(time_s_, felt_s_ + dt_s);
      return;
    }
    touching_ = s.contact.touching();
    beside_ = touching_ && !(there ? there_ : here_).touchedBy(s.contact) &&
              !near(there ? there_spheres_ : here_spheres_, s.contact.scp.A, s.probe_A);
    if (touching_ && !beside_) felt_s_ = std::min(time_s_, felt_s_ + dt_s);
  }

  // Which atoms block the probe may depend on the difference in question, and the message "beside the place" would
  // reveal it. Therefore everything close to the place counts.
  static bool near(const std::vector<Sphere>& spheres, const Vec3& scp_A, double probe_A) {
    return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& b) {
      return glm::distance(scp_A, b.centre_A) - b.radius_A - probe_A <= kNear_A;
    });
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    if (body_) {
      const TaskStage& stage = showsOther() ? other_ : one_;
      if (!stage.body_begins) return plan;
      const Vec3 from = stage.body_begins->A, to = middles_A_[by_place_ && showsOther()];
      const double far_A = glm::length(to - from);
      plan.push_back({.to = PointA{from}, .turned_to = kNoRotation, .placed = true, .wait_s = 0.05});
      plan.push_back({.to = PointA{from + (to - from) * (std::max(0.0, far_A - kNear_A) / std::max(far_A, 1e-6))},
                      .speed_A_per_s = 6.0,
                      .wait_s = time_s_ + 0.1});
      plan.push_back({.answer = TaskAnswer{.word = !second_ ? "next" : order_[trial_].differ ? "different" : "same"}});
      return plan;
    }
    const auto place = placeFor(view, placesToTouch(view, by_place_ && showsOther() ? there_ : here_));
    if (!place) return plan;
    comeTo(plan, *place, depthFor(view, 0.5), time_s_ + 0.1);
    plan.push_back({.answer = TaskAnswer{.word = !second_ ? "next" : order_[trial_].differ ? "different" : "same"}});
    return plan;
  }

  std::vector<TaskButton> currentButtons() const override {
    if (felt_s_ < time_s_) return {};
    if (!second_) return {{"next", N_("Feel the second")}};
    return {{"same", N_("The same"), 'S'}, {"different", N_("Different"), 'D'}};
  }

  TaskStage requestedStage() const override {
    TaskStage stage = showsOther() ? other_ : one_;
    stage.dark = stage.unnamed = true;
    stage.force_meter = meter_;
    stage.presentation = presentation_ + 1;
    return stage;
  }

  void onAnswer(const TaskAnswer& answer) override {
    felt_s_ = 0.0;
    touching_ = beside_ = false;
    ++presentation_;
    if (!second_) {
      second_ = true;
      if (failed_) judged_.clear();
      return;
    }
    const bool differ = order_[trial_].differ, said = answer.word == "different";
    hits_ += differ && said;
    alarms_ += !differ && said;
    right_ += differ == said;
    judged_.push_back(differ == said);
    last_right_ = differ == said;
    last_differed_ = differ;
    second_ = false;
    answered_ = true;
    failed_ = false;
    setProgress(double(++trial_) / double(trials_));
    if (trial_ < trials_) return;
    --trial_;
    if (round_ == 0) first_round_ = sensitivityNow(trials_);
    // The first asking is a measurement: one round, whatever the answers.
    if (before_ || right_ >= needed_) {
      finish();
      return;
    }
    if (missedLast()) return;
    failed_ = true;
    failed_right_ = right_;
    ++round_;
    const std::vector<bool> last = judged_;
    begin();
    judged_ = last;
    setProgress(0.0);
  }

  std::string guidance() const override {
    if (felt_s_ >= time_s_)
      return second_ ? tr("Were the two the same, or different?") : tr("Now go on to the second.");
    if (beside_)
      return led() ? tr("You are beside the place. It lies in the middle of the view: let go, and push there.")
                   : tr("You are beside the place: let go, and push elsewhere.");
    const std::size_t pair = trial_ + 1;
    if (touching_) {
      const std::string felt = timeText(felt_s_), wanted = timeText(time_s_);
      return second_ ? trf("Feel the second of pair {0} of {1}: {2} of {3}.", pair, trials_, felt, wanted)
                     : trf("Feel the first of pair {0} of {1}: {2} of {3}.", pair, trials_, felt, wanted);
    }
    if (body_) return guidanceOfBody(pair);
    const std::string touch =
        led() ? (second_ ? trf("Touch the second of pair {0} of {1}: push in the middle of the view.", pair, trials_)
                         : trf("Touch the first of pair {0} of {1}: push in the middle of the view.", pair, trials_))
        : second_ ? trf("Touch the second of pair {0} of {1}.", pair, trials_)
                  : trf("Touch the first of pair {0} of {1}.", pair, trials_);
    if (failed_)
      return trf("{0} of {1} right; {2} are needed. Another round: {3}", failed_right_, trials_, needed_, touch);
    if (tell_ && answered_ && !second_ && felt_s_ == 0.0) return judgement() + std::string(" ") + touch;
    return touch;
  }

  std::string guidanceOfBody(std::size_t pair) const {
    const std::string lead = second_ ? trf("Lead what you hold to the second of pair {0} of {1}.", pair, trials_)
                                     : trf("Lead what you hold to the first of pair {0} of {1}.", pair, trials_);
    if (failed_)
      return trf("{0} of {1} right; {2} are needed. Another round: {3}", failed_right_, trials_, needed_, lead);
    if (tell_ && answered_ && !second_ && felt_s_ == 0.0) return judgement() + std::string(" ") + lead;
    return lead;
  }

  // Whether the place is rotated to the front and into the middle of the view.
  bool led() const { return one_.facing.has_value(); }

  const char* judgement() const {
    if (last_right_) return last_differed_ ? tr("Right, they were different.") : tr("Right, they were the same.");
    return last_differed_ ? tr("No, they were different.") : tr("No, they were the same.");
  }

  std::string afterwards() const override {
    return before_ ? std::string() : trf("{0} of {1} right.", right_, trials_);
  }
  std::string solution() const override { return trf("{0} of {1} right; {2} were needed.", right_, trials_, needed_); }

  void measure(std::vector<TaskFigure>& out) const override {
    const std::size_t answered = done() ? trials_ : trial_;
    out.push_back({N_("trials"), double(answered), ""});
    out.push_back({N_("right"), double(right_), ""});
    out.push_back({N_("hits"), double(hits_), ""});
    out.push_back({N_("false alarms"), double(alarms_), ""});
    if (answered > 0) out.push_back({"d'", sensitivityNow(answered), ""});
    if (asked_ && first_round_) out.push_back({kFirstRoundSensitivity, *first_round_, ""});
    out.push_back({N_("rounds"), double(round_ + 1), ""});
  }

  // Of the pairs of this round that have been answered.
  double sensitivityNow(std::size_t answered) const {
    int differed = 0;
    for (std::size_t k = 0; k < answered; ++k) differed += order_[k].differ;
    return sensitivity(hits_, differed, alarms_, static_cast<int>(answered) - differed);
  }

  AtomSet here_, there_;
  std::vector<Sphere> here_spheres_, there_spheres_;  // their atoms, if they are named
  std::size_t trials_ = 8, needed_ = 6, trial_ = 0, right_ = 0, failed_right_ = 0;
  bool fixed_ = false;  // the author gives the seed of the orders
  std::uint64_t seed_ = 0, drawn_ = 0;
  double time_s_ = 1.0, felt_s_ = 0.0;
  bool tell_ = true, meter_ = true;
  bool before_ = false, asked_ = false;  // asked before the explanation; asked before and after it
  bool by_place_ = false;
  std::shared_ptr<const HeldBody> body_;  // what the hand holds; null: the probe
  std::array<Vec3, 2> middles_A_{};       // of the places, for a body
  std::array<Selection, 2> places_;
  std::array<std::optional<AtSurface>, 2> surfaces_;  // of both, if forces between atoms act on at least one
  std::optional<double> first_round_;                 // d' of the first round, once it has ended
  TaskStage one_, other_;
  std::vector<Trial> order_;
  std::vector<bool> judged_;  // of this round; until it begins, of the previous one
  int round_ = 0, presentation_ = 0, hits_ = 0, alarms_ = 0;
  bool second_ = false, touching_ = false, beside_ = false, answered_ = false, failed_ = false, last_right_ = false,
       last_differed_ = false;
};

void checkSame(const TaskSpec& spec, std::vector<Problem>& problems) {
  std::size_t given = 0;
  for (const std::string_view key : differences()) {
    const Value& value = spec.values[key];
    if (!value.place.line) continue;
    if (++given > 1)
      problems.push_back(problemAt(value.place, tr("the two things differ in one respect only"),
                                   tr("take this line out, or the other")));
  }
  const Value &same = spec.values["same"], &right = spec.values["right"], &place = spec.values["place"];
  if (given == 0)
    problems.push_back(
        problemAt(same.place, tr("nothing says how the second thing differs from the scene"),
                  trf("add a line that starts with {0} and a colon", joined(differences(), tr(" or ")))));
  if (spec.values["asked"].text == "before")
    for (const std::string_view key : {"right", "attempts", "tell"})
      if (const Value& value = spec.values[key]; value.place.line)
        problems.push_back(problemAt(
            value.place, trf("'{0}' plays no part in a task that is asked before: it is one round, not judged", key),
            tr("take this line out")));
  if (place.place.line && !same.selection.given())
    problems.push_back(problemAt(same.place, tr("two places are to be felt, but only one is named"),
                                 tr("name the atoms of the first in 'same'")));
  if (right.place.line && right.number > spec.values["trials"].number)
    problems.push_back(
        problemAt(right.place, tr("more right answers than there are trials"), tr("ask for no more than 'trials'")));
}

void checkPlaces(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                 std::vector<Problem>& problems) {
  const Value &one = spec.values["same"], &other = spec.values["place"], &removed = spec.values["remove"];
  const std::vector<std::uint32_t> atoms = AtomSet(one.selection, molecule).atoms();
  if (removed.selection.given()) {
    const std::vector<std::uint32_t> gone = removed.selection.select(molecule);
    const auto among = [](std::span<const std::uint32_t> some, std::uint32_t a) {
      return std::binary_search(some.begin(), some.end(), a);
    };
    if (!atoms.empty() && std::all_of(atoms.begin(), atoms.end(),
                                      [&](std::uint32_t a) { return among(gone, a) || among(untouchable, a); }))
      problems.push_back(problemAt(removed.place, tr("without these atoms nothing is left to be felt"),
                                   tr("take out fewer, or name others in 'same'")));
  }
  if (!one.selection.given() || !other.selection.given()) return;
  if (!atoms.empty() && atoms == other.selection.select(molecule))
    problems.push_back(problemAt(other.place, tr("the two places are the same atoms"), tr("name other atoms")));
}

// A body is felt beside atoms that are named, and forces act on it.
bool sameJudgesBody(const TaskSpec& spec) {
  return spec.values["same"].selection.given() && !spec.values.has("remove");
}

// The second thing must differ from the scene.
void checkSameScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  for (const TouchProperty& p : touchProperties()) {
    const Value& value = spec.values[p.key];
    if (value.place.line && touchValueOf(p, value) == touchValue(scene.touch, p))
      problems.push_back(problemAt(value.place, tr("the two things are the same: the scene has this value too"),
                                   tr("write another value, or change the scene's")));
  }
}

}  // namespace

TaskKind sameKind() {
  std::vector<KeySpec> keys{
      {.name = "same",
       .type = ValueType::Target,
       .meaning = "Where to touch: atoms, or anywhere on the surface. The first thing is the scene as it is.",
       .required = true,
       .words = {"anywhere"}}};
  for (KeySpec& key : comparedTouchKeys()) keys.push_back(std::move(key));
  const KeySpec others[]{
      {.name = kPlace, .type = ValueType::Selection, .meaning = "The second thing is these atoms."},
      {.name = kRemove,
       .type = ValueType::Selection,
       .meaning =
           "The second thing is the scene without these atoms, which are not felt. The view is that of the scene."},
      {.name = "trials",
       .type = ValueType::Count,
       .meaning = "The number of pairs. Each is drawn independently and differs with a probability of one half.",
       .fallback = "8",
       .min = 2,
       .max = 100},
      {.name = "right",
       .type = ValueType::Count,
       .meaning = "How many answers must be right; by default three quarters. Otherwise another round with other pairs "
                  "begins.",
       .min = 1,
       .max = 100},
      attemptsKey("The number of rounds; by default unlimited. After the last one the student continues without having "
                  "solved the task."),
      {.name = "for",
       .type = ValueType::Quantity,
       .meaning = "The minimum time to touch each thing.",
       .fallback = "1 s",
       .dimension = Dimension::Time,
       .min = 0.1,
       .max = 60.0},
      {.name = "tell",
       .type = ValueType::Word,
       .meaning = "Whether each answer is judged at once.",
       .fallback = "yes",
       .words = {"yes", "no"}},
      {.name = "meter",
       .type = ValueType::Word,
       .meaning = "Whether magnitude and direction of the force are displayed. Without a force-feedback device this "
                  "display is the only information.",
       .fallback = "on",
       .words = {"on", "off"}},
      {.name = "asked",
       .type = ValueType::Word,
       .meaning = "For a lesson that measures its effect: it asks the same task in two steps, `before` (one round "
                  "without judgement) and `after` its explanation, with other pairs. The report gives the gain in d' "
                  "between the first rounds.",
       .words = {"before", "after"}},
      {.name = "seed",
       .type = ValueType::Count,
       .meaning = "For studies: the seed of the pairs, which are then the same for all students and attempts; by "
                  "default they differ.",
       .max = 1e6}};
  keys.insert(keys.end(), std::begin(others), std::end(others));
  return {
      "same",
      "Feel two things in the dark and say whether they are the same, several times.",
      {.each_s = 20.0, .each = "trials", .each_what = "pair"},
      std::move(keys),
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Same>(s, m); },
      &checkSame,
      &checkPlaces,
      &checkSameScene,
      "with named atoms and without `remove`: each counts as felt while the hand holds the body. It begins before each "
      "place as it lies before the first one in the molecule's file, and the view is from the front.",
      &sameJudgesBody};
}

}  // namespace moltact
