// A table of results with units, and its output formats: console, CSV, Markdown, JSON. Not for the haptic thread.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace moltact::bench {

/// A text, a number, or empty (not measured or meaningless).
using Cell = std::variant<std::monostate, std::string, double>;

struct Column {
  std::string name;  ///< in the CSV header: "p99_ns"
  std::string head;  ///< for people: "p99 (ns)"
};

struct ReportTable {
  std::string name;   ///< stem of the CSV file and key in JSON: "ticks"
  std::string title;  ///< one sentence above the table
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
  std::string note;                     ///< below the table; may be empty
};

/// Formats a number for people: three significant digits, separated thousands, 1e-13 if small.
std::string readable(double value);

/// Formats a constant as in source code: 0.05, 18.4, 7.
std::string constant(double value);

/// Joins names: "a, b and c"; "none" for an empty list.
std::string listed(const std::vector<std::string>& names);
/// Joins names that consist of several words: "a; b; c"; "none" for an empty list.
std::string listedApart(const std::vector<std::string>& names);

std::string toConsole(const ReportTable& table);
std::string toMarkdown(const ReportTable& table);

/// A header of column names, then the rows; numbers with nine digits; fields quoted as RFC 4180 requires.
std::string toCsv(const ReportTable& table);

/// {"command": …, "tables": {name: {"title", "note", "rows": [{column: value}]}}}; nothing is null.
std::string toJson(const std::vector<ReportTable>& tables, const std::string& command);

/// The rows with text `value` in the named column, under another name and title; no rows if there is no such column.
ReportTable rowsWhere(const ReportTable& table, const std::string& column, const std::string& value, std::string name,
                      std::string title);

/// Returns `text` with everything between the lines "<!-- name:begin" … and "<!-- name:end -->" replaced by `content`;
/// unchanged if the markers are missing.
std::string replacedBetweenMarkers(const std::string& text, const std::string& name, const std::string& content);

}  // namespace moltact::bench
