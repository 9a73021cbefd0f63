// The font files for all text: those of homeFolder()/fonts if the program was distributed with them, else those of
// Debian's packages fonts-inter and fonts-dejavu-core. They may not exist. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <string_view>

namespace moltact {

/// A face of Inter, the font of all text: "Inter-Regular.otf".
std::filesystem::path interFile(std::string_view name);

/// The fallback font for characters that Inter lacks.
std::filesystem::path dejaVuFile();

}  // namespace moltact
