#include "core/compute/kernel.h"

namespace prizma {

Result<Kernel> Kernel::create(const ClProgram& program, const std::string& name) {
    cl_int code = CL_SUCCESS;
    Kernel made;
    made.kernel_ = ClKernel(clCreateKernel(program.get(), name.c_str(), &code));
    made.name_ = name;
    if (auto ok = checkCl(code, "find the kernel " + name); !ok)
        return std::unexpected(ok.error());
    return made;
}

void Kernel::addRaw(std::size_t size, const void* value) {
    const cl_int code = clSetKernelArg(kernel_.get(), next_++, size, value);
    if (code_ == CL_SUCCESS)
        code_ = code;
}

Result<ClEvent> Kernel::launch(Context& context, std::size_t global, std::size_t local) {
    cl_event event = nullptr;
    cl_int code = code_;
    if (code == CL_SUCCESS && global > 0) {
        const std::size_t rounded = (global + local - 1) / local * local;
        code = clEnqueueNDRangeKernel(context.queue(), kernel_.get(), 1, nullptr, &rounded, &local, 0,
                                      nullptr, &event);
    }
    if (auto ok = checkCl(code, "run the kernel " + name_); !ok)
        return std::unexpected(ok.error());
    return ClEvent(event);
}

double milliseconds(const ClEvent& event) {
    if (!event)
        return 0.0;
    cl_ulong start = 0;
    cl_ulong end = 0;
    if (clGetEventProfilingInfo(event.get(), CL_PROFILING_COMMAND_START, sizeof(start), &start, nullptr) !=
            CL_SUCCESS ||
        clGetEventProfilingInfo(event.get(), CL_PROFILING_COMMAND_END, sizeof(end), &end, nullptr) !=
            CL_SUCCESS ||
        end < start)
        return 0.0;
    return static_cast<double>(end - start) * 1e-6;
}

} // namespace prizma
