// `moltact play`: runs a scripted learner through a lesson, without a window and on a virtual clock.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands/command.h"
#include "app/commands/lesson_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/print_json.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/answers_file.h"
#include "engine/molecule/reader.h"
#include "engine/platform/read_file.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

// "step 2 of 5" for a step of the core; steps outside the core have no number.
std::string placeOf(const Lesson& lesson, std::size_t step) {
  if (lesson.steps[step].aside) return lesson.steps[step].extra ? "extra step" : "aside";
  const auto core = [](const Step& s) { return !s.aside; };
  const auto begin = lesson.steps.begin();
  return "step " + std::to_string(std::count_if(begin, begin + std::ptrdiff_t(step) + 1, core)) + " of " +
         std::to_string(std::count_if(begin, lesson.steps.end(), core));
}

struct PlayOptions {
  std::string lesson, answers;
  bool demonstrate = false, json = false;
  double task_s = 180.0;
};

std::string lineOf(const Lesson& lesson, const LearnerEvent& e) {
  return lesson.file + ":" + std::to_string(e.place.line) + ":" + std::to_string(e.place.column) + ": ";
}

std::string figuresText(const std::vector<TaskFigure>& figures) {
  std::string out;
  for (const TaskFigure& f : figures) {
    char number[48];
    std::snprintf(number, sizeof number, f.value == std::round(f.value) ? "%.0f" : "%.2f", f.value);
    out += (out.empty() ? "" : ", ") + std::string(f.name) + " " + number + (f.unit.empty() ? "" : " ") +
           std::string(f.unit);
  }
  return out;
}

void print(const Lesson& lesson, const LearnerEvent& e) {
  using Kind = LearnerEvent::Kind;
  switch (e.kind) {
    case Kind::Step:
      out() << placeOf(lesson, e.index) << ": " << e.text << " (" << e.note << ")\n";
      break;
    case Kind::Task:
    case Kind::GaveUp:
      out() << "  task " << e.index + 1 << ": " << e.text << '\n';
      out() << "    " << (e.kind == Kind::Task ? "done: " : "NOT DONE: " + lineOf(lesson, e)) << e.note << '\n';
      out() << "    " << figuresText(e.figures) << '\n';
      break;
    case Kind::Question:
      out() << "  question " << e.index + 1 << ": " << e.text << '\n';
      out() << "    " << (!e.taken ? "not taken: " : e.right ? "right: " : "wrong: ") << e.answer << '\n';
      if (!e.note.empty()) out() << "    note: " << e.note << '\n';
      break;
    case Kind::Fault:
      out() << "  " << lineOf(lesson, e) << e.note << '\n';
      break;
  }
}

nlohmann::ordered_json jsonOf(const LearnerEvent& e) {
  using Kind = LearnerEvent::Kind;
  constexpr const char* kNames[] = {"step", "task", "gave up", "question", "fault"};
  nlohmann::ordered_json out{{"event", kNames[static_cast<int>(e.kind)]},
                             {"time_s", e.time_s},
                             {"step", e.step},
                             {"index", e.index},
                             {"line", e.place.line},
                             {"column", e.place.column}};
  if (!e.text.empty()) out["text"] = e.text;
  if (e.kind == Kind::Question) {
    out["answer"] = e.answer;
    out["right"] = e.right;
    if (!e.taken) out["taken"] = false;
  }
  if (!e.note.empty()) out["told"] = e.note;
  for (const TaskFigure& f : e.figures)
    out["figures"].push_back({{"name", f.name}, {"value", f.value}, {"unit", f.unit}});
  return out;
}

Expected<std::shared_ptr<const Molecule>> shared(Expected<Molecule> molecule) {
  if (!molecule) return molecule.problem();
  return std::make_shared<const Molecule>(*std::move(molecule));
}

// Finds molecules as the window does. Consecutive steps with the same molecule read it once.
MoleculeByName library(const std::filesystem::path& lesson) {
  struct Last {
    MoleculeKey key;
    std::shared_ptr<const Molecule> molecule;
  };
  return [lesson,
          last = std::make_shared<Last>()](const NamedMolecule& named) -> Expected<std::shared_ptr<const Molecule>> {
    const Expected<MoleculeKey> key = lessonMolecule(lesson, named);
    if (!key) return key.problem();
    if (last->molecule && last->key == *key) return last->molecule;
    auto molecule = shared(readMolecule(*key));
    if (molecule) *last = {*key, *molecule};
    return molecule;
  };
}

[[noreturn]] void fail(const std::vector<Problem>& problems) {
  for (std::size_t k = 0; k < problems.size(); ++k) err() << (k ? "" : "moltact: ") << problems[k].text() << '\n';
  throw CommandFailed{};
}

std::vector<LearnerAct> actsOf(const std::string& file) {
  const Expected<std::string> text =
      readFile(file, 1u << 20, "a file of answers is a text of some lines; take another file");
  if (!text) throw CommandError{text.problem().text()};
  AnswersReading read = readAnswers(file, *text);
  if (read.problems.empty()) return std::move(read.acts);
  fail(read.problems);
}

void run(const PlayOptions& options) {
  const Expected<LessonArgument> argument = LessonArgument::open(options.lesson);
  if (!argument) fail({argument.problem()});
  LessonReading reading = readLesson(argument->file());
  if (!reading.lesson) {
    for (Problem& p : reading.errors) p = argument->shown(std::move(p));
    fail(reading.errors);
  }
  const auto lesson = std::make_shared<const Lesson>(*std::move(reading.lesson));
  const std::vector<LearnerAct> acts = options.demonstrate ? std::vector<LearnerAct>() : actsOf(options.answers);
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  const auto watch = [&](const LearnerEvent& e) {
    if (options.json)
      events.push_back(jsonOf(e));
    else
      print(*lesson, e);
  };
  ScriptedLearner learner(lesson, library(argument->file()), watch, {.task_s = options.task_s});
  std::vector<Problem> problems;
  if (options.demonstrate)
    learner.demonstrate();
  else
    problems = carryOut(learner, acts, options.answers);

  const LessonSession& session = learner.session();
  std::string left;
  for (std::size_t k = 0; k < lesson->steps.size(); ++k)
    if (!session.stepDone(k)) left += (left.empty() ? "" : ", ") + lesson->steps[k].id;
  if (options.json) {
    nlohmann::ordered_json all{{"lesson", argument->shown(lesson->file)},
                               {"finished", session.finished()},
                               {"progress", session.progress()},
                               {"time_s", learner.time_s()}};
    all["events"] = std::move(events);
    all["problems"] = nlohmann::ordered_json::array();
    for (const Problem& p : problems) all["problems"].push_back(p.text());
    printDocument(all);
  } else {
    char time[32];
    std::snprintf(time, sizeof time, "%.1f s", learner.time_s());
    out() << (session.finished() ? "lesson finished" : "lesson not finished") << " after " << time
          << " on the virtual clock\n";
  }
  if (session.finished() && problems.empty()) return;
  if (!session.finished()) problems.push_back({{}, 0, 0, trf("the lesson was not finished; left in: {0}", left), {}});
  fail(problems);
}

}  // namespace

void addPlay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("play", "Run a scripted learner through a lesson, without a window");
  auto options = std::make_shared<PlayOptions>();
  command->add_option("lesson", options->lesson, "The lesson's file, or a pack")->type_name(kFileType)->required();
  CLI::Option* answers =
      command
          ->add_option(
              "--answers", options->answers,
              "File of acts, one per line:\n  do, touch PLACE, press FORCE [on PLACE], slide PLACE, wait TIME, lift,\n"
              "  method NAME, say WORD, draw FORCE, FORCE, …, answer QUESTION: ANSWER, next, back, go STEP")
          ->type_name(kFileType);
  CLI::Option* demonstrate =
      command->add_flag("--demonstrate", options->demonstrate, "Do every task and answer every question correctly");
  answers->excludes(demonstrate);
  command->add_flag("--json", options->json, "Print the events as JSON");
  command->add_option("--seconds", options->task_s, "Time limit of a task on the virtual clock")
      ->check(numberFrom(1.0, 36000.0))
      ->capture_default_str();
  command->callback([options] {
    if (options->answers.empty() && !options->demonstrate) throw CLI::RequiredError("--answers (or --demonstrate)");
    run(*options);
  });
}

}  // namespace moltact
