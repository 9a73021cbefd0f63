// The acts of a scripted learner in a lesson, read from a text file: one act per line; "#" begins a comment. PLACE is a
// selection, or crease, pit, sphere or anywhere.
//
//   do                            carries out the current task by its plan
//   touch PLACE                   touches it for half a second with 0.3 N
//   press 0.8 N [on PLACE]        exerts this force for half a second, on PLACE or where the hand touches
//   slide PLACE                   slides there over the surface in contact
//   wait 2 s                      keeps the hand at rest
//   pose X, Y, Z[, QW, QX, QY, QZ]
//                                 leads the hand straight there (angstrom), and evenly to the orientation of that
//                                 quaternion relative to the molecule's file; without one it keeps its orientation. A
//                                 body in the hand has its middle there
//   state 1                       moves the scene's atoms to this share of the way to its second structure, 0 to 1
//   lift                          lets go
//   method NAME                   chooses a haptic method
//   say WORD                      presses a button of the task: here, next, same, different, mark, this
//   set 1.8 Å                     sets the task's slider
//   draw 0 N, 0.5 N, 1 N          draws a force curve: values at equal distances over the whole axis
//   answer QUESTION: ANSWER       answers a question of the step, given by its number in the step or its id; choices
//                                 by number or text, several separated by ";"; other answers as text
//   next   back   go STEP-ID      enters another step
//
// Any thread but the haptic one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"

namespace moltact {

struct LearnerAct {
  enum class Kind { Do, Touch, Press, Slide, Pose, State, Wait, Lift, Method, Say, Set, Draw, Answer, Next, Back, Go };
  Kind kind = Kind::Do;
  std::string word;           ///< method, button, step, question, or a kind of place
  std::string text;           ///< the answer
  Selection place;            ///< not given if `word` names the place, or if there is none
  double number = 0.0;        ///< unit: newton, second or angstrom
  std::vector<double> curve;  ///< unit: newton
  PointA to;                  ///< target of a pose
  std::optional<Quat> turned_to;
  std::size_t line = 0, column = 0;
};

/// The acts of a file. Every problem of the text is reported with its line.
struct AnswersReading {
  std::vector<LearnerAct> acts;
  std::vector<Problem> problems;
};
AnswersReading readAnswers(const std::string& file, std::string_view text);

/// Carries out the acts, beginning at the student's step. Reports an act that cannot be done in this lesson (the step
/// lacks the question, the place has no atoms) as a problem and continues with the next act.
std::vector<Problem> carryOut(ScriptedLearner& learner, const std::vector<LearnerAct>& acts, const std::string& file);

}  // namespace moltact
