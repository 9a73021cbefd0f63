#include "app/ui/panels/lesson/lesson_ends.h"

#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

void line(const char* name, const std::string& text, ImU32 colour, bool bold = false) {
  drawRichText(name, {TextRun{.text = text, .bold = bold}}, colour);
}

// Each with a mark before it.
void drawGoals(const LessonSession& session, const char* name, Icon mark, ImU32 colour) {
  const Look& l = look();
  for (std::size_t k = 0; k < session.lesson().goals.size(); ++k) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetFontSize();
    if (mark == Icon::None)
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + l.px(8), at.y + 0.52f * size}, l.px(2.5f), colour, 16);
    else
      drawIcon(ImGui::GetWindowDrawList(), mark, {at.x + l.px(8), at.y + 0.55f * size}, 0.8f * size, colour);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + l.px(22));
    line((std::string(name) + "/" + std::to_string(k)).c_str(), session.lesson().goals[k], l.palette.text);
  }
}

struct Done {
  std::size_t tasks = 0, questions = 0, first_right = 0, steps = 0, asides = 0, steps_seen = 0, skipped = 0;
  double touched_s = 0.0, way_A = 0.0;
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
        if (f.name == "way") out.way_A += f.value;
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

// The steps by their titles in the order in which they were met; what was passed over stands where it would have come.
RichText wayOf(const LessonSession& session) {
  const std::vector<Step>& steps = session.lesson().steps;
  std::vector<std::size_t> way = session.met();
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

}  // namespace

void drawLessonGoals(Application& app, const LessonSession& session) {
  if (session.lesson().goals.empty()) return;
  bool open = app.panels.lesson_goals.value_or(false);
  if (disclosure("lesson/goals", tr("What you can do afterwards"), open)) app.panels.lesson_goals = open;
  if (open) drawGoals(session, "lesson/goal", Icon::None, look().palette.accent);
  ImGui::Spacing();
}

void settleLessonGoals(Application& app, const LessonSession& session, float width, float text_height) {
  PanelState& panels = app.panels;
  if (panels.lesson_goals) return;
  const bool begins = session.stepIndex() == 0 && session.met().size() == 1 && session.parts().done == 0;
  float height = 0.0f;
  for (const std::string& goal : session.lesson().goals)
    height += richTextHeight({TextRun{.text = goal}}, width - look().px(22)) + ImGui::GetStyle().ItemSpacing.y;
  const float work = panels.lesson_task_y > 0.0f ? panels.lesson_task_y : panels.lesson_question_y;
  const bool seen = work > 0.0f && work <= panels.lesson_text_end;
  panels.lesson_goals = begins && height <= 0.5f * text_height && (!seen || work + height <= panels.lesson_text_end);
}

void drawLessonEnd(Application& app, const LessonSession& session) {
  if (session.hasNext() || session.step().aside || !session.finished()) return;
  const Look& l = look();
  const Done done = doneIn(session);
  ImGui::Dummy({0, l.px(8)});
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  // The ground goes under text whose height is known only afterwards.
  draw->ChannelsSplit(2);
  draw->ChannelsSetCurrent(1);
  ImGui::SetCursorScreenPos({low.x + pad, low.y + pad});
  ImGui::BeginGroup();
  ImGui::PushItemWidth(width - 2 * pad);
  line("lesson/end", trf("You have finished {0}.", session.lesson().title), l.palette.text, true);
  ImGui::Spacing();
  drawGoals(session, "lesson/end/goal", Icon::Check, l.palette.good);
  ImGui::Spacing();
  if (done.tasks > 0)
    line("lesson/end/tasks", trnf("{0} touch task done.", "{0} touch tasks done.", done.tasks, done.tasks),
         l.palette.text);
  if (done.questions > 0)
    line("lesson/end/questions", trf("{0} of {1} answers right at the first try.", done.first_right, done.questions),
         l.palette.text);
  // Only of what was done since the lesson was taken up: earlier figures are in the attempt's file.
  if (done.touched_s >= 1.0)
    line("lesson/end/felt",
         trf("In the tasks of today you touched for {0}, over {1} of surface.",
             quantityText(done.touched_s, Dimension::Time, decimals(0)),
             quantityText(done.way_A, Dimension::Length, decimals(0))),
         l.palette.text);
  line("lesson/end/way",
       done.asides ? trf("{0} of {1} steps seen, and {2}.", done.steps_seen, done.steps,
                         trnf("{0} side path", "{0} side paths", done.asides, done.asides))
                   : trf("{0} of {1} steps seen.", done.steps_seen, done.steps),
       l.palette.quiet);
  if (session.met().size() > 1) {
    const WithFont small(Font::Small);
    drawRichText("lesson/end/order", wayOf(session), l.palette.quiet, width - 2 * pad);
  }
  if (done.skipped > 0)
    line("lesson/end/skipped",
         trnf("{0} step passed over, by your answers.", "{0} steps passed over, by your answers.", done.skipped,
              done.skipped),
         l.palette.quiet);
  ImGui::PopItemWidth();
  ImGui::EndGroup();
  const float end = ImGui::GetItemRectMax().y + pad;
  draw->ChannelsSetCurrent(0);
  draw->AddRectFilled(low, {low.x + width, end}, l.palette.good_soft, l.px(8));
  draw->ChannelsMerge();
  ImGui::SetCursorScreenPos({low.x, end + l.px(8)});
  if (const LessonCard* next = app.extensions().shelf.after(app.lesson.file())) {
    const LessonCard card = *next;
    if (!card.description.empty()) line("lesson/end/next about", card.description, l.palette.quiet);
    if (button("lesson/end/next", elided(trf("Next lesson: {0}", card.title), width - l.px(28)).c_str(),
               ButtonLook::Primary, width))
      app.extensions().shelf.begin(card);
  } else if (button("lesson/end/more", tr("More lessons"), ButtonLook::Primary, width)) {
    app.panels.welcome = true;
  }
}

}  // namespace moltact
