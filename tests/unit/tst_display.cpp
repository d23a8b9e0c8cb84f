// The kernels that turn sums of radiance into pictures, alone.
#include "core/render/film.h"
#include "core/render/kernel_set.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace prizma;

namespace {

double encodeSrgb(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

/// Place of a pixel in the film: tiles of 8 x 8, Morton order inside.
std::size_t placeOf(int x, int y, int width) {
    const int tile = (y / 8) * ((width + 7) / 8) + x / 8;
    int inside = 0;
    for (int bit = 0; bit < 3; ++bit)
        inside |= ((x >> bit) & 1) << (2 * bit) | ((y >> bit) & 1) << (2 * bit + 1);
    return static_cast<std::size_t>(tile) * 64 + static_cast<std::size_t>(inside);
}

} // namespace

class DisplayTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void bytesFollowTheSrgbCurve();
    void valuesThatAreNoColoursStayInRange();
    void meanIsSumOverSamples();

  private:
    static constexpr int width = 203;
    static constexpr int height = 117;

    std::vector<std::uint32_t> toneMapped(const std::vector<float>& sums, float scale);

    std::unique_ptr<Context> context_;
    std::unique_ptr<KernelSet> kernels_;
    Film film_;
};

void DisplayTest::initTestCase() {
    auto context = Context::create({});
    if (!context)
        QSKIP("There is no OpenCL device here.");
    context_ = std::move(*context);
    auto kernels = KernelSet::create(*context_, layoutFor(context_->info().type));
    QVERIFY(kernels);
    kernels_ = std::make_unique<KernelSet>(std::move(*kernels));
    QVERIFY(film_.resize(*context_, width, height));
}

std::vector<std::uint32_t> DisplayTest::toneMapped(const std::vector<float>& sums, float scale) {
    std::vector<std::uint32_t> pixels(width * height);
    kernels_->toneMap.setArguments(film_.sums, film_.display, width, height, scale, film_.encoding);
    if (!film_.sums.write(*context_, sums, 0, "sums") ||
        !kernels_->toneMap.launch(*context_, pixels.size(), kernels_->groupSize) ||
        !film_.display.read(*context_, pixels, 0, "pixels"))
        qFatal("the kernel does not run");
    return pixels;
}

void DisplayTest::bytesFollowTheSrgbCurve() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> exponent(-16.0f, 2.0f);
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount));
    for (float& value : sums)
        value = std::exp2(exponent(random));
    const auto pixels = toneMapped(sums, 0.5f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double linear = 0.5 * sums[4 * placeOf(x, y, width) + static_cast<std::size_t>(c)];
                const double exact = encodeSrgb(std::min(linear, 1.0)) * 255.0;
                const int byte =
                    static_cast<int>(pixels[static_cast<std::size_t>(y * width + x)] >> (8 * c)) & 255;
                QVERIFY2(std::abs(byte - exact) <= 0.5001,
                         qPrintable(QString("%1 became %2").arg(linear).arg(byte)));
            }
}

void DisplayTest::valuesThatAreNoColoursStayInRange() {
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount), 0.0f);
    const float odd[] = {std::nanf(""), -1.0f, -INFINITY, INFINITY, 1e30f, 1e-40f, -0.0f};
    const int expected[] = {0, 0, 0, 255, 255, 0, 0};
    for (int i = 0; i < 7; ++i)
        sums[4 * placeOf(i, 0, width)] = odd[i];
    const auto pixels = toneMapped(sums, 1.0f);
    for (int i = 0; i < 7; ++i)
        QCOMPARE(static_cast<int>(pixels[static_cast<std::size_t>(i)] & 255u), expected[i]);
}

void DisplayTest::meanIsSumOverSamples() {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> value(0.0f, 9.0f);
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount));
    for (float& sum : sums)
        sum = value(random);
    std::vector<float> mean(4 * width * height);
    QVERIFY(film_.mean.reserve(*context_, mean.size(), "mean"));
    QVERIFY(film_.sums.write(*context_, sums, 0, "sums"));
    kernels_->meanRadiance.setArguments(film_.sums, film_.mean, width, height, 0.25f);
    QVERIFY(kernels_->meanRadiance.launch(*context_, mean.size() / 4, kernels_->groupSize));
    QVERIFY(film_.mean.read(*context_, mean, 0, "mean"));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                QCOMPARE(mean[4 * static_cast<std::size_t>(y * width + x) + c],
                         sums[4 * placeOf(x, y, width) + c] * 0.25f);
}

QTEST_GUILESS_MAIN(DisplayTest)
#include "tst_display.moc"
