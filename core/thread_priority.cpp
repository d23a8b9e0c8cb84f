#include "core/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace prizma {

void lowerThreadPriority() {
#ifdef __linux__
    // On Linux niceness belongs to the thread and is inherited by the threads it makes (PoCL's and TBB's
    // workers).
    constexpr int niceness = 5;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
#endif
}

} // namespace prizma
