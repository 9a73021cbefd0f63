// Guesses what authors meant who use another program's selection language or none. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// Translates a word of another program's language ("resi", "hetatm"), a residue in chemical notation ("Glu 35",
/// "Glu35") or a bare number, for example to "residue 52". `next` is the following word. Empty for other words.
std::string inOurLanguage(std::string_view word, std::string_view next);
/// The same as a question: "did you mean 'residue 52'?"
std::string otherLanguage(std::string_view word, std::string_view next);

/// "35+52" with blanks in place of the plus signs.
std::string withBlanks(std::string_view numbers);

}  // namespace moltact
