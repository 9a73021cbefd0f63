// OpenMM in a worker of a page: the functions that app/web/simulation_worker.js calls. Messages are texts and rows of
// numbers (simulation_message.h), which the worker copies into and out of this module's memory.
#include <memory>
#include <string>
#include <vector>

#include "engine/dynamics/simulation_message.h"
#include "engine/dynamics/simulation_slices.h"

extern "C" moltact::MdEngine* moltactMakeMdEngine(const moltact::MdStart& start, std::string& why);

namespace {

std::string text_in, text_out;
std::vector<double> numbers_in, numbers_out;
std::unique_ptr<moltact::SimulationSlices> simulation;

}  // namespace

extern "C" {

// Where the caller writes a text of this many bytes, or this many numbers.
char* simulation_text_room(int bytes) {
  text_in.resize(std::size_t(bytes));
  return text_in.data();
}
double* simulation_number_room(int count) {
  numbers_in.resize(std::size_t(count));
  return numbers_in.data();
}

// What the last call has to say.
const char* simulation_text() { return text_out.c_str(); }
const double* simulation_numbers() { return numbers_out.data(); }
int simulation_number_count() { return int(numbers_out.size()); }

// Makes the engine for the system in the text and the start in the numbers. 1: the text is its name and its platform in two
// lines, and the numbers are its step in ps, its steps per second and the masses in dalton. 0: the text says why not.
int simulation_open() {
  numbers_out.clear();
  auto start = moltact::startOf(numbers_in);
  if (!start) {
    text_out = "the start is incomplete";
    return 0;
  }
  start->system.swap(text_in);
  std::unique_ptr<moltact::MdEngine> engine(moltactMakeMdEngine(*start, text_out));
  if (!engine) return 0;
  const moltact::EngineFacts facts = moltact::factsOf(*engine);
  text_out = facts.name + '\n' + facts.platform;
  numbers_out = {facts.step_ps, facts.measured_steps_per_s};
  numbers_out.insert(numbers_out.end(), engine->masses_u().begin(), engine->masses_u().end());
  simulation = std::make_unique<moltact::SimulationSlices>(std::move(engine));
  return 1;
}

// Carries out the command in the numbers; then the numbers are the frame, and the text is its fault.
void simulation_advance() {
  const auto timed = moltact::commandOf(numbers_in);
  if (!timed || !simulation) return;
  const moltact::SimulationFrame& frame = simulation->advance(timed->command, timed->elapsed_s);
  numbers_out = moltact::numbersOf(frame);
  text_out = frame.fault;
}
}
