// A lesson's picture, as large as the window allows.
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"

namespace moltact {

void drawPicturePage(Application& app) {
  if (!beginPage("picture", tr("Picture"), app.panels.pages.picture, 2000, 2000)) return;
  const Look& l = look();
  const LessonPanelMemory::LargePicture& picture = app.panels.lesson_memory.picture;
  const std::optional<FileLink> file = fileLink(app.lesson.file(), picture.path);
  const LessonPictures::Shown* shown = file ? &app.extensions().lesson_pictures.find(file->file) : nullptr;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float words = ImGui::CalcTextSize(picture.description.c_str(), nullptr, false, room.x).y + l.px(12);
  if (shown && shown->texture) {
    // At most four screen pixels per pixel of the picture; beyond that no detail is gained.
    const float wide = float(shown->width_px), high = float(shown->height_px);
    const float scale = std::min({room.x / wide, std::max(1.0f, room.y - words) / high, 4.0f * l.scale});
    const ImVec2 size{wide * scale, high * scale};
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (room.x - size.x));
    ImGui::Dummy(size);
    const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddImageRounded(shown->texture, low, end, {0, 0}, {1, 1}, IM_COL32_WHITE, l.px(6));
    recordItem("picture/shown", trf("Picture: {0}", picture.description));
  }
  {
    const WithText quiet(l.palette.quiet);
    ImGui::TextWrapped("%s", picture.description.c_str());
  }
  endPage();
}

}  // namespace moltact
