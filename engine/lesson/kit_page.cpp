#include "engine/lesson/kit_page.h"

#include <algorithm>
#include <string_view>

#include "engine/core/markup.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/class_plan.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/kit_parts.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/reader.h"

namespace moltact {
namespace kit {

std::string html(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) {
    std::string piece;
    for (std::size_t from = 0; from <= run.text.size();) {
      const std::size_t end = std::min(run.text.find('\n', from), run.text.size());
      piece += (from ? "<br>" : "") + escaped(std::string_view(run.text).substr(from, end - from));
      from = end + 1;
    }
    const auto wrapped = [&](bool on, const char* tag) {
      if (on) piece = std::string("<") + tag + ">" + piece + "</" + tag + ">";
    };
    wrapped(run.script == Script::Sub, "sub");
    wrapped(run.script == Script::Super, "sup");
    wrapped(run.code, "code");
    wrapped(run.italic, "i");
    wrapped(run.bold, "b");
    if (linkScheme(run.link).starts_with("http")) piece = "<a href=\"" + escaped(run.link) + "\">" + piece + "</a>";
    out += piece;
  }
  return out;
}

}  // namespace kit

namespace {

using kit::html;
using kit::letter;

std::string_view kitStyle() {
  return R"css(
*{box-sizing:border-box}
html{background:#e6e9ed}
body{margin:0;color:#111;font:14px/1.42 Inter,system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif;font-variant-numeric:tabular-nums}
.sheet{background:#fff;max-width:210mm;margin:8mm auto;padding:14mm}
h1{font-size:20px;line-height:1.2;margin:0 0 6px}h2{font-size:15px;line-height:1.25;margin:14px 0 3px;break-after:avoid}h3{font-size:1em;margin:7px 0 1px;break-after:avoid}
p{margin:4px 0}ul{margin:2px 0;padding-left:1.2em}li{margin:1px 0}
.part{margin:0;text-transform:uppercase;letter-spacing:.06em;font-size:11px;font-weight:600;color:#444}
.quiet{color:#444}
table{border-collapse:collapse;width:100%;margin:4px 0}th,td{text-align:left;vertical-align:top;padding:3px 6px 3px 0;border-top:1px solid #bbb}th{font-weight:600}
thead{display:table-header-group}tr{break-inside:avoid}td.min{white-space:nowrap}td p{margin:0 0 2px}
.teacher{font-size:12px;line-height:1.36}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 7mm}.pair h2:first-child{margin-top:10px}
.answers{columns:2;column-gap:7mm}.answers>div{break-inside:avoid;margin-bottom:5px}
.answers p{margin:0}.right::before{content:"✓ "}.wrong{padding-left:1.1em;text-indent:-1.1em}.wrong::before{content:"✗ "}
.name{display:flex;gap:8mm;margin:8px 0 10px}.name span{flex:1;border-bottom:1px solid #555;padding-bottom:1px;color:#444;font-size:12px}.name span:first-child{flex:3}
.ask{break-inside:avoid;margin:7px 0}
.boxes{list-style:none;padding-left:4px}.boxes li{margin:3px 0;padding-left:22px;text-indent:-22px}
.boxes li::before,.box{content:"";display:inline-block;width:11px;height:11px;border:1.3px solid #222;border-radius:2px;margin-right:9px;vertical-align:-1px}
.box{margin:0 4px 0 12px}.letter{font-weight:600;display:inline-block;min-width:14px;text-indent:0}
.because{border-bottom:1px solid #888;margin:9px 0 3px;color:#444;font-size:12px}
.line{border-bottom:1px solid #888;height:25px}
.blank{display:inline-block;width:16mm;border-bottom:1px solid #555}.blank.long{width:70mm}
.record{display:grid;grid-template-columns:5.2em 1fr;break-inside:avoid;margin:2px 0}.record p{margin:7px 0 2px}.record .because{margin-top:9px}.record>b{padding-top:6px}
.axes{display:block;width:75mm;height:30mm;border-left:1.5px solid #222;border-bottom:1.5px solid #222;position:relative;margin:4px 0 20px}
.axes span{position:absolute;font-size:11px;color:#444}.axes span:first-child{top:-3px;left:6px}.axes span:last-child{right:0;bottom:-18px}
.word{display:flex;margin:0}.word span{min-width:44mm}.word::after{content:"";flex:1;border-bottom:1px solid #888;height:25px}
.tickets{padding-top:0;padding-bottom:0}.ticket{break-inside:avoid;padding:9mm 0}.ticket+.ticket{border-top:1.5px dashed #777}
@page{margin:11mm 13mm}
@media print{html{background:none}body{font-size:10.2pt}.sheet{max-width:none;margin:0;padding:0}.sheet+.sheet{break-before:page}.teacher{font-size:8.6pt;line-height:1.3}
.fresh{break-before:page}.ticket{min-height:122mm;padding:6mm 0}.ticket+.ticket{padding-top:8mm}a{color:inherit;text-decoration:none}}
)css";
}

void list(std::string& out, const std::string& heading, const std::vector<RichText>& items) {
  if (items.empty()) return;
  out += "<div><h2>" + heading + "</h2><ul>";
  for (const RichText& item : items) out += "<li>" + html(item) + "</li>";
  out += "</ul></div>";
}

void prompts(std::string& out, const TeachersKit& kit, std::string_view step) {
  for (const KitPrompt& p : kit.prompts)
    if (p.step == step)
      out += "<p>" + html(p.question) + (p.answer.empty() ? "" : " <i>" + html(p.answer) + "</i>") + "</p>";
}

void timeLine(std::string& out, const Lesson& lesson, const TeachersKit& kit) {
  const std::vector<PlanRow> plan = classPlan(lesson);
  out += "<h2>" + trf("Time line for {0} minutes", std::max(kClassMinutes, minutesOf(plan))) +
         "</h2><table><thead><tr><th>" + tr("Minutes") + "</th><th>" + tr("Step") + "</th><th>" +
         tr("What the hand does") + "</th><th>" + tr("What to ask, and the expected answer") +
         "</th></tr></thead><tbody>";
  int number = 0;
  for (const PlanRow& row : plan) {
    out += "<tr><td class=\"min\">" + std::to_string(row.from_min) + "–" + std::to_string(row.from_min + row.minutes) +
           "</td><td>";
    switch (row.kind) {
      case PlanRow::Kind::Opening:
        out += std::string("<b>") + tr("Opening") + "</b></td><td colspan=\"2\">" +
               tr("The question of the lesson, read aloud. What does the class expect? The worksheets are handed out; "
                  "each prediction "
                  "is made when its step comes, before the touch.");
        break;
      case PlanRow::Kind::Step: {
        const Step& step = lesson.steps[row.step];
        out += "<b>" + std::to_string(++number) + " " + escaped(step.title) + "</b></td><td>";
        for (const TaskSpec& task : step.tasks) out += "<p>" + escaped(task.values["say"].text) + "</p>";
        out += "</td><td>";
        prompts(out, kit, step.id);
        break;
      }
      case PlanRow::Kind::Talk:
        out += std::string("<b>") + tr("Talk") + "</b></td><td colspan=\"2\">" +
               tr("What did the hand find that the eye did not expect? The class compares its worksheets, question by "
                  "question.");
        break;
      case PlanRow::Kind::Ticket:
        out += std::string("<b>") + tr("Exit ticket") + "</b></td><td colspan=\"2\">" +
               tr("Each student alone, with the program closed.");
        break;
    }
    out += "</td></tr>";
  }
  out += "</tbody></table>";
  std::string extra;
  for (const Step& step : lesson.steps)
    if (step.extra) extra += (extra.empty() ? "" : "; ") + escaped(step.title);
  if (!extra.empty()) out += "<p>" + trf("For students who finish early: {0}.", extra) + "</p>";
}

// The expected answer, and what each wrong choice stands for: its tag, else its feedback.
void expectedAnswer(std::string& out, const Question& question) {
  out += "<div><p><b>" + html(question.title) + "</b></p>";
  for (const Choice& c : question.choices)
    if (c.right) out += "<p class=\"right\">" + html(c.text) + "</p>";
  for (const Choice& c : question.choices)
    if (!c.right)
      out += "<p class=\"wrong\">" + html(c.text) + " – <i>" + (c.tag.empty() ? html(c.feedback) : escaped(c.tag)) +
             "</i></p>";
  if (const auto& answer = question.answer) {
    std::string expected;
    if (answer->kind == AnswerSpec::Kind::Free)
      expected = answer->model;
    else if (answer->kind == AnswerSpec::Kind::Text)
      expected = answer->texts.empty() ? std::string() : answer->texts.front();
    else
      expected = numberText(answer->number) + (answer->unit.empty() ? "" : "\u00a0" + answer->unit);
    if (!expected.empty()) out += "<p class=\"right\">" + escaped(expected) + "</p>";
  }
  out += "</div>";
}

void ticketKey(std::string& out, const TeachersKit& kit) {
  if (kit.exit_ticket.empty()) return;
  out += std::string("<h2>") + tr("Key to the exit ticket") + "</h2>";
  for (std::size_t k = 0; k < kit.exit_ticket.size(); ++k) {
    const std::vector<Choice>& choices = kit.exit_ticket[k].choices;
    std::string right, wrong;
    for (std::size_t c = 0; c < choices.size(); ++c) {
      if (choices[c].right)
        right += (right.empty() ? "" : ", ") + letter(c);
      else if (!choices[c].feedback.empty())
        wrong += (wrong.empty() ? "" : "; ") + letter(c) + ": " + html(choices[c].feedback);
    }
    out += "<p><b>" + std::to_string(k + 1) + " " + right + "</b>" + (wrong.empty() ? "" : " – " + wrong) + "</p>";
  }
}

void teachersPage(std::string& out, const Lesson& lesson, const TeachersKit& kit) {
  out += "<section class=\"sheet teacher\"><p class=\"part\">" + std::string(tr("For the teacher")) + "</p><h1>" +
         escaped(lesson.title) + "</h1><p>" + escaped(lesson.description) + "</p><p class=\"quiet\">";
  std::string molecules;
  for (const std::string& m : lesson.molecules) molecules += (molecules.empty() ? "" : ", ") + escaped(m);
  const ShownMinutes minutes = shownMinutes(lesson);
  out += trf("One student alone needs about {0} minutes for the core, with all steps {1}. Molecules: {2}.",
             minutes.core, minutes.all, molecules) +
         "</p><div class=\"pair\">";
  if (!lesson.goals.empty()) {
    out += std::string("<div><h2>") + tr("Goals") + "</h2><ul>";
    for (const std::string& goal : lesson.goals) out += "<li>" + escaped(goal) + "</li>";
    out += "</ul></div>";
  }
  list(out, tr("Prior knowledge"), kit.prior_knowledge);
  out += "</div>";
  timeLine(out, lesson, kit);
  out += "<div class=\"pair\">";
  list(out, tr("What touch shows that a picture does not"), kit.touch_shows);
  list(out, tr("Limits of the model"), kit.limits);
  out += "</div>";
  std::string answers;
  for (const Step& step : lesson.steps)
    if (!step.aside)
      for (const Question& q : step.questions) expectedAnswer(answers, q);
  if (!answers.empty())
    out += std::string("<h2>") + tr("Expected answers, and what each wrong choice stands for") +
           "</h2><div class=\"answers\">" + answers + "</div>";
  ticketKey(out, kit);
  if (const auto words = kit::worksheetWords(lesson); !words.empty()) {
    out += std::string("<h2>") + tr("Words of the worksheet") + "</h2>";
    for (const GlossaryWord* w : words) out += "<p><b>" + escaped(w->word) + "</b>: " + html(w->meaning) + "</p>";
  }
  if (kit.curriculum.empty())
    out += std::string("<p class=\"quiet\">") +
           tr("Curriculum codes: none. This page names a code only with the source that it was checked against.") +
           "</p>";
  else
    list(out, tr("Curriculum"), kit.curriculum);
  out += "</section>";
}

}  // namespace

std::string kitPage(const Lesson& lesson, const TeachersKit& kit, KitFor whom) {
  const std::string kind = whom == KitFor::Teacher ? tr("Teacher's kit") : tr("Worksheet");
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + escaped(lesson.language.empty() ? language() : lesson.language) +
                    "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, "
                    "initial-scale=1\"><meta name=\"generator\" content=\"Moltact\"><title>" +
                    escaped(lesson.title) + " – " + kind + "</title><style>" + std::string(kitStyle()) +
                    "</style></head><body>";
  if (whom == KitFor::Teacher) teachersPage(out, lesson, kit);
  kit::worksheet(out, lesson);
  kit::exitTicket(out, lesson, kit);
  out += "</body></html>\n";
  return out;
}

Expected<std::string> kitPageOf(const std::filesystem::path& lesson_file, KitFor whom) {
  LessonReading reading = readLesson(lesson_file.string());
  if (!reading.lesson) return reading.errors.front();
  Lesson lesson = *std::move(reading.lesson);
  if (lesson.language.empty()) lesson.language = lessonName(lesson_file).language;
  linkWords(lesson, glossaryBeside(lesson_file, lesson.language));
  return kitPage(lesson, kitOf(lesson_file), whom);
}

std::string kitPageName(const std::filesystem::path& lesson_file, KitFor whom) {
  return lesson_file.stem().string() + (whom == KitFor::Teacher ? ".kit.html" : ".worksheet.html");
}

}  // namespace moltact
