// What an author who knows the selections of another program, or none, most likely meant. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// "residue 52" for a word of another program's language ("resi", "hetatm"), a residue as chemists write it ("Glu 35",
/// "Glu35") or a bare number; `next` is the word after it. Empty where it is none of these.
std::string inOurLanguage(std::string_view word, std::string_view next);
/// "did you mean 'residue 52'?"
std::string otherLanguage(std::string_view word, std::string_view next);

/// "35+52" with blanks in the place of the signs.
std::string withBlanks(std::string_view numbers);

}  // namespace moltact
