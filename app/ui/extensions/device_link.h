// The haptic device: the devices found, the chosen one, its state and the limits of the safety stage. At the start, the
// last chosen device is opened or waited for; if none was ever chosen, the default one is opened. While a device is
// used, its axes are those of the screen. Window's thread. Units: second, millimetre.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/extensions/device_lister.h"
#include "app/ui/widgets/messages.h"
#include "engine/device/pending_device_open.h"
#include "engine/servo/safety_limits.h"

namespace moltact {

struct ApplicationOptions;
struct Layout;
struct PanelState;
struct Settings;
class TaskStager;

class DeviceLink : public Extension {
 public:
  DeviceLink(const TaskStager& stager, HapticSession& scene, Settings& settings, Messages& messages, PanelState& panels,
             const Layout& layout, const ApplicationOptions& options, const FrameTime& time)
      : scene_(scene),
        settings_(settings),
        messages_(messages),
        panels_(panels),
        layout_(layout),
        options_(options),
        time_(time),
        stager_(stager) {}

  static constexpr double kShowLimit_s = 1.0;  ///< a limit is displayed for this time after it acted
  static constexpr double kLongStart_s = 1.5;  ///< a soft start that lasts longer is displayed over the view
  static constexpr double kTry_s = 4.0;        ///< duration of the test force
  static constexpr double kTry_N = 0.4;
  /// Upper limits of the classes of lateness: how long after its nominal time a tick began. The last class holds all
  /// later ticks. Unit: microsecond.
  static constexpr std::array<double, 8> kLate_us{20, 50, 100, 200, 500, 1000, 2000, 5000};

  /// The devices found at the last search. A search runs every kLook_s while the page is open or a device is awaited,
  /// and every kLookForOffer_s if none was ever chosen.
  const std::vector<FoundDevice>& found() const { return found_; }
  static constexpr double kLook_s = 2.0, kLookForOffer_s = 5.0;
  /// Sets the function for later searches.
  void setFinder(DeviceLister::Find find) { lister_ = DeviceLister(std::move(find)); }
  /// Chooses a device for now and for the next start. It is opened in the background and used as soon as it is open,
  /// never within the calling frame, whose drawing may show the old device. "mouse" returns to the mouse. If the device
  /// cannot be opened, a message says so and nothing changes.
  void choose(const std::string& name);
  /// The title of the chosen device that is being opened, or empty.
  const std::string& opening() const { return opening_title_; }
  const std::string& chosen() const { return chosen_; }
  /// The address typed for a driver that takes one; initially the last one used.
  std::string& address(const DeviceDriver& driver);
  /// Uses a device that is not among those found until another is chosen or giveBack() restores the previous one. It is
  /// not stored for the next start.
  void useTemporarily(std::unique_ptr<Device> device);
  void giveBack(const std::string& before);
  /// The title of the awaited device, which was chosen earlier and is not present; empty if none.
  const std::string& awaited() const { return awaited_title_; }
  const DeviceStatus& status() const { return status_; }

  /// Applies a gentle force to the right for kTry_s, independent of the scene.
  void tryForce();
  double tryingLeft_s() const { return trying_s_; }

  /// What a length and a newton at the hand correspond to in the molecule, and why. In a task's dark, only the length:
  /// the stiffness may be part of the task.
  struct ScaleWords {
    std::string sentence, reason;
  };
  ScaleWords scaleWords(const HapticSession& scene) const;

  /// Whether the device waits for calibrate() after the user has followed the instruction in status().
  bool wantsCalibration(const ServoLink& servo) const;

  /// The limits that acted within the last kShowLimit_s, in any scene.
  std::vector<const LimitWords*> actingLimits() const;
  /// The limits that are displayed over the view. A soft start, which begins every touch, is included only if it does
  /// not end; the panic key has its own message. With a mouse, which has no motors, only lateness of the computer
  /// during a push is included: it reduces the displayed force.
  std::vector<std::string> limitNotices() const;
  /// The fraction of about the last thousand ticks in each class of kLate_us and beyond.
  const std::array<float, kLate_us.size() + 1>& lateness() const { return lateness_; }

  void beforeTicks() override;
  void afterPanels() override;
  bool live() const override { return chosen_ != "mouse" || trying_s_ > 0.0 || !awaited_.empty() || wish_ || opening_; }

 private:
  HapticSession& scene_;
  Settings& settings_;
  Messages& messages_;
  PanelState& panels_;
  const Layout& layout_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  const TaskStager& stager_;  // in the dark, no text may reveal what is touched
  /// The reason for opening a device.
  enum class For { Choice, Start, Default, GiveBack, Awaited };
  struct Wish {
    std::string name;
    For purpose = For::Choice;
  };
  void wish(const std::string& name, For purpose);
  void openWished();
  void finishOpening();
  void finished(const Wish& wish);
  void failed(const Wish& wish, const PendingDeviceOpen::Opened& result);
  void use(const std::string& name, std::unique_ptr<Device> device);
  void taken(const std::string& name);
  std::string titleOf(const std::string& name) const;
  bool noneChosen() const;
  void await(const std::string& name, const std::string& title);
  void begin();
  void look();
  double lookEvery_s() const;
  void offer();
  void leadView();
  void stopTrying();
  void ask();
  void watchTicks(const std::vector<ServoSample>& ticks);

  std::vector<FoundDevice> found_;
  std::string chosen_ = "mouse";
  std::string awaited_, awaited_title_;
  std::map<std::string, std::string> addresses_;  // by driver name
  std::optional<Wish> wish_;                      // to be opened next
  std::unique_ptr<PendingDeviceOpen> opening_;    // one at a time, so that no hardware is opened twice
  Wish opened_for_;
  bool unwanted_ = false;  // closes the device immediately after it has been opened
  std::string opening_title_;
  PendingDeviceOpen::Hardware hardware_;  // of the device in use
  double searched_s_ = 0.0;
  DeviceLister lister_;
  bool begun_ = false, takes_default_ = false;
  double looked_s_ = -1.0;                 // negative: not yet
  std::string offered_;                    // a device that is present while none was ever chosen
  MessageId offer_id_ = 0, shown_id_ = 0;  // the messages that offer a device and report its state
  DeviceStatus status_;
  std::string reported_;  // the reported state of the device
  double asked_s_ = -1.0, trying_s_ = 0.0, soft_start_s_ = 0.0;
  std::array<double, 32> limit_left_s_{};
  std::array<float, kLate_us.size() + 1> lateness_{};
};

}  // namespace moltact
