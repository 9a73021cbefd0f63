// The parts of a teacher's kit page (kit_page.h). Internal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/lesson/teachers_kit.h"

namespace moltact::kit {

/// The text as HTML. Links within the lesson become plain text.
std::string html(const RichText& text);

/// "a", "b" …; for the choices of the exit ticket.
std::string letter(std::size_t choice);

/// Appends the worksheet. It contains no praise, feedback, hint, note, tag or model answer. The choices of predictions
/// stand in an order that does not depend on which one is right; other questions stand without their choices, because
/// the choices of one question can answer another. Titles of steps and goals are left out for the same reason.
void worksheet(std::string& out, const Lesson& lesson);

/// Appends a sheet with the exit ticket twice, each on half a page. Nothing if the kit has none.
void exitTicket(std::string& out, const Lesson& lesson, const TeachersKit& kit);

/// The words of the glossary that the core explains and that answer none of its questions, at most six, in the order of
/// their occurrence.
std::vector<const GlossaryWord*> worksheetWords(const Lesson& lesson);

}  // namespace moltact::kit
