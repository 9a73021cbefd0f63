// Converts fingers on a touch screen to mouse input. In the view, one finger pushes. Two fingers rotate the held body,
// or with a probe the molecule, by the motion of their centre and by their twist. They zoom when they move apart. Three
// fingers rotate the molecule. While one finger pushes, a second one on a pad at the view's edge changes the push. On
// the panels, a short touch is a click, a vertical motion scrolls and a horizontal one drags. A finger that rests long
// shows the tool tip, as a hovering mouse does. The edge between two panels follows a finger at once. Window's thread.
// Units: pixel of the framebuffer, second.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/ui/widgets/input_queue.h"
#include "engine/core/units.h"

namespace moltact {

class Fingers {
 public:
  explicit Fingers(InputQueue& to) : to_(to) {}

  enum class Target {
    Panel,
    View,  ///< the view of the molecule
    Edge,  ///< between two panels; any motion drags it
    Harder,
    Lighter,  ///< the pads at the view's edge
  };

  /// A finger touches the screen. `line_px` is the height of a line of text.
  void down(int id, glm::dvec2 place_px, Target on, double now_s, double line_px);
  void move(int id, glm::dvec2 place_px);
  void up(int id);
  /// Called once per frame.
  void advance(double now_s);
  /// Whether any finger is on the screen, also after its gesture has ended.
  bool any() const { return pad_ || !fingers_.empty(); }

  static constexpr double kStill_lines = 0.6;  ///< shorter motions count as rest
  static constexpr double kLong_s = 0.5;       ///< resting time until the tool tip appears
  static constexpr double kNotch_lines = 5.0;  ///< scrolling distance of one wheel notch
  static constexpr double kNotch = 1.12;       ///< zoom factor of one wheel notch
  /// The twist of two fingers per notch of the wheel's second axis, clockwise positive (unit: radian).
  static constexpr double kTwistNotch_rad = kTwoPi / 24.0;
  static constexpr int kViewButton = 3;      ///< mouse button that is held while three fingers rotate the molecule
  static constexpr double kRepeat_s = 0.25;  ///< a held pad sends one notch of push per interval

 private:
  enum class Way {
    None,
    Waiting,  ///< on a panel; the gesture is not yet known
    Scrolling,
    Dragging,
    Telling,
    Pushing,
    Turning,
    TurningView,
    Ended,  ///< after a gesture of several fingers, the fingers that remain have no effect
  };
  struct Finger {
    int id;
    glm::dvec2 place;
  };
  glm::dvec2 middle() const;
  double spread() const;
  double direction() const;
  void letGo();
  void pushNotch(double now_s);

  InputQueue& to_;
  std::vector<Finger> fingers_;
  struct Pad {
    int id;
    double notches;  ///< per repeat
    double last_s;   ///< of the last repeat
  };
  std::optional<Pad> pad_;
  Way way_ = Way::None;
  glm::dvec2 begun_{0.0}, last_{0.0};
  double begun_s_ = 0.0, line_px_ = 16.0, last_spread_ = 0.0, last_direction_ = 0.0;
};

}  // namespace moltact
