#include "core/compute/worker_affinity.h"

#ifdef __linux__
#include <cstdlib>

#include <sched.h>
#include <unistd.h>
#endif

namespace prizma {

void keepDeviceWorkersApart() {
#ifdef __linux__
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (processors > CPU_SETSIZE || sched_getaffinity(0, sizeof allowed, &allowed) != 0)
        return;
    for (int i = 0; i < processors; ++i)
        if (!CPU_ISSET(i, &allowed))
            return;
    constexpr int keepUsers = 0;
    setenv("POCL_AFFINITY", "1", keepUsers);
#endif
}

} // namespace prizma
