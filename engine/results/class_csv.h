// A class as a table for spreadsheets: RFC 4180, UTF-8 with a byte order mark (without it some take the file for
// another encoding), one row for each person and lesson. The columns are described in docs/results.md.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// The whole file. Text that a spreadsheet could take for a formula gets an apostrophe before it, so that nothing
/// written by a student is ever computed: text that begins with = + - or @ in any width, after whatever blanks or
/// invisible signs, also after a semicolon, a tab or a line end within. Control characters are replaced.
std::string classCsv(const ClassSummary& summary);

/// Marks for a learning platform, in the same form: a row for each named person, and of each lesson what was done and
/// how many of the answers were right at the first try, each of 100; empty where nothing was begun.
std::string gradebookCsv(const ClassSummary& summary);

}  // namespace moltact
