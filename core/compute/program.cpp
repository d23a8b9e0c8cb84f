#include "core/compute/program.h"

#include "core/compute/cl_error.h"
#include "core/compute/kernel_source.h"

#include <spdlog/spdlog.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <vector>

namespace prizma {
namespace {

namespace fs = std::filesystem;

/// FNV-1a over several texts; only names files, so collisions between a few dozen variants do not matter.
std::string hashOf(std::initializer_list<std::string_view> texts) {
    std::uint64_t hash = 14695981039346656037ull;
    const auto mix = [&](unsigned char byte) { hash = (hash ^ byte) * 1099511628211ull; };
    for (const std::string_view text : texts) {
        for (const char c : text)
            mix(static_cast<unsigned char>(c));
        mix(0);
    }
    char digits[17];
    std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

std::string buildLog(cl_program program, cl_device_id device) {
    std::size_t size = 0;
    clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
    std::string log(size, '\0');
    clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n'))
        log.pop_back();
    return log;
}

ClProgram loadCached(Context& context, const fs::path& path, const std::string& options) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<char> binary((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (binary.empty())
        return {};
    const std::size_t size = binary.size();
    const auto* bytes = reinterpret_cast<const unsigned char*>(binary.data());
    cl_device_id device = context.device();
    cl_int status = CL_SUCCESS;
    cl_int code = CL_SUCCESS;
    ClProgram program(
        clCreateProgramWithBinary(context.context(), 1, &device, &size, &bytes, &status, &code));
    if (code != CL_SUCCESS || status != CL_SUCCESS ||
        clBuildProgram(program.get(), 1, &device, options.c_str(), nullptr, nullptr) != CL_SUCCESS)
        return {};
    return program;
}

void storeCached(const ClProgram& program, const fs::path& path) {
    std::size_t size = 0;
    if (clGetProgramInfo(program.get(), CL_PROGRAM_BINARY_SIZES, sizeof(size), &size, nullptr) !=
            CL_SUCCESS ||
        size == 0)
        return;
    std::vector<unsigned char> binary(size);
    unsigned char* bytes = binary.data();
    if (clGetProgramInfo(program.get(), CL_PROGRAM_BINARIES, sizeof(bytes), &bytes, nullptr) != CL_SUCCESS)
        return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    // Another process may write the same entry: each writes its own file, the last rename wins.
    const fs::path temporary = path.string() + "." + std::to_string(std::random_device{}());
    std::ofstream(temporary, std::ios::binary)
        .write(reinterpret_cast<const char*>(binary.data()), static_cast<std::streamsize>(binary.size()));
    fs::rename(temporary, path, error);
    if (error)
        spdlog::warn("Could not keep a built kernel in {}: {}", path.string(), error.message());
}

} // namespace

fs::path programCacheFolder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return fs::path(cache) / "prizma" / "programs";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "prizma" / "programs";
    return {};
}

Result<ClProgram> buildProgram(Context& context, const std::string& file, const std::string& options) {
    return buildProgram(context, file, kernelFile(file), options);
}

Result<ClProgram> buildProgram(Context& context, const std::string& file, std::string_view content,
                               const std::string& options) {
    const std::string source = expandedKernelSource(file, content);
    const DeviceInfo& info = context.info();
    const fs::path folder = programCacheFolder();
    const fs::path cached =
        folder / (hashOf({source, options, info.id, info.driverVersion, info.openclVersion}) + ".bin");
    if (!folder.empty())
        if (ClProgram program = loadCached(context, cached, options))
            return program;

    const char* text = source.c_str();
    const std::size_t length = source.size();
    cl_int code = CL_SUCCESS;
    ClProgram program(clCreateProgramWithSource(context.context(), 1, &text, &length, &code));
    cl_device_id device = context.device();
    if (code == CL_SUCCESS)
        code = clBuildProgram(program.get(), 1, &device, options.c_str(), nullptr, nullptr);
    if (code != CL_SUCCESS)
        return failure("The kernels in " + file + " do not compile on " + info.name + " (" +
                       clErrorText(code) + "):\n" +
                       (program ? buildLog(program.get(), device) : std::string()));
    if (!folder.empty())
        storeCached(program, cached);
    return program;
}

} // namespace prizma
