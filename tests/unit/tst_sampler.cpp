// The numbers that Path draws: how evenly they are spread, and that pixels and purposes have their own.
#include "tests/support/kernel_probe.h"
#include "tests/support/statistics.h"

#include <QtTest>

#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr const char* probe = R"(
#include "sampler.clh"
// Points first to first + count of a pixel's dimension.
kernel void squares(uint pixel, uint dimension, uint seed, uint first, uint count, global float2* points) {
    uint i = get_global_id(0);
    Sampler sampler = samplerOf(pixel, first + i, seed);
    if (i < count)
        points[i] = sampleSquare(&sampler, dimension);
}
// `samples` points of each of `pixels` pixels.
kernel void pixelSquares(uint pixels, uint samples, uint dimension, uint seed, global float2* points) {
    uint i = get_global_id(0);
    Sampler sampler = samplerOf(i / samples, i % samples, seed);
    if (i < pixels * samples)
        points[i] = sampleSquare(&sampler, dimension);
}
kernel void pixelChoices(uint pixels, uint samples, uint dimension, uint seed, global float4* points) {
    uint i = get_global_id(0);
    Sampler sampler = samplerOf(i / samples, i % samples, seed);
    if (i < pixels * samples)
        points[i] = (float4)(sampleChoice(&sampler, dimension), 0.0f);
}
)";

struct Point {
    float x, y;
};

struct Choice {
    float x, y, z, padding;
};

/// Integrands over the square with their integrals: smooth, with an edge, with a corner.
struct Integrand {
    const char* name;
    double (*value)(double, double);
    double integral;
};

const Integrand integrands[] = {
    {"smooth", [](double x, double y) { return std::exp(-(x * x + y * y)); }, 0.5577462853510337},
    {"disk", [](double x, double y) { return x * x + y * y < 2 / 3.14159265358979 ? 1.0 : 0.0; }, 0.5},
    {"half", [](double x, double y) { return y < 0.3 + 0.4 * x ? 1.0 : 0.0; }, 0.5},
};

/// Root of the mean squared error of one pixel's estimate.
double errorOf(const std::vector<Point>& points, std::size_t samples, const Integrand& f) {
    double squares = 0;
    const std::size_t pixels = points.size() / samples;
    for (std::size_t p = 0; p < pixels; ++p) {
        double sum = 0;
        for (std::size_t i = 0; i < samples; ++i)
            sum += f.value(points[p * samples + i].x, points[p * samples + i].y);
        const double error = sum / static_cast<double>(samples) - f.integral;
        squares += error * error;
    }
    return std::sqrt(squares / static_cast<double>(pixels));
}

} // namespace

class SamplerTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void powersOfTwoAreNets();
    void errorFallsFasterThanChance();
    void pixelsAreIndependent();
    void dimensionsAreIndependent();
    void choicesAreUniform();
    void seedChangesEverything();

  private:
    std::vector<Point> squares(std::uint32_t pixel, std::uint32_t dimension, std::uint32_t seed,
                               std::uint32_t first, std::uint32_t count) {
        ProbeBuffer<Point> points(*context_, count);
        probe_->run("squares", count, pixel, dimension, seed, first, count, points.buffer());
        return points.download();
    }
    std::vector<Point> pixelSquares(std::uint32_t pixels, std::uint32_t samples, std::uint32_t dimension,
                                    std::uint32_t seed = 0) {
        ProbeBuffer<Point> points(*context_, std::size_t{pixels} * samples);
        probe_->run("pixelSquares", std::size_t{pixels} * samples, pixels, samples, dimension, seed,
                    points.buffer());
        return points.download();
    }

    std::unique_ptr<Context> context_;
    std::unique_ptr<KernelProbe> probe_;
};

void SamplerTest::initTestCase() {
    auto context = Context::create({});
    if (!context)
        QSKIP("There is no OpenCL device here.");
    context_ = std::move(*context);
    probe_ = std::make_unique<KernelProbe>(*context_, probe);
}

void SamplerTest::powersOfTwoAreNets() {
    // Every box of area 2^-m with sides that are powers of two holds exactly one of 2^m points in a row.
    std::mt19937 engine(1);
    const auto random = [&engine](std::uint32_t below) {
        return static_cast<std::uint32_t>(engine() % below);
    };
    for (int round = 0; round < 40; ++round) {
        const std::uint32_t pixel = random(100'000);
        const std::uint32_t dimension = random(50);
        const std::uint32_t seed = random(10);
        for (int m = 0; m <= 10; ++m) {
            const std::uint32_t count = 1u << m;
            const std::uint32_t first = random(1000) * count;
            const std::vector<Point> points = squares(pixel, dimension, seed, first, count);
            for (int wide = 0; wide <= m; ++wide) {
                std::vector<int> boxes(count, 0);
                for (const Point& p : points) {
                    QVERIFY(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
                    const auto column = static_cast<std::uint32_t>(p.x * static_cast<float>(1 << wide));
                    const auto row = static_cast<std::uint32_t>(p.y * static_cast<float>(1 << (m - wide)));
                    ++boxes[(row << wide) + column];
                }
                QVERIFY2(
                    std::ranges::all_of(boxes, [](int n) { return n == 1; }),
                    qPrintable(
                        QString("pixel %1, dimension %2, 2^%3 points").arg(pixel).arg(dimension).arg(m)));
            }
        }
    }
}

void SamplerTest::errorFallsFasterThanChance() {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(0, 1);
    for (const Integrand& f : integrands) {
        double before = 0;
        for (const std::uint32_t samples : {16u, 64u, 256u, 1024u}) {
            const std::uint32_t pixels = 400;
            const double error = errorOf(pixelSquares(pixels, samples, 3), samples, f);
            std::vector<Point> independent(pixels * samples);
            for (Point& p : independent)
                p = {unit(random), unit(random)};
            const double chance = errorOf(independent, samples, f);
            qInfo("%-6s %4u samples: RMS error %.2e, of independent ones %.2e, ratio %.3f", f.name, samples,
                  error, chance, error / chance);
            QVERIFY(error < 0.5 * chance);
            if (before > 0) // chance alone: a half; of 400 pixels the figure is good to 5 %
                QVERIFY2(error < 0.45 * before, qPrintable(QString::number(error / before)));
            before = error;
        }
    }
}

void SamplerTest::pixelsAreIndependent() {
    // The errors of neighbours are not correlated; the limit is that of independent ones.
    const std::uint32_t pixels = 4096;
    const std::uint32_t samples = 8;
    const std::vector<Point> points = pixelSquares(pixels, samples, 1);
    std::vector<double> errors(pixels, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i)
        errors[i / samples] += integrands[0].value(points[i].x, points[i].y) - integrands[0].integral;
    double variance = 0;
    for (const double e : errors)
        variance += e * e / pixels;
    const std::array<std::size_t, 6> distances{1, 2, 3, 4, 16, 64};
    const double limit = twoSidedLimit(sidak(0.01, distances.size())) / std::sqrt(pixels);
    for (const std::size_t distance : distances) {
        double sum = 0;
        for (std::size_t i = 0; i + distance < errors.size(); ++i)
            sum += errors[i] * errors[i + distance] / (variance * pixels);
        qInfo("pixels %zu apart: correlation %+.4f, limit %.4f", distance, sum, limit);
        QVERIFY(std::abs(sum) < limit);
    }
}

void SamplerTest::dimensionsAreIndependent() {
    // Pairs of one number of each of two dimensions fill the square evenly.
    const std::uint32_t pixels = 8192;
    const std::uint32_t samples = 8;
    const std::vector<Point> one = pixelSquares(pixels, samples, 5);
    for (const std::uint32_t other : {0u, 4u, 6u, 11u, 2000u}) {
        const std::vector<Point> two = pixelSquares(pixels, samples, other);
        std::vector<double> counts(256, 0.0);
        for (std::size_t i = 0; i < one.size(); i += samples) // one a pixel: these are independent
            ++counts[static_cast<std::size_t>(one[i].x * 16) * 16 + static_cast<std::size_t>(two[i].x * 16)];
        const std::vector<double> expected(256, pixels / 256.0);
        const double p = chiSquaredTest(counts, expected);
        QVERIFY2(p > sidak(0.01, 5), qPrintable(QString("dimension %1: p = %2").arg(other).arg(p)));
    }
}

void SamplerTest::choicesAreUniform() {
    const std::uint32_t pixels = 64'000;
    ProbeBuffer<Choice> points(*context_, pixels);
    probe_->run("pixelChoices", pixels, pixels, 1u, 7u, 3u, points.buffer());
    std::vector<double> counts(8 * 8 * 8, 0.0);
    for (const Choice& c : points.download())
        ++counts[static_cast<std::size_t>(c.x * 8) * 64 + static_cast<std::size_t>(c.y * 8) * 8 +
                 static_cast<std::size_t>(c.z * 8)];
    const std::vector<double> expected(counts.size(), pixels / 512.0);
    QVERIFY(chiSquaredTest(counts, expected) > 0.01);
}

void SamplerTest::seedChangesEverything() {
    const std::vector<Point> one = pixelSquares(512, 4, 2, 1);
    const std::vector<Point> other = pixelSquares(512, 4, 2, 2);
    QCOMPARE(std::memcmp(one.data(), pixelSquares(512, 4, 2, 1).data(), one.size() * sizeof(Point)), 0);
    int equal = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        equal += one[i].x == other[i].x || one[i].y == other[i].y;
    QVERIFY2(equal <= 2, qPrintable(QString::number(equal))); // by chance 2^-23 each
}

QTEST_GUILESS_MAIN(SamplerTest)
#include "tst_sampler.moc"
