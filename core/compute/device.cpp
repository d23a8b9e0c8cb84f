#include "core/compute/device.h"

#include "core/compute/device_lookup.h"

#include <algorithm>
#include <map>

namespace prizma {
namespace {

std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\0' || text.back() == ' '))
        text.pop_back();
    text.erase(0, text.find_first_not_of(' '));
    return text;
}

std::string platformText(cl_platform_id platform, cl_platform_info what) {
    std::size_t size = 0;
    if (clGetPlatformInfo(platform, what, 0, nullptr, &size) != CL_SUCCESS)
        return {};
    std::string text(size, '\0');
    clGetPlatformInfo(platform, what, size, text.data(), nullptr);
    return trimmed(text);
}

std::string deviceText(cl_device_id device, cl_device_info what) {
    std::size_t size = 0;
    if (clGetDeviceInfo(device, what, 0, nullptr, &size) != CL_SUCCESS)
        return {};
    std::string text(size, '\0');
    clGetDeviceInfo(device, what, size, text.data(), nullptr);
    return trimmed(text);
}

template <class T>
T deviceValue(cl_device_id device, cl_device_info what) {
    T value{};
    clGetDeviceInfo(device, what, sizeof(value), &value, nullptr);
    return value;
}

DeviceType deviceType(cl_device_type type) {
    if ((type & CL_DEVICE_TYPE_GPU) != 0)
        return DeviceType::Gpu;
    if ((type & CL_DEVICE_TYPE_CPU) != 0)
        return DeviceType::Cpu;
    return (type & CL_DEVICE_TYPE_ACCELERATOR) != 0 ? DeviceType::Accelerator : DeviceType::Other;
}

DeviceInfo readFacts(cl_platform_id platform, cl_device_id device) {
    DeviceInfo info;
    info.platform = platformText(platform, CL_PLATFORM_NAME);
    info.name = deviceText(device, CL_DEVICE_NAME);
    info.vendor = deviceText(device, CL_DEVICE_VENDOR);
    info.driverVersion = deviceText(device, CL_DRIVER_VERSION);
    info.openclVersion = deviceText(device, CL_DEVICE_VERSION);
    info.type = deviceType(deviceValue<cl_device_type>(device, CL_DEVICE_TYPE));
    info.computeUnits = static_cast<int>(deviceValue<cl_uint>(device, CL_DEVICE_MAX_COMPUTE_UNITS));
    info.clockMHz = static_cast<int>(deviceValue<cl_uint>(device, CL_DEVICE_MAX_CLOCK_FREQUENCY));
    info.globalMemory = deviceValue<cl_ulong>(device, CL_DEVICE_GLOBAL_MEM_SIZE);
    info.maxAllocation = deviceValue<cl_ulong>(device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
    info.localMemory = deviceValue<cl_ulong>(device, CL_DEVICE_LOCAL_MEM_SIZE);
    info.maxWorkGroupSize = deviceValue<std::size_t>(device, CL_DEVICE_MAX_WORK_GROUP_SIZE);
    info.floatVectorWidth =
        static_cast<int>(deviceValue<cl_uint>(device, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT));
    info.doublePrecision = deviceText(device, CL_DEVICE_EXTENSIONS).find("cl_khr_fp64") != std::string::npos;
    info.usable = deviceValue<cl_bool>(device, CL_DEVICE_AVAILABLE) == CL_TRUE &&
                  deviceValue<cl_bool>(device, CL_DEVICE_COMPILER_AVAILABLE) == CL_TRUE;
    return info;
}

std::vector<cl_platform_id> platforms() {
    cl_uint count = 0;
    if (clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS)
        return {};
    std::vector<cl_platform_id> ids(count);
    clGetPlatformIDs(count, ids.data(), nullptr);
    return ids;
}

std::vector<cl_device_id> devicesOf(cl_platform_id platform) {
    cl_uint count = 0;
    if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS)
        return {};
    std::vector<cl_device_id> ids(count);
    clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, ids.data(), nullptr);
    return ids;
}

} // namespace

std::vector<ClDevice> listClDevices() {
    std::vector<ClDevice> devices;
    std::map<std::string, int> alike;
    for (cl_platform_id platform : platforms()) {
        for (cl_device_id device : devicesOf(platform)) {
            ClDevice entry{platform, device, readFacts(platform, device)};
            entry.info.id = entry.info.platform + " / " + entry.info.name;
            if (const int number = ++alike[entry.info.id]; number > 1)
                entry.info.id += " #" + std::to_string(number);
            devices.push_back(std::move(entry));
        }
    }
    return devices;
}

std::vector<DeviceInfo> listDevices() {
    std::vector<DeviceInfo> infos;
    for (ClDevice& entry : listClDevices())
        infos.push_back(std::move(entry.info));
    return infos;
}

int chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& preferred) {
    const auto indexOf = [&](auto&& fits) {
        const auto found = std::find_if(devices.begin(), devices.end(), fits);
        return found == devices.end() ? -1 : static_cast<int>(found - devices.begin());
    };
    int index = indexOf([&](const DeviceInfo& d) { return d.usable && d.id == preferred; });
    if (index < 0)
        index = indexOf([](const DeviceInfo& d) {
            return d.usable && d.type == DeviceType::Cpu && d.platform.find("Portable") != std::string::npos;
        });
    return index >= 0 ? index : indexOf([](const DeviceInfo& d) { return d.usable; });
}

std::string describe(DeviceType type) {
    switch (type) {
    case DeviceType::Cpu:
        return "CPU";
    case DeviceType::Gpu:
        return "GPU";
    case DeviceType::Accelerator:
        return "Accelerator";
    case DeviceType::Other:
        break;
    }
    return "Other";
}

} // namespace prizma
