// compare: touch with each of several haptic methods for a while, in any order.
#include <algorithm>

#include "engine/haptics/methods.h"
#include "engine/lesson/tasks/kinds.h"

namespace moltact {
namespace {

std::vector<std::string_view> methodNames() {
  std::vector<std::string_view> names;
  for (const Method& m : methods()) names.push_back(m.name);
  return names;
}

class Compare : public Task {
 public:
  explicit Compare(const TaskSpec& spec) : Task(spec), time_s_(spec.values["for"].number) {
    for (const std::string& name : spec.values["compare"].words)
      if (std::none_of(parts_.begin(), parts_.end(), [&](const Part& p) { return p.method == name; })) parts_.push_back({name, 0.0});
  }

  void reset() override {
    Task::reset();
    for (Part& p : parts_) p.felt_s = 0.0;
    in_use_ = nullptr;
    touching_ = false;
  }

 private:
  struct Part {
    std::string method;
    double felt_s = 0.0;
  };

  void take(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    in_use_ = nullptr;
    double sum_s = 0.0;
    bool all = true;
    for (Part& p : parts_) {
      if (p.method == s.method) {
        in_use_ = &p;
        if (touching_) p.felt_s = std::min(time_s_, p.felt_s + dt_s);
      }
      sum_s += p.felt_s;
      all = all && p.felt_s >= time_s_;
    }
    setProgress(sum_s / (time_s_ * double(parts_.size())));
    if (all) finish();
  }

  std::string guidance() const override {
    if (in_use_ && in_use_->felt_s < time_s_) {
      const std::string with = methodTitle(in_use_->method);
      return touching_ ? "Keep touching with " + with + ": " + timeText(in_use_->felt_s) + " of " + timeText(time_s_) + "."
                       : "Touch the surface with " + with + ".";
    }
    for (const Part& p : parts_)
      if (p.felt_s < time_s_) return "Now choose " + methodTitle(p.method) + " in the panel Methods.";
    return {};
  }

  std::vector<Part> parts_;
  double time_s_ = 1.0;
  const Part* in_use_ = nullptr;
  bool touching_ = false;
};

}  // namespace

TaskKind compareKind() {
  return {"compare", "Touch with each of several haptic methods; the student switches between them.",
          {{.name = "compare", .type = ValueType::WordList, .meaning = "The methods, in any order.", .required = true, .words = methodNames()},
           {.name = "for", .type = ValueType::Quantity, .meaning = "How long to touch with each.", .fallback = "2 s",
            .dimension = Dimension::Time, .least = 0.1, .most = 600.0}},
          [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Compare>(s); }};
}

}  // namespace moltact
