// The preview's denoiser alone: synthetic guides and noise with known truth.
#include "core/render/preview_denoiser.h"
#include "tests/support/film_order.h"

#include <QtTest>

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

struct Surface {
    glm::vec3 normal{0.0f, 0.0f, 1.0f};
    glm::vec3 position{0.0f};
    glm::vec3 albedo{1.0f};
    float footprint = 0.01f; ///< 0: the background.
};

/// A wall that faces the camera, a pixel to a hundredth.
Surface wall(int x, int y) {
    return {{0.0f, 0.0f, 1.0f}, {0.01f * static_cast<float>(x), 0.01f * static_cast<float>(y), -5.0f}};
}

using SurfaceAt = std::function<Surface(int, int)>;
using ColorAt = std::function<glm::vec3(int, int)>;

} // namespace

class PreviewDenoiserTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void constantStaysConstant();
    void noiseFalls_data();
    void noiseFalls();
    void edgesStay_data();
    void edgesStay();
    void textureStaysSharp();
    void backgroundIsLeftAlone();
    void whatIsNoNumberDoesNotSpread();
    void convergedPictureIsLeftAlone();
    void newGuidesForgetTheScatter();
    void timeOfAPicture();

  private:
    void setSurfaces(int width, int height, const SurfaceAt& at);
    void addSamples(const ColorAt& truth, double deviation, int samples);
    std::vector<glm::vec3> denoised();
    std::vector<glm::vec3> noisy() const;
    double errorOf(const std::vector<glm::vec3>& picture, const ColorAt& truth) const;

    std::unique_ptr<Context> context_;
    std::unique_ptr<KernelSet> kernels_;
    std::optional<PreviewDenoiser> denoiser_;
    int width_ = 0, height_ = 0, samples_ = 0;
    std::vector<float> sums_;
    std::mt19937 random_;
};

void PreviewDenoiserTest::initTestCase() {
    auto context = Context::create({});
    if (!context)
        QSKIP("There is no OpenCL device here.");
    context_ = std::move(*context);
    const TreeLayout layout = layoutFor(context_->info().type);
    auto kernels = KernelSet::create(*context_, layout);
    QVERIFY(kernels);
    kernels_ = std::make_unique<KernelSet>(std::move(*kernels));
    auto made = PreviewDenoiser::create(*context_, layout, kernels_->groupSize);
    QVERIFY2(made, made ? "" : made.error().message.c_str());
    denoiser_ = std::move(*made);
}

void PreviewDenoiserTest::setSurfaces(int width, int height, const SurfaceAt& at) {
    width_ = width;
    height_ = height;
    samples_ = 0;
    random_.seed(11);
    const auto tiles = static_cast<std::size_t>((width + 7) / 8) * static_cast<std::size_t>((height + 7) / 8);
    sums_.assign(4 * 64 * tiles, 0.0f);
    const std::size_t plane = PreviewDenoiser::places(width, height);
    const std::size_t stride = plane / static_cast<std::size_t>(height);
    std::vector<float> planes(PreviewDenoiser::guidePlanes * plane, 0.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Surface s = at(x, y);
            const std::array<float, 10> values{s.normal.x,   s.normal.y,   s.normal.z,  s.position.x,
                                               s.position.y, s.position.z, s.footprint, s.albedo.x,
                                               s.albedo.y,   s.albedo.z};
            const std::size_t place =
                static_cast<std::size_t>(y) * stride + PRIZMA_DENOISE_MARGIN + static_cast<std::size_t>(x);
            for (std::size_t i = 0; i < values.size(); ++i)
                planes[i * plane + place] = values[i];
        }
    QVERIFY(denoiser_->setGuides(*context_, width, height, planes));
}

/// Samples of a path tracer's kind: most are dark and a few bright, with the truth as their mean.
void PreviewDenoiserTest::addSamples(const ColorAt& truth, double deviation, int samples) {
    // Bernoulli with probability p has the deviation sqrt((1 - p) / p) relative to its mean.
    const double p = 1.0 / (1.0 + deviation * deviation);
    std::bernoulli_distribution hit(p);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            for (int i = 0; i < samples; ++i) {
                const glm::vec3 value =
                    deviation > 0.0 ? (hit(random_) ? truth(x, y) / static_cast<float>(p) : glm::vec3(0.0f))
                                    : truth(x, y);
                for (int c = 0; c < 3; ++c)
                    sums_[4 * placeInFilm(x, y, width_) + static_cast<std::size_t>(c)] += value[c];
            }
    samples_ += samples;
}

std::vector<glm::vec3> PreviewDenoiserTest::denoised() {
    Buffer<float> sums;
    PictureDisplay display;
    std::vector<glm::vec3> picture;
    if (!sums.assign(*context_, sums_, "sums"))
        qFatal("the sums cannot be written");
    const auto smooth = denoiser_->denoise(*context_, {sums, width_, height_, samples_});
    if (!smooth)
        qFatal("the denoiser does not run: %s", smooth.error().message.c_str());
    const auto mean = display.mean(*context_, *kernels_, *smooth);
    if (!mean)
        qFatal("no picture");
    for (std::size_t i = 0; i < mean->size(); i += 4)
        picture.emplace_back((*mean)[i], (*mean)[i + 1], (*mean)[i + 2]);
    return picture;
}

std::vector<glm::vec3> PreviewDenoiserTest::noisy() const {
    std::vector<glm::vec3> picture;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const float* sum = &sums_[4 * placeInFilm(x, y, width_)];
            picture.push_back(glm::vec3(sum[0], sum[1], sum[2]) / static_cast<float>(samples_));
        }
    return picture;
}

/// Mean squared error, relative to the truth's square.
double PreviewDenoiserTest::errorOf(const std::vector<glm::vec3>& picture, const ColorAt& truth) const {
    double error = 0.0;
    double all = 0.0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const glm::vec3 off = picture[static_cast<std::size_t>(y * width_ + x)] - truth(x, y);
            error += glm::dot(off, off);
            all += glm::dot(truth(x, y), truth(x, y));
        }
    return error / all;
}

void PreviewDenoiserTest::constantStaysConstant() {
    const glm::vec3 color(0.3f, 0.7f, 1.9f);
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {64, 48}, {203, 117}}) {
        setSurfaces(width, height, wall);
        for (int batch = 0; batch < 6; ++batch) {
            addSamples([&](int, int) { return color; }, 0.0, 1);
            for (const glm::vec3& pixel : denoised())
                QVERIFY(glm::length(pixel - color) < 1e-5f);
        }
    }
}

void PreviewDenoiserTest::noiseFalls_data() {
    QTest::addColumn<int>("calls"); // how often the picture is shown, with a sample more each time
    QTest::addColumn<double>("factor");
    QTest::newRow("one sample") << 1 << 20.0;
    QTest::newRow("three samples") << 3 << 20.0;
    QTest::newRow("eight samples") << 8 << 20.0;
    QTest::newRow("32 samples") << 32 << 20.0;
}

void PreviewDenoiserTest::noiseFalls() {
    QFETCH(int, calls);
    QFETCH(double, factor);
    const ColorAt truth = [](int x, int y) { // a slow gradient, as of a lamp's light
        return glm::vec3(0.5f, 0.4f, 0.3f) * (1.0f + 0.002f * static_cast<float>(x + y));
    };
    setSurfaces(160, 120, wall);
    std::vector<glm::vec3> smooth;
    for (int i = 0; i < calls; ++i) {
        addSamples(truth, 1.0, 1);
        smooth = denoised();
    }
    const double before = errorOf(noisy(), truth);
    const double after = errorOf(smooth, truth);
    qInfo("error %.4f before, %.5f after: %.0f times less", before, after, before / after);
    QVERIFY(after * factor < before);
}

void PreviewDenoiserTest::edgesStay_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("normal") << 0;
    QTest::newRow("depth") << 1;
    QTest::newRow("colour") << 2;
}

/// Two surfaces side by side, one lit four times as brightly: what the light of one leaks onto the other
/// near the edge stays small against the step.
void PreviewDenoiserTest::edgesStay() {
    QFETCH(int, kind);
    constexpr int edge = 61;
    setSurfaces(128, 64, [&](int x, int y) {
        Surface s = wall(x, y);
        if (x >= edge && kind == 0)
            s.normal = glm::normalize(glm::vec3(1.0f, 0.0f, 1.0f));
        if (x >= edge && kind == 1)
            s.position.z = -6.0f;
        if (x >= edge && kind == 2)
            s.albedo = {0.1f, 0.1f, 0.9f};
        return s;
    });
    const ColorAt truth = [](int x, int) { return glm::vec3(x < edge ? 0.2f : 0.8f); };
    for (int i = 0; i < 2; ++i)
        addSamples(truth, 1.0, 4);
    const auto smooth = denoised();
    double left = 0.0;
    double right = 0.0;
    for (int y = 0; y < height_; ++y) {
        left += double(smooth[static_cast<std::size_t>(y * width_ + edge - 1)].y) / height_;
        right += double(smooth[static_cast<std::size_t>(y * width_ + edge)].y) / height_;
    }
    qInfo("%.3f | %.3f instead of 0.2 | 0.8", left, right);
    QVERIFY(std::abs(left - 0.2) < 0.03);
    QVERIFY(std::abs(right - 0.8) < 0.06);
    QVERIFY(errorOf(smooth, truth) * 8.0 < errorOf(noisy(), truth));
}

/// The surface's own colour is divided out and comes back whole.
void PreviewDenoiserTest::textureStaysSharp() {
    const auto albedo = [](int x, int y) {
        return (x + y) % 2 == 0 ? glm::vec3(0.45f, 0.4f, 0.35f) : glm::vec3(0.3f, 0.35f, 0.4f);
    };
    setSurfaces(96, 64, [&](int x, int y) {
        Surface s = wall(x, y);
        s.albedo = albedo(x, y);
        return s;
    });
    const ColorAt truth = [&](int x, int y) { return albedo(x, y) * 0.7f; };
    addSamples(truth, 1.0, 4);
    const auto smooth = denoised();
    const double after = errorOf(smooth, truth);
    qInfo("%.0f times less", errorOf(noisy(), truth) / after);
    QVERIFY(after * 20.0 < errorOf(noisy(), truth));
}

void PreviewDenoiserTest::backgroundIsLeftAlone() {
    setSurfaces(80, 40, [](int x, int y) {
        Surface s = wall(x, y);
        if (x < 20)
            s.footprint = 0.0f;
        return s;
    });
    addSamples([](int x, int) { return glm::vec3(x < 20 ? 3.0f : 0.1f); }, 0.7, 2);
    const auto smooth = denoised();
    const auto before = noisy();
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const auto i = static_cast<std::size_t>(y * width_ + x);
            if (x < 20)
                QVERIFY(glm::length(smooth[i] - before[i]) <= 1e-6f * glm::length(before[i]));
            else
                QVERIFY(smooth[i].y < 1.0f); // nothing of the sky came over the edge
        }
}

void PreviewDenoiserTest::whatIsNoNumberDoesNotSpread() {
    setSurfaces(64, 64, wall);
    const ColorAt truth = [](int, int) { return glm::vec3(0.5f); };
    for (int call = 0; call < 6; ++call) {
        addSamples(truth, 0.5, 2);
        sums_[4 * placeInFilm(30, 31, width_)] = std::nanf("");
        sums_[4 * placeInFilm(7, 8, width_) + 1] = INFINITY;
        const auto smooth = denoised();
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const glm::vec3 pixel = smooth[static_cast<std::size_t>(y * width_ + x)];
                const bool isOdd = (x == 30 && y == 31) || (x == 7 && y == 8);
                // The odd ones stay to be seen: a preview hides no fault.
                QCOMPARE(std::isfinite(pixel.x + pixel.y + pixel.z), !isOdd);
                if (!isOdd)
                    QVERIFY(std::abs(pixel.x - 0.5f) < 0.5f);
            }
    }
}

/// Details that no guide knows, such as a shadow's edge, stay once the samples agree about them.
void PreviewDenoiserTest::convergedPictureIsLeftAlone() {
    setSurfaces(96, 64, wall);
    const ColorAt truth = [](int x, int y) { return glm::vec3((x / 3 + y / 5) % 2 == 0 ? 0.2f : 0.5f); };
    for (int call = 0; call < 8; ++call) {
        addSamples(truth, 0.0, 4);
        denoised();
    }
    const double error = errorOf(denoised(), truth);
    qInfo("error %.2g", error);
    QVERIFY(error < 1e-6);
}

void PreviewDenoiserTest::newGuidesForgetTheScatter() {
    const ColorAt truth = [](int, int) { return glm::vec3(0.5f); };
    const auto first = [&] {
        setSurfaces(48, 32, wall);
        addSamples(truth, 1.0, 2);
        return denoised();
    };
    const auto fresh = first();
    for (int i = 0; i < 7; ++i) {
        addSamples(truth, 1.0, 2);
        denoised();
    }
    const auto again = first();
    for (std::size_t i = 0; i < fresh.size(); ++i)
        QCOMPARE(fresh[i], again[i]);
}

void PreviewDenoiserTest::timeOfAPicture() {
    setSurfaces(1280, 720, wall);
    const ColorAt truth = [](int, int) { return glm::vec3(0.5f); };
    addSamples(truth, 1.0, 1);
    for (int i = 0; i < 5; ++i) {
        denoised();
        qInfo("%s: %.1f ms at 1280 x 720", i == 0 ? "first" : "again", denoiser_->milliseconds());
        samples_ += 1;
    }
    QVERIFY(denoiser_->milliseconds() > 0.0);
}

QTEST_GUILESS_MAIN(PreviewDenoiserTest)
#include "tst_preview_denoiser.moc"
