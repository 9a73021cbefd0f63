#include "engine/results/study_page.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "engine/core/svg.h"
#include "engine/language/catalogue.h"
#include "engine/results/page_parts.h"

namespace moltact {
namespace {

using namespace page;

constexpr const char* kStudyStyle = R"css(
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(330px,1fr));gap:12px;margin:12px 0}
.line{fill:none;stroke-width:2}.g0{--own:var(--device)}.g1{--own:var(--mouse)}.g2{--own:var(--keyboard)}.g3{--own:var(--text)}
.line.g0,.line.g1,.line.g2,.line.g3{stroke:var(--own)}.line.g1{stroke-dasharray:7 3}.line.g2{stroke-dasharray:2 3}.dot{fill:var(--own);stroke:none}
.whisker{stroke:var(--own);stroke-width:1.3;fill:none}.zero{stroke:var(--text);stroke-width:1;stroke-dasharray:3 3}
.estimate{fill:var(--accent)}.interval{stroke:var(--accent);stroke-width:2}text.name{font-size:11px;fill:var(--text)}
.formula{font:14px Georgia,"DejaVu Serif",serif;white-space:nowrap}dl.formulas dt{font-weight:600;margin-top:12px}dl.formulas dd{margin:2px 0 0}
)css";

const char* partName(const std::string& part) {
  if (part == "pre") return trc("study", "before");
  if (part == "post") return trc("study", "after");
  if (part == "delayed") return trc("study", "delayed");
  return part == "lesson" ? trc("study", "lesson") : part.c_str();
}

std::string signedNumber(double value, int digits) { return (value > 0 ? "+" : "") + number(value, digits); }

std::string orDash(const std::optional<double>& value, int digits) { return value ? number(*value, digits) : "–"; }

std::string meanAndSd(const Spread& s, int digits) {
  if (s.n == 0) return "–";
  return number(s.mean, digits) + (s.n > 1 ? "\u00a0±\u00a0" + number(s.sd, digits) : "");
}

std::string sectionHead(const char* title) { return std::string("<h2>") + title + "</h2>"; }

// The groups by condition, touch first.
std::vector<std::size_t> groupOrder(const StudyData& study) {
  static constexpr const char* kOrder[]{"touch", "look", "blind"};
  std::vector<std::size_t> out(study.groups.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = k;
  std::stable_sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t k) {
      return std::find(std::begin(kOrder), std::end(kOrder), study.conditions[k]) - std::begin(kOrder);
    };
    return rank(a) < rank(b);
  });
  return out;
}

std::vector<const StudyPartOutline*> testsOf(const StudyData& study) {
  std::vector<const StudyPartOutline*> out;
  for (const StudyPartOutline& part : study.parts)
    if (part.test()) out.push_back(&part);
  return out;
}

// The shares of a group in several tests, only of students who have done all of them; by test.
std::vector<std::vector<double>> matched(const StudyData& study, const std::string& group,
                                         const std::vector<const StudyPartOutline*>& tests) {
  std::vector<std::vector<double>> out(tests.size());
  for (const StudyStudent& s : study.students) {
    if (s.group != group) continue;
    std::vector<double> shares;
    for (const StudyPartOutline* test : tests)
      if (const auto share = test ? s.share(*test) : std::nullopt) shares.push_back(*share);
    for (std::size_t k = 0; shares.size() == tests.size() && k < shares.size(); ++k) out[k].push_back(shares[k]);
  }
  return out;
}

std::vector<double> differences(const std::vector<std::vector<double>>& two) {
  std::vector<double> out;
  for (std::size_t k = 0; k < two[0].size(); ++k) out.push_back(two[1][k] - two[0][k]);
  return out;
}

std::string groupLegend(const StudyData& study, const std::vector<std::size_t>& order) {
  std::string out = "<div class=\"legend\">";
  for (std::size_t k = 0; k < order.size(); ++k) {
    Svg svg;
    const std::string look = " g" + std::to_string(std::min<std::size_t>(k, 3)) + "\"";
    svg.path("M1 7h28", "class=\"line" + look);
    svg.circle(15, 7, 4, "class=\"dot" + look);
    out += "<span>" + std::move(svg).within("viewBox=\"0 0 30 14\" aria-hidden=\"true\"") +
           escaped(study.groups[order[k]]) + "</span>";
  }
  return out + "</div>";
}

// The means of the tests by group, with 95 % intervals.
std::string scoresPlot(const StudyData& study, const std::vector<std::size_t>& order) {
  const auto tests = testsOf(study);
  constexpr double kLeft = 42, kTop = 12, kWide = 270, kHigh = 170;
  Svg svg;
  for (int percent = 0; percent <= 100; percent += 25) {
    const double y = kTop + kHigh * (1.0 - percent / 100.0);
    svg.path(svgPoint('M', kLeft, y) + "h" + svgNumber(kWide), "class=\"grid\"");
    svg.text(kLeft - 6, y + 3.5, "end", std::to_string(percent), "class=\"axis\"");
  }
  const auto x = [&](std::size_t test) { return kLeft + kWide * (double(test) + 0.5) / double(tests.size()); };
  for (std::size_t t = 0; t < tests.size(); ++t)
    svg.text(x(t), kTop + kHigh + 16, "middle", partName(tests[t]->part), "class=\"axis\"");
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::string look = " g" + std::to_string(std::min<std::size_t>(k, 3)) + "\"";
    const double shift = 9.0 * (double(k) - 0.5 * double(order.size() - 1));
    std::string line;
    Svg marks;
    for (std::size_t t = 0; t < tests.size(); ++t) {
      const Spread s = spreadOf(matched(study, study.groups[order[k]], {tests[t]})[0]);
      if (s.n == 0) continue;
      const auto y = [&](double share) { return kTop + kHigh * (1.0 - std::clamp(share, 0.0, 1.0)); };
      line += svgPoint(line.empty() ? 'M' : 'L', x(t) + shift, y(s.mean));
      if (const auto half = meanHalfWidth(s))
        svg.line(x(t) + shift, y(s.mean - *half), x(t) + shift, y(s.mean + *half), "class=\"whisker" + look);
      svg.circle(x(t) + shift, y(s.mean), 4, "class=\"dot" + look);
    }
    if (!line.empty()) svg.path(line, "class=\"line" + look);
  }
  const std::string title = tr("Right answers, %");
  return "<figure><figcaption><b>" + title + "</b><span>" + tr("mean with 95 % interval") + "</span></figcaption>" +
         std::move(svg).within("viewBox=\"0 0 320 204\" role=\"img\" aria-label=\"" + title + "\"") + "</figure>";
}

std::string outcomeName(const std::string& outcome) {
  if (outcome == "gain") return tr("gain from before to after");
  if (outcome == "post") return tr("test after");
  return tr("gain from before to the delayed test");
}

std::string forestPlot(const std::vector<StudyComparison>& comparisons) {
  constexpr double kLeft = 170, kWide = 320, kRow = 30, kTop = 8;
  double low = -0.2, high = 0.2;
  std::size_t rows = 0;
  for (const StudyComparison& c : comparisons)
    if (c.effect) {
      low = std::min(low, c.effect->low);
      high = std::max(high, c.effect->high);
      ++rows;
    }
  if (rows == 0) return {};
  const double step = high - low > 4.0 ? 2.0 : high - low > 2.0 ? 1.0 : 0.5;
  low = std::max(-20.0, std::floor(low / step) * step);
  high = std::min(20.0, std::ceil(high / step) * step);
  const auto x = [&](double g) { return kLeft + kWide * (std::clamp(g, low, high) - low) / (high - low); };
  const double bottom = kTop + kRow * double(rows);
  Svg svg;
  for (double at = low; at <= high + 1e-9; at += step) {
    svg.path(svgPoint('M', x(at), kTop) + "v" + svgNumber(bottom - kTop),
             std::abs(at) < 1e-9 ? "class=\"zero\"" : "class=\"grid\"");
    svg.text(x(at), bottom + 15, "middle", number(at, step < 1.0 ? 1 : 0), "class=\"axis\"");
  }
  double y = kTop + 0.5 * kRow;
  for (const StudyComparison& c : comparisons) {
    if (!c.effect) continue;
    svg.text(kLeft - 10, y - 2, "end", c.first + " − " + c.second, "class=\"name\"");
    svg.text(kLeft - 10, y + 10, "end", outcomeName(c.outcome), "class=\"axis\"");
    svg.line(x(c.effect->low), y, x(c.effect->high), y, "class=\"interval\"");
    svg.rect(x(c.effect->g) - 4, y - 4, 8, 8, "class=\"estimate\"");
    y += kRow;
  }
  const std::string title = tr("Effect size g");
  return "<figure><figcaption><b>" + title + "</b><span>" + tr("with 95 % interval") + "</span></figcaption>" +
         std::move(svg).within("viewBox=\"0 0 510 " + svgNumber(bottom + 22) + "\" role=\"img\" aria-label=\"" + title +
                               "\"") +
         "</figure>";
}

void scores(std::string& out, const StudyData& study, const std::vector<std::size_t>& order) {
  const StudyPartOutline *pre = study.find("pre"), *post = study.find("post"), *delayed = study.find("delayed");
  out += sectionHead(tr("Scores and gains"));
  out += std::string("<p class=\"quiet\">") +
         tr("Shares of right answers in percent, mean ± standard deviation. Gains are of the students who did both "
            "tests.") +
         "</p>" + groupLegend(study, order);
  out += "<div class=\"card scroll\">" + tableHead({{tr("Group"), true},
                                                    {tr("Condition"), true},
                                                    {tr("Students")},
                                                    {tr("Before")},
                                                    {tr("After")},
                                                    {tr("Delayed")},
                                                    {tr("n with gain")},
                                                    {tr("Normalised gain of the group")},
                                                    {tr("Mean of the students’ normalised gains")}});
  for (const std::size_t k : order) {
    const std::string& group = study.groups[k];
    const auto n = std::count_if(study.students.begin(), study.students.end(),
                                 [&](const StudyStudent& s) { return s.group == group; });
    out += "<tr><td class=\"name\">" + escaped(group) + "</td><td class=\"left\">" + escaped(study.conditions[k]) +
           "</td><td>" + std::to_string(n) + "</td>";
    for (const StudyPartOutline* test : {pre, post, delayed}) {
      std::vector<double> shares = test ? matched(study, group, {test})[0] : std::vector<double>();
      for (double& s : shares) s *= 100.0;
      out += "<td>" + meanAndSd(spreadOf(shares), 1) + "</td>";
    }
    const auto both = matched(study, group, {pre, post});
    std::vector<double> own;
    for (std::size_t s = 0; s < both[0].size(); ++s)
      if (const auto gain = normalisedGain(both[0][s], both[1][s])) own.push_back(*gain);
    const auto gain = both[0].empty() ? std::nullopt : normalisedGain(spreadOf(both[0]).mean, spreadOf(both[1]).mean);
    out += "<td>" + std::to_string(both[0].size()) + "</td><td>" + orDash(gain, 2) + "</td><td>" +
           meanAndSd(spreadOf(own), 2) + "</td></tr>";
  }
  out += "</tbody></table></div>";
}

void effects(std::string& out, const std::vector<StudyComparison>& comparisons) {
  if (comparisons.empty()) return;
  out += sectionHead(tr("Effect of the condition"));
  out += std::string("<p class=\"quiet\">") +
         tr("First group minus second. State before the study which line answers its question: the intervals and "
            "p values are not corrected for several comparisons.") +
         "</p>";
  out += "<div class=\"card scroll\">" + tableHead({{tr("Groups"), true},
                                                    {tr("Outcome"), true},
                                                    {tr("n")},
                                                    {tr("Difference, percentage points")},
                                                    {tr("Hedges’ g")},
                                                    {tr("95 % interval")},
                                                    {tr("t (df)")},
                                                    {tr("p")}});
  for (const StudyComparison& c : comparisons) {
    out += "<tr><td class=\"name\">" + escaped(c.first) + " − " + escaped(c.second) + "</td><td class=\"left\">" +
           outcomeName(c.outcome) + "</td><td>" + std::to_string(c.n1) + " + " + std::to_string(c.n2) + "</td>";
    if (!c.effect) {
      out += "<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td></tr>";
      continue;
    }
    const EffectSize& e = *c.effect;
    out += "<td>" + signedNumber(100.0 * e.difference, 1) + "</td><td>" + signedNumber(e.g, 2) + "</td><td>" +
           // Translators: an interval.
           trf("{0} to {1}", signedNumber(e.low, 2), signedNumber(e.high, 2)) + "</td><td>" + number(e.t, 2) + " (" +
           std::to_string(e.n1 + e.n2 - 2) + ")</td><td>" +
           (e.p < 0.001 ? "&lt; " + number(0.001, 3) : number(e.p, 3)) + "</td></tr>";
  }
  out += "</tbody></table></div>";
}

// The wrong answer that was chosen most, with its misconception.
std::string commonMistake(const StudyData& study, const StudyPartOutline& part, std::size_t item) {
  std::map<std::size_t, std::size_t> chosen;
  std::size_t answered = 0;
  for (const StudyStudent& s : study.students) {
    const auto score = s.parts.find(part.part);
    if (score == s.parts.end()) continue;
    const auto answer = score->second.answers.find(item);
    if (answer == score->second.answers.end()) continue;
    ++answered;
    if (!answer->second.right)
      for (const std::size_t c : answer->second.chosen) ++chosen[c];
  }
  if (chosen.empty()) return "–";
  const auto most =
      std::max_element(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const StudyItem& at = part.questions[item];
  const QuestionOutline& q = part.lesson.steps[at.step].questions[at.index];
  std::string out = most->first < q.choices.size() ? escaped(q.choices[most->first]) : "?";
  if (most->first < q.tags.size() && !q.tags[most->first].empty())
    out += "<br><span class=\"quiet small\">" + escaped(q.tags[most->first]) + "</span>";
  return out + " <span class=\"quiet\">" + percent(double(most->second) / double(answered)) + "</span>";
}

std::string itemPlot(const std::vector<ItemFigures>& items, const std::string& title) {
  constexpr double kLeft = 42, kTop = 12, kWide = 270, kHigh = 170, kLow = -0.4;
  Svg svg;
  const auto x = [&](double p) { return kLeft + kWide * p; };
  const auto y = [&](double r) { return kTop + kHigh * (1.0 - (std::clamp(r, kLow, 1.0) - kLow) / (1.0 - kLow)); };
  for (const double r : {-0.4, 0.0, 0.4, 0.8}) {
    svg.path(svgPoint('M', kLeft, y(r)) + "h" + svgNumber(kWide), r == 0.0 ? "class=\"zero\"" : "class=\"grid\"");
    svg.text(kLeft - 6, y(r) + 3.5, "end", number(r, 1), "class=\"axis\"");
  }
  for (int percent = 0; percent <= 100; percent += 25)
    svg.text(x(percent / 100.0), kTop + kHigh + 16, "middle", std::to_string(percent), "class=\"axis\"");
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].point_biserial) continue;
    svg.circle(x(items[i].difficulty), y(*items[i].point_biserial), 3, "class=\"estimate\"");
    svg.text(x(items[i].difficulty) + 5, y(*items[i].point_biserial) - 3, "start", std::to_string(i + 1),
             "class=\"name\"");
  }
  return "<figure><figcaption><b>" + title + "</b><span>" + tr("r against right answers, %") + "</span></figcaption>" +
         std::move(svg).within("viewBox=\"0 0 340 204\" role=\"img\" aria-label=\"" + title + "\"") + "</figure>";
}

void items(std::string& out, const StudyData& study) {
  const auto tests = testsOf(study);
  if (tests.empty()) return;
  out += sectionHead(tr("The questions of the tests"));
  out += std::string("<p class=\"quiet\">") +
         tr("All groups together. An r or D near 0 or below marks a question that students who know the rest do not "
            "answer better: check its wording.") +
         "</p>";
  for (const StudyPartOutline* test : tests) {
    const AnswerMatrix answers = study.answers(*test);
    const std::vector<ItemFigures> figures = itemFigures(answers);
    const auto alpha = cronbachAlpha(answers);
    out += "<h3>" + escaped(test->lesson.title) + ": " + escaped(partName(test->part)) + "</h3><p class=\"quiet\">" +
           trf("{0} students; reliability (Cronbach’s α, KR-20) {1}.", answers.size(), orDash(alpha, 2)) + "</p>";
    out += "<div class=\"card scroll\">" + tableHead({{tr("Question"), true},
                                                      {tr("right")},
                                                      {tr("r")},
                                                      {tr("D")},
                                                      {tr("most frequent wrong answer, its misconception"), true}});
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const StudyItem& at = test->questions[i];
      out += "<tr><td class=\"left\"><b>" + std::to_string(i + 1) + "</b> " +
             escaped(test->lesson.steps[at.step].questions[at.index].text) + "</td><td class=\"nowrap\">" +
             percent(figures[i].difficulty) + "</td><td>" + orDash(figures[i].point_biserial, 2) + "</td><td>" +
             orDash(figures[i].upper_lower, 2) + "</td><td class=\"left\">" + commonMistake(study, *test, i) +
             "</td></tr>";
    }
    out += "</tbody></table></div><div class=\"plots\">" +
           itemPlot(figures, trf("Questions: {0}", partName(test->part))) + "</div>";
  }
}

void misconceptions(std::string& out, const StudyData& study) {
  const auto tests = testsOf(study);
  std::map<std::string, std::vector<std::size_t>> counts;  // students by tag and test
  for (std::size_t t = 0; t < tests.size(); ++t)
    for (const StudyStudent& s : study.students) {
      const auto score = s.parts.find(tests[t]->part);
      if (score == s.parts.end()) continue;
      std::map<std::string, bool> shown;
      for (const auto& [item, answer] : score->second.answers) {
        const StudyItem& at = tests[t]->questions[item];
        const QuestionOutline& q = tests[t]->lesson.steps[at.step].questions[at.index];
        for (const std::size_t c : answer.chosen)
          if (c < q.tags.size() && !q.tags[c].empty()) shown[q.tags[c]] = true;
      }
      for (const auto& [tag, yes] : shown) {
        auto& count = counts[tag];
        count.resize(tests.size());
        ++count[t];
      }
    }
  if (counts.empty()) return;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  out += sectionHead(tr("Misconceptions in the tests")) + "<div class=\"card scroll\"><table><thead><tr><th>" +
         tr("What a wrong answer shows") + "</th>";
  for (const StudyPartOutline* test : tests) out += "<th>" + escaped(partName(test->part)) + "</th>";
  out += "</tr></thead><tbody>";
  for (const auto& [tag, count] : sorted) {
    out += "<tr><td class=\"left\">" + escaped(tag) + "</td>";
    for (const std::size_t n : count) out += "<td>" + std::to_string(n) + "</td>";
    out += "</tr>";
  }
  out += "</tbody></table></div>";
}

void timeOnTask(std::string& out, const StudyData& study, const std::vector<std::size_t>& order) {
  out += sectionHead(tr("Time on task"));
  out += "<div class=\"card scroll\">" + tableHead({{tr("Part"), true},
                                                    {tr("Group"), true},
                                                    {tr("n")},
                                                    {tr("minutes, mean ± standard deviation")},
                                                    {tr("each student"), true},
                                                    {tr("minutes of touch")},
                                                    {tr("touches")}});
  double most = 0.0;
  for (const StudyStudent& s : study.students)
    for (const auto& [part, score] : s.parts) most = std::max(most, score.time_s / 60.0);
  const double end = roundAbove(most);
  for (const StudyPartOutline& part : study.parts)
    for (const std::size_t k : order) {
      std::vector<double> minutes, touch, touches;
      std::vector<Measured> marks;
      for (const StudyStudent& s : study.students) {
        const auto score = s.parts.find(part.part);
        if (s.group != study.groups[k] || score == s.parts.end()) continue;
        minutes.push_back(score->second.time_s / 60.0);
        touch.push_back(score->second.touch_s / 60.0);
        touches.push_back(double(score->second.touches));
        marks.push_back({minutes.back(), InputKind::Mouse});
      }
      if (minutes.empty()) continue;
      out += "<tr><td class=\"left\">" + escaped(partName(part.part)) + "</td><td class=\"left\">" +
             escaped(study.groups[k]) + "</td><td>" + std::to_string(minutes.size()) + "</td><td>" +
             meanAndSd(spreadOf(minutes), 1) + "</td><td class=\"left\">" + strip(marks, end) + "</td><td>" +
             number(spreadOf(touch).mean, 1) + "</td><td>" + number(spreadOf(touches).mean, 0) + "</td></tr>";
    }
  out += "<tr><td></td><td></td><td></td><td></td><td class=\"left\">" + stripScale(end, "min") +
         "</td><td></td><td></td></tr></tbody></table></div>";
}

void studyFormulas(std::string& out) {
  out += sectionHead(tr("How this was computed")) + "<dl class=\"formulas small\">";
  struct Entry {
    const char *name, *formula, *meaning, *source;
  };
  const Entry entries[]{
      {tr("Normalised gain"), "⟨g⟩ = (⟨post⟩ − ⟨pre⟩) / (1 − ⟨pre⟩)",
       tr("Of the group from its mean shares, over the students who did both tests. A student with everything right "
          "before has no normalised gain."),
       "R. R. Hake, Am. J. Phys. 66, 64 (1998)"},
      {tr("Effect size g"), "g = J(n₁ + n₂ − 2) · (x̄₁ − x̄₂) / s,  J(m) = Γ(m/2) / (√(m/2) Γ((m − 1)/2))",
       tr("s is the pooled standard deviation of both groups. The interval contains the population’s difference in "
          "standard deviations with 95 % confidence; it comes from the noncentral t distribution."),
       "L. V. Hedges, J. Educ. Stat. 6, 107 (1981); L. V. Hedges, I. Olkin, Statistical Methods for Meta-Analysis, "
       "Academic Press (1985), ch. 5"},
      {tr("t and p"), "t = (x̄₁ − x̄₂) / (s √(1/n₁ + 1/n₂))",
       tr("The two-sided test of two independent groups with pooled variance."), "Student, Biometrika 6, 1 (1908)"},
      {tr("Right (difficulty)"), "p = R / n",
       tr("The share of the students who answered rightly. An item that a student left out counts as wrong."),
       "L. Crocker, J. Algina, Introduction to Classical and Modern Test Theory (1986), ch. 14"},
      {tr("Discrimination r"), "r = corr(xᵢ, Σ xⱼ, j ≠ i)",
       tr("The correlation of the item (0 or 1) with the number of right answers to the other items. Given from five "
          "students on."),
       "S. Henrysson, Psychometrika 28, 211 (1963)"},
      {tr("Discrimination D"), "D = p(upper 27 %) − p(lower 27 %)",
       tr("By the total of the test. Students with equal totals at a border enter with equal weight. Given from ten "
          "students on."),
       "T. L. Kelley, J. Educ. Psychol. 30, 17 (1939)"},
      {tr("Reliability α"), "α = k/(k − 1) · (1 − Σ sᵢ² / s²)",
       tr("k items with the variances sᵢ², and the variance s² of the totals. For right and wrong answers it equals "
          "formula 20 of Kuder and Richardson."),
       "L. J. Cronbach, Psychometrika 16, 297 (1951); G. F. Kuder, M. W. Richardson, Psychometrika 2, 151 (1937)"},
      {tr("Intervals of means"), "x̄ ± t(0.975, n − 1) s / √n", tr("s is the standard deviation with n − 1."),
       "Student, Biometrika 6, 1 (1908)"},
  };
  for (const Entry& e : entries)
    out += std::string("<dt>") + e.name + "</dt><dd><span class=\"formula\">" + e.formula + "</span><br>" + e.meaning +
           " <span class=\"quiet\">" + e.source + "</span></dd>";
  out += "</dl><p class=\"small\">" +
         std::string(tr("Time on task is time with the part open. Of a test the last answers of the first attempt "
                        "count, of a lesson the first answer to each question. Students without a code are in the "
                        "tables of the questions only, because their tests cannot be joined.")) +
         "</p>";
}

}  // namespace

std::vector<StudyComparison> studyComparisons(const StudyData& study) {
  const StudyPartOutline *pre = study.find("pre"), *post = study.find("post"), *delayed = study.find("delayed");
  const std::vector<std::size_t> order = groupOrder(study);
  std::vector<StudyComparison> out;
  const auto outcome = [&](const std::string& name, const std::string& group) {
    if (name == "post") return matched(study, group, {post})[0];
    return differences(matched(study, group, {pre, name == "gain" ? post : delayed}));
  };
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b)
      for (const char* name : {"gain", "post", "delayed gain"}) {
        const bool there = std::string_view(name) == "gain"   ? pre && post
                           : std::string_view(name) == "post" ? post != nullptr
                                                              : pre && delayed;
        if (!there) continue;
        const std::string &first = study.groups[order[a]], &second = study.groups[order[b]];
        const std::vector<double> x = outcome(name, first), y = outcome(name, second);
        out.push_back({name, first, second, hedgesG(x, y), x.size(), y.size()});
      }
  return out;
}

std::string studyPage(const StudyData& study, const std::vector<Problem>& passed_over, const std::string& made) {
  const std::vector<std::size_t> order = groupOrder(study);
  const std::vector<StudyComparison> comparisons = studyComparisons(study);
  const std::string title = trf("Study: {0}", escaped(study.name));
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + escaped(language()) +
                    "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
                    "content=\"width=device-width, initial-scale=1\">"
                    "<meta name=\"generator\" content=\"Moltact\"><title>" +
                    title + "</title><style>";
  out += styleSheet();
  out += kStudyStyle;
  out +=
      "</style></head><body>" + patterns() + "<main><h1>" + title + "</h1><p class=\"quiet\">" +
      trf("{0} students, {1} attempts. Made {2} with Moltact.", study.students.size(), study.attempts, escaped(made)) +
      "</p>";
  if (!order.empty()) {
    scores(out, study, order);
    out += "<div class=\"plots\">" + (testsOf(study).empty() ? std::string() : scoresPlot(study, order)) +
           forestPlot(comparisons) + "</div>";
    effects(out, comparisons);
  }
  items(out, study);
  misconceptions(out, study);
  if (!order.empty()) timeOnTask(out, study, order);
  if (!study.notes.empty() || study.others > 0 || !passed_over.empty()) {
    out += sectionHead(tr("Notes on the data")) + "<ul class=\"plain small\">";
    for (const std::string& note : study.notes) out += "<li>" + escaped(note) + "</li>";
    if (study.others > 0)
      out += "<li>" +
             trnf("{0} attempt belongs to no study and does not count.",
                  "{0} attempts belong to no study and do not count.", study.others, study.others) +
             "</li>";
    for (const Problem& p : passed_over) out += "<li><code>" + escaped(p.text()) + "</code></li>";
    out += "</ul>";
  }
  studyFormulas(out);
  out += "</main></body></html>\n";
  return out;
}

}  // namespace moltact
