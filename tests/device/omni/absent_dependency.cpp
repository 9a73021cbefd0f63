// A library that needy_library.cpp needs and does not find, for nothing says where it is.
extern "C" int absentFunction() { return 1; }
