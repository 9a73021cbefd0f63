// `moltact play` as users call it: its output and exit status.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

const std::string kLessons = MOLTACT_SOURCE_DIR "/lessons/";
const std::filesystem::path kFolder =
    std::filesystem::temp_directory_path() / ("moltact-play-" + std::to_string(::getpid()));

struct Run {
  int status = -1;
  std::string out, err;
};

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Run play(const std::string& arguments, const std::string& answers = {}) {
  std::filesystem::create_directories(kFolder);
  std::ofstream(kFolder / "answers.txt") << answers;
  const std::string command = "MOLTACT_HOME='" MOLTACT_SOURCE_DIR "' '" MOLTACT_BINARY "' play " + arguments + " >'" +
                              (kFolder / "out").string() + "' 2>'" + (kFolder / "err").string() + "'";
  const int status = std::system(command.c_str());
  Run run{WEXITSTATUS(status), contents(kFolder / "out"), contents(kFolder / "err")};
  std::filesystem::remove_all(kFolder);
  return run;
}

std::string withAnswers() { return " --answers '" + (kFolder / "answers.txt").string() + "'"; }

}  // namespace

TEST_CASE(
    "play --demonstrate finishes the first lesson with status 0 and prints the 5 steps of its core; --json says the "
    "same") {
  const Run text = play("'" + kLessons + "first-touch.md' --demonstrate");
  CHECK(text.status == 0);
  CHECK(text.out.find("step 5 of 5: A molecule that you cannot see") != std::string::npos);
  CHECK(text.out.find("done: That is it. You have touched a molecule.") != std::string::npos);
  CHECK(text.out.find("lesson finished after ") != std::string::npos);
  CHECK(text.err.empty());
  const Run json = play("'" + kLessons + "first-touch.md' --demonstrate --json");
  CHECK(json.status == 0);
  const auto read = nlohmann::json::parse(json.out);
  CHECK(read["finished"] == true);
  CHECK(read["progress"] == 1.0);
  std::size_t steps = 0, tasks = 0, questions = 0;
  for (const auto& event : read["events"]) {
    steps += event["event"] == "step";
    tasks += event["event"] == "task";
    questions += event["event"] == "question";
    if (event["event"] == "task") CHECK(event["figures"].size() >= 5);
  }
  CHECK(steps == 5);
  CHECK(tasks == 9);
  CHECK(questions == 5);
}

TEST_CASE("play --answers does the first step of the first lesson, lists what is left and ends with status 1") {
  const Run run = play("'" + kLessons + "first-touch.md'" + withAnswers(),
                       "touch element C\npress 0.9 N\nlift\ndo\nnext\nanswer 1: One\n");
  CHECK(run.status == 1);
  CHECK(run.out.find("wrong: One") != std::string::npos);
  CHECK(run.err.find("left in: two-atoms-and-a-crease") != std::string::npos);
  CHECK(run.err.find("five-rings") == std::string::npos);
}

TEST_CASE("a fault in the answers ends with status 1 and its line; wrong usage with 2") {
  const Run fault = play("'" + kLessons + "first-touch.md'" + withAnswers(), "touch element Ar\npres 0.9 N\n");
  CHECK(fault.status == 1);
  CHECK(fault.err.find("answers.txt:2:1: there is no act 'pres'; did you mean 'press'?") != std::string::npos);
  CHECK(play("'" + kLessons + "first-touch.md'").status == 2);
  CHECK(play("'" + kLessons + "first-touch.md' --demonstrate --answers x").status == 2);
  CHECK(play("nowhere.md --demonstrate").status == 1);
}
