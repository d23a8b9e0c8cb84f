#pragma once

#include <CL/cl.h>

#include <utility>

namespace prizma {

/// Owns one reference to an OpenCL object.
template <class T, cl_int (*release)(T)>
class ClHandle {
  public:
    ClHandle() = default;
    explicit ClHandle(T object) : object_(object) {}
    ClHandle(ClHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    ClHandle& operator=(ClHandle&& other) noexcept {
        std::swap(object_, other.object_);
        return *this;
    }
    ~ClHandle() {
        if (object_)
            release(object_);
    }

    T get() const { return object_; }
    explicit operator bool() const { return object_ != nullptr; }

  private:
    T object_ = nullptr;
};

using ClContext = ClHandle<cl_context, clReleaseContext>;
using ClQueue = ClHandle<cl_command_queue, clReleaseCommandQueue>;
using ClProgram = ClHandle<cl_program, clReleaseProgram>;
using ClKernel = ClHandle<cl_kernel, clReleaseKernel>;
using ClMemory = ClHandle<cl_mem, clReleaseMemObject>;
using ClEvent = ClHandle<cl_event, clReleaseEvent>;

} // namespace prizma
