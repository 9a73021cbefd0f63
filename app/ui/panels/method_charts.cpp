#include "app/ui/panels/method_charts.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr double kMinError_A = 1e-4, kMaxError_A = 10.0;  // smaller errors are drawn on the lowest line, labelled 0
constexpr float kLeftMargin = 38.0f;                      // for the labels of the vertical axis, in both charts

struct Frame {
  ImVec2 low, high;  // of the plotting area
  float small;
  float x(double time_us) const {
    const double part = std::log10(std::max(time_us, 1e-9) / TickHistogram::kMin_us) /
                        std::log10(TickHistogram::kMax_us / TickHistogram::kMin_us);
    return low.x + (high.x - low.x) * float(std::clamp(part, 0.0, 1.0));
  }
};

void text(ImVec2 at, ImU32 colour, const std::string& words, float size, float align = 0.0f) {
  ImFont* font = look().font(Font::Small);
  const float width = font->CalcTextSizeA(size, 1e9f, 0.0f, words.c_str()).x;
  ImGui::GetWindowDrawList()->AddText(font, size, {at.x - align * width, at.y}, colour, words.c_str());
}

std::string tickTimeText(double time_us) {
  if (time_us < 1.0) return quantityText(time_us * 1e-6, Dimension::Time, {decimals(0), "ns"});
  return quantityText(time_us * 1e-6, Dimension::Time, {decimals(time_us < 10 ? 1 : 0), "µs"});
}

std::string errorText(double error_A) {
  if (error_A < kMinError_A) return tr("no error");
  return quantityText(error_A, Dimension::Length, plain(error_A < 1e-3 ? 1 : 2));
}

// Draws a title line with a value, the plotting area below it on a raised background, and the numbers of the time axis.
Frame begin(const char* title, const std::string& reading, float height) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float small = l.font(Font::Small)->FontSize, head = small + l.px(6), foot = small + l.px(2);
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, head + l.px(height) + foot});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  text(low, p.quiet, title, small);
  text({high.x, low.y}, p.text, reading, small, 1.0f);
  Frame f{{low.x + l.tx(kLeftMargin), low.y + head}, {high.x, high.y - foot}, small};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(f.low, f.high, p.raised, l.px(6));
  if (l.font(Font::Small)->CalcTextSizeA(small, 1e9f, 0.0f, (std::string(title) + reading).c_str()).x > high.x - low.x)
    widgets().noteCut(title);
  for (const double time_us : {0.1, 1.0, 10.0}) {
    const std::string words = quantityText(time_us * 1e-6, Dimension::Time, {plain(), "µs"});
    const float x = std::round(f.x(time_us));
    draw->AddLine({x, f.low.y}, {x, f.high.y}, p.line, 1.0f);
    text({x, f.high.y + l.px(2)}, p.faint, words, small * 0.86f, 0.5f);
  }
  return f;
}

}  // namespace

void tickHistogram(const char* name, const MethodRecord* record, float height) {
  const Look& l = look();
  const Palette& p = l.palette;
  const bool any = record && !record->times.empty();
  const std::string reading =
      any ? trf("half within {0}", tickTimeText(record->times.quantile_us(0.5))) : tr("touch to measure");
  const Frame f = begin(tr("Time for a tick"), reading, height);
  if (any) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    double most = 0.0;
    for (int k = 0; k < TickHistogram::kBins; ++k) most = std::max(most, record->times.share(k));
    const float wide = (f.high.x - f.low.x) / float(TickHistogram::kBins), tall = f.high.y - f.low.y - l.px(6);
    for (int k = 0; k < TickHistogram::kBins; ++k) {
      const double share = record->times.share(k);
      if (share <= 0.0) continue;
      const float x = f.low.x + wide * float(k), h = std::max(l.px(1.5f), tall * float(share / most));
      draw->AddRectFilled({x + 0.08f * wide, f.high.y - h}, {x + 0.92f * wide, f.high.y}, p.accent, l.px(1));
    }
    text({f.low.x - l.px(6), f.low.y}, p.faint, quantityText(double(most), Dimension::Share), f.small * 0.86f, 1.0f);
  }
  recordItem(name, reading);
}

void speedAccuracyChart(const char* name, const MethodWatch& watch, const std::string& in_use, float height) {
  const Look& l = look();
  const Palette& p = l.palette;
  const MethodRecord* live = watch.find(in_use);
  const bool judged = live && live->ticks >= MethodWatch::kJudged_ticks && !live->times.empty();
  const std::string reading = judged ? errorText(live->error_A) : tr("touch to measure");
  const Frame f = begin(tr("Error against time"), reading, height);
  recordItem(name, reading);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float inset = l.px(9), y0 = f.high.y - inset, y1 = f.low.y + inset;
  const double decades = std::log10(kMaxError_A / kMinError_A);
  const auto y = [&](double error_A) {
    return y0 -
           (y0 - y1) * float(std::clamp(std::log10(std::max(error_A, kMinError_A) / kMinError_A) / decades, 0.0, 1.0));
  };
  double at = kMinError_A;
  for (int k = 0; k < 6; ++k, at *= 10.0) {
    if (k == 2 || k == 4) continue;
    const std::string mark = k == 0   ? "0"
                             : k == 5 ? quantityText(at, Dimension::Length, plain(2))
                                      : quantityNumber(at, Dimension::Length, plain(2));
    draw->AddLine({f.low.x, y(at)}, {f.high.x, y(at)}, p.line, 1.0f);
    text({f.low.x - l.px(6), y(at) - 0.43f * f.small}, p.faint, mark, f.small * 0.86f, 1.0f);
  }

  struct Box {
    ImVec2 low, high;
    bool meets(const Box& o) const {
      return low.x < o.high.x && o.low.x < high.x && low.y < o.high.y && o.low.y < high.y;
    }
  };
  std::vector<Box> taken;
  const float dot = l.px(3.5f), label_size = f.small * 0.92f;
  ImFont* font = l.font(Font::Small);
  // All marks first, so that no name covers one; then the names, that of the method in use first.
  std::vector<const MethodRecord*> shown;
  for (const MethodRecord& r : watch.tried())
    if (r.ticks >= MethodWatch::kJudged_ticks && !r.times.empty()) shown.push_back(&r);
  std::stable_partition(shown.begin(), shown.end(), [&](const MethodRecord* r) { return r == live; });
  const auto place = [&](const MethodRecord& r) { return ImVec2{f.x(r.times.quantile_us(0.5)), y(r.error_A)}; };
  for (const MethodRecord* r : shown) {
    const ImVec2 c = place(*r);
    taken.push_back({{c.x - dot, c.y - dot}, {c.x + dot, c.y + dot}});
  }
  draw->PushClipRect(f.low, f.high, true);
  for (const MethodRecord* r : shown) {
    const ImVec2 c = place(*r);
    const bool now = r == live;
    if (now) draw->AddCircleFilled(c, l.px(9), faded(p.accent, 0.22f), 32);
    draw->AddCircleFilled(c, now ? l.px(5) : dot, now ? p.accent : p.faint, 24);
    const std::string label = methodTitle(r->method);
    const ImVec2 size = font->CalcTextSizeA(label_size, 1e9f, 0.0f, label.c_str());
    const float off = (now ? l.px(9) : dot) + l.px(3);
    const ImVec2 tries[] = {{c.x + off, c.y - 0.5f * size.y},          {c.x - off - size.x, c.y - 0.5f * size.y},
                            {c.x - 0.5f * size.x, c.y - off - size.y}, {c.x - 0.5f * size.x, c.y + off},
                            {c.x + off, c.y - 1.3f * size.y},          {c.x + off, c.y + 0.3f * size.y},
                            {c.x - off - size.x, c.y - 1.3f * size.y}, {c.x - off - size.x, c.y + 0.3f * size.y},
                            {c.x + 2 * off, c.y - 1.8f * size.y},      {c.x + 2 * off, c.y + 0.8f * size.y}};
    for (const ImVec2& t : tries) {
      const Box box{t, {t.x + size.x, t.y + size.y}};
      const bool inside = box.low.x >= f.low.x + l.px(2) && box.high.x <= f.high.x - l.px(2) && box.low.y >= f.low.y &&
                          box.high.y <= f.high.y;
      const Box own{{c.x - dot, c.y - dot}, {c.x + dot, c.y + dot}};
      // A name may cover a mark only if that mark overlaps its own, and never another name.
      const auto marks_end = taken.begin() + std::ptrdiff_t(shown.size());
      if (!inside ||
          std::any_of(taken.begin(), marks_end, [&](const Box& b) { return b.meets(box) && !b.meets(own); }) ||
          std::any_of(marks_end, taken.end(), [&](const Box& b) { return b.meets(box); }))
        continue;
      taken.push_back(box);
      text(t, now ? p.text : p.quiet, label, label_size);
      break;
    }
    recordRectangle(std::string(name) + "/" + r->method, {c.x - dot, c.y - dot}, {c.x + dot, c.y + dot},
                    tickTimeText(r->times.quantile_us(0.5)) + ", " + errorText(r->error_A));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsWindowHovered() && std::hypot(mouse.x - c.x, mouse.y - c.y) < l.px(9))
      ImGui::SetTooltip("%s: %s, %s", label.c_str(), tickTimeText(r->times.quantile_us(0.5)).c_str(),
                        errorText(r->error_A).c_str());
  }
  draw->PopClipRect();
}

}  // namespace moltact
