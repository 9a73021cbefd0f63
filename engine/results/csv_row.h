// A row of a table for spreadsheets (RFC 4180). An apostrophe precedes text that a spreadsheet could take for a formula
// (class_csv.h). Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string>

namespace moltact {

/// At the beginning of a file: without it, some spreadsheets assume another encoding than UTF-8.
inline constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";

/// Appends cells to a row of `out`; its destructor ends the row with CR LF.
class CsvRow {
 public:
  explicit CsvRow(std::string& out) : out_(out) {}
  ~CsvRow();
  CsvRow(const CsvRow&) = delete;
  CsvRow& operator=(const CsvRow&) = delete;

  void text(const std::string& cell);
  void whole(std::size_t n) { raw(std::to_string(n)); }
  void value(double v, int digits);
  void empty() { raw({}); }

 private:
  void raw(const std::string& cell);

  std::string& out_;
  bool first_ = true;
};

}  // namespace moltact
