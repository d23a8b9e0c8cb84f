#include "core/render/video_encoder.h"

#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>

namespace prizma {
namespace {

constexpr const char* program = "ffmpeg";

class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int get() const { return number_; }
    void close() {
        if (number_ >= 0)
            ::close(number_);
        number_ = -1;
    }

  private:
    int number_;
};

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// ffmpeg at work: pictures go in through its standard input, complaints come out into a temporary file.
class Encoder {
  public:
    static Result<std::unique_ptr<Encoder>> start(const std::vector<std::string>& arguments) {
        std::array<int, 2> ends{};
        std::unique_ptr<std::FILE, CloseFile> complaints(std::tmpfile());
        // A socket, because writing to one whose reader is gone can be told not to raise a signal.
        if (!complaints || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            return failure(std::string("ffmpeg could not be started: ") + std::strerror(errno) + ".");
        std::unique_ptr<Encoder> encoder(new Encoder(ends[0], std::move(complaints)));
        const Descriptor input(ends[1]);
        if (const int error = encoder->spawn(arguments, input.get()); error != 0)
            return error == ENOENT
                       ? std::unexpected(missingVideoEncoder())
                       : failure(std::string("ffmpeg could not be started: ") + std::strerror(error) + ".");
        return encoder;
    }

    ~Encoder() {
        if (process_ <= 0)
            return;
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }

    /// False if ffmpeg takes no more; `finish` says why.
    bool write(std::string_view bytes) {
        while (!bytes.empty()) {
            const auto sent = send(input_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent < 0 && errno != EINTR)
                return false;
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
        }
        return true;
    }

    Result<void> finish() {
        input_.close();
        int status = 0;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            return {};
        return failure("ffmpeg could not make the video: " + complaint());
    }

  private:
    Encoder(int input, std::unique_ptr<std::FILE, CloseFile> complaints)
        : input_(input), complaints_(std::move(complaints)) {}

    int spawn(const std::vector<std::string>& arguments, int input) {
        std::vector<char*> list;
        for (const std::string& argument : arguments)
            list.push_back(const_cast<char*>(argument.c_str()));
        list.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, fileno(complaints_.get()), STDERR_FILENO);
        const int error = posix_spawnp(&process_, program, &actions, nullptr, list.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            process_ = 0;
        return error;
    }

    /// The last line that says something.
    std::string complaint() {
        std::string text;
        std::array<char, 4096> part{};
        std::rewind(complaints_.get());
        while (const std::size_t count = std::fread(part.data(), 1, part.size(), complaints_.get()))
            text.append(part.data(), count);
        std::istringstream lines(text);
        std::string last = "it gave no reason.";
        for (std::string line; std::getline(lines, line);)
            if (!line.empty())
                last = line;
        return last;
    }

    Descriptor input_;
    std::unique_ptr<std::FILE, CloseFile> complaints_;
    pid_t process_ = 0;
};

std::vector<std::string> argumentsFor(const VideoOptions& options, const std::string& file) {
    std::vector<std::string> list{program, "-hide_banner", "-loglevel", "error", "-y", "-f", "image2pipe",
                                  "-c:v", "png", "-framerate", fmt::format("{}", options.fps), "-i", "-",
                                  // Players want even sizes and colour at half resolution.
                                  "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
    const auto add = [&](std::initializer_list<const char*> more) {
        list.insert(list.end(), more.begin(), more.end());
    };
    if (lowerExtension(options.output) == "webm")
        add({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-f", "webm"});
    else
        add({"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"});
    list.push_back("file:" + file);
    return list;
}

Result<void> encodeTo(const std::string& file, const VideoOptions& options, Progress& progress) {
    auto encoder = Encoder::start(argumentsFor(options, file));
    if (!encoder)
        return std::unexpected(encoder.error());
    const auto count = static_cast<double>(options.pictures.size());
    for (std::size_t i = 0; i < options.pictures.size(); ++i) {
        progress.set(static_cast<double>(i) / count);
        if (progress.isCancelled())
            return failure("Making the video was cancelled; the pictures stay.", options.output);
        const auto bytes = readFile(options.pictures[i]);
        if (!bytes)
            return std::unexpected(bytes.error());
        if (!(*encoder)->write(*bytes))
            break;
    }
    return (*encoder)->finish();
}

} // namespace

bool isVideoEncoderInstalled() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0)
            return true;
    return false;
}

Diagnostic missingVideoEncoder() {
    return {Severity::Error,
            "ffmpeg, which makes the videos, is not installed. Install it (on Debian: sudo apt install "
            "ffmpeg) and "
            "try again; finished pictures need not be rendered again.",
            {},
            0};
}

std::string findFault(const VideoOptions& options) {
    const std::string extension = lowerExtension(options.output);
    if (extension != "mp4" && extension != "webm")
        return "a video's name must end in .mp4 or .webm";
    if (options.pictures.empty())
        return "there are no pictures for it";
    if (std::any_of(options.pictures.begin(), options.pictures.end(),
                    [](const std::string& file) { return lowerExtension(file) != "png"; }))
        return "a video is made of .png pictures";
    if (!std::isfinite(options.fps) || options.fps <= 0.0)
        return "its frame rate must be above 0";
    return {};
}

Result<void> encodeVideo(const VideoOptions& options, Progress& progress) {
    if (const std::string fault = findFault(options); !fault.empty())
        return failure("The video cannot be made: " + fault + ".", options.output);
    if (!isVideoEncoderInstalled())
        return std::unexpected(missingVideoEncoder());
    const auto made =
        replaceFile(std::filesystem::absolute(options.output).string(),
                    [&](const std::string& temporary) { return encodeTo(temporary, options, progress); });
    if (made)
        progress.set(1.0);
    return made;
}

} // namespace prizma
