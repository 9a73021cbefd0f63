// The part of a teacher's kit that cannot be derived from a lesson: what students must know before, what touch shows,
// the limits of the model, what to ask, and the exit ticket. It stands in the folder "kits" beside the lesson, in a file
// of the lesson's name: the kit of lessons/first-touch.de.md is lessons/kits/first-touch.de.md. No view of a student
// reads these files, and packs and the browser edition do not contain them. docs/teachers-kit.md describes the format.
// Not for the haptic thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// A question for the class at a step.
struct KitPrompt {
  std::string step;           ///< id of the step; empty: none was named
  RichText question, answer;  ///< `answer` may be empty
  Place place;
};

struct TeachersKit {
  std::filesystem::path file;  ///< where the kit is, or where it belongs
  bool present = false;        ///< the file exists
  std::vector<RichText> prior_knowledge, touch_shows, limits;
  std::vector<KitPrompt> prompts;
  std::vector<Question> exit_ticket;  ///< the feedback of a wrong choice names the misconception behind it
  std::vector<RichText> curriculum;   ///< codes, each with the source that it was checked against
  std::vector<Problem> problems;      ///< text that could not be read, in the order of the file
};

inline constexpr std::size_t kExitQuestions = 3;

/// Reads the text of a kit; `name` is its name in messages.
TeachersKit readKit(const std::string& name, std::string bytes);

/// The kit of a lesson's file. Empty if there is no such file.
TeachersKit kitOf(const std::filesystem::path& lesson_file);

/// Whether a file is a kit, by its folder.
bool isKitFile(const std::filesystem::path& file);

/// What the kit lacks, each with a remedy, in the order of the kit's file. Empty for a complete kit.
std::vector<Problem> kitLacks(const Lesson& lesson, const TeachersKit& kit);

}  // namespace moltact
