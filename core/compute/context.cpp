#include "core/compute/context.h"

#include "core/compute/cl_error.h"
#include "core/compute/device_lookup.h"

namespace prizma {

Result<std::unique_ptr<Context>> Context::create(const std::string& deviceId) {
    const auto entries = listClDevices();
    std::vector<DeviceInfo> infos;
    for (const ClDevice& entry : entries)
        infos.push_back(entry.info);
    const int index = chooseDevice(infos, deviceId);
    if (index < 0)
        return failure(
            "There is no OpenCL device. On Debian, \"apt install pocl-opencl-icd\" adds one that runs on "
            "every CPU.");
    const ClDevice& chosen = entries[static_cast<std::size_t>(index)];
    if (!deviceId.empty() && chosen.info.id != deviceId)
        return failure("There is no usable OpenCL device called \"" + deviceId + "\".");

    std::unique_ptr<Context> made(new Context);
    made->info_ = chosen.info;
    made->device_ = chosen.device;
    const cl_context_properties properties[] = {CL_CONTEXT_PLATFORM,
                                                reinterpret_cast<cl_context_properties>(chosen.platform), 0};
    cl_int code = CL_SUCCESS;
    made->context_ = ClContext(clCreateContext(properties, 1, &chosen.device, nullptr, nullptr, &code));
    if (auto ok = checkCl(code, "start " + chosen.info.name); !ok)
        return std::unexpected(ok.error());
    made->queue_ =
        ClQueue(clCreateCommandQueue(made->context_.get(), chosen.device, CL_QUEUE_PROFILING_ENABLE, &code));
    if (auto ok = checkCl(code, "start a queue on " + chosen.info.name); !ok)
        return std::unexpected(ok.error());
    return made;
}

Result<void> Context::finish() {
    return checkCl(clFinish(queue_.get()), "finish the work on " + info_.name);
}

} // namespace prizma
