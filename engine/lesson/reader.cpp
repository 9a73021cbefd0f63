#include "engine/lesson/reader.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/suggestion.h"

namespace moltact {
namespace {

using Kind = MarkdownBlock::Kind;
using reading::Reading;

constexpr std::string_view kQuestion = "Question:";
constexpr std::string_view kAside = "Aside:";

/// Walks the document from top to bottom and puts each block where it belongs.
class Walk {
 public:
  Walk(Reading& reading, Lesson& lesson) : reading_(reading), lesson_(lesson) {}

  /// False where there are more steps than are read.
  bool run(const MarkdownBlock& root) {
    for (const MarkdownBlock& block : root.children) {
      if (too_many_) break;
      take(block);
    }
    endQuestion();
    if (lesson_.steps.empty()) {
      reading_.error(root.children.empty() ? Place{1, 1} : root.children.front().place, "the lesson has no steps",
                     "start each step with a heading '## …'");
    } else if (!scene_stated_) {
      reading_.error(lesson_.steps[0].place, "the first step has no scene",
                     "add a fenced block 'scene' with 'molecule: …'");
    }
    return !too_many_;
  }

 private:
  Step* step() { return lesson_.steps.empty() ? nullptr : &lesson_.steps.back(); }
  const Step* lastMainStep() const { return last_main_ ? &lesson_.steps[*last_main_] : nullptr; }
  std::vector<Block>& blocks() { return step() ? step()->blocks : lesson_.introduction; }

  void take(const MarkdownBlock& block) {
    switch (block.kind) {
      case Kind::Heading:
        heading(block);
        return;
      case Kind::Code:
        if (block.info == "scene") return scene(block);
        if (block.info == "touch") return touch(block);
        if (block.info == "answer") return answer(block);
        if (!block.info.empty()) unknownFence(block);
        break;
      case Kind::List:
        if (in_question_ && step()->questions.back().choices.empty() && !block.children.empty() &&
            std::any_of(block.children.begin(), block.children.end(),
                        [](const MarkdownBlock& i) { return i.is_task; })) {
          step()->questions.back().choices = reading::readChoices(reading_, block);
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
    if (title.starts_with(kQuestion) && block.level != 3)
      reading_.error(block.place, "a question on the wrong level of heading", "write it as '### Question: …'");
    if (block.level == 1) {
      // Many editors want a first heading; the title in the front matter is the one that is shown.
      if (step())
        reading_.error(block.place, "a heading of the first level inside the lesson", "start each step with '## …'");
      return;
    }
    endQuestion();
    if (block.level == 2) return startStep(block, title);
    if (title.starts_with(kQuestion)) return startQuestion(block, title);
    blocks().push_back(Subheading{block.text});
  }

  void startStep(const MarkdownBlock& block, const std::string& title) {
    if (lesson_.steps.size() == kMostLessonSteps) {
      too_many_ = true;
      reading_.error(block.place, "a lesson of more than " + std::to_string(kMostLessonSteps) + " steps",
                     "split it into several lessons");
      return;
    }
    Step next;
    // The id is that of the whole heading, so that links work on Git hosts too.
    next.id = slug(title);
    next.aside = title.starts_with(kAside);
    next.title = next.aside ? stripped(std::string_view(title).substr(kAside.size())) : title;
    next.place = block.place;
    if (next.aside && !step())
      reading_.error(block.place, "the first step is an aside", "start with a step that every student sees: '## …'");
    if (next.title.empty()) reading_.error(block.place, "a step without a name", "write its name after '## '");
    if (const auto [twin, is_new] = step_lines_.emplace(next.id, block.place.line); !is_new && !next.id.empty())
      reading_.error(block.place, "two steps are called '" + title + "'",
                     "rename one; the other is on line " + std::to_string(twin->second));
    question_lines_.clear();
    // What an aside puts on the stage is gone where the student has passed it over.
    if (step()) next.scene = next.aside || !lastMainStep() ? step()->scene : lastMainStep()->scene;
    if (!next.aside) last_main_ = lesson_.steps.size();
    lesson_.steps.push_back(std::move(next));
  }

  void startQuestion(const MarkdownBlock& block, const std::string& title) {
    if (!step()) {
      reading_.error(block.place, "a question before the first step", "put it below a heading '## …'");
      return;
    }
    Question question;
    question.place = block.place;
    question.title = block.text;
    std::size_t left = kQuestion.size();
    for (TextRun& run : question.title) {
      const std::size_t now = std::min(left, run.text.size());
      run.text.erase(0, now);
      left -= now;
    }
    std::erase_if(question.title, [](const TextRun& r) { return r.text.empty(); });
    if (!question.title.empty() && question.title.front().text.starts_with(' '))
      question.title.front().text.erase(0, 1);
    const std::string_view asked = stripped(std::string_view(title).substr(kQuestion.size()));
    if (asked.empty()) reading_.error(block.place, "a question without words", "write it after 'Question:'");
    question.id = slug(asked);
    if (const auto [twin, is_new] = question_lines_.emplace(question.id, block.place.line); !is_new && !asked.empty())
      reading_.error(block.place, "this question is asked twice in one step",
                     "rename one; the other is on line " + std::to_string(twin->second));
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
      reading_.error(block.place, "a " + block.info + " block before the first step", "put it below a heading '## …'");
    return !step();
  }

  void scene(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    if (step()->states_scene) {
      reading_.error(block.place, "a second scene in one step", "start a new step, or put both into one block");
      return;
    }
    const SceneSpec before = step()->scene;
    step()->scene = reading::readScene(reading_, block, scene_stated_ ? &before : nullptr, lesson_);
    step()->states_scene = scene_stated_ = true;
  }

  void touch(const MarkdownBlock& block) {
    if (outsideStep(block)) return;
    if (!scene_stated_) {
      // A later step's scene does not help the student who is here now.
      reading_.error(block.place, "a touch task without anything on the stage", "put a scene block above it");
      scene_stated_ = true;
    }
    TaskSpec task = reading::readTouch(reading_, block);
    if (task.kind.empty()) return;
    step()->tasks.push_back(std::move(task));
    step()->blocks.push_back(TaskHere{step()->tasks.size() - 1});
  }

  void answer(const MarkdownBlock& block) {
    if (!in_question_) {
      reading_.error(block.place, "an answer block without a question", "put '### Question: …' above it");
      return;
    }
    if (step()->questions.back().answer) {
      reading_.error(block.place, "a second answer block in one question", "take one of the two out");
      return;
    }
    step()->questions.back().answer = reading::readAnswer(reading_, block);
  }

  void unknownFence(const MarkdownBlock& block) {
    constexpr std::string_view kFences[] = {"scene", "touch", "answer"};
    reading_.warning(block.place, "'" + block.info + "' is no block of a lesson and is shown as it stands",
                     suggest(block.info, kFences, "blocks"));
  }

  Reading& reading_;
  Lesson& lesson_;
  bool in_question_ = false, scene_stated_ = false, too_many_ = false;
  std::optional<std::size_t> last_main_;                                      // the last step that is no aside
  std::unordered_map<std::string, std::size_t> step_lines_, question_lines_;  // by id; the questions of this step
};

/// Problems with the bytes themselves, after which nothing else can be read.
std::optional<Problem> badBytes(const SourceText& source) {
  if (source.bytes().size() > kLargestLesson)
    return Problem{source.name(), 0, 0, "a lesson of more than 1 MiB", "split it into several lessons"};
  if (stripped(source.bytes()).empty())
    return Problem{source.name(), 1, 1, "the file is empty", "start from the text of another lesson"};
  for (std::size_t n = 1; n <= source.lineCount(); ++n)
    if (source.line(n).size() > kLongestLessonLine)
      return Problem{source.name(), n, 1, "a line of more than " + std::to_string(kLongestLessonLine) + " bytes",
                     "break it into several lines"};
  if (const std::size_t bad = firstBadByte(source.bytes()); bad != std::string_view::npos) {
    const Place place = source.at(bad);
    return Problem{source.name(), place.line, place.column, "this is not UTF-8 text",
                   "save the file in the encoding UTF-8"};
  }
  return {};
}

}  // namespace

std::string plainText(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) out += run.text;
  return out;
}

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
    if (whole && open_fences.empty()) reading::checkLinks(reading, lesson);
  } else {
    reading.errors.push_back(tree.problem());
  }
  if (!open_fences.empty()) {
    // What follows was read as part of the block, so most of what could be told of it would be wrong.
    const auto follows = [&](const Problem& p) { return p.line >= open_fences.front().line; };
    std::erase_if(reading.errors, follows);
    std::erase_if(reading.warnings, follows);
    for (const Place place : open_fences)
      reading.error(place, "this fenced block has no end, so what follows it is not read",
                    "close it with a line of its own: ```");
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
