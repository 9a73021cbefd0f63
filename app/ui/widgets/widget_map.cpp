#include "app/ui/widgets/widget_map.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"

namespace moltact {
namespace {

void recordAs(std::string_view name, glm::vec2 low, glm::vec2 high, std::string text, unsigned key_stop) {
  requestGlyphs(text);
  WidgetRecord record{low, high, {}, {}, std::move(text)};
  record.key_stop = key_stop;
  if (const ImGuiWindow* window = ImGui::GetCurrentWindowRead()) {
    record.clip_low = {window->ClipRect.Min.x, window->ClipRect.Min.y};
    record.clip_high = {window->ClipRect.Max.x, window->ClipRect.Max.y};
    record.scrolls = window->ScrollMax.y > 0.0f || window->ScrollbarY;
  }
  widgets().set(name, std::move(record));
}

}  // namespace

WidgetMap& widgets() {
  static WidgetMap map;
  return map;
}

void recordRectangle(std::string_view name, glm::vec2 low, glm::vec2 high, std::string text) {
  recordAs(name, low, high, std::move(text), 0);
}

void recordControl(std::string_view name, glm::vec2 low, glm::vec2 high, std::string text) {
  recordAs(name, low, high, std::move(text), keyStop());
}

void recordItem(std::string_view name, std::string text) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  recordControl(name, {low.x, low.y}, {high.x, high.y}, std::move(text));
}

}  // namespace moltact
