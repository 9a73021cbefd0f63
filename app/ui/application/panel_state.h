// Which panels and pages are open, and what a panel remembers from frame to frame. Window's thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/ui/application/side_tabs.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/seen_parts.h"
#include "engine/molecule/molecule_key.h"
#include "engine/render/colour_legend.h"

namespace moltact {

/// The card of the welcome page that the keys are at.
struct CardFocus {
  std::size_t card = ~std::size_t{0};  ///< counted from the page's first; beyond the last: none
  std::size_t cards = 0;               ///< on the page in the last frame
  std::size_t columns = 1;             ///< in the card's rows
  bool scroll = false;                 ///< the card is to be scrolled into sight
};

struct PanelState : KeyFocus {
  bool lesson = true;
  SideTabs tabs;               ///< of the panel beside the view
  bool lesson_first = true;    ///< where only one side panel has room
  bool touch_details = false;  ///< the touch panel's second half
  bool teacher_notes = false;  ///< the lesson's notes for the teacher are shown; never to the next student
  float messages_end = 0.0f;   ///< where the messages over the view ended in the last frame (unit: pixel); 0: none
  bool legend = false;         ///< the legend of colours is open where it is too large for the view
  LegendMemory colours;        ///< what it says
  /// Whether the goals at the lesson's start are open; no value: as there is room.
  std::optional<bool> lesson_goals;
  bool lesson_problems = false;         ///< the list of what is wrong with the lesson's file
  float lesson_problems_height = 0.0f;  ///< of that list, as it was last drawn (unit: pixel)
  bool arrows_draw = false;             ///< in this frame the arrow keys lead a pen in the lesson and not the probe
  std::size_t lesson_task = 0;          ///< the step's current task when it was last drawn
  float lesson_task_height = 0.0f;      ///< of its card, which does not shrink while the task goes on (unit: pixel)
  float lesson_task_width = 0.0f;       ///< with which that height was needed
  float lesson_task_y = 0.0f;           ///< where the current task's own words end (unit: pixel); 0: none
  float lesson_question_y = 0.0f;       ///< where the step's last unanswered question begins (unit: pixel); 0: none
  float lesson_text_end = 0.0f;         ///< of what is shown of the lesson's text (unit: pixel)
  SeenParts lesson_seen;                ///< of the step: what the student has had the time to see
  double lesson_done_s = -1.0;          ///< when one was done last, by the frames' clock
  struct LessonPart {
    bool task = false;  ///< a task, else a question
    std::size_t index = 0;
  };
  std::optional<LessonPart> lesson_wanted;  ///< of the step, to be scrolled into sight
  bool lesson_closed = false;               ///< the closing page stood in the lesson panel in the last frame
  bool lesson_more_below = false;           ///< some of the lesson's text lies below what is shown of it
  struct Word {
    std::string below;  ///< the block of the lesson's text below which its meaning stands, as it is recorded
    std::string id;     ///< as links write it
    friend bool operator==(const Word&, const Word&) = default;
  };
  Word word;  ///< of the glossary, whose meaning is open; empty: none
  struct LargePicture {
    std::string path, description;  ///< as the lesson names it
  };
  LargePicture picture;        ///< of the lesson, on its page
  float lesson_scroll = 0.0f;  ///< the lesson's text is to go on by so much (unit: pixel)
  bool open_page = false, controls_page = false, about_page = false, preferences_page = false, device_page = false,
       turns_page = false, zoom_page = false, look_page = false, reading_page = false, picture_page = false;
  ReadOptions reading;     ///< as it is chosen on the page for it
  std::string zoom_atoms;  ///< what was written last on the page that comes close to atoms
  bool open_adds = false;  ///< what is chosen on the page that opens files is put on the shelf
  bool welcome = false;    ///< the welcome page stands in the place of view and panels
  CardFocus card;
  float menus_end = 0.0f;     ///< where the menus end (unit: pixel): the tool bar has room from there on
  bool full_screen = false;   ///< as the window is to be
  bool fingers = false;       ///< a finger on a touch screen is what points; false: a mouse
  float below_share = 0.46f;  ///< of the room, for the panel below the view where the window is tall
  std::size_t lesson_step = ~std::size_t{0};  ///< whose text stands in the lesson panel: another begins at its top
};

}  // namespace moltact
