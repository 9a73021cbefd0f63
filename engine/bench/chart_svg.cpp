#include "engine/bench/chart_svg.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "engine/bench/log_axis.h"
#include "engine/core/svg.h"
#include "engine/core/units.h"
#include "engine/core/utf8.h"

namespace moltact::bench {
namespace {

constexpr double kPanelWidth = 560, kPanelHeight = 430, kLeft = 84, kRight = 20, kTop = 84, kBottom = 66, kFont = 14;
constexpr double kMark = 6, kRowGap = 30;
constexpr std::size_t kColumns = 2;

double textWidth(const std::string& text) { return 0.56 * kFont * double(characterCount(text)); }

struct Box {
  double x0, y0, x1, y1;
  double overlap(const Box& b) const {
    return std::max(0.0, std::min(x1, b.x1) - std::max(x0, b.x0)) *
           std::max(0.0, std::min(y1, b.y1) - std::max(y0, b.y0));
  }
};

void drawMark(Svg& svg, Mark kind, double x, double y) {
  const double r = kMark;
  const std::string solid = "class=\"mark\" fill=\"#1a1a1a\" stroke=\"white\" stroke-width=\"1\"",
                    hollow = "class=\"mark\" fill=\"white\" stroke=\"#1a1a1a\" stroke-width=\"2\"";
  const auto polygon = [&](std::initializer_list<std::array<double, 2>> corners, const std::string& look) {
    std::string d;
    for (const auto& c : corners) d += svgPoint(d.empty() ? 'M' : 'L', x + c[0], y + c[1]);
    svg.path(d + "Z", look);
  };
  switch (kind) {
    case Mark::Disc:
      svg.circle(x, y, r, solid);
      break;
    case Mark::Circle:
      svg.circle(x, y, r, hollow);
      break;
    case Mark::Square:
      polygon({{-r, -r}, {r, -r}, {r, r}, {-r, r}}, hollow);
      break;
    case Mark::Triangle:
      polygon({{0, -r - 1}, {r + 1, r}, {-r - 1, r}}, hollow);
      break;
    case Mark::Diamond:
      polygon({{0, -r - 2}, {r + 2, 0}, {0, r + 2}, {-r - 2, 0}}, solid);
      break;
    case Mark::Cross:
      svg.path(svgPoint('M', x - r, y - r) + svgPoint('L', x + r, y + r) + svgPoint('M', x - r, y + r) +
                   svgPoint('L', x + r, y - r),
               "class=\"mark\" fill=\"none\" stroke=\"#1a1a1a\" stroke-width=\"2.5\"");
      break;
  }
}

std::string power(int exponent) {
  if (exponent >= 0 && exponent <= 3) return std::to_string(static_cast<int>(std::pow(10, exponent)));
  if (exponent < 0 && exponent >= -3) return "0." + std::string(std::size_t(-exponent - 1), '0') + "1";
  static const std::array<const char*, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = "10";
  if (exponent < 0) out += "⁻";
  for (const char c : std::to_string(std::abs(exponent))) out += kRaised[std::size_t(c - '0')];
  return out;
}

void drawAxes(Svg& svg, const ChartPanel& panel, const LogAxis& x, const LogAxis& y, double x0, double x1, double y0,
              double y1) {
  const std::string fine = "stroke=\"#ececec\" stroke-width=\"1\"", grid = "stroke=\"#cfcfcf\" stroke-width=\"1\"",
                    frame = "stroke=\"#1a1a1a\" stroke-width=\"1.2\"";
  const auto minor = [&](const LogAxis& axis, auto&& draw) {
    if (axis.high() - axis.low() > 9) return;
    for (int e = int(axis.low()); e < int(axis.high()); ++e)
      for (int m = 2; m < 10; ++m)
        if (!axis.hidden(e + std::log10(m))) draw(axis.at(m * std::pow(10.0, e)));
  };
  minor(x, [&](double p) { svg.line(p, y0, p, y1, fine); });
  if (!y.cut()) minor(y, [&](double p) { svg.line(x0, p, x1, p, fine); });
  for (const int e : x.decades()) {
    const double p = x.at(std::pow(10.0, e));
    svg.line(p, y0, p, y1, grid);
    svg.text(p, y1 + 20, "middle", power(e));
  }
  for (const int e : y.decades()) {
    const double p = y.at(std::pow(10.0, e));
    svg.line(x0, p, x1, p, grid);
    svg.text(x0 - 8, p + 5, "end", power(e));
  }
  svg.line(x0, y1, x1, y1, frame);
  svg.line(x0, y0, x0, y1, frame);
  if (y.cut()) {
    const double p = y.cutMiddle();
    svg.path(svgPoint('M', x0 - 7, p + 8) + "l14 -6" + svgPoint('M', x0 - 7, p + 1) + "l14 -6",
             "stroke=\"#1a1a1a\" stroke-width=\"1.2\" fill=\"none\"");
    svg.line(x0 + 9, p, x1, p, "stroke=\"#8a8a8a\" stroke-width=\"1\" stroke-dasharray=\"1 5\"");
  }
  svg.text(x0, y0 - 14, "start", panel.title, "font-weight=\"bold\"");
  svg.text((x0 + x1) / 2, y1 + 44, "middle", panel.x_axis);
  const double mid = (y0 + y1) / 2;
  svg.text(x0 - 58, mid, "middle", panel.y_axis,
           "transform=\"rotate(-90 " + svgNumber(x0 - 58) + " " + svgNumber(mid) + ")\"");
}

// Places each label where it covers least: beside its mark if possible, else farther away with a thin line.
void drawLabels(Svg& svg, const ChartPanel& panel, const LogAxis& x, const LogAxis& y, const Box& frame) {
  struct Place {
    double x, y;
    const std::string* label;
  };
  std::vector<Place> places;
  std::vector<Box> taken;
  for (const ChartSeries& s : panel.series)
    for (const ChartPoint& p : s.points) {
      if (!(p.x > 0) || !(p.y > 0) || !s.marked) continue;
      const double px = x.at(p.x), py = y.at(p.y);
      taken.push_back({px - kMark - 2, py - kMark - 2, px + kMark + 2, py + kMark + 2});
      if (!p.label.empty()) places.push_back({px, py, &p.label});
    }
  for (const Place& place : places) {
    const double w = textWidth(*place.label), h = kFont;
    Box best{};
    double smallest = 1e300;
    for (double away = 10; away <= 74; away += 16)
      for (int side = 0; side < 12; ++side) {
        const double turn = kTwoPi * side / 12, cx = std::cos(turn), cy = -std::sin(turn);
        const double mx = place.x + cx * (away + w / 2), my = place.y + cy * (away + h / 2);
        const Box b{mx - w / 2, my - h / 2, mx + w / 2, my + h / 2};
        double cost = 0.4 * (away - 10) + 0.02 * side;
        const Box roomy{b.x0 - 6, b.y0 - 1, b.x1 + 6, b.y1 + 1};
        for (const Box& t : taken) cost += 6 * roomy.overlap(t);
        cost += 6 * (w * h - b.overlap(frame));
        if (cost < smallest) smallest = cost, best = b;
      }
    taken.push_back(best);
    const double nx = std::clamp(place.x, best.x0, best.x1), ny = std::clamp(place.y, best.y0, best.y1);
    if (std::hypot(nx - place.x, ny - place.y) > 14)
      svg.line(place.x, place.y, nx, ny, "stroke=\"#8a8a8a\" stroke-width=\"1\"");
    const double middle = (best.x0 + best.x1) / 2;
    svg.text(middle, best.y1 - 3, "middle", *place.label,
             "stroke=\"white\" stroke-width=\"4\" stroke-linejoin=\"round\"");
    svg.text(middle, best.y1 - 3, "middle", *place.label);
  }
}

void drawPanel(Svg& svg, const ChartPanel& panel, double left, double top) {
  const double x0 = left + kLeft, x1 = left + kPanelWidth - kRight, y0 = top, y1 = top + kPanelHeight - kBottom;
  std::vector<double> xs, ys;
  for (const ChartSeries& s : panel.series)
    for (const ChartPoint& p : s.points)
      if (p.x > 0 && p.y > 0) xs.push_back(p.x), ys.push_back(p.y);
  const LogAxis x(xs, x0, x1, false), y(ys, y1, y0, true);
  drawAxes(svg, panel, x, y, x0, x1, y0, y1);
  for (const ChartSeries& s : panel.series) {
    if (!s.joined) continue;
    std::string d;
    for (const ChartPoint& p : s.points)
      if (p.x > 0 && p.y > 0) d += svgPoint(d.empty() ? 'M' : 'L', x.at(p.x), y.at(p.y));
    svg.path(d, std::string("fill=\"none\" stroke=\"#5a5a5a\" stroke-width=\"1.6\"") +
                    (s.dashed ? " stroke-dasharray=\"7 4\"" : ""));
  }
  for (const ChartSeries& s : panel.series)
    for (const ChartPoint& p : s.points)
      if (s.marked && p.x > 0 && p.y > 0) drawMark(svg, s.mark, x.at(p.x), y.at(p.y));
  drawLabels(svg, panel, x, y, {x0 + 2, y0, x1, y1 - 2});
}

}  // namespace

std::string chartSvg(const std::string& title, const std::vector<ChartPanel>& panels, const std::string& note) {
  Svg svg;
  svg.title(title).ground("white");
  const std::size_t columns = std::min(kColumns, panels.size()), rows = (panels.size() + kColumns - 1) / kColumns;
  const double width = kPanelWidth * double(columns);
  double legend_y = kTop + kPanelHeight * double(rows) + kRowGap * double(rows - 1) + 8;
  svg.text(kLeft, 34, "start", title, "font-size=\"19\" font-weight=\"bold\"");
  for (std::size_t k = 0; k < panels.size(); ++k)
    drawPanel(svg, panels[k], kPanelWidth * double(k % kColumns),
              kTop + (kPanelHeight + kRowGap) * double(k / kColumns));

  std::vector<std::string> named;
  double at = kLeft;
  for (const ChartPanel& panel : panels)
    for (const ChartSeries& s : panel.series) {
      if (s.name.empty() || std::find(named.begin(), named.end(), s.name) != named.end()) continue;
      named.push_back(s.name);
      if (at > kLeft && at + 20 + textWidth(s.name) > width) {
        at = kLeft;
        legend_y += 22;
      }
      if (s.joined)
        svg.line(
            at - 10, legend_y - 5, at + 14, legend_y - 5,
            std::string("stroke=\"#5a5a5a\" stroke-width=\"1.6\"") + (s.dashed ? " stroke-dasharray=\"7 4\"" : ""));
      if (s.marked) drawMark(svg, s.mark, at + 2, legend_y - 5);
      svg.text(at + 20, legend_y, "start", s.name);
      at += (s.joined ? 62 : 46) + textWidth(s.name);
    }
  double height = legend_y + 18;
  if (!note.empty()) svg.text(kLeft, height += 10, "start", note, "font-size=\"12\" fill=\"#4a4a4a\"");
  height += 14;
  return std::move(svg).within("xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svgNumber(width) + "\" height=\"" +
                               svgNumber(height) + "\" viewBox=\"0 0 " + svgNumber(width) + " " + svgNumber(height) +
                               "\" font-family=\"Inter, Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"14\" "
                               "fill=\"#1a1a1a\"") +
         "\n";
}

}  // namespace moltact::bench
