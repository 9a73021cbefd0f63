#include "engine/results/lesson_section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/language/quantity_text.h"
#include "engine/results/outcome_sections.h"
#include "engine/results/page_parts.h"

namespace moltact {
namespace {

using namespace page;

InputKind inputOf(const PersonScore& p) { return p.input().value_or(InputKind::Mouse); }

template <class Value>
std::vector<double> sorted(const std::vector<const PersonScore*>& people, Value value) {
  std::vector<double> out;
  for (const PersonScore* p : people) out.push_back(value(*p));
  std::sort(out.begin(), out.end());
  return out;
}

void tile(std::string& out, const std::string& value, const std::string& what) {
  out += "<div class=\"tile\"><b>" + value + "</b><span>" + what + "</span></div>";
}

// A task's measurement as displayed: "mean force, N", and the factor for its values. Attempts hold English names, and
// values in the unit given with them.
struct FigureShown {
  std::string title;
  double factor = 1.0;
};
FigureShown figureShown(const std::string& name, const std::string& unit) {
  const Unit* known = unitNamed(unit);
  const Unit* shown = shownInstead(unit);
  const std::string_view symbol = shown ? shown->symbol : std::string_view(unit);
  return {figureTitle(name) + (symbol.empty() ? std::string() : ", " + std::string(symbol)),
          shown ? known->in_code_units / shown->in_code_units : 1.0};
}

// A histogram of values in the code's unit.
std::string histogramOf(const std::string& title, Dimension dimension, std::vector<Measured> values) {
  for (Measured& m : values) m.value /= shownUnit(dimension)->in_code_units;
  return histogram(title, std::string(unitText(dimension)), std::move(values));
}

std::string legend(const std::vector<PersonScore>& people) {
  std::array<bool, kInputKinds> used{};
  for (const PersonScore& p : people) {
    if (p.input()) used[std::size_t(*p.input())] = true;
    for (std::size_t w = 0; w < kInputKinds; ++w) used[w] = used[w] || p.touch_by_input_s[w] > 0;
  }
  static constexpr std::array kNames{N_("haptic device"), N_("mouse"), N_("keyboard")};
  std::string out = std::string("<div class=\"legend\">") + tr("Way of input:");
  for (std::size_t w = 0; w < kInputKinds; ++w)
    if (used[w]) {
      Svg svg;
      svg.rect(1, 1, 14, 12, "class=\"bar " + inputClass(InputKind(w)) + "\"");
      drawMark(svg, InputKind(w), 24, 7);
      out += "<span>" + std::move(svg).within("viewBox=\"0 0 30 14\" aria-hidden=\"true\"") + tr(kNames[w]) + "</span>";
    }
  return out + "</div>";
}

void tiles(std::string& out, const LessonSummary& lesson) {
  std::vector<const PersonScore*> all;
  std::size_t finished = 0, answers = 0, right = 0;
  for (const PersonScore& p : lesson.people) {
    all.push_back(&p);
    finished += p.finished();
    answers += p.answered();
    right += p.firstRight();
  }
  const std::size_t n = lesson.people.size();
  out += "<div class=\"tiles\">";
  tile(out, trf("{0} of {1}", finished, n), tr("finished"));
  tile(out, percent(quantile(sorted(all, [](const PersonScore& p) { return p.share(); }), 0.5)), tr("done (median)"));
  tile(out, duration(quantile(sorted(all, [](const PersonScore& p) { return p.time_s; }), 0.5)), tr("time (median)"));
  tile(out, answers ? percent(double(right) / double(answers)) : "–", tr("of answers right at the first try"));
  tile(out, duration(quantile(sorted(all, [](const PersonScore& p) { return p.touch_s; }), 0.5)),
       tr("time in touch (median)"));
  out += "</div>";
}

void byWay(std::string& out, const LessonSummary& lesson) {
  std::array<std::vector<const PersonScore*>, kInputKinds> groups;
  for (const PersonScore& p : lesson.people)
    if (p.input()) groups[std::size_t(*p.input())].push_back(&p);
  if (std::count_if(groups.begin(), groups.end(), [](const auto& g) { return !g.empty(); }) < 2) return;
  out += section(tr("By way of input"), {{tr("Most touching with")},
                                         {tr("Students")},
                                         {tr("Finished")},
                                         {tr("Done<br>(median)")},
                                         {tr("Right at<br>first try")},
                                         {tr("Time<br>(median)")},
                                         {trf("Peak force<br>(median), {0}", unitText(Dimension::Force))},
                                         {trf("Mean force<br>(median), {0}", unitText(Dimension::Force))},
                                         {trf("Path<br>(median), {0}", unitText(Dimension::Length))}});
  for (std::size_t w = 0; w < kInputKinds; ++w) {
    const auto& group = groups[w];
    if (group.empty()) continue;
    std::size_t finished = 0, answers = 0, right = 0;
    for (const PersonScore* p : group) finished += p->finished(), answers += p->answered(), right += p->firstRight();
    const auto median = [&](auto value) { return quantile(sorted(group, value), 0.5); };
    out += "<tr><td class=\"name\">" + shownName(InputKind(w)) + "</td><td>" + std::to_string(group.size()) +
           "</td><td>" + std::to_string(finished) + "</td><td>" +
           percent(median([](const PersonScore& p) { return p.share(); })) + "</td><td>" +
           (answers ? percent(double(right) / double(answers)) : "–") + "</td><td>" +
           duration(median([](const PersonScore& p) { return p.time_s; })) + "</td><td>" +
           quantityNumber(median([](const PersonScore& p) { return p.peak_N; }), Dimension::Force, decimals(2)) +
           "</td><td>" +
           quantityNumber(median([](const PersonScore& p) { return p.mean_N; }), Dimension::Force, decimals(2)) +
           "</td><td>" +
           quantityNumber(median([](const PersonScore& p) { return p.path_A; }), Dimension::Length, decimals(0)) +
           "</td></tr>";
  }
  out += "</tbody></table></div>";
}

void peopleTable(std::string& out, const LessonSummary& lesson) {
  out += section(tr("Students"), {{tr("Student")},
                                  {tr("Done"), true},
                                  {tr("Last step"), true},
                                  {tr("Time")},
                                  {tr("Right at<br>first try")},
                                  {tr("Hints")},
                                  {tr("Input"), true}});
  for (const PersonScore& p : lesson.people)
    out +=
        "<tr><td class=\"name\">" + escaped(p.person) +
        (p.attempts > 1 ? "<br><span class=\"quiet small\">" +
                              trnf("{0} attempt", "{0} attempts", p.attempts, p.attempts) + "</span>"
                        : "") +
        "</td><td class=\"left\"><div class=\"doneCell\">" + bar(p.share(), true) + "<span>" + percent(p.share()) +
        "</span></div></td><td class=\"left\">" +
        (p.finished() ? std::string("<span class=\"tick\">✓</span> ") + tr("finished") : escaped(p.last_step)) +
        "</td><td>" + duration(p.time_s) + "</td><td>" +
        (p.answered() == 0 ? "–" : std::to_string(p.firstRight()) + " / " + std::to_string(p.answered())) +
        "</td><td>" + std::to_string(p.hints) + "</td><td class=\"left\">" + escaped(inputsText(p)) +
        (p.gives_force ? "<br><span class=\"quiet small nowrap\">" + escaped(tr(p.device.c_str())) + "</span>" : "") +
        "</td></tr>";
  out += "</tbody></table></div>";
}

// Force and path of each student's touch: not assessed, for comparing ways of input.
void forResearch(std::string& out, const LessonSummary& lesson) {
  out += section(tr("For research: forces and paths"), {{tr("Student")},
                                                        {trf("Touch,<br>{0}", unitText(Dimension::Time))},
                                                        {trf("Peak,<br>{0}", unitText(Dimension::Force))},
                                                        {trf("Mean,<br>{0}", unitText(Dimension::Force))},
                                                        {trf("Path,<br>{0}", unitText(Dimension::Length))}});
  for (const PersonScore& p : lesson.people)
    out += "<tr><td class=\"name\">" + escaped(p.person) + "</td><td>" +
           quantityNumber(p.touch_s, Dimension::Time, decimals(0)) + "</td><td>" +
           quantityNumber(p.peak_N, Dimension::Force, decimals(2)) + "</td><td>" +
           quantityNumber(p.mean_N, Dimension::Force, decimals(2)) + "</td><td>" +
           quantityNumber(p.path_A, Dimension::Length, decimals(0)) + "</td></tr>";
  out += "</tbody></table></div>";
}

// The texts of all students, which only the teacher can assess.
void freeAnswers(std::string& out, const LessonSummary& lesson, const StepOutline& step, const QuestionOutline& q) {
  std::string rows;
  std::size_t answered = 0;
  for (const PersonScore& p : lesson.people) {
    const auto given = p.answers.find({step.id, q.id});
    if (given == p.answers.end()) continue;
    ++answered;
    rows += "<dt>" + escaped(p.person) + "</dt><dd>" + escaped(given->second.written) + "</dd>";
  }
  out += "<div class=\"card\"><div class=\"head\"><b>" + escaped(q.text) + "</b><span>" +
         (answered ? tr("for you to read") : tr("not answered yet")) + "</span></div><div class=\"quiet small\">" +
         trf("{0}. Answered by {1} of {2}.", escaped(step.title), answered, lesson.people.size()) + "</div>" +
         (rows.empty() ? "" : "<dl class=\"texts\">" + rows + "</dl>") + "</div>";
}

// The first answers to one question; for a prediction, the last ones.
void question(std::string& out, const LessonSummary& lesson, const StepOutline& step, const QuestionOutline& q) {
  if (q.kind == AnswerKind::Free) return freeAnswers(out, lesson, step, q);
  const bool marked = q.kind == AnswerKind::Marked;
  std::vector<std::size_t> first(q.choices.size());
  std::map<std::string, std::pair<std::size_t, bool>> written;  // count, and whether right
  std::size_t answered = 0, right = 0, first_right = 0;
  std::array<std::pair<std::size_t, std::size_t>, kInputKinds> ways{};  // right at the first try, and total
  for (const PersonScore& p : lesson.people) {
    const auto given = p.answers.find({step.id, q.id});
    if (given == p.answers.end()) continue;
    const AnswerScore& a = given->second;
    ++answered;
    right += a.right;
    first_right += a.first_right;
    ways[std::size_t(a.by)].first += a.first_right;
    ++ways[std::size_t(a.by)].second;
    for (const std::size_t c : a.chosen)
      if (c < first.size()) ++first[c];
    if (!a.written.empty()) ++written[a.written].first, written[a.written].second = a.first_right;
  }
  out += "<div class=\"card\"><div class=\"head\"><b>" + escaped(q.text) + "</b><span>" +
         (!answered ? tr("not answered yet")
          : marked  ? trf("{0} right at first try", percent(double(first_right) / double(answered)))
                   : trf("{0} predicted this correctly; not scored", percent(double(first_right) / double(answered)))) +
         "</span></div><div class=\"quiet small\">" +
         (marked ? trf("{0}. Answered by {1} of {2}; right in the end: {3}.", escaped(step.title), answered,
                       lesson.people.size(), right)
                 : trf("{0}. Predicted by {1} of {2}, before the touch.", escaped(step.title), answered,
                       lesson.people.size()));
  std::string by;
  for (std::size_t w = 0; w < kInputKinds; ++w)
    if (ways[w].second)
      by += (by.empty() ? "" : ", ") + trf("{0} {1} of {2}", shownName(InputKind(w)), ways[w].first, ways[w].second);
  if (marked && !by.empty()) out += " " + trf("Right at first try by input: {0}.", by);
  if (const auto r = marked ? discrimination(lesson, step.id, q.id) : std::nullopt)
    out += " " + trf("Who was right here was right elsewhere too: r = {0}.", numberText(*r, decimals(2)));
  out += "</div><div class=\"question\">";
  const auto row = [&](bool is_right, const std::string& text, std::size_t n) {
    const double share = answered ? double(n) / double(answered) : 0.0;
    out += "<span class=\"tick\">" + std::string(is_right ? "✓" : "") + "</span><span" +
           (is_right ? " class=\"right\"" : "") + ">" + escaped(text) + "</span>" + bar(share, is_right) +
           "<span class=\"n\">" + std::to_string(n) + (answered ? " · " + percent(share) : "") + "</span>";
  };
  for (std::size_t c = 0; c < q.choices.size(); ++c)
    row(std::find(q.right.begin(), q.right.end(), c) != q.right.end(), q.choices[c], first[c]);
  // Of many different texts, the most frequent ones.
  std::vector<std::pair<std::string, std::pair<std::size_t, bool>>> texts(written.begin(), written.end());
  std::stable_sort(texts.begin(), texts.end(),
                   [](const auto& a, const auto& b) { return a.second.first > b.second.first; });
  constexpr std::size_t kMax = 12;
  for (std::size_t k = 0; k < std::min(kMax, texts.size()); ++k)
    row(texts[k].second.second, texts[k].first, texts[k].second.first);
  out += "</div>";
  if (texts.size() > kMax)
    out += "<p class=\"quiet small\">" + trf("and {0} more, in the CSV", texts.size() - kMax) + "</p>";
  out += "</div>";
}

void questions(std::string& out, const LessonSummary& lesson) {
  bool any = false;
  for (const StepOutline& s : lesson.lesson.steps) any = any || !s.questions.empty();
  if (!any) return;
  out += std::string("<h3>") + tr("Answers by question") + "</h3><p class=\"quiet small\">" +
         tr("The first answer of each student. A full bar with ✓ is right, a hatched bar is not.") + "</p>";
  for (const StepOutline& s : lesson.lesson.steps)
    for (const QuestionOutline& q : s.questions) question(out, lesson, s, q);

  out += std::string("<div class=\"card scroll\"><table class=\"given\"><thead><tr><th>") + tr("Student") + "</th>";
  std::size_t number = 0;
  for (const StepOutline& s : lesson.lesson.steps)
    for (const QuestionOutline& q : s.questions)
      out += "<th title=\"" + escaped(q.text) + "\">" + trf("Q{0}", ++number) + "</th>";
  out += "</tr></thead><tbody>";
  for (const PersonScore& p : lesson.people) {
    out += "<tr><td class=\"name\">" + escaped(p.person) + "</td>";
    for (const StepOutline& s : lesson.lesson.steps)
      for (const QuestionOutline& q : s.questions) {
        const auto a = p.answers.find({s.id, q.id});
        if (a == p.answers.end())
          out += "<td class=\"none\">·</td>";
        else if (q.kind != AnswerKind::Marked)
          out += "<td>✎</td>";
        else if (a->second.first_right)
          out += "<td class=\"ok\">✓</td>";
        else if (a->second.right)
          out += "<td>" + trnf("{0} try", "{0} tries", static_cast<unsigned long>(a->second.tries), a->second.tries) +
                 "</td>";
        else
          out += "<td class=\"no\">✗</td>";
      }
    out += "</tr>";
  }
  out +=
      std::string("</tbody></table><p class=\"quiet small\">") +
      tr("✓ right at the first try, “2 tries” right in the end, ✗ not right, ✎ given and not scored, · not answered. "
         "Questions are in the order above.") +
      "</p></div>";
}

void steps(std::string& out, const LessonSummary& lesson) {
  std::vector<std::pair<const StepOutline*, std::vector<Measured>>> rows;
  double most = 0.0;
  for (const StepOutline& s : lesson.lesson.steps) {
    auto& [step, values] = rows.emplace_back(&s, std::vector<Measured>());
    for (const PersonScore& p : lesson.people)
      if (const auto t = p.step_s.find(s.id); t != p.step_s.end()) values.push_back({t->second / 60.0, inputOf(p)});
    for (const Measured& m : values) most = std::max(most, m.value);
  }
  most = roundAbove(most);
  out +=
      section(tr("Time for each step"), {{tr("Step")}, {tr("Students")}, {tr("Median")}, {tr("Each student"), true}});
  for (const auto& [step, values] : rows) {
    std::vector<double> times;
    for (const Measured& m : values) times.push_back(m.value);
    std::sort(times.begin(), times.end());
    out += "<tr><td>" + escaped(step->title) + "</td><td>" + std::to_string(times.size()) + "</td><td>" +
           (times.empty() ? "–" : duration(60.0 * quantile(times, 0.5))) + "</td><td class=\"left\">" +
           strip(values, most) + "</td></tr>";
  }
  out += "<tr><td></td><td></td><td></td><td class=\"left\">" + stripScale(most, "min") +
         "</td></tr></tbody></table></div>";
}

// The drawn and the felt curve of each student, if the task has any.
std::string taskCurves(const LessonSummary& lesson, const StepOutline& step, std::size_t task) {
  std::string figures;
  bool drawn = false;
  for (const PersonScore& p : lesson.people) {
    const auto score = p.tasks.find({step.id, task});
    if (score == p.tasks.end() || (!score->second.drawn && !score->second.felt)) continue;
    drawn = drawn || score->second.drawn;
    figures += curves(p.person, score->second.drawn.get(), score->second.felt.get());
  }
  if (figures.empty()) return {};
  return std::string("<p class=\"quiet small\">") +
         (drawn ? tr("Force as first drawn (dashed) and as felt in the end (line).") : tr("Force as felt.")) +
         "</p><div class=\"curves\">" + figures + "</div>";
}

void tasks(std::string& out, const LessonSummary& lesson) {
  std::string rows;
  for (const StepOutline& s : lesson.lesson.steps)
    for (std::size_t t = 0; t < s.tasks.size(); ++t) {
      std::size_t begun = 0, done = 0;
      std::vector<std::pair<std::string, std::vector<Measured>>> figures;  // by "name, unit", in the order of first
                                                                           // occurrence
      std::map<std::string, std::size_t> places;
      const auto add = [&](const std::string& name, const std::string& unit, double value, InputKind by) {
        const FigureShown shown = figureShown(name, unit);
        const auto [place, made] = places.try_emplace(shown.title, figures.size());
        if (made) figures.emplace_back(shown.title, std::vector<Measured>());
        figures[place->second].second.push_back({value * shown.factor, by});
      };
      for (const PersonScore& p : lesson.people) {
        const auto score = p.tasks.find({s.id, t});
        if (score == p.tasks.end()) continue;
        begun += score->second.begun || score->second.done;
        done += score->second.done;
        if (!score->second.done) continue;
        if (score->second.figures.empty())
          add("time", std::string(codeUnit(Dimension::Time)), score->second.took_s, score->second.by);
        for (const LoggedFigure& f : score->second.figures)
          if (std::isfinite(f.value)) add(f.name, f.unit, f.value, score->second.by);
      }
      rows += "<div class=\"card\"><div class=\"head\"><b>" +
              escaped(s.tasks[t].say.empty() ? s.tasks[t].kind : s.tasks[t].say) + "</b><span>" +
              trf("done by {0} of {1}", done, begun) + "</span></div><div class=\"quiet small\">" + escaped(s.title) +
              ", " + escaped(s.tasks[t].kind) + "</div>";
      if (!figures.empty()) {
        rows +=
            "<div class=\"scroll\">" +
            tableHead({{tr("Figure")}, {tr("Median")}, {tr("Middle half")}, {tr("Range")}, {tr("Each student"), true}});
        for (const auto& [name, values] : figures) {
          std::vector<double> v;
          for (const Measured& m : values) v.push_back(m.value);
          std::sort(v.begin(), v.end());
          const double most = roundAbove(v.back());
          const int digits = most >= 50 ? 0 : most >= 5 ? 1 : most >= 0.05 ? 2 : 3;
          rows += "<tr><td>" + escaped(name) + "</td><td>" + number(quantile(v, 0.5), digits) + "</td><td>" +
                  number(quantile(v, 0.25), digits) + " – " + number(quantile(v, 0.75), digits) + "</td><td>" +
                  number(v.front(), digits) + " – " + number(v.back(), digits) + "</td><td class=\"left\">" +
                  strip(values, most) + stripScale(most, "") + "</td></tr>";
        }
        rows += "</tbody></table></div>";
      }
      rows += taskCurves(lesson, s, t) + "</div>";
    }
  if (!rows.empty()) out += std::string("<h3>") + tr("Touch tasks") + "</h3>" + rows;
}

void forces(std::string& out, const LessonSummary& lesson) {
  std::vector<Measured> peak, mean, path, touch, minutes, right;
  for (const PersonScore& p : lesson.people) {
    minutes.push_back({p.time_s / 60.0, inputOf(p)});
    if (p.answered() > 0) right.push_back({double(p.firstRight()), inputOf(p)});
    if (!p.touches) continue;
    peak.push_back({p.peak_N, inputOf(p)});
    mean.push_back({p.mean_N, inputOf(p)});
    path.push_back({p.path_A, inputOf(p)});
    touch.push_back({p.touch_s, inputOf(p)});
  }
  out += std::string("<h3>") + tr("Time, force and path") + "</h3><div class=\"histograms\">" +
         histogram(tr("Time for the lesson"), "min", minutes) +
         histogram(tr("Answers right at the first try"), "", right) +
         histogramOf(tr("Time in touch"), Dimension::Time, touch) +
         histogramOf(tr("Peak force"), Dimension::Force, peak) +
         histogramOf(tr("Mean force while touching"), Dimension::Force, mean) +
         histogramOf(tr("Path over the surface"), Dimension::Length, path) + "</div>";
}

void predictions(std::string& out, const LessonSummary& lesson) {
  std::string rows;
  for (const PersonScore& p : lesson.people)
    for (const Predicted& guess : p.predictions)
      rows += "<tr><td class=\"name\">" + escaped(guess.student) + "</td><td class=\"left\">" +
              escaped(guess.question) + "</td><td class=\"left\">" + escaped(guess.text) + "</td><td class=\"left\">" +
              escaped(p.person) + "</td></tr>";
  if (!rows.empty())
    out += section(
               tr("Predictions of those who waited"),
               {{tr("Student")}, {tr("Question"), true}, {tr("Prediction"), true}, {tr("While at the device"), true}}) +
           rows + "</tbody></table></div>";
}

}  // namespace

void lessonSection(std::string& out, const LessonSummary& lesson, bool first) {
  out += "<h2" + std::string(first ? " class=\"first\"" : "") + ">" + escaped(lesson.lesson.title) +
         "</h2><p class=\"quiet small\">" +
         (lesson.versions > 1 ? trf("{0}, in {1} versions: questions and tasks are those of the last",
                                    escaped(lesson.lesson.file), lesson.versions)
                              : escaped(lesson.lesson.file)) +
         "</p>";
  tiles(out, lesson);
  peopleTable(out, lesson);
  out += goalSection(lesson) + gainSection(lesson) + misconceptionSection(lesson);
  byWay(out, lesson);
  questions(out, lesson);
  out += legend(lesson.people);
  steps(out, lesson);
  forces(out, lesson);
  tasks(out, lesson);
  predictions(out, lesson);
  out += waySection(lesson);
  forResearch(out, lesson);
}

}  // namespace moltact
