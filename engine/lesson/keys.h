// Every key that a lesson may use, in one table. The reader checks lessons against it, and the authors' reference is
// generated from it. A touch block has the common keys here and those of its task kind (tasks/registry.h). Plain data;
// any thread but the haptic one.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/selection.h"
#include "engine/lesson/source_text.h"
#include "engine/molecule/draw_style.h"

namespace moltact {

enum class KeyBlock : std::uint8_t { FrontMatter, Step, Scene, Touch, Answer, Facts };

/// "front matter", "step", "scene", "touch", "answer", "facts" in English; `trc("block", …)` where a message names it.
const char* blockName(KeyBlock block);

enum class ValueType : std::uint8_t {
  Text,       ///< a line of text
  TextList,   ///< texts: "- " lines, or separated by commas
  Count,      ///< a whole number
  Number,     ///< any number, with or without a unit (the answer to a question)
  Quantity,   ///< a number with its unit; without one if the key has no dimension
  Range,      ///< "0.2 N to 0.6 N"
  Word,       ///< one of `words`
  WordList,   ///< some of `words`, separated by commas
  Selection,  ///< atoms (selection.h)
  Target,     ///< one of `words`, or a selection
  Path,       ///< selections in order, separated by "then"; or one of `words`
  View,       ///< "front", "facing residue 35", "turned 30 10", each optionally followed by ", zoom ligand"
  Remarks,    ///< "- SELECTION -> text" lines, or a single one after the colon
  Styles,     ///< "cartoon, surface 40% for chain A": styles of `words`, each with its opacity and its atoms
  /// `words` and names in double quotes, each for its atoms: 'residue for chain A, "the cleft" for residue 35'; or
  /// "none"
  Marks,
  Counts,  ///< whole numbers, separated by commas
  Way,     ///< "go to #a-step", "skip #a-step, #another": steps by their links or headings
  Places,  ///< `least` to `most` selections with " - " between them, several parted by commas; or "none"
  Facts,   ///< "- PLACES = NUMBER" lines, or one of them behind the colon: `least` to `most` selections with " - "
           ///< between them, and a number in the key's dimension (None: a count)
};

/// The complete description of one key.
struct KeySpec {
  std::string_view name;
  ValueType type = ValueType::Text;
  std::string_view meaning;  ///< one sentence for authors
  /// The value used if the key is missing, as an author would write it; may be empty.
  std::string_view fallback = {};
  bool required = false;
  Dimension dimension = Dimension::None;  ///< of Quantity and Range
  /// smallest and largest value (in the code's unit), for Count, Quantity and Range
  double min = 0.0;
  double max = std::numeric_limits<double>::max();
  std::vector<std::string_view> words = {};
  /// The word in capitals in `name` is a placeholder: "view NAME", "after N wrong".
  bool named = false;
};

/// The keys of a block; for Touch, those common to all task kinds.
const std::vector<KeySpec>& keysOf(KeyBlock block);

/// How some atoms are drawn, as the author wrote it.
struct StyleSpec {
  DrawStyle style = DrawStyle::Spheres;
  double opacity = 1.0;  ///< 0.05 to 1
  Selection atoms;       ///< not given: all
  Place place;           ///< of the selection
  friend bool operator==(const StyleSpec& a, const StyleSpec& b) {
    return a.style == b.style && a.opacity == b.opacity && a.atoms == b.atoms;
  }
};

/// The direction from which a molecule is viewed, as the author wrote it.
struct ViewSpec {
  std::string text = "side";  ///< as written
  std::string side = "side";  ///< one of the key's words; empty if the view is given otherwise
  Selection facing;           ///< atoms to be rotated to the front
  /// Rotations to the right, upwards and around the line of sight, relative to the front view (unit: degree).
  std::optional<std::array<double, 3>> turned_deg = {};
  Selection zoom;                  ///< atoms that fill the view
  Place facing_place, zoom_place;  ///< of the selections
  friend bool operator==(const ViewSpec& a, const ViewSpec& b) { return a.text == b.text; }
};

/// A word of a Marks value, a name in quotes, or both, with the atoms that it marks.
struct MarkSpec {
  std::string word, name;  ///< one of them may be empty
  Selection atoms;         ///< not given: all
  Place place;             ///< of the selection
  friend bool operator==(const MarkSpec& a, const MarkSpec& b) {
    return a.word == b.word && a.name == b.name && a.atoms == b.atoms;
  }
};

/// Places between which something is measured.
struct PlacesSpec {
  std::vector<Selection> atoms;  ///< each place is the centre of its selection
  std::vector<Place> places;     ///< of each selection
  friend bool operator==(const PlacesSpec& a, const PlacesSpec& b) { return a.atoms == b.atoms; }
};

/// What an author states about a molecule: "chain A - chain B = 9.3 Å".
struct FactSpec {
  enum class Relation : std::uint8_t { Equal, Less, More };
  std::vector<Selection> atoms;
  std::vector<Place> places;  ///< of each selection
  Relation relation = Relation::Equal;
  std::string stated;            ///< the number as written: "9.3 Å"
  double low = 0.0, high = 0.0;  ///< the stated number, or its range (Å, degree, or 1)
  double half_digit = 0.0;       ///< half a unit of its last digit: what rounding may hide; 0 for counts
  Place place;                   ///< of the line

  /// Whether a computed value agrees with the stated one.
  bool holds(double computed) const;
};

/// The author's remark on a touch of these atoms.
struct SelectionRemark {
  Selection atoms;
  std::string text;
  Place place;  ///< of the selection
  friend bool operator==(const SelectionRemark& a, const SelectionRemark& b) {
    return a.atoms == b.atoms && a.text == b.text;
  }
};

/// A parsed value. The key's type determines which members are set.
struct Value {
  Place place;                     ///< position of the value; line 0 for a default
  std::string text;                ///< as written
  double number = 0.0;             ///< Count, Number, Quantity (in the code's unit)
  double low = 0.0, high = 0.0;    ///< Range (in the code's unit)
  std::vector<std::string> words;  ///< Word (one), WordList, TextList, Target and Path where a word was given; the
                                   ///< steps of a Way
  std::vector<Place> places;  ///< of each of `words`, for WordList, TextList and Way; of each of `path`, of `counts`
  std::vector<std::size_t> counts = {};  ///< Counts
  bool skips = false;                    ///< of a Way: "skip", else "go to"
  Selection selection;                   ///< Selection, and Target with atoms
  std::vector<Selection> path = {};      ///< Path with atoms, in order
  std::vector<StyleSpec> styles = {};
  ViewSpec view = {};
  std::vector<MarkSpec> marks = {};
  std::vector<PlacesSpec> measures = {};
  std::vector<SelectionRemark> remarks = {};
  std::vector<FactSpec> facts = {};
};

/// Where the selection of a value begins.
Place selectionPlace(const Value& value);

/// A text for students: the author's, or the key's default in the language in use.
class AuthorsText {
 public:
  AuthorsText() = default;
  explicit AuthorsText(const Value& value) : written_(value.text), own_(value.place.line != 0) {}
  std::string text() const;
  /// Whether the author wrote it.
  bool own() const { return own_; }

 private:
  std::string written_;
  bool own_ = false;
};

/// Values by key; a named key is stored as the author wrote it ("view the cleft"). Contains no key that is neither
/// given nor has a default.
class KeyValues {
 public:
  void set(std::string_view key, Value value) { values_.insert_or_assign(std::string(key), std::move(value)); }
  bool has(std::string_view key) const { return values_.contains(key); }
  /// The value of a key; an empty Value if there is none.
  const Value& operator[](std::string_view key) const;
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::map<std::string, Value, std::less<>> values_;
};

/// Parses one value. A Problem and `places` have line 0 and the column within `text`.
Expected<Value> parseValue(const KeySpec& key, std::string_view text);

/// Adds the remark of a line "SELECTION -> text" to `value`; otherwise returns the problem, as above.
std::optional<Problem> addRemark(Value& value, std::string_view line);

/// Adds what a line "PLACES = NUMBER" states to the facts of `value`; else the problem, as above.
std::optional<Problem> addFact(const KeySpec& key, Value& value, std::string_view line);

}  // namespace moltact
