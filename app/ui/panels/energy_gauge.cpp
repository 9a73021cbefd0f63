// In the view's lower right corner, beside the depth of the hand, where forces between atoms act: their energy as a bar
// from zero, down where they attract and up where they repel. A line marks the lowest energy since the scene began. Also
// drawn on a dark screen that displays the force. The depth gauge's switch hides it.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/dark_view.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// The bar's length is asinh(E / kEven), so that a weak well is seen beside a deep one; it is full at kFull.
constexpr double kEven_kcal_mol = 1.0, kFull_kcal_mol = 60.0;
constexpr double kZeroAt = 0.3;  // share of the height above zero

struct GaugeColours {
  ImU32 text, quiet, attracts, repels;
};

// From -1 to 1.
float barLength(double energy_kcal_mol) {
  const double size =
      std::asinh(std::abs(energy_kcal_mol) / kEven_kcal_mol) / std::asinh(kFull_kcal_mol / kEven_kcal_mol);
  return float(std::copysign(std::min(size, 1.0), energy_kcal_mol));
}

void drawBar(double energy_kcal_mol, double lowest_kcal_mol, ImVec2 low, ImVec2 high, const GaugeColours& colours) {
  const Look& l = look();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float middle = 0.5f * (low.x + high.x), half = l.px(11), top = low.y + l.px(8), bottom = high.y - l.px(24);
  const float zero = top + float(kZeroAt) * (bottom - top);
  const auto placeOf = [&](double energy) {
    const float length = barLength(energy);
    return length < 0.0f ? zero - length * (bottom - zero) : zero - length * (zero - top);
  };
  draw->AddRectFilled({middle - half, top}, {middle + half, bottom}, faded(colours.quiet, 0.25f), l.px(3));
  const float end = placeOf(energy_kcal_mol);
  draw->AddRectFilled({middle - half, std::min(zero, end)}, {middle + half, std::max(zero, end)},
                      energy_kcal_mol < 0.0 ? colours.attracts : colours.repels);
  draw->AddLine({middle - half - l.px(7), zero}, {middle + half + l.px(7), zero}, colours.quiet,
                std::max(1.0f, l.px(1.5f)));
  if (lowest_kcal_mol < 0.0) {
    const float mark = placeOf(lowest_kcal_mol), point = l.px(5);
    draw->AddLine({middle - half, mark}, {middle + half, mark}, colours.text, std::max(1.0f, l.px(1.5f)));
    draw->AddTriangleFilled({middle - half, mark}, {middle - half - point, mark - point},
                            {middle - half - point, mark + point}, colours.text);
  }
  const std::string text = energyBetweenAtoms(energy_kcal_mol, decimals(1));
  ImFont* font = l.font(Font::Small);
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str());
  draw->AddText(font, font->FontSize, {middle - 0.5f * extent.x, high.y - l.px(20)}, colours.text, text.c_str());
  recordRectangle("view/energy", {low.x, low.y}, {high.x, high.y}, text);
}

// The energy to be shown; none where it may not be.
std::optional<double> shownEnergy(const Application& app) {
  const auto& energy = app.scene.log().latest().molecular_energy;
  if (!app.settings.depth_gauge || !energy || !app.extensions().reveal_policy.tellsEnergy()) return std::nullopt;
  const double total = energy->total_kcal_mol();
  return std::isfinite(total) ? std::optional(total) : std::nullopt;
}

ImU32 packedColour(const Colour& c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1.0f}); }

ImVec2 gaugeSize() { return {look().px(104), look().px(124)}; }

}  // namespace

void drawEnergyGauge(Application& app, ViewRoom& room, float bottom_px) {
  const std::optional<double> energy = shownEnergy(app);
  if (!energy) return;
  const Rectangle& view = room.view;
  const Look& l = look();
  const ImVec2 size = gaugeSize();
  ImVec2 low{view.high.x - size.x - l.px(18), bottom_px - size.y};
  const auto place = [&] { return Rectangle{{low.x, low.y}, {low.x + size.x, low.y + size.y}}; };
  if (!room.isFree(place())) low.x -= l.px(100);  // the depth of the hand
  if (low.x < view.low.x + l.px(220) || low.y < view.low.y + l.px(56) || !room.isFree(place())) return;
  room.take(place());
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + size.y}, faded(l.palette.panel, 0.85f),
                                            l.px(8));
  const Theme theme = l.viewTheme();
  drawBar(*energy, app.scene.log().lowest_kcal_mol(), low, {low.x + size.x, low.y + size.y},
          {l.palette.text, l.palette.quiet, packedColour(theme.attracts), packedColour(theme.repels)});
}

void drawDarkEnergy(Application& app, const Rectangle& view, const DarkColours& colours) {
  const std::optional<double> energy = shownEnergy(app);
  if (!energy) return;
  const Look& l = look();
  const ImVec2 size = gaugeSize();
  const ImVec2 low{view.high.x - size.x - l.px(18), view.high.y - size.y - l.px(46)};
  if (low.x < 0.5f * (view.low.x + view.high.x) + l.px(100) || low.y < view.low.y) return;
  const Theme theme = l.viewTheme();
  drawBar(*energy, app.scene.log().lowest_kcal_mol(), low, {low.x + size.x, low.y + size.y},
          {colours.bright, colours.quiet, packedColour(theme.attracts), packedColour(theme.repels)});
}

}  // namespace moltact
