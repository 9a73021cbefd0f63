// A teacher's kit as a self-contained web page for printing on A4 or Letter: the teacher's page, the students' worksheet
// and the exit ticket. It loads nothing and runs no script. The fixed words are in the language in use (catalogue.h),
// all others in that of the lesson. Pure functions; any thread but the haptic one.
#pragma once

#include <string>

#include "engine/lesson/lesson.h"
#include "engine/lesson/teachers_kit.h"

namespace moltact {

enum class KitFor {
  Teacher,   ///< everything
  Students,  ///< the worksheet and the exit ticket, without any answer
};

/// Returns the whole file. Parts that the kit lacks are left out. `lesson` has the words of its folder's glossary
/// (linkWords()).
std::string kitPage(const Lesson& lesson, const TeachersKit& kit, KitFor whom);

/// Reads a lesson's file, its kit and its glossary and returns the page, or the first problem of a lesson that cannot be
/// read.
Expected<std::string> kitPageOf(const std::filesystem::path& lesson_file, KitFor whom);

/// The name of the page's file: "first-touch.de.kit.html".
std::string kitPageName(const std::filesystem::path& lesson_file, KitFor whom);

}  // namespace moltact
