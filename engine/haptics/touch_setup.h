// The settings of a scene's touch, and one table of their properties. The table generates the keys and locks of scenes,
// the changes made by tasks, the fields of attempts and the labels of recordings. It also generates undo, the touch
// panel and the options of commands. A new property needs a member here, a row in touch_setup.cpp and the code that
// applies it. Plain data; any thread except the haptic one.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/offered_word.h"
#include "engine/haptics/contact.h"
#include "engine/language/units.h"

namespace moltact {

/// Limits of TouchSetup::coupling_N_per_mm and of the amount of TouchSetup::probe_charge_e.
inline constexpr double kMaxCoupling_N_per_mm = 1.0, kMaxProbeCharge_e = 2.0;
/// The largest TouchSetup::weak_gain.
inline constexpr double kMaxWeakGain = 8.0;

struct TouchSetup {
  double probe_A = kWaterProbe_A;
  double stiffness_N_per_mm = 0.5;    ///< of the felt spring, in the device's space
  std::string method = "exact";       ///< as in findMethod (methods.h)
  bool force_on = true;               ///< false: contacts are computed, but no force is given
  std::string interaction = "probe";  ///< as in findInteractionKind (interactions.h)
  std::string charges = "none";       ///< as in chargeSources (atom_chemistry.h)
  std::string forces = "none";        ///< between atoms, as in forceChoices (field/force_choices.h)
  std::string dielectric = "water";   ///< of these forces, as in dielectricChoices
  double probe_charge_e = 0.0;        ///< of the probe's atom, for these forces
  /// Stiffness of the virtual coupling between the hand and what it holds in these forces, in the molecule; 0: by the
  /// number of atoms (unit: N/mm; 1 kcal/mol/A^2 is 0.000695 N/mm).
  double coupling_N_per_mm = 0.0;
  double weak_gain = 1.0;        ///< of the weakest of these forces: PairModel::weak_gain, 1 or more
  double friction = 0.0;         ///< Friction::coefficient (surface_properties.h)
  double stick_slip = 0.0;       ///< Friction::stick_slip
  std::string texture = "none";  ///< what friction depends on, as in textureChoices (texture_choices.h)

  friend bool operator==(const TouchSetup&, const TouchSetup&) = default;
};

/// The member of a property. A text takes one of the words that TouchProperty::words returns; keys and options offer
/// exactly these. The panel offers only those interactions that fit what the hand holds (resolveInteraction).
using TouchMember = std::variant<double TouchSetup::*, bool TouchSetup::*, std::string TouchSetup::*>;
/// A property's value, of the member's type.
using TouchValue = std::variant<double, bool, std::string>;

struct TouchRange {
  double min = 0.0, max = 0.0;  ///< in the code's unit
};

/// The touch panel's control of a property. A property without a title has a control of its own there, or none.
struct TouchControl {
  std::string_view title = {}, tip = {};  ///< untranslated (N_); "{0}" in the tip is the default value
  TouchRange range = {};                  ///< of a number
  double step = 0.0;                      ///< of a number
  int decimals = -1;                      ///< digits shown after the decimal sign; negative: those of the unit
  bool first = false;                     ///< at the top of the panel; else in the details
  std::string (*note)(const TouchSetup& touch) = nullptr;  ///< a sentence below the control, translated; null: none
  /// True where the control has an effect; null: everywhere. `body`: the hand holds a body.
  bool (*shown)(const TouchSetup& touch, bool body) = nullptr;
};

struct TouchProperty {
  TouchMember member;
  std::string_view key;         ///< name in a scene, a lock and an option: "probe"
  std::string_view field;       ///< name in an attempt: "probe_A"
  std::string_view label = {};  ///< name in a recording; empty if every tick of a recording stores the value
  /// True if attempts and recordings of every version contain the property. A later property is written only if it
  /// differs from the default, and a file without it means the default.
  bool in_old_files = false;
  /// True if a changed value requires a new interaction, which begins with a soft start. False if the servo loop
  /// applies the value while running; then ServoSettings::take and giveTo transfer it, and each tick of a recording
  /// stores it (without a label).
  bool requires_rebuild = true;
  /// True for a property of SurfaceProperties: commands have an option for it although it needs no rebuild.
  bool of_surface = false;
  Dimension dimension = Dimension::None;          ///< of a number
  TouchRange in_scenes = {}, in_files = {};       ///< of a number: range in lessons; range in attempts and labels
  std::vector<OfferedWord> (*words)() = nullptr;  ///< of a text (required): its possible words
  TouchControl control = {};
  std::string_view fallback = {};  ///< the default as written in a lesson
  std::string_view meaning = {};   ///< one sentence for authors
  std::string_view compared = {};  ///< the same for tasks that compare two things; empty: not available there
};

/// All properties, in the order of files and pages.
std::span<const TouchProperty> touchProperties();

TouchValue touchValue(const TouchSetup& setup, const TouchProperty& property);
/// Sets a property. A value of another type than the member's is ignored.
void setTouchValue(TouchSetup& setup, const TouchProperty& property, const TouchValue& value);
/// True if authors and users can choose a value; a text with one possible word is never offered.
bool isChoice(const TouchProperty& property);

/// True if an interaction created for `a` also serves `b`: they agree in all properties with requires_rebuild.
bool sameConstruction(const TouchSetup& a, const TouchSetup& b);

/// Converts a setup to the labels of a recording and back. A property without a label keeps its value from
/// `otherwise`. An invalid number or a missing label gives the default; a missing label with in_old_files gives an
/// empty word.
std::map<std::string, std::string> touchLabels(const TouchSetup& setup);
TouchSetup labelledTouch(const std::map<std::string, std::string>& labels, const TouchSetup& otherwise = {});

/// A set of properties whose values replace those of a scene.
class TouchChange {
 public:
  void set(const TouchProperty& property, TouchValue value) { values_[property.field] = std::move(value); }
  bool has(const TouchMember& member) const;
  /// The scene's setup with the changes applied.
  TouchSetup over(TouchSetup scene) const;
  /// Updates `now`, the present setup of a scene with original setup `scene`, from the change `before` to this
  /// change. A property whose value differs between the two changes is set; one that is no longer changed returns to
  /// `scene`. All others stay, because the user may have set them.
  void replace(const TouchChange& before, const TouchSetup& scene, TouchSetup& now) const;

  friend bool operator==(const TouchChange&, const TouchChange&) = default;

 private:
  std::map<std::string_view, TouchValue> values_;  // by the property's field
};

}  // namespace moltact
