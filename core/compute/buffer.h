#pragma once

#include "core/compute/cl_error.h"
#include "core/compute/context.h"
#include "core/compute/memory.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace prizma {

/// Device memory for items of type T. Grows, never shrinks; holds room for one item at least, so that it can
/// always be passed to a kernel.
template <class T>
class Buffer {
  public:
    Buffer() = default;
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Buffer() {
        if (context_)
            context_->countAllocation(-static_cast<std::int64_t>(capacity_ * sizeof(T)));
    }

    cl_mem get() const { return memory_.get(); }
    std::size_t capacity() const { return capacity_; } ///< In items.

    /// Room for `count` items; what the first `kept` held survives. `what` names the content in error
    /// messages.
    Result<void> reserve(Context& context, std::size_t count, const std::string& what, std::size_t kept = 0) {
        count = std::max<std::size_t>(count, 1);
        if (memory_ && capacity_ >= count)
            return {};
        cl_int code = CL_SUCCESS;
        ClMemory larger = createMemory(context, count * sizeof(T), code);
        if (code == CL_SUCCESS && memory_ && kept > 0)
            code = clEnqueueCopyBuffer(context.queue(), memory_.get(), larger.get(), 0, 0, kept * sizeof(T),
                                       0, nullptr, nullptr);
        if (auto ok = checkCl(code, "make room for the " + what); !ok)
            return ok;
        context_ = &context;
        context.countAllocation(static_cast<std::int64_t>((count - capacity_) * sizeof(T)));
        memory_ = std::move(larger);
        capacity_ = count;
        return {};
    }

    /// Copies `items` to place `first`; there must be room. Returns when `items` may be changed again.
    Result<void> write(Context& context, std::span<const T> items, std::size_t first,
                       const std::string& what) {
        if (items.empty())
            return {};
        return checkCl(clEnqueueWriteBuffer(context.queue(), memory_.get(), CL_TRUE, first * sizeof(T),
                                            items.size_bytes(), items.data(), 0, nullptr, nullptr),
                       "upload the " + what);
    }

    /// Makes room and copies `items` to the start.
    Result<void> assign(Context& context, std::span<const T> items, const std::string& what) {
        if (auto ok = reserve(context, items.size(), what); !ok)
            return ok;
        return write(context, items, 0, what);
    }

    /// Waits for the device, then copies from place `first` into `items`.
    Result<void> read(Context& context, std::span<T> items, std::size_t first,
                      const std::string& what) const {
        if (items.empty())
            return {};
        return checkCl(clEnqueueReadBuffer(context.queue(), memory_.get(), CL_TRUE, first * sizeof(T),
                                           items.size_bytes(), items.data(), 0, nullptr, nullptr),
                       "read the " + what);
    }

  private:
    void swap(Buffer& other) noexcept {
        std::swap(context_, other.context_);
        std::swap(memory_, other.memory_);
        std::swap(capacity_, other.capacity_);
    }

    Context* context_ = nullptr;
    ClMemory memory_;
    std::size_t capacity_ = 0;
};

} // namespace prizma
