// Bytes of a file are converted only to numbers, never to other objects in memory. Checked in the sources: copies of
// bytes and pointer casts are allowed only at the places listed here.
#include "engine/core/file_bytes.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

namespace fs = std::filesystem;

TEST_CASE("numbers come from unaligned bytes as this machine orders them") {
  const unsigned char bytes[] = {0, 1, 2, 0, 0, 0};
  CHECK(moltact::numberAt<std::uint16_t>(bytes + 1) == 0x0201);
  CHECK(moltact::numberAt<std::uint32_t>(bytes + 1) == 0x0201);
  CHECK(moltact::numberAt<float>(bytes + 2) == doctest::Approx(2.8e-45));
}

TEST_CASE("the sources copy bytes, or cast pointers, only at the places listed here") {
  // File, and how often. What is added here is to be no value out of a file.
  const std::map<std::string, int> known = {
      {"engine/core/file_bytes.h", 1},              // numbers
      {"engine/haptics/field/grid_map.cpp", 1},     // numbers of a map into a vector of the processor
      {"engine/haptics/field/pair_kernel.cpp", 1},  // numbers into a vector of the processor
      {"engine/core/short_text.h", 9},              // a text's own bytes, their place and their number
      {"engine/molecule/molecule_storage.cpp", 1},  // a number as a key's bytes
      {"engine/servo/recording_bytes.h", 1},        // bytes of numbers for a file
      {"engine/servo/servo_recording.cpp", 4},      // bytes for checksums
      {"engine/molecule/text_source.cpp", 3},       // text into text, and zlib's own idea of a byte
      {"engine/gltf/gltf_file.cpp", 1},             // numbers for a file
      {"engine/lesson/lesson_picture.cpp", 1},      // stb's own idea of a byte
      {"engine/lesson/png_inflation.cpp", 1},       // zlib's
      {"engine/render/gl_objects.cpp", 2},          // OpenGL's offsets
      {"engine/platform/audio_output_openal.cpp", 2},
      {"engine/platform/audio_output_windows.cpp", 1},      // samples, as waveOut takes them
      {"engine/platform/listening_socket_windows.cpp", 1},  // a switch, as Windows takes it
      {"engine/platform/local_addresses_windows.cpp", 5},   // addresses and lists, as the system's calls give them
      {"engine/device/omni/hd_library.cpp", 2},             // functions of a library
      {"engine/dynamics/openmm_engine.cpp", 1},             // a function of a library
      {"engine/trajectory/read_amber_netcdf.cpp", 1},       // functions of a library
      {"engine/platform/shared_library_windows.cpp", 2},
      {"engine/platform/offscreen_gl_windows.cpp", 2},
      {"engine/device/net/report_stream.h", 1},  // bytes that move to the front of their buffer
      {"engine/platform/local_addresses_linux.cpp", 3},
      {"engine/platform/tcp_linux.cpp", 2},      // addresses, as the system's calls take them
      {"engine/platform/tcp_windows.cpp", 8},    // the same, and bytes as Windows has them
      {"engine/render/picture.cpp", 1},          // bytes of a PNG for a file
      {"app/ui/shell/touch_screen_x11.cpp", 1},  // what XInput says of a device
      {"app/ui/extensions/card_pictures.cpp", 1},
      {"app/ui/scene/view_picture.cpp", 2},  // ImGui's textures
  };
  const std::regex copies(R"(\b(memcpy|memmove|reinterpret_cast)\b)");
  std::map<std::string, int> found;
  for (const char* room : {"engine", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MOLTACT_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);)
        if (const auto comment = line.substr(0, line.find("//")); std::regex_search(comment, copies))
          ++found[fs::relative(entry.path(), MOLTACT_SOURCE_DIR).generic_string()];
    }
  for (const auto& [file, times] : found) {
    CAPTURE(file);
    const auto at = known.find(file);
    CHECK((at == known.end() ? 0 : at->second) >= times);
  }
}
