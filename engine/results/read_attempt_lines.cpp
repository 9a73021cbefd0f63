// Parses the lines of an attempt.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "engine/haptics/body/held_body.h"
#include "engine/language/catalogue.h"
#include "engine/results/attempt_lines.h"
#include "engine/results/attempt_ranges.h"
#include "engine/results/attempt_words.h"
#include "engine/results/line_values.h"

namespace moltact {
namespace {

using namespace line_values;

std::int32_t atom(const Json& value) { return static_cast<std::int32_t>(number(value, "atoms")); }

InputKind inputKind(const Json& from) {
  const std::string name = text(from, "by", true);
  for (const InputKind w : {InputKind::Device, InputKind::Mouse, InputKind::Keyboard})
    if (name == nameOf(w)) return w;
  throw LineError{tr("'by' is none of device, mouse and keyboard")};
}

LessonOutline outline(const Json& from) {
  object(from, "lesson");
  LessonOutline out{text(from, "file", true), text(from, "title", true), text(from, "hash", false), {}};
  for (const Json& goal : listOrNone(from, "goals", kMaxSteps)) out.goals.push_back(text(goal, "goals"));
  out.test = from.contains("test") && flag(from, "test");
  if (const std::string condition = text(from, "condition", false); !condition.empty()) {
    const std::optional<Condition> known = conditionNamed(condition);
    if (!known) throw LineError{trf("'{0}' is no condition of a study", condition)};
    out.condition = *known;
  }
  if (from.contains("study")) {
    const Json& study = object(from["study"], "study");
    out.study = {text(study, "name", true), text(study, "part", true), text(study, "group", false)};
  }
  const auto goalsOf = [](const Json& of) {
    std::vector<std::size_t> goals;
    for (const Json& g : listOrNone(of, "goals", kMaxSteps)) goals.push_back(count(g, "goals"));
    return goals;
  };
  for (const Json& step : list(from, "steps", kMaxSteps)) {
    StepOutline& s = out.steps.emplace_back(
        StepOutline{text(object(step, "steps"), "id", true), text(step, "title", false), {}, {}});
    s.aside = step.contains("aside") && flag(step, "aside");
    for (const Json& task : listOrNone(step, "tasks"))
      s.tasks.push_back({text(object(task, "tasks"), "kind", true), text(task, "say", false), goalsOf(task),
                         text(task, "asked", false)});
    for (const Json& question : listOrNone(step, "questions")) {
      QuestionOutline& q = s.questions.emplace_back(QuestionOutline{
          text(object(question, "questions"), "id", true), text(question, "text", false), {}, {}, AnswerKind::Marked});
      for (const Json& choice : listOrNone(question, "choices")) q.choices.push_back(text(choice, "choices"));
      for (const Json& right : listOrNone(question, "right")) q.right.push_back(count(right, "right"));
      for (const Json& tag : listOrNone(question, "tags")) q.tags.push_back(text(tag, "tags"));
      q.goals = goalsOf(question);
      if (const std::string kind = text(question, "kind", false); !kind.empty()) {
        const auto known = std::find(kAnswerKinds.begin(), kAnswerKinds.end(), kind);
        if (known == kAnswerKinds.end()) throw LineError{trf("'{0}' is no kind of question", kind)};
        q.kind = AnswerKind(known - kAnswerKinds.begin());
      }
    }
  }
  return out;
}

// The rotation given by four numbers of a list, normalized to remove rounding errors.
Quat turnAt(const std::vector<double>& numbers, std::size_t at, const char* key) {
  const Quat q(numbers[at], numbers[at + 1], numbers[at + 2], numbers[at + 3]);
  if (!(std::abs(glm::length(q) - 1.0) <= 1e-2)) throw LineError{trf("'{0}' is no rotation", key)};
  return glm::normalize(q);
}

// Lines with a held body contain the hand's orientation.
void readHeld(const Json& from, HipChunk& chunk) {
  if (!from.contains("orientation")) return;
  const std::size_t n = chunk.samples.size();
  const std::vector<double> orientation = numbers(from, "orientation", 4 * n);
  std::vector<double> body, body_orientation;
  if (from.contains("body")) {
    body = numbers(from, "body", 3 * n);
    body_orientation = numbers(from, "body_orientation", 4 * n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    HipSample& s = chunk.samples[i];
    HeldSample& held = s.held.emplace();
    held.orientation = turnAt(orientation, 4 * i, "orientation");
    held.body = body.empty() ? s.bodyAtHand(held.orientation)
                             : PoseA{{{body[3 * i], body[3 * i + 1], body[3 * i + 2]}},
                                     turnAt(body_orientation, 4 * i, "body_orientation")};
  }
}

// Lines of a hand in a field contain the wanted force of every sample; (0, 0, 0) where no field acts.
void readFields(const Json& from, HipChunk& chunk) {
  if (!from.contains("wanted")) return;
  const auto& samples = chunk.samples;
  const auto free = static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.end(), [](const HipSample& s) { return s.feature == Feature::Free; }));
  const std::vector<double> wanted = numbers(from, "wanted", 3 * samples.size());
  const std::vector<double> force = free ? numbers(from, "free_force", 3 * free) : std::vector<double>();
  for (std::size_t i = 0, k = 0; i < samples.size(); ++i) {
    HipSample& s = chunk.samples[i];
    const Vec3 wanted_N(wanted[3 * i], wanted[3 * i + 1], wanted[3 * i + 2]);
    if (wanted_N != Vec3(0.0)) s.wanted_N = wanted_N;
    if (s.feature != Feature::Free) continue;
    s.force.N = {force[k], force[k + 1], force[k + 2]};
    k += 3;
  }
}

HipChunk hipChunk(const Json& from) {
  const Json& ms = list(from, "ms");
  const std::string features = text(from, "feature", true);
  const std::size_t n = ms.size();
  if (features.size() != n) throw LineError{tr("'feature' and 'ms' differ in length")};
  const std::size_t touching = n - static_cast<std::size_t>(std::count(features.begin(), features.end(), '.'));
  const std::vector<double> hip = numbers(from, "hip", 3 * n);
  std::vector<double> scp, force, displacement;
  if (touching) {
    scp = numbers(from, "scp", 3 * touching);
    force = numbers(from, "force", 3 * touching);
    if (from.contains("displacement")) displacement = numbers(from, "displacement", 3 * touching);
  }
  const double from_s = numberAt(from, "from");
  const Json& changes = listOrNone(from, "atoms");
  HipChunk out;
  std::array<std::int32_t, 3> held{-1, -1, -1};
  std::size_t change = 0;
  for (std::size_t i = 0, k = 0; i < n; ++i) {
    HipSample s;
    s.t_s = from_s + number(ms[i], "ms") / 1000.0;
    s.hip.A = s.scp.A = {hip[3 * i], hip[3 * i + 1], hip[3 * i + 2]};
    const std::size_t feature = kFeatureSigns.find(features[i]);
    if (feature == std::string_view::npos) throw LineError{tr("'feature' has a sign that is not known")};
    s.feature = static_cast<Feature>(feature);
    if (s.feature != Feature::Free) {
      s.scp.A = {scp[k], scp[k + 1], scp[k + 2]};
      s.force.N = {force[k], force[k + 1], force[k + 2]};
      s.displacement_A =
          displacement.empty() ? s.scp.A - s.hip.A : Vec3(displacement[k], displacement[k + 1], displacement[k + 2]);
      k += 3;
      if (change < changes.size() && changes[change].is_array() && !changes[change].empty() &&
          count(changes[change][0], "atoms") == i) {
        held = {-1, -1, -1};
        for (std::size_t a = 1; a < std::min<std::size_t>(4, changes[change].size()); ++a)
          held[a - 1] = atom(changes[change][a]);
        ++change;
      }
      s.atoms = held;
    }
    out.samples.push_back(s);
  }
  readHeld(from, out);
  readFields(from, out);
  return out;
}

std::vector<std::int32_t> atoms(const Json& from) {
  std::vector<std::int32_t> out;
  for (const Json& a : list(from, "atoms", kMaxTouched)) out.push_back(atom(a));
  return out;
}

// Reads the value of a property or option from its key.
template <class T>
void take(T& to, const Json& from, std::string_view name) {
  const std::string key(name);
  if constexpr (std::is_same_v<T, std::string>)
    to = text(from, key.c_str(), true);
  else if constexpr (std::is_same_v<T, bool>)
    to = flag(from, key.c_str());
  else
    to = static_cast<T>(numberAt(from, key.c_str()));
}

TouchSetup touch(const Json& from) {
  TouchSetup out;
  for (const TouchProperty& p : touchProperties())
    if (p.in_old_files || from.contains(p.field))
      std::visit([&](const auto member) { take(out.*member, from, p.field); }, p.member);
  return out;
}

ReadOptions reading(const Json& from) {
  ReadOptions out;
  for (const ReadingOption& option : readingOptions()) {
    if (!from.contains(option.name)) continue;
    ReadOptions options;
    std::visit([&](const auto member) { take(options.*member, from, option.name); }, option.member);
    readText(out, option, textOf(options, option));  // missing keys keep their defaults
  }
  return out;
}

// In the order of kFactKinds.
std::optional<AttemptFact> factOf(const std::string& kind, const Json& j) {
  if (kind == "step") return StepEntered{text(j, "step", true)};
  if (kind == "answer") {
    Answered a{text(j, "step", true),
               text(j, "question", true),
               static_cast<int>(numberAt(j, "attempt")),
               {},
               text(j, "written", false),
               flag(j, "right"),
               inputKind(j)};
    for (const Json& c : listOrNone(j, "chosen")) a.chosen.push_back(count(c, "chosen"));
    return a;
  }
  if (kind == "hint") return HintOpened{text(j, "step", true)};
  if (kind == "task") return TaskBegun{text(j, "step", true), countAt(j, "task")};
  if (kind == "done") {
    TaskDone d{text(j, "step", true), countAt(j, "task"), numberOr(j, "took_s", 0.0), inputKind(j), {}};
    for (const Json& f : listOrNone(j, "figures", kMaxFigures))
      d.figures.push_back({text(object(f, "figures"), "name", true), numberAt(f, "value"), text(f, "unit", false)});
    if (j.contains("solved")) d.solved = flag(j, "solved");
    return d;
  }
  if (kind == "curve") {
    CurveKept c{text(j, "step", true),
                countAt(j, "task"),
                text(j, "of", true) == "felt",
                text(j, "axis", false),
                numberAt(j, "to_A"),
                numberAt(j, "most_N"),
                {}};
    for (const Json& f : list(j, "force_N", kMaxCurveValues))
      c.force_N.push_back(f.is_null() ? std::nan("") : number(f, "force_N"));
    return c;
  }
  if (kind == "touch") return TouchBegan{atoms(j)};
  if (kind == "released")
    return TouchEnded{numberAt(j, "from"),
                      atoms(j),
                      j.contains("crossings") ? countAt(j, "crossings") : 0,
                      numberAt(j, "peak_N"),
                      numberOr(j, "mean_N", 0.0),
                      numberOr(j, "path_A", 0.0),
                      inputKind(j)};
  if (kind == "input") return InputChanged{inputKind(j), text(j, "device", false), flag(j, "gives_force")};
  if (kind == "stage") {
    StageChanged s{text(j, "molecule", true), text(j, "file", true), countAt(j, "atoms"), {}, touch(j), reading(j)};
    s.workspace.A_per_mm = numberAt(j, "A_per_mm");
    s.workspace.centre_A = vector(j, "centre_A");
    const std::vector<double> turn = numbers(j, "turn", 9);
    for (int k = 0; k < 9; ++k) s.workspace.rotation[k / 3][k % 3] = turn[static_cast<std::size_t>(k)];
    constexpr double kOff = 1e-3;
    const glm::dmat3 product = glm::transpose(s.workspace.rotation) * s.workspace.rotation;
    for (int k = 0; k < 9; ++k)
      if (std::abs(product[k / 3][k % 3] - (k % 4 == 0)) > kOff || glm::determinant(s.workspace.rotation) < 0.0)
        throw LineError{trf("'{0}' is no rotation", "turn")};
    for (const Json& a : listOrNone(j, "held", kMaxHeldAtoms)) {
      s.held.push_back(static_cast<std::uint32_t>(count(a, "held")));
      if (s.held.size() > 1 && s.held.back() <= *(s.held.end() - 2)) throw LineError{tr("'held' does not ascend")};
      if (s.held.back() >= s.atoms) throw LineError{tr("'held' names an atom that there is not")};
    }
    return s;
  }
  if (kind == "view") {
    const std::vector<double> q = numbers(j, "orientation", 4);
    turnAt(q, 0, "orientation");
    return ViewChanged{{q[0], q[1], q[2], q[3]}, vector(j, "target_A"), numberAt(j, "distance_A")};
  }
  if (kind == "trace") return hipChunk(j);
  if (kind == "lesson") return LessonReread{outline(need(j, "lesson"))};
  if (kind == "resumed")
    return Resumed{text(j, "at", true), text(j, "program", false), text(j, "device", false), flag(j, "gives_force")};
  if (kind == "progress") return ProgressMade{text(j, "step", true), countAt(j, "done"), countAt(j, "of")};
  if (kind == "prediction")
    return Predicted{text(j, "student", true), text(j, "step", false), text(j, "question", true),
                     text(j, "text", true)};
  if (kind == "touching")
    return TouchSoFar{numberAt(j, "from"),   countAt(j, "crossings"), numberAt(j, "peak_N"),
                      numberAt(j, "mean_N"), numberAt(j, "path_A"),   inputKind(j)};
  if (kind == "still") return Heartbeat{};
  if (kind == "moved")
    return AtomsMoved{text(j, "by", true), text(j, "file", false), text(j, "detail", false), numberAt(j, "position"),
                      text(j, "engine", false)};
  if (kind == kFormerStateKind)
    return AtomsMoved{std::string(kMovedByStates), text(j, "file", true), text(j, "superposed_on", false),
                      numberAt(j, "share")};
  if (kind == "way") {
    OrderChanged w{
        text(j, "step", true), text(j, "question", true), text(j, "rule", true), text(j, "does", true) == "skip", {}};
    for (const Json& s : list(j, "steps", kMaxSteps)) w.steps.push_back(text(s, "steps"));
    return w;
  }
  if (kind == "left") return SessionClosed{text(j, "at", true)};
  return std::nullopt;
}

Problem noObject() { return {{}, 0, 0, tr("it is no JSON object"), tr("it is passed over")}; }

Json parsed(std::string_view line) {
  if (line.size() > kLongestLine) return Json(Json::value_t::discarded);
  return Json::parse(line.begin(), line.end(), nullptr, false);
}

}  // namespace

std::string_view leadingKind(std::string_view line) {
  // Consumes one token after the other, with the blanks that JSON allows between them.
  const auto take = [&](std::string_view piece) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r\n"), line.size()));
    if (!line.starts_with(piece)) return false;
    line.remove_prefix(piece.size());
    return true;
  };
  if (!take("{") || !take("\"kind\"") || !take(":") || !take("\"")) return {};
  return line.substr(0, line.find('"'));
}

bool mayBeginAttempt(std::string_view line) {
  const std::size_t end = line.find('\n');
  std::string dense;
  for (const char c : line.substr(0, std::min(end, 4 * kHeaderBegins.size())))
    if (c != ' ' && c != '\t' && c != '\r') dense += c;
  if (dense.starts_with(kHeaderBegins) || line.empty()) return true;
  return end == std::string_view::npos && !dense.empty() && kHeaderBegins.starts_with(dense);
}

namespace {

// Stops parsing at the value of "began" in the outermost object.
class BeganReader : public nlohmann::json_sax<Json> {
 public:
  std::string began;
  bool null() override { return wanted_ = false, true; }
  bool boolean(bool) override { return wanted_ = false, true; }
  bool number_integer(number_integer_t) override { return wanted_ = false, true; }
  bool number_unsigned(number_unsigned_t) override { return wanted_ = false, true; }
  bool number_float(number_float_t, const string_t&) override { return wanted_ = false, true; }
  bool binary(binary_t&) override { return true; }
  bool string(string_t& value) override {
    if (wanted_) began = value;
    return !wanted_;
  }
  bool start_object(std::size_t) override { return ++depth_, wanted_ = false, true; }
  bool end_object() override { return --depth_, true; }
  bool start_array(std::size_t) override { return ++depth_, wanted_ = false, true; }
  bool end_array() override { return --depth_, true; }
  bool key(string_t& name) override { return wanted_ = depth_ == 1 && name == "began", true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  int depth_ = 0;
  bool wanted_ = false;
};

}  // namespace

std::string beginTimeOf(std::string_view line) {
  BeganReader reader;
  Json::sax_parse(line.begin(), line.end(), &reader);
  return reader.began;
}

Expected<AttemptHeader> readHeaderLine(std::string_view line) {
  const Json j = parsed(line);
  const Problem none{
      {}, 0, 0, tr("it is no attempt at a lesson"), tr("attempts are the .jsonl files that Moltact writes")};
  if (!j.is_object() || !j.contains("kind") || j["kind"] != "attempt") return none;
  try {
    AttemptHeader h;
    h.format = static_cast<int>(numberAt(j, "format"));
    h.program = text(j, "program", false);
    h.began = text(j, "began", true);
    h.student = text(j, "student", false);
    h.device = text(j, "device", false);
    h.gives_force = j.contains("gives_force") && flag(j, "gives_force");
    h.lesson = outline(need(j, "lesson"));
    return h;
  } catch (const LineError& lacking) {
    return Problem{{}, 0, 0, trf("its first line is damaged: {0}", lacking.what), none.remedy};
  }
}

Expected<std::optional<AttemptEvent>> readEventLine(std::string_view line) {
  const Json j = parsed(line);
  if (!j.is_object()) return noObject();
  try {
    if (text(j, "kind", true) == "gap")
      return Problem{{},
                     0,
                     0,
                     trf("{0} lines are missing here: the disk took none while they came",
                         static_cast<long long>(numberAt(j, "lines"))),
                     tr("what the report says of the time between is not complete")};
    const double t_s = numberAt(j, "t");
    std::optional<AttemptFact> fact = factOf(text(j, "kind", true), j);
    if (!fact) return std::optional<AttemptEvent>();
    return std::optional<AttemptEvent>(AttemptEvent{t_s, *std::move(fact)});
  } catch (const LineError& lacking) {
    return Problem{{}, 0, 0, lacking.what, tr("the line is passed over")};
  }
}

}  // namespace moltact
