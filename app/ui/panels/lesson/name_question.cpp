// Asks for a name or code when a lesson that requires one is opened.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawNameQuestion(Application& app) {
  NameAsker& asker = app.extensions().name_asker;
  bool open = asker.asking();
  const bool appears = open && !ImGui::IsPopupOpen("name");
  const bool code = asker.asksForCode();
  if (!beginPage("name", code ? tr("Your code") : tr("Your name"), open, 480, 340)) return;
  const Look& l = look();
  ImGui::TextWrapped("%s", code ? tr("This lesson asks for the code that you were given.")
                                : tr("This lesson asks for your name, so that your work can be told from others'."));
  ImGui::Spacing();
  ImGui::SetNextItemWidth(-1.0f);
  bool given = ImGui::InputText("##name", &asker.draft, ImGuiInputTextFlags_EnterReturnsTrue);
  recordItem("name/field", asker.draft);
  if (appears) writeInLastField("##name");
  {
    WithText quiet(l.palette.quiet);
    ImGui::TextWrapped("%s", tr("It is stored on this computer with your work, and your teacher's report lists it. If "
                                "you have used it here before, you continue where you left off."));
  }
  ImGui::Dummy({0, l.px(8)});
  const float whole = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x, side = l.tx(180);
  const bool written = !trimmed(asker.draft).empty();
  given = button("name/begin", tr("Begin"), ButtonLook::Primary, whole - side - gap, written) || given;
  ImGui::SameLine();
  const bool without = button("name/without", tr("Without a name"), ButtonLook::Plain, side);
  given = given && written;
  if (given || without) ImGui::CloseCurrentPopup();
  endPage();
  // Last, because the lesson is opened again. Closing the page gives no name.
  if (given)
    asker.give(std::string(asker.draft));
  else if (without || !open)
    asker.give({});
}

}  // namespace moltact
