#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace prizma {

enum class DeviceType { Cpu, Gpu, Accelerator, Other };

/// The facts about an OpenCL device that people choose by.
struct DeviceInfo {
    std::string id; ///< Stable between starts: "platform / device", with a number if several are alike.
    std::string platform;
    std::string name;
    std::string vendor;
    std::string driverVersion;
    std::string openclVersion;
    DeviceType type = DeviceType::Other;
    int computeUnits = 0;
    int clockMHz = 0;
    std::uint64_t globalMemory = 0;  ///< Bytes.
    std::uint64_t maxAllocation = 0; ///< Bytes a single buffer may have.
    std::uint64_t localMemory = 0;
    std::uint64_t maxWorkGroupSize = 0;
    int floatVectorWidth = 1;
    bool doublePrecision = false;
    bool usable = false; ///< Available, with a compiler.
};

/// Every device of every platform; empty if there is no OpenCL at all. Never fails.
std::vector<DeviceInfo> listDevices();

/// Index into `devices` of the device to start with: the one whose id is `preferred`; else a PoCL CPU, else
/// any usable one; -1 if there is none.
int chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& preferred);

/// "CPU", "GPU", ...
std::string describe(DeviceType type);

} // namespace prizma
