// Damage tracking, as compositors do it: which rectangles of the window look other than in the frame before, so that only
// they are drawn again where the framebuffer keeps what was drawn. Window's thread. Units: pixel of the framebuffer, from
// its upper left corner.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "app/ui/widgets/layout.h"

namespace moltact {

class Damage {
 public:
  static constexpr std::size_t kMaxRectangles = 4;

  /// What `now` draws otherwise than the last call's data: whole pixels, disjoint, at most kMaxRectangles; empty where
  /// nothing differs. The whole window at the first call, after forget(), after a change of size and where windows open,
  /// close or change their order.
  std::vector<Rectangle> since(const ImDrawData& now);
  /// The framebuffer holds nothing of use any more.
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

/// Adds a picture without blending, its first row at the bottom. Its pixels may change while the texture's name stays:
/// then `version` is another.
void addPicture(ImDrawList& list, ImTextureID texture, const Rectangle& where, std::uint64_t version);

/// Draws the part of `data` that lies in `area` into the bound framebuffer, on `ground`.
void drawWithin(const Rectangle& area, ImDrawData& data, ImU32 ground);

}  // namespace moltact
