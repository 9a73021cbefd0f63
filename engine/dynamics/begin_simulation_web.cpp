// A simulation in a worker of the page. app/web/simulation.js starts the worker, in which openmm_worker.cpp runs, when
// the first scene needs it. The window asks for one frame at a time, for the time that has passed since it asked before.
#include <emscripten.h>

#include <cstdlib>
#include <utility>

#include "engine/dynamics/begin_simulation.h"
#include "engine/dynamics/openmm_engine.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_message.h"
#include "engine/dynamics/simulation_slices.h"
#include "engine/language/catalogue.h"

// The following functions are JavaScript.
// clang-format off
EM_JS(int, openSimulation, (const char* system, const double* start, int count), {
  return Module.simulations.open(UTF8ToString(system), HEAPF64.slice(start >> 3, (start >> 3) + count));
})
EM_JS(void, closeSimulation, (int number), { Module.simulations.close(number); })
EM_JS(void, askSimulation, (int number, const double* command, int count), {
  Module.simulations.ask(number, HEAPF64.slice(command >> 3, (command >> 3) + count));
})
// What has come from it since the last call: 0 nothing, 1 the facts, 2 a frame, 3 OpenMM's refusal, 4 its end.
EM_JS(int, simulationNews, (int number), { return Module.simulations.news(number); })
// Of those news; the caller frees them. The first number is the count of the others.
EM_JS(double*, simulationNumbers, (int number), {
  const numbers = Module.simulations.numbers(number);
  const at = _malloc(8 * (numbers.length + 1));
  HEAPF64[at >> 3] = numbers.length;
  HEAPF64.set(numbers, (at >> 3) + 1);
  return at;
})
EM_JS(char*, simulationText, (int number), {
  const text = Module.simulations.text(number);
  const size = lengthBytesUTF8(text) + 1;
  const at = _malloc(size);
  stringToUTF8(text, at, size);
  return at;
})
// clang-format on

namespace moltact {
namespace {

class WorkerSimulation final : public LiveSimulation {
 public:
  WorkerSimulation(std::string file, std::shared_ptr<const Molecule> molecule, const MdStart& start)
      : file_(std::move(file)), molecule_(std::move(molecule)) {
    const std::vector<double> numbers = numbersOf(start);
    number_ = openSimulation(start.system.c_str(), numbers.data(), int(numbers.size()));
  }
  ~WorkerSimulation() override { closeSimulation(number_); }
  WorkerSimulation(const WorkerSimulation&) = delete;
  WorkerSimulation& operator=(const WorkerSimulation&) = delete;

  EngineFacts engine() const override { return facts_; }
  bool opening() const override { return facts_.name.empty() && !frame_.lost; }
  void command(const SimulationCommand& wanted) override { wanted_.command = wanted; }

  const SimulationFrame& newest() override {
    takeNews();
    return frame_;
  }

  void pass(double dt_s) override {
    takeNews();
    if (frame_.lost) return;
    if (!asked_) {
      if (opening()) {  // the worker loads OpenMM and tries the system
        waited_s_ += dt_s;
        if (waited_s_ > kOpening_s) lose(trf("it has not answered for {0} s", kOpening_s));
        return;
      }
      wanted_.elapsed_s = std::min(owed_s_ + dt_s, SimulationSlices::kMaxElapsed_s);
      const std::vector<double> numbers = numbersOf(wanted_);
      askSimulation(number_, numbers.data(), int(numbers.size()));
      asked_ = true;
      owed_s_ = waited_s_ = 0.0;
      return;
    }
    owed_s_ += dt_s;
    waited_s_ += dt_s;
    if (waited_s_ > kPatience_s) lose(trf("it has not answered for {0} s", kPatience_s));
  }

  /// The window's time without an answer after which the worker counts as lost. A relaxation takes up to 2 s.
  static constexpr int kPatience_s = 10;
  /// The same until it has read the system.
  static constexpr int kOpening_s = 60;

 private:
  enum class News { None, Facts, Frame, Refusal, End };

  void takeNews() {
    for (;;) {
      const News news = News(simulationNews(number_));
      if (news == News::None || frame_.lost) return;
      const std::string text = takeText();
      const std::vector<double> numbers = takeNumbers();
      if (news == News::Facts)
        begin(text, numbers);
      else if (news == News::Frame)
        take(frameOf(numbers), text);
      else
        lose(news == News::Refusal ? openMMRefusal(file_, text).text() : trf("the simulation has ended: {0}", text));
    }
  }

  // Name and platform, each in a line; step, steps per second and masses.
  void begin(const std::string& text, const std::vector<double>& numbers) {
    const std::size_t line = text.find('\n');
    if (numbers.size() < 2 || line == std::string::npos) return lose(openMMRefusal(file_, text).text());
    Problem fault = massFault(*molecule_, std::span(numbers).subspan(2));
    if (!fault.message.empty()) {
      fault.file = file_;
      return lose(fault.text());
    }
    facts_ = {text.substr(0, line), text.substr(line + 1), numbers[0], numbers[1]};
  }

  void take(std::optional<SimulationFrame> frame, const std::string& fault) {
    asked_ = false;
    if (!frame || frame->positions_A.size() != molecule_->spheres.size()) return;
    frame_ = *std::move(frame);
    frame_.fault = fault;
  }

  void lose(std::string why) {
    frame_.dead = frame_.lost = true;
    frame_.fault = std::move(why);
    closeSimulation(number_);
  }

  std::string takeText() const {
    char* const text = simulationText(number_);
    const std::string out = text;
    std::free(text);
    return out;
  }

  std::vector<double> takeNumbers() const {
    double* const numbers = simulationNumbers(number_);
    const std::vector<double> out(numbers + 1, numbers + 1 + std::size_t(numbers[0]));
    std::free(numbers);
    return out;
  }

  const std::string file_;
  const std::shared_ptr<const Molecule> molecule_;
  int number_ = 0;
  EngineFacts facts_;
  TimedCommand wanted_;
  SimulationFrame frame_;
  bool asked_ = false;  // the answer is missing
  double owed_s_ = 0.0, waited_s_ = 0.0;
};

}  // namespace

Expected<std::unique_ptr<LiveSimulation>> beginSimulation(const std::filesystem::path& system,
                                                          std::shared_ptr<const Molecule> molecule, MdStart start,
                                                          SimulationPace) {
  if (const std::size_t count = molecule->atoms.size(); count > kMaxSimulatedInPage)
    return Problem{
        system.filename().string(), 0, 0,
        trf("the molecule has {0} atoms; a page in a browser simulates at most {1}", count, kMaxSimulatedInPage),
        tr("take a part of it, or use the desktop program")};
  Expected<MdStart> whole = readStart(system, *molecule, std::move(start));
  if (!whole) return whole.problem();
  return std::unique_ptr<LiveSimulation>(
      std::make_unique<WorkerSimulation>(system.filename().string(), std::move(molecule), *whole));
}

}  // namespace moltact
