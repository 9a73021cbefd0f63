#include "engine/results/lesson_section.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/results/page_parts.h"

namespace moltact {
namespace {

using namespace page;

InputWay wayOf(const PersonScore& p) { return p.way().value_or(InputWay::Mouse); }

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

std::string legend(const std::vector<PersonScore>& people) {
  std::array<bool, kWays> used{};
  for (const PersonScore& p : people) {
    if (p.way()) used[std::size_t(*p.way())] = true;
    for (std::size_t w = 0; w < kWays; ++w) used[w] = used[w] || p.touch_ways_s[w] > 0;
  }
  static constexpr std::array kMarks{
      "<circle cx=\"24\" cy=\"7\" r=\"3.2\" class=\"mark way-device\"/>",
      "<rect x=\"21.2\" y=\"4.2\" width=\"5.6\" height=\"5.6\" class=\"mark way-mouse\"/>",
      "<path d=\"M24 3.6l3.4 6h-6.8z\" class=\"mark way-keyboard\"/>"};
  static constexpr std::array kNames{"haptic device", "mouse", "keyboard"};
  std::string out = "<div class=\"legend\">Way of input:";
  for (std::size_t w = 0; w < kWays; ++w)
    if (used[w])
      out +=
          "<span><svg viewBox=\"0 0 30 14\" aria-hidden=\"true\"><rect x=\"1\" y=\"1\" width=\"14\" height=\"12\" "
          "class=\"bar " +
          wayClass(InputWay(w)) + "\"/>" + kMarks[w] + "</svg>" + kNames[w] + "</span>";
  return out + "</div>";
}

void tiles(std::string& out, const LessonSummary& lesson) {
  std::vector<const PersonScore*> all;
  std::size_t finished = 0, answers = 0, right = 0;
  for (const PersonScore& p : lesson.people) {
    all.push_back(&p);
    finished += p.finished();
    answers += p.answers.size();
    right += p.firstRight();
  }
  const std::size_t n = lesson.people.size();
  out += "<div class=\"tiles\">";
  tile(out, std::to_string(finished) + " of " + std::to_string(n), "finished");
  tile(out, percent(quantile(sorted(all, [](const PersonScore& p) { return p.share(); }), 0.5)), "done (median)");
  tile(out, duration(quantile(sorted(all, [](const PersonScore& p) { return p.time_s; }), 0.5)), "time (median)");
  tile(out, answers ? percent(double(right) / double(answers)) : "–", "of answers right at the first try");
  tile(out, duration(quantile(sorted(all, [](const PersonScore& p) { return p.touch_s; }), 0.5)),
       "time in touch (median)");
  out += "</div>";
}

void byWay(std::string& out, const LessonSummary& lesson) {
  std::array<std::vector<const PersonScore*>, kWays> groups;
  for (const PersonScore& p : lesson.people)
    if (p.way()) groups[std::size_t(*p.way())].push_back(&p);
  if (std::count_if(groups.begin(), groups.end(), [](const auto& g) { return !g.empty(); }) < 2) return;
  out +=
      "<h3>By way of input</h3><div class=\"card scroll\"><table><thead><tr><th>Most touching "
      "with</th><th>Students</th><th>Finished</th><th>Done<br>(median)</th><th>Right at<br>first try</th>"
      "<th>Time<br>(median)</th><th>Peak force<br>(median), N</th><th>Mean force<br>(median), "
      "N</th><th>Path<br>(median), Å</th></tr></thead><tbody>";
  for (std::size_t w = 0; w < kWays; ++w) {
    const auto& group = groups[w];
    if (group.empty()) continue;
    std::size_t finished = 0, answers = 0, right = 0;
    for (const PersonScore* p : group)
      finished += p->finished(), answers += p->answers.size(), right += p->firstRight();
    const auto median = [&](auto value) { return quantile(sorted(group, value), 0.5); };
    out += "<tr><td class=\"name\">" + std::string(nameOf(InputWay(w))) + "</td><td>" + std::to_string(group.size()) +
           "</td><td>" + std::to_string(finished) + "</td><td>" +
           percent(median([](const PersonScore& p) { return p.share(); })) + "</td><td>" +
           (answers ? percent(double(right) / double(answers)) : "–") + "</td><td>" +
           duration(median([](const PersonScore& p) { return p.time_s; })) + "</td><td>" +
           number(median([](const PersonScore& p) { return p.peak_N; }), 2) + "</td><td>" +
           number(median([](const PersonScore& p) { return p.mean_N; }), 2) + "</td><td>" +
           number(median([](const PersonScore& p) { return p.path_A; }), 0) + "</td></tr>";
  }
  out += "</tbody></table></div>";
}

void peopleTable(std::string& out, const LessonSummary& lesson) {
  out +=
      "<h3>Students</h3><div class=\"card scroll\"><table><thead><tr><th>Student</th><th class=\"left\">Done</th><th "
      "class=\"left\">Last step</th><th>Time</th><th>Right at<br>first try</th><th>Hints</th>"
      "<th>Touch,<br>s</th><th>Peak,<br>N</th><th>Mean,<br>N</th><th>Path,<br>Å</th><th "
      "class=\"left\">Input</th></tr></thead><tbody>";
  for (const PersonScore& p : lesson.people)
    out +=
        "<tr><td class=\"name\">" + escaped(p.person) +
        (p.attempts > 1 ? "<br><span class=\"quiet small\">" + std::to_string(p.attempts) + " attempts</span>" : "") +
        "</td><td class=\"left\"><div class=\"doneCell\">" + bar(p.share(), true) + "<span>" + percent(p.share()) +
        "</span></div></td><td class=\"left\">" +
        (p.finished() ? "<span class=\"tick\">✓</span> finished" : escaped(p.last_step)) + "</td><td>" +
        duration(p.time_s) + "</td><td>" +
        (p.answers.empty() ? "–" : std::to_string(p.firstRight()) + " / " + std::to_string(p.answers.size())) +
        "</td><td>" + std::to_string(p.hints) + "</td><td>" + number(p.touch_s, 0) + "</td><td>" + number(p.peak_N, 2) +
        "</td><td>" + number(p.mean_N, 2) + "</td><td>" + number(p.path_A, 0) + "</td><td class=\"left\">" +
        escaped(waysText(p)) +
        (p.gives_force ? "<br><span class=\"quiet small nowrap\">" + escaped(p.device) + "</span>" : "") + "</td></tr>";
  out += "</tbody></table></div>";
}

// What was answered first to one question.
void question(std::string& out, const LessonSummary& lesson, const StepOutline& step, const QuestionOutline& q) {
  std::vector<std::size_t> first(q.choices.size());
  std::map<std::string, std::pair<std::size_t, bool>> written;  // how often, and whether right
  std::size_t answered = 0, right = 0, first_right = 0;
  std::array<std::pair<std::size_t, std::size_t>, kWays> ways{};  // right at first try, of
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
         (answered ? percent(double(first_right) / double(answered)) + " right at first try" : "not answered yet") +
         "</span></div><div class=\"quiet small\">" + escaped(step.title) + ". Answered by " +
         std::to_string(answered) + " of " + std::to_string(lesson.people.size()) +
         "; right in the end: " + std::to_string(right) + ".";
  std::string by;
  for (std::size_t w = 0; w < kWays; ++w)
    if (ways[w].second)
      by += (by.empty() ? "" : ", ") + std::string(nameOf(InputWay(w))) + " " + std::to_string(ways[w].first) + " of " +
            std::to_string(ways[w].second);
  if (!by.empty()) out += " Right at first try by input: " + by + ".";
  out += "</div><div class=\"question\">";
  const auto row = [&](bool is_right, const std::string& text, std::size_t n) {
    const double share = answered ? double(n) / double(answered) : 0.0;
    out += "<span class=\"tick\">" + std::string(is_right ? "✓" : "") + "</span><span" +
           (is_right ? " class=\"right\"" : "") + ">" + escaped(text) + "</span>" + bar(share, is_right) +
           "<span class=\"n\">" + std::to_string(n) + (answered ? " · " + percent(share) : "") + "</span>";
  };
  for (std::size_t c = 0; c < q.choices.size(); ++c)
    row(std::find(q.right.begin(), q.right.end(), c) != q.right.end(), q.choices[c], first[c]);
  // Many different texts: the most frequent ones.
  std::vector<std::pair<std::string, std::pair<std::size_t, bool>>> texts(written.begin(), written.end());
  std::stable_sort(texts.begin(), texts.end(),
                   [](const auto& a, const auto& b) { return a.second.first > b.second.first; });
  constexpr std::size_t kMost = 12;
  for (std::size_t k = 0; k < std::min(kMost, texts.size()); ++k)
    row(texts[k].second.second, texts[k].first, texts[k].second.first);
  out += "</div>";
  if (texts.size() > kMost)
    out += "<p class=\"quiet small\">and " + std::to_string(texts.size() - kMost) + " more, in the CSV</p>";
  out += "</div>";
}

void questions(std::string& out, const LessonSummary& lesson) {
  bool any = false;
  for (const StepOutline& s : lesson.lesson.steps) any = any || !s.questions.empty();
  if (!any) return;
  out +=
      "<h3>Answers by question</h3><p class=\"quiet small\">The first answer of each student. A full bar with ✓ is "
      "right, a hatched bar is not.</p>";
  for (const StepOutline& s : lesson.lesson.steps)
    for (const QuestionOutline& q : s.questions) question(out, lesson, s, q);

  out += "<div class=\"card scroll\"><table class=\"given\"><thead><tr><th>Student</th>";
  std::size_t number = 0;
  for (const StepOutline& s : lesson.lesson.steps)
    for (const QuestionOutline& q : s.questions)
      out += "<th title=\"" + escaped(q.text) + "\">Q" + std::to_string(++number) + "</th>";
  out += "</tr></thead><tbody>";
  for (const PersonScore& p : lesson.people) {
    out += "<tr><td class=\"name\">" + escaped(p.person) + "</td>";
    for (const StepOutline& s : lesson.lesson.steps)
      for (const QuestionOutline& q : s.questions) {
        const auto a = p.answers.find({s.id, q.id});
        if (a == p.answers.end())
          out += "<td class=\"none\">·</td>";
        else if (a->second.first_right)
          out += "<td class=\"ok\">✓</td>";
        else if (a->second.right)
          out += "<td>" + std::to_string(a->second.tries) + " tries</td>";
        else
          out += "<td class=\"no\">✗</td>";
      }
    out += "</tr>";
  }
  out +=
      "</tbody></table><p class=\"quiet small\">✓ right at the first try, “2 tries” right in the end, ✗ not right, · "
      "not answered. Questions are in the order above.</p></div>";
}

void steps(std::string& out, const LessonSummary& lesson) {
  std::vector<std::pair<const StepOutline*, std::vector<Measured>>> rows;
  double most = 0.0;
  for (const StepOutline& s : lesson.lesson.steps) {
    auto& [step, values] = rows.emplace_back(&s, std::vector<Measured>());
    for (const PersonScore& p : lesson.people)
      if (const auto t = p.step_s.find(s.id); t != p.step_s.end()) values.push_back({t->second / 60.0, wayOf(p)});
    for (const Measured& m : values) most = std::max(most, m.value);
  }
  most = roundAbove(most);
  out +=
      "<h3>Time for each step</h3><div class=\"card "
      "scroll\"><table><thead><tr><th>Step</th><th>Students</th><th>Median</th><th class=\"left\">Each "
      "student</th></tr></thead><tbody>";
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

// What each student expected and felt, where a task asks to draw it.
std::string taskCurves(const LessonSummary& lesson, const StepOutline& step, std::size_t task) {
  std::string figures;
  for (const PersonScore& p : lesson.people)
    if (const auto score = p.tasks.find({step.id, task}); score != p.tasks.end() && score->second.drawn)
      figures += curves(p.person, *score->second.drawn, score->second.felt);
  if (figures.empty()) return {};
  return "<p class=\"quiet small\">Force as first drawn (dashed) and as felt in the end (line).</p><div "
         "class=\"curves\">" +
         figures + "</div>";
}

void tasks(std::string& out, const LessonSummary& lesson) {
  std::string rows;
  for (const StepOutline& s : lesson.lesson.steps)
    for (std::size_t t = 0; t < s.tasks.size(); ++t) {
      std::size_t begun = 0, done = 0;
      std::vector<std::pair<std::string, std::vector<Measured>>> figures;  // by "name, unit", in the order met
      std::map<std::string, std::size_t> places;
      const auto figure = [&](const std::string& name) -> std::vector<Measured>& {
        const auto [place, made] = places.try_emplace(name, figures.size());
        if (made) figures.emplace_back(name, std::vector<Measured>());
        return figures[place->second].second;
      };
      for (const PersonScore& p : lesson.people) {
        const auto score = p.tasks.find({s.id, t});
        if (score == p.tasks.end()) continue;
        begun += score->second.begun || score->second.done;
        done += score->second.done;
        if (!score->second.done) continue;
        if (score->second.figures.empty()) figure("time, s").push_back({score->second.took_s, score->second.by});
        for (const LoggedFigure& f : score->second.figures)
          if (std::isfinite(f.value))
            figure(f.name + (f.unit.empty() ? "" : ", " + f.unit)).push_back({f.value, score->second.by});
      }
      rows += "<div class=\"card\"><div class=\"head\"><b>" +
              escaped(s.tasks[t].say.empty() ? s.tasks[t].kind : s.tasks[t].say) + "</b><span>done by " +
              std::to_string(done) + " of " + std::to_string(begun) + "</span></div><div class=\"quiet small\">" +
              escaped(s.title) + ", " + escaped(s.tasks[t].kind) + "</div>";
      if (!figures.empty()) {
        rows +=
            "<div class=\"scroll\"><table><thead><tr><th>Figure</th><th>Median</th><th>Middle "
            "half</th><th>Range</th><th class=\"left\">Each student</th></tr></thead><tbody>";
        for (const auto& [name, values] : figures) {
          std::vector<double> v;
          for (const Measured& m : values) v.push_back(m.value);
          std::sort(v.begin(), v.end());
          const double most = roundAbove(v.back());
          const int digits = most >= 50 ? 0 : most >= 5 ? 1 : 2;
          rows += "<tr><td>" + escaped(name) + "</td><td>" + number(quantile(v, 0.5), digits) + "</td><td>" +
                  number(quantile(v, 0.25), digits) + " – " + number(quantile(v, 0.75), digits) + "</td><td>" +
                  number(v.front(), digits) + " – " + number(v.back(), digits) + "</td><td class=\"left\">" +
                  strip(values, most) + stripScale(most, "") + "</td></tr>";
        }
        rows += "</tbody></table></div>";
      }
      rows += taskCurves(lesson, s, t) + "</div>";
    }
  if (!rows.empty()) out += "<h3>Touch tasks</h3>" + rows;
}

void forces(std::string& out, const LessonSummary& lesson) {
  std::vector<Measured> peak, mean, path, touch, minutes, right;
  for (const PersonScore& p : lesson.people) {
    minutes.push_back({p.time_s / 60.0, wayOf(p)});
    if (!p.answers.empty()) right.push_back({double(p.firstRight()), wayOf(p)});
    if (!p.touches) continue;
    peak.push_back({p.peak_N, wayOf(p)});
    mean.push_back({p.mean_N, wayOf(p)});
    path.push_back({p.path_A, wayOf(p)});
    touch.push_back({p.touch_s, wayOf(p)});
  }
  out += "<h3>Time, force and path</h3><div class=\"histograms\">" + histogram("Time for the lesson", "min", minutes) +
         histogram("Answers right at the first try", "", right) + histogram("Time in touch", "s", touch) +
         histogram("Peak force", "N", peak) + histogram("Mean force while touching", "N", mean) +
         histogram("Path over the surface", "Å", path) + "</div>";
}

void predictions(std::string& out, const LessonSummary& lesson) {
  std::string rows;
  for (const PersonScore& p : lesson.people)
    for (const Predicted& guess : p.predictions)
      rows += "<tr><td class=\"name\">" + escaped(guess.student) + "</td><td class=\"left\">" +
              escaped(guess.question) + "</td><td class=\"left\">" + escaped(guess.text) + "</td><td class=\"left\">" +
              escaped(p.person) + "</td></tr>";
  if (!rows.empty())
    out +=
        "<h3>Predictions of those who waited</h3><div class=\"card scroll\"><table><thead><tr><th>Student</th><th "
        "class=\"left\">Question</th><th class=\"left\">Prediction</th><th class=\"left\">While at the "
        "device</th></tr></thead><tbody>" +
        rows + "</tbody></table></div>";
}

}  // namespace

std::string lessonSection(const LessonSummary& lesson, bool first) {
  std::string out = "<h2" + std::string(first ? " class=\"first\"" : "") + ">" + escaped(lesson.lesson.title) +
                    "</h2><p class=\"quiet small\">" + escaped(lesson.lesson.file) +
                    (lesson.versions > 1 ? ", in " + std::to_string(lesson.versions) +
                                               " versions: questions and tasks are those of the last"
                                         : "") +
                    "</p>";
  tiles(out, lesson);
  peopleTable(out, lesson);
  byWay(out, lesson);
  questions(out, lesson);
  out += legend(lesson.people);
  steps(out, lesson);
  forces(out, lesson);
  tasks(out, lesson);
  predictions(out, lesson);
  return out;
}

}  // namespace moltact
