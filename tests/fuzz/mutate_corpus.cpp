// Stands in for libFuzzer where there is no clang: runs the harness over all files of the given folders, then
// over mutations of them for a time. Usage: mutate_corpus SECONDS FOLDER...
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t longestMutation = 20'000; ///< Short texts are quick and get at the same code.
constexpr double slowestInput = 5.0;            ///< Seconds of the processor.

const char* const pieces[] = {"end\n",
                              "nodes\n",
                              "skeleton\n",
                              "triangles\n",
                              "vertexanimation\n",
                              "time 0\n",
                              "time 2147483647\n",
                              "-1",
                              "999999999999",
                              "1e38",
                              "nan",
                              "-inf",
                              "1e-400",
                              "\"",
                              "{",
                              "}",
                              "$sequence ",
                              "$include \"",
                              "$bodygroup ",
                              "/*",
                              "//",
                              "\r",
                              "\n",
                              "\xEF\xBB\xBF",
                              "flexfile "};

std::vector<std::string> readFolders(int count, char** folders) {
    std::vector<std::string> texts;
    for (int i = 0; i < count; ++i) {
        std::error_code error;
        for (std::filesystem::recursive_directory_iterator entry(folders[i], error), end;
             !error && entry != end; entry.increment(error)) {
            if (!entry->is_regular_file())
                continue;
            const auto extension = entry->path().extension();
            if (extension != ".smd" && extension != ".qc" && extension != ".qci" && extension != ".vta")
                continue;
            std::ifstream stream(entry->path(), std::ios::binary);
            texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
        }
    }
    std::ranges::sort(texts); // the same order everywhere
    return texts;
}

/// Seconds of the processor, which are no more on a busy machine.
double run(const std::string& text) {
    const std::clock_t start = std::clock();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A window of a text with a few changes, among them pieces of another one.
std::string mutation(const std::vector<std::string>& texts, std::mt19937& random) {
    const auto below = [&](std::size_t limit) { return limit == 0 ? 0 : random() % limit; };
    const std::string& source = texts[below(texts.size())];
    std::string text = source.substr(0, longestMutation);
    if (below(4) == 0) // head and tail: the triangles of long files come late
        text = source.substr(0, 3000) +
               source.substr(source.size() - std::min<std::size_t>(source.size(), 3000));
    for (std::size_t i = 1 + below(6); i > 0; --i) {
        const std::size_t at = below(text.size() + 1);
        const std::string& other = texts[below(texts.size())];
        switch (below(6)) {
        case 0:
            text.insert(at, 1, static_cast<char>(below(256)));
            break;
        case 1:
            text.erase(at, below(40));
            break;
        case 2:
            text.insert(at, pieces[below(std::size(pieces))]);
            break;
        case 3:
            text.insert(at, other.substr(below(other.size()), below(400)));
            break;
        case 4:
            text.resize(at);
            break;
        default:
            text.replace(at, std::min<std::size_t>(4, text.size() - at), std::to_string(random()));
            break;
        }
    }
    return text;
}

} // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "usage: %s SECONDS FOLDER...\n", arguments[0]);
        return 2;
    }
    const double seconds = std::atof(arguments[1]);
    const auto texts = readFolders(count - 2, arguments + 2);
    if (texts.empty()) {
        std::fprintf(stderr, "there are no files to begin with\n");
        return 1;
    }
    double slowest = 0.0;
    for (const std::string& text : texts)
        slowest = std::max(slowest, run(text));
    std::mt19937 random(20191);
    std::size_t runs = 0;
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds) {
        slowest = std::max(slowest, run(mutation(texts, random)));
        ++runs;
    }
    std::printf("%zu files and %zu mutations, the slowest %.3f s\n", texts.size(), runs, slowest);
    return slowest < slowestInput ? 0 : 1;
}
