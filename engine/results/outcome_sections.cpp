#include "engine/results/outcome_sections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/results/page_parts.h"
#include "engine/results/study_statistics.h"

namespace moltact {

using namespace page;

namespace {

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / double(values.size());
}

}  // namespace

std::string goalSection(const LessonSummary& lesson) {
  std::string rows;
  for (std::size_t g = 0; g < lesson.lesson.goals.size(); ++g) {
    GoalScore all;
    std::size_t reached = 0;
    for (const PersonScore& p : lesson.people) {
      const GoalScore one = goalScore(lesson.lesson, p, g);
      all.parts += one.parts;
      all.done += one.done;
      all.answered += one.answered;
      all.first_right += one.first_right;
      reached += one.parts > 0 && one.done == one.parts;
    }
    if (all.parts == 0) continue;
    const double share = double(all.done) / double(all.parts);
    rows += "<tr><td class=\"left\">" + std::to_string(g + 1) + ". " + escaped(lesson.lesson.goals[g]) +
            "</td><td class=\"left\"><div class=\"doneCell\">" + bar(share, true) + "<span>" + percent(share) +
            "</span></div></td><td>" + (all.answered ? percent(double(all.first_right) / double(all.answered)) : "–") +
            "</td><td>" + std::to_string(reached) + "</td></tr>";
  }
  if (rows.empty()) return {};
  return section(tr("By goal"), {{tr("Goal"), true},
                                 {tr("Done"), true},
                                 {tr("Right at<br>first try")},
                                 {tr("Students who<br>did all of it")}}) +
         rows + "</tbody></table></div>";
}

std::string misconceptionSection(const LessonSummary& lesson) {
  struct Met {
    std::size_t people = 0, times = 0;
  };
  std::map<std::string, Met> met;
  std::map<std::string, std::string> questions;  // the questions that contain a tag
  for (const StepOutline& s : lesson.lesson.steps)
    for (const QuestionOutline& q : s.questions)
      for (std::size_t k = 0; k < q.tags.size(); ++k)
        if (!q.tags[k].empty() && std::find(q.tags.begin(), q.tags.begin() + std::ptrdiff_t(k), q.tags[k]) ==
                                      q.tags.begin() + std::ptrdiff_t(k)) {
          met[q.tags[k]];
          std::string& in = questions[q.tags[k]];
          in += (in.empty() ? "" : "<br>") + escaped(q.text);
        }
  if (met.empty()) return {};
  for (const PersonScore& p : lesson.people)
    for (const auto& [tag, times] : p.misconceptions) {
      ++met[tag].people;
      met[tag].times += times;
    }
  std::vector<std::pair<std::string, Met>> rows(met.begin(), met.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second.people > b.second.people; });
  std::string out = section(
      tr("Misconceptions"),
      {{tr("What wrong answers show"), true}, {tr("Students"), true}, {tr("Times")}, {tr("In the questions"), true}});
  for (const auto& [tag, m] : rows) {
    const double share = double(m.people) / double(std::max<std::size_t>(1, lesson.people.size()));
    out += "<tr><td class=\"left\">" + escaped(tag) + "</td><td class=\"left\"><div class=\"doneCell\">" +
           bar(share, false) + "<span>" + trf("{0} of {1}", m.people, lesson.people.size()) + "</span></div></td><td>" +
           std::to_string(m.times) + "</td><td class=\"left\">" + questions[tag] + "</td></tr>";
  }
  return out + "</tbody></table></div>";
}

std::string gainSection(const LessonSummary& lesson) {
  if (!asksTwice(lesson.lesson)) return {};
  const auto shown = [](const std::optional<double>& value) { return value ? number(*value, 2) : std::string("–"); };
  std::string rows;
  std::vector<double> before, after, gains;
  for (const PersonScore& p : lesson.people) {
    const SensitivityPair pair = sensitivityPair(lesson.lesson, p);
    if (!pair.before && !pair.after) continue;
    rows += "<tr><td class=\"name\">" + escaped(p.person) + "</td><td>" + shown(pair.before) + "</td><td>" +
            shown(pair.after) + "</td><td>" + shown(pair.gain()) + "</td></tr>";
    if (!pair.gain()) continue;
    before.push_back(*pair.before);
    after.push_back(*pair.after);
    gains.push_back(*pair.gain());
  }
  if (rows.empty()) return {};
  const std::optional<double> half_width = meanHalfWidth(spreadOf(gains));
  if (!gains.empty())
    rows += "<tr><td class=\"name\"><b>" + trf("Mean of {0}", gains.size()) + "</b></td><td>" +
            number(mean(before), 2) + "</td><td>" + number(mean(after), 2) + "</td><td><b>" + number(mean(gains), 2) +
            (half_width ? " ± " + number(*half_width, 2) : std::string()) + "</b></td></tr>";
  return section(tr("Told apart in the dark, before and after"),
                 {{tr("Student")}, {tr("d′ before")}, {tr("d′ after")}, {tr("Gain")}}) +
         rows + "</tbody></table><p class=\"quiet small\">" +
         tr("0 is guessing; 1 tells apart a little, 2 well. Of each asking the first round counts. Behind ± stands "
            "half "
            "the width of the 95 % confidence interval of the mean gain; if 0 lies within it, so few students show no "
            "gain.") +
         "</p></div>";
}

std::string waySection(const LessonSummary& lesson) {
  std::vector<std::string> straight;
  for (const StepOutline& s : lesson.lesson.steps)
    if (!s.aside) straight.push_back(s.id);
  const bool any = std::any_of(lesson.people.begin(), lesson.people.end(), [&](const PersonScore& p) {
    return !p.rules.empty() || p.steps_taken.size() > straight.size() ||
           !std::equal(p.steps_taken.begin(), p.steps_taken.end(), straight.begin());
  });
  if (!any) return {};
  std::string out =
      section(tr("The way taken"), {{tr("Student")}, {tr("Steps by their numbers, side paths as a1, a2 …"), true}});
  for (const PersonScore& p : lesson.people)
    out += "<tr><td class=\"name\">" + escaped(p.person) + "</td><td class=\"left\">" +
           escaped(wayText(lesson.lesson, p)) + "</td></tr>";
  return out + "</tbody></table></div>";
}

}  // namespace moltact
