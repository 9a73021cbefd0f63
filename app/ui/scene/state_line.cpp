#include "app/ui/scene/state_line.h"

#include <cmath>

namespace moltact {

bool StateLine::update(const std::string& what, const std::string& line, double force_N, double now_s) {
  if (what != candidate_) {
    candidate_ = what;
    candidate_s_ = now_s;
  }
  const bool other = what != reported_, force_changed = std::abs(force_N - shown_N_) >= pace_.step_N;
  if (!text_.empty()) {
    if (!other && !force_changed) return false;
    if (now_s - shown_s_ < pace_.pace_s || now_s - candidate_s_ < pace_.rest_s) return false;
  }
  reported_ = what;
  shown_N_ = force_N;
  shown_s_ = now_s;
  if (line == text_) return false;
  text_ = line;
  return true;
}

}  // namespace moltact
