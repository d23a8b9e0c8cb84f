#include "core/compute/memory.h"

#include <cstdlib>
#include <memory>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace prizma {
namespace {

struct Free {
    void operator()(void* memory) const noexcept { std::free(memory); }
};
using HostMemory = std::unique_ptr<void, Free>;

/// Null if it is too little to be worth it, or if there is none.
HostMemory allocateLargePages([[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t pageSize = std::size_t{2} << 20;
    if (bytes < pageSize)
        return nullptr;
    const std::size_t rounded = (bytes + pageSize - 1) / pageSize * pageSize;
    HostMemory memory(std::aligned_alloc(pageSize, rounded));
    if (memory)
        madvise(memory.get(), rounded, MADV_HUGEPAGE); // only a hint
    return memory;
#else
    return nullptr;
#endif
}

void CL_CALLBACK freePages(cl_mem, void* pages) {
    std::free(pages);
}

} // namespace

ClMemory createMemory(Context& context, std::size_t bytes, cl_int& code) {
    bytes += 16; // kernels may load the last three floats as four
    HostMemory pages = context.info().type == DeviceType::Cpu ? allocateLargePages(bytes) : nullptr;
    if (pages) {
        ClMemory memory(clCreateBuffer(context.context(), CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes,
                                       pages.get(), &code));
        // Commands that are still queued keep the buffer, and so its pages, alive.
        if (code == CL_SUCCESS)
            code = clSetMemObjectDestructorCallback(memory.get(), freePages, pages.get());
        if (code == CL_SUCCESS) {
            pages.release();
            return memory;
        }
    }
    return ClMemory(clCreateBuffer(context.context(), CL_MEM_READ_WRITE, bytes, nullptr, &code));
}

} // namespace prizma
