#include "engine/results/learning_record.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "engine/core/content_hash.h"

namespace moltact {
namespace {

using Seconds = std::chrono::system_clock::time_point;

// The inverse of utcText().
std::optional<Seconds> timeOf(std::string_view utc) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  if (utc.size() != kForm.size()) return std::nullopt;
  std::array<int, 6> part{};
  std::size_t which = 0;
  for (std::size_t k = 0; k < utc.size(); ++k) {
    const bool digit = utc[k] >= '0' && utc[k] <= '9';
    if (digit != (kForm[k] == '0') || (!digit && utc[k] != kForm[k])) return std::nullopt;
    if (digit)
      part[which] = part[which] * 10 + (utc[k] - '0');
    else
      ++which;
  }
  using namespace std::chrono;
  const year_month_day date{year{part[0]}, month{unsigned(part[1])}, day{unsigned(part[2])}};
  if (!date.ok()) return std::nullopt;
  return sys_days(date) + hours(part[3]) + minutes(part[4]) + seconds(part[5]);
}

std::string asciiIdOf(std::string_view id) {
  std::string out;
  for (const char c : id) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-') {
      out += c;
    } else {
      constexpr const char* kDigits = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      out += {'.', kDigits[byte >> 4], kDigits[byte & 15u]};
    }
  }
  return out;
}

std::string shortened(std::string id) {
  if (id.size() <= kMaxInteractionId) return id;
  const std::string hash = contentHash(id);
  id.resize(kMaxInteractionId - hash.size() - 1);
  return id + '.' + hash;
}

// What the score needs to know about a lesson's parts.
struct Part {
  bool scored = false, done = false, right = false;
  const std::vector<std::size_t>* goals = nullptr;
};

struct Taken {
  std::set<std::pair<std::string, std::size_t>> tasks_over, tasks_solved;
  std::map<std::pair<std::string, std::string>, bool> first_right;
  std::set<std::string> entered, skipped;
};

std::vector<Part> scoredParts(const LessonOutline& lesson, const Taken& taken) {
  std::vector<Part> out;
  for (const StepOutline& step : lesson.steps) {
    const bool entered = taken.entered.count(step.id) > 0;
    if (step.aside || (taken.skipped.count(step.id) > 0 && !entered)) continue;
    for (std::size_t t = 0; t < step.tasks.size(); ++t) {
      const std::pair key(step.id, t);
      out.push_back({true, taken.tasks_over.count(key) > 0, taken.tasks_solved.count(key) > 0, &step.tasks[t].goals});
    }
    for (const QuestionOutline& q : step.questions) {
      const auto first = taken.first_right.find({step.id, q.id});
      const bool answered = first != taken.first_right.end();
      out.push_back({q.kind == AnswerKind::Marked, answered, answered && first->second, &q.goals});
    }
  }
  return out;
}

class Builder {
 public:
  explicit Builder(const Attempt& attempt) : lesson_(attempt.header.lesson), base_utc_(timeOf(attempt.header.began)) {
    record_.began = attempt.header.began;
    for (const AttemptEvent& event : attempt.events) {
      record_.at_s = std::max(record_.at_s, event.t_s);
      std::visit([&](const auto& fact) { take(event.t_s, fact); }, event.what);
    }
    finish();
  }

  LearningRecord take() { return std::move(record_); }

 private:
  template <class Fact>
  void take(double, const Fact&) {}

  void take(double t_s, const StepEntered& e) {
    if (record_.step != e.step) entered_s_ = t_s;
    record_.step = e.step;
    record_.place = e.step;
    taken_.entered.insert(e.step);
  }
  void take(double, const TaskBegun& e) { record_.place = e.step + "/task " + std::to_string(e.task + 1); }
  void take(double, const ProgressMade& e) {
    record_.done = e.done;
    record_.of = e.of;
    progressed_ = true;
  }
  void take(double, const OrderChanged& e) {
    if (e.skips) taken_.skipped.insert(e.steps.begin(), e.steps.end());
  }
  void take(double t_s, const Resumed& e) {
    if (const auto utc = timeOf(e.at)) {
      base_utc_ = utc;
      base_s_ = t_s;
    }
    entered_s_ = t_s;
    answered_s_.clear();
  }
  void take(double t_s, const TaskDone& e) {
    record_.place = e.step;
    const std::pair key(e.step, e.task);
    taken_.tasks_over.insert(key);
    if (e.solved) taken_.tasks_solved.insert(key);
    LearningInteraction out = begin(t_s, interactionId(e.step, e.task));
    out.kind = LearningInteraction::Kind::Task;
    out.right = e.solved;
    out.attempt = ++rounds_[key];
    out.latency_s = e.took_s;
    const StepOutline* step = stepOf(e.step);
    if (step && e.task < step->tasks.size()) {
      out.text = step->tasks[e.task].say;
      out.goals = step->tasks[e.task].goals;
    }
    record_.interactions.push_back(std::move(out));
  }
  void take(double t_s, const Answered& e) {
    const std::pair key(e.step, e.question);
    taken_.first_right.try_emplace(key, e.right);
    LearningInteraction out = begin(t_s, interactionId(e.step, e.question));
    out.right = e.right;
    out.attempt = e.attempt;
    out.chosen = e.chosen;
    out.written = e.written;
    out.kind = LearningInteraction::Kind::Typed;
    const auto before = answered_s_.find(key);
    out.latency_s = std::max(0.0, t_s - (before == answered_s_.end() ? entered_s_ : before->second));
    answered_s_[key] = t_s;
    if (const StepOutline* step = stepOf(e.step))
      for (const QuestionOutline& q : step->questions) {
        if (q.id != e.question) continue;
        out.text = q.text;
        out.choices = q.choices;
        out.right_choices = q.right;
        out.judged = q.kind;
        out.goals = q.goals;
        if (!q.choices.empty()) out.kind = LearningInteraction::Kind::Choice;
        std::erase_if(out.chosen, [&](std::size_t c) { return c >= q.choices.size(); });
        for (const std::size_t c : out.chosen)
          if (c < q.tags.size() && !q.tags[c].empty()) out.misconceptions.push_back(q.tags[c]);
      }
    record_.interactions.push_back(std::move(out));
  }

  LearningInteraction begin(double t_s, std::string id) const {
    LearningInteraction out;
    out.id = std::move(id);
    out.at_s = t_s;
    if (base_utc_)
      out.at_utc = utcText(*base_utc_ + std::chrono::seconds(std::int64_t(std::clamp(t_s - base_s_, 0.0, 1e9))));
    return out;
  }

  const StepOutline* stepOf(const std::string& id) const {
    const auto found =
        std::find_if(lesson_.steps.begin(), lesson_.steps.end(), [&](const StepOutline& s) { return s.id == id; });
    return found == lesson_.steps.end() ? nullptr : &*found;
  }

  void finish() {
    const std::vector<Part> parts = scoredParts(lesson_, taken_);
    if (!progressed_) record_.of = std::max<std::size_t>(1, lesson_.parts());
    const auto scoreOf = [&](auto&& counts) -> std::optional<double> {
      std::size_t right = 0, of = 0;
      for (const Part& p : parts) {
        if (!p.scored || !counts(p)) continue;
        ++of;
        right += p.right ? 1 : 0;
      }
      return of ? std::optional(double(right) / double(of)) : std::nullopt;
    };
    record_.score = scoreOf([](const Part&) { return true; });
    for (std::size_t g = 0; g < lesson_.goals.size(); ++g) {
      const auto serves = [g](const Part& p) {
        return std::find(p.goals->begin(), p.goals->end(), g) != p.goals->end();
      };
      LearningObjective o{"goal_" + std::to_string(g + 1), lesson_.goals[g], 0, 0, scoreOf(serves)};
      for (const Part& p : parts) {
        if (!serves(p)) continue;
        ++o.of;
        o.done += p.done ? 1 : 0;
      }
      record_.objectives.push_back(std::move(o));
    }
  }

  const LessonOutline& lesson_;
  LearningRecord record_;
  Taken taken_;
  std::optional<Seconds> base_utc_;  // at base_s_
  double base_s_ = 0.0, entered_s_ = 0.0;
  bool progressed_ = false;
  std::map<std::pair<std::string, std::string>, double> answered_s_;
  std::map<std::pair<std::string, std::size_t>, int> rounds_;
};

std::string_view wordOf(LearningInteraction::Kind kind) {
  switch (kind) {
    case LearningInteraction::Kind::Task:
      return "task";
    case LearningInteraction::Kind::Choice:
      return "choice";
    case LearningInteraction::Kind::Typed:
      return "typed";
  }
  return "typed";
}

std::string_view wordOf(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::Marked:
      return "marked";
    case AnswerKind::Prediction:
      return "prediction";
    case AnswerKind::Free:
      return "free";
  }
  return "free";
}

nlohmann::ordered_json shareOrNull(const std::optional<double>& share) {
  return share ? nlohmann::ordered_json(*share) : nlohmann::ordered_json(nullptr);
}

}  // namespace

LearningRecord learningRecord(const Attempt& attempt) { return Builder(attempt).take(); }

std::string interactionId(std::string_view step, std::size_t task) {
  return shortened("task_" + asciiIdOf(step) + "_" + std::to_string(task + 1));
}

std::string interactionId(std::string_view step, std::string_view question) {
  return shortened("question_" + asciiIdOf(step) + "_" + asciiIdOf(question));
}

std::string learningRecordJson(const LearningRecord& r, std::string_view suspended, std::size_t from) {
  nlohmann::ordered_json objectives = nlohmann::ordered_json::array(), interactions = objectives;
  for (const LearningObjective& o : r.objectives)
    objectives.push_back(
        {{"id", o.id}, {"text", o.text}, {"done", o.done}, {"of", o.of}, {"score", shareOrNull(o.score)}});
  for (std::size_t k = std::min(from, r.interactions.size()); k < r.interactions.size(); ++k) {
    const LearningInteraction& i = r.interactions[k];
    interactions.push_back({{"id", i.id},
                            {"text", i.text},
                            {"kind", wordOf(i.kind)},
                            {"judged", wordOf(i.judged)},
                            {"right", i.right},
                            {"attempt", i.attempt},
                            {"choices", i.choices},
                            {"chosen", i.chosen},
                            {"right_choices", i.right_choices},
                            {"written", i.written},
                            {"misconceptions", i.misconceptions},
                            {"goals", i.goals},
                            {"t", i.at_s},
                            {"at", i.at_utc},
                            {"latency_s", i.latency_s}});
  }
  const nlohmann::ordered_json all = {{"began", r.began},
                                      {"t", r.at_s},
                                      {"step", r.step},
                                      {"place", r.place},
                                      {"done", r.done},
                                      {"of", r.of},
                                      {"complete", r.complete()},
                                      {"score", shareOrNull(r.score)},
                                      {"objectives", objectives},
                                      {"interactions", interactions},
                                      {"interaction_count", r.interactions.size()},
                                      {"suspended", suspended}};
  return all.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace moltact
