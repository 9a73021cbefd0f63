// Dear ImGui in the bound framebuffer: the common part of the window and the off-screen run. Window's thread, with a
// current GL context, which must outlive the shell. Units: pixel of the framebuffer.
#pragma once

#include <functional>
#include <memory>

#include "app/ui/files/settings.h"
#include "app/ui/widgets/damage.h"
#include "app/ui/widgets/input_queue.h"

namespace moltact {

class Shell {
 public:
  Shell();
  ~Shell();
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  InputQueue& input() { return *input_; }

  /// Sets the theme, the scale and the text size (1: that of the scale) from the next frame on.
  void setLook(ThemeChoice theme, float scale, float text);
  /// A message about fonts that could not be loaded, or empty.
  const std::string& fault() const { return fault_text_; }

  /// With true, the bound framebuffer is the same in every frame and keeps its contents, so that only changes are
  /// drawn. Pass false if this is not known, as for a window with swapped buffers.
  void framebufferKept(bool kept);
  /// Runs one frame: feeds the input, calls `panels`, and draws into the bound framebuffer if `drawn`.
  void frame(int width, int height, double dt_s, const std::function<void()>& panels, bool drawn = true);

 private:
  std::unique_ptr<InputQueue> input_;
  ThemeChoice theme_ = ThemeChoice::Light;
  bool look_changed_ = true;
  float scale_ = 1.0f, text_ = 1.0f, loaded_ = 0.0f;  // loaded_: scale of the loaded fonts
  std::string fault_text_;
  Damage damage_;
  bool kept_ = false;
};

}  // namespace moltact
