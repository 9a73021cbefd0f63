// Writes to the browser's console.
#include <iostream>

#include "engine/platform/terminal.h"

namespace moltact {

std::ostream& cleanOut() { return std::cout; }
std::ostream& cleanErr() { return std::cerr; }
TerminalText out() { return TerminalText(cleanOut()); }
TerminalText err() { return TerminalText(cleanErr()); }
bool terminalWritten() { return true; }
void showStatus(std::string_view) {}
bool standardErrorIsTerminal() { return false; }
void hideOwnTerminal() {}
Typed typedLine(std::string&, int) { return Typed::End; }

}  // namespace moltact
