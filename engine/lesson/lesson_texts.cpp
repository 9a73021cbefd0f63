#include "engine/lesson/lesson_texts.h"

namespace moltact {

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
