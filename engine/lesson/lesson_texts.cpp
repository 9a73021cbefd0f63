#include "engine/lesson/lesson_texts.h"

#include <algorithm>
#include <string_view>

#include "engine/core/utf8.h"

namespace moltact {
namespace {

struct Raised {
  char32_t on_line, super, sub;  // 0: not in Unicode
};
constexpr Raised kRaised[] = {
    {'0', U'⁰', U'₀'},  {'1', U'¹', U'₁'}, {'2', U'²', U'₂'}, {'3', U'³', U'₃'}, {'4', U'⁴', U'₄'}, {'5', U'⁵', U'₅'},
    {'6', U'⁶', U'₆'},  {'7', U'⁷', U'₇'}, {'8', U'⁸', U'₈'}, {'9', U'⁹', U'₉'}, {'+', U'⁺', U'₊'}, {'-', U'⁻', U'₋'},
    {U'−', U'⁻', U'₋'}, {'=', U'⁼', U'₌'}, {'(', U'⁽', U'₍'}, {')', U'⁾', U'₎'}, {'n', U'ⁿ', U'ₙ'}, {'i', U'ⁱ', 0}};

/// "⁻⁹" for "−9"; empty if Unicode lacks any of the characters.
std::string raised(std::string_view text, Script script) {
  std::string out;
  for (const char32_t c : charactersOf(text)) {
    char32_t sign = 0;
    for (const Raised& r : kRaised)
      if (r.on_line == c) sign = script == Script::Super ? r.super : r.sub;
    if (!sign) return {};
    out += utf8Of(sign);
  }
  return out;
}

}  // namespace

bool hasTeacherNotes(const Lesson& lesson) {
  const auto one = [](const std::vector<Block>& blocks) {
    return std::any_of(blocks.begin(), blocks.end(),
                       [](const Block& b) { return std::holds_alternative<TeacherNote>(b); });
  };
  return one(lesson.introduction) ||
         std::any_of(lesson.steps.begin(), lesson.steps.end(), [&](const Step& s) { return one(s.blocks); });
}

std::string plainText(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) {
    const std::string signs = run.script == Script::None ? std::string() : raised(run.text, run.script);
    if (run.script == Script::None || !signs.empty())
      out += signs.empty() ? run.text : signs;
    else
      out += (run.script == Script::Super ? "^" : "_") + run.text;
  }
  return out;
}

std::string bareText(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) out += run.text;
  return out;
}

void forEachText(const std::vector<Block>& blocks, const std::function<void(const RichText&)>& visit) {
  const auto all = [&](const std::vector<RichText>& texts) {
    for (const RichText& t : texts) visit(t);
  };
  for (const Block& b : blocks) {
    if (const auto* p = std::get_if<Paragraph>(&b)) visit(p->text);
    if (const auto* h = std::get_if<Subheading>(&b)) visit(h->text);
    if (const auto* t = std::get_if<Tip>(&b)) all(t->paragraphs);
    if (const auto* n = std::get_if<TeacherNote>(&b)) all(n->paragraphs);
    if (const auto* q = std::get_if<Quote>(&b)) all(q->paragraphs);
    if (const auto* l = std::get_if<ListBlock>(&b))
      for (const ListBlock::Item& i : l->items) visit(i.text);
    if (const auto* t = std::get_if<Table>(&b))
      for (const std::vector<RichText>& row : t->rows) all(row);
  }
}

void forEachText(const Step& step, const std::function<void(const RichText&)>& visit) {
  forEachText(step.blocks, visit);
  for (const Question& q : step.questions) {
    visit(q.title);
    for (const RichText& p : q.prompt) visit(p);
    for (const Choice& c : q.choices) {
      visit(c.text);
      visit(c.feedback);
    }
  }
}

void forEachText(const Lesson& lesson, const std::function<void(const RichText&)>& visit) {
  forEachText(lesson.introduction, visit);
  for (const Step& step : lesson.steps) forEachText(step, visit);
  for (const GlossaryWord& word : lesson.glossary) visit(word.meaning);
}

void forEachImage(const Lesson& lesson, const std::function<void(const Image&)>& visit) {
  const auto in = [&](const std::vector<Block>& blocks) {
    for (const Block& b : blocks)
      if (const auto* image = std::get_if<Image>(&b)) visit(*image);
  };
  in(lesson.introduction);
  for (const Step& step : lesson.steps) in(step.blocks);
}

}  // namespace moltact
