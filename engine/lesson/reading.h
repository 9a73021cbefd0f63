// The state that the parts of the lesson reader share: source and problems; and the entry point of each part. Internal.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/lesson/markdown.h"
#include "engine/lesson/problem_list.h"
#include "engine/lesson/reader.h"

namespace moltact::reading {

struct Reading {
  const SourceText& source;
  std::vector<Problem> errors, warnings;

  bool enough() const { return enoughProblems(errors); }
  void error(Place place, std::string message, std::string remedy = {}) {
    if (!enough()) errors.push_back({source.name(), place.line, place.column, std::move(message), std::move(remedy)});
  }
  void warning(Place place, std::string message, std::string remedy = {}) {
    if (!enoughProblems(warnings))
      warnings.push_back({source.name(), place.line, place.column, std::move(message), std::move(remedy)});
  }
  /// Adds problems that have no file name yet.
  void add(std::vector<Problem> problems) {
    for (Problem& p : problems) {
      if (enough()) return;
      p.file = source.name();
      errors.push_back(std::move(p));
    }
  }
};

/// Reads the front matter into the lesson. Returns the offset of the first byte after it.
std::size_t readFrontMatter(Reading& reading, Lesson& lesson);

/// The opening fences of blocks without an end: the file ends inside them, or a lesson's block begins inside another.
std::vector<Place> findOpenFences(const SourceText& source, std::size_t from);

/// Adds a problem for each line that would be a heading or a choice if it had a blank after its signs.
void findLineSlips(Reading& reading, std::size_t from);

/// Adds a problem for a molecule that the front matter does not list.
void mustBeListed(Reading& reading, const Lesson& lesson, const std::string& name, Place place);

/// Reads a scene block. `before` is the previous step's scene, from which it starts (nullptr for the first).
SceneSpec readScene(Reading& reading, const MarkdownBlock& block, const SceneSpec* before, const Lesson& lesson);

/// Reads a touch block. Returns an empty spec if it names no kind, or two.
TaskSpec readTouch(Reading& reading, const MarkdownBlock& block, const Lesson& lesson);

/// Converts goals counted from 1 to indices. Adds a problem for each that the lesson does not have.
std::vector<std::size_t> readGoals(Reading& reading, const Value& value, const Lesson& lesson);

/// Reads a step block into the step.
void readStep(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Step& step);

/// Reads a question's answer block into it: the right answer, if it gives one, and the effects of answers.
void readAnswer(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Question& question);

/// Reads a block of facts. Those about the scene's own molecule start from `scene`.
FactsSpec readFacts(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, const SceneSpec& scene);

/// Called after the whole lesson has been read. Passes the steps' goals to their tasks and questions, and replaces the
/// steps in rules by ids. Adds a problem for each unknown step.
void resolveGoalsAndRules(Reading& reading, Lesson& lesson);

/// Changes the lesson to what its condition gives: takes out steps of other conditions, touch or the picture. Called
/// before the links are checked. Adds a problem if no step remains, and for what a test cannot have.
void applyCondition(Reading& reading, Lesson& lesson);

/// Reads the task list of a question. The choices of a `test` need no feedback.
std::vector<Choice> readChoices(Reading& reading, const MarkdownBlock& list, bool test = false);

/// Adds problems for a question without choices or answer, or without a right one.
void checkQuestion(Reading& reading, const Question& question);

/// Reads plain text, a list, a quote or a picture, and appends it to `blocks`.
void readProse(Reading& reading, const MarkdownBlock& block, std::vector<Block>& blocks);

/// Reads a block of a glossary: lists are words with their meanings, other text is ignored.
void readWords(Reading& reading, const MarkdownBlock& block, std::vector<GlossaryWord>& words);

/// Adds problems for links to steps that do not exist.
void checkLinks(Reading& reading, const Lesson& lesson);

}  // namespace moltact::reading
