// kernels/light_sampling.clh by itself: densities against histograms, estimates against closed forms
// (facts/accuracy.md), and odd places and lights.
#include "tests/support/chi_squared.h"
#include "tests/support/light_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// A scene and a point in it that light arrives at.
struct Place {
    Scene scene;
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
};

/// Cells of equal solid angle on the part of the sphere where samples lie.
class Cells {
  public:
    static constexpr int rows = 80, columns = 160;

    explicit Cells(const std::vector<Answer>& answers) {
        glm::dvec3 sum(0.0);
        for (const Answer& answer : answers)
            if (answer.pdf > 0.0f)
                sum += answer.towards();
        axis_ = glm::length(sum) > 0.0 ? glm::normalize(sum) : glm::dvec3(0, 0, 1);
        const glm::dvec3 other = std::abs(axis_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        x_ = glm::normalize(glm::cross(axis_, other));
        y_ = glm::cross(axis_, x_);
        for (const Answer& answer : answers)
            if (answer.pdf > 0.0f)
                depth_ = std::max(depth_, depthOf(answer.towards()));
        depth_ = std::min(depth_ * 1.02, 2.0);
    }

    /// A cell and those beside it.
    static std::vector<std::size_t> around(std::size_t cell) {
        const auto row = static_cast<int>(cell) / columns;
        const auto column = static_cast<int>(cell) % columns;
        std::vector<std::size_t> found;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y)
            for (int x = column - 1; x <= column + 1; ++x)
                found.push_back(static_cast<std::size_t>(y * columns + (x + columns) % columns));
        return found;
    }

    double solidAngle() const { return 2.0 * pi * depth_ / (rows * columns); }

    std::size_t cellOf(const glm::dvec3& direction) const {
        const double turn = std::atan2(glm::dot(direction, y_), glm::dot(direction, x_)) / (2.0 * pi);
        const int row = std::min(static_cast<int>(depthOf(direction) / depth_ * rows), rows - 1);
        const int column = std::min(static_cast<int>((turn - std::floor(turn)) * columns), columns - 1);
        return static_cast<std::size_t>(row * columns + column);
    }

    /// A direction inside a cell; `down` and `across` in [0, 1).
    glm::dvec3 directionIn(std::size_t cell, double down, double across) const {
        const auto row = static_cast<double>(cell / columns);
        const auto column = static_cast<double>(cell % columns);
        const double fall = (row + down) / rows * depth_;
        const double sine = std::sqrt(fall * (2.0 - fall));
        const double angle = (column + across) / columns * 2.0 * pi;
        return axis_ * (1.0 - fall) + (x_ * std::cos(angle) + y_ * std::sin(angle)) * sine;
    }

  private:
    double depthOf(const glm::dvec3& direction) const { // 1 - cosine
        const glm::dvec3 difference = direction - axis_;
        return 0.5 * glm::dot(difference, difference);
    }

    glm::dvec3 axis_, x_, y_;
    double depth_ = 0.0;
};

} // namespace

class LightSamplingTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void densitiesMatchHistograms_data();
    void densitiesMatchHistograms();

  private:
    /// Integrals of the density over all cells: a few points in each, many where it jumps.
    std::vector<double> integrals(const Place& place, const Cells& cells, const std::vector<double>& counts,
                                  RandomNumbers& random);
    std::vector<double> densitiesIn(const Place& place, const Cells& cells,
                                    const std::vector<std::size_t>& which, int side, RandomNumbers& random,
                                    std::vector<bool>* varies);
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<LightProbe> probe_;
};

void LightSamplingTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    probe_ = std::make_unique<LightProbe>(*renderer_);
}

std::vector<double> LightSamplingTest::densitiesIn(const Place& place, const Cells& cells,
                                                   const std::vector<std::size_t>& which, int side,
                                                   RandomNumbers& random, std::vector<bool>* varies) {
    std::vector<Question> questions;
    std::vector<Answer> answers;
    for (const std::size_t cell : which)
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                questions.push_back(question(place.position, place.normal, random));
                const glm::dvec3 d =
                    cells.directionIn(cell, (i + random.uniform()) / side, (j + random.uniform()) / side);
                Answer answer{};
                for (int k = 0; k < 3; ++k)
                    answer.direction[k] = static_cast<float>(d[k]);
                answers.push_back(answer);
            }
    probe_->densitiesAlong(questions, answers);
    std::vector<double> means;
    for (std::size_t i = 0; i < which.size(); ++i) {
        double sum = 0.0, low = 1e300, high = 0.0;
        for (int k = 0; k < side * side; ++k) {
            const double pdf =
                answers[i * static_cast<std::size_t>(side * side) + static_cast<std::size_t>(k)].otherPdf;
            sum += pdf;
            low = std::min(low, pdf);
            high = std::max(high, pdf);
        }
        means.push_back(sum / (side * side));
        if (varies)
            varies->push_back(high - low > 0.05 * high);
    }
    return means;
}

std::vector<double> LightSamplingTest::integrals(const Place& place, const Cells& cells,
                                                 const std::vector<double>& counts, RandomNumbers& random) {
    std::vector<std::size_t> all(static_cast<std::size_t>(Cells::rows * Cells::columns));
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    std::vector<bool> varies;
    std::vector<double> result = densitiesIn(place, cells, all, 4, random, &varies);
    // Cells in which the density jumps, and what is beside them.
    std::vector<std::size_t> uneven;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool refined = false;
        for (const std::size_t other : Cells::around(i))
            refined = refined || varies[other] || std::abs(result[other] - result[i]) > 0.05 * result[i] ||
                      (counts[other] > 0.0 && result[other] == 0.0);
        if (refined)
            uneven.push_back(i);
    }
    constexpr double evaluations = 4e6;
    const int side = std::clamp(
        static_cast<int>(std::sqrt(evaluations / static_cast<double>(uneven.size() + 1))), 20, 250);
    const std::vector<double> finer = densitiesIn(place, cells, uneven, side, random, nullptr);
    for (std::size_t i = 0; i < uneven.size(); ++i)
        result[uneven[i]] = finer[i];
    for (double& value : result)
        value *= cells.solidAngle();
    return result;
}

namespace {

Place placeOfLight(const Light& light, const glm::dvec3& position = glm::dvec3(0.0)) {
    Place place{emptyScene(), position, glm::dvec3(0.0)};
    addLight(place.scene, light);
    return place;
}

Place placeOfTriangle(const std::vector<glm::vec3>& corners) {
    Place place{emptyScene(), glm::dvec3(0.0), glm::dvec3(0.0)};
    addObject(place.scene, triangles(corners, addMaterial(place.scene, shining())));
    return place;
}

Place placeOfPicture(const ImagePtr& image, double turn) {
    Place place{emptyScene(), glm::dvec3(0.0), glm::dvec3(0.0)};
    place.scene.background.image = {"sky.exr", image};
    place.scene.background.rotation = turn;
    return place;
}

std::vector<std::pair<std::string, Place>> places() {
    std::vector<std::pair<std::string, Place>> all;
    RandomNumbers random(7);
    const glm::dquat facing(1, 0, 0, 0); // downwards
    all.emplace_back("rectangle above", placeOfLight(rectangle({0, 2, 0}, facing, {1, 1})));
    all.emplace_back("long rectangle beside", placeOfLight(rectangle({3, 0.4, -1}, facing, {4, 0.3})));
    all.emplace_back("huge rectangle", placeOfLight(rectangle({10, 1, 3}, facing, {1000, 400})));
    all.emplace_back("near rectangle", placeOfLight(rectangle({0.2, 0.01, 0.1}, facing, {1, 1})));
    all.emplace_back("far rectangle", placeOfLight(rectangle({1, 90, 2}, facing, {1, 2})));
    for (int i = 0; i < 4; ++i) {
        Light light = rectangle(random.direction() * random.logUniform(0.5, 5.0), random.rotation(),
                                {random.logUniform(0.1, 5.0), random.logUniform(0.1, 5.0)});
        if (glm::dot(light.rotation * glm::dvec3(0, -1, 0), light.position) > 0.0)
            light.rotation = light.rotation * glm::dquat(0, 1, 0, 0);
        all.emplace_back("rectangle " + std::to_string(i), placeOfLight(light));
    }
    all.emplace_back("sphere", placeOfLight(sphere({1, 2, -1}, 0.7)));
    all.emplace_back("small sphere", placeOfLight(sphere({10, 2, -1}, 0.05)));
    all.emplace_back("near sphere", placeOfLight(sphere({0, 0, -1}, 0.9999)));
    all.emplace_back("inside a sphere", placeOfLight(sphere({0.3, 0.2, -0.5}, 1.0)));
    all.emplace_back("triangle", placeOfTriangle({{-1, 1, -1}, {1, 1.5f, -1}, {0, 1, 2}}));
    all.emplace_back("far triangle", placeOfTriangle({{-1, 100, -1}, {1, 100, -1}, {0, 101, 2}}));
    all.emplace_back("near triangle", placeOfTriangle({{-3, 0.01f, -1}, {2, 0.02f, -2}, {0, 0.01f, 3}}));
    all.emplace_back("triangle seen from its edge",
                     placeOfTriangle({{1, 0.1f, -1}, {3, 0.2f, -1}, {2, 0.2f, 2}}));
    all.emplace_back("sliver", placeOfTriangle({{1, 1, -3}, {1.1f, 1, -3}, {1, 1.1f, 3}}));
    Place uniform{emptyScene(), glm::dvec3(0.0), glm::dvec3(0.0)};
    uniform.scene.background.color = glm::dvec3(0.3, 1.0, 0.2);
    all.emplace_back("even background", uniform);
    uniform.normal = glm::normalize(glm::dvec3(-1, 3, -2));
    all.emplace_back("even background on a surface", uniform);
    const ImagePtr sky = floatImage(16, 8, [&](int x, int y) {
        return (x == 5 && y == 2) ? 30.0 : ((x > 9 && y > 3) ? 0.0 : random.uniform());
    });
    all.emplace_back("sky", placeOfPicture(sky, 0.0));
    all.emplace_back("turned sky", placeOfPicture(sky, 37.0));
    const ImagePtr large = floatImage(1500, 700, [](int x, int y) {
        return std::pow(0.5 + 0.5 * std::sin(x * 0.02) * std::cos(y * 0.03), 4.0);
    });
    all.emplace_back("sky of more texels than cells", placeOfPicture(large, -100.0));
    return all;
}

} // namespace

void LightSamplingTest::densitiesMatchHistograms_data() {
    QTest::addColumn<int>("index");
    const auto all = places();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::newRow(all[i].first.c_str()) << static_cast<int>(i);
}

void LightSamplingTest::densitiesMatchHistograms() {
    QFETCH(int, index);
    const auto all = places();
    const Place& place = all[static_cast<std::size_t>(index)].second;
    probe_->setScene(place.scene);
    RandomNumbers random(static_cast<unsigned>(100 + index));
    constexpr int count = 400000;
    std::vector<Question> questions;
    for (int i = 0; i < count; ++i)
        questions.push_back(question(place.position, place.normal, random));
    std::vector<Answer> answers = probe_->sample(questions);
    const Cells cells(answers);
    std::vector<double> counts(static_cast<std::size_t>(Cells::rows * Cells::columns));
    for (const Answer& answer : answers) {
        QVERIFY(answer.pdf > 0.0f);
        QVERIFY(std::abs(glm::length(answer.towards()) - 1.0) < 1e-5);
        counts[cells.cellOf(answer.towards())] += 1.0;
    }

    std::vector<double> expected = integrals(place, cells, counts, random);
    double sum = 0.0;
    for (double& value : expected) {
        sum += value;
        value *= count;
    }
    const double p = chiSquaredTest(counts, expected);
    qInfo("integral of the density %.5f, p = %.4f", sum, p);
    QVERIFY2(std::abs(sum - 1.0) < 3e-3, qPrintable(QString::number(sum)));
    QVERIFY2(p > sidakLevel(0.01, static_cast<int>(all.size())), qPrintable(QString::number(p)));

    // The density that comes with a sample is the one that a ray in its direction would find.
    std::vector<Answer> met = answers;
    probe_->densitiesAlong(questions, met);
    int missed = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (met[i].otherPdf == 0.0f) {
            ++missed; // an edge, by rounding
            continue;
        }
        const double error = std::abs(met[i].otherPdf / answers[i].pdf - 1.0);
        if (error > 2e-3)
            ++missed;
        else
            QVERIFY(std::abs(met[i].metRadiance[0] - answers[i].radiance[0]) <=
                    1e-3f * met[i].metRadiance[0] + 1e-6f);
    }
    QVERIFY2(missed < count / 1000, qPrintable(QString::number(missed)));
}

QTEST_GUILESS_MAIN(LightSamplingTest)
#include "tst_light_sampling.moc"
