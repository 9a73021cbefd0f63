// The pages of a live class for the teacher and the projector: HTML with every name escaped, a style sheet and a script of
// its own. Pure functions; any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/classroom/class_view.h"

namespace moltact {

struct TeacherPageFacts {
  std::string address;  ///< for students
  bool shared = false;  ///< other computers reach it
};

/// The page for the projector: the students' address, large and as a QR code, how many students are here, and the plot that
/// the teacher shows. It has no name and no secret of the teacher, and loads itself again every 5 s.
std::string boardPage(const TeacherPageFacts& facts, std::size_t here, const BoardPlot& board);

/// The page for the projector while a student shows the scene; `name` empty: without it. Its script (boardScript) fetches
/// the pictures from `scene`, and loads the page again when the student shows none any more.
std::string boardScenePage(const TeacherPageFacts& facts, std::size_t here, const std::string& name);
std::string boardScript();
/// Why the projector shows no scene now, for the class. Empty for SceneHidden::No.
std::string sceneHiddenText(SceneHidden why);

std::string teacherPage(const ClassView& view, const TeacherPageFacts& facts);
/// The parts that change, by the id of their element.
std::vector<std::pair<std::string, std::string>> teacherParts(const ClassView& view);
std::string teacherStyle();
std::string teacherScript();

}  // namespace moltact
