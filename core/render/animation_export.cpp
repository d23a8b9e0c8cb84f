#include "core/render/animation_export.h"

#include "core/import/file_finder.h"

#include <array>
#include <filesystem>

namespace prizma {
namespace {

namespace fs = std::filesystem;

/// Where a video's pictures are.
fs::path pictureFolder(const AnimationExport& animation) {
    return animation.output + ".frames";
}

std::vector<std::string> pictureFiles(const AnimationExport& animation) {
    std::vector<std::string> files;
    const SequenceOptions sequence = sequenceOf(animation);
    for (int frame = animation.first; frame <= animation.last; ++frame)
        files.push_back(frameFile(sequence.output, frame));
    return files;
}

Result<void> makePictureFolder(const AnimationExport& animation) {
    std::error_code error;
    fs::create_directory(pictureFolder(animation), error);
    if (error)
        return failure("The folder for the video's pictures could not be made: " + error.message() + ".",
                       pictureFolder(animation).string());
    return {};
}

/// What cannot be removed stays; the video is there all the same.
void removePictures(const AnimationExport& animation) {
    std::error_code ignored;
    for (const std::string& file : pictureFiles(animation))
        fs::remove(file, ignored);
    fs::remove(pictureFolder(animation), ignored); // if nothing else is in it
}

} // namespace

bool isVideo(AnimationFormat format) {
    return format == AnimationFormat::Mp4 || format == AnimationFormat::WebM;
}

std::string_view extensionOf(AnimationFormat format) {
    constexpr std::array<std::string_view, 5> extensions{"png", "png", "exr", "mp4", "webm"};
    return extensions[static_cast<std::size_t>(format)];
}

SequenceOptions sequenceOf(const AnimationExport& animation) {
    SequenceOptions sequence;
    sequence.picture = animation.picture;
    sequence.picture.deep = animation.format == AnimationFormat::Png16;
    sequence.first = animation.first;
    sequence.last = animation.last;
    sequence.overwrite = animation.overwrite;
    sequence.output =
        isVideo(animation.format) ? (pictureFolder(animation) / "####.png").string() : animation.output;
    return sequence;
}

std::string findFault(const AnimationExport& animation) {
    if (lowerExtension(animation.output) != extensionOf(animation.format))
        return "the name must end in ." + std::string(extensionOf(animation.format));
    SequenceOptions sequence = sequenceOf(animation);
    if (isVideo(animation.format)) {
        if (!isVideoEncoderInstalled())
            return "ffmpeg, which makes the videos, is not installed";
        // The folder of the pictures is made when needed; that of the video has to be there.
        sequence.output = (fs::absolute(animation.output).parent_path() / "####.png").string();
    }
    return findFault(sequence);
}

int finishedFrames(const AnimationExport& animation) {
    if (animation.overwrite)
        return 0;
    int count = 0;
    std::error_code error;
    for (const std::string& file : pictureFiles(animation))
        count += fs::is_regular_file(file, error) ? 1 : 0;
    return count;
}

Result<SequenceSummary> exportAnimation(Renderer& renderer, const Scene& scene,
                                        const AnimationExport& animation, Progress& progress,
                                        const std::function<void()>& videoBegins) {
    if (const std::string fault = findFault(animation); !fault.empty())
        return failure("The animation cannot be exported: " + fault + ".", animation.output);
    if (isVideo(animation.format))
        if (auto made = makePictureFolder(animation); !made)
            return std::unexpected(made.error());
    auto summary = renderSequence(renderer, scene, sequenceOf(animation), progress);
    if (!summary || !isVideo(animation.format))
        return summary;
    progress.set(0.0);
    if (videoBegins)
        videoBegins();
    VideoOptions video;
    video.pictures = pictureFiles(animation);
    video.fps = animation.fps;
    video.output = animation.output;
    if (auto made = encodeVideo(video, progress); !made)
        return std::unexpected(made.error());
    if (!animation.keepPictures)
        removePictures(animation);
    return summary;
}

} // namespace prizma
