// BSDFs by themselves: the density of sampling, energy, reciprocity, odd input.
#include "tests/support/kernel_probe.h"
#include "tests/support/statistics.h"

#include <QFile>
#include <QtTest>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <array>
#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr double pi = glm::pi<double>();
// ALBEDO_ERROR and ALBEDO_GRAZING_ERROR of kernels/bsdf_albedo.clh
double tableError(double cosine) {
    return cosine < 0.1 ? 0.025 : 0.008;
}

// As in tests/support/bsdf_probe.cl.
struct Question {
    float baseColor[3] = {1, 1, 1};
    float specular = 1, metallic = 0, roughness = 0.5f, transmission = 0, ior = 1.5f;
    float specularColor[3] = {1, 1, 1};
    std::uint32_t entering = 1;
    float normal[3] = {0, 0, 1};
    float geometricNormal[3] = {0, 0, 1};
    float toEye[3] = {0, 0, 1};
};

struct Sample {
    float direction[3];
    float pdf;
    float weight[3];
    std::uint32_t isDelta;
    float value[3];
    float valuePdf;
    std::uint32_t transmitted;
};

struct Four {
    float x, y, z, w;
};

struct NamedMaterial {
    const char* name;
    Question material;
    bool isWhite; // neither the material nor a table's end keeps it from sending back all light
};

std::vector<NamedMaterial> materials() {
    const auto make = [](auto change) {
        Question q;
        change(q);
        return q;
    };
    return {
        {"lambert", make([](Question& q) { q.specular = 0; }), true},
        {"white plastic", make([](Question&) {}), true},
        {"dense plastic", make([](Question& q) { q.ior = 2.4f; }), true},
        {"blue plastic", make([](Question& q) {
             q.baseColor[0] = 0.1f, q.baseColor[1] = 0.2f, q.baseColor[2] = 0.7f;
             q.specular = 0.6f;
             q.specularColor[1] = 0.5f;
         }),
         false},
        {"white metal", make([](Question& q) { q.metallic = 1; }), true},
        {"copper", make([](Question& q) {
             q.metallic = 1;
             q.baseColor[0] = 0.96f, q.baseColor[1] = 0.64f, q.baseColor[2] = 0.54f;
         }),
         false},
        {"glass from outside", make([](Question& q) { q.transmission = 1; }), true},
        {"glass from inside", make([](Question& q) { q.transmission = 1, q.entering = 0; }), true},
        {"diamond from outside", make([](Question& q) { q.transmission = 1, q.ior = 2.42f; }), true},
        {"diamond from inside", make([](Question& q) { q.transmission = 1, q.ior = 2.42f, q.entering = 0; }),
         true},
        {"tinted glass", make([](Question& q) {
             q.transmission = 1, q.baseColor[0] = 0.5f;
             q.specular = 0;
         }),
         false},
        {"a bit of everything", make([](Question& q) {
             q.transmission = 0.5f, q.metallic = 0.3f, q.specular = 0.5f;
             q.baseColor[0] = 0.9f, q.baseColor[1] = 0.5f, q.baseColor[2] = 0.2f;
         }),
         false},
        {"hardly bending", make([](Question& q) { q.transmission = 1, q.ior = 1.005f; }), false},
    };
}

constexpr std::array roughnesses{0.0f, 0.1f, 0.25f, 0.5f, 0.8f, 1.0f};
constexpr std::array lobeRoughnesses{0.0f, 0.15f, 0.3f, 0.5f, 0.8f, 1.0f}; // sharper ones no grid resolves
constexpr std::array anglesInDegrees{0.0, 30.0, 60.0, 80.0, 85.0};

void setEye(Question& q, double degrees, double turn = 0.4) {
    const double theta = glm::radians(degrees);
    q.toEye[0] = static_cast<float>(std::sin(theta) * std::cos(turn));
    q.toEye[1] = static_cast<float>(std::sin(theta) * std::sin(turn));
    q.toEye[2] = static_cast<float>(std::cos(theta));
}

glm::dvec3 vectorOf(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

std::string probeText() {
    QFile file(QStringLiteral(PRIZMA_SOURCE_DIR "/tests/support/bsdf_probe.cl"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no probe");
    return file.readAll().toStdString();
}

glm::dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

} // namespace

class BsdfTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void samplesFollowTheirDensity_data();
    void samplesFollowTheirDensity();
    void weightsAreValueOverDensity();
    void energyIsKept();
    void purelyDiffuseIsLambert();
    void mirrorAndGlassAreExact();
    void lightGoesBothWaysAlike();
    void oddInputGivesNumbers();
    void bentNormalsLeakNothing();
    void tablesAreAsExactAsTheySay();

  private:
    std::vector<Sample> sample(const std::vector<Question>& questions, std::uint32_t each,
                               std::uint32_t seed) {
        ProbeBuffer<Question> asked(*context_, questions.size());
        asked.values = questions;
        const auto count = static_cast<std::uint32_t>(questions.size() * each);
        ProbeBuffer<Sample> samples(*context_, count);
        probe_->run("sampleAll", count, asked.upload(), each, seed, count, samples.buffer());
        return samples.download();
    }
    std::vector<Four> evaluate(const std::vector<Question>& questions,
                               const std::vector<glm::dvec3>& directions) {
        ProbeBuffer<Question> asked(*context_, questions.size());
        asked.values = questions;
        ProbeBuffer<float> towards(*context_, 3 * directions.size());
        for (std::size_t i = 0; i < directions.size(); ++i)
            for (int c = 0; c < 3; ++c)
                towards.values[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(directions[i][c]);
        const auto count = static_cast<std::uint32_t>(directions.size());
        const auto each = static_cast<std::uint32_t>(directions.size() / questions.size());
        ProbeBuffer<Four> values(*context_, count);
        probe_->run("evaluateAll", count, asked.upload(), towards.upload(), each, count, values.buffer());
        return values.download();
    }

    std::unique_ptr<Context> context_;
    std::unique_ptr<KernelProbe> probe_;
};

void BsdfTest::initTestCase() {
    auto context = Context::create({});
    if (!context)
        QSKIP("There is no OpenCL device here.");
    context_ = std::move(*context);
    probe_ = std::make_unique<KernelProbe>(*context_, probeText());
}

void BsdfTest::samplesFollowTheirDensity_data() {
    QTest::addColumn<std::size_t>("material");
    for (std::size_t i = 0; i < materials().size(); ++i)
        QTest::newRow(materials()[i].name) << i;
}

void BsdfTest::samplesFollowTheirDensity() {
    QFETCH(std::size_t, material);
    constexpr std::uint32_t rings = 80;
    constexpr std::uint32_t sectors = 160;
    constexpr std::uint32_t count = 200'000;
    const double level = sidak(
        0.01, static_cast<double>(materials().size() * lobeRoughnesses.size() * anglesInDegrees.size()));
    double lowest = 1;
    for (const float roughness : lobeRoughnesses)
        for (const double degrees : anglesInDegrees) {
            Question q = materials()[material].material;
            q.roughness = roughness;
            setEye(q, degrees);
            ProbeBuffer<Question> asked(*context_, 1);
            asked.values = {q};
            ProbeBuffer<float> integrals(*context_, rings * sectors);
            // A lobe is about alpha high and, where it grazes, alpha times the cosine wide; refraction
            // narrows it.
            const double alpha = std::max(roughness * roughness, 0.01f) * (q.transmission > 0 ? 0.35 : 1.0);
            // Refraction near grazing has kinks, where the integral converges slowly.
            const double least = q.transmission > 0 && degrees >= 80 ? 20.0 : 5.0;
            const auto high = static_cast<std::uint32_t>(std::clamp(0.1 / alpha, least, 20.0));
            const auto wide =
                static_cast<std::uint32_t>(std::clamp(0.04 / (alpha * q.toEye[2]), least, 50.0));
            probe_->run("integrateCells", rings * sectors, asked.upload(), rings, sectors, high, wide,
                        integrals.buffer());
            std::vector<double> expected;
            double sum = 0;
            for (const float integral : integrals.download()) {
                expected.push_back(count * static_cast<double>(integral));
                sum += integral;
            }
            QVERIFY2(sum < 1.0005,
                     qPrintable(QString("roughness %1, %2 degrees: the density integrates to %3")
                                    .arg(roughness)
                                    .arg(degrees)
                                    .arg(sum)));
            std::vector<double> observed(expected.size() + 1, 0.0);
            for (const Sample& s : sample({q}, count, static_cast<std::uint32_t>(degrees) + 17)) {
                if (s.isDelta || s.pdf == 0) { // mirrors, and samples that end
                    ++observed.back();
                    continue;
                }
                const double theta = std::acos(std::clamp(s.direction[2], -1.0f, 1.0f));
                double phi = std::atan2(s.direction[1], s.direction[0]);
                phi += phi < 0 ? 2 * pi : 0;
                const auto ring = std::min(static_cast<std::uint32_t>(theta / pi * rings), rings - 1);
                const auto sector =
                    std::min(static_cast<std::uint32_t>(phi / (2 * pi) * sectors), sectors - 1);
                ++observed[ring * sectors + sector];
            }
            expected.push_back(count * std::max(1 - sum, 0.0));
            const double p = chiSquaredTest(observed, expected);
            lowest = std::min(lowest, p);
            QVERIFY2(p > level, qPrintable(QString("roughness %1, %2 degrees: p = %3, integral %4")
                                               .arg(roughness)
                                               .arg(degrees)
                                               .arg(p)
                                               .arg(sum)));
        }
    qInfo("%s: lowest p of %zu tests %.4f, limit %.1e", materials()[material].name,
          lobeRoughnesses.size() * anglesInDegrees.size(), lowest, level);
}

void BsdfTest::weightsAreValueOverDensity() {
    double worst = 0;
    for (const NamedMaterial& m : materials())
        for (const float roughness : roughnesses)
            for (const double degrees : anglesInDegrees) {
                Question q = m.material;
                q.roughness = roughness;
                setEye(q, degrees);
                for (const Sample& s : sample({q}, 500, 3)) {
                    if (s.isDelta)
                        continue;
                    if (s.pdf == 0) { // lost: it came out on the wrong side
                        QVERIFY(s.weight[0] == 0 && s.weight[1] == 0 && s.weight[2] == 0);
                        continue;
                    }
                    QVERIFY(std::abs(s.pdf - s.valuePdf) <= 1e-5 * s.pdf);
                    for (int c = 0; c < 3; ++c) {
                        const double ratio = static_cast<double>(s.value[c]) / s.pdf;
                        worst = std::max(worst, std::abs(ratio - s.weight[c]) / std::max(ratio, 1e-3));
                    }
                }
            }
    qInfo("largest difference %.1e", worst);
    QVERIFY(worst < 1e-5);
}

void BsdfTest::energyIsKept() {
    constexpr std::uint32_t count = 100'000;
    const double tests =
        static_cast<double>(materials().size() * roughnesses.size() * anglesInDegrees.size() * 3);
    const double z = twoSidedLimit(sidak(0.01, tests));
    for (const NamedMaterial& m : materials()) {
        double least = 2;
        double most = 0;
        for (const float roughness : roughnesses)
            for (const double degrees : anglesInDegrees) {
                Question q = m.material;
                q.roughness = roughness;
                setEye(q, degrees);
                const std::vector<Sample> samples = sample({q}, count, 5);
                for (std::size_t c = 0; c < 3; ++c) {
                    std::vector<double> weights;
                    for (const Sample& s : samples)
                        weights.push_back(s.weight[c]);
                    const Mean mean = meanOf(weights);
                    const double bound = z * mean.standardError + tableError(q.toEye[2]) + 1e-6;
                    least = std::min(least, mean.value);
                    most = std::max(most, mean.value);
                    const QString what = QString("%1, roughness %2, %3 degrees: %4 with error %5")
                                             .arg(m.name)
                                             .arg(roughness)
                                             .arg(degrees)
                                             .arg(mean.value)
                                             .arg(mean.standardError);
                    QVERIFY2(mean.value < 1 + bound, qPrintable(what));
                    if (m.isWhite)
                        QVERIFY2(mean.value > 1 - bound, qPrintable(what));
                    QVERIFY2(mean.value > 0.03, qPrintable(what));
                }
            }
        qInfo("%-20s gives back %.4f to %.4f", m.name, least, most);
    }
}

void BsdfTest::purelyDiffuseIsLambert() {
    std::mt19937 random(3);
    Question q;
    q.specular = 0;
    q.baseColor[1] = 0.5f;
    setEye(q, 50);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 1000; ++i)
        directions.push_back(randomDirection(random));
    const std::vector<Four> values = evaluate({q}, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double cosine = std::max(directions[i].z, 0.0);
        QVERIFY(std::abs(values[i].x - cosine / pi) < 1e-6);
        QVERIFY(std::abs(values[i].y - 0.5 * cosine / pi) < 1e-6);
        QVERIFY(std::abs(values[i].w - cosine / pi) < 1e-6);
    }
}

void BsdfTest::mirrorAndGlassAreExact() {
    Question mirror;
    mirror.metallic = 1;
    mirror.roughness = 0;
    setEye(mirror, 37);
    for (const Sample& s : sample({mirror}, 100, 1)) {
        QVERIFY(s.isDelta);
        QVERIFY(std::abs(s.weight[0] - 1) < 1e-6);
        QVERIFY(glm::length(vectorOf(s.direction) + vectorOf(mirror.toEye) -
                            glm::dvec3(0, 0, 2 * mirror.toEye[2])) < 1e-6);
        QCOMPARE(s.value[0], 0.0f);
    }
    for (const std::uint32_t entering : {1u, 0u})
        for (const double degrees : {0.0, 25.0, 40.0, 60.0, 85.0}) {
            Question glass;
            glass.transmission = 1;
            glass.roughness = 0;
            glass.entering = entering;
            setEye(glass, degrees);
            const double eta = entering ? 1.5 : 1 / 1.5;
            const double cosine = glass.toEye[2];
            const double sine = std::sqrt(1 - cosine * cosine) / eta;
            double fresnel = 1;
            if (sine < 1) {
                const double beyond = std::sqrt(1 - sine * sine);
                const double a = (eta * cosine - beyond) / (eta * cosine + beyond);
                const double b = (cosine - eta * beyond) / (cosine + eta * beyond);
                fresnel = (a * a + b * b) / 2;
            }
            for (const Sample& s : sample({glass}, 200, 2)) {
                QVERIFY(s.isDelta && std::abs(s.weight[0] - 1) < 1e-4);
                QVERIFY(std::abs(s.pdf - (s.transmitted ? 1 - fresnel : fresnel)) < 5e-5);
                if (s.transmitted) // Snell
                    QVERIFY(std::abs(std::hypot(s.direction[0], s.direction[1]) - sine) < 2e-6 &&
                            s.direction[2] < 0);
            }
        }
}

void BsdfTest::lightGoesBothWaysAlike() {
    // f(o, i) / n_i^2 = f(i, o) / n_o^2 for the value without cosine: reflection, and refraction too, in
    // radiance per squared index.
    std::mt19937 random(4);
    std::vector<Question> there;
    std::vector<Question> back;
    std::vector<glm::dvec3> toLight;
    std::vector<glm::dvec3> toEye;
    std::vector<double> factors;
    for (int i = 0; i < 40'000; ++i) {
        const auto all = materials();
        const NamedMaterial& m = all[random() % all.size()];
        Question q = m.material;
        q.roughness = std::uniform_real_distribution<float>(0.2f, 1.0f)(random);
        glm::dvec3 o = randomDirection(random);
        o.z = std::abs(o.z);
        const glm::dvec3 l = randomDirection(random);
        if (o.z < 0.02 || std::abs(l.z) < 0.02)
            continue;
        Question r = q;
        const bool through = l.z < 0;
        if (through)
            r.entering = 1 - q.entering;
        const double side = through ? -1 : 1;
        for (int c = 0; c < 3; ++c) {
            q.toEye[c] = static_cast<float>(o[c]);
            r.toEye[c] = static_cast<float>(side * l[c]);
        }
        there.push_back(q);
        back.push_back(r);
        toLight.push_back(l);
        toEye.push_back(side * o);
        const double eta = through ? (q.entering ? q.ior : 1 / q.ior) : 1; // n_i over n_o
        factors.push_back(o.z / std::abs(l.z) / (eta * eta));
    }
    const std::vector<Four> one = evaluate(there, toLight);
    const std::vector<Four> two = evaluate(back, toEye);
    double worst = 0;
    int through = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double a = one[i].x * factors[i];
        const double b = two[i].x;
        through += toLight[i].z < 0 && a > 0;
        const double difference = std::abs(a - b) / std::max({a, b, 1e-3});
        worst = std::max(worst, difference);
        QVERIFY2(difference < 2e-3, qPrintable(QString("%1 and %2").arg(a).arg(b)));
    }
    qInfo("%zu pairs, %d of them through a surface: largest relative difference %.1e", one.size(), through,
          worst);
    QVERIFY(through > 1000);
}

void BsdfTest::oddInputGivesNumbers() {
    std::mt19937 random(5);
    const auto oneOf = [&random](std::initializer_list<float> values) {
        return *(values.begin() + random() % values.size());
    };
    std::vector<Question> questions;
    for (int i = 0; i < 60'000; ++i) {
        Question q;
        for (float& c : q.baseColor)
            c = oneOf({0, 0.3f, 1});
        for (float& c : q.specularColor)
            c = oneOf({0, 0.3f, 1});
        q.specular = oneOf({0, 0.5f, 1});
        q.metallic = oneOf({0, 0.5f, 1});
        q.transmission = oneOf({0, 0.5f, 1});
        q.roughness = oneOf({0, 0.0799f, 0.08f, 0.3f, 1});
        q.ior = oneOf({1, 1.0001f, 1.0099f, 1.0101f, 1.5f, 4});
        q.entering = random() % 2;
        const double height = oneOf({1, 0.5f, 1e-3f, 1e-6f, 1e-20f, 0});
        setEye(q, glm::degrees(std::acos(height)), static_cast<double>(random() % 1000));
        q.toEye[2] = static_cast<float>(height);
        if (random() % 3 == 0) { // a normal that the geometry does not have
            const glm::dvec3 n = glm::normalize(glm::dvec3(0, 0, 1) + 0.7 * randomDirection(random));
            if (glm::dot(n, vectorOf(q.toEye)) > 0)
                for (int c = 0; c < 3; ++c)
                    q.geometricNormal[c] = static_cast<float>(n[c]);
        }
        questions.push_back(q);
    }
    for (const Sample& s : sample(questions, 4, 6)) {
        for (int c = 0; c < 3; ++c)
            QVERIFY(std::isfinite(s.weight[c]) && s.weight[c] >= 0 && std::isfinite(s.value[c]) &&
                    s.value[c] >= 0);
        QVERIFY(std::isfinite(s.pdf) && s.pdf >= 0 && std::isfinite(s.valuePdf));
        QVERIFY(std::abs(glm::length(vectorOf(s.direction)) - 1) < 1e-5);
    }
}

void BsdfTest::bentNormalsLeakNothing() {
    // Interpolated normals: nothing leaves on the wrong side, no energy is made, and mirrors stay whole.
    std::mt19937 random(7);
    const double z = twoSidedLimit(sidak(0.01, 300));
    for (int i = 0; i < 300; ++i) {
        const auto all = materials();
        Question q = all[random() % all.size()].material;
        q.roughness = roughnesses[random() % roughnesses.size()];
        const glm::dvec3 n = glm::normalize(glm::dvec3(0, 0, 1) + 0.6 * randomDirection(random));
        for (int c = 0; c < 3; ++c)
            q.geometricNormal[c] = static_cast<float>(n[c]);
        setEye(q, 85.0 * static_cast<double>(random() % 100) / 100, static_cast<double>(random() % 1000));
        if (glm::dot(n, vectorOf(q.toEye)) < 0.01)
            continue;
        std::vector<double> weights;
        for (const Sample& s : sample({q}, 20'000, 8)) {
            const double side = glm::dot(vectorOf(s.direction), n);
            if (s.weight[0] > 0)
                QVERIFY(s.transmitted ? side < 1e-6 : side > -1e-6);
            if (s.transmitted && q.transmission == 0)
                QCOMPARE(s.weight[0], 0.0f);
            weights.push_back(s.weight[0]);
        }
        const Mean mean = meanOf(weights);
        QVERIFY2(mean.value < 1 + z * mean.standardError + tableError(q.toEye[2]),
                 qPrintable(QString::number(mean.value)));
        if (q.metallic == 1 && q.roughness == 0 && q.baseColor[0] == 1)
            QVERIFY(std::abs(mean.value - 1) < 1e-5);
    }
}

namespace {

double fresnelOf(double cosine, double eta) {
    const double sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return 1;
    const double beyond = std::sqrt(1 - sine2);
    const double a = (eta * cosine - beyond) / (eta * cosine + beyond);
    const double b = (cosine - eta * beyond) / (cosine + eta * beyond);
    return (a * a + b * b) / 2;
}

/// The albedo of reflection, by Heitz' masking and the plain distribution of normals, over a grid of facets:
/// other variables than the tables were made with.
double reflectedShare(double cosine, double roughness, double eta, bool isMetal) {
    const double alpha = roughness * roughness;
    const double sine = std::sqrt(1 - cosine * cosine);
    const auto g1 = [alpha](double c) { return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 / (c * c) - 1))); };
    const int steps = 600;
    double sum = 0;
    for (int a = 0; a < steps; ++a) {
        const double share = (a + 0.5) / steps; // of D cosine over the facets
        const double tangent2 = alpha * alpha * share / (1 - share);
        const double hz = 1 / std::sqrt(1 + tangent2);
        const double ring = std::sqrt(1 - hz * hz);
        for (int b = 0; b < steps; ++b) {
            const double phi = pi * (b + 0.5) / steps;
            const double met = sine * ring * std::cos(phi) + cosine * hz;
            const double out = 2 * met * hz - cosine;
            if (met <= 0 || out <= 0)
                continue;
            const double go = g1(cosine);
            const double gi = g1(out);
            const double both = go * gi / (go + gi - go * gi); // height-correlated
            sum += (isMetal ? 1 : fresnelOf(met, eta)) * both * met / (cosine * hz);
        }
    }
    return sum / steps / steps;
}

} // namespace

void BsdfTest::tablesAreAsExactAsTheySay() {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> unit(0, 1);
    const std::uint32_t count = 100;
    ProbeBuffer<Four> places(*context_, count);
    for (Four& p : places.values)
        p = {std::pow(unit(random), 1.5f) * 0.99f + 0.01f, 0.1f + 0.9f * unit(random),
             1.05f + 2.9f * unit(random), 0};
    ProbeBuffer<Four> found(*context_, count);
    probe_->run("albedos", count, places.upload(), count, found.buffer());
    found.download();
    double worst[2] = {0, 0};
    for (std::size_t i = 0; i < count; ++i) {
        const Four& p = places.values[i];
        const double error = std::max(std::abs(found.values[i].x - reflectedShare(p.x, p.y, p.z, false)),
                                      std::abs(found.values[i].w - reflectedShare(p.x, p.y, p.z, true)));
        double& most = worst[p.x < 0.1 ? 1 : 0];
        most = std::max(most, error);
        QVERIFY2(
            error < tableError(p.x),
            qPrintable(
                QString("%1 at cosine %2, roughness %3, index %4").arg(error).arg(p.x).arg(p.y).arg(p.z)));
    }
    qInfo("largest error %.5f, near grazing %.5f", worst[0], worst[1]);
}

QTEST_GUILESS_MAIN(BsdfTest)
#include "tst_bsdf.moc"
