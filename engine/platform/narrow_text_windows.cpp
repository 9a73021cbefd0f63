// Text in `char` is UTF-8 in this program, but std::filesystem::path converts it by the C library's locale, which does
// not support UTF-8 (msvcrt). These conversions replace those of the C++ library with the same names: the linker uses
// the first definition.
#include <codecvt>
#include <locale>

namespace {

const std::codecvt_utf8_utf16<wchar_t>& utf8() {
  static const std::codecvt_utf8_utf16<wchar_t> conversion(1);  // 1: not owned by a locale
  return conversion;
}

}  // namespace

namespace std {

using Utf16 = codecvt<wchar_t, char, mbstate_t>;

codecvt_base::result Utf16::do_out(mbstate_t& state, const wchar_t* from, const wchar_t* end, const wchar_t*& next,
                                   char* to, char* to_end, char*& to_next) const {
  return utf8().out(state, from, end, next, to, to_end, to_next);
}

codecvt_base::result Utf16::do_in(mbstate_t& state, const char* from, const char* end, const char*& next, wchar_t* to,
                                  wchar_t* to_end, wchar_t*& to_next) const {
  return utf8().in(state, from, end, next, to, to_end, to_next);
}

int Utf16::do_encoding() const throw() { return utf8().encoding(); }
int Utf16::do_length(mbstate_t& state, const char* from, const char* end, size_t max) const {
  return utf8().length(state, from, end, max);
}
int Utf16::do_max_length() const throw() { return utf8().max_length(); }

}  // namespace std
