// The lesson's keys, in addition to those of the view. They act while no text field has the focus and no page is open.
// The page of controls lists them. Window's thread.
//
//   1 to 9 choose an answer    Enter  hands in several choices, a curve, or presses a task's first button
//   A      writes an answer    H      opens the next hint     letters on a task's buttons press them
//   G      follows the link in the feedback                   Ctrl + Page Up, Page Down  scroll the text
//
// A key acts only on a part that has been in view for SeenParts::kMoment_s, so that nobody answers below the panel's
// edge. Otherwise the key scrolls to that part. For kAfterDone_s after a task or question is done, keys do nothing: a
// last digit of one answer must not answer the next question.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

class Application;

inline constexpr double kAfterDone_s = 0.5;

/// Whether lesson keys act now: no text field has the focus, no page is open, neither Ctrl nor Alt is held.
bool lessonKeysFree();
/// Whether a digit, a capital letter or '\n' (Enter) was pressed in this frame and lesson keys act. Consumes the key:
/// later callers in this frame get false.
bool lessonKeyPressed(char key);

/// A part of the text on which a key acts: its vertical range in the window (unit: pixel).
struct KeyPart {
  std::string name;  ///< unique in the step
  float low = 0.0f, high = 0.0f;
  bool read = true;    ///< whether its context has been seen, for a choice its question
  float with = -1.0f;  ///< top of that context; negative: at the part itself
};
/// Notes the position of the part in this frame.
void noteSeen(Application& app, const KeyPart& part);
/// Whether it has been in view for kMoment_s since the step began.
bool wasSeen(const Application& app, std::string_view name);
/// Notes the part and returns whether the key was pressed and acts on it. If the part has not been seen, a press is
/// consumed and scrolls the part into view.
bool lessonKeyActs(Application& app, char key, const KeyPart& part);
/// The same for ImGui's last item.
bool lessonKeyOnItem(Application& app, char key, std::string name);
/// Called before and after the lesson's text is drawn: notes that a task or question was done in this frame.
void noteDone(Application& app);
/// Called within the window that scrolls the lesson's text: scrolls it by keys.
void scrollByKeys();

}  // namespace moltact
