// Answers the requests of a live class: which page or act a request asks for, and whether it may. Knows HTTP's words but
// no socket; class_server.cpp gives it what a connection brought. Many threads may call at once.
//
// Addresses: /CODE/ and below for students and the projector (/CODE/board), /teacher/TOKEN/ and below for the teacher, who
// must sit at this computer. No part of a request becomes part of
// a file's name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/classroom/class_room.h"
#include "engine/classroom/class_store.h"
#include "engine/classroom/class_view.h"
#include "engine/classroom/rate_limit.h"
#include "engine/classroom/shared_scene.h"

namespace moltact {

struct ClassRequest {
  std::string method;                                  ///< "GET" or "POST"
  std::string path;                                    ///< without the query
  std::string host, origin, content_type, fetch_site;  ///< headers; empty: not sent
  std::string if_none_match;
  std::string remote;  ///< the other computer's address
  std::string body;
  double now_s = 0.0;
};

struct ClassReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const std::string> whole;  ///< the body, if it is one of the large ones
  bool events = false;                       ///< the teacher's page listens: send liveParts() as they change
};

/// A lesson that the page fetches and opens.
struct ServedLesson {
  std::string id, title;
  std::shared_ptr<const std::string> pack;
};

struct ClassSite {
  std::string page;                   ///< the text of the browser edition
  std::vector<ServedLesson> lessons;  ///< empty: the page shows those that it contains
  std::vector<std::string> hosts;     ///< accepted in the header Host: "127.0.0.1:8230"
  std::string address;                ///< for students, complete
  bool shared = false;
  /// Random bytes, for the tokens of students.
  std::function<std::string(std::size_t)> random;
};

/// Longer bodies are refused (unit: byte).
inline constexpr std::size_t kMaxClassBody = std::size_t{1} << 20;
inline constexpr std::size_t kMaxClassPath = 200;
/// Longer bodies that answer for a scene, or bring a picture of it, are refused (unit: byte).
inline constexpr std::size_t kMaxSceneBody = std::size_t{72} << 10;

class ClassRequests {
 public:
  /// `store` must outlive this. Returns a Problem if the page is no browser edition.
  static Expected<std::unique_ptr<ClassRequests>> make(ClassSite site, ClassRoom room, ClassStore& store);

  /// Answers after what the answer acknowledges is on the disk.
  ClassReply answer(const ClassRequest& request);
  /// Whether a request may be answered at all, by its headers: the place is known and no other site sent it. A reply if not.
  std::optional<ClassReply> refused(const ClassRequest& request);

  /// The parts of the teacher's page that change, as JSON {"id": "HTML", …}.
  std::string liveParts(double now_s) const;
  /// What the teacher's page shows, for a page that is not in a browser.
  ClassView shownView(double now_s) const;
  /// Does what the teacher's page asks for by a body of /steer, which a page in the program makes. False if it was refused.
  bool steerHere(std::string body, double now_s);
  bool ended() const;
  std::size_t students() const;
  /// Writes all attempts and the report (report.html in the class's folder); returns its HTML, empty if nobody has begun a
  /// lesson. Blocks.
  Expected<std::string> writeReport();
  std::filesystem::path reportFile() const { return store_.folder() / "report.html"; }

 private:
  ClassRequests(ClassSite site, ClassRoom room, ClassStore& store)
      : site_(std::move(site)), store_(store), room_(std::move(room)) {}
  ClassReply studentAnswer(std::string_view path, const ClassRequest& request);
  ClassReply teacherAnswer(std::string_view path, const ClassRequest& request);
  ClassReply join(const ClassRequest& request);
  ClassReply takeLines(const ClassRequest& request);
  ClassReply steer(const ClassRequest& request);
  ClassReply takeScene(const ClassRequest& request);
  ClassReply giveScene(const ClassRequest& request);
  ClassReply board(const ClassRequest& request);
  ClassView view(double now_s) const;
  bool steerScene(const std::string& act, std::size_t student, double now_s);
  std::string show(const ShownPlot& plot);
  std::string hide();

  ClassSite site_;
  ClassStore& store_;
  mutable std::mutex lock_;  // of all below
  ClassRoom room_;
  std::vector<RateBucket> student_rates_;
  RateByAddress joins_{{double(kMaxStudents), 1.0}}, guesses_{{20.0, 0.2}};
  mutable SharedScene scene_;  // a view of the class ends what is over
  RateBucket scene_looks_;     // of other computers than this one
  std::shared_ptr<const std::string> page_;
  std::string page_tag_;
  // As it was when the teacher showed it, or when the server began: otherwise the room would see the prediction of each
  // student who is late.
  BoardPlot board_plot_;
  std::string board_;  // the projector's page, made at board_at_s_
  double board_at_s_ = 0.0;
  bool board_scene_ = false;  // it is that of a student's scene
};

}  // namespace moltact
