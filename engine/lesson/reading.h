// State that the parts of the lesson reader share: the source, the problems so far, and each part's entry. Internal.
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
  /// Takes over problems that do not name the file yet.
  void add(std::vector<Problem> problems) {
    for (Problem& p : problems) {
      if (enough()) return;
      p.file = source.name();
      errors.push_back(std::move(p));
    }
  }
};

/// Reads the front matter into the lesson; the offset of the first byte after it.
std::size_t readFrontMatter(Reading& reading, Lesson& lesson);

/// Where fenced blocks begin that have no end: the file ends in them, or a block of a lesson begins in a block of a
/// lesson.
std::vector<Place> findOpenFences(const SourceText& source, std::size_t from);

/// Problems with lines that are no heading or choice for want of a blank.
void findLineSlips(Reading& reading, std::size_t from);

/// Reads a scene block upon the scene of the step before (nullptr for the first).
SceneSpec readScene(Reading& reading, const MarkdownBlock& block, const SceneSpec* before, const Lesson& lesson);

/// Reads a touch block; no kind (an empty spec) where it names none, or two.
TaskSpec readTouch(Reading& reading, const MarkdownBlock& block, const Lesson& lesson);

/// The goals that a value counts from 1, as indices; a problem for each that the lesson does not have.
std::vector<std::size_t> readGoals(Reading& reading, const Value& value, const Lesson& lesson);

/// Reads a step block into the step.
void readStep(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Step& step);

/// Reads the answer block of a question into it: what is right, where it says so, and what its answers do.
void readAnswer(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Question& question);

/// Once the lesson has been read: goals of steps go to their tasks and questions, and the steps that rules name become
/// ids; problems with those that there are not.
void finishWays(Reading& reading, Lesson& lesson);

/// Reads the task list of a question.
std::vector<Choice> readChoices(Reading& reading, const MarkdownBlock& list);

/// Problems with a finished question: nothing to answer, nothing right.
void checkQuestion(Reading& reading, const Question& question);

/// Reads what is plain text, a list, a quote or a picture; `blocks` gets what is shown.
void readProse(Reading& reading, const MarkdownBlock& block, std::vector<Block>& blocks);

/// Reads a block of a glossary: its lists are words with their meanings, other text is passed over.
void readWords(Reading& reading, const MarkdownBlock& block, std::vector<GlossaryWord>& words);

/// Problems with links to steps that do not exist.
void checkLinks(Reading& reading, const Lesson& lesson);

}  // namespace moltact::reading
