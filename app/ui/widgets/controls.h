// The controls that panels are made of, drawn in the program's look on Dear ImGui. Each is recorded in the widget map
// under `name`, which is also its ImGui id. Window's thread.
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

/// A button as wide as its label, or `width` pixels (negative: the rest of the line). True when it was clicked.
bool button(const char* name, const char* label, ButtonLook look = ButtonLook::Plain, float width = 0.0f,
            bool enabled = true);
/// While it lives, a text field is as high as a button(), beside which it stands.
class FieldAsHighAsButton {
 public:
  FieldAsHighAsButton();
  ~FieldAsHighAsButton();
  FieldAsHighAsButton(const FieldAsHighAsButton&) = delete;
  FieldAsHighAsButton& operator=(const FieldAsHighAsButton&) = delete;
};
/// A square button with a drawn sign. `tip` is shown while the pointer rests on it; `on` draws it as switched on.
bool iconButton(const char* name, Icon icon, const char* tip, bool on = false, bool enabled = true);
/// A switch with its label on the left of the line and the knob on the right. True when it was changed.
bool toggle(const char* name, const char* label, bool& on, const char* tip = nullptr);
/// How a control's value is shown.
struct ShownAs {
  Dimension dimension = Dimension::None;
  QuantityOptions how{};
  double code_units = 1.0;  ///< 1 of the value in the code's unit of that dimension
};

/// A label and value above a track. Ends and steps in the value's unit; the wheel moves it by `step` while the pointer
/// rests on it, unless the panel itself scrolls. True when it was changed.
bool slider(const char* name, const char* label, double& value, double least, double most, double step,
            const ShownAs& shown_as, const char* tip = nullptr);
/// Choices side by side, named by their English labels (N_), which are shown in the language in use; the widget map has
/// them in English. True when another was chosen.
bool segments(const char* name, std::span<const std::string> labels, std::size_t& chosen);
/// The same of the words of a choice, by their titles; `word` is the name of the one that is chosen.
bool wordSegments(const char* name, std::span<const OfferedWord> words, std::string& word);
/// A line that opens and closes what comes after it.
bool disclosure(const char* name, const char* label, bool& open);
/// A thin bar filled from 0 to 1.
void progressBar(const char* name, float part, bool done);
/// A small heading in a panel.
void sectionTitle(const char* label);
/// Shows the text while the pointer rests on the last item; does nothing for null.
void tip(const char* text);
/// Draws an icon in a square of `size` about a place.
void drawIcon(ImDrawList* draw, Icon icon, ImVec2 centre, float size, ImU32 colour);
/// Text cut at `width` with an ellipsis where it is too long.
std::string elided(const std::string& text, float width);

/// Begins a panel that fills a rectangle; false (and nothing to end) where that is empty. End it with endPanel().
bool beginPanel(const char* name, const Rectangle& where, ImGuiWindowFlags flags = 0);
/// The same over the panels, without a ground and paddings.
bool beginOverlay(const char* name, const Rectangle& where);
void endPanel();

/// Begins a page in the middle of the window over everything else, opened by `open`; false when it is closed. Its width
/// and height are at 96 dpi and are cut to the window. End it with endPage(). Escape and its cross close it.
bool beginPage(const char* name, const char* title, bool& open, float width, float height);
void endPage();

}  // namespace moltact
