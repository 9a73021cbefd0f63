// Reads paragraphs, lists, quotes, tips, notes and pictures; the choices of questions; links.
#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_texts.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/suggestion.h"

namespace moltact::reading {
namespace {

using Kind = MarkdownBlock::Kind;

void takeOffStart(RichText& text, std::size_t bytes) {
  while (bytes > 0 && !text.empty()) {
    const std::size_t now = std::min(bytes, text.front().text.size());
    text.front().text.erase(0, now);
    bytes -= now;
    if (text.front().text.empty()) text.erase(text.begin());
  }
  if (!text.empty())
    text.front().text.erase(0, std::min(text.front().text.find_first_not_of(" \n"), text.front().text.size()));
}

/// The paragraphs in a quote; each list item becomes a paragraph.
void collectParagraphs(const MarkdownBlock& block, std::vector<RichText>& out) {
  if (!block.text.empty()) out.push_back(block.text);
  for (const MarkdownBlock& child : block.children) collectParagraphs(child, out);
}

/// "teacher: …", "For the teacher …", "Teachers …": variants of the word that hides a note from students.
bool nearlyForTeachers(std::string_view text) {
  std::string begin(text.substr(0, 24));
  for (char& c : begin)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const std::string_view word : {"teacher", "note for teacher", "for teacher", "for the teacher", "to the teacher",
                                      "instructor", "lehrer", "lehrkr"})
    if (begin.starts_with(word)) return true;
  // "Techer: …"
  constexpr std::string_view kWords[] = {"teacher", "teachers"};
  const std::size_t colon = begin.find(':');
  return colon != std::string::npos && !nearest(stripped(std::string_view(begin).substr(0, colon)), kWords).empty();
}

void readQuote(Reading& reading, const MarkdownBlock& block, std::vector<Block>& blocks) {
  std::vector<RichText> paragraphs;
  collectParagraphs(block, paragraphs);
  const std::string start = paragraphs.empty() ? std::string() : plainText(paragraphs[0]);
  const auto strip = [&](std::size_t bytes) {
    takeOffStart(paragraphs[0], bytes);
    if (plainText(paragraphs[0]).empty()) paragraphs.erase(paragraphs.begin());
    if (paragraphs.empty())
      reading.error(block.place, tr("this note is empty"), tr("write its text on the next line, after '> '"));
  };
  if (!start.starts_with("[!")) {
    blocks.push_back(Quote{std::move(paragraphs)});
    return;
  }
  const std::string word = start.substr(2, start.find(']') == std::string::npos ? 0 : start.find(']') - 2);
  if (word == "TIP") {
    strip(6);
    blocks.push_back(Tip{std::move(paragraphs)});
  } else if (word == "NOTE") {
    strip(7);
    const bool teacher = !paragraphs.empty() && plainText(paragraphs[0]).starts_with("Teacher:");
    if (teacher) {
      strip(8);
      blocks.push_back(TeacherNote{std::move(paragraphs)});
    } else {
      if (!paragraphs.empty() && nearlyForTeachers(plainText(paragraphs[0])))
        reading.warning(block.place, tr("students see this note, though it begins as if it were for the teacher"),
                        tr("begin it with 'Teacher:', spelt so"));
      blocks.push_back(Quote{std::move(paragraphs)});
    }
  } else {
    reading.error(block.place, trf("'[!{0}]' is no kind of note", word),
                  tr("write [!TIP] for a hint or [!NOTE] and 'Teacher:' for the teacher"));
  }
}

void readList(Reading& reading, const MarkdownBlock& list, int depth, ListBlock& out, std::vector<Block>& pictures) {
  int number = list.start;
  for (const MarkdownBlock& item : list.children) {
    ListBlock::Item line;
    line.depth = depth;
    line.number = list.ordered ? number++ : 0;
    line.text = item.text;
    if (item.is_task)
      reading.error(item.place, tr("a task list outside a question"),
                    tr("put '### Question: …' above it, or take out the '[ ]'"));
    for (const Image& image : item.images) pictures.push_back(image);
    bool placed = !line.text.empty();
    if (placed) out.items.push_back(line);
    for (const MarkdownBlock& child : item.children) {
      if (child.kind == Kind::List) {
        readList(reading, child, depth + 1, out, pictures);
      } else if (child.kind == Kind::Code) {
        reading.error(child.place, tr("a fenced block inside a list"),
                      tr("move it out of the list, to the start of the line"));
      } else if (!child.text.empty()) {
        ListBlock::Item more = line;
        more.text = child.text;
        if (placed) more.number = -1;
        out.items.push_back(std::move(more));
        placed = true;
      }
    }
  }
}

Table readTable(const MarkdownBlock& block) {
  Table table;
  for (const MarkdownBlock& row : block.children) {
    std::vector<RichText>& cells = table.rows.emplace_back();
    for (const MarkdownBlock& cell : row.children) {
      if (table.rows.size() == 1) table.sides.push_back(cell.side);
      cells.push_back(cell.text);
    }
    cells.resize(table.sides.size());
  }
  return table;
}

struct Arrow {
  std::size_t run = 0, at = 0, bytes = 0;
};

std::optional<Arrow> findArrow(const RichText& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i].code) continue;
    for (const std::string_view sign : {std::string_view("→"), std::string_view("->")})
      if (const std::size_t at = text[i].text.find(sign); at != std::string::npos) return Arrow{i, at, sign.size()};
  }
  return {};
}

// A tag is a few words; a sentence was meant as feedback for the student.
void checkTag(Reading& reading, Place place, const Choice& choice) {
  constexpr std::size_t kLongest = 60;
  if (choice.tag.empty())
    reading.error(place, tr("no text follows the second arrow"),
                  tr("write the misconception's tag there, or take the arrow out"));
  else if (characterCount(choice.tag) > kLongest)
    reading.warning(place, tr("the text after the second arrow is a tag for the report, which students do not see"),
                    trf("make it shorter than {0} characters, or take the second arrow out", kLongest));
  else if (choice.right)
    reading.warning(place, tr("a right choice has the tag of a misconception"), tr("take the second arrow out"));
}

void trimEnd(RichText& text) {
  while (!text.empty()) {
    std::string& last = text.back().text;
    last.erase(last.find_last_not_of(" \n") + 1);
    if (!last.empty()) return;
    text.pop_back();
  }
}

}  // namespace

void readProse(Reading& reading, const MarkdownBlock& block, std::vector<Block>& blocks) {
  switch (block.kind) {
    case Kind::Paragraph:
      if (!block.text.empty() && !stripped(plainText(block.text)).empty()) blocks.push_back(Paragraph{block.text});
      for (const Image& image : block.images) {
        if (image.path.empty())
          reading.error(block.place, tr("a picture without a file"), tr("write ![what it shows](picture.png)"));
        if (image.description.empty())
          reading.warning(block.place, tr("a picture without a description"),
                          tr("write what it shows between the square brackets"));
        blocks.push_back(image);
      }
      break;
    case Kind::List: {
      ListBlock list;
      std::vector<Block> pictures;
      readList(reading, block, 0, list, pictures);
      if (!list.items.empty()) blocks.push_back(std::move(list));
      blocks.insert(blocks.end(), pictures.begin(), pictures.end());
      break;
    }
    case Kind::Quote:
      readQuote(reading, block, blocks);
      break;
    case Kind::Code: {
      CodeText code;
      for (const BlockLine& line : block.lines) code.text += line.text + '\n';
      blocks.push_back(std::move(code));
      break;
    }
    case Kind::Table:
      blocks.push_back(readTable(block));
      break;
    case Kind::Html:
      // Comments are for authors; other HTML would silently disappear.
      if (const std::string html = plainText(block.text); !html.starts_with("<!--"))
        reading.warning(block.place, tr("HTML is not shown"), tr("write it in Markdown"));
      else if (html.find("-->") == std::string::npos)
        reading.error(block.place, tr("this comment has no end, so nothing below it is shown"),
                      tr("close it with '-->'"));
      break;
    default:
      break;
  }
}

std::vector<Choice> readChoices(Reading& reading, const MarkdownBlock& list, bool test) {
  std::vector<Choice> out;
  std::unordered_map<std::string, std::size_t> lines;  // by the text of the choice
  for (const MarkdownBlock& item : list.children) {
    Choice choice;
    choice.place = item.place;
    choice.right = item.ticked;
    choice.text = item.text;
    for (const MarkdownBlock& child : item.children)
      if (choice.text.empty()) choice.text = child.text;
    if (!item.is_task) {
      reading.error(item.place, tr("this choice does not say whether it is right"),
                    tr("start it with '- [x]' or '- [ ]'"));
      continue;
    }
    if (const auto arrow = findArrow(choice.text)) {
      choice.feedback.assign(choice.text.begin() + static_cast<std::ptrdiff_t>(arrow->run), choice.text.end());
      takeOffStart(choice.feedback, arrow->at + arrow->bytes);
      choice.text.resize(arrow->run + 1);
      choice.text.back().text.resize(arrow->at);
      trimEnd(choice.text);
      // The text after a second arrow is the tag for the report.
      if (const auto second = findArrow(choice.feedback)) {
        RichText tag(choice.feedback.begin() + static_cast<std::ptrdiff_t>(second->run), choice.feedback.end());
        takeOffStart(tag, second->at + second->bytes);
        choice.tag = stripped(plainText(tag));
        choice.feedback.resize(second->run + 1);
        choice.feedback.back().text.resize(second->at);
        trimEnd(choice.feedback);
        checkTag(reading, item.place, choice);
      }
      for (const TextRun& run : choice.feedback)
        if (choice.link.empty() && run.link.starts_with('#') && !sceneLink(run.link) && !wordLink(run.link))
          choice.link = run.link;
    }
    if (plainText(choice.text).empty())
      reading.error(item.place, tr("an empty choice"), tr("write what can be chosen, then → and the feedback"));
    else if (choice.feedback.empty() && !test)
      reading.warning(item.place, tr("this choice has no feedback"),
                      tr("write → after it and tell the student why it is right or wrong"));
    if (const auto [twin, is_new] = lines.emplace(plainText(choice.text), item.place.line);
        !is_new && !choice.text.empty())
      reading.error(item.place, tr("this choice is there twice"),
                    trf("take one of the two out; the other is on line {0}", twin->second));
    out.push_back(std::move(choice));
  }
  return out;
}

void checkQuestion(Reading& reading, const Question& question) {
  if (question.prediction && question.free())
    reading.error(question.place, tr("a prediction with a free answer, which has no feedback"),
                  tr("write '### Question: …', or give it choices"));
  if (question.answer) {
    if (!question.choices.empty())
      reading.error(question.place, tr("this question has both choices and an answer block"),
                    tr("keep one of the two"));
    return;
  }
  if (question.choices.empty() && question.block_place.line)
    reading.error(question.block_place, tr("the answer block does not define the right answer"),
                  tr("give one of 'number: …', 'text: …' and 'free: yes'"));
  else if (question.choices.empty())
    reading.error(question.place, tr("this question has nothing to answer"),
                  tr("add a list of choices '- [x] …' or an answer block"));
  else if (question.choices.size() == 1)
    reading.error(question.place, tr("this question has only one choice"), tr("add another line '- [ ] …'"));
  else if (question.rightChoices() == 0)
    reading.error(question.place, tr("this question has no right answer"), tr("mark the right choice with '[x]'"));
  else if (question.rightChoices() == question.choices.size())
    reading.warning(question.place, tr("every choice of this question is right"),
                    tr("take the '[x]' from those that are not, or add one that is not"));
}

void checkLinks(Reading& reading, const Lesson& lesson) {
  std::vector<std::string_view> ids;
  for (const Step& s : lesson.steps) ids.push_back(s.id);
  const std::unordered_set<std::string_view> known(ids.begin(), ids.end());
  const auto ofScene = [&](const TextRun& run, const SceneLink& link, const SceneSpec& scene) {
    if (link.kind == SceneLink::Kind::View && !findView(scene, link.of)) {
      std::vector<std::string> names;
      for (const NamedView& v : scene.views) names.push_back(slug(v.name));
      const std::vector<std::string_view> views(names.begin(), names.end());
      reading.error(
          run.link_place, trf("the scene has no view '{0}'", link.of),
          views.empty() ? tr("add a line 'view NAME: …' to the scene") : suggest(link.of, views, tr("views")));
    } else if (link.kind == SceneLink::Kind::State && (scene.then.molecule.empty() || !stateNamed(scene, link.of))) {
      reading.error(run.link_place, trf("'{0}' is no state of this scene", link.of),
                    scene.then.molecule.empty()
                        ? tr("add a line 'then: …' with the second one")
                        : tr("write one of its 'states', or a share from 0\u00a0% to 100\u00a0%"));
    } else if (link.kind == SceneLink::Kind::Zoom) {
      if (const auto atoms = parseSelection(link.of); !atoms)
        reading.error(run.link_place, atoms.problem().message, atoms.problem().remedy);
    }
  };
  const auto check = [&](const RichText& text, const SceneSpec& scene) {
    for (const TextRun& run : text) {
      if (!run.link.starts_with('#') || reading.enough()) continue;
      if (const auto link = sceneLink(run.link)) {
        ofScene(run, *link, scene);
        continue;
      }
      if (wordLink(run.link)) continue;
      const std::string_view id = std::string_view(run.link).substr(1);
      if (!known.contains(id))
        reading.error(run.link_place, trf("the link '{0}' leads to no step", run.link), suggest(id, ids, tr("steps")));
    }
  };
  const SceneSpec none;
  forEachText(lesson.introduction,
              [&](const RichText& text) { check(text, lesson.steps.empty() ? none : lesson.steps[0].scene); });
  for (const Step& step : lesson.steps) forEachText(step, [&](const RichText& text) { check(text, step.scene); });
}

}  // namespace moltact::reading
