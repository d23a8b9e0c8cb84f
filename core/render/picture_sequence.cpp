#include "core/render/picture_sequence.h"

#include "core/import/file_finder.h"

#include <fmt/format.h>

#include <filesystem>

namespace prizma {
namespace {

bool isThere(const std::string& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

} // namespace

std::string findFault(const SequenceOptions& options) {
    const std::string extension = lowerExtension(options.output);
    if (extension != "png" && extension != "exr")
        return "the pictures' name must end in .png or .exr";
    if (options.last < options.first)
        return "the last frame comes before the first";
    const std::string name = std::filesystem::path(options.output).filename().string();
    if (options.last > options.first && name.find('#') == std::string::npos)
        return "several frames need #### in the pictures' name";
    const auto folder = std::filesystem::absolute(options.output).parent_path();
    if (std::error_code error; !std::filesystem::is_directory(folder, error))
        return "there is no folder \"" + folder.string() + "\"";
    return {};
}

std::string frameFile(const std::string& output, int frame) {
    const auto slash = output.find_last_of('/');
    const auto last = output.find_last_of('#');
    if (last == std::string::npos || (slash != std::string::npos && last < slash))
        return output;
    auto first = last;
    while (first > 0 && output[first - 1] == '#')
        --first;
    return output.substr(0, first) + fmt::format("{:0{}}", frame, last - first + 1) + output.substr(last + 1);
}

Result<SequenceSummary> renderSequence(Renderer& renderer, Scene scene, const SequenceOptions& options,
                                       Progress& progress,
                                       const std::function<void(const SequenceFrame&)>& frameDone) {
    if (const std::string fault = findFault(options); !fault.empty())
        return failure("The frames cannot be rendered: " + fault + ".", options.output);
    SequenceSummary summary;
    const double count = options.last - options.first + 1;
    for (int frame = options.first; frame <= options.last; ++frame) {
        progress.set((frame - options.first) / count);
        if (progress.isCancelled())
            return failure("Rendering was cancelled; the frames that are done stay.");
        const std::string file = frameFile(options.output, frame);
        if (!options.overwrite && isThere(file)) {
            ++summary.skipped;
            if (frameDone)
                frameDone({frame, file, nullptr});
            continue;
        }
        scene.timeline.frame = frame;
        const auto picture = renderOffline(renderer, scene, options.picture, &progress);
        if (!picture)
            return std::unexpected(picture.error());
        if (auto ok = savePicture(*picture, file); !ok)
            return std::unexpected(ok.error());
        ++summary.rendered;
        if (frameDone)
            frameDone({frame, file, &*picture});
    }
    progress.set(1.0);
    return summary;
}

} // namespace prizma
