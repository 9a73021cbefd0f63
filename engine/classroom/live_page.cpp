#include "engine/classroom/live_page.h"

#include <algorithm>
#include <cmath>

#include "engine/classroom/qr_code.h"
#include "engine/core/markup.h"
#include "engine/core/svg.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxUnbegun = 3;

std::string tile(std::size_t count, const char* words, const char* look) {
  return std::string("<div class=\"tile ") + look + "\"><b>" + std::to_string(count) + "</b><span>" + words +
         "</span></div>";
}

std::string minutes(double time_s) {
  const auto whole = static_cast<long long>(std::clamp(time_s, 0.0, 1e9));
  const std::string seconds = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (seconds.size() < 2 ? "0" : "") + seconds;
}

std::string tilesPart(const ClassView& view) {
  return tile(view.here, trn("student here", "students here", view.here), "") + tile(view.away, tr("away"), "") +
         tile(view.stuck, tr("stuck"), view.stuck ? "warn" : "") +
         tile(view.finished, tr("finished"), view.finished ? "good" : "") +
         (view.ended ? std::string("<p class=\"over\">") +
                           tr("The class has ended. Work that is still on the way arrives.") + "</p>"
                     : std::string());
}

std::string stateOf(const StudentRow& row) {
  if (row.finished) return std::string("<span class=\"mark good\">✓ ") + tr("finished") + "</span>";
  if (row.away) return std::string("<span class=\"mark\">") + tr("away") + "</span>";
  if (row.stuck)
    return std::string("<span class=\"mark warn\">! ") + (row.begun ? tr("stuck") : tr("has not begun")) + "</span>";
  return {};
}

std::string studentsPart(const ClassView& view) {
  if (view.students.empty())
    return std::string("<p class=\"quiet\">") + tr("Nobody has joined yet. Students open the address above.") + "</p>";
  const bool asks =
      std::any_of(view.students.begin(), view.students.end(), [](const StudentRow& row) { return row.may_ask_scene; });
  const bool several = std::any_of(view.students.begin(), view.students.end(), [&](const StudentRow& row) {
    return !row.lesson.empty() && row.lesson != view.students.front().lesson && !view.students.front().lesson.empty();
  });
  std::string out = std::string("<table><thead><tr><th>") + tr("Student") + "</th>" +
                    (several ? std::string("<th>") + tr("Lesson") + "</th>" : "") + "<th>" + tr("Step") + "</th><th>" +
                    tr("Task") + "</th><th class=\"n\">" + tr("On this step") + "</th><th class=\"n\">" + tr("Hints") +
                    "</th><th>" + tr("Done") + "</th><th></th>" + (asks ? "<th></th>" : "") + "</tr></thead><tbody>";
  for (const StudentRow& row : view.students) {
    out += row.stuck ? "<tr class=\"stuck\">" : row.away ? "<tr class=\"away\">" : "<tr>";
    out += "<td class=\"name\">" + escaped(row.name) + "</td>";
    if (several) out += "<td>" + escaped(row.lesson) + "</td>";
    out += "<td>" +
           (row.step_number ? std::to_string(row.step_number) + ". " + escaped(row.step)
                            : std::string("<span class=\"quiet\">") + tr("not begun") + "</span>") +
           "</td>";
    out += "<td>" + (row.task ? trf("{0} of {1}", row.task, row.tasks) : row.tasks ? "✓" : std::string("–")) + "</td>";
    out += "<td class=\"n\">" + (row.step_number ? minutes(row.on_step_s) : "") + "</td><td class=\"n\">" +
           (row.hints ? std::to_string(row.hints) : "") + "</td>";
    out += "<td><progress max=\"" + std::to_string(std::max<std::size_t>(1, row.of)) + "\" value=\"" +
           std::to_string(row.done) + "\"></progress></td><td>" + stateOf(row) + "</td>";
    if (row.may_ask_scene)
      out += "<td class=\"n\"><button class=\"small\" data-do=\"ask scene\" id=\"ask-scene-" +
             std::to_string(row.student) + "\" data-student=\"" + std::to_string(row.student) + "\">" +
             tr("Ask for the scene") + "</button></td>";
    else if (asks)
      out += "<td></td>";
    out += "</tr>";
  }
  return out + "</tbody></table>";
}

// The scene that a student was asked for, or shows.
std::string scenePart(const ClassView& view) {
  if (!view.scene) return {};
  const SceneRow& row = *view.scene;
  const std::string name = escaped(row.student);
  std::string words;
  if (!row.agreed)
    words = trf("{0} is asked to show the scene on the projector.", name);
  else
    words = row.named ? trf("The projector's page shows the scene of {0}, with the name.", name)
                      : trf("The projector's page shows the scene of {0}, without the name.", name);
  std::string out = "<p class=\"held\">" + words + " <button data-do=\"end scene\" id=\"end-scene\">" +
                    (row.agreed ? tr("Take it off") : tr("Do not ask")) + "</button></p>";
  std::string why;
  if (row.hidden == SceneHidden::Dark)
    why = trnf("It stays hidden: {0} student works on a task that is done without seeing.",
               "It stays hidden: {0} students work on a task that is done without seeing.", row.waiting, row.waiting);
  if (row.hidden == SceneHidden::Question)
    why = trnf("It stays hidden: a question of this step is open for {0} student.",
               "It stays hidden: a question of this step is open for {0} students.", row.waiting, row.waiting);
  if (row.hidden == SceneHidden::NoPicture) why = tr("It is hidden: the student's page sends no picture now.");
  return why.empty() ? out : out + "<p class=\"quiet\">" + why + "</p>";
}

std::string stepsPart(const ClassView& view) {
  std::string out;
  for (const LessonView& lesson : view.lessons) {
    // Of a class with all lessons of the program, those that somebody has begun.
    if (lesson.students == 0 && !lesson.held && view.lessons.size() > kMaxUnbegun) continue;
    out += "<article class=\"card\"><h3>" + escaped(lesson.title) + "</h3>";
    if (lesson.held) {
      out += "<p class=\"held\">" + trf("Nobody may go beyond step {0}.", *lesson.held + 1) +
             " <button data-do=\"open\" id=\"open-" + escaped(lesson.id) + "\" data-lesson=\"" + escaped(lesson.id) +
             "\">" + tr("Open the way for all") + "</button></p>";
    }
    std::size_t most = 1;
    for (const StepRow& step : lesson.steps) most = std::max(most, step.here);
    out += std::string("<table><thead><tr><th>") + tr("Step") + "</th><th>" + tr("Here now") + "</th><th class=\"n\">" +
           tr("Reached") + "</th><th class=\"n\">" + tr("Hints taken") + "</th><th></th></tr></thead><tbody>";
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
      const StepRow& step = lesson.steps[k];
      if (step.aside && step.reached == 0) continue;
      out += std::string("<tr") + (step.held ? " class=\"held\"" : "") + "><td>" + std::to_string(k + 1) + ". " +
             escaped(step.title) + "</td><td><meter class=\"" + (step.stuck ? "warn" : "") + "\" max=\"" +
             std::to_string(most) + "\" value=\"" + std::to_string(step.here) + "\"></meter> " +
             (step.here ? std::to_string(step.here) : "") + "</td><td class=\"n\">" + std::to_string(step.reached) +
             "</td><td class=\"n\">" + (step.hints ? std::to_string(step.hints) : "") + "</td><td class=\"n\">";
      if (!step.aside && !step.held)
        out += "<button class=\"small\" data-do=\"hold\" id=\"hold-" + escaped(lesson.id) + "-" + std::to_string(k) +
               "\" data-lesson=\"" + escaped(lesson.id) + "\" data-step=\"" + std::to_string(k) + "\">" +
               tr("Hold here") + "</button>";
      if (step.held) out += std::string("<b>") + tr("held") + "</b>";
      out += "</td></tr>";
    }
    out += "</tbody></table></article>";
  }
  return out.empty()
             ? std::string("<p class=\"quiet\">") + tr("The lessons stand here when somebody begins one.") + "</p>"
             : out;
}

std::string barRow(const std::string& words, std::size_t count, std::size_t of, const std::string& more = {}) {
  return "<li><span>" + escaped(words) + (more.empty() ? "" : "<small>" + more + "</small>") + "</span><meter max=\"" +
         std::to_string(std::max<std::size_t>(1, of)) + "\" value=\"" + std::to_string(count) + "\"></meter><b>" +
         std::to_string(count) + "</b></li>";
}

std::string curvesSvg(const CurvePlot& plot) {
  constexpr double kLeft = 34, kTop = 8, kWide = 420, kHigh = 150;
  double max_N = 0.1, to_A = 0.1;
  for (const CurveKept& curve : plot.curves) {
    max_N = std::max(max_N, std::isfinite(curve.max_N) ? curve.max_N : 0.0);
    to_A = std::max(to_A, std::isfinite(curve.to_A) ? curve.to_A : 0.0);
  }
  Svg svg;
  for (const double part : {0.0, 0.5, 1.0})
    svg.path(svgPoint('M', kLeft, kTop + kHigh * part) + "h" + svgNumber(kWide), "class=\"grid\"");
  svg.text(kLeft - 4, kTop + 8, "end", quantityNumber(max_N, Dimension::Force, significant(2)), "class=\"axis\"");
  svg.text(kLeft - 4, kTop + kHigh, "end", "0", "class=\"axis\"");
  svg.text(kLeft + kWide, kTop + kHigh + 14, "end", quantityText(to_A, Dimension::Length, significant(2)),
           "class=\"axis\"");
  svg.text(kLeft, kTop + kHigh + 14, "start", unitText(Dimension::Force), "class=\"axis\"");
  for (const CurveKept& curve : plot.curves) {
    std::string path;
    bool on = false;
    const double last = double(std::max<std::size_t>(2, curve.force_N.size()) - 1);
    for (std::size_t k = 0; k < curve.force_N.size(); ++k) {
      const double force = curve.force_N[k];
      if (!std::isfinite(force)) {
        on = false;
        continue;
      }
      path += svgPoint(on ? 'L' : 'M', kLeft + kWide * double(k) / last * std::clamp(curve.to_A / to_A, 0.0, 1.0),
                       kTop + kHigh * (1.0 - std::clamp(force / max_N, 0.0, 1.0)));
      on = true;
    }
    svg.path(path, "class=\"drawn\"");
  }
  return std::move(svg).within("class=\"curves\" viewBox=\"0 0 470 180\" role=\"img\" aria-label=\"" +
                               escaped(plot.task) + "\"");
}

std::string choiceBars(const PredictionPlot& plot) {
  std::string out;
  for (std::size_t k = 0; k < plot.choices.size(); ++k) out += barRow(plot.choices[k], plot.counts[k], plot.students);
  return out;
}

// The button that puts a plot on the projector's page, or takes it off. Who has not predicted yet would see the others'
// predictions first, so that the teacher is asked then.
std::string showButton(const ClassView& view, const ShownPlot& plot, std::size_t students, std::size_t waiting) {
  const std::string what = std::string(plot.curve ? "task" : "question") + "-" + escaped(plot.lesson) + "-" +
                           std::to_string(plot.step) + "-" + std::to_string(plot.number);
  if (view.shown == plot)
    return std::string("<p class=\"held\">") + tr("The page for the projector shows this.") +
           " <button data-do=\"hide\" id=\"hide-" + what + "\">" + tr("Take it off") + "</button></p>";
  if (students < kShownFrom)
    return "<p class=\"quiet\">" + trf("It can be shown to the class with {0} predictions and more.", kShownFrom) +
           "</p>";
  std::string out = "<p><button class=\"small\" data-do=\"show\" id=\"show-" + what + "\" data-lesson=\"" +
                    escaped(plot.lesson) + "\" data-step=\"" + std::to_string(plot.step) + "\" data-" +
                    (plot.curve ? "task" : "question") + "=\"" + std::to_string(plot.number) + "\"";
  if (waiting > 0)
    out +=
        " data-sure=\"" +
        escaped(trnf("{0} student here has not predicted yet and would see the others' predictions first. Show it?",
                     "{0} students here have not predicted yet and would see the others' predictions first. Show it?",
                     waiting, waiting)) +
        "\"";
  return out + ">" + tr("Show this prediction to the class") + "</button>" +
         (waiting > 0 ? " <span class=\"quiet\">" +
                            trnf("{0} student here has not predicted yet.", "{0} students here have not predicted yet.",
                                 waiting, waiting) +
                            "</span>"
                      : std::string()) +
         "</p>";
}

std::string answersPart(const ClassView& view) {
  std::string out;
  if (!view.misconceptions.empty()) {
    out += std::string("<article class=\"card\"><h3>") + tr("Misconceptions chosen now") + "</h3><ul class=\"bars\">";
    for (const MisconceptionRow& row : view.misconceptions) {
      std::string names;
      for (const std::string& name : row.students) names += (names.empty() ? "" : ", ") + escaped(name);
      out += barRow(row.words, row.students.size(), view.students.size(), names);
    }
    out += "</ul></article>";
  }
  for (const LessonView& lesson : view.lessons) {
    for (const PredictionPlot& plot : lesson.predictions) {
      out += "<article class=\"card\"><h3>" + escaped(plot.question) + "</h3><p class=\"quiet\">" +
             trnf("Prediction of {0} student, {1}", "Predictions of {0} students, {1}", plot.students, plot.students,
                  escaped(plot.step)) +
             "</p><ul class=\"bars\">";
      out += choiceBars(plot);
      for (const std::string& text : plot.written) out += "<li class=\"text\">" + escaped(text) + "</li>";
      out += "</ul>";
      if (!plot.choices.empty())
        out += showButton(view, {lesson.id, plot.at_step, plot.at_question, false}, plot.students, plot.waiting);
      out += "</article>";
    }
    for (const CurvePlot& plot : lesson.curves)
      out += "<article class=\"card\"><h3>" + escaped(plot.task) + "</h3><p class=\"quiet\">" +
             trnf("Force curve that {0} student drew, {1}", "Force curves that {0} students drew, {1}",
                  plot.curves.size(), plot.curves.size(), escaped(plot.step)) +
             "</p>" + curvesSvg(plot) +
             showButton(view, {lesson.id, plot.at_step, plot.at_task, true}, plot.curves.size(), plot.waiting) +
             "</article>";
  }
  return out.empty() ? std::string("<p class=\"quiet\">") +
                           tr("Predictions and wrong answers that show a misconception stand here.") + "</p>"
                     : out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> teacherParts(const ClassView& view) {
  return {{"tiles", tilesPart(view)},
          {"scene-row", scenePart(view)},
          {"students", studentsPart(view)},
          {"steps", stepsPart(view)},
          {"answers", answersPart(view)}};
}

namespace {

std::string boardPageOf(const TeacherPageFacts& facts, std::size_t here, const std::string& content,
                        const std::string& head) {
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + escaped(language()) +
                    "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, "
                    "initial-scale=1\">" +
                    head + "<title>" + tr("Live class") + "</title><style>" + teacherStyle() +
                    "</style></head><body class=\"board" + (content.empty() ? "" : " plot") + "\"><main>" + content +
                    "<section><div><p>" + tr("Open this address") + "</p><p class=\"big\">" + escaped(facts.address) +
                    "</p><p>" + std::to_string(here) + " " + trn("student here", "students here", here) + "</p></div>";
  if (facts.shared)
    out += qrSvg(qrCode(facts.address), facts.address);
  else
    out += std::string("<p class=\"quiet\">") +
           tr("It works on this computer only. Start the class with --share to let the room in.") + "</p>";
  return out + "</section></main></body></html>\n";
}

}  // namespace

std::string sceneHiddenText(SceneHidden why) {
  switch (why) {
    case SceneHidden::No:
      return {};
    case SceneHidden::Dark:
      return tr("The scene is hidden while somebody works on a task that is done without seeing.");
    case SceneHidden::Question:
      return tr("The scene is hidden until everyone at this step has answered its questions.");
    case SceneHidden::NoPicture:
      return tr("The student's page sends no picture now.");
  }
  return {};
}

std::string boardScenePage(const TeacherPageFacts& facts, std::size_t here, const std::string& name) {
  const std::string title =
      name.empty() ? std::string(tr("The scene of a student")) : trf("The scene of {0}", escaped(name));
  return boardPageOf(facts, here,
                     "<h1>" + title + "</h1><img id=\"scene\" alt=\"" + title +
                         "\" hidden><p id=\"why\" class=\"quiet\" role=\"status\" data-lost=\"" +
                         escaped(tr("The class's server does not answer. This page tries again.")) + "\"></p>",
                     "<script src=\"board.js\" defer></script>");
}

std::string boardScript() {
  return R"js("use strict";
(() => {
  const kEvery_ms = 400, kLost_ms = 5000;
  const scene = document.getElementById("scene"), why = document.getElementById("why");
  let tag = "", heard_ms = performance.now();
  const hide = (text) => {
    if (scene.src) URL.revokeObjectURL(scene.src);
    scene.removeAttribute("src");
    scene.hidden = true;
    why.textContent = text;
    tag = "";
  };
  const look = async () => {
    try {
      const reply = await fetch("scene", {cache: "no-store", credentials: "omit", headers: tag ? {"If-None-Match": tag} : {},
                                          signal: AbortSignal.timeout(kLost_ms)});
      if (reply.status === 404) return location.reload();
      heard_ms = performance.now();
      if (reply.status === 200) {
        const old = scene.src;
        scene.src = URL.createObjectURL(await reply.blob());
        if (old) URL.revokeObjectURL(old);
        tag = reply.headers.get("ETag") || "";
        scene.hidden = false;
        why.textContent = "";
      } else if (reply.status === 409) {
        hide(await reply.text());
      }
    } catch {
      if (performance.now() - heard_ms > kLost_ms) hide(why.dataset.lost);
    }
    setTimeout(look, kEvery_ms);
  };
  look();
})();
)js";
}

std::string boardPage(const TeacherPageFacts& facts, std::size_t here, const BoardPlot& board) {
  std::string plot;
  if (board.prediction)
    plot = "<h1>" + escaped(board.prediction->question) + "</h1><p class=\"quiet\">" +
           trnf("What {0} student expects", "What {0} students expect", board.prediction->students,
                board.prediction->students) +
           "</p><ul class=\"bars\">" + choiceBars(*board.prediction) + "</ul>";
  else if (board.curve)
    plot = "<h1>" + escaped(board.curve->task) + "</h1><p class=\"quiet\">" +
           trnf("The force that {0} student expects", "The force that {0} students expect", board.curve->curves.size(),
                board.curve->curves.size()) +
           "</p>" + curvesSvg(*board.curve);
  return boardPageOf(facts, here, plot, "<meta http-equiv=\"refresh\" content=\"5\">");
}

std::string teacherPage(const ClassView& view, const TeacherPageFacts& facts) {
  const std::string title = tr("Live class");
  const auto parts = teacherParts(view);
  const auto part = [&](std::size_t k) { return "<div id=\"" + parts[k].first + "\">" + parts[k].second + "</div>"; };
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + escaped(language()) +
                    "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, "
                    "initial-scale=1\"><title>" +
                    title + "</title><link rel=\"stylesheet\" href=\"class.css\"><link rel=\"icon\" href=\"data:,\">" +
                    "<script src=\"class.js\" defer></script></head><body><main>";
  out += "<header><div><h1>" + title + "</h1><p id=\"lost\" role=\"status\" hidden>" +
         tr("The class's server does not answer. This page tries again.") +
         "</p></div><nav><a class=\"button\" href=\"" + escaped(facts.address) +
         "board\" target=\"_blank\" rel=\"noopener\">" + tr("For the projector") +
         "</a><a class=\"button\" href=\"report\" target=\"_blank\">" + tr("Report") +
         "</a><button data-do=\"end\" data-sure=\"" +
         escaped(tr("End the class for all? Students can then no longer join.")) + "\">" + tr("End the class") +
         "</button></nav></header>";
  out += "<section class=\"card address\"><div><p class=\"quiet\">" + std::string(tr("Students open this address")) +
         "</p><p class=\"big\">" + escaped(facts.address) + "</p>";
  if (!facts.shared)
    out += std::string("<p class=\"quiet\">") +
           tr("It works on this computer only. Start the class with --share to let the room in.") + "</p>";
  out += std::string("<p class=\"quiet\">") +
         tr("Do not show this page to the class: it has names and answers. The projector has a page of its own.") +
         "</p></div></section>";
  out += part(0) + part(1) + "<h2>" + tr("Who is where") + "</h2><div class=\"card scroll\">" + part(2) + "</div><h2>" +
         tr("Steps") + "</h2>" + part(3) + "<h2>" + tr("Answers") + "</h2>" + part(4);
  return out + "</main></body></html>\n";
}

std::string teacherStyle() {
  return R"css(
:root{color-scheme:light dark;--ground:#f6f7f9;--panel:#fff;--text:#1b2430;--quiet:#5a6675;--line:#d9dfe6;--accent:#0b63a8;--soft:#e6f0f9;--warn:#b4480a;--warn-soft:#fcefe4;--good:#0a7d5c}
@media(prefers-color-scheme:dark){:root{--ground:#12161b;--panel:#1b2129;--text:#e8edf2;--quiet:#a3afbc;--line:#333d48;--accent:#6fb5f0;--soft:#1f3347;--warn:#f0a066;--warn-soft:#3a2a1e;--good:#5fd0a8}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--text);font:16px/1.5 Inter,system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif;font-variant-numeric:tabular-nums}
main{max-width:1180px;margin:0 auto;padding:24px 24px 64px}
header{display:flex;flex-wrap:wrap;justify-content:space-between;align-items:center;gap:12px;margin-bottom:14px}
h1{font-size:28px;line-height:1.2;margin:0;letter-spacing:-.01em}h2{font-size:21px;margin:34px 0 10px;letter-spacing:-.01em}h3{font-size:17px;margin:0 0 8px}
p{margin:4px 0}.quiet,small{color:var(--quiet)}nav{display:flex;gap:10px}
button,.button{font:inherit;font-weight:600;color:var(--accent);background:var(--panel);border:1px solid var(--line);border-radius:8px;padding:8px 16px;cursor:pointer;text-decoration:none}
button:hover,.button:hover{background:var(--soft)}button:focus-visible,.button:focus-visible{outline:3px solid var(--accent);outline-offset:2px}
button.small{font-size:13.5px;padding:3px 10px;font-weight:500}
.card{background:var(--panel);border:1px solid var(--line);border-radius:12px;padding:16px 20px;margin:0 0 12px}.scroll{overflow-x:auto}
.address{display:flex;justify-content:space-between;align-items:center;gap:24px}.big{font-size:clamp(22px,3.4vw,40px);font-weight:650;letter-spacing:.01em;overflow-wrap:anywhere}
.qr{width:min(210px,30vw);flex:none;border-radius:8px}
#tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(140px,1fr));gap:12px;margin:12px 0}
.tile{background:var(--panel);border:1px solid var(--line);border-radius:12px;padding:10px 16px}.tile b{display:block;font-size:30px;line-height:1.2}.tile span{color:var(--quiet)}
.tile.warn{background:var(--warn-soft);border-color:var(--warn)}.tile.warn b{color:var(--warn)}.tile.good b{color:var(--good)}.over{grid-column:1/-1;font-weight:600}
table{border-collapse:collapse;width:100%}th,td{padding:7px 10px;text-align:left;border-bottom:1px solid var(--line);vertical-align:middle}
th{font-weight:600;color:var(--quiet);font-size:13.5px}tbody tr:last-child td{border-bottom:0}.n{text-align:right;white-space:nowrap}.name{font-weight:600;overflow-wrap:anywhere;min-width:8em}
tr.stuck{background:var(--warn-soft)}tr.away{color:var(--quiet)}tr.held td{background:var(--soft)}p.held{background:var(--soft);border-radius:8px;padding:8px 12px;margin-bottom:10px}
.mark{white-space:nowrap;color:var(--quiet)}.mark.warn{color:var(--warn);font-weight:650}.mark.good{color:var(--good);font-weight:650}
progress,meter{width:120px;height:12px;vertical-align:middle;border:0;border-radius:6px;overflow:hidden;background:var(--soft);appearance:none}
meter::-webkit-meter-bar,progress::-webkit-progress-bar{background:var(--soft);border:0;border-radius:6px;height:12px}
meter::-webkit-meter-optimum-value,progress::-webkit-progress-value{background:var(--accent);border-radius:6px}meter.warn::-webkit-meter-optimum-value{background:var(--warn)}
meter::-moz-meter-bar,progress::-moz-progress-bar{background:var(--accent);border-radius:6px}meter.warn::-moz-meter-bar{background:var(--warn)}
.bars{list-style:none;margin:8px 0 0;padding:0}.bars li{display:grid;grid-template-columns:minmax(8em,1.4fr) minmax(100px,1fr) 2.4em;gap:4px 14px;align-items:center;padding:5px 0}
.bars small{display:block}.bars meter{width:100%;height:16px}.bars meter::-webkit-meter-bar{grid-row:1/-1;height:100%}.bars b{text-align:right}.bars li.text{display:block;border-left:3px solid var(--line);padding:2px 10px;margin:4px 0;overflow-wrap:anywhere}
.board main{text-align:center;font-size:24px}.board .big{font-size:clamp(28px,5vw,72px)}.board .qr{width:min(56vh,80vw);margin:16px auto}
.plot main{text-align:left;max-width:1400px}.plot h1{font-size:clamp(26px,3vw,44px)}.plot .bars li{padding:10px 0;font-size:clamp(20px,2.2vw,32px)}.plot .bars meter{height:30px;border-radius:8px}.plot .curves{max-width:min(100%,110vh)}
#scene{display:block;width:100%;max-height:72vh;object-fit:contain;border-radius:10px}#scene[hidden]{display:none}
.plot section{display:flex;justify-content:space-between;align-items:center;gap:24px;margin-top:28px;padding-top:12px;border-top:1px solid var(--line);font-size:18px}.plot .big{font-size:clamp(20px,2.4vw,32px)}.plot .qr{width:min(22vh,30vw);margin:0}
svg{max-width:100%;display:block}.curves{max-width:620px}.grid{stroke:var(--line);fill:none}.axis{font-size:11px;fill:var(--quiet)}.drawn{fill:none;stroke:var(--accent);stroke-width:2;stroke-opacity:.45;stroke-linejoin:round}
#lost{color:var(--warn);font-weight:600}
)css";
}

std::string teacherScript() {
  return R"js("use strict";
(() => {
  const lost = document.getElementById("lost");
  const events = new EventSource("events");
  // A button that is replaced while it is pressed gives no click: the page waits for the release.
  let pressed = false, parts = {};
  const show = () => {
    if (pressed) return;
    for (const [id, html] of Object.entries(parts)) {
      const box = document.getElementById(id);
      if (!box || box.shown === html) continue;
      const focused = box.contains(document.activeElement) ? document.activeElement.id : "";
      box.innerHTML = html;  // the server has escaped every name, and the page's policy permits no script in it
      box.shown = html;
      if (focused) document.getElementById(focused)?.focus();
    }
  };
  events.addEventListener("live", (event) => {
    lost.hidden = true;
    parts = JSON.parse(event.data);
    show();
  });
  addEventListener("pointerdown", () => { pressed = true; }, true);
  for (const end of ["pointerup", "pointercancel", "blur"])
    addEventListener(end, () => { setTimeout(() => { pressed = false; show(); }); }, true);
  events.addEventListener("error", () => { lost.hidden = false; });
  document.addEventListener("click", async (event) => {
    const button = event.target.closest("button[data-do]");
    if (!button || (button.dataset.sure && !confirm(button.dataset.sure))) return;
    const {do: act, lesson, ...numbers} = button.dataset;
    const body = {do: act};
    if (lesson !== undefined) body.lesson = lesson;
    for (const key of ["step", "question", "task", "student"])
      if (numbers[key] !== undefined) body[key] = Number(numbers[key]);
    try {
      const reply = await fetch("steer", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});
      if (reply.ok && act === "end") window.open("report", "_blank");
    } catch { lost.hidden = false; }
  });
})();
)js";
}

}  // namespace moltact
