#include "engine/results/attempt_log.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "engine/results/attempt_lines.h"

namespace moltact {
namespace {

// "first-touch-20261121-105814": the lesson and its start, in characters that every file system accepts.
std::string fileName(const AttemptHeader& header) {
  std::string out;
  for (const char c : std::filesystem::path(header.lesson.file).stem().string())
    out += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '-';
  if (out.size() > 60) out.resize(60);
  out += '-';
  for (const char c : header.began) {
    if (c == 'T')
      out += '-';
    else if (std::isdigit(static_cast<unsigned char>(c)))
      out += c;
  }
  return out;
}

// Shifts an event's time, and every time within it.
void moveBy(double s, AttemptEvent& event) {
  event.t_s += s;
  if (auto* touch = std::get_if<TouchEnded>(&event.what)) touch->from_s += s;
  if (auto* touch = std::get_if<TouchSoFar>(&event.what)) touch->from_s += s;
  if (auto* chunk = std::get_if<HipChunk>(&event.what))
    for (HipSample& sample : chunk->samples) sample.t_s += s;
}

bool isDeed(const AttemptFact& fact) {
  return std::holds_alternative<TouchBegan>(fact) || std::holds_alternative<Answered>(fact) ||
         std::holds_alternative<HintOpened>(fact) || std::holds_alternative<TaskDone>(fact) ||
         std::holds_alternative<Predicted>(fact);
}

}  // namespace

AttemptLog::AttemptLog(std::filesystem::path folder, AttemptHeader header)
    : folder_(std::move(folder)), name_(fileName(header)), before_(lineOf(header)) {}

AttemptLog::AttemptLog(std::filesystem::path file, double end_s, const Resumed& resumed)
    : from_s_(end_s), written_s_(end_s), writer_(AttemptWriter::resume(std::move(file))) {
  write(lineOf(AttemptEvent{from_s_, resumed}));
}

void AttemptLog::write(std::string line) {
  since_progress_ += line.size();
  writer_->append(std::move(line));
}

void AttemptLog::heartbeat(double t_s) {
  if (writer_ && t_s + from_s_ - written_s_ >= kHeartbeat_s) add({t_s, Heartbeat{}});
}

void AttemptLog::add(AttemptEvent event) {
  if (!writer_ && folder_.empty()) return;
  moveBy(from_s_, event);
  if (!std::holds_alternative<HipChunk>(event.what) && !std::holds_alternative<ViewChanged>(event.what))
    written_s_ = std::max(written_s_, event.t_s);
  const bool step = std::holds_alternative<StepEntered>(event.what),
             gone_on = step && before_.find(R"({"kind":"step")") != std::string::npos;  // of lines written by this
                                                                                        // program
  if (!writer_ && (gone_on || isDeed(event.what))) {
    writer_.emplace(AttemptWriter::startNew(folder_, name_));
    write(std::exchange(before_, {}));
  }
  std::string line = lineOf(event);
  if (!writer_) {
    // Without an action, HIP samples must not fill the memory.
    if (before_.size() < kProgressEvery || !std::holds_alternative<HipChunk>(event.what)) before_ += line;
    return;
  }
  write(std::move(line));
  if (std::holds_alternative<ProgressMade>(event.what)) {
    since_progress_ = 0;
    progress_ = std::move(event);
  } else if (progress_ && since_progress_ > kProgressEvery) {
    progress_->t_s = event.t_s;
    write(lineOf(*progress_));
    since_progress_ = 0;
  }
}

}  // namespace moltact
