#include <windows.h>

#include <streambuf>

#include "engine/platform/terminal.h"

namespace moltact {
namespace {

// Cleans on its way to the system. A code point that is not whole yet waits for the rest of it.
class CleanBuffer : public std::streambuf {
 public:
  explicit CleanBuffer(DWORD which) : handle_(GetStdHandle(which)) {
    DWORD mode = 0;
    terminal_ = GetConsoleMode(handle_, &mode) != 0;
    if (terminal_) SetConsoleOutputCP(CP_UTF8);
  }
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
      DWORD written = 0;
      if (!WriteFile(handle_, bytes.data(), DWORD(bytes.size()), &written, nullptr) || written == 0) {
        failed_ = true;
        return false;
      }
      bytes.remove_prefix(written);
    }
    return true;
  }

  bool failed() const { return failed_; }
  bool terminal() const { return terminal_; }

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
  bool full() { return waiting_.size() < kMost || send(false); }

  static constexpr std::size_t kMost = 1 << 14;
  HANDLE handle_;
  std::string waiting_;
  bool failed_ = false, terminal_ = false;
};

struct Streams {
  CleanBuffer out_buffer{STD_OUTPUT_HANDLE}, err_buffer{STD_ERROR_HANDLE};
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
  streams().err_buffer.raw("\r" + oneLine(line) + "\033[K");
}

bool standardErrorIsTerminal() { return streams().err_buffer.terminal(); }

Typed typedLine(std::string& line, int wait_ms) {
  static std::string typed;  // what came after the last line
  std::size_t end = typed.find('\n');
  if (end == std::string::npos) {
    HANDLE const input = GetStdHandle(STD_INPUT_HANDLE);
    if (WaitForSingleObject(input, DWORD(wait_ms)) != WAIT_OBJECT_0) return Typed::Nothing;
    char some[256];
    DWORD size = 0;
    if (!ReadFile(input, some, sizeof some, &size, nullptr) || size == 0) return Typed::End;
    for (const char c : std::string_view(some, size))
      if (c != '\r') typed += c;
    end = typed.find('\n');
    if (end == std::string::npos) return Typed::Nothing;
  }
  line = typed.substr(0, end);
  typed.erase(0, end + 1);
  return Typed::Line;
}

}  // namespace moltact
