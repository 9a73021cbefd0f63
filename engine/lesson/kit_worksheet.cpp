// The students' part of a teacher's kit: worksheet and exit ticket.
#include <algorithm>
#include <cstdint>

#include "engine/core/markup.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/kit_parts.h"
#include "engine/lesson/reader.h"

namespace moltact::kit {
namespace {

constexpr std::size_t kMaxWords = 6;

std::string nameLine() {
  return std::string("<p class=\"name\"><span>") + tr("Name") + "</span><span>" + trc("of a day", "Date") +
         "</span></p>";
}

std::string lines(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += "<div class=\"line\"></div>";
  return out;
}

// FNV-1a, for an order of choices that is the same on every computer.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

void prediction(std::string& out, const Question& question, const std::string& number) {
  out += "<div class=\"ask\"><p><b>" + number + "</b> " + html(question.title) + "</p>";
  for (const RichText& p : question.prompt) out += "<p>" + html(p) + "</p>";
  std::vector<const Choice*> choices;
  for (const Choice& c : question.choices) choices.push_back(&c);
  if (!question.in_order)
    std::stable_sort(choices.begin(), choices.end(), [&](const Choice* a, const Choice* b) {
      return hashOf(question.id + plainText(a->text)) < hashOf(question.id + plainText(b->text));
    });
  if (choices.empty()) {
    out += lines(2) + "</div>";
    return;
  }
  out += "<ul class=\"boxes\">";
  for (const Choice* c : choices) out += "<li>" + html(c->text) + "</li>";
  out += "</ul><p class=\"because\">" + std::string(tr("because")) + "</p></div>";
}

// What to write down of a task that gives a result; empty if it gives none.
std::string resultLine(const TaskSpec& task) {
  constexpr const char* kBlank = "<i class=\"blank\"></i>";
  const std::string with_length = kBlank + std::string(" ") + std::string(unitText(Dimension::Length));
  if (task.kind == "same") {
    const bool told = task.values["asked"].text != "before" && task.values["tell"].text != "no";
    return told ? trf("In the dark: {0} of {1} right", kBlank, int(task.values["trials"].number))
                : std::string(tr("In the dark: how sure was I?")) + " <span class=\"box\"></span> " + tr("sure") +
                      " <span class=\"box\"></span> " + tr("unsure");
  }
  if (task.kind == "order" || task.kind == "rank")
    return trf("My order in the dark: {0}", "<i class=\"blank long\"></i>");
  if (task.kind == "fit") return trf("The largest probe that got there: {0}", with_length);
  if (task.kind == "measure") return trf("Measured: {0}", with_length);
  if (task.kind == "find") return trf("Found in the dark after {0} tries", kBlank);
  if (task.kind == "predict")
    return std::string("<span class=\"axes\"><span>") + tr("force") + "</span><span>" + tr("way of the hand") +
           "</span></span>";
  return {};
}

void record(std::string& out, const Step& step, int number) {
  out += "<div class=\"record\"><b>" + trf("Step {0}", number) + "</b><div>";
  bool felt = false;
  for (const TaskSpec& task : step.tasks) {
    const std::string line = resultLine(task);
    if (line.empty())
      felt = true;
    else
      out += "<p>" + line + "</p>";
  }
  if (felt || step.tasks.empty()) out += "<p class=\"because\">" + std::string(tr("My hand felt")) + "</p>";
  out += "</div></div>";
}

void question(std::string& out, const Question& question, const std::string& number) {
  out += "<div class=\"ask\"><p><b>" + number + "</b> " + html(question.title) + "</p>";
  for (const RichText& p : question.prompt) out += "<p>" + html(p) + "</p>";
  out += lines(question.free() ? 4 : 1) + "</div>";
}

// All texts that would answer a question of the core.
std::string answersOf(const Lesson& lesson) {
  std::string out;
  for (const Step& step : lesson.steps) {
    if (step.aside) continue;
    for (const Question& q : step.questions) {
      for (const Choice& c : q.choices)
        if (c.right) out += plainText(c.text) + "\n";
      if (q.answer)
        for (const std::string& text : q.answer->texts) out += text + "\n";
    }
  }
  return lower(out);
}

}  // namespace

std::string letter(std::size_t choice) { return std::string(1, char('a' + choice % 26)); }

std::vector<const GlossaryWord*> worksheetWords(const Lesson& lesson) {
  const std::string answers = answersOf(lesson);
  std::vector<const GlossaryWord*> out;
  const auto take = [&](const RichText& text) {
    for (const TextRun& run : text) {
      const auto id = wordLink(run.link);
      const GlossaryWord* word = id ? findWord(lesson, *id) : nullptr;
      if (!word || out.size() == kMaxWords || std::find(out.begin(), out.end(), word) != out.end()) continue;
      bool answer = answers.find(lower(word->word)) != std::string::npos;
      for (const std::string& other : word->others) answer = answer || answers.find(lower(other)) != std::string::npos;
      if (!answer) out.push_back(word);
    }
  };
  const auto in = [&](const std::vector<Block>& blocks) {
    for (const Block& b : blocks) {
      if (const auto* p = std::get_if<Paragraph>(&b)) take(p->text);
      if (const auto* l = std::get_if<ListBlock>(&b))
        for (const ListBlock::Item& item : l->items) take(item.text);
    }
  };
  in(lesson.introduction);
  for (const Step& step : lesson.steps)
    if (!step.aside) in(step.blocks);
  return out;
}

void worksheet(std::string& out, const Lesson& lesson) {
  out += "<section class=\"sheet\"><p class=\"part\">" + std::string(tr("Worksheet")) + "</p><h1>" +
         escaped(lesson.title) + "</h1>" + nameLine();
  for (const Block& b : lesson.introduction)
    if (const auto* p = std::get_if<Paragraph>(&b)) out += "<p>" + html(p->text) + "</p>";
  std::string predictions, records, questions;
  int number = 0;
  for (const Step& step : lesson.steps) {
    if (step.aside) continue;
    ++number;
    record(records, step, number);
    std::size_t of_step = 0;
    for (const Question& q : step.questions) {
      // "3 b": the second question of step 3.
      const std::string name = std::to_string(number) + (step.questions.size() > 1 ? letter(of_step) : "");
      ++of_step;
      if (q.prediction)
        prediction(predictions, q, name);
      else
        question(questions, q, name);
    }
  }
  if (!predictions.empty())
    out += std::string("<h2>") + tr("Before you touch") + "</h2><p class=\"quiet\">" +
           tr("What do you expect? Decide when you come to the step of this number. No answer is wrong yet.") + "</p>" +
           predictions;
  out += std::string("<h2>") + tr("What your hand finds") + "</h2>" + records;
  if (!questions.empty())
    out += std::string("<div class=\"fresh\"><h2>") + tr("Afterwards") + "</h2><p class=\"quiet\">" +
           tr("In your own words. Say what your hand felt.") + "</p>" + questions;
  if (const auto words = worksheetWords(lesson); !words.empty()) {
    out += std::string("<h2>") + tr("Words") + "</h2><p class=\"quiet\">" + tr("What does each of them mean?") + "</p>";
    for (const GlossaryWord* w : words) out += "<p class=\"word\"><span>" + escaped(w->word) + "</span></p>";
  }
  if (!questions.empty()) out += "</div>";
  out += "</section>";
}

void exitTicket(std::string& out, const Lesson& lesson, const TeachersKit& kit) {
  if (kit.exit_ticket.empty()) return;
  std::string ticket = "<div class=\"ticket\"><p class=\"part\">" + std::string(tr("Exit ticket")) + "</p><h1>" +
                       escaped(lesson.title) + "</h1>" + nameLine();
  for (std::size_t k = 0; k < kit.exit_ticket.size(); ++k) {
    const Question& q = kit.exit_ticket[k];
    ticket +=
        "<div class=\"ask\"><p><b>" + std::to_string(k + 1) + "</b> " + html(q.title) + "</p><ul class=\"boxes\">";
    for (std::size_t c = 0; c < q.choices.size(); ++c)
      ticket += "<li><span class=\"letter\">" + letter(c) + "</span> " + html(q.choices[c].text) + "</li>";
    ticket += "</ul></div>";
  }
  ticket += "</div>";
  out += "<section class=\"sheet tickets\">" + ticket + ticket + "</section>";
}

}  // namespace moltact::kit
