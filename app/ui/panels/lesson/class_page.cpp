// Lesson > Teach this lesson to a class: begins a live class (docs/live-class.md) and shows the teacher who is where.
#include "app/ui/panels/lesson/class_page.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/classroom/taught_class.h"
#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

// The page, and the class, which goes on while the page is closed. The class ends with the program.
struct ClassDesk {
  bool open = false, share = true;
  std::filesystem::path lesson;  // in the window when the class began, or would begin
  std::string title;
  std::unique_ptr<TaughtClass> taught;
  ClassView view;
  std::chrono::steady_clock::time_point looked{};
  bool sure = false;  // asks whether to end the class
  std::string said;   // why something is not there
};

ClassDesk& classDesk() {
  static ClassDesk desk;
  return desk;
}

// The class, for an act that the next frame shows.
TaughtClass& acted(ClassDesk& desk) {
  desk.looked = {};
  return *desk.taught;
}

void words(const char* name, const std::string& text, ImU32 colour) {
  const WithText coloured(colour);
  ImGui::TextWrapped("%s", text.c_str());
  recordItem(name, text);
}

// Dark on light, whatever the theme is, with the quiet zone of four modules.
void drawQr(const QrCode& code, float side) {
  constexpr std::size_t kQuiet = 4;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float module = side / float(code.width + 2 * kQuiet);
  draw->AddRectFilled(low, {low.x + side, low.y + side}, IM_COL32_WHITE, look().px(6));
  const auto edge = [&](float from, std::size_t k) { return std::round(from + module * float(k + kQuiet)); };
  for (std::size_t row = 0; row < code.width; ++row)
    for (std::size_t column = 0; column < code.width; ++column)
      if (code.at(row, column))
        draw->AddRectFilled({edge(low.x, column), edge(low.y, row)}, {edge(low.x, column + 1), edge(low.y, row + 1)},
                            IM_COL32_BLACK);
  ImGui::Dummy({side, side});
  recordItem("class/qr");
}

std::string clock(double time_s) {
  const auto whole = static_cast<long long>(std::clamp(time_s, 0.0, 1e9));
  const std::string seconds = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (seconds.size() < 2 ? "0" : "") + seconds;
}

void begin(ClassDesk& desk) {
  LiveClassOptions options;
  options.lessons = {desk.lesson.string()};
  options.page = browserEdition();
  options.folder = newClassFolder();
  options.share = desk.share;
  desk.said.clear();
  if (options.page.empty())
    desk.said = tr("There is no browser edition here for the students. Make it with './run.sh web'.");
  else if (options.folder.empty())
    desk.said = tr("This computer names no folder for the class.");
  else
    desk.taught = std::make_unique<TaughtClass>(std::move(options));
  desk.looked = {};
}

void drawBeginning(ClassDesk& desk) {
  const Palette& p = look().palette;
  {
    const WithFont heading(Font::Heading);
    words("class/lesson", desk.title, p.text);
  }
  ImGui::Spacing();
  words(
      "class/what",
      tr("Students open an address with any browser, on a telephone or a computer, give a name and begin this lesson. "
         "They install nothing. You see who is where, who is stuck and what they choose."),
      p.text);
  ImGui::Spacing();
  toggle("class/share", tr("Other computers in this network may join"), desk.share);
  words("class/share/what",
        desk.share ? tr("Every device in this network reaches the class, and whoever has the address can join it. The "
                        "connection is not encrypted: others in the network can read names and answers.")
                   : tr("Only this computer reaches the class: to try it."),
        p.quiet);
  ImGui::Spacing();
  words("class/kept", tr("Names and work are kept on this computer. The class ends when this program does."), p.quiet);
  if (!desk.said.empty()) words("class/said", desk.said, p.warn);
  ImGui::Dummy({0, look().px(8)});
  if (button("class/begin", tr("Begin the class"), ButtonLook::Primary, -1.0f, !desk.lesson.empty())) begin(desk);
}

void drawAddress(ClassDesk& desk, const TaughtClass::Facts& facts) {
  const Look& l = look();
  const float side = facts.qr.width ? l.tx(150) : 0.0f, wide = ImGui::GetContentRegionAvail().x;
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wide - side - l.px(20));
  {
    const WithText quiet(l.palette.quiet);
    ImGui::TextWrapped("%s", tr("Students open this address"));
  }
  {
    const WithFont heading(Font::Heading);
    ImGui::TextWrapped("%s", facts.address.c_str());
    recordItem("class/address", facts.address);
  }
  for (const std::string& other : facts.others) {
    const WithText quiet(l.palette.quiet);
    ImGui::TextWrapped("%s", trf("or: {0}", other).c_str());
  }
  if (facts.alone)
    words("class/alone", tr("This computer is in no network now, so that nobody else reaches the class."),
          l.palette.warn);
  else if (!facts.shared)
    words("class/alone", tr("Only this computer reaches the class: to try it."), l.palette.quiet);
  ImGui::PopTextWrapPos();
  if (button("class/projector", tr("For the projector")) && !openInBrowser(facts.address + "board"))
    desk.said = trf("There is no browser to open. Its address: {0}", facts.address + "board");
  tip(tr("A page in the browser with this address and its code, without names"));
  ImGui::SameLine();
  if (button("class/browser", tr("Your page in the browser")) && !openInBrowser(facts.teacher))
    desk.said = trf("There is no browser to open. Its address: {0}", facts.teacher);
  tip(tr("With the plots of predictions. Do not show it to the class: it has names and answers"));
  if (!desk.said.empty()) words("class/said", desk.said, l.palette.warn);
  ImGui::EndGroup();
  if (!facts.qr.width) return;
  ImGui::SameLine(wide - side);
  drawQr(facts.qr, side);
}

std::string hiddenWords(const SceneRow& row) {
  switch (row.hidden) {
    case SceneHidden::No:
      return {};
    case SceneHidden::Dark:
      return trnf("It stays hidden: {0} student works on a task that is done without seeing.",
                  "It stays hidden: {0} students work on a task that is done without seeing.", row.waiting,
                  row.waiting);
    case SceneHidden::Question:
      return trnf("It stays hidden: a question of this step is open for {0} student.",
                  "It stays hidden: a question of this step is open for {0} students.", row.waiting, row.waiting);
    case SceneHidden::NoPicture:
      return tr("It is hidden: the student's page sends no picture now.");
  }
  return {};
}

std::string stateWords(const StudentRow& row) {
  if (row.finished) return tr("finished");
  if (row.away) return tr("away");
  if (row.stuck) return row.begun ? tr("stuck") : tr("has not begun");
  return {};
}

void cell(const std::string& text, ImU32 colour) {
  ImGui::TableNextColumn();
  const WithText coloured(colour);
  ImGui::TextWrapped("%s", text.c_str());
}

constexpr ImGuiTableFlags kTable =
    ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX;

void headCells(std::initializer_list<const char*> texts) {
  ImGui::TableNextRow();
  for (const char* text : texts) cell(text, look().palette.quiet);
}

void drawStudents(ClassDesk& desk) {
  const Palette& p = look().palette;
  const ClassView& view = desk.view;
  words("class/here",
        std::to_string(view.here) + " " + trn("student here", "students here", view.here) + ", " +
            std::to_string(view.stuck) + " " + tr("stuck") + ", " + std::to_string(view.finished) + " " +
            tr("finished"),
        p.text);
  if (view.students.empty() || !ImGui::BeginTable("students", 6, kTable)) return;
  ImGui::TableSetupColumn("name", 0, 1.5f);
  ImGui::TableSetupColumn("step", 0, 1.8f);
  ImGui::TableSetupColumn("task", 0, 0.7f);
  ImGui::TableSetupColumn("time", 0, 0.7f);
  ImGui::TableSetupColumn("state", 0, 0.9f);
  ImGui::TableSetupColumn("scene", 0, 1.2f);
  headCells({tr("Student"), tr("Step"), tr("Task"), tr("On this step"), "", ""});
  for (const StudentRow& row : view.students) {
    ImGui::TableNextRow();
    const ImU32 colour = row.stuck ? p.warn : row.away ? p.quiet : p.text;
    const std::string name = "class/student/" + std::to_string(row.student);
    cell(row.name, colour);
    recordItem(name, row.name);
    cell(row.step_number ? std::to_string(row.step_number) + ". " + row.step : std::string(tr("not begun")), colour);
    recordItem(name + "/step", row.step);
    cell(row.task ? trf("{0} of {1}", row.task, row.tasks) : row.tasks ? tr("done") : std::string("–"), colour);
    cell(row.step_number ? clock(row.on_step_s) : std::string(), colour);
    cell(stateWords(row), colour);
    recordItem(name + "/state", stateWords(row));
    ImGui::TableNextColumn();
    if (row.may_ask_scene && button((name + "/scene").c_str(), tr("Ask for the scene")))
      acted(desk).askForScene(row.student);
  }
  ImGui::EndTable();
}

void drawScene(ClassDesk& desk) {
  if (!desk.view.scene) return;
  const SceneRow& row = *desk.view.scene;
  words("class/scene",
        !row.agreed ? trf("{0} is asked to show the scene on the projector.", row.student)
        : row.named ? trf("The projector's page shows the scene of {0}, with the name.", row.student)
                    : trf("The projector's page shows the scene of {0}, without the name.", row.student),
        look().palette.text);
  if (row.hidden != SceneHidden::No) words("class/scene/hidden", hiddenWords(row), look().palette.quiet);
  if (button("class/scene/end", row.agreed ? tr("Take it off") : tr("Do not ask"))) acted(desk).endScene();
}

void drawSteps(ClassDesk& desk) {
  const Palette& p = look().palette;
  for (const LessonView& lesson : desk.view.lessons) {
    sectionTitle(tr("Steps"));
    if (lesson.held) {
      words("class/held", trf("Nobody may go beyond step {0}.", *lesson.held + 1), p.text);
      if (button("class/open", tr("Open the way for all"))) acted(desk).open(lesson.id);
    }
    if (!ImGui::BeginTable("steps", 5, kTable)) continue;
    ImGui::TableSetupColumn("step", 0, 2.4f);
    for (const char* column : {"here", "reached", "hints", "hold"}) ImGui::TableSetupColumn(column, 0, 0.8f);
    headCells({tr("Step"), tr("Here now"), tr("Reached"), tr("Hints taken"), ""});
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
      const StepRow& step = lesson.steps[k];
      if (step.aside && step.reached == 0) continue;
      ImGui::TableNextRow();
      const std::string name = "class/step/" + std::to_string(k);
      cell(std::to_string(k + 1) + ". " + step.title, p.text);
      cell(step.here ? std::to_string(step.here) : std::string(), step.stuck ? p.warn : p.text);
      recordItem(name + "/here", std::to_string(step.here));
      cell(std::to_string(step.reached), p.text);
      cell(step.hints ? std::to_string(step.hints) : std::string(), p.text);
      ImGui::TableNextColumn();
      if (step.held)
        ImGui::TextUnformatted(tr("held"));
      else if (!step.aside && button((name + "/hold").c_str(), tr("Hold here")))
        acted(desk).hold(lesson.id, k);
    }
    ImGui::EndTable();
  }
}

void drawMisconceptions(const ClassView& view) {
  if (view.misconceptions.empty()) return;
  sectionTitle(tr("Misconceptions chosen now"));
  for (std::size_t k = 0; k < view.misconceptions.size(); ++k) {
    const MisconceptionRow& row = view.misconceptions[k];
    std::string names;
    for (const std::string& name : row.students) names += (names.empty() ? "" : ", ") + name;
    words(("class/misconception/" + std::to_string(k)).c_str(), row.words + ": " + names, look().palette.text);
  }
}

void report(Application& app, ClassDesk& desk) {
  const auto file = desk.taught->writeReport();
  if (!file) return app.messages.error(file.problem().text());
  desk.said.clear();
  if (file->empty())
    desk.said = tr("Nobody has begun a lesson yet.");
  else if (!openInBrowser("file://" + file->string()))
    desk.said = trf("Report: {0}", file->string());
}

void drawFoot(Application& app, ClassDesk& desk) {
  const bool ended = desk.view.ended;
  if (desk.sure) {
    words("class/sure", tr("End the class for all? Students can then no longer join."), look().palette.text);
    if (button("class/end/yes", tr("End the class"), ButtonLook::Primary)) {
      desk.sure = false;
      acted(desk).end();
      report(app, desk);
    }
    ImGui::SameLine();
    if (button("class/end/no", tr("Go on"))) desk.sure = false;
    return;
  }
  if (button("class/report", tr("Report"))) report(app, desk);
  ImGui::SameLine();
  if (!ended && button("class/end", tr("End the class"))) desk.sure = true;
  if (ended && button("class/stop", tr("Stop serving"))) desk.taught->stop();
  if (ended) tip(tr("Work that is still on the way then stays in the students' browsers"));
}

void drawServed(Application& app, ClassDesk& desk) {
  constexpr std::chrono::milliseconds kLookEvery{1000};
  const auto now = std::chrono::steady_clock::now();
  if (desk.looked.time_since_epoch().count() == 0 || now - desk.looked >= kLookEvery) {
    if (auto view = desk.taught->view()) desk.view = *std::move(view);
    desk.looked = now;
  }
  const float foot = look().tx(desk.sure ? 66 : 36) + look().px(10);
  ImGui::BeginChild("class", {0, -foot});
  drawAddress(desk, desk.taught->facts());
  ImGui::Dummy({0, look().px(6)});
  if (desk.view.ended)
    words("class/ended", tr("The class has ended. Work that is still on the way arrives."), look().palette.text);
  drawStudents(desk);
  drawScene(desk);
  drawSteps(desk);
  drawMisconceptions(desk.view);
  ImGui::EndChild();
  drawFoot(app, desk);
}

void drawOver(ClassDesk& desk) {
  const Palette& p = look().palette;
  if (const auto problem = desk.taught->problem()) {
    words("class/problem", problem->text(), p.warn);
  } else {
    words("class/over", tr("The class is over."), p.text);
    if (const std::filesystem::path file = desk.taught->report(); !file.empty())
      words("class/report/file", trf("Report: {0}", file.string()), p.text);
  }
  ImGui::Dummy({0, look().px(8)});
  if (button("class/again", tr("Another class"), ButtonLook::Primary)) desk.taught.reset();
}

}  // namespace

bool teachesClass() { return classDesk().taught && classDesk().taught->state() != TaughtClass::State::Over; }

void openClassPage(Application& app) {
  ClassDesk& desk = classDesk();
  desk.open = true;
  if (desk.taught || !app.lesson.session()) return;
  desk.lesson = app.lesson.file();
  desk.title = app.lesson.session()->lesson().title;
  desk.said.clear();
}

void drawClassPage(Application& app) {
  ClassDesk& desk = classDesk();
  const bool served = desk.taught && desk.taught->state() == TaughtClass::State::Served;
  const float width = served ? 880.0f : 520.0f, height = served ? 680.0f : 470.0f;
  if (!beginPage("class page", tr("Teach a class"), desk.open, width, height)) return;
  if (!desk.taught)
    drawBeginning(desk);
  else if (served)
    drawServed(app, desk);
  else if (desk.taught->state() == TaughtClass::State::Over)
    drawOver(desk);
  else
    words("class/beginning", tr("The class begins …"), look().palette.quiet);
  endPage();
}

}  // namespace moltact
