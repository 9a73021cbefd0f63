// Where lessons for everyone on a computer are looked for, after the XDG base directory specification.
#include "engine/platform/folders.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

using namespace moltact;
namespace fs = std::filesystem;

namespace {

// A variable of the environment as it is told, until the end of the test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* was = std::getenv(name)) was_ = was;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { was_ ? ::setenv(name_, was_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> was_;
};

}  // namespace

TEST_CASE(
    "shared data are in moltact of each folder of XDG_DATA_DIRS, in order; relative and empty ones are passed over") {
  const Variable dirs("XDG_DATA_DIRS", "/srv/school:here/not::/opt/x/");
  CHECK(sharedDataFolders() == std::vector<fs::path>{"/srv/school/moltact", "/opt/x/moltact"});
}

TEST_CASE("without XDG_DATA_DIRS shared data are under /usr/local/share and /usr/share") {
  for (const char* none : {static_cast<const char*>(nullptr), ""}) {
    const Variable dirs("XDG_DATA_DIRS", none);
    CHECK(sharedDataFolders() == std::vector<fs::path>{"/usr/local/share/moltact", "/usr/share/moltact"});
  }
}

TEST_CASE("the program's own data are not among the shared ones, though they lie in a folder of XDG_DATA_DIRS") {
  const fs::path share = fs::temp_directory_path() / "moltact-folders-test";
  fs::create_directories(share / "moltact");
  const Variable home("MOLTACT_HOME", (share / "moltact").c_str()),
      dirs("XDG_DATA_DIRS", (share.string() + ":/srv").c_str());
  CHECK(sharedDataFolders() == std::vector<fs::path>{"/srv/moltact"});
  fs::remove_all(share);
}
