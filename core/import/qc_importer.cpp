#include "core/import/qc_importer.h"

#include "core/import/file_finder.h"
#include "core/import/smd_importer.h"
#include "core/import/smd_model_builder.h"
#include "core/import/smd_reader.h"
#include "core/import/text_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace prizma {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostPoses = 20'000'000; ///< Of all sequences together: about 800 MB.
constexpr std::size_t mostFolders = 64;
constexpr int mostParentFolders = 6; ///< How far above the script a game's folder of materials is looked for.

std::string folderOf(const std::string& file) {
    return fs::path(file).parent_path().string();
}

Result<QcModel> readQcFile(const std::string& file) {
    auto text = readTextFile(file, mostScriptBytes);
    if (!text)
        return std::unexpected(text.error());
    const std::string folder = folderOf(file);
    return readQc({file, std::move(*text)}, [&](const std::string& name) -> Result<QcScript> {
        const auto found = findFile(folder, name);
        if (!found)
            return failure("There is no such file.", file);
        auto included = readTextFile(*found, mostScriptBytes);
        if (!included)
            return std::unexpected(included.error());
        return QcScript{*found, std::move(*included)};
    });
}

void addFolder(std::vector<std::string>& folders, const std::string& base, const std::string& name) {
    if (folders.size() >= mostFolders)
        return;
    if (const auto found = findFolder(base, name);
        found && std::ranges::find(folders, *found) == folders.end())
        folders.push_back(*found);
}

class QcImporter {
  public:
    QcImporter(const std::string& file, QcModel qc, const ImportOptions& options, Progress& progress)
        : file_(file), qc_(std::move(qc)), options_(options), progress_(progress) {
        modelFolders_.push_back(folderOf(file));
        for (const std::string& folder : qc_.folders)
            addFolder(modelFolders_, folderOf(file), folder);
        builder_.warnings() = std::move(qc_.warnings);
    }

    Result<ImportedModel> import(bool withPictures) {
        if (qc_.bodies.empty())
            return failure("The script names no model: it has neither $body nor $model nor $bodygroup.",
                           file_);
        if (auto done = addBodies(); !done)
            return std::unexpected(done.error());
        builder_.buildMesh();
        addFlexes();
        addSequences();
        if (progress_.isCancelled())
            return failure("The import was cancelled.", file_);
        if (!withPictures)
            return builder_.finish(nullptr);
        TextureFinder textures(textureFolders());
        return builder_.finish(&textures);
    }

    std::set<std::string> files() const {
        std::set<std::string> files;
        const auto add = [&](const std::string& name, const char* extension) {
            if (auto found = find(name, extension))
                files.insert(std::move(*found));
        };
        for (const QcBody& body : qc_.bodies) {
            add(body.file, "smd");
            add(body.flexFile, "vta");
        }
        for (const QcSequence& sequence : qc_.sequences)
            add(sequence.file, "smd");
        return files;
    }

  private:
    /// A file that the script names, with the extension that it may leave out.
    Result<std::string> find(const std::string& name, const std::string& extension) const {
        std::string extended = name;
        extended += '.';
        extended += extension;
        for (const std::string& wanted : {name, extended})
            if (lowerExtension(wanted) == extension)
                for (const std::string& folder : modelFolders_)
                    if (auto found = findFile(folder, wanted))
                        return std::move(*found);
        const std::string other = lowerExtension(name);
        if (other == "dmx" || other == "fbx" || other == "obj")
            return failure("Of a script's models only those in SMD files are read, not \"" + name + "\".");
        return failure("There is no file \"" + name + "\".");
    }

    void warn(const std::string& what, const Diagnostic& reason, const std::string& script, int line) {
        const std::string where = reason.file.empty() ? std::string() : " (" + describe(reason) + ")";
        builder_.warnings().push_back(
            {Severity::Warning, what + (where.empty() ? ": " + reason.message : "." + where), script, line});
    }

    Result<void> addBodies() {
        Diagnostic lastFault{Severity::Error, "There are no triangles in it.", file_, 0};
        const auto count = static_cast<double>(qc_.bodies.size());
        double done = 0.0;
        for (const QcBody& body : qc_.bodies) {
            if (progress_.isCancelled())
                return failure("The import was cancelled.", file_);
            const auto part = ProgressPart(progress_).part(0.4 * done / count, 0.4 * (done + 1.0) / count);
            done += 1.0;
            if (auto added = addBody(body, part); !added) {
                lastFault = added.error();
                if (lastFault.file.empty()) {
                    lastFault.file = body.script;
                    lastFault.line = body.line;
                }
                warn("The body \"" + body.file + "\" was left out", added.error(), body.script, body.line);
            }
        }
        if (!builder_.hasTriangles())
            return std::unexpected(lastFault);
        return {};
    }

    Result<void> addBody(const QcBody& body, const ProgressPart& progress) {
        const auto file = find(body.file, "smd");
        if (!file)
            return std::unexpected(file.error());
        const auto text = readTextFile(*file, mostModelBytes);
        if (!text)
            return std::unexpected(text.error());
        const auto smd = readSmd(*text, *file, progress);
        if (!smd)
            return std::unexpected(smd.error());
        if (smd->corners.empty())
            return failure("There are no triangles in it.", *file);
        if (auto done = builder_.addBody(*smd, {options_.upAxis, options_.unitScale * body.scale}, *file);
            !done)
            return done;
        bodyFolders_.insert(folderOf(*file));
        bodiesRead_.push_back(&body);
        return {};
    }

    void addFlexes() {
        for (std::size_t i = 0; i < bodiesRead_.size(); ++i) {
            const QcBody& body = *bodiesRead_[i];
            if (body.flexFile.empty())
                continue;
            const auto file = find(body.flexFile, "vta");
            const auto text = file ? readTextFile(*file, mostModelBytes) : std::unexpected(file.error());
            const auto vta = text ? readVta(*text, *file, ProgressPart(progress_, 0.4, 0.5))
                                  : std::unexpected(text.error());
            if (vta)
                builder_.addFlexes(i, *vta, body.flexes, *file);
            else
                warn("The flexes of \"" + body.file + "\" were left out", vta.error(), body.script,
                     body.line);
        }
    }

    void addSequences() {
        std::size_t poses = 0;
        const double count = static_cast<double>(std::max<std::size_t>(qc_.sequences.size(), 1));
        for (std::size_t i = 0; i < qc_.sequences.size() && !progress_.isCancelled(); ++i) {
            const QcSequence& sequence = qc_.sequences[i];
            const auto part = ProgressPart(progress_).part(0.5 + 0.4 * static_cast<double>(i) / count,
                                                           0.5 + 0.4 * (static_cast<double>(i) + 1) / count);
            if (auto added = addSequence(sequence, part))
                poses += *added;
            else
                warn("The sequence \"" + sequence.name + "\" was left out", added.error(), sequence.script,
                     sequence.line);
            if (poses > mostPoses) {
                builder_.warnings().push_back({Severity::Warning,
                                               "The sequences are too long for memory; those after \"" +
                                                   sequence.name + "\" were left out.",
                                               sequence.script, sequence.line});
                return;
            }
        }
    }

    /// Gives the number of its poses.
    Result<std::size_t> addSequence(const QcSequence& sequence, const ProgressPart& progress) {
        const auto file = find(sequence.file, "smd");
        if (!file)
            return std::unexpected(file.error());
        auto animation =
            importSmdAnimation(*file, {options_.upAxis, options_.unitScale * sequence.scale}, progress);
        if (!animation)
            return std::unexpected(animation.error());
        Clip& clip = animation->clip;
        clip.name = sequence.name;
        clip.fps = sequence.fps;
        clip.loops = sequence.loops;
        std::ranges::move(animation->warnings, std::back_inserter(builder_.warnings()));
        if (sequence.frames)
            trim(clip, *sequence.frames, sequence);
        const std::size_t poses = clip.tracks.size() * static_cast<std::size_t>(clip.frameCount);
        builder_.addClip(std::move(clip), animation->skeleton, *file);
        return poses;
    }

    void trim(Clip& clip, const std::pair<int, int>& frames, const QcSequence& sequence) {
        const int last = std::min(frames.second, clip.frameCount - 1);
        if (frames.second > last)
            builder_.warnings().push_back({Severity::Warning,
                                           "The sequence \"" + sequence.name + "\" has only " +
                                               std::to_string(clip.frameCount) +
                                               " frames, fewer than the script asks for.",
                                           sequence.script, sequence.line});
        if (frames.first > last)
            return;
        clip.frameCount = last - frames.first + 1;
        for (BoneTrack& track : clip.tracks)
            track.frames = {track.frames.begin() + frames.first, track.frames.begin() + last + 1};
    }

    /// Where pictures may be: beside the models and the script, in the folders that it names, and in those
    /// below the materials folder of the game that it lies in.
    std::vector<std::string> textureFolders() const {
        std::vector<std::string> folders(bodyFolders_.begin(), bodyFolders_.end());
        for (const std::string& folder : modelFolders_)
            if (std::ranges::find(folders, folder) == folders.end())
                folders.push_back(folder);
        for (const std::string& name : qc_.textureFolders)
            for (const std::string& base : modelFolders_)
                addFolder(folders, base, name);
        fs::path above = folderOf(file_);
        for (int i = 0; i < mostParentFolders && above.has_relative_path(); ++i) {
            if (const auto materials = findFolder(above.string(), "materials"))
                for (const std::string& name : qc_.textureFolders)
                    addFolder(folders, *materials, name);
            above = above.parent_path();
        }
        return folders;
    }

    std::string file_;
    QcModel qc_;
    ImportOptions options_;
    Progress& progress_;
    SmdModelBuilder builder_;
    std::vector<std::string> modelFolders_;
    std::set<std::string> bodyFolders_;
    std::vector<const QcBody*> bodiesRead_;
};

} // namespace

Result<ImportedModel> importQc(const std::string& file, const ImportOptions& options, Progress& progress) {
    auto qc = readQcFile(file);
    if (!qc)
        return std::unexpected(qc.error());
    return QcImporter(file, std::move(*qc), options, progress).import(true);
}

Result<ImportedModel> importQcClips(const std::string& file, const ImportOptions& options,
                                    Progress& progress) {
    auto qc = readQcFile(file);
    if (!qc)
        return std::unexpected(qc.error());
    return QcImporter(file, std::move(*qc), options, progress).import(false);
}

std::set<std::string> filesOfQc(const std::string& file) {
    auto qc = readQcFile(file);
    Progress progress;
    return qc ? QcImporter(file, std::move(*qc), {}, progress).files() : std::set<std::string>();
}

SmdSpace spaceOfQc(const std::string& file) {
    SmdSpace space;
    if (const auto qc = readQcFile(file)) {
        space.upAxis = qc->upAxis.value_or(space.upAxis);
        if (!qc->bodies.empty())
            space.scale = qc->bodies.front().scale;
    }
    return space;
}

} // namespace prizma
