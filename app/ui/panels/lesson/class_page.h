// The page from which a teacher serves the window's lesson to a class (docs/live-class.md). One class for the program; it
// goes on while the page is closed, and ends with the program. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Whether a class is served now.
bool teachesClass();
/// Opens the page, for the lesson in the window unless a class is served already.
void openClassPage(Application& app);

}  // namespace moltact
