// What a scene is felt with: one value, and one table of its properties. The keys and locks of a scene, what a task
// changes in it, attempts, recordings, undo, the touch panel and the options of commands are all made from the table: a
// property is added by a member here and a row in touch_setup.cpp, and what it does by the code that uses it. Plain
// data; any thread but the haptic one.
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

struct TouchSetup {
  double probe_A = kWaterProbe_A;
  double stiffness_N_per_mm = 0.5;    ///< of the spring that is felt, in the device's space
  std::string method = "exact";       ///< as in findMethod (methods.h)
  bool force_on = true;               ///< false: contact is followed, but no force is given
  std::string interaction = "probe";  ///< as in findInteractionKind (interactions.h)
  std::string charges = "none";       ///< as in chargeSources (atom_chemistry.h)

  friend bool operator==(const TouchSetup&, const TouchSetup&) = default;
};

/// A text is one of its property's words, and never one that anybody may write: panel, keys and options offer these. Only
/// the interaction of a body is none that is offered: a scene has it by its key `in-hand`.
using TouchMember = std::variant<double TouchSetup::*, bool TouchSetup::*, std::string TouchSetup::*>;
/// Of the type that the member has.
using TouchValue = std::variant<double, bool, std::string>;

struct TouchRange {
  double least = 0.0, most = 0.0;  ///< in the code's unit
};

/// How the touch panel offers a property. One without a title has a chooser of its own there, or none.
struct TouchControl {
  std::string_view title = {}, tip = {};  ///< N_; "{0}" in the tip is the default value
  TouchRange range = {};                  ///< of a number
  double step = 0.0;
  int decimals = -1;   ///< of the number shown; below zero: as its unit has them
  bool first = false;  ///< at the head of the panel; else among the details
};

struct TouchProperty {
  TouchMember member;
  std::string_view key;         ///< in a scene, of a lock, of an option: "probe"
  std::string_view field;       ///< in an attempt: "probe_A"
  std::string_view label = {};  ///< in a recording; empty where every tick of a recording holds it
  /// Attempts and recordings of every version carry it. Else it came later: it is written where it differs from the
  /// default, and a file without it means the default.
  bool in_old_files = false;
  /// The interaction is made with it, so that another value needs another interaction, which begins softly. False where
  /// the servo loop itself follows it while it changes: ServoSettings::take and giveTo then hold it, and so does each
  /// tick of a recording (which needs no label).
  bool requires_rebuild = true;
  Dimension dimension = Dimension::None;     ///< of a number
  TouchRange in_scenes = {}, in_files = {};  ///< of a number: what an author may write; what an attempt or label holds
  std::vector<OfferedWord> (*words)() = nullptr;  ///< of a text, which needs them: what it may be
  TouchControl control = {};
  std::string_view fallback = {};  ///< the default as an author writes it
  std::string_view meaning = {};   ///< one sentence for authors
  std::string_view compared = {};  ///< the same in a task that compares the scene with another; empty: none does
};

/// All, in the order in which files and pages have them.
std::span<const TouchProperty> touchProperties();

TouchValue touchValue(const TouchSetup& setup, const TouchProperty& property);
/// A value of another type than the member's changes nothing.
void setTouchValue(TouchSetup& setup, const TouchProperty& property, const TouchValue& value);
/// Authors and people can choose: a text of one possible word is offered nowhere.
bool isChoice(const TouchProperty& property);

/// An interaction made for the one does for the other.
bool sameConstruction(const TouchSetup& a, const TouchSetup& b);

/// The labels of a recording, and back; what stands in no label stays as in `otherwise`. A number that is not sound,
/// and a label that is missing, give the default; a missing one that every recording has gives an empty word.
std::map<std::string, std::string> touchLabels(const TouchSetup& setup);
TouchSetup labelledTouch(const std::map<std::string, std::string>& labels, const TouchSetup& otherwise = {});

/// Some properties that are to be other than a scene has them.
class TouchChange {
 public:
  void set(const TouchProperty& property, TouchValue value) { values_[property.field] = std::move(value); }
  bool has(const TouchMember& member) const;
  /// The scene's setup with the changes in it.
  TouchSetup over(TouchSetup scene) const;
  /// `now` belongs to a scene whose setup is `scene`, changed by `before`. Where this change says something else than
  /// `before` did, `now` takes it (what it says no more: from `scene`); the rest stays, for a person may have set it.
  void replace(const TouchChange& before, const TouchSetup& scene, TouchSetup& now) const;

  friend bool operator==(const TouchChange&, const TouchChange&) = default;

 private:
  std::map<std::string_view, TouchValue> values_;  // by the property's field
};

}  // namespace moltact
