#include "core/import/qc_reader.h"

#include "core/import/qc_lexer.h"
#include "core/import/text_fields.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace prizma {
namespace {

constexpr std::size_t mostIncludes = 256;
constexpr std::size_t mostParts = 10'000; ///< Bodies, sequences, animations, flexes and folders, each.

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

constexpr std::size_t mostWarnings = 1000;

/// What $animation and $sequence have in common; what is not said is not set.
struct Motion {
    std::string file;
    std::optional<double> fps, scale;
    std::optional<std::pair<int, int>> frames;
    bool loops = false;
    bool blends = false; ///< Names more files than the one that is kept.
};

class QcReader {
  public:
    explicit QcReader(const QcIncluder& include) : include_(include) {}

    Result<void> readScript(const QcScript& script);
    QcModel finish() { return std::move(model_); }

  private:
    using Handler = Result<void> (QcReader::*)();

    static Handler handlerOf(std::string_view command);

    // The words of one command: up to the next command that is not in its braces.
    std::optional<QcToken> next();
    std::optional<QcToken> wordOnSameCommand();
    std::optional<double> number();
    Result<std::string> argument(const char* what);
    Result<void> skipRest();

    Result<void> readBody();
    Result<void> readModel();
    Result<void> readBodyGroup();
    Result<void> readFlexFile(QcBody& body);
    Result<void> readSequence();
    Result<void> readAnimation();
    Result<Motion> readMotion();
    Result<void> readMotionWord(const QcToken& token, Motion& motion);
    Result<void> readScale();
    Result<void> readFolder();
    Result<void> readTextureFolder();
    Result<void> readUpAxis();
    Result<void> readInclude();
    Result<void> readMacro();

    std::optional<double> positive(const char* message);
    QcBody bodyHere(std::string file) const;

    std::unexpected<Diagnostic> error(std::string message) const {
        return failure(std::move(message), file_, line_);
    }
    void warn(std::string message) {
        if (model_.warnings.size() < mostWarnings)
            model_.warnings.push_back({Severity::Warning, std::move(message), file_, line_});
    }
    template <class List>
    Result<void> checkNumber(const List& list, const char* what) const {
        if (list.size() >= mostParts)
            return error(std::string("There are more than ") + std::to_string(mostParts) + " " + what + ".");
        return {};
    }

    const QcIncluder& include_;
    QcModel model_;
    std::map<std::string, Motion> animations_; ///< By name in lower case.
    double scale_ = 1.0;
    std::size_t includes_ = 0;

    // Of the present script.
    QcLexer lexer_{{}};
    std::string file_;
    int line_ = 0;  ///< Of the present command.
    int depth_ = 0; ///< Of its braces.
};

QcReader::Handler QcReader::handlerOf(std::string_view command) {
    static constexpr std::pair<std::string_view, Handler> handlers[] = {
        {"$body", &QcReader::readBody},
        {"$model", &QcReader::readModel},
        {"$bodygroup", &QcReader::readBodyGroup},
        {"$sequence", &QcReader::readSequence},
        {"$animation", &QcReader::readAnimation},
        {"$scale", &QcReader::readScale},
        {"$cd", &QcReader::readFolder},
        {"$cdtexture", &QcReader::readTextureFolder},
        {"$cdmaterials", &QcReader::readTextureFolder},
        {"$upaxis", &QcReader::readUpAxis},
        {"$include", &QcReader::readInclude},
        {"$definemacro", &QcReader::readMacro},
        {"$definevariable", &QcReader::readMacro},
    };
    const auto found =
        std::ranges::find(handlers, lowerCase(command), [](const auto& entry) { return entry.first; });
    return found == std::end(handlers) ? nullptr : found->second;
}

Result<void> QcReader::readScript(const QcScript& script) {
    const auto outerLexer = std::exchange(lexer_, QcLexer(script.text));
    const auto outerFile = std::exchange(file_, script.file);
    const int outerLine = line_;
    while (const auto token = lexer_.next()) {
        if (!token->isCommand())
            continue;
        line_ = token->line;
        depth_ = 0;
        if (const Handler handler = handlerOf(token->text))
            if (auto done = (this->*handler)(); !done)
                return done;
        if (auto done = skipRest(); !done)
            return done;
    }
    lexer_ = outerLexer;
    file_ = outerFile;
    line_ = outerLine;
    depth_ = 0;
    return {};
}

std::optional<QcToken> QcReader::next() {
    const auto token = lexer_.peek();
    if (!token || (depth_ <= 0 && token->isCommand()))
        return std::nullopt;
    lexer_.next();
    if (token->is('{'))
        ++depth_;
    else if (token->is('}'))
        --depth_;
    return token;
}

Result<void> QcReader::skipRest() {
    while (next()) {
    }
    if (depth_ > 0)
        return error("A brace that opens here is not closed.");
    return {};
}

/// The next word, unless a brace or another command follows.
std::optional<QcToken> QcReader::wordOnSameCommand() {
    const auto token = lexer_.peek();
    if (!token || token->is('{') || token->is('}'))
        return std::nullopt;
    return next();
}

std::optional<double> QcReader::number() {
    const auto token = wordOnSameCommand();
    return token ? Fields(token->text).number() : std::nullopt;
}

Result<std::string> QcReader::argument(const char* what) {
    const auto token = wordOnSameCommand();
    if (!token)
        return error(std::string("The command lacks ") + what + ".");
    return std::string(token->text);
}

std::optional<double> QcReader::positive(const char* message) {
    const auto value = number();
    if (value && *value > 0.0 && *value <= 1e6)
        return value;
    warn(message);
    return std::nullopt;
}

QcBody QcReader::bodyHere(std::string file) const {
    QcBody body;
    body.file = std::move(file);
    body.scale = scale_;
    body.script = file_;
    body.line = line_;
    return body;
}

Result<void> QcReader::readBody() {
    const auto name = argument("the body's name");
    if (!name)
        return std::unexpected(name.error());
    auto file = argument("the body's file");
    if (!file)
        return std::unexpected(file.error());
    if (auto done = checkNumber(model_.bodies, "bodies"); !done)
        return done;
    model_.bodies.push_back(bodyHere(std::move(*file)));
    return {};
}

/// As $body, with a block that may name the file of its flexes.
Result<void> QcReader::readModel() {
    if (auto done = readBody(); !done)
        return done;
    while (const auto token = next())
        if (!token->isQuoted && lowerCase(token->text) == "flexfile")
            if (auto done = readFlexFile(model_.bodies.back()); !done)
                return done;
    return {};
}

/// flexfile "file" { defaultflex frame 0  flex "name" frame 1  flexpair "name" 1 frame 2 ... }
Result<void> QcReader::readFlexFile(QcBody& body) {
    auto file = argument("the name of the VTA file");
    if (!file)
        return std::unexpected(file.error());
    if (!body.flexFile.empty())
        warn("The model has several flex files; the last was taken.");
    body.flexFile = std::move(*file);
    body.flexes.clear();
    const int outer = depth_;
    std::string name;
    while (const auto token = next()) {
        if (depth_ <= outer && token->is('}'))
            return {};
        const std::string word = lowerCase(token->text);
        if (word == "flex" || word == "flexpair") {
            const auto given = wordOnSameCommand();
            name = given ? std::string(given->text) : std::string();
        } else if (word == "frame") {
            const auto frame = number();
            if (!name.empty() && frame && *frame >= 1.0 && *frame < 1e9) {
                if (auto done = checkNumber(body.flexes, "flexes"); !done)
                    return done;
                body.flexes.push_back({std::exchange(name, {}), static_cast<int>(*frame)});
            }
        }
    }
    return {};
}

/// $bodygroup "name" { studio "file"  blank ... }: what is listed first is what is seen.
Result<void> QcReader::readBodyGroup() {
    const auto name = argument("the body group's name");
    if (!name)
        return std::unexpected(name.error());
    std::optional<std::string> first;
    std::size_t choices = 0;
    while (const auto token = next()) {
        const std::string word = token->isQuoted ? std::string() : lowerCase(token->text);
        if (word == "studio") {
            auto file = argument("the file of \"studio\"");
            if (!file)
                return std::unexpected(file.error());
            if (choices++ == 0)
                first = std::move(*file);
        } else if (word == "blank") {
            ++choices;
        } else if (token->is('}') && depth_ <= 0) {
            break;
        }
    }
    if (choices > 1)
        warn("The body group \"" + *name + "\" offers " + std::to_string(choices) + " choices; the first, " +
             (first ? "\"" + *first + "\"" : std::string("which is blank")) + ", was taken.");
    if (!first)
        return {};
    if (auto done = checkNumber(model_.bodies, "bodies"); !done)
        return done;
    model_.bodies.push_back(bodyHere(std::move(*first)));
    return {};
}

/// One word of a motion: an option, its file, or something that is of no matter here (events, activities).
Result<void> QcReader::readMotionWord(const QcToken& token, Motion& motion) {
    const std::string word = lowerCase(token.text);
    if (!token.isQuoted && word == "fps") {
        motion.fps = positive("The frame rate is no number above 0; the usual one was taken.");
    } else if (!token.isQuoted && word == "loop") {
        motion.loops = true;
    } else if (!token.isQuoted && word == "scale") {
        motion.scale = positive("The scale is no number above 0; it was ignored.");
    } else if (!token.isQuoted && (word == "frames" || word == "frame")) {
        const auto first = number();
        const auto last = number();
        if (first && last && *first >= 0.0 && *last >= *first && *last < 1e9)
            motion.frames = {static_cast<int>(*first), static_cast<int>(*last)};
        else
            warn("The range of frames is none; all frames were taken.");
    } else if (!token.is('{') && !token.is('}')) {
        const bool isFile = word.ends_with(".smd") || animations_.contains(word);
        if (!motion.file.empty())
            motion.blends = motion.blends || isFile;
        else if (isFile || (!Fields(token.text).number() && !word.starts_with("act_")))
            motion.file = token.text;
    }
    return {};
}

Result<Motion> QcReader::readMotion() {
    Motion motion;
    while (const auto token = next())
        if (auto done = readMotionWord(*token, motion); !done)
            return std::unexpected(done.error());
    if (motion.file.empty())
        return error("The command lacks the name of an SMD file.");
    return motion;
}

Result<void> QcReader::readAnimation() {
    const auto name = argument("the animation's name");
    if (!name)
        return std::unexpected(name.error());
    auto motion = readMotion();
    if (!motion)
        return std::unexpected(motion.error());
    if (auto done = checkNumber(animations_, "animations"); !done)
        return done;
    if (!motion->scale)
        motion->scale = scale_;
    animations_[lowerCase(*name)] = std::move(*motion);
    return {};
}

Result<void> QcReader::readSequence() {
    const auto name = argument("the sequence's name");
    if (!name)
        return std::unexpected(name.error());
    const auto own = readMotion();
    if (!own)
        return std::unexpected(own.error());
    if (auto done = checkNumber(model_.sequences, "sequences"); !done)
        return done;
    if (own->blends)
        warn("The sequence \"" + *name + "\" blends several animations; the first was taken.");
    const auto named = animations_.find(lowerCase(own->file));
    const Motion none;
    const Motion& base = named == animations_.end() ? none : named->second;
    QcSequence sequence;
    sequence.name = *name;
    sequence.file = base.file.empty() ? own->file : base.file;
    sequence.fps = own->fps.value_or(base.fps.value_or(30.0));
    sequence.loops = own->loops || base.loops;
    sequence.scale = own->scale.value_or(base.scale.value_or(scale_));
    sequence.frames = own->frames ? own->frames : base.frames;
    sequence.script = file_;
    sequence.line = line_;
    model_.sequences.push_back(std::move(sequence));
    return {};
}

Result<void> QcReader::readScale() {
    scale_ = positive("The scale is no number above 0; it was ignored.").value_or(scale_);
    return {};
}

Result<void> QcReader::readFolder() {
    const auto folder = argument("a folder");
    if (!folder)
        return std::unexpected(folder.error());
    if (auto done = checkNumber(model_.folders, "folders"); !done)
        return done;
    if (std::ranges::find(model_.folders, *folder) == model_.folders.end())
        model_.folders.push_back(*folder);
    return {};
}

Result<void> QcReader::readTextureFolder() {
    const auto folder = argument("a folder");
    if (!folder)
        return std::unexpected(folder.error());
    if (auto done = checkNumber(model_.textureFolders, "folders"); !done)
        return done;
    if (std::ranges::find(model_.textureFolders, *folder) == model_.textureFolders.end())
        model_.textureFolders.push_back(*folder);
    return {};
}

Result<void> QcReader::readUpAxis() {
    const auto axis = argument("an axis");
    if (!axis)
        return std::unexpected(axis.error());
    const std::string name = lowerCase(*axis);
    if (name == "y")
        model_.upAxis = UpAxis::Y;
    else if (name == "z")
        model_.upAxis = UpAxis::Z;
    else
        warn("\"" + *axis + "\" cannot be the axis that is up; Z was taken.");
    return {};
}

Result<void> QcReader::readInclude() {
    const auto name = argument("the name of a file");
    if (!name)
        return std::unexpected(name.error());
    if (++includes_ > mostIncludes)
        return error("There are more than " + std::to_string(mostIncludes) +
                     " includes; perhaps a file includes itself.");
    const auto script = include_(*name);
    if (!script) {
        warn("\"" + *name + "\" could not be included and was left out: " + script.error().message);
        return {};
    }
    return readScript(*script);
}

Result<void> QcReader::readMacro() {
    warn("Macros and variables are not read; what depends on this one may be missing.");
    lexer_.skipContinuedLine();
    return {};
}

} // namespace

Result<QcModel> readQc(const QcScript& script, const QcIncluder& include) {
    QcReader reader(include);
    if (auto done = reader.readScript(script); !done)
        return std::unexpected(done.error());
    return reader.finish();
}

} // namespace prizma
