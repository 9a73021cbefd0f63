#include "engine/results/page_parts.h"

#include <algorithm>
#include <cmath>

#include "engine/core/svg.h"
#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/language/quantity_text.h"

namespace moltact::page {
namespace {

constexpr std::array kInputOrder{InputKind::Device, InputKind::Mouse, InputKind::Keyboard};

// The range of the scales: no value of an attempt exceeds it (attempt_ranges.h), nor do sums of them.
constexpr double kMaxOnScale = 1e15, kMin = 1e-12;
double onScale(double value) { return std::isfinite(value) ? std::clamp(value, -kMaxOnScale, kMaxOnScale) : 0.0; }

// 1, 2 or 5 times a power of ten, not less than `min`.
double roundStep(double min) {
  min = std::clamp(onScale(min), kMin, kMaxOnScale);
  const double power = std::pow(10.0, std::floor(std::log10(min)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= min * (1.0 - 1e-12)) return m * power;
  return 10.0 * power;
}

int digitsFor(double step) { return std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 4); }

std::vector<double> sortedValues(const std::vector<Measured>& values) {
  std::vector<double> out;
  for (const Measured& m : values) out.push_back(onScale(m.value));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

// Disc, square, triangle.
void drawMark(Svg& svg, InputKind input, double x, double y) {
  const std::string look = "class=\"mark " + inputClass(input) + "\"";
  if (input == InputKind::Device)
    svg.circle(x, y, 3.2, look);
  else if (input == InputKind::Mouse)
    svg.rect(x - 2.8, y - 2.8, 5.6, 5.6, look);
  else
    svg.path(svgPoint('M', x, y - 3.4) + "l3.4 6h-6.8z", look);
}

std::string number(double value, int digits) { return numberText(value, decimals(digits)); }

std::string percent(double share) { return quantityText(share, Dimension::Share); }

std::string duration(double time_s) {
  if (time_s < 99.5) return quantityText(time_s, Dimension::Time, decimals(0));
  return numberText(time_s / 60.0, decimals(time_s < 600 ? 1 : 0)) + "\u00a0min";
}

std::string inputClass(InputKind input) { return "way-" + std::string(nameOf(input)); }

std::string inputsText(const PersonScore& person) {
  std::vector<std::pair<double, InputKind>> shares;
  for (const InputKind w : kInputOrder)
    if (const double s = person.touch_by_input_s[std::size_t(w)]; s > 0) shares.emplace_back(s, w);
  if (shares.empty()) {
    const auto input = person.input();
    return input ? shownName(*input) : "–";
  }
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (shares.size() == 1) return shownName(shares[0].second);
  std::string out;
  for (const auto& [s, w] : shares) out += (out.empty() ? "" : ", ") + shownName(w) + " " + percent(s / person.touch_s);
  return out;
}

double roundAbove(double value) {
  value = onScale(value);
  if (!(value > kMin)) return 1.0;
  const double step = roundStep(value / 5.0);
  return std::ceil(value / step - 1e-9) * step;
}

std::string histogram(const std::string& title, const std::string& unit, std::vector<Measured> values) {
  std::erase_if(values, [](const Measured& m) { return !std::isfinite(m.value) || std::abs(m.value) > kMaxOnScale; });
  if (values.empty()) return {};
  const std::vector<double> sorted = sortedValues(values);
  // Small whole numbers have one bar each, centred over the number.
  const bool counted = unit.empty() && sorted.front() >= 0.0 && sorted.back() < 40.0;
  const double greatest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
  const double spread = std::max({sorted.back() - sorted.front(), 1e-3 * greatest, 1e-6});
  const double width = counted ? 1.0 : roundStep(spread / 9.0);
  const double first = counted ? 0.0 : std::floor(sorted.front() / width) * width;
  const auto binOf = [&](double value) { return static_cast<std::size_t>((value - first) / width + 1e-9); };
  const std::size_t bins = binOf(sorted.back()) + 1;
  std::vector<std::array<int, kInputKinds>> counts(bins);
  for (const Measured& m : values) ++counts[binOf(m.value)][std::size_t(m.by)];
  int max = 1;
  for (const auto& c : counts) max = std::max(max, c[0] + c[1] + c[2]);

  constexpr double kLeft = 26, kTop = 8, kWide = 278, kHigh = 112;
  const double each = kWide / double(bins), unit_high = kHigh / double(max);
  Svg svg;
  const int tick = std::max(1, static_cast<int>(roundStep(std::max(1.0, max / 4.5))));
  for (int n = 0; n <= max; n += tick) {
    const double y = kTop + kHigh - n * unit_high;
    svg.path(svgPoint('M', kLeft, y) + "h" + svgNumber(kWide), "class=\"grid\"");
    svg.text(kLeft - 5, y + 3.5, "end", std::to_string(n), "class=\"axis\"");
  }
  for (std::size_t b = 0; b < bins; ++b) {
    double y = kTop + kHigh;
    for (const InputKind w : kInputOrder) {
      const double high = counts[b][std::size_t(w)] * unit_high;
      if (high <= 0) continue;
      y -= high;
      svg.rect(kLeft + each * double(b) + 1, y, each - 2, high, "class=\"bar " + inputClass(w) + "\"");
    }
  }
  const int digits = digitsFor(width);
  const std::size_t every = bins > 6 ? 2 : 1;
  for (std::size_t b = 0; b < bins + !counted; b += every)
    svg.text(kLeft + each * (double(b) + (counted ? 0.5 : 0.0)), kTop + kHigh + 14, "middle",
             number(first + width * double(b), digits), "class=\"axis\"");
  const double median = quantile(sorted, 0.5), x = kLeft + each * ((median - first) / width + (counted ? 0.5 : 0.0));
  svg.path(svgPoint('M', x, kTop - 4) + "v" + svgNumber(kHigh + 4), "class=\"median\"");
  std::string middle = number(median, std::min(3, digits + 1));
  if (!unit.empty()) middle += "\u00a0" + escaped(unit);
  return "<figure class=\"histogram\"><figcaption><div><b>" + escaped(title) + "</b>" +
         (unit.empty() ? "" : ", " + escaped(unit)) + "</div><span>" +
         trf("median {0}, n = {1}", middle, values.size()) + "</span></figcaption>" +
         std::move(svg).within("viewBox=\"0 0 320 152\" role=\"img\" aria-label=\"" + escaped(title) + "\"") +
         "</figure>";
}

namespace {
constexpr double kStripWide = 420, kStripEdge = 6;
double stripX(double value, double max) {
  const double share = std::isfinite(value / max) ? std::clamp(value / max, 0.0, 1.0) : 0.0;
  return kStripEdge + (kStripWide - 2 * kStripEdge) * share;
}
}  // namespace

std::string strip(const std::vector<Measured>& values, double max) {
  Svg svg;
  svg.path("M6 11h408", "class=\"grid\"");
  const std::vector<double> sorted = sortedValues(values);
  if (sorted.size() >= 4) {
    const double from = stripX(quantile(sorted, 0.25), max), to = stripX(quantile(sorted, 0.75), max);
    svg.rect(from, 3, std::max(1.0, to - from), 16, "class=\"box\" rx=\"2\"");
  }
  // Marks that would overlap are moved up and down alternately.
  std::vector<Measured> by_value = values;
  std::stable_sort(by_value.begin(), by_value.end(),
                   [](const Measured& a, const Measured& b) { return a.value < b.value; });
  static constexpr std::array kShift{0.0, -5.0, 5.0, -2.5, 2.5};
  double last = -100;
  std::size_t row = 0;
  for (const Measured& m : by_value) {
    const double x = stripX(m.value, max);
    row = x - last < 6.0 ? (row + 1) % kShift.size() : 0;
    last = x;
    drawMark(svg, m.by, x, 11 + kShift[row]);
  }
  if (!sorted.empty()) svg.path(svgPoint('M', stripX(quantile(sorted, 0.5), max), 1) + "v20", "class=\"median\"");
  return std::move(svg).within("class=\"strip\" viewBox=\"0 0 420 22\" role=\"img\" aria-label=\"" +
                               trnf("{0} value", "{0} values", values.size(), values.size()) + "\"");
}

std::string stripScale(double max, const std::string& unit) {
  Svg svg;
  max = std::clamp(onScale(max), kMin, kMaxOnScale);
  const double step = roundStep(max / 4.0);
  const int steps = static_cast<int>(max / step + 1e-9);  // 1 to 4
  for (int k = 0; k <= steps; ++k) {
    const double v = step * k;
    const bool last = k == steps;
    const std::string_view anchor = v == 0 ? "start" : v > max * 0.999 ? "end" : "middle";
    svg.text(stripX(v, max), 12, anchor, number(v, digitsFor(step)) + (last ? " " + unit : ""), "class=\"axis\"");
  }
  return std::move(svg).within("class=\"strip\" viewBox=\"0 0 420 16\" aria-hidden=\"true\"");
}

namespace {

// Path data of a curve in a box of the given size; a new subpath begins after each gap.
std::string linePath(const std::vector<double>& values, double max, double left, double top, double wide, double high) {
  std::string path;
  bool on = false;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool there = std::isfinite(values[k]);
    if (there)
      path += svgPoint(on ? 'L' : 'M', left + wide * double(k) / double(std::max<std::size_t>(1, values.size() - 1)),
                       top + high * (1.0 - std::clamp(values[k] / max, 0.0, 1.0)));
    on = there;
  }
  return path;
}

}  // namespace

std::string curves(const std::string& title, const CurveKept* drawn, const CurveKept* felt) {
  const CurveKept& of = drawn ? *drawn : *felt;
  constexpr double kLeft = 24, kTop = 6, kWide = 166, kHigh = 84;
  const double max = of.max_N > 0.0 ? of.max_N : 1.0;
  constexpr std::string_view kAxis = "class=\"axis\"";
  Svg svg;
  for (const double part : {0.0, 0.5, 1.0})
    svg.path(svgPoint('M', kLeft, kTop + kHigh * part) + "h" + svgNumber(kWide), "class=\"grid\"");
  svg.text(kLeft - 4, kTop + 8, "end", quantityNumber(max, Dimension::Force, significant(2)), kAxis);
  svg.text(kLeft - 4, kTop + kHigh + 3, "end", "0", kAxis);
  svg.text(kLeft + kWide, kTop + kHigh + 14, "end", quantityText(of.to_A, Dimension::Length, significant(2)), kAxis);
  svg.text(kLeft, kTop + kHigh + 14, "start",
           trf("{0} against {1}", unitText(Dimension::Force), figureTitle(of.axis.empty() ? "depth" : of.axis)), kAxis);
  if (felt) svg.path(linePath(felt->force_N, max, kLeft, kTop, kWide, kHigh), "class=\"felt\"");
  if (drawn) svg.path(linePath(drawn->force_N, max, kLeft, kTop, kWide, kHigh), "class=\"drawn\"");
  return "<figure class=\"curve\"><figcaption>" + escaped(title) +
         (felt ? "" : std::string(" <span>") + tr("not felt") + "</span>") + "</figcaption>" +
         std::move(svg).within("viewBox=\"0 0 196 108\" role=\"img\" aria-label=\"" + escaped(title) + "\"") +
         "</figure>";
}

std::string bar(double share, bool right) {
  const double wide = 198.0 * std::clamp(share, 0.0, 1.0);
  Svg svg;
  svg.rect(0.5, 0.5, 199, 13, "class=\"track\" rx=\"3\"");
  svg.rect(1, 1, wide, 12, std::string("class=\"") + (right ? "full" : "hatched") + "\" rx=\"2.5\"");
  return std::move(svg).within(
      "class=\"share\" viewBox=\"0 0 200 14\" preserveAspectRatio=\"none\" aria-hidden=\"true\"");
}

std::string patterns() {
  return R"svg(<svg width="0" height="0" style="position:absolute" aria-hidden="true"><defs>
<pattern id="hatch" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="5" height="5" class="ground-wrong"/><rect width="2" height="5" class="ink-wrong"/></pattern>
<pattern id="mouse" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="6" height="6" class="ground-mouse"/><rect width="2.6" height="6" class="ink-mouse"/></pattern>
<pattern id="keyboard" width="6" height="6" patternUnits="userSpaceOnUse"><rect width="6" height="6" class="ground-keyboard"/><circle cx="3" cy="3" r="1.7" class="ink-keyboard"/></pattern>
</defs></svg>)svg";
}

std::string_view styleSheet() {
  return R"css(
:root{color-scheme:light dark;--ground:#f6f7f9;--panel:#fff;--text:#1b2430;--quiet:#5a6675;--line:#d9dfe6;--accent:#0b63a8;--soft:#e6f0f9;
--device:#0b63a8;--mouse:#c2560a;--mouse-soft:#f7e3d3;--keyboard:#0a7d5c;--keyboard-soft:#d5efe5;--wrong:#77808c;--wrong-soft:#eceff2;--good:#0a7d5c}
@media(prefers-color-scheme:dark){:root{--ground:#12161b;--panel:#1b2129;--text:#e8edf2;--quiet:#a3afbc;--line:#333d48;--accent:#6fb5f0;--soft:#1f3347;
--device:#6fb5f0;--mouse:#f0a066;--mouse-soft:#4a3423;--keyboard:#5fd0a8;--keyboard-soft:#1d4437;--wrong:#9aa5b1;--wrong-soft:#2c343d;--good:#5fd0a8}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--text);font:15px/1.5 Inter,system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif;font-variant-numeric:tabular-nums}
main{max-width:1080px;margin:0 auto;padding:32px 24px 64px}
h1{font-size:30px;line-height:1.2;margin:0 0 4px;letter-spacing:-.01em}h2{font-size:23px;margin:48px 0 4px;letter-spacing:-.01em}h3{font-size:17px;margin:30px 0 10px}
p{margin:6px 0}.curves{display:grid;grid-template-columns:repeat(auto-fill,minmax(180px,1fr));gap:10px;margin-top:8px}figure.curve{margin:0}figure.curve figcaption{font-size:13px}
.drawn,.felt{fill:none;stroke-width:2;stroke-linejoin:round}.drawn{stroke:var(--accent);stroke-dasharray:5 3}.felt{stroke:var(--text)}
.quiet,figcaption span,.axis{color:var(--quiet)}.small{font-size:13px}
.tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:12px;margin:18px 0}
.tile,.card{background:var(--panel);border:1px solid var(--line);border-radius:10px}
.tile{padding:12px 16px}.tile b{display:block;font-size:25px;line-height:1.25;letter-spacing:-.01em}.tile span{color:var(--quiet);font-size:13px}
.card{padding:16px 18px;margin:12px 0;break-inside:avoid}
.scroll{overflow-x:auto}.nowrap{white-space:nowrap}
table{border-collapse:collapse;width:100%;font-size:14px}th,td{padding:7px 10px;text-align:right;border-bottom:1px solid var(--line);vertical-align:middle}
th{font-weight:600;color:var(--quiet);font-size:12.5px;line-height:1.3;vertical-align:bottom}th:first-child,td:first-child,.left{text-align:left!important}
tbody tr:last-child td{border-bottom:0}td.name{font-weight:600;min-width:9em}thead{display:table-header-group}tr{break-inside:avoid}
.doneCell{display:flex;align-items:center;gap:8px;min-width:130px}.doneCell svg.share{width:76px;flex:none}.doneCell span{min-width:3.1em;text-align:right;white-space:nowrap}
svg{display:block;max-width:100%}svg.share{width:100%;height:14px}svg.strip{width:420px}
.track{fill:var(--wrong-soft);stroke:var(--line)}.full{fill:var(--accent)}.hatched{fill:url(#hatch)}
.ground-wrong{fill:var(--wrong-soft)}.ink-wrong{fill:var(--wrong)}.ground-mouse{fill:var(--mouse-soft)}.ink-mouse{fill:var(--mouse)}.ground-keyboard{fill:var(--keyboard-soft)}.ink-keyboard{fill:var(--keyboard)}
.bar{stroke-width:1}.bar.way-device{fill:var(--device);stroke:var(--device)}.bar.way-mouse{fill:url(#mouse);stroke:var(--mouse)}.bar.way-keyboard{fill:url(#keyboard);stroke:var(--keyboard)}
.mark{stroke-width:1.2;fill-opacity:.35}.mark.way-device{fill:var(--device);stroke:var(--device)}.mark.way-mouse{fill:var(--mouse);stroke:var(--mouse)}.mark.way-keyboard{fill:var(--keyboard);stroke:var(--keyboard)}
.grid{stroke:var(--line);fill:none}.box{fill:var(--soft);stroke:var(--line)}.median{stroke:var(--text);stroke-width:2;fill:none}text.axis{font-size:10.5px;fill:var(--quiet)}
.histograms{display:grid;grid-template-columns:repeat(auto-fill,minmax(300px,1fr));gap:12px}
figure{margin:0;background:var(--panel);border:1px solid var(--line);border-radius:10px;padding:12px 14px 8px;break-inside:avoid}
figcaption{display:flex;flex-wrap:wrap;justify-content:space-between;gap:2px 12px;font-size:13.5px;margin-bottom:6px}figcaption b{margin-right:0}
.legend{display:flex;flex-wrap:wrap;gap:4px 18px;margin:8px 0 12px;font-size:13px;color:var(--quiet);align-items:center}.legend span{display:inline-flex;align-items:center;gap:7px}.legend svg{width:30px;height:14px}
.question{display:grid;grid-template-columns:1.6em minmax(10em,2.2fr) minmax(120px,1.6fr) 5.5em;gap:6px 12px;align-items:center;margin-top:10px}
.texts{display:grid;grid-template-columns:minmax(6em,max-content) 1fr;gap:6px 14px;margin:10px 0 0}.texts dt{color:var(--quiet)}.texts dd{margin:0;white-space:pre-wrap;overflow-wrap:anywhere}
.question .n{text-align:right;white-space:nowrap}.right{font-weight:600}.tick{color:var(--good);font-weight:700}
.head{display:flex;justify-content:space-between;gap:16px;align-items:baseline}.head b{font-size:16px}.head span{color:var(--quiet);white-space:nowrap;font-size:13.5px}
.given td,.given th{text-align:center}.given td:first-child,.given th:first-child{text-align:left}.given .ok{color:var(--good);font-weight:700}.given .no{color:var(--mouse);font-weight:700}.given .none{color:var(--quiet)}
ul.plain{margin:6px 0;padding-left:1.2em}code{font:13px ui-monospace,"DejaVu Sans Mono",monospace;overflow-wrap:anywhere}
@media print{:root{--ground:#fff;--panel:#fff;--text:#000;--quiet:#444;--line:#bbb;--accent:#333;--soft:#eee;--device:#000;--mouse:#000;--mouse-soft:#fff;--keyboard:#000;--keyboard-soft:#fff;--wrong:#666;--wrong-soft:#fff;--good:#000;color-scheme:light}
body{font-size:9.5pt;-webkit-print-color-adjust:exact;print-color-adjust:exact}main{max-width:none;padding:0}h1{font-size:18pt}h2{font-size:15pt;margin:0 0 2px;break-before:page}h2.first{break-before:auto}h3{font-size:11pt;margin:14px 0 6px;break-after:avoid}.small{font-size:8.5pt}
.tiles{grid-template-columns:repeat(5,1fr);gap:8px;margin:10px 0}.tile{padding:8px 10px}.tile b{font-size:14pt}.tile span{font-size:8pt}.card{padding:8px 12px;margin:8px 0}.scroll{overflow:visible;break-inside:auto}.head b{font-size:10.5pt}.head span,figcaption,.legend{font-size:8.5pt}
table{font-size:8pt}th{font-size:7.5pt}th,td{padding:2px 6px}.histograms{grid-template-columns:repeat(3,1fr)}a{color:inherit}}
@page{margin:14mm 13mm}
)css";
}

std::string tableHead(std::initializer_list<Column> columns) {
  std::string out = "<table><thead><tr>";
  for (const Column& c : columns) out += std::string(c.left ? "<th class=\"left\">" : "<th>") + c.title + "</th>";
  return out + "</tr></thead><tbody>";
}

std::string section(const char* heading, std::initializer_list<Column> columns) {
  return std::string("<h3>") + heading + "</h3><div class=\"card scroll\">" + tableHead(columns);
}

}  // namespace moltact::page
