// Formats the lines of an attempt.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/results/attempt_lines.h"
#include "engine/results/attempt_words.h"
#include "engine/results/line_values.h"

namespace moltact {
namespace {

using line_values::Json;

double rounded(double value) { return std::isfinite(value) ? std::round(value * 1000.0) / 1000.0 : 0.0; }

Json rounded(const Vec3& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

void append(Json& list, const Vec3& v) {
  for (int k = 0; k < 3; ++k) list.push_back(rounded(v[k]));
}

// With five decimals, the rounding error moves atoms of a body of 20 A by less than 0.001 A.
double roundedTurn(double value) { return std::isfinite(value) ? std::round(value * 1e5) / 1e5 : 0.0; }

void append(Json& list, const Quat& q) {
  for (const double value : {q.w, q.x, q.y, q.z}) list.push_back(roundedTurn(value));
}

std::string closed(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

Json written(const LessonOutline& lesson) {
  Json steps = Json::array();
  for (const StepOutline& s : lesson.steps) {
    Json step{{"id", s.id}, {"title", s.title}};
    if (s.aside) step["aside"] = true;
    for (const TaskOutline& t : s.tasks) {
      Json task{{"kind", t.kind}, {"say", t.say}};
      if (!t.goals.empty()) task["goals"] = t.goals;
      if (!t.asked.empty()) task["asked"] = t.asked;
      step["tasks"].push_back(std::move(task));
    }
    for (const QuestionOutline& q : s.questions) {
      Json question{{"id", q.id}, {"text", q.text}};
      if (!q.choices.empty()) question["choices"] = q.choices;
      if (!q.right.empty()) question["right"] = q.right;
      if (!q.tags.empty()) question["tags"] = q.tags;
      if (!q.goals.empty()) question["goals"] = q.goals;
      if (q.kind != AnswerKind::Marked) question["kind"] = kAnswerKinds[std::size_t(q.kind)];
      step["questions"].push_back(std::move(question));
    }
    steps.push_back(std::move(step));
  }
  Json out{{"file", lesson.file}, {"title", lesson.title}, {"hash", lesson.hash}};
  if (!lesson.goals.empty()) out["goals"] = lesson.goals;
  if (lesson.test) out["test"] = true;
  if (lesson.condition != Condition::Touch) out["condition"] = nameOf(lesson.condition);
  if (!lesson.study.study.empty()) {
    out["study"] = {{"name", lesson.study.study}, {"part", lesson.study.part}};
    if (!lesson.study.group.empty()) out["study"]["group"] = lesson.study.group;
  }
  out["steps"] = std::move(steps);
  return out;
}

constexpr double kUnturned = 2e-5;     // a body within this angle of the hand's orientation is regarded as having it
                                       // (unit: radian)
constexpr double kStraight_A = 0.002;  // a spring that equals SCP - HIP within rounding is not written

// Each kind of fact writes its keys after "kind" and "t".
struct FactWriter {
  Json& out;

  void operator()(const StepEntered& e) { out["step"] = e.step; }
  void operator()(const Answered& e) {
    out["step"] = e.step;
    out["question"] = e.question;
    out["attempt"] = e.attempt;
    if (!e.chosen.empty()) out["chosen"] = e.chosen;
    if (!e.written.empty()) out["written"] = e.written;
    out["right"] = e.right;
    out["by"] = nameOf(e.by);
  }
  void operator()(const HintOpened& e) { out["step"] = e.step; }
  void operator()(const TaskBegun& e) {
    out["step"] = e.step;
    out["task"] = e.task;
  }
  void operator()(const TaskDone& e) {
    out["step"] = e.step;
    out["task"] = e.task;
    out["took_s"] = rounded(e.took_s);
    out["by"] = nameOf(e.by);
    for (const LoggedFigure& f : e.figures)
      out["figures"].push_back({{"name", f.name}, {"value", std::isfinite(f.value) ? f.value : 0.0}, {"unit", f.unit}});
    if (!e.solved) out["solved"] = false;
  }
  void operator()(const CurveKept& e) {
    out["step"] = e.step;
    out["task"] = e.task;
    out["of"] = e.felt ? "felt" : "drawn";
    out["axis"] = e.axis;
    out["to_A"] = rounded(e.to_A);
    out["most_N"] = rounded(e.max_N);
    out["force_N"] = Json::array();
    for (const double f : e.force_N) out["force_N"].push_back(std::isfinite(f) ? Json(rounded(f)) : Json());
  }
  void operator()(const TouchBegan& e) { out["atoms"] = e.atoms; }
  void operator()(const TouchEnded& e) {
    out["from"] = rounded(e.from_s);
    out["atoms"] = e.atoms;
    out["crossings"] = e.crossings;
    out["peak_N"] = rounded(e.peak_N);
    out["mean_N"] = rounded(e.mean_N);
    out["path_A"] = rounded(e.path_A);
    out["by"] = nameOf(e.by);
  }
  void operator()(const InputChanged& e) {
    out["by"] = nameOf(e.by);
    out["device"] = e.device;
    out["gives_force"] = e.gives_force;
  }
  void operator()(const StageChanged& e) {
    out["molecule"] = e.molecule;
    out["file"] = e.file;
    out["atoms"] = e.atoms;
    out["A_per_mm"] = e.workspace.A_per_mm;
    out["centre_A"] = rounded(e.workspace.centre_A);
    out["turn"] = Json::array();
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) out["turn"].push_back(e.workspace.rotation[column][row]);
    for (const TouchProperty& p : touchProperties()) {
      const TouchValue value = touchValue(e.touch, p);
      if (!p.in_old_files && value == touchValue(TouchSetup(), p)) continue;
      Json& to = out[std::string(p.field)];
      std::visit([&](const auto& v) { to = v; }, value);
      if (const auto* number = std::get_if<double>(&value)) to = rounded(*number);
    }
    for (const ReadingOption& option : readingOptions())
      if (!isDefault(e.reading, option))
        std::visit([&](const auto member) { out[std::string(option.name)] = e.reading.*member; }, option.member);
    if (!e.held.empty()) out["held"] = e.held;
  }
  void operator()(const ViewChanged& e) {
    for (const double q : e.orientation) out["orientation"].push_back(roundedTurn(q));
    out["target_A"] = rounded(e.target_A);
    out["distance_A"] = rounded(e.distance_A);
  }
  void operator()(const HipChunk& e) {
    Json ms = Json::array(), hip = Json::array(), scp = Json::array(), force = Json::array(), atoms = Json::array();
    std::string features;
    Json displacement = Json::array();
    bool shaded = false;
    std::array<std::int32_t, 3> held{-1, -1, -1};
    const double from_s = e.samples.empty() ? 0.0 : e.samples.front().t_s;
    for (std::size_t i = 0; i < e.samples.size(); ++i) {
      const HipSample& s = e.samples[i];
      ms.push_back(std::llround((s.t_s - from_s) * 1000.0));
      append(hip, s.hip.A);
      features += kFeatureSigns[static_cast<std::size_t>(s.feature)];
      if (s.feature == Feature::Free) continue;
      append(scp, s.scp.A);
      append(force, s.force.N);
      append(displacement, s.displacement_A);
      shaded = shaded || glm::distance(s.displacement_A, s.scp.A - s.hip.A) > kStraight_A;
      if (s.atoms == held) continue;
      held = s.atoms;
      Json change = Json::array({i});
      for (const std::int32_t a : s.atoms)
        if (a >= 0) change.push_back(a);
      atoms.push_back(std::move(change));
    }
    out["from"] = rounded(from_s);
    out["ms"] = std::move(ms);
    out["feature"] = std::move(features);
    out["hip"] = std::move(hip);
    writeHeld(e);
    writeFields(e);
    if (scp.empty()) return;
    out["scp"] = std::move(scp);
    out["force"] = std::move(force);
    if (shaded) out["displacement"] = std::move(displacement);
    out["atoms"] = std::move(atoms);
  }
  // Writes the forces in a field: what is wanted in every sample, and what the hand gets where nothing is touched.
  void writeFields(const HipChunk& e) {
    Json wanted = Json::array(), free_force = Json::array();
    bool any = false;
    for (const HipSample& s : e.samples) {
      any = any || s.wanted_N;
      append(wanted, s.wanted_N.value_or(Vec3(0.0)));
      if (s.feature == Feature::Free) append(free_force, s.force.N);
    }
    if (!any) return;
    out["wanted"] = std::move(wanted);
    if (!free_force.empty()) out["free_force"] = std::move(free_force);
  }
  // Writes the hand's orientation, and the body's pose if any part of it differs from the default.
  void writeHeld(const HipChunk& e) {
    const auto holds = [](const HipSample& s) { return s.held.has_value(); };
    if (e.samples.empty() || !std::all_of(e.samples.begin(), e.samples.end(), holds)) return;
    Json orientation = Json::array(), body = Json::array(), body_orientation = Json::array();
    bool apart = false;
    for (const HipSample& s : e.samples) {
      const PoseA usual = s.bodyAtHand(s.held->orientation);
      append(orientation, s.held->orientation);
      append(body, s.held->body.place.A);
      append(body_orientation, s.held->body.orientation);
      apart = apart || glm::distance(usual.place.A, s.held->body.place.A) > kStraight_A ||
              glm::length(rotationBetween(usual.orientation, s.held->body.orientation)) > kUnturned;
    }
    out["orientation"] = std::move(orientation);
    if (!apart) return;
    out["body"] = std::move(body);
    out["body_orientation"] = std::move(body_orientation);
  }
  void operator()(const LessonReread& e) { out["lesson"] = written(e.lesson); }
  void operator()(const Resumed& e) {
    out["at"] = e.at;
    out["program"] = e.program;
    out["device"] = e.device;
    out["gives_force"] = e.gives_force;
  }
  void operator()(const ProgressMade& e) {
    out["step"] = e.step;
    out["done"] = e.done;
    out["of"] = e.of;
  }
  void operator()(const Predicted& e) {
    out["student"] = e.student;
    if (!e.step.empty()) out["step"] = e.step;
    out["question"] = e.question;
    out["text"] = e.text;
  }
  void operator()(const SessionClosed& e) { out["at"] = e.at; }
  void operator()(const TouchSoFar& e) {
    out["from"] = rounded(e.from_s);
    out["crossings"] = e.crossings;
    out["peak_N"] = rounded(e.peak_N);
    out["mean_N"] = rounded(e.mean_N);
    out["path_A"] = rounded(e.path_A);
    out["by"] = nameOf(e.by);
  }
  void operator()(const Heartbeat&) {}
  void operator()(const AtomsMoved& e) {
    out["by"] = e.by;
    if (!e.file.empty()) out["file"] = e.file;
    if (!e.detail.empty()) out["detail"] = e.detail;
    out["position"] = rounded(e.position);
    if (!e.engine.empty()) out["engine"] = e.engine;
  }
  void operator()(const OrderChanged& e) {
    out["step"] = e.step;
    out["question"] = e.question;
    out["rule"] = e.rule;
    out["does"] = e.skips ? "skip" : "go to";
    out["steps"] = e.steps;
  }
};

}  // namespace

std::string lineOf(const AttemptHeader& header) {
  return closed({{"kind", "attempt"},
                 {"format", header.format},
                 {"program", header.program},
                 {"began", header.began},
                 {"student", header.student},
                 {"device", header.device},
                 {"gives_force", header.gives_force},
                 {"lesson", written(header.lesson)}});
}

std::string gapLine(std::size_t lines) { return closed({{"kind", "gap"}, {"lines", lines}}); }

std::string lineOf(const AttemptEvent& event) {
  Json out{{"kind", kFactKinds[event.what.index()]}, {"t", rounded(event.t_s)}};
  std::visit(FactWriter{out}, event.what);
  return closed(out);
}

}  // namespace moltact
