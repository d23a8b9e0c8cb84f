#include "core/import/image_loader.h"
#include "core/import/image_saver.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <png.h>

#include <cmath>
#include <limits>
#include <random>

using namespace prizma;

using Bytes = std::vector<std::uint8_t>;

class TestImageLoader : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const {
        return folder_.filePath(QString::fromUtf8(name)).toStdString();
    }

    QByteArray read(const std::string& file) const {
        QFile stream(QString::fromStdString(file));
        return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
    }

    void write(const std::string& file, const QByteArray& content) const {
        QFile stream(QString::fromStdString(file));
        QVERIFY(stream.open(QIODevice::WriteOnly));
        QCOMPARE(stream.write(content), content.size());
    }

  private Q_SLOTS:
    void pngRoundTrip() {
        std::mt19937 random(5);
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 7}, {64, 33}}) {
            std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height * 4));
            for (auto& value : pixels)
                value = static_cast<std::uint8_t>(random());
            pixels[3] = 17;
            QVERIFY(savePng(path("a.png"), width, height, pixels));
            const auto image = loadImage(path("a.png"));
            QVERIFY(image);
            QCOMPARE((*image)->width, width);
            QCOMPARE((*image)->height, height);
            QVERIFY((*image)->bytes == pixels);
            QVERIFY((*image)->floats.empty() && !(*image)->opaque);
        }
    }

    void deepPngRoundTrip() {
        std::mt19937 random(15);
        std::vector<std::uint16_t> pixels(5 * 3 * 4);
        for (auto& value : pixels)
            value = static_cast<std::uint16_t>(random());
        QVERIFY(savePng16(path("d.png"), 5, 3, pixels));
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_file(&image, path("d.png").c_str()) != 0);
        QCOMPARE(image.width, 5u);
        QCOMPARE(image.height, 3u);
        QVERIFY((image.format & PNG_FORMAT_FLAG_LINEAR) != 0); // libpng's word for 16 bits a channel
        png_image_free(&image);
        // Bytes are the upper halves, but for rounding: the order of the bytes is right.
        const auto bytes = loadImage(path("d.png"));
        QVERIFY(bytes);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            QVERIFY(std::abs(pixels[i] / 257.0 - (*bytes)->bytes[i]) < 1.1);
        QVERIFY(!savePng16(path("x.png"), 2, 2, pixels));
    }

    void opaqueIsSeen() {
        const std::vector<std::uint8_t> pixels(4 * 4 * 4, 255);
        QVERIFY(savePng(path("o.png"), 4, 4, pixels));
        QVERIFY((*loadImage(path("o.png")))->opaque);
    }

    void exrRoundTrip() {
        std::mt19937 random(6);
        std::uniform_real_distribution<float> value(0.0F, 5000.0F);
        for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {40, 21}}) {
            std::vector<float> pixels(static_cast<std::size_t>(width * height * 4));
            for (float& v : pixels)
                v = value(random);
            QVERIFY(saveExr(path("a.exr"), width, height, pixels));
            const auto image = loadImage(path("a.exr"));
            QVERIFY(image);
            QCOMPARE((*image)->width, width);
            QVERIFY((*image)->floats == pixels);
            QVERIFY((*image)->bytes.empty());
        }
    }

    void exrValuesBecomeFinite() {
        std::vector<float> pixels(8, 1.0F);
        pixels[0] = std::numeric_limits<float>::quiet_NaN();
        pixels[1] = std::numeric_limits<float>::infinity();
        QVERIFY(saveExr(path("n.exr"), 2, 1, pixels));
        const auto image = loadImage(path("n.exr"));
        QVERIFY(image);
        for (const float v : (*image)->floats)
            QVERIFY(std::isfinite(v));
    }

    void writingLeavesNoTemporaryFile() {
        QTemporaryDir other;
        const std::string file = other.filePath("x.png").toStdString();
        QVERIFY(savePng(file, 1, 1, Bytes{1, 2, 3, 4}));
        QVERIFY(savePng(file, 1, 1, Bytes{4, 3, 2, 1}));
        QCOMPARE(QDir(other.path()).entryList(QDir::Files).size(), 1);
        QVERIFY((*loadImage(file))->bytes == std::vector<std::uint8_t>({4, 3, 2, 1}));
    }

    void writingFaults() {
        QVERIFY(!savePng("/no/such/folder/x.png", 1, 1, Bytes{1, 2, 3, 4}));
        QVERIFY(!savePng(path("x.png"), 2, 2, Bytes{1, 2, 3, 4}));
        QVERIFY(!savePng(folder_.path().toStdString(), 1, 1, Bytes{1, 2, 3, 4}));
        QVERIFY(!saveExr(path("x.exr"), 0, 1, {}));
    }

    void badFilesAreErrors() {
        write(path("empty.png"), {});
        write(path("text.png"), "hello, I am no picture");
        write(path("huge.exr"), QByteArray("\x76\x2f\x31\x01", 4) + QByteArray(60, '\x7f'));
        for (const std::string& file : {path("empty.png"), path("text.png"), path("huge.exr"),
                                        path("missing.png"), folder_.path().toStdString()}) {
            const auto image = loadImage(file);
            QVERIFY(!image);
            QCOMPARE(image.error().file, file);
            QVERIFY(!image.error().message.empty());
        }
    }

    void damagedFilesNeverCrash() {
        std::mt19937 random(9);
        QVERIFY(savePng(path("whole.png"), 16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 77)));
        QVERIFY(saveExr(path("whole.exr"), 20, 20, std::vector<float>(20 * 20 * 4, 0.5F)));
        for (const char* name : {"whole.png", "whole.exr"}) {
            const QByteArray whole = read(path(name));
            QVERIFY(!whole.isEmpty());
            for (int length = 0; length < whole.size(); length += 1 + static_cast<int>(whole.size() / 60)) {
                write(path("cut"), whole.left(length));
                const auto image = loadImage(path("cut"));
                QVERIFY(image || !image.error().message.empty());
            }
        }
        const QByteArray whole = read(path("whole.png"));
        for (int round = 0; round < 200; ++round) {
            QByteArray bent = whole;
            bent[static_cast<int>(random() % static_cast<unsigned>(bent.size()))] =
                static_cast<char>(random());
            write(path("bent"), bent);
            const auto image = loadImage(path("bent"));
            QVERIFY(image || !image.error().message.empty());
        }
    }
};

QTEST_GUILESS_MAIN(TestImageLoader)
#include "tst_image_loader.moc"
