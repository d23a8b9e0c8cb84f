#pragma once

#include "core/compute/buffer.h"
#include "core/compute/cl_error.h"
#include "core/compute/cl_handle.h"
#include "core/compute/context.h"

#include <string>
#include <type_traits>

namespace prizma {

/// One kernel of a built program.
class Kernel {
  public:
    Kernel() = default;

    static Result<Kernel> create(const ClProgram& program, const std::string& name);

    /// Sets all arguments in order: buffers, or plain values of the very size the kernel declares.
    template <class... Arguments>
    void setArguments(const Arguments&... arguments) {
        next_ = 0;
        code_ = CL_SUCCESS;
        (addArgument(arguments), ...);
    }

    /// Continues after the last set argument.
    template <class T>
    void addArgument(const Buffer<T>& buffer) {
        const cl_mem memory = buffer.get();
        addRaw(sizeof(memory), &memory);
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void addArgument(const T& value) { addRaw(sizeof(value), &value); }

    /// Queues `global` work items in groups of `local`; `global` is rounded up, so kernels check their index.
    /// Does not wait. The event is for timing.
    Result<ClEvent> launch(Context& context, std::size_t global, std::size_t local);

  private:
    void addRaw(std::size_t size, const void* value);

    ClKernel kernel_;
    std::string name_;
    cl_uint next_ = 0;
    cl_int code_ = CL_SUCCESS;
};

/// Milliseconds the device spent on a finished command.
double milliseconds(const ClEvent& event);

} // namespace prizma
