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

/// The pages that are open.
struct OpenPages {
  bool welcome = false;  ///< stands in the place of view and panels
  bool open = false, controls = false, about = false, preferences = false, device = false, turns = false, zoom = false,
       look = false, reading = false, picture = false;
};

/// What the lesson's panel remembers from frame to frame, most of it of the step that is shown. Heights and places: pixel.
struct LessonPanelMemory {
  bool teacher_notes = false;          ///< the lesson's notes for the teacher are shown; never to the next student
  std::optional<bool> goals;           ///< the goals at the lesson's start are open; no value: as there is room
  bool problems = false;               ///< the list of what is wrong with the lesson's file is open
  float problems_height = 0.0f;        ///< of that list, as it was last drawn
  std::size_t step = ~std::size_t{0};  ///< whose text stands there: another begins at its top
  bool closed = false;                 ///< the closing page stood there in the last frame
  std::size_t task = 0;                ///< the step's current task when it was last drawn
  float task_height = 0.0f;            ///< of its card, which does not shrink while the task goes on
  float task_width = 0.0f;             ///< with which that height was needed
  float task_y = 0.0f;                 ///< where the current task's own words end; 0: none
  float question_y = 0.0f;             ///< where the step's last unanswered question begins; 0: none
  float text_end = 0.0f;               ///< of what is shown of the text
  bool more_below = false;             ///< some of the text lies below what is shown of it
  float scroll = 0.0f;                 ///< the text is to go on by so much
  SeenParts seen;                      ///< what the student has had the time to see
  double done_s = -1.0;                ///< when a task or question was done last, by the frames' clock
  struct Part {
    bool task = false;  ///< a task, else a question
    std::size_t index = 0;
  };
  std::optional<Part> wanted;  ///< to be scrolled into sight
  struct Word {
    std::string below;  ///< the block of the text below which its meaning stands, as it is recorded
    std::string id;     ///< as links write it
    friend bool operator==(const Word&, const Word&) = default;
  };
  Word word;  ///< of the glossary, whose meaning is open; empty: none
  struct LargePicture {
    std::string path, description;  ///< as the lesson names it
  };
  LargePicture picture;  ///< on its page
};

/// The window itself, and what its bars report to each other.
struct WindowState {
  bool full_screen = false;   ///< as the window is to be
  bool fingers = false;       ///< a finger on a touch screen is what points; false: a mouse
  float below_share = 0.46f;  ///< of the room, for the panel below the view where the window is tall
  float menus_end = 0.0f;     ///< where the menus end (unit: pixel): the tool bar has room from there on
  float messages_end = 0.0f;  ///< where the messages over the view ended in the last frame (unit: pixel); 0: none
};

struct PanelState : KeyFocus {
  bool lesson = true;        ///< the lesson's panel is open
  bool lesson_first = true;  ///< where only one side panel has room
  SideTabs tabs;             ///< of the panel beside the view
  OpenPages pages;
  LessonPanelMemory lesson_memory;
  WindowState window;
  bool touch_details = false;  ///< the second half of the tab of touch
  bool legend = false;         ///< the legend of colours is open where it is too large for the view
  LegendMemory colours;        ///< what it says
  bool arrows_draw = false;    ///< in this frame the arrow keys lead a pen in the lesson and not the probe
  ReadOptions reading;         ///< as it is chosen on the page for it
  std::string zoom_atoms;      ///< what was written last on the page that comes close to atoms
  bool open_adds = false;      ///< what is chosen on the page that opens files is put on the shelf
  CardFocus card;
};

}  // namespace moltact
