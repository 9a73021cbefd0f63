// The font files that all text is set in: those beside the program's data (homeFolder()/fonts) where they were handed out
// with it, else those of Debian's packages fonts-inter and fonts-dejavu-core. They may not exist. Not for the haptic
// thread.
#pragma once

#include <filesystem>
#include <string_view>

namespace moltact {

/// A face of Inter, as "Inter-Regular.otf": what all text is set in.
std::filesystem::path interFile(std::string_view name);

/// What stands in where Inter has no sign.
std::filesystem::path dejaVuFile();

}  // namespace moltact
