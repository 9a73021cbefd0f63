// The keys by which a lesson is gone through without a mouse, beside those of the view: what is open in the lesson
// takes them while no text is being written and no page is open. The page of controls tells them. Window's thread.
//
//   1 to 9 choose an answer    Enter  hands in several choices, a curve, or presses a task's first button
//   A      writes an answer    H      opens the next hint     letters on a task's buttons press them
//   G      follows the link in the feedback                   Ctrl + Page Up, Page Down  scroll the text
#pragma once

namespace moltact {

class Application;

/// Whether a key of the lesson counts now: no text is being written, no page is open, neither Ctrl nor Alt is held.
bool lessonKeysFree();
/// Whether a digit, a capital letter or '\n' (Enter) was pressed now, where lesson keys count. The key is taken:
/// whoever asks next in this frame does not get it.
bool lessonKeyPressed(char key);
/// Within the window that scrolls the lesson's text: scrolls it by the keys.
void scrollByKeys();

}  // namespace moltact
