// OpenMM's pool of threads for a page, which has none: one task at a time, carried out by the caller. It replaces
// openmmapi/src/ThreadPool.cpp, which starts threads and asks an x86 processor for its features. Tasks that wait for each
// other (syncThreads) are only in the platform CPU, which a page does not have.
#include <stdexcept>

#include "openmm/internal/ThreadPool.h"

namespace OpenMM {

class ThreadPool::ThreadData {};

ThreadPool::ThreadPool(int) : isDeleted(false), numThreads(1), waitCount(0), currentTask(nullptr) {}
ThreadPool::~ThreadPool() = default;

int ThreadPool::getNumThreads() const { return numThreads; }
void ThreadPool::execute(Task& task) { task.execute(*this, 0); }
void ThreadPool::execute(std::function<void(ThreadPool&, int)> task) { task(*this, 0); }
void ThreadPool::syncThreads() { throw std::logic_error("a pool without threads cannot synchronise them"); }
void ThreadPool::waitForThreads() {}
void ThreadPool::resumeThreads() {}

}  // namespace OpenMM
