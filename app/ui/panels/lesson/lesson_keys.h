// The keys by which a lesson is gone through without a mouse, beside those of the view: what is open in the lesson
// takes them while no text is being written and no page is open. The page of controls tells them. Window's thread.
//
//   1 to 9 choose an answer    Enter  hands in several choices, a curve, or presses a task's first button
//   A      writes an answer    H      opens the next hint     letters on a task's buttons press them
//   G      follows the link in the feedback                   Ctrl + Page Up, Page Down  scroll the text
// A key acts only on what is in view and has been there for a moment (SeenParts::kMoment_s), so that nobody answers what
// is below the panel's edge; a key for something else leads there. For a while after a task or question was done
// (kAfterDone_s) keys do nothing: the fourth digit of four places is not the answer to what comes next.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

class Application;

inline constexpr double kAfterDone_s = 0.5;

/// Whether a key of the lesson counts now: no text is being written, no page is open, neither Ctrl nor Alt is held.
bool lessonKeysFree();
/// Whether a digit, a capital letter or '\n' (Enter) was pressed now, where lesson keys count. The key is taken:
/// whoever asks next in this frame does not get it.
bool lessonKeyPressed(char key);

/// A part of the text that a key acts on, from top to bottom in the window (unit: pixel).
struct KeyPart {
  std::string name;  ///< unique in the step
  float low = 0.0f, high = 0.0f;
  bool read = true;    ///< what it belongs to has been seen as well: a choice's question
  float with = -1.0f;  ///< where that begins; negative: at the part itself
};
/// Notes that the part stands there in this frame.
void noteSeen(Application& app, const KeyPart& part);
/// Whether it has been in view for a moment since the step began.
bool wasSeen(const Application& app, std::string_view name);
/// Notes the part; whether the key was pressed and acts on it. A press on what has not been seen is taken, and brings it
/// into view.
bool lessonKeyActs(Application& app, char key, const KeyPart& part);
/// The same for ImGui's last item.
bool lessonKeyOnItem(Application& app, char key, std::string name);
/// Before and after the lesson's text is drawn: watches whether a task or question of the step was done.
void watchDone(Application& app);
/// Within the window that scrolls the lesson's text: scrolls it by the keys.
void scrollByKeys();

}  // namespace moltact
