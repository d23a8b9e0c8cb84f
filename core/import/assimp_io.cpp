#include "core/import/assimp_io.h"

#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/text_encoding.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace prizma {
namespace {

class MemoryStream : public Assimp::IOStream {
  public:
    explicit MemoryStream(std::string content) : content_(std::move(content)) {}

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        if (size == 0)
            return 0;
        const std::size_t whole = std::min(count, (content_.size() - position_) / size);
        std::memcpy(buffer, content_.data() + position_, whole * size);
        position_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? position_
                                                          : content_.size();
        const std::size_t target =
            base + offset; // offsets from the end wrap round, as in assimp's own streams
        if (target > content_.size())
            return aiReturn_FAILURE;
        position_ = target;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return position_; }
    std::size_t FileSize() const override { return content_.size(); }
    void Flush() override {}

  private:
    std::string content_;
    std::size_t position_ = 0;
};

std::string folderOf(const std::string& file) {
    return std::filesystem::path(file).parent_path().string();
}

bool isTextFormat(const std::string& file) {
    const std::string extension = lowerExtension(file);
    return extension == "obj" || extension == "mtl";
}

void addOnce(std::vector<std::string>& list, const std::string& entry) {
    if (std::find(list.begin(), list.end(), entry) == list.end())
        list.push_back(entry);
}

} // namespace

AssimpFiles::AssimpFiles(const std::string& model) : folders_{folderOf(model)}, model_(model) {}

bool AssimpFiles::Exists(const char* name) const {
    return findFile(folders_.front(), name).has_value();
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
    if (std::strchr(mode, 'w') || std::strchr(mode, 'a'))
        return nullptr;
    const auto found = findFile(folders_.front(), name);
    auto content = found ? readFile(*found) : failure({});
    if (content && isTextFormat(*found)) {
        auto text = toUtf8(std::move(*content));
        if (!text)
            return nullptr;
        // assimp 5.2.5 looks beyond the end of a last line that nothing ends.
        content = std::move(*text) + "\n";
    }
    if (!content) {
        addOnce(missing_, expectedPath(folders_.front(), name));
        return nullptr;
    }
    addOnce(folders_, folderOf(*found));
    if (*found != model_)
        addOnce(companions_, *found);
    return std::make_unique<MemoryStream>(std::move(*content)).release(); // assimp hands it back to Close
}

void AssimpFiles::Close(Assimp::IOStream* stream) {
    const std::unique_ptr<Assimp::IOStream> owner(stream);
}

bool AssimpProgress::Update(float fraction) {
    if (progress_.isCancelled())
        throw std::runtime_error("cancelled");
    if (fraction >= 0.0F)
        progress_.set(std::min(1.0, static_cast<double>(fraction)) * share_);
    return true;
}

} // namespace prizma
