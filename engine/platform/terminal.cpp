// The part of terminal.h common to all systems with a terminal.
#include "engine/platform/terminal.h"

#include <streambuf>

#include "engine/platform/terminal_calls.h"

namespace moltact {
namespace {

// Cleans text before it is passed to the system. An incomplete code point waits for the rest of it.
class CleanBuffer : public std::streambuf {
 public:
  explicit CleanBuffer(platform::Output to) : to_(to) { platform::prepare(to); }
  ~CleanBuffer() override { send(true); }

  bool send(bool all) {
    std::size_t whole = waiting_.size();
    for (std::size_t back = 1; !all && back <= 3 && back <= waiting_.size(); ++back)
      if (firstCodePoint(std::string_view(waiting_).substr(waiting_.size() - back)).cut) whole = waiting_.size() - back;
    const std::string clean = printable(std::string_view(waiting_).substr(0, whole));
    waiting_.erase(0, whole);
    return raw(clean);
  }

  bool raw(std::string_view bytes) {
    while (!bytes.empty()) {
      const std::size_t written = platform::writeSome(to_, bytes);
      if (written == 0) {
        failed_ = true;
        return false;
      }
      bytes.remove_prefix(written);
    }
    return true;
  }

  bool failed() const { return failed_; }

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    waiting_ += traits_type::to_char_type(c);
    return full() ? c : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    waiting_.append(text, std::size_t(size));
    return full() ? size : 0;
  }
  int sync() override { return send(false) ? 0 : -1; }

 private:
  bool full() { return waiting_.size() < kMax || send(false); }

  static constexpr std::size_t kMax = 1 << 14;
  platform::Output to_;
  std::string waiting_;
  bool failed_ = false;
};

struct Streams {
  CleanBuffer out_buffer{platform::Output::Standard}, err_buffer{platform::Output::Error};
  std::ostream out{&out_buffer}, err{&err_buffer};
  Streams() {
    err.tie(&out);
    err << std::unitbuf;
  }
};

Streams& streams() {
  static Streams both;
  return both;
}

}  // namespace

std::ostream& cleanOut() { return streams().out; }
std::ostream& cleanErr() { return streams().err; }
TerminalText out() { return TerminalText(cleanOut()); }
TerminalText err() { return TerminalText(cleanErr()); }

bool terminalWritten() {
  streams().err_buffer.send(true);
  return streams().out_buffer.send(true) && !streams().out_buffer.failed();
}

void showStatus(std::string_view line) {
  if (!standardErrorIsTerminal()) return;
  cleanErr().flush();
  streams().err_buffer.raw("\r\033[K" + oneLine(line));
}

bool standardErrorIsTerminal() { return platform::isTerminal(platform::Output::Error); }

Typed typedLine(std::string& line, int wait_ms) {
  static std::string typed;  // input after the last line
  std::size_t end = typed.find('\n');
  if (end == std::string::npos) {
    if (const Typed came = platform::readSome(typed, wait_ms); came != Typed::Line) return came;
    end = typed.find('\n');
    if (end == std::string::npos) return Typed::Nothing;
  }
  line = typed.substr(0, end);
  typed.erase(0, end + 1);
  return Typed::Line;
}

}  // namespace moltact
