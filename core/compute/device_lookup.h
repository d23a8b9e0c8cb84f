#pragma once

#include "core/compute/device.h"

#include <CL/cl.h>

#include <vector>

namespace prizma {

struct ClDevice {
    cl_platform_id platform = nullptr;
    cl_device_id device = nullptr;
    DeviceInfo info;
};

/// Every device of every platform with its OpenCL handles.
std::vector<ClDevice> listClDevices();

} // namespace prizma
