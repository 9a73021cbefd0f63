#include "engine/results/class_page.h"

#include <algorithm>
#include <map>

#include "engine/results/lesson_section.h"
#include "engine/results/page_parts.h"

namespace moltact {
namespace {

using namespace page;

std::string plural(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void whoFinishedWhat(std::string& out, const ClassSummary& summary) {
  out += "<h3>Who finished what</h3><div class=\"card scroll\"><table><thead><tr><th>Student</th>";
  for (const LessonSummary& lesson : summary.lessons)
    out += "<th class=\"left\">" + escaped(lesson.lesson.title) + "</th>";
  out += "</tr></thead><tbody>";
  for (const std::string& person : summary.people) {
    out += "<tr><td class=\"name\">" + escaped(person) + "</td>";
    for (const LessonSummary& lesson : summary.lessons) {
      const auto p = std::find_if(lesson.people.begin(), lesson.people.end(),
                                  [&](const PersonScore& s) { return s.person == person; });
      if (p == lesson.people.end())
        out += "<td class=\"left quiet\">not begun</td>";
      else
        out += "<td class=\"left\"><div class=\"doneCell\">" + bar(p->share(), true) + "<span>" + percent(p->share()) +
               "</span><span class=\"quiet small\">" + (p->finished() ? "✓ " : "") + duration(p->time_s) +
               "</span></div></td>";
    }
    out += "</tr>";
  }
  out += "</tbody></table></div>";
}

void passedOver(std::string& out, const std::vector<Problem>& problems) {
  if (problems.empty()) return;
  out +=
      "<h2>Passed over</h2><p class=\"quiet\">These files or lines could not be read and count for nothing "
      "above.</p><ul class=\"plain small\">";
  for (const Problem& p : problems) out += "<li><code>" + escaped(p.text()) + "</code></li>";
  out += "</ul>";
}

void howCounted(std::string& out) {
  out +=
      "<h2>How this was counted</h2><ul class=\"plain small\">"
      "<li>A person is a student’s name, or an attempt where no name was given. Several attempts of a person at a "
      "lesson count together: the farthest "
      "progress, all the time, and of each question the first answer ever given.</li>"
      "<li>Done is the share of a lesson’s tasks and questions. Time is time with the lesson open, also while "
      "reading.</li>"
      "<li>Forces are those of the probe on the hand, a choice of scale made for the hand; without a force-feedback "
      "device they are the ones that such "
      "a device would have given. A mouse and a stylus press differently: compare forces and paths within one way of "
      "input only.</li>"
      "<li>The path is the way of the probe over the surface, in ångström. Mean forces are over the time of touch.</li>"
      "<li>In the charts a line is the median, a box the middle half of the values.</li></ul>";
}

}  // namespace

std::string classPage(const ClassSummary& summary, const std::vector<Problem>& passed_over, const std::string& made) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">"
      "<meta name=\"generator\" content=\"Moltact\"><title>Class report</title><style>";
  out += styleSheet();
  out += "</style></head><body>" + patterns() + "<main><h1>Class report</h1><p class=\"quiet\">" +
         plural(summary.people.size(), "student", "students") + ", " +
         plural(summary.lessons.size(), "lesson", "lessons") + ", " + plural(summary.attempts, "attempt", "attempts") +
         ". Made " + escaped(made) + " with Moltact.</p>";
  if (summary.lessons.empty()) out += "<p>There are no attempts in what was given.</p>";
  if (summary.lessons.size() > 1) whoFinishedWhat(out, summary);
  bool first = summary.lessons.size() <= 1;
  for (const LessonSummary& lesson : summary.lessons) {
    out += lessonSection(lesson, first);
    first = false;
  }
  passedOver(out, passed_over);
  howCounted(out);
  return out + "</main></body></html>\n";
}

}  // namespace moltact
