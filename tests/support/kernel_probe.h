#pragma once

#include "core/compute/kernel.h"
#include "core/compute/program.h"

#include <QtGlobal>

#include <memory>
#include <string>

namespace prizma::test {

/// Kernels of a test's own, which call functions of kernels/ by including them.
class KernelProbe {
  public:
    /// `text` is OpenCL C. Faults end the test.
    KernelProbe(Context& context, const std::string& text) : context_(context) {
        auto program = buildProgram(context, "probe.cl", text, "-D PRIZMA_WIDE8");
        if (!program)
            qFatal("%s", program.error().message.c_str());
        program_ = std::move(*program);
    }

    /// Runs kernel `name` over `count` work items.
    template <class... Arguments>
    void run(const char* name, std::size_t count, const Arguments&... arguments) {
        auto kernel = Kernel::create(program_, name);
        if (!kernel)
            qFatal("%s", kernel.error().message.c_str());
        kernel->setArguments(arguments...);
        if (auto launched = kernel->launch(context_, count, 64); !launched || !context_.finish())
            qFatal("the kernel does not run");
    }

  private:
    Context& context_;
    ClProgram program_;
};

/// What a test gives a kernel and gets from it.
template <class T>
class ProbeBuffer {
  public:
    ProbeBuffer(Context& context, std::size_t count) : context_(context), values(count) {
        if (!buffer_.reserve(context, count, "probe"))
            qFatal("no memory");
    }
    const Buffer<T>& upload() {
        if (!buffer_.assign(context_, values, "probe"))
            qFatal("upload");
        return buffer_;
    }
    const Buffer<T>& buffer() const { return buffer_; }
    const std::vector<T>& download() {
        if (!buffer_.read(context_, values, 0, "probe"))
            qFatal("download");
        return values;
    }

  private:
    Context& context_;
    Buffer<T> buffer_;

  public:
    std::vector<T> values;
};

} // namespace prizma::test
