// File > Save molecule as glTF: asks for the file and writes the molecule on the stage as balls. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Opens the file dialog; what is written, or why it cannot be, is told in a message.
void askForGltf(Application& app);

}  // namespace moltact
