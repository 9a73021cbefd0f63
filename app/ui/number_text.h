// Numbers as the person writes them. Window's thread.
#pragma once

#include <string>

namespace moltact {

/// Sets whether numbers have a decimal comma from here on (default: a point).
void setDecimalComma(bool on);

/// A text with the points between digits as commas, where the person prefers that: "1.4 Å" gives "1,4 Å". For texts whose
/// only points between digits are decimal points.
std::string localNumbers(std::string text);
/// The inverse, for what the person wrote as one number.
std::string plainNumbers(std::string text);

}  // namespace moltact
