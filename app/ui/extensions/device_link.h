// The device in the person's hand: which there are, which is chosen, how it is, and what its safety limits did. At the
// start the one that was chosen last is opened, or is waited for; where nobody ever chose, the default. Where it leads,
// its axes are the screen's. Window's thread. Units: second, millimetre.
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

  static constexpr double kShowLimit_s = 1.0;  ///< a limit that acted is shown for so long
  static constexpr double kLongStart_s = 1.5;  ///< a soft start that lasts longer is shown over the view
  static constexpr double kTry_s = 4.0;        ///< the gentle force is tried for so long
  static constexpr double kTry_N = 0.4;
  /// Ticks began no later than so many microseconds after their time, by class; the last class is the rest.
  static constexpr std::array<double, 8> kLate_us{20, 50, 100, 200, 500, 1000, 2000, 5000};

  /// The devices found at the last search, which runs every kLook_s while the page is open or a device is waited for,
  /// and where nobody ever chose one, every kLookForOffer_s.
  const std::vector<FoundDevice>& found() const { return found_; }
  static constexpr double kLook_s = 2.0, kLookForOffer_s = 5.0;
  /// Looks by `find` from now on.
  void lookBy(DeviceLister::Find find) { lister_ = DeviceLister(std::move(find)); }
  /// Takes it into use, now and at the next start, as soon as it has been opened beside the window, and never within the
  /// frame that asks: what is drawn may show the device that goes. "mouse" goes back to the mouse alone. A device that
  /// cannot be opened gives a message and changes nothing.
  void choose(const std::string& name);
  /// The title of the device that is being opened because it was chosen; empty: none is.
  const std::string& opening() const { return opening_title_; }
  const std::string& chosen() const { return chosen_; }
  /// The address that the person writes for a driver that takes one; at first the one that was used last.
  std::string& address(const DeviceDriver& driver);
  /// A device that is none of those found leads until another is chosen, or until what led before gets it back. It is
  /// not remembered for the next start.
  void lend(std::unique_ptr<Device> device);
  void giveBack(const std::string& before);
  /// The name of the device that was chosen earlier and is not there; empty: none is waited for.
  const std::string& awaited() const { return awaited_title_; }
  const DeviceStatus& status() const { return status_; }

  /// Pulls gently to the right for kTry_s, whatever is on the stage.
  void tryForce();
  double tryingLeft_s() const { return trying_s_; }

  /// The length and the force in the molecule that a length and a newton at the hand stand for, and the reason. In a
  /// task's dark the length alone: the surface may be softer or harder there, which is for the hand to find.
  struct ScaleWords {
    std::string sentence, reason;
  };
  ScaleWords scaleWords(const HapticSession& scene) const;

  /// Whether it waits for its calibrate(), when the person has done what status() says.
  bool wantsCalibration(const ServoLink& servo) const;

  /// The limits that acted within the last kShowLimit_s, in whatever scene.
  std::vector<const LimitWords*> actingLimits() const;
  /// The part of them that is shown over the view: a soft start, which every touch begins with, only where it does not
  /// end; the panic key has words of its own. With a mouse, of which no motor needs care, only that the computer was
  /// late, while the hand pushes: the force that is shown falls then.
  std::vector<std::string> limitNotices() const;
  /// The fraction of the last thousand or so ticks in each class of kLate_us and beyond.
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
  const TaskStager& stager_;  // in the dark nothing may tell what is touched
  /// Why a device is opened.
  enum class For { Choice, Start, Default, GiveBack, Awaited };
  struct Wish {
    std::string name;
    For purpose = For::Choice;
  };
  void wish(const std::string& name, For purpose);
  void openWished();
  void finishOpening();
  void settled(const Wish& wish);
  void failed(const Wish& wish, const PendingDeviceOpen::Opened& result);
  void use(const std::string& name, std::unique_ptr<Device> device);
  void taken(const std::string& name);
  std::string titleOf(const std::string& name) const;
  bool nobodyChose() const;
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
  std::map<std::string, std::string> addresses_;  // by the driver's name
  std::optional<Wish> wish_;                      // to be opened next
  std::unique_ptr<PendingDeviceOpen> opening_;    // one at a time, so that no hardware is opened twice
  Wish opened_for_;
  bool unwanted_ = false;  // what is being opened is closed again at once
  std::string opening_title_;
  PendingDeviceOpen::Hardware hardware_;  // of the device in use
  double searched_s_ = 0.0;
  DeviceLister lister_;
  bool begun_ = false, takes_default_ = false;
  double looked_s_ = -1.0;                // none yet: negative
  std::string offered_;                   // the device that nobody chose and could
  MessageId offer_id_ = 0, told_id_ = 0;  // the messages that offer it and tell the state
  DeviceStatus status_;
  std::string told_;  // of the device's state
  double asked_s_ = -1.0, trying_s_ = 0.0, soft_start_s_ = 0.0;
  std::array<double, 32> limit_left_s_{};
  std::array<float, kLate_us.size() + 1> lateness_{};
};

}  // namespace moltact
