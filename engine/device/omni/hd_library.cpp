#include "engine/device/omni/hd_library.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <type_traits>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/shared_library.h"

namespace moltact::hd {
namespace {

Expected<Library> load() {
  std::vector<std::string> names{"libHD.so", "libHD.so.3", "/usr/lib/libHD.so", "/usr/lib64/libHD.so"};
  const char* variable = std::getenv("MOLTACT_LIBHD");
  const std::string named = variable ? variable : "";  // empty counts as unset
  if (!named.empty()) names = {named};
  const auto library = SharedLibrary::open(names);
  if (!library)
    return Problem{"", 0, 0, trf("OpenHaptics' libHD.so could not be loaded ({0})", library.problem().message),
                   named.empty()
                       ? tr("install 3D Systems' \"OpenHaptics for Linux\" and the driver of the device, both from "
                            "their support pages, or name the library with MOLTACT_LIBHD=/path/libHD.so")
                       : tr("correct or unset MOLTACT_LIBHD, which names it; the library comes with 3D Systems' "
                            "\"OpenHaptics for Linux\"")};
  Library hd{};
  const char* missing = nullptr;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(library->symbol(name));
    if (!function && !missing) missing = name;
  };
  find(hd.initDevice, "hdInitDevice");
  find(hd.disableDevice, "hdDisableDevice");
  find(hd.makeCurrentDevice, "hdMakeCurrentDevice");
  find(hd.beginFrame, "hdBeginFrame");
  find(hd.endFrame, "hdEndFrame");
  find(hd.getError, "hdGetError");
  find(hd.enable, "hdEnable");
  hd.disable = reinterpret_cast<decltype(hd.disable)>(library->symbol("hdDisable"));
  find(hd.getBooleanv, "hdGetBooleanv");
  find(hd.getIntegerv, "hdGetIntegerv");
  find(hd.getDoublev, "hdGetDoublev");
  find(hd.setDoublev, "hdSetDoublev");
  find(hd.getString, "hdGetString");
  find(hd.checkCalibration, "hdCheckCalibration");
  find(hd.updateCalibration, "hdUpdateCalibration");
  find(hd.startScheduler, "hdStartScheduler");
  find(hd.stopScheduler, "hdStopScheduler");
  find(hd.setSchedulerRate, "hdSetSchedulerRate");
  find(hd.scheduleAsynchronous, "hdScheduleAsynchronous");
  find(hd.unschedule, "hdUnschedule");
  if (missing)
    return Problem{
        "", 0, 0, trf("{0} has no function {1}", (named.empty() ? "libHD.so" : named), missing),
        named.empty()
            ? tr("install OpenHaptics 3.0 or later for Linux, or name its libHD.so with MOLTACT_LIBHD=/path/libHD.so")
            : tr("MOLTACT_LIBHD is to name the libHD.so of OpenHaptics 3.0 or later; correct or unset it")};
  return hd;
}

// A sentence adapted for use within another one.
std::string asPart(std::string sentence, bool keeps_capital) {
  if (sentence.ends_with('.')) sentence.pop_back();
  if (!keeps_capital && !sentence.empty()) sentence.front() = static_cast<char>(std::tolower(sentence.front()));
  return sentence;
}

}  // namespace

Expected<const Library*> Library::get() {
  // The library stays loaded once found; until then each call searches again, because it may be installed while the
  // program runs.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  static std::optional<Library> found;
  if (!found) {
    const auto loaded = load();
    if (!loaded) return loaded.problem();
    found = *loaded;
  }
  return &*found;
}

// Translators: these sentences also become parts of another one, then their first letter is made small: begin with an
// article or a verb.
ErrorWords errorWords(std::uint32_t code) {
  switch (code) {
    case kWarmMotors:
      return {tr("The device's motors are warm."),
              tr("Let go for a minute; the force is smaller until they have cooled.")};
    case kExceededMaxForce:
      return {tr("More force was asked than the device can give."),
              tr("Nothing is to be done: the device has cut it.")};
    case kExceededImpulse:
      return {tr("The device has cut a force that changed too fast."), tr("Touch on: the force comes back softly.")};
    case kExceededVelocity:
      return {tr("The stylus moved faster than the device allows."), tr("Touch on: the force comes back softly.")};
    case kForceError:
      return {tr("The device could not give the force."), tr("Let go of the stylus for a moment.")};
    case kDeviceFault:
      return {tr("The device reports a fault."), tr("Look at its power supply and its cable, then plug it in again.")};
    case kAlreadyInitiated:
      return {tr("Another program uses the device."), tr("End that program.")};
    case kCommError:
      return {tr("The connection to the device is lost."), tr("Plug its cable in again.")};
    case kCommConfig:
      return {tr("The device's connection is not set up."),
              tr("Run the maker's setup program, Touch_Setup or Geomagic_Touch_Setup.")};
    case kTimerError:
      return {tr("The driver found no clock that is fast enough."), tr("Reinstall the manufacturer's driver.")};
    case kInvalidLicense:
      return {tr("OpenHaptics has no valid licence."), tr("Install the licence that came with it."), true};
    case kBadHandle:
      return {tr("The driver does not know the device any more."), tr("Plug the device in again.")};
    case kSchedulerFull:
      return {tr("The driver's clock has no place for this program."), tr("End other programs that use the device.")};
    default: {
      char number[16];
      std::snprintf(number, sizeof number, "0x%04X", code);
      const std::string text = trf("The driver reports error {0}.", number);
      if (errorWeight(code) == 1)
        return {text,
                tr("The program has asked it wrongly: nothing is to be done at the device; please report the number.")};
      return {text, tr("Plug the device in again; if that does not help, restart the program.")};
    }
  }
}

Problem problemOf(const std::string& what, const ErrorWords& words) {
  return Problem{"", 0, 0, what + ": " + asPart(words.message, words.begins_with_name), asPart(words.remedy, false)};
}

int errorWeight(std::uint32_t code) noexcept {
  if (code == kNoError) return 0;
  if ((code >= kDeviceFault && code <= kTimerError) || code == kBadHandle || code == kSchedulerFull ||
      code == kInvalidPriority)
    return 4;
  if (code >= kWarmMotors && code <= kForceError) return 3;
  const std::uint32_t group = code >> 8;
  return group == 1 || group == 4 ? 1 : 2;
}

}  // namespace moltact::hd
