// Runs `moltact` in a temporary folder, which is deleted at the end.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moltact::test {

struct Run {
  int status = -1;
  std::string out, err;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeBytes(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// The fields of each row.
inline std::vector<std::vector<std::string>> csvRows(const std::string& csv) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    all.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) all.back().push_back(field);
  }
  return all;
}

struct CommandPlace {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("moltact-command-" + std::to_string(::getpid()));
  CommandPlace() { std::filesystem::create_directories(folder); }
  ~CommandPlace() { std::filesystem::remove_all(folder); }
  CommandPlace(const CommandPlace&) = delete;
  CommandPlace& operator=(const CommandPlace&) = delete;

  /// A file's path in the folder.
  std::string operator/(const std::string& name) const { return (folder / name).string(); }

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
