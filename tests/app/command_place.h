// Runs `moltact` in a temporary folder, which is deleted at the end.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace moltact::test {

struct Run {
  int status = -1;
  std::string out, err;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct CommandPlace {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("moltact-command-" + std::to_string(::getpid()));
  CommandPlace() { std::filesystem::create_directories(folder); }
  ~CommandPlace() { std::filesystem::remove_all(folder); }
  CommandPlace(const CommandPlace&) = delete;
  CommandPlace& operator=(const CommandPlace&) = delete;

  /// `before`: shell commands before the program, such as "ulimit -f 200;" or "env NAME=value". `input`: standard
  /// input.
  Run run(const std::string& arguments, const std::string& before = "", const std::string& input = "") const {
    const std::filesystem::path out = folder / "run.out", err = folder / "run.err";
    std::ofstream(folder / "run.in") << input;
    const std::string line = "cd '" + folder.string() + "'; " + before + " '" MOLTACT_BINARY "' " + arguments + " <'" +
                             (folder / "run.in").string() + "' >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), contents(out), contents(err)};
  }
};

}  // namespace moltact::test
