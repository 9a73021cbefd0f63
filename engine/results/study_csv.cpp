#include "engine/results/study_csv.h"

#include <array>
#include <utility>

#include "engine/results/csv_row.h"

namespace moltact {
namespace {

// Column, what it holds, its unit or values.
constexpr std::array<std::array<const char*, 3>, 20> kColumns{{
    {"study", "name of the study", "text"},
    {"student", "code of the student", "text"},
    {"group", "group of the student", "text; empty: no part states one"},
    {"condition", "what the student got in this part", "touch, look, blind"},
    {"part", "part of the study", "pre, lesson, lesson 2 ..., post, delayed"},
    {"lesson", "file of the lesson or test", "text"},
    {"began_utc", "when the first attempt at the part began", "ISO 8601, UTC"},
    {"item", "number of the question in the part, from 1, equal in every language; of a task its step and number",
     "text"},
    {"kind", "what the row holds", "test, question, prediction, free, task, figure, measure"},
    {"text", "the question, the kind of the task, or the name of the figure or measure", "text"},
    {"answer", "numbers of the chosen answers in the order of the file, from 1, or what was written",
     "text; empty: not answered"},
    {"right", "whether the answer is right; of a task, whether it was solved", "1, 0; empty: not judged"},
    {"tries", "number of answers to the question", "count"},
    {"misconception", "tag of the chosen wrong answers", "text"},
    {"seconds",
     "time of use to the first answer, from the previous answer in the part or from entering the step; of a task, its "
     "duration",
     "s"},
    {"input", "input of the answer or task", "device, mouse, keyboard"},
    {"value", "of a figure or measure", "number"},
    {"unit", "of the value", "text"},
    {"attempts", "attempts of the student at the part; of a test only the first one is scored", "count"},
    {"goals", "numbers of the lesson's goals that the question serves, from 1", "text"},
}};

std::string joined(const std::vector<std::size_t>& numbers) {
  std::string out;
  for (const std::size_t n : numbers) out += (out.empty() ? "" : " ") + std::to_string(n + 1);
  return out;
}

// A row before its cells are written.
struct Cells {
  std::string item = {}, kind = {}, text = {}, answer = {}, right = {}, misconception = {}, input = {}, unit = {},
              goals = {};
  std::optional<double> seconds = {}, value = {};
  int tries = -1;
};

void write(std::string& out, const StudyData& study, const StudyStudent& student, const StudyPartOutline& part,
           const StudyScore& score, const Cells& cells) {
  CsvRow row(out);
  const auto number = [&](const std::optional<double>& v, int digits) { v ? row.value(*v, digits) : row.empty(); };
  for (const std::string& text : {study.name, student.name, student.group, score.condition, part.part, part.lesson.file,
                                  score.began, cells.item, cells.kind, cells.text, cells.answer, cells.right})
    row.text(text);
  cells.tries >= 0 ? row.whole(std::size_t(cells.tries)) : row.empty();
  row.text(cells.misconception);
  number(cells.seconds, 1);
  row.text(cells.input);
  number(cells.value, 4);
  row.text(cells.unit);
  row.whole(score.attempts);
  row.text(cells.goals);
}

const char* kindOf(const StudyPartOutline& part, const QuestionOutline& question) {
  if (question.kind == AnswerKind::Prediction) return "prediction";
  if (question.kind == AnswerKind::Free) return "free";
  return part.test() ? "test" : "question";
}

Cells questionCells(const StudyPartOutline& part, std::size_t k, const StudyScore& score) {
  const StudyItem& item = part.questions[k];
  const QuestionOutline& question = part.lesson.steps[item.step].questions[item.index];
  Cells cells{.item = std::to_string(k + 1), .kind = kindOf(part, question), .text = question.text};
  cells.goals = joined(question.goals);
  const auto found = score.answers.find(k);
  const bool judged = question.kind != AnswerKind::Free;
  if (found == score.answers.end()) {
    if (part.test() && judged) cells.right = "0";
    cells.tries = 0;
    return cells;
  }
  const StudyAnswer& answer = found->second;
  cells.answer = answer.written.empty() ? joined(answer.chosen) : answer.written;
  if (judged) cells.right = answer.right ? "1" : "0";
  cells.tries = answer.tries;
  for (const std::size_t c : answer.chosen)
    if (c < question.tags.size() && !question.tags[c].empty())
      cells.misconception += (cells.misconception.empty() ? "" : "; ") + question.tags[c];
  cells.seconds = answer.seconds;
  cells.input = nameOf(answer.by);
  return cells;
}

}  // namespace

std::string studyCsv(const StudyData& study) {
  std::string out = kByteOrderMark;
  {
    CsvRow head(out);
    for (const auto& column : kColumns) head.text(column[0]);
  }
  for (const StudyStudent& student : study.students)
    for (const StudyPartOutline& part : study.parts) {
      const auto found = student.parts.find(part.part);
      if (found == student.parts.end()) continue;
      const StudyScore& score = found->second;
      for (std::size_t k = 0; k < part.questions.size(); ++k)
        if (part.test() || score.answers.contains(k))
          write(out, study, student, part, score, questionCells(part, k, score));
      for (const StudyTask& task : score.tasks) {
        Cells cells{.item = task.step + "/task " + std::to_string(task.index + 1), .kind = "task", .text = task.kind};
        cells.right = task.solved ? "1" : "0";
        cells.seconds = task.took_s;
        cells.input = nameOf(task.by);
        write(out, study, student, part, score, cells);
        for (const LoggedFigure& f : task.figures)
          write(out, study, student, part, score,
                {.item = cells.item, .kind = "figure", .text = f.name, .unit = f.unit, .value = f.value});
      }
      const std::array<std::pair<const char*, std::pair<double, const char*>>, 6> measures{
          {{"time on task", {score.time_s, "s"}},
           {"touches", {double(score.touches), ""}},
           {"touch time", {score.touch_s, "s"}},
           {"peak force", {score.peak_N, "N"}},
           {"path", {score.path_A, "A"}},
           {"hints", {double(score.hints), ""}}}};
      for (const auto& [name, value] : measures)
        write(out, study, student, part, score,
              {.item = name, .kind = "measure", .text = name, .unit = value.second, .value = value.first});
    }
  return out;
}

std::string studyCodebook() {
  std::string out = kByteOrderMark;
  const auto line = [&](const char* column, const char* meaning, const char* values) {
    CsvRow row(out);
    row.text(column);
    row.text(meaning);
    row.text(values);
  };
  line("column", "meaning", "values or unit");
  for (const auto& column : kColumns) line(column[0], column[1], column[2]);
  for (const auto& [value, meaning] : std::array<std::pair<const char*, const char*>, 7>{
           {{"kind = test", "a question of a test; the last answer counts, and none counts as wrong"},
            {"kind = question", "a question of a lesson; the first answer counts"},
            {"kind = prediction", "a prediction before the touch; the first one counts, and no score contains it"},
            {"kind = free", "an answer in the student's own words"},
            {"kind = task", "a touch task that was ended"},
            {"kind = figure", "a quantity that the task measured; text, value and unit"},
            {"kind = measure", "a measure of the whole part; text, value and unit"}}})
    line(value, meaning, "");
  for (const auto& [value, meaning] : std::array<std::pair<const char*, const char*>, 3>{
           {{"condition = touch", "the lesson as it is written"},
            {"condition = look", "the same scenes and texts without touch and without touch tasks"},
            {"condition = blind", "the same touch without a picture of the molecule"}}})
    line(value, meaning, "");
  return out;
}

}  // namespace moltact
