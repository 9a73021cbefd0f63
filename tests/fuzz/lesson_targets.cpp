// Lessons, selections of atoms, and files of answers for the scripted learner.
#include "engine/lesson/check.h"
#include "engine/lesson/formula.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_picture.h"
#include "engine/lesson/problem_list.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/answers_file.h"
#include "engine/lesson/selection.h"
#include "tests/fuzz/target.h"
#include "tests/lesson/small_molecules.h"

namespace moltact::fuzz {

constexpr std::size_t kMaxFactsComputed = 3;  // a search on every path takes a second

void lesson(std::string_view bytes) {
  static const auto molecule = std::make_shared<const Molecule>(mixedMolecule());
  const auto by_name = [](const NamedMolecule& named) -> Expected<std::shared_ptr<const Molecule>> {
    if (named.name.size() > 6) return Problem{{}, 0, 0, "there is no such molecule", "take another"};
    return molecule;
  };
  const LessonCheck check = checkLesson("/nowhere/x.md", std::string(bytes), by_name);
  mustBe(check.lesson || !check.errors.empty(), "a lesson or an error");
  mustBe(check.errors.size() <= kMaxLessonProblems + 1 && check.warnings.size() <= kMaxLessonProblems + 1,
         "no more problems than are told");
  for (const Problem& p : check.errors) mustBe(!p.message.empty(), "a message");
  std::size_t facts = 0;
  if (check.lesson)
    for (const Step& step : check.lesson->steps)
      for (const FactsSpec& block : step.facts) facts += block.facts.size();
  if (facts > 0 && facts <= kMaxFactsComputed)
    for (const Problem& p : checkFacts(*check.lesson, by_name)) mustBe(!p.message.empty() && p.line > 0, "a line");
  if (check.lesson)
    mustBe(!check.lesson->steps.empty() && check.lesson->steps.size() <= kMaxLessonSteps, "1 to 1000 steps");
}

void glossary(std::string_view bytes) {
  const Glossary words = readGlossary("/nowhere/glossary.md", std::string(bytes));
  mustBe(words.words.size() <= kMaxGlossaryWords, "no more words than are read");
  Lesson lesson;
  lesson.steps.emplace_back().blocks.push_back(Paragraph{{TextRun{.text = std::string(bytes.substr(0, 2000))}}});
  const std::string before = bareText(std::get<Paragraph>(lesson.steps[0].blocks[0]).text);
  linkWords(lesson, words);
  const RichText& text = std::get<Paragraph>(lesson.steps[0].blocks[0]).text;
  mustBe(bareText(text) == before, "the text as it was");
  for (const TextRun& run : text)
    if (const auto word = wordLink(run.link)) mustBe(findWord(lesson, *word) != nullptr, "a word to each link");
}

void lessonPicture(std::string_view bytes) {
  const auto picture = readLessonPicture(bytes);
  if (!picture) return mustBe(!picture.problem().message.empty(), "a message");
  mustBe(picture->width_px > 0 && picture->width_px <= kLargestPicture_px && picture->height_px > 0 &&
             picture->height_px <= kLargestPicture_px &&
             picture->rgb.size() == std::size_t(3) * picture->width_px * picture->height_px,
         "pixels as many as it says");
}

void formula(std::string_view bytes) {
  std::vector<Problem> problems;
  for (const TextRun& run : formulaText(bytes, {1, 1}, problems)) mustBe(!run.text.empty(), "no empty run");
}

void selection(std::string_view bytes) {
  static const Molecule molecule = mixedMolecule();
  const auto read = parseSelection(bytes);
  if (!read) return mustBe(!read.problem().message.empty(), "a message");
  const std::vector<std::uint32_t> atoms = read->select(molecule);
  for (std::size_t i = 0; i < atoms.size(); ++i)
    mustBe(atoms[i] < molecule.atoms.size() && (i == 0 || atoms[i - 1] < atoms[i]), "atoms that are there, ascending");
  if (atoms.empty())
    mustBe(!read->whyEmpty(molecule).message.empty(), "a reason");
  else
    read->unmatchedNames(molecule);
  mustBe(!read->noun().empty(), "a noun");
}

void answers(std::string_view bytes) {
  for (const Problem& p : readAnswers("x.txt", bytes).problems)
    mustBe(!p.message.empty() && p.line > 0, "a message and its line");
}

}  // namespace moltact::fuzz
