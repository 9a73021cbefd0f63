#include <process.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/run_program.h"

namespace moltact {
namespace {

// The C library joins arguments by blanks: each is quoted as the called program's C library reads it back.
std::wstring quoted(const std::wstring& word) {
  std::wstring out = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') out.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    out += c;
  }
  out.append(backslashes, L'\\');
  return out + L'"';
}

}  // namespace

Expected<int> becomeProgram(const std::vector<std::string>& words) {
  std::vector<std::wstring> wide;
  for (const std::string& word : words)
    wide.push_back(quoted(std::filesystem::path(std::u8string(word.begin(), word.end())).wstring()));
  std::vector<const wchar_t*> arguments;
  for (const std::wstring& word : wide) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  const std::string program = words.empty() ? std::string() : words[0];
  const std::intptr_t status =
      _wspawnv(_P_WAIT, std::filesystem::path(std::u8string(program.begin(), program.end())).c_str(), arguments.data());
  if (status == -1)
    return Problem{program, 0, 0, trf("it cannot be started ({0})", std::generic_category().message(errno)), {}};
  return int(status);
}

}  // namespace moltact
