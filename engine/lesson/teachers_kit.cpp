#include "engine/lesson/teachers_kit.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/class_plan.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/letters.h"
#include "engine/lesson/reading.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using Kind = MarkdownBlock::Kind;
using reading::Reading;

constexpr std::string_view kKitFolder = "kits", kExitQuestion = "Question:";

enum class KitSection { None, PriorKnowledge, TouchShows, Limits, Prompts, ExitTicket, Curriculum };

struct KitHeading {
  KitSection section;
  std::string_view english, german;  // slugs
};
constexpr std::array kKitHeadings{
    KitHeading{KitSection::PriorKnowledge, "prior-knowledge", "vorwissen"},
    KitHeading{KitSection::TouchShows, "what-touch-shows", "was-die-hand-zeigt"},
    KitHeading{KitSection::Limits, "limits-of-the-model", "grenzen-des-modells"},
    KitHeading{KitSection::Prompts, "what-to-ask", "was-zu-fragen-ist"},
    KitHeading{KitSection::ExitTicket, "exit-ticket", "abschlusskarte"},
    KitHeading{KitSection::Curriculum, "curriculum", "lehrplan"},
};

KitSection kitSectionOf(std::string_view heading) {
  const std::string id = slug(heading);
  for (const KitHeading& h : kKitHeadings)
    if (id == h.english || id == h.german) return h.section;
  return KitSection::None;
}

/// Removes this many bytes and the following blanks from the start.
RichText textAfter(RichText text, std::size_t bytes) {
  for (TextRun& run : text) {
    const std::size_t now = std::min(bytes, run.text.size());
    run.text.erase(0, now);
    bytes -= now;
    if (bytes == 0 && !run.text.empty()) {
      run.text.erase(0, std::min(run.text.find_first_not_of(' '), run.text.size()));
      if (!run.text.empty()) break;
    }
  }
  std::erase_if(text, [](const TextRun& run) { return run.text.empty(); });
  return text;
}

/// "[Step](lesson.md#step): Question? *Answer.*"
KitPrompt promptOf(const RichText& text, Place place) {
  KitPrompt out;
  out.place = place;
  std::size_t k = 0;
  for (; k < text.size() && !text[k].link.empty(); ++k)
    if (const std::size_t hash = text[k].link.find('#'); hash != std::string::npos)
      out.step = text[k].link.substr(hash + 1);
  RichText rest(text.begin() + std::ptrdiff_t(k), text.end());
  if (k > 0 && !rest.empty() && rest[0].text.starts_with(':')) rest = textAfter(std::move(rest), 1);
  const auto answer = std::find_if(rest.begin(), rest.end(), [](const TextRun& run) { return run.italic; });
  out.question.assign(rest.begin(), answer);
  out.answer.assign(answer, rest.end());
  for (TextRun& run : out.answer) run.italic = false;
  return out;
}

class KitWalk {
 public:
  KitWalk(Reading& reading, TeachersKit& kit) : reading_(reading), kit_(kit) {}

  void take(const MarkdownBlock& block) {
    if (block.kind == Kind::Heading) return heading(block);
    if (block.kind == Kind::Html) return;
    if (section_ == KitSection::None) return;
    if (block.kind == Kind::List && section_ == KitSection::ExitTicket && !kit_.exit_ticket.empty() &&
        kit_.exit_ticket.back().choices.empty()) {
      kit_.exit_ticket.back().choices = reading::readChoices(reading_, block);
      kit_.exit_ticket.back().in_order = true;
    } else if (block.kind == Kind::List && section_ != KitSection::ExitTicket) {
      for (const MarkdownBlock& item : block.children) {
        RichText text = item.text;
        for (const MarkdownBlock& child : item.children)
          if (text.empty()) text = child.text;
        if (!text.empty()) put(std::move(text), item.place);
      }
    } else if (block.kind == Kind::Paragraph && section_ != KitSection::ExitTicket) {
      put(block.text, block.place);
    } else {
      reading_.error(block.place, tr("this text has no place in a teacher's kit"),
                     section_ == KitSection::ExitTicket ? tr("write '### Question: …', and below it choices '- [ ] …'")
                                                        : tr("write it as a list, lines that start with '- '"));
    }
  }

 private:
  void heading(const MarkdownBlock& block) {
    const std::string title(stripped(plainText(block.text)));
    if (block.level == 1) return;
    if (section_ == KitSection::ExitTicket && block.level == 3 && title.starts_with(kExitQuestion)) {
      Question question;
      question.place = block.place;
      question.title = textAfter(block.text, kExitQuestion.size());
      question.id = slug(bareText(question.title));
      kit_.exit_ticket.push_back(std::move(question));
      return;
    }
    section_ = block.level == 2 ? kitSectionOf(title) : KitSection::None;
    if (section_ == KitSection::None)
      reading_.error(block.place, trf("'{0}' is no part of a teacher's kit", title),
                     tr("the parts are '## Prior knowledge', '## What touch shows', '## Limits of the model', '## What "
                        "to ask', '## Exit ticket' and '## Curriculum'"));
  }

  void put(RichText text, Place place) {
    switch (section_) {
      case KitSection::PriorKnowledge:
        return kit_.prior_knowledge.push_back(std::move(text));
      case KitSection::TouchShows:
        return kit_.touch_shows.push_back(std::move(text));
      case KitSection::Limits:
        return kit_.limits.push_back(std::move(text));
      case KitSection::Curriculum:
        return kit_.curriculum.push_back(std::move(text));
      case KitSection::Prompts:
        return kit_.prompts.push_back(promptOf(text, place));
      case KitSection::ExitTicket:
      case KitSection::None:
        return;
    }
  }

  Reading& reading_;
  TeachersKit& kit_;
  KitSection section_ = KitSection::None;
};

bool hasWebAddress(const RichText& text) {
  return std::any_of(text.begin(), text.end(),
                     [](const TextRun& run) { return linkScheme(run.link).starts_with("http"); });
}

}  // namespace

bool isKitFile(const fs::path& file) {
  return file.extension() == ".md" && file.has_parent_path() && file.parent_path().filename() == kKitFolder;
}

TeachersKit readKit(const std::string& name, std::string bytes) {
  TeachersKit out;
  out.file = name;
  out.present = true;
  const SourceText source(name, std::move(bytes));
  Reading reading{source, {}, {}};
  if (source.bytes().size() > kLargestLesson)
    reading.error({1, 1}, tr("a teacher's kit of more than 1 MiB"), tr("shorten it"));
  else if (const std::size_t bad = firstBadByte(source.bytes()); bad != std::string_view::npos)
    reading.error(source.at(bad), tr("this is not UTF-8 text"), tr("save the file in the encoding UTF-8"));
  else if (const auto tree = parseMarkdown(source, 0); !tree)
    reading.errors.push_back(tree.problem());
  else {
    KitWalk walk(reading, out);
    for (const MarkdownBlock& block : tree->children) walk.take(block);
  }
  orderProblems(reading.errors);
  out.problems = std::move(reading.errors);
  return out;
}

TeachersKit kitOf(const fs::path& lesson_file) {
  const fs::path file = lesson_file.parent_path() / kKitFolder / lesson_file.filename();
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    TeachersKit out;
    out.file = file;
    return out;
  }
  Expected<std::string> bytes = readLessonFile(file);
  if (bytes) return readKit(file.string(), *std::move(bytes));
  TeachersKit out;
  out.file = file;
  out.present = true;
  out.problems.push_back(bytes.problem());
  return out;
}

std::vector<Problem> kitLacks(const Lesson& lesson, const TeachersKit& kit) {
  std::vector<Problem> out = kit.problems;
  const auto lacks = [&](Place place, std::string message, std::string remedy) {
    out.push_back({kit.file.string(), place.line, place.column, std::move(message), std::move(remedy)});
  };
  if (!kit.present) {
    Problem missing{lesson.file, 0, 0, tr("the lesson has no teacher's kit"),
                    trf("write what only you can know into {0}; docs/teachers-kit.md tells how", kit.file.string())};
    return {std::move(missing)};
  }
  if (lesson.goals.empty())
    lacks({}, tr("the teacher's page has no goals"), tr("write 'goals:' into the lesson's front matter"));
  if (kit.prior_knowledge.empty())
    lacks({}, tr("the kit does not say what students must know before"), tr("write it below '## Prior knowledge'"));
  if (kit.touch_shows.empty())
    lacks({}, tr("the kit does not say what touch shows that a picture does not"),
          tr("write it below '## What touch shows'"));
  if (kit.limits.empty())
    lacks({}, tr("the kit does not state the limits of the model"), tr("write them below '## Limits of the model'"));
  if (kit.prompts.empty())
    lacks({}, tr("the kit has nothing to ask the class"), tr("write questions below '## What to ask'"));
  for (const KitPrompt& prompt : kit.prompts) {
    if (prompt.step.empty() || !lesson.find(prompt.step))
      lacks(prompt.place, tr("this question belongs to no step of the lesson"),
            trf("begin it with a link to the step: [its name]({0}#its-name): …",
                "../" + fs::path(lesson.file).filename().string()));
    if (prompt.answer.empty())
      lacks(prompt.place, tr("this question has no expected answer"), tr("write it in *stars* behind the question"));
  }
  if (kit.exit_ticket.size() != kExitQuestions)
    lacks({},
          trnf("the exit ticket has {0} question", "the exit ticket has {0} questions", kit.exit_ticket.size(),
               kit.exit_ticket.size()),
          tr("write three below '## Exit ticket'"));
  for (const Question& question : kit.exit_ticket) {
    if (question.choices.size() < 2 || question.rightChoices() != 1)
      lacks(question.place, tr("this question of the exit ticket does not have exactly one right choice among several"),
            tr("write choices '- [ ] …' below it, and '- [x] …' for the right one"));
    for (const Choice& choice : question.choices)
      if (!choice.right && choice.feedback.empty())
        lacks(choice.place, tr("this choice does not say which misconception it stands for"),
              tr("write → after it, and the misconception"));
  }
  for (const RichText& code : kit.curriculum)
    if (!hasWebAddress(code))
      lacks({}, trf("'{0}' names no source that it was checked against", plainText(code)),
            tr("add a link to the source, or take the code out"));
  if (const int minutes = minutesOf(classPlan(lesson)); minutes > kClassMinutes)
    lacks({}, trf("the time line takes {0} minutes, more than {1}", minutes, kClassMinutes),
          tr("shorten the core, or mark steps as extra with 'extra: yes' in a step block"));
  return out;
}

}  // namespace moltact
