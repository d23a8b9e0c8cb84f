// The kernels that turn sums of radiance into pictures, alone.
#include "core/render/film.h"
#include "core/render/kernel_set.h"
#include "core/render/picture_display.h"
#include "core/render/view_transform.h"
#include "core/scene/srgb.h"
#include "tests/support/film_order.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace prizma;
using namespace prizma::test;

class DisplayTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void bytesFollowTheSrgbCurve();
    void filmicFollowsItsExactForm();
    void deepPicturesFollowBothViews_data();
    void deepPicturesFollowBothViews();
    void valuesThatAreNoColoursStayInRange();
    void filmicKeepsBlackAndMiddleGrey();
    void filmicRisesAndFadesToWhite();
    void meanIsSumOverSamples();

  private:
    static constexpr int width = 203;
    static constexpr int height = 117;

    std::vector<float> randomSums(unsigned seed, float low, float high) const;
    SummedPicture picture(const std::vector<float>& sums, int samples);
    static RenderSettings settings(ViewTransform transform, double exposure = 0.0);

    std::unique_ptr<Context> context_;
    std::unique_ptr<KernelSet> kernels_;
    Film film_;
    PictureDisplay display_;
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

/// Powers of two, evenly from 2^low to 2^high.
std::vector<float> DisplayTest::randomSums(unsigned seed, float low, float high) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(low, high);
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount));
    for (float& value : sums)
        value = std::exp2(exponent(random));
    return sums;
}

SummedPicture DisplayTest::picture(const std::vector<float>& sums, int samples) {
    if (!film_.sums.write(*context_, sums, 0, "sums"))
        qFatal("the sums cannot be written");
    return {film_.sums, width, height, samples};
}

RenderSettings DisplayTest::settings(ViewTransform transform, double exposure) {
    RenderSettings settings;
    settings.viewTransform = transform;
    settings.exposure = exposure;
    return settings;
}

void DisplayTest::bytesFollowTheSrgbCurve() {
    const auto sums = randomSums(5, -16.0f, 2.0f);
    const auto bytes =
        display_.bytes(*context_, *kernels_, picture(sums, 4), settings(ViewTransform::Standard, 1.0));
    QVERIFY(bytes);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const double linear = 0.5 * sums[4 * placeInFilm(x, y, width) + c];
                const double exact = encodeSrgb(std::min(linear, 1.0)) * 255.0;
                const int byte = (*bytes)[4 * static_cast<std::size_t>(y * width + x) + c];
                QVERIFY2(std::abs(byte - exact) <= 0.5001,
                         qPrintable(QString("%1 became %2").arg(linear).arg(byte)));
            }
}

void DisplayTest::filmicFollowsItsExactForm() {
    const auto sums = randomSums(7, -16.0f, 7.0f);
    const auto bytes =
        display_.bytes(*context_, *kernels_, picture(sums, 2), settings(ViewTransform::Filmic, 0.5));
    QVERIFY(bytes);
    double worst = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* sum = &sums[4 * placeInFilm(x, y, width)];
            const glm::dvec3 exact = displayColor(glm::dvec3(sum[0], sum[1], sum[2]) * (std::exp2(0.5) / 2.0),
                                                  ViewTransform::Filmic);
            for (int c = 0; c < 3; ++c) {
                const int byte =
                    (*bytes)[4 * static_cast<std::size_t>(y * width + x) + static_cast<std::size_t>(c)];
                worst = std::max(worst, std::abs(byte - encodeSrgb(exact[c]) * 255.0));
            }
        }
    qInfo("worst: %.5f of a byte's step", worst);
    QVERIFY(worst <= 0.502); // half a step of rounding, and a little for the table
}

void DisplayTest::deepPicturesFollowBothViews_data() {
    QTest::addColumn<ViewTransform>("transform");
    QTest::newRow("standard") << ViewTransform::Standard;
    QTest::newRow("filmic") << ViewTransform::Filmic;
}

void DisplayTest::deepPicturesFollowBothViews() {
    QFETCH(ViewTransform, transform);
    const auto sums = randomSums(8, -16.0f, 5.0f);
    const auto words = display_.words(*context_, *kernels_, picture(sums, 3), settings(transform, -1.0));
    QVERIFY(words);
    double worst = 0.0;
    std::size_t notBytes = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* sum = &sums[4 * placeInFilm(x, y, width)];
            const glm::dvec3 exact =
                displayColor(glm::dvec3(sum[0], sum[1], sum[2]) * (0.5 / 3.0), transform);
            const std::uint16_t* word = &(*words)[4 * static_cast<std::size_t>(y * width + x)];
            QCOMPARE(word[3], std::uint16_t(65535));
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(word[c] - encodeSrgb(exact[c]) * 65535.0));
                notBytes += word[c] % 257 != 0 ? 1 : 0;
            }
        }
    qInfo("worst: %.3f of 65535", worst);
    QVERIFY(worst <= 1.5);
    QVERIFY(notBytes > words->size() / 4); // they are no bytes made wide
}

void DisplayTest::valuesThatAreNoColoursStayInRange() {
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount), 0.0f);
    const float odd[] = {std::nanf(""), -1.0f, -INFINITY, INFINITY, 1e30f, 1e-40f, -0.0f};
    const int expected[] = {0, 0, 0, 255, 255, 0, 0};
    for (int i = 0; i < 7; ++i)
        sums[4 * placeInFilm(i, 0, width)] = odd[i];
    const auto standard =
        display_.bytes(*context_, *kernels_, picture(sums, 1), settings(ViewTransform::Standard));
    const auto filmic =
        display_.bytes(*context_, *kernels_, picture(sums, 1), settings(ViewTransform::Filmic));
    const auto deep = display_.words(*context_, *kernels_, picture(sums, 1), settings(ViewTransform::Filmic));
    QVERIFY(standard && filmic && deep);
    for (std::size_t i = 0; i < 7; ++i) {
        QCOMPARE(static_cast<int>((*standard)[4 * i]), expected[i]);
        QCOMPARE(static_cast<int>((*filmic)[4 * i]), expected[i]);
        QCOMPARE(static_cast<int>((*deep)[4 * i]), expected[i] * 257);
        QCOMPARE(static_cast<int>((*filmic)[4 * i + 3]), 255);
        if (expected[i] == 0) // what is no number does not colour the other channels
            QCOMPARE(static_cast<int>((*filmic)[4 * i + 1]), 0);
    }
}

void DisplayTest::filmicKeepsBlackAndMiddleGrey() {
    const auto grey = [](double x) { return displayColor(glm::dvec3(x), ViewTransform::Filmic); };
    QCOMPARE(grey(0.0), glm::dvec3(0.0));
    QCOMPARE(grey(NAN), glm::dvec3(0.0));
    for (int c = 0; c < 3; ++c) {
        QVERIFY(std::abs(grey(0.18)[c] - 0.18) < 1e-12);
        QVERIFY(std::abs(grey(20.0)[c] - 1.0) < 1e-12);
        // The slope at the pivot is 2.4 over the range of 16.5 stops, of a value encoded with 2.4.
        const double up = std::pow(grey(0.18 * std::exp2(0.01))[c], 1.0 / 2.4);
        const double down = std::pow(grey(0.18 * std::exp2(-0.01))[c], 1.0 / 2.4);
        QVERIFY(std::abs((up - down) / 0.02 - 2.4 / 16.5) < 1e-4);
    }
}

void DisplayTest::filmicRisesAndFadesToWhite() {
    const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 color(value(random), value(random), value(random));
        double before = -1.0;
        for (double stops = -14.0; stops < 12.0; stops += 0.125) {
            const glm::dvec3 shown = displayColor(color * std::exp2(stops), ViewTransform::Filmic);
            const double luminance = glm::dot(shown, weights);
            QVERIFY(luminance >= before - 1e-6);
            before = luminance;
        }
        QVERIFY(before > 0.95);
    }
    double before = -1.0;
    for (double x = 0.0; x < 40.0; x += 0.01) {
        const double shown = displayColor(glm::dvec3(x), ViewTransform::Filmic).x;
        QVERIFY(shown >= before - 1e-12);
        before = shown;
    }
    // A lamp's red does not stay a primary: the other channels come up.
    const glm::dvec3 bright = displayColor({50.0, 2.0, 1.0}, ViewTransform::Filmic);
    QVERIFY(bright.x > 0.9 && bright.y > 0.2 && bright.z > 0.2);
}

void DisplayTest::meanIsSumOverSamples() {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> value(0.0f, 9.0f);
    std::vector<float> sums(4 * static_cast<std::size_t>(film_.pixelCount));
    for (float& sum : sums)
        sum = value(random);
    const auto mean = display_.mean(*context_, *kernels_, picture(sums, 4));
    QVERIFY(mean);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                QCOMPARE((*mean)[4 * static_cast<std::size_t>(y * width + x) + c],
                         sums[4 * placeInFilm(x, y, width) + c] * 0.25f);
}

QTEST_GUILESS_MAIN(DisplayTest)
#include "tst_display.moc"
