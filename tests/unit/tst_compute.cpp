#include "core/compute/arena.h"
#include "core/compute/kernel_source.h"
#include "core/compute/program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>
#include <map>
#include <random>

using namespace prizma;

class ComputeTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void unknownDeviceIsAnError();
    void defaultDeviceIsListed();
    void arenaKeepsEveryPiece();
    void includesAreExpanded();
    void compileErrorNamesFileAndLine();
    void damagedCacheEntryIsReplaced();

  private:
    std::unique_ptr<Context> context_;
};

void ComputeTest::initTestCase() {
    auto context = Context::create({});
    if (!context)
        QSKIP("There is no OpenCL device here.");
    context_ = std::move(*context);
}

void ComputeTest::unknownDeviceIsAnError() {
    const auto context = Context::create("no such platform / no such device");
    QVERIFY(!context);
    QVERIFY(context.error().message.find("no such device") != std::string::npos);
}

void ComputeTest::defaultDeviceIsListed() {
    const auto devices = listDevices();
    const int index = chooseDevice(devices, {});
    QVERIFY(index >= 0);
    QCOMPARE(devices[static_cast<std::size_t>(index)].id, context_->info().id);
    QCOMPARE(chooseDevice(devices, devices.back().id), static_cast<int>(devices.size()) - 1);
    QCOMPARE(chooseDevice({}, {}), -1);
}

/// Random allocations and releases; every piece must still hold what was written to it, and be disjoint from
/// others.
void ComputeTest::arenaKeepsEveryPiece() {
    std::mt19937 random(7);
    Arena<std::uint32_t> arena("numbers");
    std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
    for (int step = 0; step < 400; ++step) {
        if (pieces.size() < 4 || random() % 5 < 3) {
            std::vector<std::uint32_t> content(random() % 300);
            for (auto& value : content)
                value = static_cast<std::uint32_t>(random());
            const auto first = arena.add(*context_, content);
            QVERIFY(first);
            if (!content.empty())
                pieces[*first] = content;
        } else {
            const auto piece =
                std::next(pieces.begin(), static_cast<std::ptrdiff_t>(random() % pieces.size()));
            arena.release(piece->first, piece->second.size());
            pieces.erase(piece);
        }
        std::uint32_t end = 0;
        for (const auto& [first, content] : pieces) {
            QVERIFY(first >= end);
            end = first + static_cast<std::uint32_t>(content.size());
        }
    }
    for (const auto& [first, content] : pieces) {
        std::vector<std::uint32_t> held(content.size());
        QVERIFY(arena.buffer().read(*context_, held, first, "numbers"));
        QCOMPARE(held, content);
    }
    QVERIFY(context_->allocatedBytes() > 0);
}

void ComputeTest::includesAreExpanded() {
    const std::string source = expandedKernelSource("ray_shader.cl");
    QVERIFY(source.find("#include \"") == std::string::npos);
    QVERIFY(source.find("kernel void rayShader") != std::string::npos);
    QVERIFY(source.find("DeviceInstance;") != std::string::npos);
    QVERIFY(expandedKernelSource("no_such_file.cl").find("kernel") == std::string::npos);
}

void ComputeTest::compileErrorNamesFileAndLine() {
    const auto program = buildProgram(*context_, "display.cl", "-D toByte=1+");
    QVERIFY(!program);
    QVERIFY(program.error().message.find("display.cl") != std::string::npos);
}

void ComputeTest::damagedCacheEntryIsReplaced() {
    QTemporaryDir folder;
    const QByteArray old = qgetenv("XDG_CACHE_HOME");
    qputenv("XDG_CACHE_HOME", folder.path().toLocal8Bit());
    QVERIFY(buildProgram(*context_, "display.cl", ""));
    std::filesystem::path entry;
    for (const auto& file : std::filesystem::directory_iterator(programCacheFolder()))
        entry = file.path();
    QVERIFY(!entry.empty());
    const auto size = std::filesystem::file_size(entry);
    std::ofstream(entry, std::ios::binary) << "this is no program";
    QVERIFY(buildProgram(*context_, "display.cl", ""));
    QCOMPARE(std::filesystem::file_size(entry), size);
    qputenv("XDG_CACHE_HOME", old);
}

QTEST_GUILESS_MAIN(ComputeTest)
#include "tst_compute.moc"
