// Dear ImGui in whatever picture is bound: what the real window and the off-screen run have in common.
// Window's thread, with a current GL context, which must outlive the shell. Units: pixel of the framebuffer.
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

  /// Asks for a theme, a scale and a size of letters (1: the scale's own) from the next frame on.
  void setLook(ThemeChoice theme, float scale, float text);
  /// A message about fonts that could not be loaded, given once; empty when all is well.
  const std::string& fault() const { return fault_text_; }

  /// The bound framebuffer is the same one in every frame and holds what was drawn before: of the next frames only that
  /// which differs is drawn. False where that is not known, as behind a window whose buffers are swapped.
  void framebufferKept(bool kept);
  /// One frame: feeds the input, calls `panels`, and draws into the bound framebuffer where `drawn`.
  void frame(int width, int height, double dt_s, const std::function<void()>& panels, bool drawn = true);

 private:
  std::unique_ptr<InputQueue> input_;
  ThemeChoice theme_ = ThemeChoice::Light;
  bool look_changed_ = true;
  float scale_ = 1.0f, text_ = 1.0f, loaded_ = 0.0f;  // loaded_: of the letters
  std::string fault_text_;
  Damage damage_;
  bool kept_ = false;
};

}  // namespace moltact
