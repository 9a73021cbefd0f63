// The teacher's page of a live class: HTML with every name escaped, a style sheet and a script of its own. Pure functions;
// any thread but the haptic one.
#pragma once

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

std::string teacherPage(const ClassView& view, const TeacherPageFacts& facts);
/// The parts that change, by the id of their element.
std::vector<std::pair<std::string, std::string>> teacherParts(const ClassView& view);
std::string teacherStyle();
std::string teacherScript();

}  // namespace moltact
