#include "tests/results/synthetic_class.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/lesson/reader.h"
#include "engine/results/attempt_log.h"

namespace moltact {
namespace {

class Student {
 public:
  Student(unsigned seed, InputKind way) : random_(seed), way_(way) {
    skill_ = std::clamp(std::normal_distribution<double>(0.62, 0.15)(random_), 0.2, 0.95);
    pace_ = std::exp(std::normal_distribution<double>(0.0, 0.25)(random_));
    press_N_ = (way == InputKind::Device  ? 0.9
                : way == InputKind::Mouse ? 1.3
                                          : 1.1) *
               std::exp(std::normal_distribution<double>(0.0, 0.2)(random_));
  }

  // Works through a lesson up to `share` of its steps.
  void work(AttemptLog& log, const Lesson& lesson, double share) {
    log.add({0.0, InputChanged{way_, way_ == InputKind::Device ? "Phantom Omni" : "Mouse", way_ == InputKind::Device}});
    const auto steps = static_cast<std::size_t>(std::ceil(share * double(lesson.steps.size())));
    for (std::size_t s = 0; s < steps; ++s) {
      const Step& step = lesson.steps[s];
      log.add({t_, StepEntered{step.id}});
      read();
      if (chance(0.2 * (1.2 - skill_))) log.add({t_, HintOpened{step.id}});
      for (std::size_t k = 0; k < step.tasks.size(); ++k) task(log, step, k);
      for (const Question& q : step.questions) answer(log, step, q);
      progress(log, lesson, s);
    }
    log.add({t_, SessionClosed{"2026-11-20T09:00:00Z"}});
  }

 private:
  bool chance(double p) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < p; }
  double around(double middle, double spread = 0.35) {
    return middle * std::exp(std::normal_distribution<double>(0.0, spread)(random_));
  }
  void read() { t_ += pace_ * around(28.0); }

  void task(AttemptLog& log, const Step& step, std::size_t index) {
    log.add({t_, TaskBegun{step.id, index}});
    const double begun = t_;
    t_ += pace_ * around(4.0);
    double touch_s = 0.0, path_A = 0.0, peak_N = 0.0;
    const int touches = 1 + int(random_() % 4);
    for (int k = 0; k < touches; ++k) {
      const double from = t_, lasts = around(3.0), peak = std::min(3.3, around(press_N_, 0.3)),
                   path = around(way_ == InputKind::Device ? 14.0 : 9.0, 0.5);
      log.add({from, TouchBegan{{std::int32_t(random_() % 50)}}});
      HipChunk chunk;
      for (int i = 0; i < 20; ++i) {
        HipSample sample;
        sample.t_s = from + 0.02 * i;
        sample.hip.A = sample.scp.A = {0.3 * i, std::sin(0.3 * i), 5.0};
        chunk.samples.push_back(sample);
      }
      log.add({from + 0.4, chunk});
      t_ += lasts;
      log.add({t_, TouchEnded{from, {1, 2}, random_() % 5, peak, 0.55 * peak, path, way_}});
      t_ += around(0.8);
      touch_s += lasts;
      path_A += path;
      peak_N = std::max(peak_N, peak);
    }
    log.add({t_, TaskDone{step.id,
                          index,
                          t_ - begun,
                          way_,
                          {{"time", t_ - begun, "s"},
                           {"contact time", touch_s, "s"},
                           {"mean force", 0.55 * peak_N, "N"},
                           {"greatest force", peak_N, "N"},
                           {"way", path_A, "Å"}}}});
    ++done_;
  }

  void answer(AttemptLog& log, const Step& step, const Question& q) {
    const InputKind by = way_ == InputKind::Keyboard ? way_ : InputKind::Mouse;
    t_ += pace_ * around(9.0);
    if (q.choices.empty()) {
      const bool number = q.answer && q.answer->kind == AnswerSpec::Kind::Number;
      log.add({t_, Answered{step.id,
                            q.id,
                            1,
                            {},
                            number ? std::to_string(q.answer->number).substr(0, 4) + " " + q.answer->unit
                                   : "the crease is a line, the pit a point",
                            true,
                            by}});
      ++done_;
      return;
    }
    std::vector<std::size_t> right;
    for (std::size_t c = 0; c < q.choices.size(); ++c)
      if (q.choices[c].right) right.push_back(c);
    int tries = 1;
    while (!chance(skill_) && tries < 4) {
      std::size_t wrong = random_() % q.choices.size();
      if (right.size() == 1 && wrong == right[0]) wrong = (wrong + 1) % q.choices.size();
      log.add({t_, Answered{step.id, q.id, tries++, {wrong}, "", false, by}});
      t_ += pace_ * around(6.0);
    }
    log.add({t_, Answered{step.id, q.id, tries, right, "", true, by}});
    ++done_;
  }

  void progress(AttemptLog& log, const Lesson& lesson, std::size_t step) {
    std::size_t of = 0;
    for (const Step& s : lesson.steps) of += s.tasks.size() + s.questions.size();
    log.add({t_, ProgressMade{lesson.steps[step].id, done_, of}});
  }

  std::mt19937 random_;
  InputKind way_;
  double skill_ = 0.6, pace_ = 1.0, press_N_ = 1.0, t_ = 0.0;
  std::size_t done_ = 0;
};

}  // namespace

void writeSyntheticClass(const std::filesystem::path& folder, unsigned seed) {
  const std::filesystem::path lessons = MOLTACT_SOURCE_DIR "/lessons";
  int written = 0;
  const auto attempt = [&](int student, const char* lesson_file, double share) {
    const LessonReading reading = readLesson(lessons / lesson_file);
    const Lesson& lesson = *reading.lesson;
    const InputKind way = student % 3 == 0   ? InputKind::Device
                          : student % 6 == 1 ? InputKind::Keyboard
                                             : InputKind::Mouse;
    AttemptHeader header;
    header.program = "0.1.0";
    char text[40];
    std::snprintf(text, sizeof text, "2026-11-20T%02d:%02d:00Z", 8 + written / 12, 5 * (written % 12));
    header.began = text;
    std::snprintf(text, sizeof text, "9b-%02d", student + 1);
    if (student < 16) header.student = text;
    header.device = way == InputKind::Device ? "Phantom Omni" : "Mouse";
    header.gives_force = way == InputKind::Device;
    header.lesson = outlineOf(lesson, "5eed5eed5eed5eed");
    AttemptLog log(folder, header);
    Student(seed + unsigned(written), way).work(log, lesson, share);
    log.add(
        {1e-3, Predicted{student % 2 ? "9b-02" : "9b-04", lesson.steps.front().id, "What will the next student feel?",
                         student % 2 ? "A bump, then a groove" : "Nothing: it is smooth"}});
    log.flush();
    ++written;
  };
  for (int student = 0; student < 18; ++student)
    attempt(student, "first-touch.md", student == 4 ? 0.4 : student == 11 ? 0.7 : 1.0);
  for (const int student : {0, 1, 2, 5, 7}) attempt(student, "how-touch-is-computed.md", student == 2 ? 0.5 : 1.0);
  attempt(4, "first-touch.md", 0.9);
}

}  // namespace moltact
