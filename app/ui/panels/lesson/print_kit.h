// Lesson > Teacher's kit: writes the kit of the open lesson as a page for printing. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Asks for a folder and writes the page into it. Requires an open lesson.
void writeTeachersKit(Application& app);

}  // namespace moltact
