#include "engine/results/suspended.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "engine/core/content_hash.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using SuspendJson = nlohmann::json;

constexpr int kSuspendedFormat = 1;
constexpr double kMostSeconds = 1e8;
constexpr std::size_t kMostSittings = 1000;
constexpr int kMostTries = 1000;
constexpr std::size_t kMostWritten = 4000;  // unit: byte
constexpr unsigned kFirstRight = 1, kEverRight = 2, kLastRight = 4;

struct KnownAnswer {
  std::vector<std::size_t> chosen;
  std::string written;
  bool empty() const { return chosen.empty() && written.empty(); }
};
bool operator==(const KnownAnswer& a, const KnownAnswer& b) { return a.chosen == b.chosen && a.written == b.written; }

struct KnownQuestion {
  int tries = 0;
  unsigned flags = 0;
  KnownAnswer first, last;
};
struct KnownStep {
  std::string id;
  std::map<std::size_t, bool> tasks;  // whether solved
  std::map<std::string, KnownQuestion> questions;
};
struct KnownAttempt {
  std::string began, step;
  std::size_t sittings = 1, done = 0, of = 0;
  double t_s = 0.0;
  std::vector<KnownStep> steps;  // in the order in which they were entered
  std::set<std::string> skipped;
};

KnownAttempt knownOf(const Attempt& attempt) {
  KnownAttempt out;
  out.began = attempt.header.began;
  out.sittings = sittingsOf(attempt);
  out.of = std::max<std::size_t>(1, attempt.header.lesson.parts());
  const auto at = [&](const std::string& id) -> KnownStep& {
    const auto found = std::find_if(out.steps.begin(), out.steps.end(), [&](const KnownStep& s) { return s.id == id; });
    return found == out.steps.end() ? out.steps.emplace_back(KnownStep{id, {}, {}}) : *found;
  };
  for (const AttemptEvent& event : attempt.events) {
    out.t_s = std::max(out.t_s, event.t_s);
    if (const auto* step = std::get_if<StepEntered>(&event.what)) {
      out.step = at(step->step).id;
    } else if (const auto* begun = std::get_if<TaskBegun>(&event.what)) {
      at(begun->step).tasks.erase(begun->task);
    } else if (const auto* done = std::get_if<TaskDone>(&event.what)) {
      at(done->step).tasks[done->task] = done->solved;
    } else if (const auto* made = std::get_if<ProgressMade>(&event.what)) {
      out.done = made->done;
      out.of = made->of;
    } else if (const auto* order = std::get_if<OrderChanged>(&event.what)) {
      if (order->skips) out.skipped.insert(order->steps.begin(), order->steps.end());
    } else if (const auto* answer = std::get_if<Answered>(&event.what)) {
      KnownQuestion& q = at(answer->step).questions[answer->question];
      const KnownAnswer given{answer->chosen, answer->written};
      if (q.tries == 0) {
        q.first = given;
        q.flags = answer->right ? kFirstRight : 0;
      }
      q.tries = std::clamp(std::max(q.tries + 1, answer->attempt), 1, kMostTries);
      q.last = given;
      q.flags = (q.flags & ~kLastRight) | (answer->right ? kEverRight | kLastRight : 0);
    }
  }
  return out;
}

// "5.3fa0": the place in the lesson and a hash of the id.
std::string keyAt(std::size_t place, std::string_view id) {
  return std::to_string(place) + '.' + contentHash(id).substr(12);
}

template <class List>
std::string keyOf(const List& list, const std::string& id) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& item) { return item.id == id; });
  return keyAt(std::size_t(found - list.begin()), id);
}

// The item at the key's place if its hash agrees, else the first with that hash, else null.
template <class List>
auto itemOf(const List& list, std::string_view key) -> const typename List::value_type* {
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return nullptr;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (keyAt(k, list[k].id) == key) return &list[k];
  for (const auto& item : list)
    if (contentHash(item.id).substr(12) == key.substr(dot + 1)) return &item;
  return nullptr;
}

// What is left out of the text, in this order.
enum class Leaving { Nothing, Written, Choices, Questions };

SuspendJson answerOf(const KnownAnswer& answer, Leaving leaving) {
  if (!answer.written.empty())
    return leaving >= Leaving::Written || answer.written.size() > kMostWritten ? SuspendJson("")
                                                                               : SuspendJson(answer.written);
  return leaving >= Leaving::Choices ? SuspendJson::array() : SuspendJson(answer.chosen);
}

SuspendJson stepJson(const KnownStep& step, std::size_t place, const StepOutline& outline, Leaving leaving) {
  std::string tasks;
  for (const auto& [index, solved] : step.tasks) {
    if (index >= outline.tasks.size()) continue;
    tasks.resize(std::max(tasks.size(), index + 1), '-');
    tasks[index] = solved ? 's' : 'x';
  }
  SuspendJson questions = SuspendJson::array();
  if (leaving < Leaving::Questions)
    for (const auto& [id, q] : step.questions) {
      SuspendJson one = {keyOf(outline.questions, id), q.tries, q.flags, answerOf(q.first, leaving)};
      if (q.tries > 1 && !(q.last == q.first)) one.push_back(answerOf(q.last, leaving));
      questions.push_back(std::move(one));
    }
  return {keyAt(place, step.id), tasks, questions};
}

std::string stateTextOf(const KnownAttempt& known, const LessonOutline& lesson, Leaving leaving,
                        std::size_t from_step) {
  SuspendJson steps = SuspendJson::array(), skipped = steps;
  for (std::size_t k = from_step; k < known.steps.size(); ++k)
    for (std::size_t place = 0; place < lesson.steps.size(); ++place)
      if (lesson.steps[place].id == known.steps[k].id)
        steps.push_back(stepJson(known.steps[k], place, lesson.steps[place], leaving));
  if (from_step == 0)
    for (const std::string& id : known.skipped) skipped.push_back(keyOf(lesson.steps, id));
  const SuspendJson all = {"moltact",
                           kSuspendedFormat,
                           known.began,
                           known.sittings,
                           std::ceil(known.t_s * 1000.0) / 1000.0,
                           keyOf(lesson.steps, known.step),
                           known.done,
                           known.of,
                           steps,
                           skipped};
  return all.dump(-1, ' ', true, SuspendJson::error_handler_t::replace);
}

// ---- reading --------------------------------------------------------------------------------------------------------

Problem damagedState() {
  return {{},
          0,
          0,
          tr("what the learning platform kept of this lesson is damaged"),
          tr("begin the lesson again; what the platform has counted stays counted")};
}

// A whole number in a range, else no value.
std::optional<double> wholeIn(const SuspendJson& value, double least, double most) {
  if (!value.is_number_integer() && !value.is_number_unsigned()) return std::nullopt;
  const double number = value.get<double>();
  return number >= least && number <= most ? std::optional(number) : std::nullopt;
}

std::optional<KnownAnswer> readAnswer(const SuspendJson& value, const QuestionOutline& question) {
  KnownAnswer out;
  if (value.is_string()) {
    out.written = value.get<std::string>();
    return out.written.size() <= kMostWritten ? std::optional(out) : std::nullopt;
  }
  if (!value.is_array()) return std::nullopt;
  for (const SuspendJson& choice : value) {
    const auto index = wholeIn(choice, 0, 1e6);
    if (!index) return std::nullopt;
    if (*index < double(question.choices.size())) out.chosen.push_back(std::size_t(*index));
  }
  std::sort(out.chosen.begin(), out.chosen.end());
  out.chosen.erase(std::unique(out.chosen.begin(), out.chosen.end()), out.chosen.end());
  return out;
}

class Reader {
 public:
  Reader(const SuspendJson& all, const LessonOutline& lesson) : lesson_(lesson) { good_ = read(all); }

  bool good() const { return good_; }
  Attempt take() { return std::move(out_); }

 private:
  bool read(const SuspendJson& all) {
    if (!all.is_array() || all.size() < 10 || all[0] != "moltact" || !wholeIn(all[1], 1, kSuspendedFormat))
      return false;
    const auto sittings = wholeIn(all[3], 1, double(kMostSittings)), done = wholeIn(all[6], 0, 1e6),
               of = wholeIn(all[7], 0, 1e6);
    if (!all[2].is_string() || all[2].get_ref<const std::string&>().size() > 40 || !sittings || !done || !of ||
        !all[4].is_number() || !all[5].is_string() || !all[8].is_array() || !all[9].is_array())
      return false;
    t_s_ = all[4].get<double>();
    if (!(t_s_ >= 0.0 && t_s_ <= kMostSeconds)) return false;
    out_.header.began = all[2].get<std::string>();
    out_.header.lesson = lesson_;
    for (std::size_t k = 1; k < std::size_t(*sittings); ++k) add(Resumed{out_.header.began, {}, {}, false});
    for (const SuspendJson& step : all[8])
      if (!readStep(step)) return false;
    std::vector<std::string> skipped;
    for (const SuspendJson& key : all[9]) {
      if (!key.is_string()) return false;
      if (const StepOutline* step = itemOf(lesson_.steps, key.get_ref<const std::string&>()))
        skipped.push_back(step->id);
    }
    if (!skipped.empty()) add(OrderChanged{{}, {}, {}, true, std::move(skipped)});
    const StepOutline* at = itemOf(lesson_.steps, all[5].get_ref<const std::string&>());
    if (at) add(StepEntered{at->id});
    add(ProgressMade{at ? at->id : std::string(), std::size_t(*done), std::size_t(*of)});
    return true;
  }

  bool readStep(const SuspendJson& step) {
    if (!step.is_array() || step.size() != 3 || !step[0].is_string() || !step[1].is_string() || !step[2].is_array())
      return false;
    const StepOutline* outline = itemOf(lesson_.steps, step[0].get_ref<const std::string&>());
    if (!outline) return true;  // the lesson no longer has it
    add(StepEntered{outline->id});
    const std::string& tasks = step[1].get_ref<const std::string&>();
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      if (tasks[k] != 's' && tasks[k] != 'x' && tasks[k] != '-') return false;
      if (tasks[k] != '-' && k < outline->tasks.size())
        add(TaskDone{outline->id, k, 0.0, InputKind::Mouse, {}, tasks[k] == 's'});
    }
    return std::all_of(step[2].begin(), step[2].end(),
                       [&](const SuspendJson& question) { return readQuestion(question, *outline); });
  }

  bool readQuestion(const SuspendJson& q, const StepOutline& step) {
    if (!q.is_array() || q.size() < 4 || q.size() > 5 || !q[0].is_string()) return false;
    const auto tries = wholeIn(q[1], 1, kMostTries), flags = wholeIn(q[2], 0, kFirstRight | kEverRight | kLastRight);
    if (!tries || !flags) return false;
    const QuestionOutline* outline = itemOf(step.questions, q[0].get_ref<const std::string&>());
    if (!outline) return true;
    const auto first = readAnswer(q[3], *outline), last = q.size() > 4 ? readAnswer(q[4], *outline) : first;
    if (!first || !last) return false;
    const auto is = [&](unsigned flag) { return (unsigned(*flags) & flag) != 0; };
    const auto answer = [&](int attempt, const KnownAnswer& a, bool right) {
      add(Answered{step.id, outline->id, attempt, a.chosen, a.written, right, InputKind::Mouse});
    };
    const int count = int(*tries);
    answer(1, *first, is(kFirstRight));
    if (count > 2 && is(kEverRight) && !is(kFirstRight) && !is(kLastRight)) answer(2, *first, true);
    if (count > 1) answer(count, *last, is(kLastRight));
    return true;
  }

  void add(AttemptFact fact) { out_.events.push_back({t_s_, std::move(fact)}); }

  const LessonOutline& lesson_;
  Attempt out_;
  double t_s_ = 0.0;
  bool good_ = false;
};

}  // namespace

std::string suspendedText(const Attempt& attempt, std::size_t max_chars) {
  const KnownAttempt known = knownOf(attempt);
  const LessonOutline& lesson = attempt.header.lesson;
  for (const Leaving leaving : {Leaving::Nothing, Leaving::Written, Leaving::Choices, Leaving::Questions})
    if (std::string text = stateTextOf(known, lesson, leaving, 0); text.size() <= max_chars) return text;
  for (std::size_t from = 1; from <= known.steps.size(); ++from)
    if (std::string text = stateTextOf(known, lesson, Leaving::Questions, from); text.size() <= max_chars) return text;
  return {};
}

Expected<Attempt> fromSuspended(std::string_view text, const LessonOutline& lesson) {
  if (text.size() > kLongestSuspended) return damagedState();
  const SuspendJson all = SuspendJson::parse(text, nullptr, false);
  if (all.is_discarded()) return damagedState();
  Reader reader(all, lesson);
  if (!reader.good()) return damagedState();
  return reader.take();
}

}  // namespace moltact
