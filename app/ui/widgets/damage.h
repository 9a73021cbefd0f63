// Damage tracking as in compositors: finds the rectangles of the window that differ from the previous frame. Where the
// framebuffer keeps its contents, only these are redrawn. Window's thread. Units: pixel of the framebuffer, from its
// upper left corner.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "app/ui/widgets/layout.h"

namespace moltact {

class Damage {
 public:
  static constexpr std::size_t kMaxRectangles = 4;

  /// The rectangles in which `now` differs from the data of the last call: whole pixels, disjoint, at most
  /// kMaxRectangles; empty if nothing differs. Returns the whole window at the first call, after forget(), after a
  /// change of size, and when windows open, close or change their order.
  std::vector<Rectangle> since(const ImDrawData& now);
  /// Call this when the contents of the framebuffer are no longer valid.
  void forget() { width_ = height_ = 0; }

 private:
  struct Command {
    std::uint64_t hash = 0;
    Rectangle bounds;
  };
  struct List {
    const char* owner = nullptr;
    std::vector<Command> commands;
  };
  std::vector<List> lists_;
  float width_ = 0, height_ = 0;
};

/// Adds a picture without blending, its first row at the bottom. If its pixels change while the texture's name stays
/// the same, pass another `version`.
void addPicture(ImDrawList& list, ImTextureID texture, const Rectangle& where, std::uint64_t version);

/// Draws the part of `data` inside `area` into the bound framebuffer, on the background `ground`.
void drawWithin(const Rectangle& area, ImDrawData& data, ImU32 ground);

}  // namespace moltact
