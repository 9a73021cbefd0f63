// A library that cannot be loaded because of another that it needs.
extern "C" int absentFunction();
extern "C" int neededFunction() { return absentFunction(); }
