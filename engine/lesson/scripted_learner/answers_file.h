// The acts of a scripted learner in a lesson, as a text file lists them: one act a line, "#" begins a comment. Places
// are selections, or crease, pit, sphere or anywhere.
//
//   do                            carries out the current task as its kind shows how
//   touch PLACE                   touches it for half a second, with 0.3 N
//   press 0.8 N [on PLACE]        pushes with so much force for half a second, there or where the hand touches
//   slide PLACE                   goes there over the surface without letting go
//   wait 2 s                      stays as it is
//   pose X, Y, Z[, QW, QX, QY, QZ]
//                                 leads the hand straight there (angstrom), and evenly to the orientation of that
//                                 quaternion relative to the molecule's file; without one it keeps its orientation. A
//                                 body in the hand has its middle there
//   state 1                       moves the scene's atoms to this share of the way to its second structure, 0 to 1
//   lift                          lets go
//   method NAME                   chooses a haptic method
//   say WORD                      presses a button of the task: here, next, same, different, mark, this
//   set 1.8 Å                     sets the number that the task asks for
//   draw 0 N, 0.5 N, 1 N          draws a force curve: values at even distances over the whole axis
//   answer QUESTION: ANSWER       answers a question of the step, by the number of its place in the step or its id;
//                                 choices by number or text, several separated by ";"; else the text itself
//   next   back   go STEP-ID      to another step
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
  Selection place;            ///< not given where `word` or nothing names the place
  double number = 0.0;        ///< newton, second or angstrom
  std::vector<double> curve;  ///< newton
  PointA to;                  ///< of a pose
  std::optional<Quat> turned_to;
  std::size_t line = 0, column = 0;
};

/// The acts of a file. Every problem of the text is reported, each at its line.
struct AnswersReading {
  std::vector<LearnerAct> acts;
  std::vector<Problem> problems;
};
AnswersReading readAnswers(const std::string& file, std::string_view text);

/// Carries out the acts from the student's step on. An act that cannot be done in the lesson as it is (a question that
/// is not in the step, a place that has no atoms) is a problem; the acts after it are still carried out.
std::vector<Problem> carryOut(ScriptedLearner& learner, const std::vector<LearnerAct>& acts, const std::string& file);

}  // namespace moltact
