// The state of the panels: which panels and pages are open, and data kept from frame to frame. Window's thread.
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

/// The card of the welcome page that has the keyboard focus.
struct CardFocus {
  std::size_t card = ~std::size_t{0};  ///< index on the page; beyond the last: none
  std::size_t cards = 0;               ///< number on the page in the last frame
  std::size_t columns = 1;             ///< number per row
  bool scroll = false;                 ///< requests scrolling to the card
};

/// The pages that are open.
struct OpenPages {
  bool welcome = false;  ///< replaces view and panels
  bool open = false, controls = false, about = false, preferences = false, device = false, turns = false, zoom = false,
       look = false, reading = false, picture = false;
};

/// Data of the lesson's panel that are kept from frame to frame, mostly for the present step. Heights and positions:
/// pixel.
struct LessonPanelMemory {
  bool teacher_notes = false;          ///< the teacher's notes are visible; reset for the next student
  std::optional<bool> goals;           ///< the goals at the lesson's start are open; no value: depending on the space
  bool problems = false;               ///< the list of the lesson file's problems is open
  float problems_height = 0.0f;        ///< of that list when last drawn (unit: pixel)
  std::size_t step = ~std::size_t{0};  ///< the step whose text is shown; another one begins at its top
  bool closed = false;                 ///< the closing page was shown in the last frame
  std::size_t task = 0;                ///< the step's current task when last drawn
  float task_height = 0.0f;            ///< height of its card, which does not shrink during the task (unit: pixel)
  float task_width = 0.0f;             ///< width for which this height was computed
  float task_y = 0.0f;                 ///< lower end of the current task's words (unit: pixel); 0: none
  float question_y = 0.0f;             ///< upper end of the step's last unanswered question (unit: pixel); 0: none
  float text_end = 0.0f;               ///< lower end of the visible part of the text
  bool more_below = false;             ///< part of the text is below the visible range
  float scroll = 0.0f;                 ///< requested scrolling of the text
  SeenParts seen;                      ///< the parts that have been visible long enough
  double done_s = -1.0;                ///< time of the last completion of a task or question on the frames' clock
  struct Part {
    bool task = false;  ///< true: a task; false: a question
    std::size_t index = 0;
  };
  std::optional<Part> wanted;  ///< the part to scroll to
  struct Word {
    std::string below;  ///< name of the text block below which the meaning is displayed
    std::string id;     ///< id in links
    friend bool operator==(const Word&, const Word&) = default;
  };
  Word word;  ///< the word whose meaning is displayed; empty: none
  struct LargePicture {
    std::string path, description;  ///< as written in the lesson
  };
  LargePicture picture;  ///< shown on its page
};

/// The state of the window, and positions that its bars pass to each other.
struct WindowState {
  bool full_screen = false;   ///< requested state of the window
  bool fingers = false;       ///< the pointer is a finger on a touch screen; false: a mouse
  float below_share = 0.46f;  ///< share of the height for the panel below the view in a tall window
  float menus_end = 0.0f;     ///< right end of the menus (unit: pixel), where the tool bar begins
  float messages_end = 0.0f;  ///< lower end of the messages over the view in the last frame (unit: pixel); 0: none
};

struct PanelState : KeyFocus {
  bool lesson = true;        ///< the lesson's panel is open
  bool lesson_first = true;  ///< if there is room for only one side panel
  SideTabs tabs;             ///< of the panel beside the view
  OpenPages pages;
  LessonPanelMemory lesson_memory;
  WindowState window;
  bool touch_details = false;  ///< the second half of the tab of touch
  bool legend = false;         ///< the colour legend is open although it is too large for the view
  LegendMemory colours;        ///< its contents
  bool arrows_draw = false;    ///< in this frame the arrow keys move a pen in the lesson instead of the probe
  ReadOptions reading;         ///< selected on the page of reading options
  std::string zoom_atoms;      ///< last input on the zoom page
  bool open_adds = false;      ///< files chosen on the open page are added to the lessons
  CardFocus card;
};

}  // namespace moltact
