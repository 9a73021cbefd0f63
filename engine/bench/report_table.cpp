#include "engine/bench/report_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/core/utf8.h"

namespace moltact::bench {
namespace {

std::string shown(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* number = std::get_if<double>(&cell)) return readable(*number);
  return "-";
}

bool isNumbers(const ReportTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const auto& row) { return std::holds_alternative<double>(row[column]); });
}

std::string padded(const std::string& text, std::size_t to, bool right) {
  std::string out = text;
  out.insert(right ? 0 : out.size(), to - std::min(to, characterCount(text)), ' ');
  return out;
}

}  // namespace

std::string readable(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return value > 0 ? "inf" : value < 0 ? "-inf" : "nan";
  char digits[64];
  const double size = std::abs(value);
  if (size < 9.995e-4 || size >= 1e13) {
    std::snprintf(digits, sizeof digits, "%.1e", value);
    return digits;
  }
  if (value == std::floor(value) && size < 1e13) std::snprintf(digits, sizeof digits, "%.0f", value);
  const int whole = static_cast<int>(std::floor(std::log10(size) + 2e-3)) + 1;  // 99.97 is written as 100
  if (value != std::floor(value)) std::snprintf(digits, sizeof digits, "%.*f", std::clamp(3 - whole, 0, 6), value);
  std::string out = digits;
  const std::size_t dot = std::min(out.find('.'), out.size()), first = value < 0 ? 1 : 0;
  for (std::size_t at = dot; at > first + 3;) out.insert(at -= 3, " ");
  return out;
}

std::string constant(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string listed(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k)
    out += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return out;
}

std::string listedApart(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string out = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) out += "; " + names[k];
  return out;
}

std::string toConsole(const ReportTable& table) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t largest = characterCount(table.columns[c].head);
    for (const auto& row : table.rows) largest = std::max(largest, characterCount(shown(row[c])));
    widths.push_back(largest);
  }
  std::string out = table.title + '\n';
  const auto line = [&](auto&& text) {
    std::string one;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      one.append("  ").append(padded(text(c), widths[c], isNumbers(table, c)));
    while (one.ends_with(' ')) one.pop_back();
    out += one + '\n';
  };
  line([&](std::size_t c) { return table.columns[c].head; });
  for (const auto& row : table.rows) line([&](std::size_t c) { return shown(row[c]); });
  if (!table.note.empty()) out += table.note + '\n';
  return out;
}

std::string toMarkdown(const ReportTable& table) {
  std::string out = "|", rule = "|";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    out.append(1, ' ').append(table.columns[c].head).append(" |");
    rule += isNumbers(table, c) ? " ---: |" : " --- |";
  }
  out += '\n' + rule + '\n';
  for (const auto& row : table.rows) {
    out += '|';
    for (const Cell& cell : row) {
      std::string text = shown(cell);
      for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
      out.append(1, ' ').append(text).append(" |");
    }
    out += '\n';
  }
  if (!table.note.empty()) out += '\n' + table.note + '\n';
  return out;
}

std::string toCsv(const ReportTable& table) {
  const auto field = [](const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
  };
  std::string out;
  for (std::size_t c = 0; c < table.columns.size(); ++c) out.append(c ? "," : "").append(field(table.columns[c].name));
  out += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c) out += ',';
      if (const auto* text = std::get_if<std::string>(&row[c])) out += field(*text);
      if (const auto* number = std::get_if<double>(&row[c])) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.9g", *number);
        out += digits;
      }
    }
    out += '\n';
  }
  return out;
}

ReportTable rowsWhere(const ReportTable& table, const std::string& column, const std::string& value, std::string name,
                      std::string title) {
  ReportTable out{std::move(name), std::move(title), table.columns, {}, table.note};
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name != column) continue;
    for (const auto& row : table.rows)
      if (const auto* text = std::get_if<std::string>(&row[c]); text && *text == value) out.rows.push_back(row);
  }
  return out;
}

std::string replacedBetweenMarkers(const std::string& text, const std::string& name, const std::string& content) {
  const std::size_t begin = text.find("<!-- " + name + ":begin");
  const std::size_t end = text.find("<!-- " + name + ":end -->");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return text;
  const std::size_t after = text.find('\n', begin);
  if (after == std::string::npos || after > end) return text;
  return text.substr(0, after + 1) + content + text.substr(end);
}

}  // namespace moltact::bench
