#include "app/commands/device_recording.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/touch_options.h"
#include "app/commands/value_types.h"
#include "engine/device/driver.h"
#include "engine/device/mouse_device.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_thread.h"
#include "engine/structure/interaction_input.h"
#include "engine/workspace/fit_workspace.h"
#include "engine/workspace/scale.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using Labels = std::map<std::string, std::string>;

constexpr int kBrokenOff = 130;  // exit status
constexpr double kRecordedRoom_A_per_mm = 0.25;
constexpr int kAsk_ms = 250;    // interval between two queries of the device's state
constexpr int kReadyLooks = 2;  // consecutive: at the first query a device may not yet know what it lacks

struct RecordOptions {
  std::string device, file;
  TouchSetup touch;
  const CLI::Option* hand = nullptr;  // --hand
  MoleculeArgument molecule;
  double seconds = 10.0, wait_s = 60.0;
  bool overwrite = false;
};

// Places the molecule in front of the hand, seen along its z-axis.
ServoSettings settingsFor(const SphereGrid& scene, const TouchSetup& touch, const DeviceSpecs& device) {
  ServoSettings settings;
  settings.take(touch);
  settings.workspace.A_per_mm = kRecordedRoom_A_per_mm;
  settings.workspace = fitToDevice(settings.workspace, scene, settings.probe_A,
                                   {0.5 * (scene.low_A() + scene.high_A())}, glm::dmat3(1.0), device);
  return settings;
}

Labels labelsOf(const RecordOptions& options, const SphereGrid& scene, const std::string& device) {
  const MoleculeFolders folders = MoleculeFolders::ofThisComputer();
  const Expected<MoleculeKey> key = findMoleculeKey(options.molecule.named, folders);
  if (!key) throw CommandError{key.problem().text()};
  Labels labels = moleculeLabels(lastingName(*key, folders));
  labels["balls"] = fingerprint(scene);
  labels.merge(touchLabels(options.touch));
  labels["device"] = device;
  return labels;
}

// Measures how long the device did not work as it should.
class DeviceWatch {
 public:
  void add(const RecordedTick& tick) {
    gone_ += tick.fallen_back;
    for (std::size_t k = 0; k < std::size(kReported); ++k)
      acted_[k] += !tick.fallen_back && tick.limits.has(kReported[k]);
    led_ = led_ || (tick.pose.fresh && !tick.pose.fault && !tick.fallen_back);
    touching_ += tick.touching;
  }
  bool led() const { return led_; }
  std::size_t touching() const { return touching_; }

  /// One line per exceeded limit; empty if there was none.
  std::string reported() const {
    std::string out;
    const auto line = [&](std::size_t ticks, std::string_view words) {
      char time[32];
      std::snprintf(time, sizeof time, "%.2f s: ", double(ticks) * kTick_s);
      if (ticks) out.append(time).append(words) += '\n';
    };
    line(gone_, "The device was gone, and the mouse stood in for it.");
    for (std::size_t k = 0; k < std::size(kReported); ++k)
      for (const LimitWords& words : limitWords())
        if (words.limit == kReported[k]) line(acted_[k], words.sentence);
    return out;
  }

 private:
  static constexpr Limit kReported[] = {Limit::StalePlace, Limit::DeviceFault, Limit::NotFinite,
                                        Limit::LateLoop,   Limit::Jump,        Limit::EnergyCut};
  bool led_ = false;
  std::size_t gone_ = 0, touching_ = 0, acted_[std::size(kReported)] = {};
};

// Makes one recording, from the first tick to the last.
class Recorder {
 public:
  Recorder(const RecordOptions& options, ServoRecordingWriter writer, Labels labels)
      : options_(options), writer_(std::move(writer)), labels_(std::move(labels)) {}

  /// Waits until the device is ready and guides the user meanwhile. Then the hand feels `felt` and is recorded.
  void run(ServoThread& servo, std::unique_ptr<Interaction> felt) {
    awaitReady(servo);
    out() << "Recording " << options_.seconds << " s.\n";
    out().flush();
    servo.loop().setInteraction(std::move(felt));
    const auto wanted = std::uint64_t(std::llround(options_.seconds / kTick_s));
    ServoStep start;
    for (int look = 0; ticks_ < wanted && !problem_ && !servo.loop().lostOfRecording() && !interrupt_.seen(); ++look) {
      if (look % (kAsk_ms / 10) == 0) ask(servo);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      servo.loop().drainRecording(start, [&](const RecordedTick& tick) {
        if (ticks_ == 0 && !problem_) problem_ = writer_.begin(labels_, start);
        if (problem_ || ticks_ == wanted) return;
        ++ticks_;
        watch_.add(tick);
        problem_ = writer_.add(tick);
      });
      servo.loop().drain([](const ServoSample&) {});
    }
    const std::size_t lost = servo.loop().lostOfRecording();
    servo.setDevice(nullptr);  // no force from here on, whatever is printed
    if (!problem_) problem_ = writer_.finish();
    tell(lost);
  }

 private:
  void awaitReady(ServoThread& servo) {
    int ready = 0;
    for (int look = 0; ready < kReadyLooks; ++look) {
      ready = ask(servo) ? ready + 1 : 0;
      const bool late = ready == 0 && 1e-3 * kAsk_ms * look >= options_.wait_s;
      if (late || interrupt_.seen()) {
        servo.setDevice(nullptr);
        if (!late) throw CommandError{tr("broken off before the first tick; nothing was recorded"), kBrokenOff};
        char text[80];
        std::snprintf(text, sizeof text, "it was not ready within %g s, and nothing was recorded", options_.wait_s);
        throw CommandError{Problem{options_.device, 0, 0, text, last_said_}.text()};
      }
      if (ready < kReadyLooks) std::this_thread::sleep_for(std::chrono::milliseconds(kAsk_ms));
    }
  }

  // Prints what the user must do with the device whenever this changes. Returns whether the device is ready.
  bool ask(ServoThread& servo) {
    const DeviceStatus status = servo.loop().device()->status();
    const std::string& text = status.text;
    if (text != said_ && !text.empty()) {
      out() << text << (status.asks_calibrate ? " Then press Enter." : "") << '\n';
      out().flush();
    }
    std::string line;
    if (status.asks_calibrate && typedLine(line, 0) == Typed::Line) servo.loop().device()->calibrate();
    if (!text.empty()) last_said_ = text;
    said_ = text;
    return status.ready;
  }

  void tell(std::size_t lost) const {
    char kept[80];
    const auto ticks = static_cast<unsigned long long>(writer_.kept());
    std::snprintf(kept, sizeof kept, "%llu ticks (%.2f s)", ticks, double(ticks) * kTick_s);
    if (problem_)
      throw CommandError{ticks ? trf("{0}; the force is off, and {1} are kept in the file", problem_->text(), kept)
                               : trf("{0}; the force is off, and nothing was recorded", problem_->text())};
    const auto fail = [&](const std::string& what, const std::string& remedy) {
      throw CommandError{Problem{options_.file, 0, 0, what, remedy}.text()};
    };
    if (lost)
      fail("the computer was too slow: " + std::to_string(lost) +
               " ticks are missing, so the recording cannot be replayed",
           "end other programs, or write to another disk");
    out() << kept << " in " << options_.file << ", " << watch_.touching() << " of them in contact\n"
          << Lines{watch_.reported()};
    if (watch_.led()) return;
    fail("the device led no tick of this recording", last_said_.empty() ? "see `moltact devices`" : last_said_);
  }

  const RecordOptions& options_;
  const InterruptWatch interrupt_;  // keeps what was recorded before the interrupt and lets the device close in order
  ServoRecordingWriter writer_;
  Labels labels_;
  DeviceWatch watch_;
  std::uint64_t ticks_ = 0;
  std::optional<Problem> problem_;
  std::string said_, last_said_;
};

ServoRecordingWriter openedFile(const RecordOptions& options) {
  auto writer = ServoRecordingWriter::create(options.file, options.overwrite);
  if (writer) return *std::move(writer);
  std::error_code error;
  if (!options.overwrite && fs::exists(options.file, error))
    throw CommandError{trf(
        "{0} is there already and stays as it is; choose another name, or replace it with --overwrite", options.file)};
  throw CommandError{writer.problem().text()};
}

void recordHand(const RecordOptions& options) {
  const Molecule molecule = options.molecule.load();
  const auto scene = std::make_shared<const SphereGrid>(molecule.spheres);
  checkOutputs({{"--out", options.file}});
  auto device = openDevice(options.device);
  if (!device) throw CommandError{device.problem().text()};
  const DeviceInfo info = (*device)->info();
  const ServoSettings settings = settingsFor(*scene, options.touch, info);
  Recorder recorder(options, openedFile(options), labelsOf(options, *scene, info.name));
  checkHand(options.touch, false, options.hand);
  auto felt = makeInteraction(interactionInput(options.touch, molecule, scene));
  MouseDevice mouse;
  ServoThread servo(mouse);
  servo.loop().setSettings(settings);
  servo.setDevice(std::move(*device));
  servo.record(true);
  if (const auto found = findDevice(options.device); found && !found->note.empty()) out() << found->note << '\n';
  out() << scaleSentence(settings.workspace, steadyStiffness_N_per_mm(settings.stiffness_N_per_mm, info)) << '\n';
  out().flush();
  recorder.run(servo, std::move(felt));
}

void replayHand(const std::string& file) {
  const auto recording = readServoRecording(file);
  if (!recording) throw CommandError{recording.problem().text()};
  const auto fail = [&](const std::string& what, const char* remedy) {
    throw CommandError{Problem{file, 0, 0, what, remedy}.text()};
  };
  if (recording->ticks.empty())
    fail(recording->torn.empty() ? "the recording holds no ticks" : recording->torn, "record it again");
  const auto label = [&](const char* key) {
    return recording->labels.contains(key) ? recording->labels.at(key) : std::string();
  };
  const TouchSetup touch = touchOf(*recording);
  const auto known = [&](const char* what, const std::string& name, bool is) {
    if (!is)
      fail("it was recorded with " + std::string(what) + " \"" + name + "\" that is not known here", "record it again");
  };
  known("a method", touch.method, findMethod(touch.method));
  known("an interaction", touch.interaction, findInteractionKind(touch.interaction));
  const Molecule molecule = MoleculeArgument{labelledMolecule(recording->labels)}.load();
  const bool placed = recording->placed.size() == molecule.spheres.size();
  const RecordedScene scene =
      recordedScene(recording->labels, placed ? SharedArray<Sphere>(recording->placed) : molecule.spheres);
  if (!label("balls").empty() && label("balls") != fingerprint(*scene.spheres))
    fail("the molecule \"" + label("molecule") + "\" is not the one any more that it was recorded on",
         "put the old file back, or record it again");

  const auto felt = makeInteraction(interactionInput(touch, molecule, scene.spheres, scene.body));
  if (!felt) fail("it was recorded with a body in the hand, and does not say which", "record it again");
  const ReplayResult result = replay(*recording, felt.get(), scene.spheres.get());
  char text[200];
  if (result.motion_unknown)
    fail("in " + std::to_string(result.motion_unknown) + " of " + std::to_string(result.ticks) +
             " ticks the molecule moved, and the file does not contain its motion",
         "record it again with this version");
  if (result.first_difference) {
    std::snprintf(
        text, sizeof text,
        "%llu ticks: the forces differ from tick %llu on, by at most %.3g N and %.3g N mm, the body's position by "
        "%.3g A%s",
        static_cast<unsigned long long>(result.ticks), static_cast<unsigned long long>(*result.first_difference),
        result.max_difference_N, result.max_difference_N_mm, result.max_difference_A,
        recording->start ? "" : "; another build made the recording");
    fail(text + (recording->torn.empty() ? std::string() : "; " + recording->torn), "");
  }
  out() << result.ticks << " ticks: the same forces and torques to the last bit\n";
  if (!recording->torn.empty()) fail(recording->torn, "");
}

}  // namespace

void addDeviceRecording(CLI::App& device) {
  const auto options = std::make_shared<RecordOptions>();
  CLI::App* records = device.add_subcommand("record", "Record a hand on a molecule: every position and every force");
  records
      ->add_option("NAME", options->device,
                   "A name that `moltact devices` lists, or a driver with an address, such as open-tcp:7010")
      ->required();
  options->molecule.addTo(*records);
  records->add_option("--out", options->file, "The file to write")->type_name(kFileType)->required();
  records->add_flag("--overwrite", options->overwrite, "Replace an existing file");
  options->hand = addTouchOptions(*records, options->touch);
  records
      ->add_option("--seconds", options->seconds, "Length of the recording; a replay needs 1.3 GB of memory per hour")
      ->check(numberFrom(0.1, 3600.0))
      ->capture_default_str();
  records->add_option("--wait", options->wait_s, "Wait up to this many seconds until the device is ready")
      ->check(numberFrom(0.0, 3600.0))
      ->capture_default_str();
  records->callback([options] { recordHand(*options); });

  const auto file = std::make_shared<std::string>();
  CLI::App* replays = device.add_subcommand("replay", "Recompute a recording and compare the forces to the last bit");
  replays->add_option("FILE", *file, "A recording")->type_name(kFileType)->required();
  replays->callback([file] { replayHand(*file); });
}

}  // namespace moltact
