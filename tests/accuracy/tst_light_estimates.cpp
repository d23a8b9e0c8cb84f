// What kernels/light_sampling.clh gives on the mean against closed forms (facts/accuracy.md), how well it
// chooses among many lights, and odd places and lights.
#include "tests/support/chi_squared.h"
#include "tests/support/light_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Mean and standard error of many numbers.
class Mean {
  public:
    void add(double value) {
        ++count_;
        const double difference = value - mean_;
        mean_ += difference / count_;
        squares_ += difference * (value - mean_);
    }
    double value() const { return mean_; }
    double variance() const { return squares_ / (count_ - 1); }
    double error() const { return std::sqrt(variance() / count_); }

  private:
    int count_ = 0;
    double mean_ = 0.0, squares_ = 0.0;
};

/// A scene, a surface in it, and the irradiance (first channel) that all lights together give it when nothing
/// is in their way.
struct Surroundings {
    Scene scene = emptyScene();
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double irradiance = 0.0;
};

class SurroundingsMaker {
  public:
    explicit SurroundingsMaker(unsigned seed) : random_(seed) {}

    Surroundings empty() {
        Surroundings s;
        s.position = random_.direction() * random_.uniform(0.0, 3.0);
        s.normal = random_.direction();
        return s;
    }

    glm::dvec3 placeAbove(const Surroundings& s, double low, double high) {
        glm::dvec3 d = random_.direction();
        if (glm::dot(d, s.normal) < 0.0)
            d = -d;
        return s.position + d * random_.logUniform(low, high);
    }

    void addPoint(Surroundings& s) {
        Light light;
        light.position = placeAbove(s, 0.5, 20.0);
        light.intensity = random_.logUniform(1.0, 100.0);
        s.irradiance += light.intensity * facing(s, light.position);
        addLight(s.scene, light);
    }

    void addSpot(Surroundings& s) {
        Light light;
        light.type = LightType::Spot;
        light.position = placeAbove(s, 0.5, 20.0);
        light.direction = glm::normalize(s.position - light.position) + 0.3 * random_.direction();
        light.innerAngle = random_.uniform(1.0, 30.0);
        light.outerAngle = light.innerAngle + random_.uniform(0.0, 30.0);
        light.intensity = random_.logUniform(1.0, 100.0);
        const double cosine =
            glm::dot(glm::normalize(light.direction), glm::normalize(s.position - light.position));
        const double inner = std::cos(glm::radians(light.innerAngle));
        const double outer = std::cos(glm::radians(light.outerAngle));
        const double x = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
        s.irradiance += light.intensity * x * x * (3.0 - 2.0 * x) * facing(s, light.position);
        addLight(s.scene, light);
    }

    void addDirectional(Surroundings& s) {
        Light light;
        light.type = LightType::Directional;
        light.direction = random_.direction();
        light.irradiance = random_.logUniform(0.1, 5.0);
        s.irradiance += light.irradiance * std::max(-glm::dot(light.direction, s.normal), 0.0);
        addLight(s.scene, light);
    }

    /// Anywhere, of any size and turn: it may stand in the surface or show its back.
    void addRectangle(Surroundings& s) {
        const glm::dquat rotation = random_.rotation();
        Light light = rectangle(s.position + random_.direction() * random_.logUniform(0.3, 20.0), rotation,
                                {random_.logUniform(0.01, 10.0), random_.logUniform(0.01, 10.0)});
        light.radiance = random_.logUniform(0.1, 10.0);
        const glm::dvec3 u = rotation * glm::dvec3(0.5 * light.size.x, 0, 0);
        const glm::dvec3 v = rotation * glm::dvec3(0, 0, 0.5 * light.size.y);
        const glm::dvec3 middle = light.position - s.position;
        if (glm::dot(rotation * glm::dvec3(0, -1, 0), middle) < 0.0)
            s.irradiance +=
                light.radiance *
                polygonIrradiance({middle - u - v, middle + u - v, middle + u + v, middle - u + v}, s.normal);
        addLight(s.scene, light);
    }

    /// Wholly above the surface.
    void addSphere(Surroundings& s) {
        Light light = sphere(placeAbove(s, 0.3, 20.0), 1.0);
        const double height = glm::dot(light.position - s.position, s.normal);
        light.radius = height * random_.logUniform(1e-3, 0.99);
        light.radiance = random_.logUniform(0.1, 10.0);
        s.irradiance += pi * light.radiance * light.radius * light.radius * facing(s, light.position);
        addLight(s.scene, light);
    }

    void addTriangles(Surroundings& s, int count) {
        Material material = shining(glm::dvec3(random_.logUniform(0.1, 10.0)));
        material.doubleSided = random_.whole() % 2 == 0;
        const double size = random_.logUniform(0.01, 5.0);
        std::vector<glm::vec3> corners;
        Object object;
        object.transform.rotation = random_.rotation();
        object.transform.translation = random_.direction();
        object.transform.scale = {1.0, random_.uniform(0.5, 2.0), random_.whole() % 2 == 0 ? 1.3 : -1.3};
        const glm::dmat4 toWorld = object.transform.matrix();
        const bool mirrored = object.transform.scale.z < 0.0;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 centre = random_.direction() * random_.logUniform(0.5, 10.0);
            std::vector<glm::dvec3> seen;
            for (int k = 0; k < 3; ++k) {
                corners.emplace_back(centre + size * random_.direction());
                seen.push_back(glm::dvec3(toWorld * glm::dvec4(corners.back(), 1.0)) - s.position);
            }
            const glm::dvec3 across = glm::cross(seen[1] - seen[0], seen[2] - seen[0]);
            const bool fromFront = (glm::dot(across, seen[0]) < 0.0) != mirrored;
            if (fromFront || material.doubleSided)
                s.irradiance += material.emission.x * polygonIrradiance(seen, s.normal);
        }
        Object made = triangles(corners, addMaterial(s.scene, material));
        made.transform = object.transform;
        addObject(s.scene, made);
    }

    void addEvenBackground(Surroundings& s) {
        s.scene.background.color = glm::dvec3(random_.logUniform(0.01, 2.0));
        s.irradiance += pi * s.scene.background.color.x;
    }

    RandomNumbers& random() { return random_; }

  private:
    /// Cosine over the square of the distance.
    static double facing(const Surroundings& s, const glm::dvec3& light) {
        const glm::dvec3 way = light - s.position;
        return std::max(glm::dot(way, s.normal), 0.0) / std::pow(glm::length(way), 3.0);
    }

    RandomNumbers random_;
};

double estimate(const Answer& answer, const glm::dvec3& normal) {
    if (!(answer.pdf > 0.0f))
        return 0.0;
    return static_cast<double>(answer.radiance[0]) * std::max(glm::dot(answer.towards(), normal), 0.0) /
           static_cast<double>(answer.pdf);
}

bool isFinite(const Answer& answer) {
    const auto finite = [](const float(&v)[3]) {
        return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
    };
    return finite(answer.direction) && finite(answer.radiance) && std::isfinite(answer.pdf) &&
           answer.pdf >= 0.0f && !std::isnan(answer.distance);
}

} // namespace

class LightEstimatesTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void meansMatchClosedForms_data();
    void meansMatchClosedForms();
    void pictureLightsAsItsIntegral();
    void posedMeshLightsFromWhereItIs();
    void chancesAddUpToOne();
    void choicesFollowTheirChances();
    void manyLightsAreChosenByImportance();
    void manyTrianglesStayUsable();
    void oddLightsAndPlaces();
    void lightsThatGiveNothingCostNothing();

  private:
    /// Mean of `count` estimates of the irradiance.
    Mean meanOf(const Surroundings& s, int count, RandomNumbers& random, bool withNormal = true) {
        std::vector<Question> questions;
        for (int i = 0; i < count; ++i)
            questions.push_back(question(s.position, withNormal ? s.normal : glm::dvec3(0.0), random));
        Mean mean;
        for (const Answer& answer : probe_->sample(questions))
            mean.add(estimate(answer, s.normal));
        return mean;
    }

    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<LightProbe> probe_;
};

void LightEstimatesTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    probe_ = std::make_unique<LightProbe>(*renderer_);
}

void LightEstimatesTest::meansMatchClosedForms_data() {
    QTest::addColumn<int>("kind");
    const char* names[] = {"points",   "spots",           "directional", "rectangle",  "sphere",
                           "triangle", "even background", "some of all", "many of all"};
    for (int kind = 0; kind < 9; ++kind)
        QTest::newRow(names[kind]) << kind;
}

/// Sixty random scenes of a kind: their z-scores are each small, and together those of a normal distribution.
void LightEstimatesTest::meansMatchClosedForms() {
    QFETCH(int, kind);
    constexpr int scenes = 60;
    constexpr int samples = 20000;
    SurroundingsMaker maker(static_cast<unsigned>(kind + 1));
    double squares = 0.0, worst = 0.0, largestError = 0.0;
    int counted = 0;
    for (int i = 0; i < scenes; ++i) {
        Surroundings s = maker.empty();
        const int repeats = kind == 7 ? 2 : (kind == 8 ? 30 : 1);
        for (int k = 0; k < repeats; ++k) {
            if (kind == 0 || kind >= 7)
                maker.addPoint(s);
            if (kind == 1 || kind >= 7)
                maker.addSpot(s);
            if (kind == 2 || kind >= 7)
                maker.addDirectional(s);
            if (kind == 3 || kind >= 7)
                maker.addRectangle(s);
            if (kind == 4 || kind >= 7)
                maker.addSphere(s);
            if (kind == 5 || kind >= 7)
                maker.addTriangles(s, kind == 5 ? 1 : 4);
        }
        if (kind >= 6)
            maker.addEvenBackground(s);
        probe_->setScene(s.scene);
        const Mean mean = meanOf(s, samples, maker.random(), i % 3 != 0);
        const double rounding = 1e-4 * s.irradiance + 1e-7; // of the lights' places as floats
        const double difference = mean.value() - s.irradiance;
        largestError = std::max(largestError, std::abs(difference) / std::max(s.irradiance, 1e-6));
        if (mean.error() < rounding) {
            QVERIFY2(std::abs(difference) < 6.0 * rounding,
                     qPrintable(QString("scene %1: %2, not %3").arg(i).arg(mean.value()).arg(s.irradiance)));
            continue;
        }
        const double z = difference / std::hypot(mean.error(), rounding);
        squares += z * z;
        ++counted;
        worst = std::max(worst, std::abs(z));
        QVERIFY2(std::abs(z) < 5.0, qPrintable(QString("scene %1: %2 +- %3, not %4")
                                                   .arg(i)
                                                   .arg(mean.value())
                                                   .arg(mean.error())
                                                   .arg(s.irradiance)));
    }
    const double p = chiSquaredTail(squares, counted);
    qInfo("largest relative error %.2g, %d z-scores up to %.2f, p = %.3f", largestError, counted, worst, p);
    QVERIFY(p > sidakLevel(0.01, 9));
}

/// Against a sum over the sphere in double precision.
void LightEstimatesTest::pictureLightsAsItsIntegral() {
    RandomNumbers random(3);
    for (int round = 0; round < 4; ++round) {
        Surroundings s;
        s.normal = random.direction();
        const int width = round == 0 ? 1 : 12;
        const int height = round == 0 ? 1 : 7;
        const ImagePtr image = floatImage(
            width, height, [&](int, int) { return 0.01 + std::pow(random.uniform(), 8.0) * 20.0; });
        s.scene.background.image = {"sky.exr", image};
        s.scene.background.intensity = 0.7;
        s.scene.background.rotation = 90.0 * round + 13.0;
        probe_->setScene(s.scene);
        // The picture as the shader sees it, on a fine grid of equal solid angles.
        std::vector<Question> questions;
        std::vector<Answer> answers;
        constexpr int rows = 500, columns = 1000;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const double y = 1.0 - 2.0 * (i + 0.5) / rows;
                const double turn = 2.0 * pi * (j + 0.5) / columns;
                Answer answer{};
                answer.direction[0] = static_cast<float>(std::sqrt(1.0 - y * y) * std::cos(turn));
                answer.direction[1] = static_cast<float>(y);
                answer.direction[2] = static_cast<float>(std::sqrt(1.0 - y * y) * std::sin(turn));
                answers.push_back(answer);
                questions.push_back(question(s.position, s.normal, random));
            }
        probe_->densitiesAlong(questions, answers);
        double integral = 0.0;
        for (const Answer& answer : answers) {
            s.irradiance += static_cast<double>(answer.metRadiance[0]) *
                            std::max(glm::dot(answer.towards(), s.normal), 0.0);
            integral += static_cast<double>(answer.otherPdf);
        }
        s.irradiance *= 4.0 * pi / (rows * columns);
        integral *= 4.0 * pi / (rows * columns);
        QVERIFY(std::abs(integral - 1.0) < 5e-3);
        const Mean mean = meanOf(s, 400000, random);
        const double z = (mean.value() - s.irradiance) / std::hypot(mean.error(), 1e-3 * s.irradiance);
        qInfo("%.5f +- %.5f, integral %.5f", mean.value(), mean.error(), s.irradiance);
        QVERIFY(std::abs(z) < 4.0);
    }
}

/// The bind pose is all that the host knows when it builds the tree; what is sampled is the pose.
void LightEstimatesTest::posedMeshLightsFromWhereItIs() {
    RandomNumbers random(11);
    Scene scene = emptyScene();
    Object object = bendingObject();
    object.materials.assign(object.mesh->slots.size(), addMaterial(scene, shining()));
    object.transform.translation = {0.5, -1.0, 0.3};
    object.transform.rotation = random.rotation();
    const Id id = addObject(scene, object);
    for (const double frame : {0.0, 9.0, 30.0}) {
        scene.timeline.frame = frame;
        probe_->setScene(scene);
        const auto positions = renderer_->deviceScene().posedPositions(id);
        QVERIFY(positions);
        const glm::dmat4 toWorld = object.transform.matrix();
        for (int i = 0; i < 10; ++i) {
            Surroundings s;
            s.position = random.direction() * random.uniform(0.2, 4.0);
            s.normal = random.direction();
            for (const glm::uvec3& triangle : object.mesh->triangles) {
                std::vector<glm::dvec3> seen;
                for (int k = 0; k < 3; ++k)
                    seen.push_back(glm::dvec3(toWorld * glm::dvec4((*positions)[triangle[k]], 1.0)) -
                                   s.position);
                s.irradiance += 3.0 * polygonIrradiance(seen, s.normal);
            }
            const Mean mean = meanOf(s, 50000, random);
            QVERIFY2(std::abs(mean.value() - s.irradiance) <= 4.5 * mean.error() + 1e-4 * s.irradiance,
                     qPrintable(
                         QString("%1 +- %2, not %3").arg(mean.value()).arg(mean.error()).arg(s.irradiance)));
        }
    }
}

/// Walking up from every leaf: the probabilities add up to 1, but for walks that end where no light comes
/// from.
void LightEstimatesTest::chancesAddUpToOne() {
    SurroundingsMaker maker(21);
    for (int round = 0; round < 60; ++round) {
        Surroundings s = maker.empty();
        const bool allAround = round % 2 == 0; // lights that shine everywhere leave no dead ends
        for (int i = 0; i < 1 + 5 * round; ++i) {
            maker.addPoint(s);
            maker.addSphere(s);
            if (!allAround) {
                maker.addSpot(s);
                maker.addRectangle(s);
                maker.addTriangles(s, 5);
            }
        }
        probe_->setScene(s.scene);
        const Question from = question(s.position, allAround ? glm::dvec3(0.0) : s.normal, maker.random());
        double sum = 0.0;
        for (const LightProbe::Choice& leaf : probe_->chances(from))
            sum += static_cast<double>(leaf.probability);
        if (allAround) {
            QVERIFY2(std::abs(sum - 1.0) < 1e-4, qPrintable(QString::number(sum)));
            continue;
        }
        constexpr int count = 20000;
        std::vector<Question> questions;
        for (int i = 0; i < count; ++i)
            questions.push_back(question(s.position, s.normal, maker.random()));
        int ended = 0;
        for (const LightProbe::Choice& choice : probe_->choose(questions))
            ended += choice.emitter == PRIZMA_NO_HIT ? 1 : 0;
        const double deadEnds = static_cast<double>(ended) / count;
        const double error = std::sqrt(std::max(sum * (1.0 - sum), 0.0) / count);
        QVERIFY2(std::abs(sum + deadEnds - 1.0) < 5.0 * error + 1e-4,
                 qPrintable(QString("%1 and %2").arg(sum).arg(deadEnds)));
    }
}

void LightEstimatesTest::choicesFollowTheirChances() {
    SurroundingsMaker maker(22);
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
        Surroundings s = maker.empty();
        for (int i = 0; i < 40; ++i) {
            maker.addPoint(s);
            maker.addSphere(s);
            maker.addRectangle(s);
            maker.addTriangles(s, 3);
        }
        probe_->setScene(s.scene);
        constexpr int count = 200000;
        std::vector<Question> questions;
        for (int i = 0; i < count; ++i)
            questions.push_back(question(s.position, s.normal, maker.random()));
        std::map<std::uint32_t, double> chanceOf;
        double sum = 0.0;
        for (const LightProbe::Choice& leaf : probe_->chances(questions[0])) {
            chanceOf[leaf.emitter] = static_cast<double>(leaf.probability);
            sum += static_cast<double>(leaf.probability);
        }
        chanceOf[PRIZMA_NO_HIT] = std::max(1.0 - sum, 0.0);
        std::map<std::uint32_t, double> countOf;
        for (const LightProbe::Choice& choice : probe_->choose(questions)) {
            countOf[choice.emitter] += 1.0;
            if (choice.emitter != PRIZMA_NO_HIT)
                QVERIFY(std::abs(static_cast<double>(choice.probability) / chanceOf[choice.emitter] - 1.0) <
                        1e-4);
        }
        std::vector<double> counts, expected;
        for (const auto& [emitter, chance] : chanceOf) {
            counts.push_back(countOf[emitter]);
            expected.push_back(chance * count);
        }
        QVERIFY(chiSquaredTest(counts, expected) > sidakLevel(0.01, rounds));
    }
}

/// A thousand lights in a hall: the variance of direct light against that of choosing each as often as
/// another, which is known in closed form; and what a sample costs.
void LightEstimatesTest::manyLightsAreChosenByImportance() {
    RandomNumbers random(31);
    for (const int lights : {1, 10, 100, 1000}) {
        Scene scene = emptyScene();
        std::vector<Light> all;
        for (int i = 0; i < lights; ++i) {
            Light light;
            light.position = {random.uniform(-20.0, 20.0), random.uniform(2.0, 4.0),
                              random.uniform(-20.0, 20.0)};
            light.intensity = random.logUniform(1.0, 10.0);
            addLight(scene, light);
            all.push_back(light);
        }
        probe_->setScene(scene);
        const glm::dvec3 normal{0, 1, 0};
        double byTree = 0.0, evenly = 0.0, cost = 0.0;
        constexpr int places = 20;
        constexpr int samples = 20000;
        for (int i = 0; i < places; ++i) {
            Surroundings s;
            s.position = {random.uniform(-20.0, 20.0), 0.0, random.uniform(-20.0, 20.0)};
            s.normal = normal;
            double squares = 0.0;
            for (const Light& light : all) {
                const glm::dvec3 way = light.position - s.position;
                const double given = light.intensity * way.y / std::pow(glm::length(way), 3.0);
                s.irradiance += given;
                squares += given * given;
            }
            const Mean mean = meanOf(s, samples, random);
            cost += probe_->lastMilliseconds() * 1e6 / samples / places;
            QVERIFY(std::abs(mean.value() - s.irradiance) < 5.0 * mean.error() + 1e-5 * s.irradiance);
            byTree += mean.variance() / (s.irradiance * s.irradiance) / places;
            evenly += (lights * squares / (s.irradiance * s.irradiance) - 1.0) / places;
        }
        qInfo("%d lights: relative variance %.3g, evenly chosen %.3g; %.0f ns a sample", lights, byTree,
              evenly, cost);
        if (lights >= 100)
            QVERIFY(byTree < 0.05 * evenly);
    }
}

void LightEstimatesTest::manyTrianglesStayUsable() {
    SurroundingsMaker maker(41);
    Surroundings s = maker.empty();
    Material material = shining();
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 centre(10.0 * maker.random().direction() * maker.random().uniform(0.3, 1.0));
        for (int k = 0; k < 3; ++k)
            corners.push_back(centre + 0.05f * glm::vec3(maker.random().direction()));
        std::vector<glm::dvec3> seen;
        for (std::size_t k = corners.size() - 3; k < corners.size(); ++k)
            seen.push_back(glm::dvec3(corners[k]) - s.position);
        s.irradiance += 3.0 * polygonIrradiance(seen, s.normal);
    }
    addObject(s.scene, triangles(corners, addMaterial(s.scene, material)));
    renderer_->waitForTrees(s.scene);
    probe_->setScene(s.scene);
    for (const StageStatistics& stage : renderer_->statistics(false).stages)
        if (stage.stage == describe(Stage::LightTree))
            qInfo("light tree of 100,000 triangles: %.0f ms", stage.milliseconds);
    QCOMPARE(renderer_->deviceScene().lights().emitterCount(), 100000u);
    const Mean mean = meanOf(s, 200000, maker.random());
    qInfo("%.4f +- %.4f, closed form %.4f; %.0f ns a sample", mean.value(), mean.error(), s.irradiance,
          probe_->lastMilliseconds() * 1e6 / 200000);
    QVERIFY(std::abs(mean.value() - s.irradiance) < 4.5 * mean.error());
}

/// Points on, in and beside lights of all sizes; triangles that are lines and points; normals of all kinds.
void LightEstimatesTest::oddLightsAndPlaces() {
    RandomNumbers random(51);
    int asked = 0;
    for (int round = 0; round < 300; ++round) {
        Scene scene = emptyScene();
        std::vector<glm::dvec3> where{{0, 0, 0}};
        const double size = random.logUniform(1e-6, 1e6);
        for (int i = 0; i < 1 + static_cast<int>(random.whole() % 5); ++i) {
            Light light;
            light.type = static_cast<LightType>(random.whole() % 5);
            light.position =
                random.whole() % 3 == 0 ? glm::dvec3(0.0) : random.direction() * random.logUniform(1e-6, 1e6);
            light.direction = random.whole() % 5 == 0 ? glm::dvec3(0.0) : random.direction();
            light.innerAngle = light.outerAngle = random.whole() % 3 == 0 ? 0.0 : random.uniform(0.0, 180.0);
            light.rotation = random.whole() % 2 == 0 ? glm::dquat(1, 0, 0, 0) : random.rotation();
            light.size = {random.whole() % 7 == 0 ? 0.0 : size * random.logUniform(1e-4, 1e4), size};
            light.radius = random.whole() % 7 == 0 ? 0.0 : size;
            light.radiance = random.logUniform(1e-10, 1e10);
            where.push_back(light.position);
            where.push_back(light.position + light.rotation * glm::dvec3(0.5 * light.size.x, 0, 0));
            where.push_back(light.position + glm::dvec3(light.radius, 0, 0));
            addLight(scene, light);
        }
        std::vector<glm::vec3> corners;
        for (int i = 0; i < static_cast<int>(random.whole() % 4); ++i) {
            const glm::vec3 a(random.direction() * size);
            const glm::vec3 b(random.direction() * random.logUniform(1e-6, 1e6));
            const glm::vec3 c = random.whole() % 2 == 0 ? a + (b - a) * 0.5f : glm::vec3(random.direction());
            corners.insert(corners.end(), {a, random.whole() % 4 == 0 ? a : b, c});
            where.emplace_back(a);
            where.emplace_back((a + b + c) / 3.0f);
        }
        if (!corners.empty())
            addObject(scene, triangles(corners, addMaterial(scene, shining())));
        if (round % 3 == 0)
            scene.background.color = glm::dvec3(random.logUniform(1e-10, 1e10));
        probe_->setScene(scene);
        std::vector<Question> questions;
        for (const glm::dvec3& place : where)
            for (int i = 0; i < 40; ++i) {
                questions.push_back(
                    question(place, i % 2 == 0 ? glm::dvec3(0.0) : random.direction(), random));
                if (i == 0)
                    questions.back().u[0] = questions.back().u[1] = questions.back().u[2] = 0.0f;
                if (i == 1)
                    questions.back().u[0] = questions.back().u[1] = questions.back().u[2] = 0.99999994f;
            }
        asked += static_cast<int>(questions.size());
        std::vector<Answer> answers = probe_->sample(questions);
        for (const Answer& answer : answers)
            QVERIFY(isFinite(answer));
        probe_->densitiesAlong(questions, answers);
        for (const Answer& answer : answers)
            QVERIFY(!std::isnan(answer.otherPdf) && answer.otherPdf >= 0.0f);
    }
    qInfo("%d samples", asked);
}

void LightEstimatesTest::lightsThatGiveNothingCostNothing() {
    Scene scene = emptyScene();
    for (const LightType type : {LightType::Point, LightType::Spot, LightType::Directional,
                                 LightType::Rectangle, LightType::Sphere}) {
        Light light;
        light.type = type;
        light.intensity = light.irradiance = light.radiance = 0.0;
        addLight(scene, light);
        light = Light{};
        light.type = type;
        light.enabled = false;
        addLight(scene, light);
    }
    Light flat = rectangle({0, 1, 0}, {1, 0, 0, 0}, {0, 1});
    addLight(scene, flat);
    addLight(scene, sphere({0, 1, 0}, 0.0));
    Material dark = shining();
    dark.emissionStrength = 0.0;
    addObject(scene, primitiveObject(PrimitiveType::Sphere, 1.0, addMaterial(scene, dark)));
    Object hidden = primitiveObject(PrimitiveType::Sphere, 1.0, addMaterial(scene, shining()));
    hidden.visible = false;
    addObject(scene, hidden);
    probe_->setScene(scene);
    const LightStore& lights = renderer_->deviceScene().lights();
    QCOMPARE(lights.lightCount(), 0u);
    QCOMPARE(lights.emitterCount(), 0u);
    QCOMPARE(lights.treeSize(), 0u);
    RandomNumbers random(1);
    for (const Answer& answer : probe_->sample({question({0, 0, 0}, {0, 1, 0}, random)}))
        QCOMPARE(answer.pdf, 0.0f);
}

QTEST_GUILESS_MAIN(LightEstimatesTest)
#include "tst_light_estimates.moc"
