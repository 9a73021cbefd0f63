// Fingers are converted to mouse input: checked by what ImGui receives.
#include "app/ui/widgets/fingers.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <cmath>
#include <memory>
#include <vector>

namespace moltact {
namespace {

// The input that ImGui received in one frame.
struct Heard {
  glm::dvec2 place{0.0};
  bool left = false, right = false, view = false;
  double wheel = 0.0, twist_deg = 0.0;
};

class TouchScreen {
 public:
  TouchScreen() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1000, 1000};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    queue = std::make_unique<InputQueue>();
    fingers = std::make_unique<Fingers>(*queue);
  }
  ~TouchScreen() { ImGui::DestroyContext(); }
  TouchScreen(const TouchScreen&) = delete;
  TouchScreen& operator=(const TouchScreen&) = delete;

  /// Frames until all has been heard; what was heard in each.
  std::vector<Heard> frames() {
    std::vector<Heard> out;
    do {
      ImGuiIO& io = ImGui::GetIO();
      io.DeltaTime = 1.0f / 60.0f;
      queue->feed(io);
      ImGui::NewFrame();
      out.push_back({{double(io.MousePos.x), double(io.MousePos.y)},
                     ImGui::IsMouseDown(0),
                     ImGui::IsMouseDown(1),
                     ImGui::IsMouseDown(Fingers::kViewButton),
                     double(io.MouseWheel),
                     glm::degrees(double(io.MouseWheelH) * Fingers::kTwistNotch_rad)});
      ImGui::EndFrame();
    } while (!queue->empty());
    return out;
  }
  Heard last() { return frames().back(); }
  double wheeled() {
    double sum = 0;
    for (const Heard& h : frames()) sum += h.wheel;
    return sum;
  }

  std::unique_ptr<InputQueue> queue;
  std::unique_ptr<Fingers> fingers;
};

constexpr double kLine_px = 20.0;
constexpr Fingers::Target kView = Fingers::Target::View, kPanel = Fingers::Target::Panel;

}  // namespace

TEST_CASE(
    "one finger on the view pushes from the first moment where it is, follows, and points at nothing when lifted") {
  TouchScreen screen;
  screen.fingers->down(7, {300, 400}, kView, 0.0, kLine_px);
  Heard now = screen.last();
  CHECK(now.left);
  CHECK(now.place == glm::dvec2(300, 400));
  screen.fingers->move(7, {303, 404});
  now = screen.last();
  CHECK(now.left);
  CHECK(now.place == glm::dvec2(303, 404));
  screen.fingers->advance(5.0);  // a push may last
  CHECK(screen.last().left);
  screen.fingers->up(7);
  now = screen.last();
  CHECK_FALSE(now.left);
  CHECK(now.place.x < -1e30);
}

TEST_CASE("a finger that stays within 12 pixels on a panel is one click where it began") {
  TouchScreen screen;
  screen.fingers->down(1, {50, 60}, kPanel, 0.0, kLine_px);
  CHECK_FALSE(screen.last().left);
  screen.fingers->move(1, {55, 70});  // 11.2 pixels: it trembles
  CHECK_FALSE(screen.last().left);
  screen.fingers->up(1);
  const std::vector<Heard> heard = screen.frames();
  int pressed = 0;
  for (const Heard& h : heard)
    if (h.left) {
      ++pressed;
      CHECK(h.place == glm::dvec2(50, 60));
    }
  CHECK(pressed == 1);
  CHECK_FALSE(heard.back().left);
}

TEST_CASE("a finger that moves 200 pixels down a panel scrolls two notches of five 20-pixel lines and clicks nothing") {
  TouchScreen screen;
  screen.fingers->down(1, {50, 60}, kPanel, 0.0, kLine_px);
  double wheel = 0.0;
  bool pressed = false;
  for (int y = 70; y <= 260; y += 10) {
    screen.fingers->move(1, {51, double(y)});
    for (const Heard& h : screen.frames()) wheel += h.wheel, pressed = pressed || h.left;
  }
  screen.fingers->up(1);
  for (const Heard& h : screen.frames()) wheel += h.wheel, pressed = pressed || h.left;
  CHECK(wheel == doctest::Approx(2.0).epsilon(1e-5));
  CHECK_FALSE(pressed);
}

TEST_CASE("a finger that moves sideways on a panel drags what it began on, and lets it go when lifted") {
  TouchScreen screen;
  screen.fingers->down(1, {50, 60}, kPanel, 0.0, kLine_px);
  screen.frames();
  screen.fingers->move(1, {90, 62});
  const std::vector<Heard> heard = screen.frames();
  CHECK(heard.back().left);
  CHECK(heard.back().place == glm::dvec2(90, 62));
  bool began_there = false;
  for (const Heard& h : heard) began_there = began_there || (h.left && h.place == glm::dvec2(50, 60));
  CHECK(began_there);
  screen.fingers->up(1);
  CHECK_FALSE(screen.last().left);
}

TEST_CASE("a finger on the edge between two panels drags it straight up, from its first moment to its last") {
  TouchScreen screen;
  screen.fingers->down(1, {50, 400}, Fingers::Target::Edge, 0.0, kLine_px);
  Heard now = screen.last();
  CHECK(now.left);
  CHECK(now.place == glm::dvec2(50, 400));
  screen.fingers->move(1, {50, 300});
  now = screen.last();
  CHECK(now.left);
  CHECK(now.place == glm::dvec2(50, 300));
  CHECK(now.wheel == 0.0);
  screen.fingers->up(1);
  now = screen.last();
  CHECK_FALSE(now.left);
  CHECK(now.place.x < -1e30);
}

TEST_CASE("a finger that rests on a panel for longer than half a second hovers there and does not click") {
  TouchScreen screen;
  screen.fingers->down(1, {50, 60}, kPanel, 10.0, kLine_px);
  screen.fingers->advance(10.4);
  screen.fingers->advance(10.6);
  Heard now = screen.last();
  CHECK(now.place == glm::dvec2(50, 60));
  CHECK_FALSE(now.left);
  screen.fingers->up(1);
  for (const Heard& h : screen.frames()) CHECK_FALSE(h.left);
}

TEST_CASE("two fingers on the view let go of the push, turn by the way of their middle and magnify as they part") {
  TouchScreen screen;
  screen.fingers->down(1, {300, 400}, kView, 0.0, kLine_px);
  screen.frames();
  screen.fingers->down(2, {400, 400}, kView, 0.1, kLine_px);
  Heard now = screen.last();
  CHECK_FALSE(now.left);
  CHECK(now.right);
  CHECK(now.place == glm::dvec2(350, 400));

  // Both move 30 to the right: so does their centre, and their distance is unchanged in the end.
  screen.fingers->move(1, {330, 400});
  double wheel = screen.wheeled();
  screen.fingers->move(2, {430, 400});
  wheel += screen.wheeled();
  CHECK(wheel == doctest::Approx(0.0).epsilon(1e-5));
  now = screen.last();
  CHECK(now.place == glm::dvec2(380, 400));
  CHECK(now.right);

  // From 100 to 125.44 apart: magnified 1.2544 times, which is two notches of 1.12.
  screen.fingers->move(2, {455.44, 400});
  CHECK(screen.wheeled() == doctest::Approx(2.0).epsilon(1e-4));

  screen.fingers->up(1);
  now = screen.last();
  CHECK_FALSE(now.right);
  // The remaining finger does not push.
  screen.fingers->move(2, {500, 500});
  for (const Heard& h : screen.frames()) CHECK_FALSE((h.left || h.right));
  screen.fingers->up(2);
  screen.fingers->down(3, {200, 200}, kView, 2.0, kLine_px);
  CHECK(screen.last().left);
}

TEST_CASE("two fingers that twist by 50 degrees, through the half turn of their line, give 50 degrees and no zoom") {
  TouchScreen screen;
  const auto at = [](double deg) {
    return glm::dvec2(300, 400) + 80.0 * glm::dvec2(std::cos(deg * 0.01745329252), std::sin(deg * 0.01745329252));
  };
  screen.fingers->down(1, at(160), kView, 0.0, kLine_px);
  screen.fingers->down(2, at(-20), kView, 0.1, kLine_px);
  screen.frames();
  double twist_deg = 0.0, wheel = 0.0;
  const auto hear = [&] {
    for (const Heard& h : screen.frames()) {
      twist_deg += h.twist_deg;
      wheel += h.wheel;
      CHECK(h.right);
      CHECK_FALSE(h.left);
    }
  };
  for (int k = 1; k <= 50; ++k) {
    screen.fingers->move(1, at(160 + k));
    screen.fingers->move(2, at(-20 + k));
    hear();
  }
  CHECK(twist_deg == doctest::Approx(50.0).epsilon(1e-4));  // clockwise, because the pixels' y axis points down
  CHECK(std::abs(wheel) < 1e-4);
  // And back.
  for (int k = 49; k >= 0; --k) {
    screen.fingers->move(1, at(160 + k));
    screen.fingers->move(2, at(-20 + k));
    hear();
  }
  CHECK(std::abs(twist_deg) < 1e-3);
  // Fingers at the same point have no direction: passing through each other is not a twist.
  screen.fingers->move(2, at(160));
  screen.fingers->move(1, at(-20));
  twist_deg = 0.0;
  hear();
  CHECK(std::abs(twist_deg) < 1e-9);
}

TEST_CASE("a third finger takes the turn over for the view, by the way of the middle of three, and a fourth ends it") {
  TouchScreen screen;
  screen.fingers->down(1, {300, 400}, kView, 0.0, kLine_px);
  screen.fingers->down(2, {400, 400}, kView, 0.1, kLine_px);
  screen.frames();
  screen.fingers->down(3, {500, 430}, kView, 0.2, kLine_px);
  Heard now = screen.last();
  CHECK(now.view);
  CHECK_FALSE(now.right);
  CHECK(now.place == glm::dvec2(400, 410));
  screen.fingers->move(3, {530, 460});
  now = screen.last();
  CHECK(now.view);
  CHECK(now.place == glm::dvec2(410, 420));
  CHECK(now.wheel == 0.0);
  CHECK(now.twist_deg == 0.0);
  screen.fingers->down(4, {100, 100}, kView, 0.3, kLine_px);
  now = screen.last();
  CHECK_FALSE((now.view || now.right || now.left));
  screen.fingers->move(1, {310, 400});
  now = screen.last();
  CHECK_FALSE((now.view || now.right || now.left));
}

TEST_CASE("a pad held for 0.6 s beside the finger that pushes gives three notches, and the push stays where it is") {
  for (const bool harder : {true, false}) {
    TouchScreen screen;
    screen.fingers->down(1, {300, 400}, kView, 0.0, kLine_px);
    screen.frames();
    double wheel = 0.0;
    const auto hear = [&] {
      for (const Heard& h : screen.frames()) {
        wheel += h.wheel;
        CHECK(h.left);
        CHECK(h.place == glm::dvec2(300, 400));
      }
    };
    screen.fingers->down(2, {900, 700}, harder ? Fingers::Target::Harder : Fingers::Target::Lighter, 1.0, kLine_px);
    hear();
    for (int k = 1; k <= 60; ++k) {
      screen.fingers->advance(1.0 + 0.01 * k);
      hear();
    }
    screen.fingers->up(2);
    screen.fingers->advance(9.0);
    hear();
    CHECK(wheel == doctest::Approx(harder ? 3.0 : -3.0));
    // One more turn of the same fingers: the pad alone does nothing.
    screen.fingers->up(1);
    screen.frames();
    screen.fingers->down(3, {900, 700}, Fingers::Target::Harder, 10.0, kLine_px);
    screen.fingers->advance(11.0);
    for (const Heard& h : screen.frames()) {
      CHECK(h.wheel == 0.0);
      CHECK_FALSE(h.left);
    }
  }
}

TEST_CASE("a third finger, one that was never put down and one put down twice leave no button pressed in the end") {
  TouchScreen screen;
  screen.fingers->move(9, {1, 1});
  screen.fingers->up(9);
  screen.fingers->down(1, {300, 400}, kView, 0.0, kLine_px);
  screen.fingers->down(1, {310, 400}, kView, 0.0, kLine_px);
  screen.fingers->down(2, {400, 400}, kView, 0.0, kLine_px);
  screen.fingers->down(3, {500, 400}, kView, 0.0, kLine_px);
  for (const int id : {2, 1, 3}) screen.fingers->up(id);
  const Heard now = screen.last();
  CHECK_FALSE(now.left);
  CHECK_FALSE(now.right);
}

}  // namespace moltact
