// Lesson, Report on a class: a page of all attempts in a folder. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Asks for the folder in which a class's files lie, with folders in it or without, and writes the page beside them.
void reportOnClass(Application& app);

}  // namespace moltact
