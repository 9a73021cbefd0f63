// Records the rectangle and the text of each named widget in the last frame, so that scripts can find widgets. Window's
// thread. Units: pixel of the framebuffer.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace moltact {

struct WidgetRecord {
  glm::vec2 low{0.0f}, high{0.0f};            ///< the whole rectangle
  glm::vec2 clip_low{0.0f}, clip_high{0.0f};  ///< of its window; parts outside are not visible
  std::string text;                           ///< the value or label on the screen; may be empty
  bool scrolls = false;                       ///< its window can be scrolled vertically
  unsigned key_stop = 0;                      ///< the id of the ImGui item that can have the keyboard focus; 0: none

  glm::vec2 centre() const { return 0.5f * (low + high); }
  /// Whether its centre is visible.
  bool visible() const {
    const glm::vec2 c = centre();
    return c.x >= clip_low.x && c.x < clip_high.x && c.y >= clip_low.y && c.y < clip_high.y;
  }
};

class WidgetMap {
 public:
  void clear() {
    records_.clear();
    cut_.clear();
  }
  void set(std::string_view name, WidgetRecord record) {
    records_.insert_or_assign(std::string(name), std::move(record));
  }
  const WidgetRecord* find(std::string_view name) const {
    const auto it = records_.find(name);
    return it == records_.end() ? nullptr : &it->second;
  }
  const std::map<std::string, WidgetRecord, std::less<>>& all() const { return records_; }

  /// The texts that did not fit and were cut off, each once.
  const std::set<std::string>& cut() const { return cut_; }
  void noteCut(std::string text) { cut_.insert(std::move(text)); }

 private:
  std::set<std::string> cut_;
  std::map<std::string, WidgetRecord, std::less<>> records_;
};

/// The map that the panels fill. The shell clears it before each frame.
WidgetMap& widgets();

/// Records ImGui's last item under a name, with its text on the screen.
void recordItem(std::string_view name, std::string text = {});
/// The same with its own rectangle, so that a script aims at a part of the item.
void recordControl(std::string_view name, glm::vec2 low, glm::vec2 high, std::string text);
/// Records a rectangle of the current window that is not an ImGui item.
void recordRectangle(std::string_view name, glm::vec2 low, glm::vec2 high, std::string text = {});

}  // namespace moltact
