// The left panel: the lesson's step with text, tasks and questions; Back and Next below.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "app/ui/panels/lesson/lesson_blocks.h"
#include "app/ui/panels/lesson/lesson_ends.h"
#include "app/ui/panels/lesson/lesson_extras.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/scene_link.h"

namespace moltact {
namespace {

void drawHead(Application& app, const LessonSession& session) {
  const Look& l = look();
  // Asides are outside the core: they do not count and have no bar.
  const std::vector<std::size_t> way = session.route();
  const std::size_t at = session.mainStepIndex(), count = way.size();
  {
    WithFont small(Font::Small);
    WithText quiet(l.palette.quiet);
    const std::string place = session.step().extra   ? std::string(tr("Extra step"))
                              : session.step().aside ? std::string(tr("Aside"))
                                                     : trf("Step {0} of {1}", session.numberOf(at), count);
    const float place_w = ImGui::CalcTextSize(place.c_str()).x, width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(elided(session.lesson().title, width - place_w - l.px(12)).c_str());
    recordItem("lesson/title", session.lesson().title);
    ImGui::SameLine(ImGui::GetCursorStartPos().x + width - place_w);
    ImGui::TextUnformatted(place.c_str());
    recordItem("lesson/place", place);
  }
  // A bar per step: done, current or open.
  const float width = ImGui::GetContentRegionAvail().x, gap = l.px(3), high = l.px(4);
  const float each = (width - gap * float(count - 1)) / float(count);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  for (std::size_t k = 0; k < count; ++k) {
    const float x = low.x + (each + gap) * float(k);
    const std::size_t step = way[k];
    const ImU32 colour = step == at                            ? l.palette.accent
                         : session.stepDone(step) && step < at ? faded(l.palette.accent, 0.45f)
                                                               : l.palette.pressed;
    ImGui::GetWindowDrawList()->AddRectFilled({x, low.y}, {x + std::max(1.0f, each), low.y + high}, colour,
                                              0.5f * high);
  }
  ImGui::Dummy({width, high + l.px(6)});
  WithFont heading(Font::Heading);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(session.step().title.c_str());
  ImGui::PopTextWrapPos();
  recordItem("lesson/step", session.step().title);
  (void)app;
}

void drawFoot(Application& app, const LessonSession& session) {
  const Look& l = look();
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  if (session.step().aside && !session.leadsTo()) {
    if (button("lesson/next", tr("Back to the lesson"), ButtonLook::Primary, width)) app.lesson.next();
    return;
  }
  const float back_w = std::min(l.tx(96), 0.4f * width);
  if (button("lesson/back", tr("Back"), ButtonLook::Plain, back_w, session.hasBack())) app.lesson.back();
  ImGui::SameLine();
  const bool last = app.lesson.atLastStep(), waits = !last && !session.mayGoOn();
  const bool held = waits && session.heldByClass();
  const char* label = held    ? tr("Your class waits here")
                      : waits ? tr("Finish this step first")
                      : last  ? tr("To the end")
                              : tr("Next");
  const ButtonLook kind = session.stepDone() || session.leadsTo() ? ButtonLook::Primary : ButtonLook::Plain;
  if (button("lesson/next", label, waits ? ButtonLook::Plain : kind, width - back_w - gap, !waits)) app.lesson.next();
}

/// Follows a link that changes the scene. Ignored in the dark.
void followInScene(Application& app, const SceneLink& link) {
  const SceneSpec& scene = app.lesson.session()->scene();
  if (!app.lesson.onStage() || app.extensions().task_stager.dark()) return;
  switch (link.kind) {
    case SceneLink::Kind::View:
      if (const NamedView* view = findView(scene, link.of)) app.showView(view->view);
      break;
    case SceneLink::Kind::Zoom:
      if (const auto atoms = parseSelection(link.of)) app.zoomTo(atoms->select(*app.scene.stage().molecule));
      break;
    case SceneLink::Kind::State:
      if (const auto share = stateNamed(scene, link.of)) app.extensions().movers.get<MovingStates>().goTo(*share);
      break;
  }
}

std::size_t hintsIn(const std::vector<Block>& blocks) {
  return std::size_t(
      std::count_if(blocks.begin(), blocks.end(), [](const Block& b) { return std::holds_alternative<Tip>(b); }));
}

/// The text of the strip below the panel while some content is below its edge. The current task has priority.
struct Below {
  std::string text;
  bool task = false, asks = false;
};

Below standsBelow(const Application& app, const LessonSession& session, float shown_to) {
  const PanelState& panels = app.panels;
  for (std::size_t k = 0; k < session.step().tasks.size(); ++k) {
    const TaskStatus status = session.task(k);
    if (status.current && panels.lesson_memory.task == k && panels.lesson_memory.task_y > shown_to)
      return {status.say, true, true};
  }
  for (std::size_t q = 0; q < session.step().questions.size(); ++q)
    if (session.question(q).attempts == 0 && panels.lesson_memory.question_y > shown_to)
      return {tr("A question stands below"), false, true};
  return {tr("More below"), false, false};
}

/// Wraps its text to at most three lines of this width.
std::string linesBelow(const Below& below, float wide) {
  const Look& l = look();
  const WithFont small(Font::Small);
  std::string lines = wrapped(below.text, wide - l.px(56));
  std::size_t end = lines.find('\n');
  for (int k = 0; k < 2 && end != std::string::npos; ++k) end = lines.find('\n', end + 1);
  return end == std::string::npos ? lines : lines.substr(0, end) + " …";
}

float heightBelow(const std::string& lines) {
  const WithFont small(Font::Small);
  return ImGui::CalcTextSize(lines.c_str()).y + look().px(12);
}

/// Draws the strip that announces content below the panel's edge; a click scrolls by a page.
void drawMoreBelow(Application& app, const Below& below, const std::string& lines, const Rectangle& text_shown) {
  const Look& l = look();
  const WithFont small(Font::Small);
  const ImVec2 size = ImGui::CalcTextSize(lines.c_str());
  const float room = text_shown.high.x - text_shown.low.x, left = l.px(below.task ? 32 : 12);
  const float high = size.y + l.px(8), wide = below.task ? room : size.x + left + l.px(28),
              x = 0.5f * (text_shown.low.x + text_shown.high.x - wide), y = text_shown.high.y + l.px(2);
  ImGui::SetCursorScreenPos({x, y});
  if (ImGui::InvisibleButton("more below", {wide, high}))
    app.panels.lesson_memory.scroll = 0.7f * (text_shown.high.y - text_shown.low.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float round = below.task ? l.px(8) : 0.5f * high;
  draw->AddRectFilled({x, y}, {x + wide, y + high}, below.asks ? l.palette.accent_soft : l.palette.raised, round);
  if (below.task)
    draw->AddCircle({x + l.px(17), y + 0.5f * high}, l.px(7), l.palette.accent, 24, l.px(2));
  else
    draw->AddRect({x, y}, {x + wide, y + high}, l.palette.line, round);
  draw->AddText({x + left, y + l.px(4)}, l.palette.text, lines.c_str());
  drawIcon(draw, Icon::ChevronDown, {x + wide - l.px(14), y + 0.5f * high}, l.px(12), l.palette.text);
  recordRectangle("lesson/more", {x, y}, {x + wide, y + high}, below.text);
}

/// Draws the step's head, text, tasks and questions. Returns the link that was clicked, or an empty text.
std::string drawStep(Application& app, LessonSession& session) {
  const bool first = session.stepIndex() == 0;
  const std::size_t introduced = first ? hintsIn(session.lesson().introduction) : 0;
  const std::size_t hints = introduced + hintsIn(session.step().blocks);
  // Opens the hints one by one; after the last one, closes all.
  if (lessonKeyPressed('H')) session.openHints(session.hintsOpen() < hints ? session.hintsOpen() + 1 : 0);
  drawHead(app, session);
  ImGui::Spacing();
  std::string link;
  noteDone(app);
  app.panels.lesson_memory.question_y = app.panels.lesson_memory.task_y = 0.0f;
  if (first) drawLessonGoals(app, session);
  if (first) link = drawLessonBlocks(app, session.lesson().introduction, "lesson/intro", 0);
  if (const std::string other = drawLessonBlocks(app, session.step().blocks, "lesson", introduced); !other.empty())
    link = other;
  noteDone(app);
  if (const std::string extra = drawExtrasOffered(session); !extra.empty()) link = extra;
  return link;
}

/// Follows a link that leads to no step: to another lesson, or out of the program.
void followOut(Application& app, const std::string& link) {
  const std::optional<FileLink> file = fileLink(app.lesson.file(), link);
  if (!file || file->file.extension() != ".md") {
    app.messages.notice(trf("This link leads out of the lesson: {0}", link));
    return;
  }
  app.open(file->file);
  if (!file->step.empty()) app.lesson.follow('#' + file->step);
}

}  // namespace

void drawLessonPanel(Application& app) {
  LessonSession* session = app.lesson.session();
  if (!session ||
      !beginPanel("lesson", app.layout().lesson, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse))
    return;
  const Look& l = look();
  const float foot = l.tx(34) + l.px(12);
  const std::size_t before = session->stepIndex();
  const bool more_below = app.panels.lesson_memory.more_below;
  const bool closing = app.lesson.closing();
  // From the positions of the last frame.
  const Below below =
      closing ? Below{.text = tr("More below")} : standsBelow(app, *session, app.panels.lesson_memory.text_end);
  const std::string below_lines = linesBelow(below, ImGui::GetContentRegionAvail().x);
  const float below_height = more_below ? heightBelow(below_lines) : 0.0f;
  ImGui::BeginChild("text", {0, -foot - below_height});
  if (app.panels.lesson_memory.step != before || app.panels.lesson_memory.closed != closing) {
    ImGui::SetScrollY(0.0f);
    app.panels.lesson_memory.task = 0;
    app.panels.lesson_memory.task_height = 0.0f;
    app.panels.lesson_memory.word = {};
    app.panels.lesson_memory.seen.clear();
  }
  app.panels.lesson_memory.step = before;
  app.panels.lesson_memory.closed = closing;
  scrollByKeys();
  if (app.panels.lesson_memory.scroll != 0.0f)
    ImGui::SetScrollY(ImGui::GetScrollY() + std::exchange(app.panels.lesson_memory.scroll, 0.0f));
  const std::string link = closing ? drawLessonClosing(app, *session) : drawStep(app, *session);
  ImGui::Dummy({0, l.px(10)});
  const float hidden = ImGui::GetScrollMaxY() - ImGui::GetScrollY(), text_width = ImGui::GetContentRegionAvail().x;
  const ImVec2 text_low = ImGui::GetWindowPos(), text_size = ImGui::GetWindowSize();
  ImGui::EndChild();
  const ImVec2 foot_at = ImGui::GetCursorScreenPos();
  if (more_below) {
    drawMoreBelow(app, below, below_lines,
                  {{text_low.x, text_low.y}, {text_low.x + text_size.x, text_low.y + text_size.y}});
    ImGui::SetCursorScreenPos({foot_at.x, foot_at.y + below_height});
  }
  app.panels.lesson_memory.more_below = hidden >= l.px(24);
  app.panels.lesson_memory.text_end = text_low.y + text_size.y;
  settleLessonGoals(app, *session, text_width, text_size.y);
  const float edge = ImGui::GetCursorScreenPos().y - l.px(3);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRectFullScreen();
  draw->AddLine({app.layout().lesson.low.x, edge}, {app.layout().lesson.high.x, edge}, l.palette.line,
                std::max(1.0f, l.scale));
  draw->PopClipRect();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + l.px(4));
  if (closing)
    drawClosingFoot(app);
  else
    drawFoot(app, *session);
  endPanel();
  // Last, because it may open another lesson.
  if (link.empty()) return;
  if (const auto in_scene = sceneLink(link))
    followInScene(app, *in_scene);
  else if (!session->mayGoTo(link))
    app.messages.notice(tr("Finish this step first: its tasks and questions come before what the link leads to."));
  else if (!app.lesson.follow(link))
    followOut(app, link);
}

}  // namespace moltact
