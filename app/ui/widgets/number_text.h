// Numbers as the person writes them. Window's thread.
#pragma once

#include <string>

namespace moltact {

/// Sets whether numbers have a decimal comma from here on (default: a point).
void setDecimalComma(bool on);

/// A text with the points between digits as commas, where the person prefers that: "1.4 Å" gives "1,4 Å". For texts
/// whose only points between digits are decimal points.
std::string localNumbers(std::string text);
/// The same in prose, where a point between digits may also part the numbers of a version, a section or an address:
/// "1.4 Å" gives "1,4 Å", and "1.4.2" and "10.1038/227" stay.
std::string localProse(std::string text);
/// A number and its unit on one line: the space between them becomes one at which no line is broken.
std::string withUnitsKept(const std::string& text);
/// The inverse of localNumbers, for what the person wrote as one number. Understands a decimal comma also where a point
/// is preferred, unless three digits follow: "1,76" gives "1.76", "1,760" stays.
std::string plainNumbers(std::string text);

/// Minutes and seconds: "1:05".
std::string clockText(int whole_s);

}  // namespace moltact
