// Lesson > Report on a class: writes a page about all attempts in a folder. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Asks for the folder with a class's files, also in subfolders, and writes the page into it.
void reportOnClass(Application& app);

}  // namespace moltact
