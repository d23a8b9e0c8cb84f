# Writes OUTPUT, a C++ file with the text of every file in kernels/ and of GENERATED, which the build made.
# Run with -DKERNEL_DIR=... -DGENERATED=... -DOUTPUT=...
file(GLOB kernels ${KERNEL_DIR}/*.cl ${KERNEL_DIR}/*.clh ${KERNEL_DIR}/*.h)
list(APPEND kernels ${GENERATED})
set(entries "")
foreach(path ${kernels})
    get_filename_component(name ${path} NAME)
    file(READ ${path} text)
    string(APPEND entries "    {\"${name}\", R\"prizma(${text})prizma\"},\n")
endforeach()
file(WRITE ${OUTPUT}.new "// Made from kernels/ by embed_kernels.cmake.
#include \"core/compute/kernel_source.h\"
#include <utility>
namespace prizma {
static constexpr std::pair<std::string_view, std::string_view> files[] = {
${entries}};
std::string_view kernelFile(std::string_view name) {
    for (const auto& [fileName, text] : files)
        if (fileName == name)
            return text;
    return {};
}
} // namespace prizma
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
