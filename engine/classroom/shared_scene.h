// A student's scene on the projector (docs/live-class.md): the teacher asks one student, the student agrees or not, with or
// without the name, and may take it back at any time. It ends with the step, and it is not shown while it would answer
// a question or a task in the dark for somebody of the class. Nothing of it is a record: it ends with the server.
// No socket, file or clock; any one thread at a time but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/classroom/class_room.h"
#include "engine/classroom/rate_limit.h"

namespace moltact {

/// A student's place in a lesson of the teacher (ClassLesson::id), with the step's number from 0.
struct ScenePlace {
  std::string lesson;
  std::size_t step = 0;
  friend bool operator==(const ScenePlace&, const ScenePlace&) = default;
};

/// Why the scene is not on the projector now.
enum class SceneHidden : std::uint8_t {
  No,
  Dark,       ///< somebody in the lesson works on a task that is done without seeing
  Question,   ///< a question of the step is open for somebody
  NoPicture,  ///< the student's page sends none, as in a dark scene or under another page
};

/// The student's place by the lines of the present attempt. Empty before the first step, in a test, and in a lesson that is
/// not the teacher's.
std::optional<ScenePlace> placeOf(const ClassRoom& room, std::size_t student);

/// Whether a scene of this place would answer something for a student who is here, by the lines that have come. Dark: a
/// task without sight is open at the step at which somebody works on this lesson; the molecule may be the same at all
/// steps. Question: a marked question or a prediction of this step is open for somebody at this step. Who has
/// begun nothing counts as at the first step. `waiting` becomes the number of such students.
SceneHidden sceneAnswers(const ClassRoom& room, const ScenePlace& place, double now_s, std::size_t& waiting);

class SharedScene {
 public:
  static constexpr double kAskFor_s = 60.0;        ///< a question without an answer lapses
  static constexpr double kFreshFor_s = 5.0;       ///< an older picture is not shown
  static constexpr RateLimit kPictures{4.0, 3.0};  ///< of the student's page

  enum class State : std::uint8_t { None, Asked, Agreed };

  /// Whether this student can be asked now: nobody else is, and the student is here, at a step, and has not said no there.
  bool mayAsk(const ClassRoom& room, std::size_t student, double now_s) const;
  bool ask(const ClassRoom& room, std::size_t student, double now_s);

  /// The student's answer, to the question of this number. False: it is not open any more.
  bool answer(std::size_t student, std::uint64_t number, bool yes, bool named, const ScenePlace& at);
  /// The student takes it back. False: there is nothing to take back.
  bool withdraw(std::size_t student, std::uint64_t number);
  /// The teacher takes it back. False if there is nothing.
  bool takeOff();

  enum class Taken : std::uint8_t { Yes, TooOften, Over };
  /// A picture of the student's page, taken at this place; empty: the page shows nothing now. A picture of
  /// another place ends the showing.
  Taken take(std::size_t student, std::uint64_t number, const ScenePlace& at, std::string picture, double now_s);

  /// Ends what is over: the class or the step has ended, the student is away, the question has lapsed.
  void follow(const ClassRoom& room, double now_s);
  /// Why there is no picture now; only while somebody has agreed, after follow().
  SceneHidden hidden(const ClassRoom& room, double now_s, std::size_t& waiting) const;

  State state() const { return state_; }
  std::size_t student() const { return student_; }
  bool named() const { return named_; }
  std::uint64_t number() const { return number_; }  ///< of the question, from 1
  std::uint64_t pictures() const { return pictures_; }
  const std::string& picture() const { return picture_; }
  const ScenePlace& place() const { return place_; }
  bool declined(const ClassRoom& room, std::size_t student) const;

 private:
  void end();

  State state_ = State::None;
  std::size_t student_ = 0;
  std::uint64_t number_ = 0, pictures_ = 0;
  bool named_ = false;
  bool known_ = false;  // the student's lines have confirmed the place
  double asked_s_ = 0.0, picture_s_ = kNotSeen_s;
  ScenePlace place_;
  std::string picture_;
  RateBucket rate_;
  std::map<std::size_t, ScenePlace> declined_;
};

}  // namespace moltact
