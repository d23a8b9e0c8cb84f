#include "core/compute/cl_error.h"

namespace prizma {

std::string clErrorText(cl_int code) {
    switch (code) {
    case CL_DEVICE_NOT_AVAILABLE:
        return "the device is not available";
    case CL_COMPILER_NOT_AVAILABLE:
        return "the device has no compiler";
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_OUT_OF_RESOURCES:
        return "the device ran out of memory or other resources";
    case CL_OUT_OF_HOST_MEMORY:
        return "the computer ran out of memory";
    case CL_INVALID_BUFFER_SIZE:
        return "the scene needs a larger buffer than the device allows";
    case CL_BUILD_PROGRAM_FAILURE:
        return "the kernels do not compile";
    case CL_INVALID_KERNEL_NAME:
        return "the kernel is missing from its program";
    case CL_INVALID_WORK_GROUP_SIZE:
        return "the device does not allow this work-group size";
    default:
        return "OpenCL error " + std::to_string(code);
    }
}

Result<void> checkCl(cl_int code, const std::string& action) {
    if (code == CL_SUCCESS)
        return {};
    return failure("Could not " + action + ": " + clErrorText(code) + ".");
}

} // namespace prizma
