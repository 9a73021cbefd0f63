// Counts the allocations of the calling thread; every_method_test.cpp replaces the program's operator new.
#pragma once

namespace moltact::test {

long allocations();

}  // namespace moltact::test
