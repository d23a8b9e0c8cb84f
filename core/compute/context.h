#pragma once

#include "core/compute/cl_handle.h"
#include "core/compute/device.h"
#include "core/diagnostic.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace prizma {

/// One OpenCL device made ready: a context and an in-order queue that times every command.
class Context {
  public:
    /// On the device that `deviceId` names; an empty id takes the default device. Errors: no OpenCL device at
    /// all, no device of that id, a driver that refuses.
    static Result<std::unique_ptr<Context>> create(const std::string& deviceId);

    const DeviceInfo& info() const { return info_; }
    cl_device_id device() const { return device_; }
    cl_context context() const { return context_.get(); }
    cl_command_queue queue() const { return queue_.get(); }

    /// Waits until everything queued is done. Errors: what went wrong on the device meanwhile.
    Result<void> finish();

    /// Bytes that buffers of this context hold now.
    std::uint64_t allocatedBytes() const { return allocatedBytes_; }
    void countAllocation(std::int64_t bytes) { allocatedBytes_ += static_cast<std::uint64_t>(bytes); }

  private:
    Context() = default;

    DeviceInfo info_;
    cl_device_id device_ = nullptr;
    ClContext context_;
    ClQueue queue_;
    std::atomic<std::uint64_t> allocatedBytes_{0};
};

} // namespace prizma
