// Mip levels as the host makes them, and the device's filter over them, against plain filters in double
// precision.
#include "core/compute/kernel.h"
#include "core/compute/program.h"
#include "core/render/mip_levels.h"
#include "core/scene/srgb.h"
#include "kernels/device_types.h"

#include <QFile>
#include <QtTest>

#include <bit>
#include <cmath>
#include <random>

using namespace prizma;

namespace {

using Level = std::vector<glm::dvec4>;

struct Question {
    float u, v;
    float footprint;
    std::uint32_t texture;
    std::int32_t reading;
};

constexpr std::int32_t readColor = 0, readData = 1, readCovered = 2; // TEXELS_... of texture.clh

Image randomImage(int width, int height, bool isFloat, unsigned seed) {
    std::mt19937 random(seed);
    Image image;
    image.width = width;
    image.height = height;
    image.opaque = false;
    const auto values = static_cast<std::size_t>(width * height * 4);
    std::uniform_real_distribution<float> value(0.0F, 3.0F);
    for (std::size_t i = 0; i < values; ++i)
        if (isFloat)
            image.floats.push_back(i % 4 == 3 ? value(random) / 3.0F : value(random));
        else
            image.bytes.push_back(static_cast<std::uint8_t>(random() % 4 == 0 ? 0 : random()));
    return image;
}

bool isColor(TexelUse use) {
    return use == TexelUse::Color || use == TexelUse::OpaqueColor;
}

Level firstLevel(const Image& image, TexelUse use) {
    Level level(static_cast<std::size_t>(image.width * image.height));
    for (std::size_t i = 0; i < level.size(); ++i)
        for (glm::length_t c = 0; c < 4; ++c) {
            const std::size_t place = 4 * i + static_cast<std::size_t>(c);
            const double byte = image.bytes.empty() ? 0.0 : image.bytes[place] / 255.0;
            level[i][c] = !image.bytes.empty() ? (isColor(use) && c < 3 ? decodeSrgb(byte) : byte)
                                               : static_cast<double>(image.floats[place]);
        }
    return level;
}

/// How much of [low, high] lies in texel `i`.
double overlap(int i, double low, double high) {
    return std::max(0.0, std::min(high, i + 1.0) - std::max(low, static_cast<double>(i)));
}

/// Every texel of the level above, weighted by the area that it shares with the texel of the next one.
Level nextLevel(const Level& above, glm::ivec2 from, glm::ivec2 to, TexelUse use) {
    Level level;
    for (int y = 0; y < to.y; ++y)
        for (int x = 0; x < to.x; ++x) {
            glm::dvec4 plain(0.0), covered(0.0);
            for (int j = 0; j < from.y; ++j)
                for (int i = 0; i < from.x; ++i) {
                    const double area =
                        overlap(i, static_cast<double>(x) * from.x / to.x, (x + 1.0) * from.x / to.x) *
                        overlap(j, static_cast<double>(y) * from.y / to.y, (y + 1.0) * from.y / to.y);
                    const glm::dvec4& texel = above[static_cast<std::size_t>(j * from.x + i)];
                    plain += texel * area;
                    covered += glm::dvec4(glm::dvec3(texel) * texel.w, texel.w) * area;
                }
            const double whole = static_cast<double>(from.x) / to.x * from.y / to.y;
            glm::dvec4 mean = plain / whole;
            if (use == TexelUse::Color && covered.w > 0.0)
                mean = glm::dvec4(glm::dvec3(covered) / covered.w, mean.w);
            level.push_back(mean);
        }
    return level;
}

glm::dvec4 unitNormal(const glm::dvec4& texel) {
    const glm::dvec3 n = glm::dvec3(texel) * 2.0 - 1.0;
    return {glm::normalize(n) * 0.5 + 0.5, texel.w};
}

/// A texel as the device sees it, and how far it may be from the exact value: half of the gap to the next
/// code, or float's rounding.
struct Stored {
    glm::dvec4 value{0.0}, slack{0.0};
};

Stored storedTexel(const std::uint32_t* words, std::size_t index, bool isFloat, TexelUse use) {
    Stored stored;
    for (glm::length_t c = 0; c < 4; ++c) {
        if (isFloat) {
            stored.value[c] =
                static_cast<double>(std::bit_cast<float>(words[4 * index + static_cast<std::size_t>(c)]));
            stored.slack[c] = 1e-5 * std::abs(stored.value[c]) + 1e-6;
            continue;
        }
        const auto code = static_cast<int>(words[index] >> (8 * c) & 255U);
        const auto decode = [&](int n) {
            const double encoded = std::clamp(n, 0, 255) / 255.0;
            return isColor(use) && c < 3 ? decodeSrgb(encoded) : encoded;
        };
        stored.value[c] = decode(code);
        stored.slack[c] =
            0.5 * std::max(decode(code + 1) - decode(code), decode(code) - decode(code - 1)) + 1e-5;
    }
    return stored;
}

} // namespace

class MipLevelsTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void sizes();
    void levelsAreMeans_data();
    void levelsAreMeans();
    void maskedEdgesDoNotBleed();
    void meanBrightnessStays();
    void filterOnTheDevice_data();
    void filterOnTheDevice();
    void closeUpIsBilinearToTheBit();

  private:
    std::vector<glm::vec4> answers(const std::vector<Image>& images, TexelUse use,
                                   const std::vector<Question>& questions);

    std::unique_ptr<Context> context_;
    Kernel kernel_;
};

void MipLevelsTest::sizes() {
    QCOMPARE(mipSizes(1, 1).size(), std::size_t(1));
    const std::vector<glm::ivec2> expected{{13, 5}, {6, 2}, {3, 1}, {1, 1}};
    QVERIFY(mipSizes(13, 5) == expected);
    for (const int n : {2, 3, 255, 256, 16384}) // as the device counts them
        QCOMPARE(mipSizes(n, 1).size(), static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(n))));
}

void MipLevelsTest::levelsAreMeans_data() {
    QTest::addColumn<TexelUse>("use");
    QTest::addColumn<bool>("isFloat");
    QTest::newRow("colour") << TexelUse::Color << false;
    QTest::newRow("opaque colour") << TexelUse::OpaqueColor << false;
    QTest::newRow("data") << TexelUse::Data << false;
    QTest::newRow("normals") << TexelUse::Normal << false;
    QTest::newRow("float colour") << TexelUse::Color << true;
    QTest::newRow("float data") << TexelUse::Data << true;
}
void MipLevelsTest::levelsAreMeans() {
    QFETCH(TexelUse, use);
    QFETCH(bool, isFloat);
    unsigned seed = 1;
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), {2, 2}, {3, 3}, {16, 8}, {13, 5}, {1, 17}, {31, 29}, {64, 64}}) {
        const Image image = randomImage(size.x, size.y, isFloat, seed++);
        const auto words = texelWords(image, use);
        const auto sizes = mipSizes(size.x, size.y);
        Level exact = firstLevel(image, use);
        std::size_t offset = 0;
        for (std::size_t l = 0; l < sizes.size(); ++l) {
            if (l > 0)
                exact = nextLevel(exact, sizes[l - 1], sizes[l], use);
            for (std::size_t i = 0; i < exact.size(); ++i) {
                const Stored stored = storedTexel(words.data() + offset, i, isFloat, use);
                const bool isMean = use == TexelUse::Normal && l > 0;
                const glm::dvec4 wanted = isMean ? unitNormal(exact[i]) : exact[i];
                for (glm::length_t c = 0; c < 4; ++c)
                    QVERIFY2(std::abs(stored.value[c] - wanted[c]) <= stored.slack[c],
                             qPrintable(QString("%1 x %2, level %3, texel %4: %5, not %6")
                                            .arg(size.x)
                                            .arg(size.y)
                                            .arg(l)
                                            .arg(i)
                                            .arg(stored.value[c])
                                            .arg(wanted[c])));
            }
            offset += exact.size() * (isFloat ? 4 : 1);
        }
        QCOMPARE(offset, words.size());
    }
}

void MipLevelsTest::maskedEdgesDoNotBleed() {
    // Opaque red among transparent green: whatever is there at any level is red.
    std::mt19937 random(3);
    Image image;
    image.width = 37;
    image.height = 22;
    image.opaque = false;
    for (int i = 0; i < 37 * 22; ++i) {
        const bool there = random() % 3 == 0;
        for (const int value : {there ? 200 : 0, there ? 0 : 255, 0, there ? 255 : 0})
            image.bytes.push_back(static_cast<std::uint8_t>(value));
    }
    std::size_t partly = 0;
    for (const std::uint32_t word : texelWords(image, TexelUse::Color)) {
        const std::uint32_t alpha = word >> 24;
        if (alpha > 0)
            QCOMPARE(word & 0xFFFFFFU, 200U);
        partly += alpha > 0 && alpha < 255 ? 1 : 0;
    }
    QVERIFY(partly > 200);
}

void MipLevelsTest::meanBrightnessStays() {
    // 50 texels on a side lose one at 25 and at 3: none may count more than another.
    const Image image = randomImage(50, 50, true, 9);
    const auto words = texelWords(image, TexelUse::Data);
    double mean = 0.0;
    for (std::size_t i = 0; i < image.floats.size(); i += 4)
        mean += static_cast<double>(image.floats[i]) / 2500.0;
    const auto last = static_cast<double>(std::bit_cast<float>(words[words.size() - 4]));
    QVERIFY2(std::abs(last - mean) < 1e-5 * mean, qPrintable(QString::number(last / mean - 1.0)));
}

std::vector<glm::vec4> MipLevelsTest::answers(const std::vector<Image>& images, TexelUse use,
                                              const std::vector<Question>& questions) {
    if (!context_) {
        auto context = Context::create({});
        if (!context)
            return {};
        context_ = std::move(*context);
        QFile probe(QStringLiteral(PRIZMA_SOURCE_DIR "/tests/support/texture_probe.cl"));
        if (!probe.open(QIODevice::ReadOnly))
            qFatal("no kernel");
        const auto program =
            buildProgram(*context_, "texture_probe.cl", probe.readAll().toStdString(), "-D PRIZMA_WIDE8");
        if (!program)
            qFatal("%s", program.error().message.c_str());
        kernel_ = std::move(*Kernel::create(*program, "filterTextures"));
    }
    std::vector<std::uint32_t> texels;
    for (int code = 0; code < 256; ++code)
        texels.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(decodeSrgb(code / 255.0))));
    std::vector<DeviceTexture> table;
    for (const Image& image : images) {
        const bool isFloat = image.bytes.empty();
        auto offset = static_cast<std::uint32_t>(texels.size());
        for (const glm::ivec2& size : mipSizes(image.width, image.height)) {
            table.push_back({offset, size.x, size.y, isFloat ? 1U : 0U});
            offset += static_cast<std::uint32_t>(size.x * size.y) * (isFloat ? 4U : 1U);
        }
        const auto words = texelWords(image, use);
        texels.insert(texels.end(), words.begin(), words.end());
    }
    Buffer<DeviceTexture> textureBuffer;
    Buffer<std::uint32_t> texelBuffer;
    Buffer<Question> questionBuffer;
    Buffer<glm::vec4> answerBuffer;
    std::vector<glm::vec4> result(questions.size());
    if (!textureBuffer.assign(*context_, table, "textures") ||
        !texelBuffer.assign(*context_, texels, "texels") ||
        !questionBuffer.assign(*context_, questions, "questions") ||
        !answerBuffer.reserve(*context_, questions.size(), "answers"))
        qFatal("no room on the device");
    kernel_.setArguments(textureBuffer, texelBuffer, questionBuffer, answerBuffer,
                         static_cast<std::uint32_t>(questions.size()));
    if (!kernel_.launch(*context_, questions.size(), 64) ||
        !answerBuffer.read(*context_, result, 0, "answers"))
        qFatal("the kernel does not run");
    return result;
}

namespace {

/// The device's filter in double precision, over the texels that it has.
class ReferenceFilter {
  public:
    ReferenceFilter(const Image& image, TexelUse use, std::int32_t reading) : reading_(reading) {
        sizes_ = mipSizes(image.width, image.height);
        const bool isFloat = image.bytes.empty();
        const auto words = texelWords(image, use);
        std::size_t offset = 0;
        for (const glm::ivec2& size : sizes_) {
            Level level;
            for (std::size_t i = 0; i < static_cast<std::size_t>(size.x * size.y); ++i)
                level.push_back(storedTexel(words.data() + offset, i, isFloat,
                                            reading == readData ? TexelUse::Data : TexelUse::Color)
                                    .value);
            offset += level.size() * (isFloat ? 4 : 1);
            levels_.push_back(std::move(level));
        }
    }

    glm::dvec4 at(double u, double v, double footprint) const {
        const double texels = footprint * std::sqrt(static_cast<double>(sizes_[0].x) * sizes_[0].y);
        const double depth = std::clamp(std::log2(texels), 0.0, static_cast<double>(levels_.size()) - 1.0);
        const auto whole = static_cast<std::size_t>(depth);
        const double part = depth - static_cast<double>(whole);
        glm::dvec4 value = bilinear(whole, u, v);
        if (part > 0.0)
            value = glm::mix(value, bilinear(whole + 1, u, v), part);
        if (reading_ == readCovered && value.w > 0.0)
            value = glm::dvec4(glm::dvec3(value) / value.w, value.w);
        return value;
    }

  private:
    glm::dvec4 texel(std::size_t level, int x, int y) const {
        const glm::ivec2 size = sizes_[level];
        x = (x % size.x + size.x) % size.x;
        y = (y % size.y + size.y) % size.y;
        glm::dvec4 value = levels_[level][static_cast<std::size_t>(y * size.x + x)];
        if (reading_ == readCovered)
            value = glm::dvec4(glm::dvec3(value) * value.w, value.w);
        return value;
    }

    glm::dvec4 bilinear(std::size_t level, double u, double v) const {
        const double x = (u - std::floor(u)) * sizes_[level].x - 0.5;
        const double y = (1.0 - (v - std::floor(v))) * sizes_[level].y - 0.5;
        const int x0 = static_cast<int>(std::floor(x));
        const int y0 = static_cast<int>(std::floor(y));
        return glm::mix(glm::mix(texel(level, x0, y0), texel(level, x0 + 1, y0), x - x0),
                        glm::mix(texel(level, x0, y0 + 1), texel(level, x0 + 1, y0 + 1), x - x0), y - y0);
    }

    std::vector<glm::ivec2> sizes_;
    std::vector<Level> levels_;
    std::int32_t reading_;
};

} // namespace

void MipLevelsTest::filterOnTheDevice_data() {
    QTest::addColumn<std::int32_t>("reading");
    QTest::addColumn<bool>("isFloat");
    QTest::newRow("colour") << readColor << false;
    QTest::newRow("data") << readData << false;
    QTest::newRow("covered") << readCovered << false;
    QTest::newRow("float colour") << readColor << true;
    QTest::newRow("float covered") << readCovered << true;
}
void MipLevelsTest::filterOnTheDevice() {
    QFETCH(std::int32_t, reading);
    QFETCH(bool, isFloat);
    const TexelUse use = reading == readData ? TexelUse::Data : TexelUse::Color;
    std::vector<Image> images;
    std::vector<std::uint32_t> first;
    std::uint32_t next = 0;
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {16, 16}, {37, 5}, {1, 30}}) {
        images.push_back(randomImage(size.x, size.y, isFloat, static_cast<unsigned>(size.x)));
        first.push_back(next);
        next += static_cast<std::uint32_t>(mipSizes(size.x, size.y).size());
    }
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-3.0F, 3.0F), size(-9.0F, 3.0F);
    std::vector<Question> questions;
    std::vector<std::size_t> asked;
    for (int i = 0; i < 20'000; ++i) {
        asked.push_back(random() % images.size());
        questions.push_back(
            {place(random), place(random), std::exp2(size(random)), first[asked.back()], reading});
    }
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const auto& [u, v, footprint] : {std::tuple{nan, 0.5F, 0.1F},
                                          {0.5F, infinity, 0.1F},
                                          {-1e30F, 1e30F, 0.1F},
                                          {0.5F, 0.5F, nan},
                                          {0.5F, 0.5F, infinity},
                                          {0.0F, 1.0F, 0.0F}}) {
        asked.push_back(1);
        questions.push_back({u, v, footprint, first[1], reading});
    }
    const auto found = answers(images, use, questions);
    if (found.empty())
        QSKIP("There is no OpenCL device here.");
    std::vector<ReferenceFilter> filters;
    for (const Image& image : images)
        filters.emplace_back(image, use, reading);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Question& q = questions[i];
        QVERIFY(std::isfinite(found[i].x + found[i].y + found[i].z + found[i].w));
        if (i >= 20'000)
            continue;
        const glm::dvec4 wanted = filters[asked[i]].at(static_cast<double>(q.u), static_cast<double>(q.v),
                                                       static_cast<double>(q.footprint));
        for (glm::length_t c = 0; c < 4; ++c) {
            // A place is known to 2^-22 of the picture, and neighbours differ by 3 at most. What is all but
            // transparent has a colour that is all but unknown.
            const double slack = reading == readCovered && c < 3 ? 3e-4 / std::max(wanted.w, 1e-3) : 3e-4;
            QVERIFY2(
                std::abs(static_cast<double>(found[i][c]) - wanted[c]) < slack,
                qPrintable(
                    QString("%1: %2, not %3").arg(i).arg(static_cast<double>(found[i][c])).arg(wanted[c])));
        }
    }
}

void MipLevelsTest::closeUpIsBilinearToTheBit() {
    std::mt19937 random(12);
    std::uniform_real_distribution<float> place(-2.0F, 2.0F), share(0.0F, 1.0F);
    const std::vector<Image> images{randomImage(23, 40, false, 1)};
    const float texel = 1.0F / std::sqrt(23.0F * 40.0F);
    std::vector<Question> filtered, plain;
    for (int i = 0; i < 5000; ++i) {
        filtered.push_back({place(random), place(random), 0.999F * texel * share(random), 0, readColor});
        plain.push_back(filtered.back());
        plain.back().reading = -1;
    }
    const auto a = answers(images, TexelUse::Color, filtered);
    if (a.empty())
        QSKIP("There is no OpenCL device here.");
    QVERIFY(a == answers(images, TexelUse::Color, plain));
}

QTEST_GUILESS_MAIN(MipLevelsTest)
#include "tst_mip_levels.moc"
