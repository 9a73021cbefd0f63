// The closing page of a lesson, at any progress.
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/learner_known.h"
#include "app/ui/panels/lesson/lesson_ends.h"
#include "app/ui/panels/lesson/lesson_extras.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxItems = 10;  // if more items are open, steps are listed instead

void line(const std::string& name, const std::string& text, ImU32 colour, bool bold = false) {
  drawRichText(name.c_str(), {TextRun{.text = text, .bold = bold}}, colour);
}

/// A task or question of a step.
struct Item {
  std::size_t step = 0, index = 0;
  bool task = false;
};

/// The tasks and questions that count for the lesson: in steps of the core, in the order of the text.
std::vector<Item> itemsOf(const LessonSession& session) {
  std::vector<Item> out;
  const std::vector<Step>& steps = session.lesson().steps;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (steps[s].aside || session.skipped(s)) continue;
    for (const Block& block : steps[s].blocks)
      if (const auto* task = std::get_if<TaskHere>(&block))
        out.push_back({s, task->index, true});
      else if (const auto* question = std::get_if<QuestionHere>(&block))
        out.push_back({s, question->index, false});
  }
  return out;
}

bool isDone(const LessonSession& session, const Item& item) {
  return item.task ? session.taskDone(item.step, item.index) : session.question(item.step, item.index).done();
}

const std::vector<std::size_t>& goalsOf(const LessonSession& session, const Item& item) {
  const Step& step = session.lesson().steps[item.step];
  return item.task ? step.tasks[item.index].goals : step.questions[item.index].goals;
}

/// Draws an icon in place of a list's bullet; the text follows beside it.
void mark(Icon icon, ImU32 colour) {
  const Look& l = look();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 centre{at.x + l.px(8), at.y + 0.55f * size};
  if (icon == Icon::None)
    draw->AddCircle(centre, 0.34f * size, colour, 24, l.px(1.5f));
  else
    drawIcon(draw, icon, centre, 0.8f * size, colour);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + l.px(24));
}

/// A goal is reached once all tasks and questions that serve it are done. A goal that none serves is reached with the
/// lesson.
void drawGoals(const LessonSession& session, const std::vector<Item>& items) {
  if (session.lesson().goals.empty()) return;
  sectionTitle(session.finished() ? tr("What you can do now") : tr("What the lesson is for"));
  for (std::size_t goal = 0; goal < session.lesson().goals.size(); ++goal) {
    std::size_t serving = 0, done = 0;
    for (const Item& item : items) {
      const std::vector<std::size_t>& goals = goalsOf(session, item);
      if (std::find(goals.begin(), goals.end(), goal) == goals.end()) continue;
      ++serving;
      done += isDone(session, item);
    }
    const bool reached = serving > 0 ? done == serving : session.finished();
    const Palette& p = look().palette;
    const std::string name = "lesson/end/goal/" + std::to_string(goal);
    mark(reached ? Icon::Check : Icon::None, reached ? p.good : p.quiet);
    line(name, session.lesson().goals[goal], p.text);
    if (reached || serving == 0) continue;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + look().px(24));
    const WithFont small(Font::Small);
    line(name + "/part", trf("{0} of {1} done", done, serving), p.quiet);
  }
  ImGui::Spacing();
}

/// A card with an icon, a text and an arrow; its width fits the text. Returns whether it was clicked.
bool leadingCard(const std::string& name, const std::string& text, const std::string& below) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(10), text_w = width - 2 * pad - l.px(22);
  const std::string lines = wrapped(text, text_w);
  ImFont* small = l.font(Font::Small);
  const float text_h = ImGui::CalcTextSize(lines.c_str()).y, below_h = below.empty() ? 0.0f : small->FontSize + l.px(2);
  ImGui::PushID(name.c_str());
  const bool clicked = ImGui::InvisibleButton("lead", {width, text_h + below_h + 2 * pad});
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, ImGui::IsItemHovered() ? p.hovered : p.raised, l.px(7));
  if (l.theme == ThemeChoice::HighContrast) draw->AddRect(low, high, p.line, l.px(7), 0, std::max(1.0f, l.scale));
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!below.empty())
    draw->AddText(small, small->FontSize, {low.x + pad, low.y + pad}, p.quiet, elided(below, text_w).c_str());
  draw->AddText({low.x + pad, low.y + pad + below_h}, p.text, lines.c_str());
  drawIcon(draw, Icon::ChevronRight, {high.x - pad - l.px(5), 0.5f * (low.y + high.y)}, l.px(12), p.quiet);
  recordItem(name, text);
  return clicked;
}

std::string wordsOf(const LessonSession& session, const Item& item) {
  const Step& step = session.lesson().steps[item.step];
  return item.task ? step.tasks[item.index].values["say"].text : plainText(step.questions[item.index].title);
}

void goTo(Application& app, const Item& item) {
  app.lesson.follow('#' + app.lesson.session()->lesson().steps[item.step].id);
  app.panels.lesson_memory.wanted = {item.task, item.index};
}

/// Draws a card for each open item, or for each step if there are many. Returns whether one was clicked.
bool drawLeft(Application& app, const LessonSession& session, const std::vector<Item>& items) {
  std::vector<Item> left;
  for (const Item& item : items)
    if (!isDone(session, item)) left.push_back(item);
  if (left.empty()) return false;
  sectionTitle(tr("What is left"));
  const bool by_steps = left.size() > kMaxItems;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Item& item = left[k];
    if (by_steps && k > 0 && left[k - 1].step == item.step) continue;
    const std::string title = session.lesson().steps[item.step].title;
    const std::string place = trf("Step {0}: {1}", session.numberOf(item.step), title);
    const auto of_step = std::size_t(
        std::count_if(left.begin(), left.end(), [&](const Item& other) { return other.step == item.step; }));
    const std::string name = "lesson/end/left/" + std::to_string(k);
    if (by_steps ? leadingCard(name, place, trnf("{0} to do", "{0} to do", of_step, of_step))
                 : leadingCard(name, wordsOf(session, item), place)) {
      goTo(app, item);
      return true;
    }
  }
  ImGui::Spacing();
  return false;
}

std::string givenTo(const Question& asked, const QuestionStatus& status) {
  std::string out = status.written;
  for (const std::size_t k : status.chosen)
    if (k < asked.choices.size()) out += (out.empty() ? "" : "; ") + plainText(asked.choices[k].text);
  return out;
}

/// The predictions whose results are known, beside what was felt.
void drawPredictions(const LessonSession& session) {
  const Palette& p = look().palette;
  const std::vector<Step>& steps = session.lesson().steps;
  bool any = false;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    bool felt = session.stepSeen(s);
    for (std::size_t k = 0; k < steps[s].tasks.size(); ++k) felt = felt && session.taskDone(s, k);
    for (std::size_t q = 0; felt && q < steps[s].questions.size(); ++q) {
      const Question& asked = steps[s].questions[q];
      const QuestionStatus& status = session.question(s, q);
      if (!asked.prediction || status.attempts == 0) continue;
      if (!any) sectionTitle(tr("What you expected, and what you felt"));
      any = true;
      const std::string name = "lesson/end/prediction/" + std::to_string(s) + "/" + std::to_string(q);
      RichText title = asked.title;
      for (TextRun& run : title) run.bold = true;
      drawRichText(name.c_str(), title, p.text);
      const std::string right = rightAnswer(asked);
      if (status.last_right) {
        mark(Icon::Check, p.good);
        line(name + "/as expected", trf("You expected it, and felt it: {0}", givenTo(asked, status)), p.text);
        continue;
      }
      mark(Icon::Close, p.bad);
      line(name + "/expected", trf("You expected: {0}", givenTo(asked, status)), p.text);
      if (right.empty()) continue;
      mark(Icon::ChevronRight, p.quiet);
      line(name + "/felt", trf("You felt: {0}", right), p.text);
    }
  }
  if (any) ImGui::Spacing();
}

struct Done {
  std::size_t tasks = 0, questions = 0, first_right = 0, steps = 0, asides = 0, steps_seen = 0, skipped = 0;
  double touched_s = 0.0, path_A = 0.0;
};

Done doneIn(const LessonSession& session) {
  Done out;
  const std::vector<Step>& steps = session.lesson().steps;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    out.skipped += session.skipped(s) && !session.stepSeen(s);
    out.steps += !steps[s].aside && (!session.skipped(s) || session.stepSeen(s));
    (steps[s].aside ? out.asides : out.steps_seen) += session.stepSeen(s);
    for (std::size_t t = 0; t < steps[s].tasks.size(); ++t) {
      out.tasks += session.taskSolved(s, t);
      for (const TaskFigure& f : session.figuresOf(s, t)) {
        if (f.name == "contact time") out.touched_s += f.value;
        if (f.name == "way") out.path_A += f.value;
      }
    }
    for (std::size_t q = 0; q < steps[s].questions.size(); ++q) {
      if (steps[s].questions[q].free() || steps[s].questions[q].prediction) continue;
      const QuestionStatus& status = session.question(s, q);
      out.questions += status.attempts > 0;
      out.first_right += status.answered_right && status.attempts == 1;
    }
  }
  return out;
}

// The titles of the steps in the order of the visits. A skipped step is listed at its regular position.
RichText wayOf(const LessonSession& session) {
  const std::vector<Step>& steps = session.lesson().steps;
  std::vector<std::size_t> way = session.visitedSteps();
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (!session.skipped(s) || session.stepSeen(s)) continue;
    auto place = way.begin();
    for (auto at = way.begin(); at != way.end(); ++at)
      if (!steps[*at].aside && *at < s) place = std::next(at);
    while (place != way.end() && steps[*place].aside) ++place;
    way.insert(place, s);
  }
  RichText out;
  for (const std::size_t s : way) {
    if (!out.empty()) out.push_back({.text = " → "});
    if (!session.stepSeen(s))
      out.push_back({.text = trf("(passed over: {0})", steps[s].title), .italic = true});
    else if (steps[s].aside)
      out.push_back({.text = trf("side path: {0}", steps[s].title), .italic = true});
    else
      out.push_back({.text = steps[s].title});
  }
  return out;
}

/// Figures of the work and the touch.
void drawFigures(const LessonSession& session) {
  const Palette& p = look().palette;
  const Done done = doneIn(session);
  sectionTitle(tr("Your way"));
  if (done.tasks > 0)
    line("lesson/end/tasks", trnf("{0} touch task done.", "{0} touch tasks done.", done.tasks, done.tasks), p.text);
  if (done.questions > 0)
    line("lesson/end/questions", trf("{0} of {1} answers right at the first try.", done.first_right, done.questions),
         p.text);
  // Only figures since the lesson was resumed; earlier ones are in the attempt's file.
  if (done.touched_s >= 1.0)
    line("lesson/end/felt",
         trf("In the tasks of today you touched for {0}, over {1} of surface.",
             quantityText(done.touched_s, Dimension::Time, decimals(0)),
             quantityText(done.path_A, Dimension::Length, decimals(0))),
         p.text);
  line("lesson/end/way",
       done.asides ? trf("{0} of {1} steps seen, and {2}.", done.steps_seen, done.steps,
                         trnf("{0} side path", "{0} side paths", done.asides, done.asides))
                   : trf("{0} of {1} steps seen.", done.steps_seen, done.steps),
       p.quiet);
  if (session.visitedSteps().size() > 1) {
    const WithFont small(Font::Small);
    drawRichText("lesson/end/order", wayOf(session), p.quiet);
  }
  if (done.skipped > 0)
    line("lesson/end/skipped",
         trnf("{0} step passed over, by your answers.", "{0} steps passed over, by your answers.", done.skipped,
              done.skipped),
         p.quiet);
}

/// Whether everything is done, on a background of its own.
void drawVerdict(const LessonSession& session) {
  const Look& l = look();
  const LessonSession::Parts parts = session.parts();
  const bool finished = session.finished();
  const std::string text =
      finished ? trf("You have finished {0}.", session.lesson().title)
      : parts.done == 0
          ? tr("Nothing of this lesson is done yet. It keeps: begin with any of what is left, now or another day.")
          : trf("{0} of {1} tasks and questions are done. The rest keeps: do it now or another day.", parts.done,
                parts.of);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12), icon = finished ? l.px(28) : 0.0f;
  const RichText words{TextRun{.text = text, .bold = finished}};
  const float height = richTextHeight(words, width - 2 * pad - icon) + 2 * pad;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, {low.x + width, low.y + height}, finished ? l.palette.good_soft : l.palette.accent_soft,
                      l.px(8));
  if (finished) drawIcon(draw, Icon::Check, {low.x + pad + l.px(8), low.y + 0.5f * height}, l.px(20), l.palette.good);
  paintRichText(draw, {low.x + pad + icon, low.y + pad}, words, l.palette.text, width - 2 * pad - icon);
  ImGui::Dummy({width, height});
  recordItem("lesson/end", text);
  ImGui::Spacing();
}

}  // namespace

std::string drawLessonClosing(Application& app, const LessonSession& session) {
  const Look& l = look();
  const float width = ImGui::GetContentRegionAvail().x;
  {
    const WithFont small(Font::Small);
    const WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(elided(session.lesson().title, width).c_str());
    recordItem("lesson/title", session.lesson().title);
  }
  const LessonSession::Parts parts = session.parts();
  progressBar("lesson/end/progress", parts.of ? float(parts.done) / float(parts.of) : 1.0f, session.finished());
  {
    const WithFont heading(Font::Heading);
    ImGui::TextUnformatted(tr("The end of the lesson"));
    recordItem("lesson/step", tr("The end of the lesson"));
  }
  ImGui::Spacing();
  drawVerdict(session);
  const std::vector<Item> items = itemsOf(session);
  // The click has opened another step.
  if (drawLeft(app, session, items)) return {};
  // A test tells nobody how it went.
  if (session.lesson().test) return {};
  drawGoals(session, items);
  drawPredictions(session);
  const std::string link = drawExtrasLeft(session);
  drawFigures(session);
  return link;
}

void drawClosingFoot(Application& app) {
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x,
              back_w = std::min(look().tx(96), 0.4f * width), next_w = width - back_w - gap;
  if (button("lesson/back", tr("Back"), ButtonLook::Plain, back_w)) app.lesson.back();
  ImGui::SameLine();
  if (const auto leave = platformReturn()) {
    if (button("lesson/end/platform", elided(tr("Back to the platform"), next_w - look().px(28)).c_str(),
               ButtonLook::Primary, next_w))
      leave();
  } else if (const LessonCard* next = app.extensions().lesson_list.after(app.lesson.file())) {
    const LessonCard card = *next;
    const bool go =
        button("lesson/end/next", elided(trf("Next lesson: {0}", card.title), next_w - look().px(28)).c_str(),
               ButtonLook::Primary, next_w);
    tip(card.description.c_str());
    if (go) app.extensions().lesson_list.begin(card);
  } else if (button("lesson/end/more", tr("More lessons"), ButtonLook::Primary, next_w)) {
    app.panels.pages.welcome = true;
  }
}

}  // namespace moltact
