// A library on which needy_library.cpp depends and which the loader does not find.
extern "C" int absentFunction() { return 1; }
