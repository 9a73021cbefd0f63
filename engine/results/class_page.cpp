#include "engine/results/class_page.h"

#include <map>
#include <string_view>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/results/lesson_section.h"
#include "engine/results/page_parts.h"

namespace moltact {
namespace {

using namespace page;

void whoFinishedWhat(std::string& out, const ClassSummary& summary) {
  out += std::string("<h3>") + tr("Who finished what") + "</h3><div class=\"card scroll\"><table><thead><tr><th>" +
         tr("Student") + "</th>";
  for (const LessonSummary& lesson : summary.lessons)
    out += "<th class=\"left\">" + escaped(lesson.lesson.title) + "</th>";
  out += "</tr></thead><tbody>";
  std::map<std::string_view, std::vector<const PersonScore*>> scores;  // of each person, by lesson
  for (std::size_t k = 0; k < summary.lessons.size(); ++k)
    for (const PersonScore& p : summary.lessons[k].people) {
      auto& of_person = scores[p.person];
      of_person.resize(summary.lessons.size());
      of_person[k] = &p;
    }
  for (const std::string& person : summary.people) {
    out += "<tr><td class=\"name\">" + escaped(person) + "</td>";
    auto& of_person = scores[person];
    of_person.resize(summary.lessons.size());
    for (const PersonScore* p : of_person) {
      if (!p)
        out += std::string("<td class=\"left quiet\">") + tr("not begun") + "</td>";
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
  out += std::string("<h2>") + tr("Passed over") + "</h2><p class=\"quiet\">" +
         tr("These files or lines could not be read and count for nothing above.") + "</p><ul class=\"plain small\">";
  for (const Problem& p : problems) out += "<li><code>" + escaped(p.text()) + "</code></li>";
  out += "</ul>";
}

void howCounted(std::string& out) {
  out += std::string("<h2>") + tr("How this was counted") + "</h2><ul class=\"plain small\">";
  for (const char* sentence :
       {tr("A person is a student’s name, or an attempt where no name was given. Several attempts of a person at a "
           "lesson count together: the farthest progress, all the time, and of each question the first answer ever "
           "given."),
        tr("Done is the share of a lesson’s tasks and questions. Time is time with the lesson open, also while "
           "reading."),
        tr("Forces are those of the probe on the hand, a choice of scale made for the hand; without a force-feedback "
           "device they are the ones that such a device would have given. A mouse and a stylus press differently: "
           "compare forces and paths within one way of input only."),
        tr("The path is the distance that the probe covers on the surface, in ångström. Mean forces are over the time "
           "of touch."),
        tr("In the charts a line is the median, a box the middle half of the values.")})
    out += std::string("<li>") + sentence + "</li>";
  out += "</ul>";
}

}  // namespace

std::string classPage(const ClassSummary& summary, const std::vector<Problem>& passed_over, const std::string& made) {
  const std::string title = tr("Class report");
  std::size_t scores = 0;
  for (const LessonSummary& lesson : summary.lessons) scores += lesson.people.size();
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + escaped(language()) +
                    "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
                    "content=\"width=device-width, initial-scale=1\">"
                    "<meta name=\"generator\" content=\"Moltact\"><title>" +
                    title + "</title><style>";
  // Reserves enough that the page of a large class is never copied to grow; unused pages of it take no memory.
  constexpr std::size_t kMaxOfScore = 4096;
  out.reserve(out.size() + kMaxOfScore * scores);
  out += styleSheet();
  const std::string counted = trf("{0}. Made {1} with Moltact.", summaryText(summary), escaped(made));
  out += "</style></head><body>" + patterns() + "<main><h1>" + title + "</h1><p class=\"quiet\">" + counted + "</p>";
  if (summary.lessons.empty()) out += std::string("<p>") + tr("There are no attempts in what was given.") + "</p>";
  if (summary.lessons.size() > 1) whoFinishedWhat(out, summary);
  bool first = summary.lessons.size() <= 1;
  for (const LessonSummary& lesson : summary.lessons) {
    lessonSection(out, lesson, first);
    first = false;
  }
  passedOver(out, passed_over);
  howCounted(out);
  out += "</main></body></html>\n";
  return out;
}

}  // namespace moltact
