#include "app/ui/widgets/damage.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "app/ui/widgets/imgui_versions.h"
#include "engine/render/gl.h"

namespace moltact {
namespace {

void withoutBlending(const ImDrawList*, const ImDrawCmd*) { glDisable(GL_BLEND); }

class Hash {
 public:
  void add(std::uint64_t value) {
    hash_ = (hash_ ^ value) * 0x9E3779B97F4A7C15ull;
    hash_ ^= hash_ >> 29;
  }
  void add(float x, float y) {
    add(std::uint64_t(std::bit_cast<std::uint32_t>(x)) << 32 | std::bit_cast<std::uint32_t>(y));
  }
  void add(const void* p) { add(std::uint64_t(std::bit_cast<std::uintptr_t>(p))); }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ull;
};

Rectangle common(const Rectangle& a, const Rectangle& b) { return {glm::max(a.low, b.low), glm::min(a.high, b.high)}; }

Rectangle around(const Rectangle& a, const Rectangle& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

float areaOf(const Rectangle& r) { return r.empty() ? 0.0f : r.size().x * r.size().y; }

// The whole pixels inside a command's clip rectangle as ImGui's OpenGL backend computes them. It truncates place and
// size, measured from the lower left corner.
Rectangle scissorOf(const ImDrawCmd& c, float window_height) {
  const float left = std::trunc(c.ClipRect.x), bottom = window_height - std::trunc(window_height - c.ClipRect.w);
  return {{left, bottom - std::trunc(c.ClipRect.w - c.ClipRect.y)},
          {left + std::trunc(c.ClipRect.z - c.ClipRect.x), bottom}};
}

// Adds a rectangle so that all stay disjoint and few. The pair whose union wastes the fewest pixels is merged.
void add(std::vector<Rectangle>& all, Rectangle more) {
  if (more.empty()) return;
  for (std::size_t k = 0; k < all.size();) {
    if (common(all[k], more).empty()) {
      ++k;
      continue;
    }
    more = around(more, all[k]);
    all.erase(all.begin() + std::ptrdiff_t(k));
    k = 0;  // disjoint rectangles may overlap the merged one
  }
  all.push_back(more);
  if (all.size() <= Damage::kMaxRectangles) return;
  std::size_t first = 0, second = 1;
  float least = INFINITY;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b)
      if (const float waste = areaOf(around(all[a], all[b])) - areaOf(all[a]) - areaOf(all[b]); waste < least) {
        least = waste;
        first = a;
        second = b;
      }
  const Rectangle both = around(all[first], all[second]);
  all.erase(all.begin() + std::ptrdiff_t(second));
  all.erase(all.begin() + std::ptrdiff_t(first));
  add(all, both);
}

}  // namespace

std::vector<Rectangle> Damage::since(const ImDrawData& now) {
  const Rectangle whole{{0, 0}, {now.DisplaySize.x, now.DisplaySize.y}};
  bool same_windows =
      width_ == now.DisplaySize.x && height_ == now.DisplaySize.y && lists_.size() == std::size_t(now.CmdListsCount);
  width_ = now.DisplaySize.x;
  height_ = now.DisplaySize.y;
  lists_.resize(std::size_t(now.CmdListsCount));
  std::vector<Rectangle> damaged;
  std::vector<Command> commands;
  for (std::size_t k = 0; k < lists_.size(); ++k) {
    const ImDrawList& list = *now.CmdLists[int(k)];
    same_windows = same_windows && lists_[k].owner == list._OwnerName;
    commands.clear();
    for (const ImDrawCmd& c : list.CmdBuffer) {
      const Rectangle clip = scissorOf(c, height_);
      Hash hash;
      Rectangle bounds{glm::vec2(INFINITY), glm::vec2(-INFINITY)};
      hash.add(c.ClipRect.x, c.ClipRect.y);
      hash.add(c.ClipRect.z, c.ClipRect.w);
      hash.add(std::uint64_t(nameOf(c.GetTexID())));
      hash.add(c.UserCallbackData);
      for (unsigned i = 0; i < c.ElemCount; ++i) {
        const ImDrawVert& v = list.VtxBuffer[int(c.VtxOffset + list.IdxBuffer[int(c.IdxOffset + i)])];
        hash.add(v.pos.x, v.pos.y);
        hash.add(v.uv.x, v.uv.y);
        hash.add(std::uint64_t(v.col));
        bounds.low = glm::min(bounds.low, glm::vec2(v.pos.x, v.pos.y));
        bounds.high = glm::max(bounds.high, glm::vec2(v.pos.x, v.pos.y));
      }
      bounds = {glm::floor(bounds.low), glm::ceil(bounds.high)};
      // After a callback the command may draw another picture anywhere in its clip rectangle.
      if (c.UserCallback) bounds = clip;
      commands.push_back({hash.value(), common(common(bounds, clip), whole)});
    }
    std::vector<Command>& before = lists_[k].commands;
    if (same_windows)
      for (std::size_t n = 0; n < std::max(before.size(), commands.size()); ++n) {
        if (n < before.size() && n < commands.size() && before[n].hash == commands[n].hash) continue;
        if (n < before.size()) add(damaged, before[n].bounds);
        if (n < commands.size()) add(damaged, commands[n].bounds);
      }
    lists_[k].owner = list._OwnerName;
    std::swap(before, commands);
  }
  if (!same_windows) return {whole};
  return damaged;
}

void addPicture(ImDrawList& list, ImTextureID texture, const Rectangle& where, std::uint64_t version) {
  // The pointer is only compared, never dereferenced.
  list.AddCallback(withoutBlending, std::bit_cast<void*>(std::uintptr_t(version)));
  list.AddImage(texture, {where.low.x, where.low.y}, {where.high.x, where.high.y}, {0, 1}, {1, 0});
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

void drawWithin(const Rectangle& area, ImDrawData& data, ImU32 ground) {
  const float height = data.DisplaySize.y;
  const ImVec4 colour = ImGui::ColorConvertU32ToFloat4(ground);
  glViewport(0, 0, GLsizei(data.DisplaySize.x), GLsizei(height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(GLint(area.low.x), GLint(height - area.high.y), GLsizei(area.size().x), GLsizei(area.size().y));
  glClearColor(colour.x, colour.y, colour.z, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  std::vector<ImVec4> clips;
  for (int k = 0; k < data.CmdListsCount; ++k)
    for (ImDrawCmd& c : data.CmdLists[k]->CmdBuffer) {
      clips.push_back(c.ClipRect);
      const Rectangle left = common(scissorOf(c, height), area);
      c.ClipRect = {left.low.x, left.low.y, left.high.x, left.high.y};
    }
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  auto clip = clips.begin();
  for (int k = 0; k < data.CmdListsCount; ++k)
    for (ImDrawCmd& c : data.CmdLists[k]->CmdBuffer) c.ClipRect = *clip++;
}

}  // namespace moltact
