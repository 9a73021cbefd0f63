// Fingers on a touch screen, turned into what a mouse does. In the view one finger pushes. Two turn what the hand holds,
// by the way of their middle and by their twist, or the molecule where it holds the probe, and magnify as they part;
// three turn the molecule. Beside the finger that pushes another one on a pad of the view's edge pushes harder or lighter. On the panels
// a finger that stays is a click, one that moves up or down scrolls, one that moves sideways drags, and one that rests
// for long tells what lies under it, as a mouse does that hovers; the edge between two panels follows a finger at once.
// Window's thread. Units: pixel of the framebuffer, second.
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

  enum class On {
    Panel,
    View,  ///< the view of the molecule
    Edge,  ///< between two panels; any motion drags it
    Harder,
    Lighter,  ///< the pads at the view's edge
  };

  /// A finger touches the screen. `line_px` is the height of a line of text.
  void down(int id, glm::dvec2 place_px, On on, double now_s, double line_px);
  void move(int id, glm::dvec2 place_px);
  void up(int id);
  /// Called once per frame.
  void advance(double now_s);
  /// Whether any finger is on the screen, also after its gesture has ended.
  bool any() const { return pad_ || !fingers_.empty(); }

  static constexpr double kStill_lines = 0.6;  ///< a finger that moves less stays where it is
  static constexpr double kLong_s = 0.5;       ///< so long a finger rests until it tells what lies there
  static constexpr double kNotch_lines = 5.0;  ///< a notch of the wheel scrolls so far
  static constexpr double kNotch = 1.12;       ///< and magnifies so much
  /// The angle by which two fingers twist in a notch of the wheel's second axis, clockwise positive (unit: radian).
  static constexpr double kTwistNotch_rad = kTwoPi / 24.0;
  static constexpr int kViewButton = 3;      ///< of the mouse, held while three fingers turn the molecule
  static constexpr double kRepeat_s = 0.25;  ///< a pad that is held gives a notch of push each

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
    Ended,  ///< fingers that are still down after a gesture of several do nothing more
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
