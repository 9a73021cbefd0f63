// A table of results with its units, and its output formats: console, CSV, Markdown, JSON. Not for the haptic thread.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace moltact::bench {

/// A text, a number, or nothing (not measured, or without meaning).
using Cell = std::variant<std::monostate, std::string, double>;

struct Column {
  std::string name;  ///< as in the CSV's header: "p99_ns"
  std::string head;  ///< as a person reads it: "p99 (ns)"
};

struct ReportTable {
  std::string name;   ///< stem of the CSV file and key in the JSON: "ticks"
  std::string title;  ///< one sentence above the table
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
  std::string note;                     ///< below the table; may be empty
};

/// Three significant digits, thousands set apart, 1e-13 where small: for people, not for programs.
std::string readable(double value);

/// A constant as it is written in the code: 0.05, 18.4, 7.
std::string constant(double value);

/// "a, b and c"; "none" of none.
std::string listed(const std::vector<std::string>& names);

std::string toConsole(const ReportTable& table);
std::string toMarkdown(const ReportTable& table);

/// A header of column names, then the rows; numbers to nine digits; fields quoted where RFC 4180 asks for it.
std::string toCsv(const ReportTable& table);

/// {"command": …, "tables": {name: {"title", "note", "rows": [{column: value}]}}}; nothing is null.
std::string toJson(const std::vector<ReportTable>& tables, const std::string& command);

/// The rows whose text in the column of that name is `value`, under another name and title; no rows where there is no
/// such column.
ReportTable rowsWhere(const ReportTable& table, const std::string& column, const std::string& value, std::string name,
                      std::string title);

/// Returns `text` with everything between the lines "<!-- name:begin" … and "<!-- name:end -->" replaced by `content`;
/// the text unchanged where the markers are missing.
std::string replacedBetweenMarkers(const std::string& text, const std::string& name, const std::string& content);

}  // namespace moltact::bench
