#include "engine/lesson/reader.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/suggestion.h"

namespace moltact {
namespace {

using Kind = MarkdownBlock::Kind;
using reading::Reading;

constexpr std::string_view kQuestion = "Question:", kPrediction = "Prediction:";
constexpr std::string_view kAside = "Aside:";

/// Walks through the document from top to bottom and adds each block to its step.
class Walk {
 public:
  Walk(Reading& reading, Lesson& lesson) : reading_(reading), lesson_(lesson) {}

  /// Returns false if there are more steps than the limit.
  bool run(const MarkdownBlock& root) {
    for (const MarkdownBlock& block : root.children) {
      if (too_many_) break;
      take(block);
    }
    endQuestion();
    std::size_t reported = 0;
    for (const BlockLine& tag : root.lines)
      if (!tag.text.starts_with("<!--") && tag.place.line != std::exchange(reported, tag.place.line))
        reading_.warning(tag.place, tr("HTML is not shown"), tr("write it in Markdown"));
    for (const Problem& slip : root.slips) reading_.warning({slip.line, slip.column}, slip.message, slip.remedy);
    if (lesson_.steps.empty()) {
      reading_.error(root.children.empty() ? Place{1, 1} : root.children.front().place, tr("the lesson has no steps"),
                     tr("start each step with a heading '## …'"));
    } else if (!scene_stated_) {
      reading_.error(lesson_.steps[0].place, tr("the first step has no scene"),
                     tr("add a fenced block 'scene' with 'molecule: …'"));
    }
    return !too_many_;
  }

 private:
  Step* step() { return lesson_.steps.empty() ? nullptr : &lesson_.steps.back(); }
  const Step* lastMainStep() const { return last_main_ ? &lesson_.steps[*last_main_] : nullptr; }
  std::vector<Block>& blocks() { return step() ? step()->blocks : lesson_.introduction; }

  void take(const MarkdownBlock& block) {
    if (in_glossary_ && !(block.kind == Kind::Heading && block.level <= 2)) {
      reading::readWords(reading_, block, lesson_.glossary);
      return;
    }
    switch (block.kind) {
      case Kind::Heading:
        heading(block);
        return;
      case Kind::Code:
        if (block.info == "step") return stepBlock(block);
        if (block.info == "scene") return scene(block);
        if (block.info == "touch") return touch(block);
        if (block.info == "answer") return answer(block);
        if (block.info == "facts") return facts(block);
        if (!block.info.empty()) unknownFence(block);
        break;
      case Kind::List:
        if (in_question_ && step()->questions.back().choices.empty() && !block.children.empty() &&
            std::any_of(block.children.begin(), block.children.end(),
                        [](const MarkdownBlock& i) { return i.is_task; })) {
          step()->questions.back().choices = reading::readChoices(reading_, block, lesson_.test);
          step()->questions.back().in_order = block.ordered;
          return;
        }
        break;
      case Kind::Paragraph:
        if (in_question_ && step()->questions.back().choices.empty() && !step()->questions.back().answer &&
            block.images.empty()) {
          step()->questions.back().prompt.push_back(block.text);
          return;
        }
        break;
      default:
        break;
    }
    reading::readProse(reading_, block, blocks());
  }

  void heading(const MarkdownBlock& block) {
    const std::string title(stripped(plainText(block.text)));
    const bool question = title.starts_with(kQuestion), prediction = title.starts_with(kPrediction);
    if ((question || prediction) && block.level != 3)
      reading_.error(block.place, tr("a question on the wrong level of heading"),
                     question ? tr("write it as '### Question: …'") : tr("write it as '### Prediction: …'"));
    if (block.level == 1) {
      // Many editors require a first heading; the title in the front matter is displayed.
      if (step())
        reading_.error(block.place, tr("a heading of the first level inside the lesson"),
                       tr("start each step with '## …'"));
      return;
    }
    endQuestion();
    part_.reset();
    in_glossary_ = block.level == 2 && isGlossaryHeading(title);
    if (in_glossary_) return;
    if (block.level == 2) return startStep(block, title);
    if (question || prediction) return startQuestion(block, title, prediction ? kPrediction : kQuestion);
    blocks().push_back(Subheading{block.text});
    // Content above the heading indicates that a step was intended.
    if (step() && (!step()->tasks.empty() || !step()->questions.empty())) part_ = Part{block.place, title};
  }

  void startStep(const MarkdownBlock& block, const std::string& title) {
    if (lesson_.steps.size() == kMaxLessonSteps) {
      too_many_ = true;
      reading_.error(block.place, trf("a lesson of more than {0} steps", kMaxLessonSteps),
                     tr("split it into several lessons"));
      return;
    }
    Step next;
    // The id is derived from the whole heading, so that links also work on Git hosts.
    next.id = slug(bareText(block.text));
    next.aside = title.starts_with(kAside);
    next.title = next.aside ? stripped(std::string_view(title).substr(kAside.size())) : title;
    next.place = block.place;
    if (next.aside && !step())
      reading_.error(block.place, tr("the first step is an aside"),
                     tr("start with a step that every student sees: '## …'"));
    if (next.title.empty()) reading_.error(block.place, tr("a step without a name"), tr("write its name after '## '"));
    if (const auto [twin, is_new] = step_lines_.emplace(next.id, block.place.line); !is_new && !next.id.empty())
      reading_.error(block.place, trf("two steps are called '{0}'", title),
                     trf("rename one; the other is on line {0}", twin->second));
    question_lines_.clear();
    // The scene of an aside ends with it, because a student may not have visited it.
    if (step()) next.scene = next.aside || !lastMainStep() ? step()->scene : lastMainStep()->scene;
    main_before_ = last_main_;
    if (!next.aside) last_main_ = lesson_.steps.size();
    next.required = lesson_.required && !next.aside;
    lesson_.steps.push_back(std::move(next));
  }

  void startQuestion(const MarkdownBlock& block, const std::string& title, std::string_view opening) {
    if (!step()) {
      reading_.error(block.place, tr("a question before the first step"), tr("put it below a heading '## …'"));
      return;
    }
    Question question;
    question.place = block.place;
    question.title = block.text;
    question.prediction = opening == kPrediction;
    std::size_t left = opening.size();
    for (TextRun& run : question.title) {
      const std::size_t now = std::min(left, run.text.size());
      run.text.erase(0, now);
      left -= now;
    }
    std::erase_if(question.title, [](const TextRun& r) { return r.text.empty(); });
    if (!question.title.empty() && question.title.front().text.starts_with(' '))
      question.title.front().text.erase(0, 1);
    const std::string_view asked = stripped(std::string_view(title).substr(opening.size()));
    if (asked.empty())
      reading_.error(block.place, tr("a question without words"), trf("write it after '{0}'", opening));
    question.id = slug(asked);
    if (const auto [twin, is_new] = question_lines_.emplace(question.id, block.place.line); !is_new && !asked.empty())
      reading_.error(block.place, tr("this question is asked twice in one step"),
                     trf("rename one; the other is on line {0}", twin->second));
    step()->questions.push_back(std::move(question));
    step()->blocks.push_back(QuestionHere{step()->questions.size() - 1});
    in_question_ = true;
  }

  void endQuestion() {
    if (in_question_) reading::checkQuestion(reading_, step()->questions.back());
    in_question_ = false;
  }

  bool outsideStep(const MarkdownBlock& block) {
    if (!step())
      reading_.error(block.place, trf("a {0} block before the first step", block.info),
                     tr("put it below a heading '## …'"));
    return !step();
  }

  void scene(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    if (step()->states_scene) {
      // Usually the heading above was intended to begin a step.
      std::string heading;
      for (const Block& b : step()->blocks)
        if (const auto* s = std::get_if<Subheading>(&b)) heading = plainText(s->text);
      reading_.error(block.place, tr("a second scene in one step"),
                     heading.empty() ? tr("start a new step, or put both into one block")
                                     : trf("write '## {0}', with two signs, if a step is to begin there", heading));
      return;
    }
    const SceneSpec before = step()->scene;
    step()->scene = reading::readScene(reading_, block, scene_stated_ ? &before : nullptr, lesson_);
    step()->states_scene = scene_stated_ = true;
  }

  void stepBlock(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    if (step()->block_place.line) {
      reading_.error(block.place, tr("a second step block in one step"), tr("put both into one block"));
      return;
    }
    reading::readStep(reading_, block, lesson_, *step());
    if (step()->extra) makeExtra(block.place);
  }

  /// The scene of an extra step ends with it, as that of an aside does.
  void makeExtra(Place place) {
    if (lesson_.steps.size() == 1) {
      reading_.error(place, tr("the first step cannot be an extra step"),
                     tr("start with a step that every student sees"));
      return;
    }
    if (step()->states_scene)
      reading_.error(place, tr("an extra step has its step block below its scene"),
                     tr("put the step block above the scene block"));
    step()->required = false;
    if (step()->aside) return;
    step()->aside = true;
    last_main_ = main_before_;
    if (!step()->states_scene) step()->scene = lesson_.steps[lesson_.steps.size() - 2].scene;
  }

  void touch(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    if (!scene_stated_) {
      // A scene of a later step does not help at this one.
      reading_.error(block.place, tr("a touch task without anything on the stage"), tr("put a scene block above it"));
      scene_stated_ = true;
    }
    TaskSpec task = reading::readTouch(reading_, block, lesson_);
    if (task.kind.empty()) return;
    if (const auto part = std::exchange(part_, std::nullopt))
      reading_.warning(part->place,
                       tr("this heading begins no step, though a task stands below it and others above: students meet "
                          "all of them in one step"),
                       trf("write '## {0}', with two signs, if a step is to begin there", part->title));
    step()->tasks.push_back(std::move(task));
    step()->blocks.push_back(TaskHere{step()->tasks.size() - 1});
  }

  void answer(const MarkdownBlock& block) {
    if (!in_question_) {
      reading_.error(block.place, tr("an answer block without a question"), tr("put '### Question: …' above it"));
      return;
    }
    if (step()->questions.back().block_place.line) {
      reading_.error(block.place, tr("a second answer block in one question"), tr("take one of the two out"));
      return;
    }
    reading::readAnswer(reading_, block, lesson_, step()->questions.back());
  }

  void facts(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    step()->facts.push_back(reading::readFacts(reading_, block, lesson_, step()->scene));
  }

  void unknownFence(const MarkdownBlock& block) {
    constexpr std::string_view kFences[] = {"step", "scene", "touch", "answer", "facts"};
    reading_.warning(block.place, trf("'{0}' is not a block of a lesson and is shown unchanged", block.info),
                     suggest(block.info, kFences, tr("blocks")));
  }

  Reading& reading_;
  Lesson& lesson_;
  bool in_question_ = false, in_glossary_ = false, scene_stated_ = false, too_many_ = false;
  struct Part {
    Place place;
    std::string title;
  };
  std::optional<Part> part_;  // the heading within a step that no task follows, with the headings above it
  std::optional<std::size_t> last_main_, main_before_;  // the last step that is not an aside; the one before it
  std::unordered_map<std::string, std::size_t> step_lines_, question_lines_;  // by id; of the questions of this step
};

/// Problems with the bytes themselves, after which no further reading is possible.
std::optional<Problem> badBytes(const SourceText& source) {
  if (source.bytes().size() > kLargestLesson)
    return Problem{source.name(), 0, 0, tr("a lesson of more than 1 MiB"), tr("split it into several lessons")};
  if (stripped(source.bytes()).empty())
    return Problem{source.name(), 1, 1, tr("the file is empty"), tr("start from the text of another lesson")};
  for (std::size_t n = 1; n <= source.lineCount(); ++n)
    if (source.line(n).size() > kLongestLessonLine)
      return Problem{source.name(), n, 1, trf("a line of more than {0} bytes", kLongestLessonLine),
                     tr("break it into several lines")};
  if (const std::size_t bad = firstBadByte(source.bytes()); bad != std::string_view::npos) {
    const Place place = source.at(bad);
    return Problem{source.name(), place.line, place.column, tr("this is not UTF-8 text"),
                   tr("save the file in the encoding UTF-8")};
  }
  return {};
}

}  // namespace

std::string slug(std::string_view heading) {
  std::string out;
  for (const char c : stripped(heading)) {
    if (c >= 'A' && c <= 'Z')
      out += static_cast<char>(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || (c & 0x80))
      out += c;
    else if (c == ' ')
      out += '-';
  }
  return out;
}

LessonReading readLessonText(const std::string& name, std::string bytes) {
  const SourceText source(name, std::move(bytes));
  LessonReading out;
  if (auto bad = badBytes(source)) {
    out.errors.push_back(std::move(*bad));
    return out;
  }
  Reading reading{source, {}, {}};
  Lesson lesson;
  lesson.file = name;
  const std::size_t body = reading::readFrontMatter(reading, lesson);
  const auto tree = parseMarkdown(source, body);
  const std::vector<Place> open_fences = reading::findOpenFences(source, body);
  if (tree) {
    const bool whole = Walk(reading, lesson).run(*tree);
    if (whole && open_fences.empty()) reading::applyCondition(reading, lesson);
    if (whole && open_fences.empty()) reading::resolveGoalsAndRules(reading, lesson);
    if (open_fences.empty()) reading::findLineSlips(reading, body);
    if (whole && open_fences.empty()) reading::checkLinks(reading, lesson);
  } else {
    reading.errors.push_back(tree.problem());
  }
  if (!open_fences.empty()) {
    // The following text was parsed as part of the block, so most findings about it would be wrong.
    const auto follows = [&](const Problem& p) { return p.line >= open_fences.front().line; };
    std::erase_if(reading.errors, follows);
    std::erase_if(reading.warnings, follows);
    for (const Place place : open_fences)
      reading.error(place, tr("this fenced block has no end, so what follows it is not read"),
                    tr("close it with a line of its own: ```"));
  }
  orderProblems(reading.errors);
  orderProblems(reading.warnings);
  out.errors = std::move(reading.errors);
  out.warnings = std::move(reading.warnings);
  if (out.errors.empty())
    out.lesson = std::move(lesson);
  else if (tree && open_fences.empty())
    out.partial = std::move(lesson);
  return out;
}

LessonReading readLesson(const std::filesystem::path& file) {
  auto bytes = readLessonFile(file);
  if (bytes) return readLessonText(file.string(), *std::move(bytes));
  LessonReading out;
  out.errors.push_back(bytes.problem());
  return out;
}

}  // namespace moltact
