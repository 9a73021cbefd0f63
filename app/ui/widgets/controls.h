// The controls of the panels, drawn in the program's style on Dear ImGui. Each is recorded in the widget map under
// `name`, which is also its ImGui id. Window's thread.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "app/ui/widgets/layout.h"
#include "engine/core/offered_word.h"
#include "engine/language/quantity_text.h"

namespace moltact {

enum class ButtonLook { Plain, Primary };
enum class Icon {
  None,
  Home,
  LeftPanel,
  RightPanel,
  Close,
  Check,
  ChevronRight,
  ChevronDown,
  Folder,
  File,
  Up,
  Undo,
  Redo,
  Camera,
  Gear,
  FullScreen,
  Question,
  Fit,
  Sound
};

/// A button as wide as its label, or `width` pixels (negative: the rest of the line). Returns whether it was clicked.
bool button(const char* name, const char* label, ButtonLook look = ButtonLook::Plain, float width = 0.0f,
            bool enabled = true);
/// While this object lives, text fields have the height of a button() beside them.
class FieldAsHighAsButton {
 public:
  FieldAsHighAsButton();
  ~FieldAsHighAsButton();
  FieldAsHighAsButton(const FieldAsHighAsButton&) = delete;
  FieldAsHighAsButton& operator=(const FieldAsHighAsButton&) = delete;
};
/// A square button with an icon. `tip` is the tool tip; `on` draws the button as switched on. Returns whether it was
/// clicked.
bool iconButton(const char* name, Icon icon, const char* tip, bool on = false, bool enabled = true);
/// A switch: the label at the left end of the line, the knob at the right. Returns whether it was changed.
bool toggle(const char* name, const char* label, bool& on, const char* tip = nullptr);
/// How a control formats its value.
struct ShownAs {
  Dimension dimension = Dimension::None;
  QuantityOptions how{};
  double code_units = 1.0;  ///< the value 1 in the code's unit of the dimension
};

/// A label and value above a track. `min`, `max` and `step` have the value's unit. The mouse wheel changes the value
/// by `step` while the pointer is over the control, unless the panel itself scrolls. Returns whether it was changed.
bool slider(const char* name, const char* label, double& value, double min, double max, double step,
            const ShownAs& shown_as, const char* tip = nullptr);
/// Choices side by side, given by their English labels (N_). The screen shows them in the language in use, the widget
/// map in English. Returns whether another one was chosen.
bool segments(const char* name, std::span<const std::string> labels, std::size_t& chosen);
/// The same for the words of a choice, shown by their titles; `word` is the name of the chosen one.
bool wordSegments(const char* name, std::span<const OfferedWord> words, std::string& word);
/// A line that shows or hides the content below it.
bool disclosure(const char* name, const char* label, bool& open);
/// A thin bar; `part` is from 0 (empty) to 1 (full).
void progressBar(const char* name, float part, bool done);
/// A small heading in a panel.
void sectionTitle(const char* label);
/// Shows a tool tip while the pointer rests on the last item. Null shows nothing.
void tip(const char* text);
/// Draws an icon in a square of `size` around `centre`.
void drawIcon(ImDrawList* draw, Icon icon, ImVec2 centre, float size, ImU32 colour);
/// The text, cut at `width` with an ellipsis if it is too long.
std::string elided(const std::string& text, float width);

/// Begins a panel that fills a rectangle. Returns false if the rectangle is empty; otherwise the caller must call
/// endPanel().
bool beginPanel(const char* name, const Rectangle& where, ImGuiWindowFlags flags = 0);
/// The same for an overlay above the panels, without background and padding.
bool beginOverlay(const char* name, const Rectangle& where);
void endPanel();

/// Begins a page in the middle of the window, above everything else; `open` opens it. Width and height are at 96 dpi
/// and limited to the window. Escape and its cross close it. Returns false if it is closed; otherwise the caller must
/// call endPage().
bool beginPage(const char* name, const char* title, bool& open, float width, float height);
void endPage();

}  // namespace moltact
