// The open tabs of the panel beside the view, and the one in front. app/ui/panels/side_panel.h is the registry of tabs.
// Window's thread.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moltact {

class SideTabs {
 public:
  /// The tab that is always present, behind the others.
  static constexpr std::string_view kTouch = "touch";

  /// Whether the panel is open at all.
  bool shown() const { return now_.shown; }
  void show(bool on) { now_.shown = on; }

  bool has(std::string_view tab) const {
    return tab == kTouch || std::find(now_.tabs.begin(), now_.tabs.end(), tab) != now_.tabs.end();
  }
  const std::string& front() const { return now_.front; }
  void bringToFront(std::string_view tab) {
    if (has(tab)) now_.front = tab;
  }

  /// Opens a tab in front, and the panel.
  void open(std::string_view tab) {
    by_lesson_ = false;
    if (!has(tab)) now_.tabs.emplace_back(tab);
    now_.front = tab;
    now_.shown = true;
  }
  void close(std::string_view tab) {
    by_lesson_ = false;
    std::erase(now_.tabs, tab);
    if (!has(now_.front)) now_.front = kTouch;
  }

  /// Opens the tabs that a lesson's scene requests ("none": closes the panel). A scene without a request restores the
  /// student's earlier choice.
  void applyLesson(const std::vector<std::string>& asked) {
    if (!asked.empty()) {
      if (!by_lesson_) own_ = now_;
      by_lesson_ = true;
      set(asked);
    } else if (std::exchange(by_lesson_, false)) {
      now_ = own_;
    }
  }
  /// The same for a scene that locks its panels: reverts the student's changes, except the tab in front.
  void enforceLesson(const std::vector<std::string>& asked) {
    by_lesson_ = by_lesson_ || !asked.empty();
    const std::string front = now_.front;
    set(asked.empty() ? std::vector<std::string>{std::string(kTouch)} : asked);
    bringToFront(front);
  }

 private:
  struct State {
    bool shown = true;
    std::vector<std::string> tabs{};  // besides kTouch, in the order in which they were opened
    std::string front{kTouch};
  };

  void set(const std::vector<std::string>& asked) {
    now_.tabs.clear();
    for (const std::string& tab : asked)
      if (tab != kTouch && tab != "none") now_.tabs.push_back(tab);
    now_.front = now_.tabs.empty() ? kTouch : now_.tabs.front();
    now_.shown = !now_.tabs.empty() || std::find(asked.begin(), asked.end(), kTouch) != asked.end();
  }

  State now_, own_;  // own_: the student's choice, while a lesson's scene overrides it
  bool by_lesson_ = false;
};

}  // namespace moltact
