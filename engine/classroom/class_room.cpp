#include "engine/classroom/class_room.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/classroom/secrets.h"
#include "engine/results/attempt_lines.h"

namespace moltact {
namespace {

using Record = nlohmann::ordered_json;

std::string recordText(const Record& record) {
  return record.dump(-1, ' ', false, Record::error_handler_t::replace) + '\n';
}

constexpr std::string_view kLineBegins = R"({"kind":"line","student":)", kAttemptFollows = R"(,"attempt":)",
                           kLineFollows = R"(,"line":)";

std::string lineRecordText(std::size_t student, std::size_t attempt, std::string_view line) {
  std::string out(kLineBegins);
  out.append(std::to_string(student)).append(kAttemptFollows).append(std::to_string(attempt));
  return out.append(kLineFollows).append(line).append("}\n");
}

bool takeText(std::string_view& from, std::string_view text) {
  if (!from.starts_with(text)) return false;
  from.remove_prefix(text.size());
  return true;
}

bool takeNumber(std::string_view& from, std::size_t& into) {
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), into);
  if (error != std::errc()) return false;
  from.remove_prefix(std::size_t(end - from.data()));
  return true;
}

bool isAttemptKey(std::string_view key) {
  return !key.empty() && key.size() <= kMaxAttemptKey && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

// A line as the page sends it: one JSON object without line ends in it.
bool isObjectLine(std::string_view line) {
  return line.size() <= kMaxClassLine && line.starts_with('{') && line.ends_with('}') &&
         line.find_first_of("\r\n") == std::string_view::npos && nlohmann::json::accept(line);
}

std::optional<std::size_t> stepNumber(const LessonOutline& lesson, std::string_view id) {
  for (std::size_t k = 0; k < lesson.steps.size(); ++k)
    if (lesson.steps[k].id == id) return k;
  return std::nullopt;
}

std::optional<std::size_t> questionNumber(const StepOutline& step, std::string_view id) {
  for (std::size_t k = 0; k < step.questions.size(); ++k)
    if (step.questions[k].id == id) return k;
  return std::nullopt;
}

// The kinds of lines that the teacher's page needs; the time of the others counts too.
bool isShownKind(std::string_view kind) {
  static constexpr std::array<std::string_view, 8> kShown{"step",  "answer", "hint",     "done",
                                                          "curve", "lesson", "progress", "prediction"};
  return kind.empty() || std::find(kShown.begin(), kShown.end(), kind) != kShown.end();
}

// The value of "t", which this program writes behind the kind, without parsing the rest. Lines of other programs give none.
std::optional<double> leadingTime(std::string_view line) {
  constexpr std::string_view kBefore = "\",\"t\":";
  const std::size_t at = line.find(kBefore);
  if (at == std::string_view::npos || at > 40) return std::nullopt;
  double value = 0.0;
  const char* begin = line.data() + at + kBefore.size();
  if (std::from_chars(begin, line.data() + line.size(), value).ec != std::errc()) return std::nullopt;
  return value >= 0.0 && value < 1e9 ? std::optional(value) : std::nullopt;
}

// Each choice once, however often a line repeats it.
std::vector<std::size_t> chosenOnce(const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < chosen.size() && out.size() < kMaxKeptChoices; ++k)
    if (std::find(out.begin(), out.end(), chosen[k]) == out.end()) out.push_back(chosen[k]);
  return out;
}

// At most kMaxKeptCurvePoints of a curve, evenly, with its ends.
std::vector<double> thinned(const std::vector<double>& values) {
  if (values.size() <= kMaxKeptCurvePoints) return values;
  std::vector<double> out;
  for (std::size_t k = 0; k < kMaxKeptCurvePoints; ++k)
    out.push_back(values[k * (values.size() - 1) / (kMaxKeptCurvePoints - 1)]);
  return out;
}

struct LiveFacts {
  LiveAttempt& attempt;
  double t_s;

  LiveAttempt::Step* at(const std::string& id, std::size_t* number = nullptr) const {
    const auto found = stepNumber(attempt.lesson, id);
    if (!found) return nullptr;
    if (number) *number = *found;
    return &attempt.steps[*found];
  }

  void operator()(const StepEntered& e) const {
    const auto found = stepNumber(attempt.lesson, e.step);
    if (!found) return;
    if (attempt.step) attempt.steps[*attempt.step].spent_s += std::max(0.0, t_s - attempt.entered_s);
    attempt.step = *found;
    attempt.steps[*found].entered = true;
    attempt.entered_s = t_s;
  }
  void operator()(const HintOpened& e) const {
    if (auto* step = at(e.step)) ++step->hints;
  }
  void operator()(const TaskDone& e) const {
    auto* step = at(e.step);
    if (step && e.task < step->tasks_done.size()) step->tasks_done[e.task] = 1;
  }
  void operator()(const ProgressMade& e) const {
    attempt.done = e.done;
    attempt.of = e.of;
  }
  void operator()(const Answered& e) const {
    std::size_t step = 0;
    if (!at(e.step, &step) || attempt.answers.size() >= kMaxKeptAnswers) return;
    const auto question = questionNumber(attempt.lesson.steps[step], e.question);
    if (question)
      attempt.answers[{step, *question}] = {chosenOnce(e.chosen), e.written.substr(0, 400), e.right, e.attempt};
  }
  void operator()(const CurveKept& e) const {
    std::size_t step = 0;
    if (e.felt || !at(e.step, &step) || attempt.curves.size() >= kMaxKeptCurves) return;
    if (e.task >= attempt.lesson.steps[step].tasks.size()) return;
    CurveKept& kept = attempt.curves[{step, e.task}];
    kept = e;
    kept.force_N = thinned(e.force_N);
  }
  void operator()(const LessonReread& e) const {
    attempt.lesson = e.lesson;
    attempt.steps.resize(e.lesson.steps.size());
    for (std::size_t k = 0; k < attempt.steps.size(); ++k)
      attempt.steps[k].tasks_done.resize(e.lesson.steps[k].tasks.size());
    if (attempt.step && *attempt.step >= attempt.steps.size()) attempt.step.reset();
    const auto missing = [&](const auto& entry) { return entry.first.first >= attempt.steps.size(); };
    std::erase_if(attempt.answers, missing);
    std::erase_if(attempt.curves, missing);
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

std::size_t LiveAttempt::hints() const {
  std::size_t out = 0;
  for (const Step& one : steps) out += one.hints;
  return out;
}

double LiveAttempt::spent_s(std::size_t at) const {
  return steps[at].spent_s + (step == at ? std::max(0.0, now_s - entered_s) : 0.0);
}

std::uint32_t lineMark(std::string_view line) {
  std::uint32_t out = 0x811c9dc5U;
  for (const char c : line) out = (out ^ static_cast<unsigned char>(c)) * 0x01000193U;
  return out;
}

std::optional<LineRecord> lineRecord(std::string_view record) {
  LineRecord out;
  while (record.ends_with('\n')) record.remove_suffix(1);
  if (!takeText(record, kLineBegins) || !takeNumber(record, out.student) || !takeText(record, kAttemptFollows) ||
      !takeNumber(record, out.attempt) || !takeText(record, kLineFollows) || !record.ends_with("}}"))
    return std::nullopt;
  out.line = record.substr(0, record.size() - 1);
  return out;
}

std::optional<ClassRoom::Joined> ClassRoom::join(std::string_view name, std::string token, double now_s) {
  if (ended_ || students_.size() >= kMaxStudents) return std::nullopt;
  Joined out;
  out.student = students_.size();
  LiveStudent& student = students_.emplace_back();
  student.name = names_.take(name);
  student.token = std::move(token);
  student.joined_s = student.seen_s = now_s;
  ++version_;
  out.record =
      recordText({{"kind", "joined"}, {"student", out.student}, {"name", student.name}, {"token", student.token}});
  return out;
}

std::optional<std::size_t> ClassRoom::studentOf(std::string_view token) const {
  if (token.empty()) return std::nullopt;
  std::optional<std::size_t> out;
  for (std::size_t k = 0; k < students_.size(); ++k)
    if (sameSecret(students_[k].token, token)) out = k;
  return out;
}

LiveAttempt& ClassRoom::attemptOf(LiveStudent& student, std::string_view key) {
  for (LiveAttempt& one : student.attempts)
    if (one.key == key) return one;
  LiveAttempt& made = student.attempts.emplace_back();
  made.key = key;
  return made;
}

ClassRoom::Taken ClassRoom::take(std::size_t number, std::string_view key, std::size_t from,
                                 const std::vector<std::string>& lines, double now_s) {
  LiveStudent& student = students_[number];
  seen(number, now_s);
  if (!isAttemptKey(key)) return {Refused::Broken, 0, {}};
  const auto known = std::find_if(student.attempts.begin(), student.attempts.end(),
                                  [&](const LiveAttempt& one) { return one.key == key; });
  const bool fresh = known == student.attempts.end();
  const std::size_t have = fresh ? 0 : known->lines;
  if (from > have) return {Refused::Gap, have, {}};
  const std::size_t first = have - from;  // the first line that is new
  if (first >= lines.size()) return {Refused::No, have, {}};
  // In part new: the page first looks whether the lines that are here are its own (lastMark).
  if (first > 0) return {Refused::Gap, have, {}};
  if (fresh && student.attempts.size() >= kMaxAttemptsOfStudent) return {Refused::Full, have, {}};
  std::size_t bytes = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!isObjectLine(lines[k])) return {Refused::Broken, have, {}};
    bytes += lines[k].size();
  }
  if (student.bytes + bytes > kMaxBytesOfStudent) return {Refused::Full, have, {}};
  std::string header;
  if (have == 0) {
    Expected<AttemptHeader> read = readHeaderLine(lines.front());
    if (!read) return {Refused::Broken, have, {}};
    read->student = student.name;
    header = lineOf(*read);
    header.pop_back();
  }

  Taken out;
  LiveAttempt& attempt = attemptOf(student, key);
  const std::size_t index = std::size_t(&attempt - student.attempts.data());
  if (fresh)
    out.records = recordText({{"kind", "attempt"}, {"student", number}, {"attempt", index}, {"key", std::string(key)}});
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string_view line = have == 0 && k == 0 ? std::string_view(header) : std::string_view(lines[k]);
    out.records += lineRecordText(number, index, line);
    apply(attempt, line);
  }
  student.bytes += bytes;
  student.current = index;
  out.have = attempt.lines;
  ++version_;
  return out;
}

std::optional<std::uint32_t> ClassRoom::lastMark(std::size_t student, std::string_view key) const {
  for (const LiveAttempt& one : students_[student].attempts)
    if (one.key == key && one.lines > 1) return one.last_mark;
  return std::nullopt;
}

void ClassRoom::apply(LiveAttempt& attempt, std::string_view line) {
  attempt.last_mark = lineMark(line);
  if (attempt.lines++ == 0) {
    Expected<AttemptHeader> header = readHeaderLine(line);
    if (header) LiveFacts{attempt, 0.0}(LessonReread{std::move(header->lesson)});
    return;
  }
  if (const auto t_s = leadingTime(line)) attempt.now_s = std::max(attempt.now_s, *t_s);
  if (!isShownKind(leadingKind(line))) return;
  const Expected<std::optional<AttemptEvent>> event = readEventLine(line);
  if (!event || !*event) return;
  const double t_s = std::clamp((*event)->t_s, 0.0, kMaxAttemptTime_s);
  attempt.now_s = std::max(attempt.now_s, t_s);
  std::visit(LiveFacts{attempt, t_s}, (*event)->what);
}

std::string ClassRoom::hold(const std::string& lesson, std::size_t step) {
  const bool known = std::any_of(lessons_.begin(), lessons_.end(), [&](const ClassLesson& one) {
    return one.id == lesson && step < one.outline.steps.size();
  });
  if (!known) return {};
  held_[lesson] = step;
  ++version_;
  return recordText({{"kind", "held"}, {"lesson", lesson}, {"step", step}});
}

std::string ClassRoom::open(const std::string& lesson) {
  if (held_.erase(lesson) == 0) return {};
  ++version_;
  return recordText({{"kind", "opened"}, {"lesson", lesson}});
}

std::string ClassRoom::show(const ShownPlot& plot) {
  const auto lesson =
      std::find_if(lessons_.begin(), lessons_.end(), [&](const ClassLesson& one) { return one.id == plot.lesson; });
  if (lesson == lessons_.end() || plot.step >= lesson->outline.steps.size()) return {};
  const StepOutline& step = lesson->outline.steps[plot.step];
  if (plot.number >= (plot.curve ? step.tasks.size() : step.questions.size())) return {};
  // Of typed predictions there is no plot, and what students type is nothing for the projector.
  if (!plot.curve &&
      (step.questions[plot.number].kind != AnswerKind::Prediction || step.questions[plot.number].choices.empty()))
    return {};
  shown_ = plot;
  ++version_;
  return recordText({{"kind", "shown"},
                     {"lesson", plot.lesson},
                     {"step", plot.step},
                     {plot.curve ? "task" : "question", plot.number}});
}

std::string ClassRoom::hide() {
  if (!shown_) return {};
  shown_.reset();
  ++version_;
  return recordText({{"kind", "hidden"}});
}

std::string ClassRoom::end() {
  if (ended_) return {};
  ended_ = true;
  ++version_;
  return recordText({{"kind", "ended"}});
}

bool ClassRoom::restore(std::string_view record) {
  ++version_;
  if (const auto line = lineRecord(record)) {
    if (line->student >= students_.size()) return false;
    LiveStudent& student = students_[line->student];
    if (line->attempt >= student.attempts.size() || !isObjectLine(line->line)) return false;
    apply(student.attempts[line->attempt], line->line);
    student.bytes += line->line.size();
    student.current = line->attempt;
    return true;
  }
  const Record r = Record::parse(record, nullptr, false);
  if (!r.is_object()) return false;
  const auto text = [&](const char* key) {
    return r.contains(key) && r[key].is_string() ? r[key].get<std::string>() : "";
  };
  const auto number = [&](const char* key) {
    return r.contains(key) && r[key].is_number_unsigned() ? r[key].get<std::size_t>() : ~std::size_t{0};
  };
  const std::string kind = text("kind");
  if (kind == "joined") {
    if (number("student") != students_.size() || students_.size() >= kMaxStudents) return false;
    LiveStudent& student = students_.emplace_back();
    student.name = cleanName(text("name"));
    student.token = text("token");
    student.joined_s = student.seen_s = kNotSeen_s;
    names_.mark(student.name);
    return true;
  }
  if (kind == "attempt") {
    if (number("student") >= students_.size() || !isAttemptKey(text("key"))) return false;
    LiveStudent& student = students_[number("student")];
    if (number("attempt") != student.attempts.size() || student.attempts.size() >= kMaxAttemptsOfStudent) return false;
    student.attempts.emplace_back().key = text("key");
    return true;
  }
  if (kind == "held") return !hold(text("lesson"), number("step")).empty();
  if (kind == "opened") return !open(text("lesson")).empty();
  if (kind == "shown") {
    const bool curve = r.contains("task");
    return !show({text("lesson"), number("step"), number(curve ? "task" : "question"), curve}).empty();
  }
  if (kind == "hidden") return !hide().empty();
  if (kind == "ended") return !end().empty();
  return false;
}

}  // namespace moltact
