#include "engine/results/class_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "engine/core/content_hash.h"
#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/sensitivity.h"
#include "engine/results/anonymous_text.h"
#include "engine/results/lesson_language.h"

namespace moltact {
namespace {

// "(no name, 21 Nov 10:58)" for "2026-11-21T10:58:14Z".
std::string nameless(const std::string& began) {
  static constexpr std::array kMonths{NC_("month", "Jan"), NC_("month", "Feb"), NC_("month", "Mar"),
                                      NC_("month", "Apr"), NC_("month", "May"), NC_("month", "Jun"),
                                      NC_("month", "Jul"), NC_("month", "Aug"), NC_("month", "Sep"),
                                      NC_("month", "Oct"), NC_("month", "Nov"), NC_("month", "Dec")};
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
  if (std::sscanf(began.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d", &year, &month, &day, &hour, &minute, &second) != 6 ||
      month < 1 || month > 12)
    return tr("(no name)");
  char time[32];
  std::snprintf(time, sizeof time, "%02d:%02d", hour, minute);
  // Translators: a day, a month and a time of day.
  return trf("(no name, {0} {1} {2})", day, trc("month", kMonths[std::size_t(month - 1)]), time);
}

// "S-4KQ7M"; longer if another name has the same code. Without letters and digits that are easily confused.
std::string codeOf(const std::string& word, const std::string& name, const std::set<std::string>& taken) {
  constexpr std::string_view kSigns = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ";
  std::uint64_t state = hash64(word + '\n' + name);
  std::string code = "S-";
  do code += kSigns[nextRandom(state) % kSigns.size()];
  while (code.size() < 7 || taken.contains(code));
  return code;
}

// Adds one attempt's events to the person's results.
class Counting {
 public:
  explicit Counting(PersonScore& into) : p_(into) {}

  void add(const Attempt& attempt) {
    ++p_.attempts;
    p_.device = attempt.header.device;
    p_.gives_force = attempt.header.gives_force;
    learn(attempt.header.lesson);
    for (const AttemptEvent& event : attempt.events) {
      t_s_ = event.t_s;
      std::visit(*this, event.what);
    }
    endOpenTouch();
    leaveStep();
    if (p_.of == 0) p_.of = std::max<std::size_t>(1, attempt.header.lesson.parts());
    p_.time_s += attempt.end_s();
    for (const StepOutline& s : attempt.header.lesson.steps)
      if (s.id == at_) p_.last_step = s.title;
  }

  void operator()(const StepEntered& e) {
    leaveStep();
    if (p_.steps_taken.empty() || p_.steps_taken.back() != e.step) p_.steps_taken.push_back(e.step);
    at_ = step_ = e.step;
    entered_s_ = t_s_;
  }
  void operator()(const SessionClosed&) { leaveStep(); }
  void operator()(const Answered& e) {
    AnswerScore& a = p_.answers[{e.step, e.question}];
    const auto kind = kinds_.find({e.step, e.question});
    if (kind != kinds_.end()) a.kind = kind->second;
    if (a.tries == 0 || a.kind != AnswerKind::Marked || test_) {
      a.chosen = e.chosen;
      a.written = e.written;
      a.first_right = e.right;
      a.by = e.by;
    }
    const auto tags = tags_.find({e.step, e.question});
    for (const std::size_t c : e.chosen)
      if (tags != tags_.end() && c < tags->second.size() && !tags->second[c].empty())
        ++p_.misconceptions[tags->second[c]];
    if (!a.right || test_) ++a.tries;
    a.right = (a.right && !test_) || e.right;
  }
  void operator()(const LessonReread& e) { learn(e.lesson); }
  void operator()(const OrderChanged& e) { p_.rules.push_back(e); }
  void operator()(const HintOpened&) { ++p_.hints; }
  void operator()(const TaskBegun& e) { p_.tasks[{e.step, e.task}].begun = true; }
  void operator()(const TaskDone& e) {
    TaskScore& task = p_.tasks[{e.step, e.task}];
    if (!task.first_sensitivity)
      for (const LoggedFigure& f : e.figures)
        if (f.name == kFirstRoundSensitivity) task.first_sensitivity = f.value;
    if (task.done) return;
    // If the tries were used up, the task was begun but not solved.
    task.begun = true;
    if (!e.solved) return;
    task = {true, true, e.took_s, e.by, e.figures, std::move(task.drawn), std::move(task.felt), task.first_sensitivity};
  }
  void operator()(const CurveKept& e) {
    TaskScore& task = p_.tasks[{e.step, e.task}];
    if (e.felt)
      task.felt = std::make_shared<const CurveKept>(e);
    else if (!task.drawn)
      task.drawn = std::make_shared<const CurveKept>(e);
  }
  void operator()(const TouchBegan&) { endOpenTouch(); }
  void operator()(const TouchSoFar& e) {
    if (open_ && open_->from_s != e.from_s) endOpenTouch();
    open_ = e;
    open_at_s_ = t_s_;
  }
  void operator()(const TouchEnded& e) {
    if (open_ && open_->from_s == e.from_s) open_.reset();
    count(e, t_s_);
  }
  void operator()(const ProgressMade& e) {
    if (e.of == 0 || (p_.of > 0 && double(e.done) * double(p_.of) < double(p_.done) * double(e.of))) return;
    p_.done = std::min(e.done, e.of);
    p_.of = e.of;
  }
  void operator()(const Predicted& e) { p_.predictions.push_back(e); }
  void operator()(const Resumed& e) {
    endOpenTouch();
    p_.device = e.device;
    p_.gives_force = e.gives_force;
  }
  void operator()(const auto&) {}

 private:
  void learn(const LessonOutline& lesson) {
    test_ = lesson.test;
    for (const StepOutline& s : lesson.steps)
      for (const QuestionOutline& q : s.questions) {
        kinds_[{s.id, q.id}] = q.kind;
        tags_[{s.id, q.id}] = q.tags;
      }
  }
  template <class TouchEvent>
  void count(const TouchEvent& e, double until_s) {
    const double lasted_s = std::max(0.0, until_s - e.from_s);
    ++p_.touches;
    p_.crossings += e.crossings;
    p_.mean_N =
        p_.touch_s + lasted_s > 0.0 ? (p_.mean_N * p_.touch_s + e.mean_N * lasted_s) / (p_.touch_s + lasted_s) : 0.0;
    p_.touch_s += lasted_s;
    p_.peak_N = std::max(p_.peak_N, e.peak_N);
    p_.path_A += e.path_A;
    p_.touch_by_input_s[static_cast<std::size_t>(e.by)] += lasted_s;
  }
  // Counts a touch without a recorded end: the program was killed.
  void endOpenTouch() {
    if (open_) count(*std::exchange(open_, std::nullopt), open_at_s_);
  }
  void leaveStep() {
    if (!step_.empty()) p_.step_s[step_] += std::max(0.0, t_s_ - entered_s_);
    step_.clear();
  }

  PersonScore& p_;
  std::map<std::pair<std::string, std::string>, AnswerKind> kinds_;               // by step and question id
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> tags_;  // of its choices
  bool test_ = false;
  std::string step_, at_;  // the step whose time is counted, and the last step entered
  double t_s_ = 0.0, entered_s_ = 0.0;
  std::optional<TouchSoFar> open_;  // the touch without an end so far, and the time of its last record
  double open_at_s_ = 0.0;
};

}  // namespace

std::size_t PersonScore::answered() const {
  return std::size_t(
      std::count_if(answers.begin(), answers.end(), [](const auto& a) { return a.second.kind == AnswerKind::Marked; }));
}

std::size_t PersonScore::firstRight() const {
  return std::size_t(std::count_if(answers.begin(), answers.end(), [](const auto& a) {
    return a.second.kind == AnswerKind::Marked && a.second.first_right;
  }));
}

std::optional<InputKind> PersonScore::input() const {
  InputShares shares = touch_by_input_s;
  if (touches == 0)
    for (const auto& [question, answer] : answers) shares[static_cast<std::size_t>(answer.by)] += 1.0;
  const auto most = std::max_element(shares.begin(), shares.end());
  if (touches == 0 && *most == 0.0) return std::nullopt;
  return static_cast<InputKind>(most - shares.begin());
}

std::optional<double> discrimination(const LessonSummary& lesson, const std::string& step,
                                     const std::string& question) {
  constexpr std::size_t kMinPairs = 5;
  std::vector<std::pair<double, double>> pairs;  // per person: this answer, and the share of the others
  for (const PersonScore& p : lesson.people) {
    const auto item = p.answers.find({step, question});
    if (item == p.answers.end() || item->second.kind != AnswerKind::Marked) continue;
    const std::size_t others = p.answered() - 1;
    if (others == 0) continue;
    pairs.emplace_back(item->second.first_right ? 1.0 : 0.0,
                       double(p.firstRight() - item->second.first_right) / double(others));
  }
  if (pairs.size() < kMinPairs) return std::nullopt;
  double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (const auto& [a, b] : pairs) x += a / double(pairs.size()), y += b / double(pairs.size());
  for (const auto& [a, b] : pairs) {
    xx += (a - x) * (a - x);
    yy += (b - y) * (b - y);
    xy += (a - x) * (b - y);
  }
  if (!(xx > 1e-12) || !(yy > 1e-12)) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

struct ClassCount::Impl {
  struct OfLesson {
    LessonOutline newest;
    std::set<std::string> hashes;
    std::map<std::string, PersonScore> people;
  };

  NamesShown shown_as;
  ClassSummary out;
  std::map<std::pair<std::string, std::string>, OfLesson> lessons;  // by file and title
  // Codes are assigned in the order of the attempts, not of the names.
  std::map<std::string, std::string> codes;
  std::map<std::string, std::size_t> times;  // number of uses of each text for a person without a name
  std::vector<std::string> names, nobodies;
  std::set<std::string> taken;
  std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>> counted_as;  // the lesson under
                                                                                                  // which each one is
                                                                                                  // counted

  // All translations of a lesson are counted together, under the one that was added first.
  std::pair<std::string, std::string> lessonOf(const LessonOutline& lesson) {
    const std::pair own(lesson.file, lesson.title);
    const auto [known, is_new] = counted_as.try_emplace(own, own);
    if (!is_new) return known->second;
    for (const auto& [other, counted] : lessons)
      if (other.first != lesson.file && sameLesson(counted.newest, lesson)) known->second = other;
    return known->second;
  }

  bool anonymous() const { return shown_as.anonymous || !shown_as.code_word.empty(); }

  NameCover cover() const {
    std::map<std::string, std::string> hidden;
    for (const auto& [key, code] : codes)
      if (key.starts_with('n')) hidden.emplace(key.substr(1), code);
    return NameCover(hidden);
  }

  std::string typedText(const NameCover& cover, const std::string& text) const {
    return shown_as.typed_texts ? cover.covered(text) : wordsLeftOut(text);
  }

  // Takes out what else could tell who somebody is.
  void makeAnonymous(PersonScore& score, const NameCover& cover) const {
    constexpr std::size_t kDay = 10;  // "2026-11-21"
    score.began.resize(std::min(score.began.size(), kDay));
    for (auto& [question, answer] : score.answers)
      if (answer.kind != AnswerKind::Marked || !answer.first_right) answer.written = typedText(cover, answer.written);
    for (Predicted& prediction : score.predictions) {
      const auto code = codes.find("n" + prediction.student);
      prediction.student = code == codes.end() ? tr("(another)") : code->second;
      prediction.text = typedText(cover, prediction.text);
    }
  }

  std::string personOf(const AttemptHeader& header) {
    const bool named = !header.student.empty();
    const std::string key = named ? "n" + header.student : "f" + std::to_string(out.attempts);
    const auto known = codes.find(key);
    if (known != codes.end()) return known->second;
    std::string shown;
    if (anonymous()) {
      shown = "S" + std::string(codes.size() < 9 ? "0" : "") + std::to_string(codes.size() + 1);
      if (!shown_as.code_word.empty()) shown = codeOf(shown_as.code_word, key, taken);
      taken.insert(shown);
    } else if (named) {
      shown = header.student;
    } else {
      // Two attempts without a name in the same minute are different people.
      shown = nameless(header.began);
      if (const std::size_t before = times[shown]++) shown += " #" + std::to_string(before + 1);
    }
    (named || anonymous() ? names : nobodies).push_back(shown);
    return codes[key] = shown;
  }
};

ClassCount::ClassCount(NamesShown names) : impl_(std::make_unique<Impl>()) { impl_->shown_as = std::move(names); }
ClassCount::~ClassCount() = default;

void ClassCount::add(const Attempt& given) {
  const LessonOutline& lesson_given = given.header.lesson;
  std::pair<std::string, std::string> of = impl_->lessonOf(lesson_given);
  const LessonOutline* target = &lesson_given;
  if (of.first != lesson_given.file) {
    target = &impl_->lessons[of].newest;
    // Another version of the lesson may have other steps than its translation.
    if (!sameLesson(*target, lesson_given)) {
      target = &lesson_given;
      of = {lesson_given.file, lesson_given.title};
    }
  }
  const bool other_language =
      target != &lesson_given || std::any_of(given.events.begin(), given.events.end(), [&](const AttemptEvent& e) {
        const auto* reread = std::get_if<LessonReread>(&e.what);
        return reread && reread->lesson.file != lesson_given.file;
      });
  std::optional<Attempt> translated;
  if (other_language) translated = inTermsOf(*target, given);
  const Attempt& attempt = translated ? *translated : given;
  const AttemptHeader& header = attempt.header;
  const std::string person = impl_->personOf(header);
  ++impl_->out.attempts;
  impl_->out.nameless += header.student.empty();
  Impl::OfLesson& lesson = impl_->lessons[of];
  lesson.newest = header.lesson;
  lesson.hashes.insert(lesson_given.hash);
  PersonScore& score = lesson.people[person];
  if (score.attempts == 0) {
    score.person = person;
    score.named = !header.student.empty();
    score.began = header.began;
  }
  Counting(score).add(attempt);
}

ClassSummary ClassCount::finish() {
  ClassSummary& out = impl_->out;
  std::map<std::string, std::size_t> titles;  // number of lessons with this file name
  for (const auto& [of, lesson] : impl_->lessons) ++titles[of.first];
  const NameCover cover = impl_->cover();
  for (auto& [of, counted] : impl_->lessons) {
    LessonSummary lesson{titles[of.first] > 1 ? of.first + " (" + of.second + ")" : of.first,
                         std::move(counted.newest),
                         counted.hashes.size(),
                         {}};
    lesson.people.reserve(counted.people.size());
    for (auto& [name, score] : counted.people) {
      if (impl_->anonymous()) impl_->makeAnonymous(score, cover);
      lesson.people.push_back(std::move(score));
    }
    counted.people.clear();
    std::stable_sort(lesson.people.begin(), lesson.people.end(),
                     [](const PersonScore& a, const PersonScore& b) { return a.named > b.named; });
    out.lessons.push_back(std::move(lesson));
  }
  std::sort(out.lessons.begin(), out.lessons.end(), [](const LessonSummary& a, const LessonSummary& b) {
    return std::tie(a.lesson.title, a.lesson.file) < std::tie(b.lesson.title, b.lesson.file);
  });
  std::sort(impl_->names.begin(), impl_->names.end());
  out.people = std::move(impl_->names);
  out.people.insert(out.people.end(), impl_->nobodies.begin(), impl_->nobodies.end());
  return std::move(out);
}

ClassSummary summarise(std::vector<Attempt> attempts, const NamesShown& names) {
  std::stable_sort(attempts.begin(), attempts.end(),
                   [](const Attempt& a, const Attempt& b) { return a.header.began < b.header.began; });
  ClassCount count(names);
  for (const Attempt& attempt : attempts) count.add(attempt);
  return count.finish();
}

GoalScore goalScore(const LessonOutline& lesson, const PersonScore& p, std::size_t goal) {
  const auto serves = [&](const std::vector<std::size_t>& goals) {
    return std::find(goals.begin(), goals.end(), goal) != goals.end();
  };
  GoalScore out;
  for (const StepOutline& s : lesson.steps) {
    if (s.aside) continue;  // asides are optional
    for (std::size_t t = 0; t < s.tasks.size(); ++t) {
      if (!serves(s.tasks[t].goals)) continue;
      ++out.parts;
      const auto task = p.tasks.find({s.id, t});
      out.done += task != p.tasks.end() && task->second.done;
    }
    for (const QuestionOutline& q : s.questions) {
      if (!serves(q.goals)) continue;
      ++out.parts;
      const auto answer = p.answers.find({s.id, q.id});
      if (answer == p.answers.end()) continue;
      const bool marked = q.kind == AnswerKind::Marked;
      out.done += !marked || answer->second.right;
      out.answered += marked;
      out.first_right += marked && answer->second.first_right;
    }
  }
  return out;
}

bool asksTwice(const LessonOutline& lesson) {
  return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const StepOutline& s) {
    return std::any_of(s.tasks.begin(), s.tasks.end(), [](const TaskOutline& t) { return t.asked == "after"; });
  });
}

SensitivityPair sensitivityPair(const LessonOutline& lesson, const PersonScore& person) {
  SensitivityPair out;
  for (const StepOutline& s : lesson.steps)
    for (std::size_t t = 0; t < s.tasks.size(); ++t) {
      const auto task = person.tasks.find({s.id, t});
      if (s.tasks[t].asked.empty() || task == person.tasks.end()) continue;
      (s.tasks[t].asked == "before" ? out.before : out.after) = task->second.first_sensitivity;
    }
  return out;
}

std::string wayText(const LessonOutline& lesson, const PersonScore& person) {
  std::map<std::string, std::string> numbers;
  std::size_t steps = 0, asides = 0;
  for (const StepOutline& s : lesson.steps)
    numbers[s.id] = s.aside ? "a" + std::to_string(++asides) : std::to_string(++steps);
  const auto numberOf = [&](const std::string& id) {
    const auto known = numbers.find(id);
    return known == numbers.end() ? "?" : known->second;
  };
  std::string out;
  std::set<std::string> counted;
  for (const std::string& id : person.steps_taken) {
    out += (out.empty() ? "" : " ") + numberOf(id);
    if (!counted.insert(id).second) continue;
    for (const OrderChanged& rule : person.rules) {
      if (rule.step != id) continue;
      std::string to;
      for (const std::string& s : rule.steps) to += (to.empty() ? "" : ", ") + numberOf(s);
      // Translators: a condition as lesson files write it, and the numbers of the steps.
      const std::string said =
          " (" + (rule.skips ? trf("{0}: skips {1}", rule.rule, to) : trf("{0}: goes to {1}", rule.rule, to)) + ")";
      // Several attempts may have triggered it.
      if (!out.ends_with(said)) out += said;
    }
  }
  return out;
}

std::string summaryText(const ClassSummary& summary) {
  // The number of students behind attempts without a name is unknown. With codes in place of names, each is listed.
  const std::size_t people = summary.people.size() - summary.nameless, lessons = summary.lessons.size();
  const std::string of_lessons = trnf("{0} lesson", "{0} lessons", lessons, lessons),
                    attempts = trnf("{0} attempt", "{0} attempts", summary.attempts, summary.attempts);
  if (people == 0) return trf("{0}, {1}, all without a name", of_lessons, attempts);
  const std::string all =
      trf("{0}, {1}, {2}", trnf("{0} student", "{0} students", people, people), of_lessons, attempts);
  return summary.nameless ? trf("{0}, {1} of them without a name", all, summary.nameless) : all;
}

}  // namespace moltact
