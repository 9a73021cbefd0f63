// A library that cannot be loaded because a dependency is missing.
extern "C" int absentFunction();
extern "C" int neededFunction() { return absentFunction(); }
