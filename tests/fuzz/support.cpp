#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

// Gone when the program ends.
struct Folder {
  std::filesystem::path path;
  Folder() {
    std::error_code error;
    const std::filesystem::path memory = "/dev/shm";
    path = (std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path()) /
           ("moltact-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(path);
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
};

}  // namespace

std::string_view oddNumber(Choices& choices) {
  constexpr std::string_view kOdd[] = {"0",
                                       "-0",
                                       "1",
                                       "-1",
                                       "0.5",
                                       "1e9",
                                       "-1e9",
                                       "1e10",
                                       "1e37",
                                       "-1e38",
                                       "1.7e308",
                                       "-1.7e308",
                                       "1e-308",
                                       "5e-324",
                                       "1e309",
                                       "-1e400",
                                       "256",
                                       "65536",
                                       "2147483647",
                                       "2147483648",
                                       "-2147483649",
                                       "4294967296",
                                       "9223372036854775807",
                                       "18446744073709551616",
                                       "nan",
                                       "inf",
                                       "-inf",
                                       "null",
                                       "\"1\"",
                                       "true",
                                       "[]",
                                       "[1e308]",
                                       "{}"};
  return kOdd[choices.pick(std::size(kOdd))];
}

std::string fileOf(std::string_view bytes, const char* name) {
  static const Folder folder;
  const std::filesystem::path file = folder.path / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file.string();
}

}  // namespace moltact::fuzz
