#include "app/render/command.h"

#include "core/compute/device.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace prizma {
namespace {

std::string gibibytes(std::uint64_t bytes) {
    return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / (1024.0 * 1024.0 * 1024.0));
}

nlohmann::ordered_json toJson(const DeviceInfo& d) {
    return {{"id", d.id},
            {"platform", d.platform},
            {"name", d.name},
            {"vendor", d.vendor},
            {"type", describe(d.type)},
            {"driver", d.driverVersion},
            {"opencl", d.openclVersion},
            {"computeUnits", d.computeUnits},
            {"clockMHz", d.clockMHz},
            {"globalMemory", d.globalMemory},
            {"maxAllocation", d.maxAllocation},
            {"localMemory", d.localMemory},
            {"maxWorkGroupSize", d.maxWorkGroupSize},
            {"floatVectorWidth", d.floatVectorWidth},
            {"doublePrecision", d.doublePrecision},
            {"usable", d.usable}};
}

void print(const DeviceInfo& d, bool isDefault) {
    fmt::print("{}{}\n", d.id, isDefault ? "  (default)" : (d.usable ? "" : "  (not usable)"));
    fmt::print("    {}, {} compute units at {} MHz, {} memory, {} a buffer\n", describe(d.type),
               d.computeUnits, d.clockMHz, gibibytes(d.globalMemory), gibibytes(d.maxAllocation));
    fmt::print("    {}, driver {}\n", d.openclVersion, d.driverVersion);
}

void listAll(bool json) {
    const auto devices = listDevices();
    const int chosen = chooseDevice(devices, {});
    if (json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const DeviceInfo& device : devices)
            list.push_back(toJson(device));
        fmt::print("{}\n", list.dump(2));
        return;
    }
    if (devices.empty()) {
        fmt::print(stderr,
                   "prizma-render: there is no OpenCL device; \"apt install pocl-opencl-icd\" adds one.\n");
        throw CLI::RuntimeError(1);
    }
    for (std::size_t i = 0; i < devices.size(); ++i)
        print(devices[i], static_cast<int>(i) == chosen);
}

} // namespace

void addDevicesCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("devices", "List the OpenCL devices and what they can do");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON");
    command->callback([json] { listAll(*json); });
}

} // namespace prizma
