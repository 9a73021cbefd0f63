// A question of a lesson: choices or a field, and the feedback.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/panels/lesson/lesson_blocks.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

bool holds(const std::vector<std::size_t>& list, std::size_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

// The mark on a choice. It is hidden until the feedback may be shown.
enum class Mark { None, Right, Wrong };

const char* wordOf(Mark verdict) { return verdict == Mark::Right ? tr("right") : tr("wrong"); }

// A tick in a disc for right, a cross in a square for wrong: distinguishable without colour.
void drawVerdict(ImDrawList* draw, Mark verdict, ImVec2 centre, float half) {
  const Palette& p = look().palette;
  if (verdict == Mark::Right)
    draw->AddCircleFilled(centre, half, p.good, 28);
  else
    draw->AddRectFilled({centre.x - half + 1, centre.y - half + 1}, {centre.x + half - 1, centre.y + half - 1}, p.bad,
                        look().px(2));
  drawIcon(draw, verdict == Mark::Right ? Icon::Check : Icon::Close, centre, 1.5f * half, p.panel);
}

// A choice: a card, with an icon and a word once its result is shown. Returns whether it was chosen.
bool drawChoice(const std::string& name, const Choice& choice, bool round, bool ticked, Mark verdict) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(9), mark = l.px(8);
  ImFont* const small = l.font(Font::Small);
  const float word_w =
      verdict == Mark::None ? 0.0f : small->CalcTextSizeA(small->FontSize, 1e9f, 0, wordOf(verdict)).x + l.px(10);
  const float text_w = width - 2 * pad - 2 * mark - l.px(10) - word_w;
  const float height = std::max(richTextHeight(choice.text, text_w), 2 * mark) + 2 * pad;
  ImGui::PushID(name.c_str());
  const bool clicked = ImGui::InvisibleButton("choice", {width, height});
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 ground = verdict == Mark::Right   ? p.good_soft
                       : verdict == Mark::Wrong ? p.bad_soft
                       : ImGui::IsItemHovered() ? p.hovered
                                                : p.raised;
  draw->AddRectFilled(low, high, ground, l.px(7));
  if (l.theme == ThemeChoice::HighContrast) draw->AddRect(low, high, p.line, l.px(7), 0, std::max(1.0f, l.scale));
  const ImVec2 centre{low.x + pad + mark, low.y + pad + mark + l.px(1)};
  const ImU32 colour = verdict == Mark::Right ? p.good : verdict == Mark::Wrong ? p.bad : ticked ? p.accent : p.faint;
  if (verdict != Mark::None) {
    drawVerdict(draw, verdict, centre, mark);
    const ImVec2 at{high.x - pad - word_w + l.px(10), low.y + pad + 0.5f * (ImGui::GetFontSize() - small->FontSize)};
    draw->AddText(small, small->FontSize, at, colour, wordOf(verdict));
    recordRectangle(name + "/verdict", {at.x, at.y}, {high.x - pad, at.y + small->FontSize}, wordOf(verdict));
  } else if (round) {
    draw->AddCircle(centre, mark - 1, colour, 28, l.px(1.6f));
    if (ticked) draw->AddCircleFilled(centre, mark - l.px(4), colour, 28);
  } else {
    const ImVec2 a{centre.x - mark + 1, centre.y - mark + 1}, b{centre.x + mark - 1, centre.y + mark - 1};
    if (ticked) {
      draw->AddRectFilled(a, b, colour, l.px(3));
      drawIcon(draw, Icon::Check, centre, 1.5f * mark, p.panel);
    } else {
      draw->AddRect(a, b, colour, l.px(3), 0, l.px(1.6f));
    }
  }
  paintRichText(draw, {low.x + pad + 2 * mark + l.px(10), low.y + pad}, choice.text, p.text, text_w);
  recordItem(name, plainText(choice.text));
  return clicked;
}

// Whether the question and each of its choices have been in view.
bool wasRead(const Application& app, const Question& question, const std::string& name) {
  bool read = wasSeen(app, name);
  for (std::size_t k = 0; k < question.choices.size(); ++k) read = read && wasSeen(app, name + "/" + std::to_string(k));
  return read;
}

// The number keys belong to the first unanswered question of the step, unless the current task uses them.
bool takesKeys(const LessonSession& session, std::size_t index) {
  if (const Task* task = session.taskAt(session.currentTask())) {
    const std::vector<TaskButton> offered = task->buttons();
    if (std::any_of(offered.begin(), offered.end(), [](const TaskButton& b) { return b.key >= '1' && b.key <= '9'; }))
      return false;
  }
  for (std::size_t k = 0; k < index; ++k)
    if (!session.question(k).done() && !session.step().questions[k].choices.empty()) return false;
  return session.takesAnswer(index);
}

// Enter belongs to the current task if it uses the key.
bool enterIsFree(const LessonSession& session) {
  const Task* task = session.taskAt(session.currentTask());
  if (!task) return true;
  if (task->curves() && task->curves()->drawing) return false;
  const std::vector<TaskButton> offered = task->buttons();
  return std::none_of(offered.begin(), offered.end(), [](const TaskButton& b) { return b.key == '\n'; });
}

// The key that starts writing belongs to the first unanswered question with a field.
bool takesWriting(const LessonSession& session, std::size_t index) {
  for (std::size_t k = 0; k < index; ++k)
    if (!session.question(k).done() && session.step().questions[k].choices.empty()) return false;
  return !session.question(index).done();
}

// `asked_y`: the top of the question.
void drawChoices(Application& app, std::size_t index, const std::string& name, float asked_y) {
  LessonGuide& lesson = app.lesson;
  LessonSession& session = *lesson.session();
  const Question& question = session.step().questions[index];
  const QuestionStatus& status = session.question(index);
  std::vector<std::size_t>& ticked = lesson.drafts().ticked[index];
  const bool one = question.rightChoices() <= 1, keys = takesKeys(session, index),
             verdict = session.feedbackVisible(index), open = session.takesAnswer(index);
  if (ticked.empty() && status.attempts > 0 && status.done()) ticked = status.chosen;
  if (!one)
    drawRichText((name + "/several").c_str(), {TextRun{.text = tr("More than one is right: tick them all.")}},
                 look().palette.quiet);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(6)});
  const std::vector<std::size_t> order = session.choiceOrder(index);
  const bool read = wasRead(app, question, name);
  const auto keyPart = [&](const std::string& part) {
    return KeyPart{part, ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().y, read, asked_y};
  };
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t k = order[place];
    const bool given = status.attempts > 0 && holds(status.chosen, k), right = question.choices[k].right;
    // After the result of a prediction or the last try, the right choices are marked too.
    const bool marked = verdict && (given || ((question.prediction || status.shown) && right));
    const bool is_ticked = one ? given : holds(ticked, k);
    const std::string choice = name + "/" + std::to_string(k);
    const bool clicked = drawChoice(choice, question.choices[k], one, is_ticked,
                                    !marked ? Mark::None
                                    : right ? Mark::Right
                                            : Mark::Wrong);
    const KeyPart part = keyPart(choice);
    noteSeen(app, part);
    const bool by_key = keys && place < 9 && lessonKeyActs(app, char('1' + place), part);
    if (!(clicked || by_key) || !open) continue;
    if (one)
      session.choose(index, {k});
    else if (holds(ticked, k))
      std::erase(ticked, k);
    else
      ticked.push_back(k);
  }
  ImGui::PopStyleVar();
  if (one || !open) return;
  const bool checked = button((name + "/check").c_str(), withKey(tr("Check"), "Enter").c_str(), ButtonLook::Primary,
                              look().tx(132), !ticked.empty());
  const bool entered =
      keys && !ticked.empty() && enterIsFree(session) && lessonKeyActs(app, '\n', keyPart(name + "/check"));
  if (!checked && !entered) return;
  std::sort(ticked.begin(), ticked.end());
  session.choose(index, ticked);
}

void drawField(Application& app, std::size_t index, const std::string& name, float asked_y) {
  LessonGuide& lesson = app.lesson;
  LessonSession& session = *lesson.session();
  const Question& question = session.step().questions[index];
  const AnswerSpec& answer = *question.answer;
  const QuestionStatus& status = session.question(index);
  std::string& written = lesson.drafts().written[index];
  if (written.empty() && status.attempts > 0) written = status.written;
  const bool free = question.free();
  const float button_w = look().tx(84), gap = ImGui::GetStyle().ItemSpacing.x;
  bool handed_in = false;
  const auto begins = [&] {
    const KeyPart field{name + "/field", ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().y, wasSeen(app, name),
                        asked_y};
    return takesWriting(session, index) && lessonKeyActs(app, 'A', field);
  };
  if (free) {
    handed_in = inputWrapped("##answer", written, {-1, look().tx(84)}, ImGuiInputTextFlags_EnterReturnsTrue);
    recordItem(name + "/field", written);
    if (begins()) writeInLastField("##answer");
    tip(tr("A begins to write, Ctrl and Enter keeps it"));
    handed_in = button((name + "/check").c_str(), tr("Keep"), ButtonLook::Plain, button_w) || handed_in;
  } else {
    const float unit_w = answer.unit.empty() ? 0.0f : ImGui::CalcTextSize(answer.unit.c_str()).x + gap;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - unit_w - button_w - gap);
    const std::string what = tr("your answer");
    const std::string hint = status.done() ? what : withKey(what, "A");
    std::optional<FieldAsHighAsButton> high(std::in_place);
    const std::string before = written;
    handed_in = ImGui::InputTextWithHint("##answer", hint.c_str(), &written, ImGuiInputTextFlags_EnterReturnsTrue);
    keepOnEscape(written, before);
    recordItem(name + "/field", written);
    if (begins()) writeInLastField("##answer");
    if (!answer.unit.empty()) {
      // The unit is beside the field, so that a number without a unit is understood.
      ImGui::SameLine();
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(answer.unit.c_str());
    }
    high.reset();
    ImGui::SameLine();
    handed_in = button((name + "/check").c_str(), tr("Check"), ButtonLook::Primary, button_w) || handed_in;
  }
  if (handed_in)
    session.write(index, answer.kind == AnswerSpec::Kind::Number ? numberAsTyped(written) : unbrokenLines(written));
}

// The feedback to an answer and its colour. Until the result may be shown, it says only that the answer is stored.
struct Said {
  std::vector<RichText> lines;
  ImU32 colour;
  Mark verdict = Mark::None;
  bool own_words = false;  // the program's sentence, because the author wrote none
};

Said saidTo(const LessonSession& session, std::size_t index) {
  const Palette& p = look().palette;
  const QuestionStatus& status = session.question(index);
  const Question& question = session.step().questions[index];
  const auto line = [](std::string text) { return RichText{TextRun{.text = std::move(text)}}; };
  if (!status.again.empty()) return {{line(status.again)}, p.text};
  if (status.attempts == 0) return {{}, p.text};
  if (session.lesson().test) return {{line(tr("Kept. You can still change it."))}, p.text};
  if (!session.feedbackVisible(index)) return {{line(tr("Kept. Now touch, and see whether it is so."))}, p.text};
  Said out{session.feedback(index), status.last_right ? p.good : p.bad, status.last_right ? Mark::Right : Mark::Wrong};
  if (question.free()) {
    out.colour = p.text;
    out.verdict = Mark::None;
    out.lines.insert(out.lines.begin(),
                     line(out.lines.empty() ? tr("Kept with your results.")
                                            : tr("Kept with your results. Compare it with this answer:")));
  } else if (out.lines.empty()) {
    out.own_words = true;
    out.lines.push_back(line(status.last_right     ? tr("Right.")
                             : question.prediction ? tr("It is otherwise.")
                                                   : tr("Not yet. Try again.")));
  }
  return out;
}

// The verdict on an answer in a field, which has no card: the icon, and the word if the author wrote the feedback. The
// author's feedback follows in the next line; the program's sentence is beside the icon.
void drawFieldVerdict(const std::string& name, const Said& said) {
  const Look& l = look();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float half = l.px(8), height = std::max(2 * half, ImGui::GetTextLineHeight());
  drawVerdict(ImGui::GetWindowDrawList(), said.verdict, {low.x + half, low.y + 0.5f * height}, half);
  ImGui::Dummy({2 * half, height});
  recordItem(name + "/verdict", wordOf(said.verdict));
  ImGui::SameLine();
  if (said.own_words) return;
  WithText colour(said.colour);
  ImGui::TextUnformatted(wordOf(said.verdict));
}

// The step to which the answer leads; Next leads there too.
void drawGoOn(Application& app, std::size_t index, const std::string& name) {
  const LessonSession& session = *app.lesson.session();
  const auto to = session.leadsTo(index);
  if (!to || session.leadsTo() != to) return;
  const float width = ImGui::GetContentRegionAvail().x;
  if (button((name + "/go on").c_str(),
             elided(trf("Go on: {0}", session.lesson().steps[*to].title), width - look().px(28)).c_str(),
             ButtonLook::Primary, width))
    app.lesson.next();
}

}  // namespace

std::string drawLessonQuestion(Application& app, std::size_t index) {
  LessonSession& session = *app.lesson.session();
  if (index >= session.step().questions.size()) return {};
  const Look& l = look();
  const std::string name = "question/" + std::to_string(index);
  std::string link;
  const auto follow = [&](std::string clicked) {
    if (!clicked.empty()) link = std::move(clicked);
  };
  const Question& question = session.step().questions[index];
  if (session.question(index).attempts == 0) app.panels.lesson_memory.question_y = ImGui::GetCursorScreenPos().y;
  ImGui::PushID(int(index));
  ImGui::Dummy({0, l.px(2)});
  if (question.prediction)
    drawRichText((name + "/before").c_str(), {TextRun{.text = tr("Before you touch, predict:")}}, l.palette.quiet);
  RichText title = question.title;
  for (TextRun& run : title) run.bold = true;
  const float asked_y = ImGui::GetCursorScreenPos().y;
  if (const auto& wanted = app.panels.lesson_memory.wanted; wanted && !wanted->task && wanted->index == index) {
    ImGui::SetScrollHereY(0.2f);
    app.panels.lesson_memory.wanted.reset();
  }
  follow(drawRichText(name.c_str(), title, l.palette.text));
  for (const RichText& p : question.prompt) follow(drawRichText((name + "/prompt").c_str(), p, l.palette.text));
  noteSeen(app, {name, asked_y, ImGui::GetCursorScreenPos().y});
  if (const auto tries = session.triesLeft(index); tries && session.question(index).attempts == 0)
    drawRichText(
        (name + "/tries").c_str(),
        {TextRun{.text = trnf("You have {0} try.", "You have {0} tries.", static_cast<std::size_t>(*tries), *tries)}},
        l.palette.quiet);
  const int attempts = session.question(index).attempts;
  const bool asked_again = !session.question(index).again.empty();
  if (question.choices.empty() && question.answer)
    drawField(app, index, name, asked_y);
  else
    drawChoices(app, index, name, asked_y);
  const QuestionStatus& status = session.question(index);
  const Said said = saidTo(session, index);
  if (!said.lines.empty()) {
    const float said_y = ImGui::GetCursorScreenPos().y;
    if (said.verdict != Mark::None && question.choices.empty()) drawFieldVerdict(name, said);
    for (std::size_t k = 0; k < said.lines.size(); ++k) {
      const ImVec2 from = ImGui::GetCursorScreenPos();
      follow(drawRichText((name + "/feedback").c_str(), said.lines[k], said.colour));
      recordRectangle(name + "/feedback/" + std::to_string(k), {from.x, from.y},
                      {from.x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y},
                      plainText(said.lines[k]));
    }
    if (session.feedbackVisible(index))
      for (const std::size_t k : status.chosen)
        if (!question.choices[k].link.empty() &&
            lessonKeyActs(app, 'G', {name + "/feedback", said_y, ImGui::GetCursorScreenPos().y}))
          link = question.choices[k].link;
    drawGoOn(app, index, name);
    // Scrolls so that the feedback is not below the panel's edge.
    if ((status.attempts != attempts || asked_again == status.again.empty()) &&
        ImGui::GetCursorScreenPos().y > ImGui::GetWindowPos().y + ImGui::GetWindowHeight())
      ImGui::SetScrollHereY(1.0f);
  }
  ImGui::PopID();
  return link;
}

}  // namespace moltact
