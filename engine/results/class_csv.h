// The results of a class as a table for spreadsheets: RFC 4180, UTF-8 with a byte order mark (without it, some
// spreadsheets assume another encoding). One row per person and lesson. docs/results.md describes the columns.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// Returns the whole file. An apostrophe precedes text that a spreadsheet could take for a formula, so that no
/// student's text is ever evaluated. This is text that begins with = + - or @ in any width, also after blanks or
/// invisible characters, or after a semicolon, tab or line end. Control characters are replaced.
std::string classCsv(const ClassSummary& summary);

/// Marks for a learning platform in the same format: one row per named person. Each lesson has two values of 100: the
/// share done, and the share of right first answers. Empty if the lesson was not begun.
std::string gradebookCsv(const ClassSummary& summary);

}  // namespace moltact
