// What becomes of the materials of model files: MTL with its extensions, glTF, and what other formats say.
#include "core/import/derived_pictures.h"
#include "core/import/gltf_extras.h"
#include "core/import/image_saver.h"
#include "core/import/model_importer.h"
#include "core/import/mtl_reader.h"
#include "core/project/project_file.h"
#include "tests/support/text_file.h"

#include <QFile>
#include <QTest>

#include <cmath>
#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

bool isNear(double a, double b, double slack = 1e-6) {
    return std::abs(a - b) < slack;
}
bool isNear(const glm::dvec3& a, const glm::dvec3& b, double slack = 1e-6) {
    return glm::length(a - b) < slack;
}

std::array<int, 4> pixelAt(const Image& image, int x, int y) {
    const auto i = static_cast<std::size_t>(4 * (y * image.width + x));
    return {image.bytes[i], image.bytes[i + 1], image.bytes[i + 2], image.bytes[i + 3]};
}

ImagePtr makeImage(int width, int height, const std::vector<std::uint8_t>& bytes) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->bytes = bytes;
    for (std::size_t i = 3; i < bytes.size(); i += 4)
        image->opaque = image->opaque && bytes[i] == 255;
    return image;
}

} // namespace

class MaterialImportTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void mtlValues();
    void mtlPlainMaterials_data();
    void mtlPlainMaterials();
    void mtlMapsAndOptions();
    void damagedMtlNeverCrashes();
    void separateMapsAreJoined();
    void opacityMapBecomesAlpha();
    void shininessAndSpecularMaps();
    void bumpMaps();
    void movedTexturesAreToldOf();
    void gltfSaysEverything();
    void gltfDefaults();
    void damagedGltfExtrasNeverCrash();
    void normalsOfHeightsPointDownhill();
    void madePicturesSurviveTheProjectFile();

  private:
    void writePicture(const char* name, int width, int height, const std::vector<std::uint8_t>& pixels) {
        QVERIFY(savePng(folder_.filePath(name).toStdString(), width, height, pixels));
    }

    /// The model of a triangle whose material "m" has these lines.
    ImportedModel importMtl(const std::string& lines) {
        writeFile(folder_, "m.mtl", "newmtl m\n" + lines);
        const auto file = writeFile(folder_, "m.obj",
                                    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                    "usemtl m\nf 1/1 2/2 3/3\n");
        return import(file);
    }

    ImportedModel import(const std::string& file) {
        Progress progress;
        auto model = importModel(file, {}, progress);
        if (!model || model->materials.empty())
            qFatal("%s", model ? "no material" : describe(model.error()).c_str());
        return std::move(*model);
    }

    Material mtl(const std::string& lines) { return importMtl(lines).materials[0]; }

    std::string gltf(const std::string& materials, const std::string& further) {
        return writeFile(
            folder_, "m.gltf",
            R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_materials_specular","KHR_materials_ior",)"
            R"("KHR_materials_transmission","KHR_materials_volume","KHR_materials_emissive_strength"],)"
            R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
            R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
            R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
            R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
            R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)" +
                further + R"("materials":[)" + materials + "]}");
    }

    QTemporaryDir folder_;
};

void MaterialImportTest::initTestCase() {
    writePicture("red.png", 1, 1, {255, 0, 0, 255});
    writePicture("grey.png", 2, 1, {51, 51, 51, 255, 204, 204, 204, 255});
    writePicture("dark.png", 1, 2, {102, 102, 102, 255, 0, 0, 0, 255});
    writePicture("leaf.png", 1, 1, {0, 200, 0, 77});
    writePicture("blue.png", 1, 1, {128, 128, 255, 255});
    std::vector<std::uint8_t> ramp;
    for (int i = 0; i < 50; ++i)
        ramp.insert(ramp.end(), 3, static_cast<std::uint8_t>(5 * i)), ramp.push_back(255);
    writePicture("ramp.png", 50, 1, ramp);
}

void MaterialImportTest::mtlValues() {
    const auto materials = readMtl("Kd 9 9 9\nnewmtl a b\n\tkd .1 .2 .3 # red\nKs 0.5\nNS 1e2\n d -halo 0.5\n"
                                   "Tr 0.25\nillum 4\nKe 1 2 3\nNi 1.4\nPr 0.3\nPm 1\nTf 0 1 0\n"
                                   "map_Kd a picture.png\r\nmap_Pr x.png\nunknown 3\n"
                                   "newmtl c\nKd red green blue\nNs nan\nillum x\n");
    QCOMPARE(materials.size(), std::size_t(2));
    const MtlMaterial& m = materials.at("a b");
    QVERIFY(m.diffuse == glm::dvec3(0.1, 0.2, 0.3) && m.specular == glm::dvec3(0.5));
    QVERIFY(m.shininess == 100.0 && m.dissolve == 0.5 && m.transparency == 0.25 && m.illumination == 4);
    QVERIFY(m.emission == glm::dvec3(1, 2, 3) && m.ior == 1.4 && m.roughness == 0.3 && m.metallic == 1.0);
    QVERIFY(m.filter == glm::dvec3(0, 1, 0));
    QCOMPARE(m.diffuseMap.file, std::string("a picture.png"));
    QCOMPARE(m.roughnessMap.file, std::string("x.png"));
    const MtlMaterial& c = materials.at("c");
    QVERIFY(!c.diffuse && !c.shininess && !c.illumination && !c.diffuseMap.isSet());
}

void MaterialImportTest::mtlPlainMaterials_data() {
    QTest::addColumn<QString>("lines");
    QTest::addColumn<Material>("expected");
    const auto row = [](const char* name, const char* lines, const auto& change) {
        Material material;
        material.specular = 0.0; // of a file that says nothing
        material.roughness = 1.0;
        change(material);
        QTest::newRow(name) << QString(lines) << material;
    };
    row("nothing", "", [](Material&) {});
    row("highlight", "Kd 0.5 0.5 0.5\nKs 0.25 0.5 0.125\nNs 30\nillum 2", [](Material& m) {
        m.baseColor = glm::dvec3(0.5);
        m.specular = 0.5;
        m.specularColor = {0.5, 1.0, 0.25};
        m.roughness = std::sqrt(0.25); // alpha² = 2 / 32, alpha = roughness²
    });
    row("metal by its colours", "Kd 0.01 0.01 0.01\nKs 0.9 0.7 0.3\nNs 30", [](Material& m) {
        m.baseColor = {0.9, 0.7, 0.3};
        m.metallic = 1.0;
        m.specular = 0.9;
        m.roughness = 0.5;
    });
    row("mirror", "Kd 0 0 0\nKs 0.9 0.9 0.9\nNs 5\nillum 3", [](Material& m) {
        m.baseColor = glm::dvec3(0.9);
        m.metallic = 1.0;
        m.specular = 0.9;
        m.roughness = 0.0;
    });
    row("glossy paint", "Kd 0.8 0 0\nKs 0.1 0.1 0.1\nillum 5", [](Material& m) {
        m.baseColor = {0.8, 0, 0};
        m.specular = 0.1;
        m.roughness = 0.0;
    });
    const auto glass = [](double transmission, double ior) {
        return [=](Material& m) {
            m.baseColor = glm::dvec3(1.0);
            m.transmission = transmission;
            m.ior = ior;
            m.specular = 1.0;
            m.roughness = 0.0;
        };
    };
    row("glass", "Kd 0.02 0.02 0.02\nNi 1.33\nNs 100\nillum 7", glass(1.0, 1.33));
    row("glass by d", "Kd 1 1 1\nNi 1.4\nd 0.25\nillum 2", glass(0.75, 1.4));
    row("glass by Tr", "Kd 1 1 1\nNi 1.4\nTr 1\nillum 6", glass(1.0, 1.4));
    row("veil", "Kd 1 1 1\nd 0.25\nNi 1\nillum 2", [](Material& m) {
        m.baseColor = glm::dvec3(1.0);
        m.alpha = 0.25;
    });
    row("d before Tr", "d 0.75\nTr 0.75", [](Material& m) { m.alpha = 0.75; });
    row("the other Tr", "Tr 1", [](Material&) {});
    row("physical", "Kd 0.9 0.6 0.3\nPr 0.25\nPm 0.75\nNs 500\nillum 3", [](Material& m) {
        m.baseColor = {0.9, 0.6, 0.3};
        m.specular = 1.0;
        m.roughness = 0.25;
        m.metallic = 0.75;
    });
    row("light", "Kd 0 0 0\nKe 4 5 6", [](Material& m) {
        m.baseColor = glm::dvec3(0.0);
        m.emission = {4, 5, 6};
    });
    row("out of range", "Kd 7 -1 0.5\nKs -1 0 0\nNs -5\nd 3\nPr 9\nPm -2\nKe -1 0 0", [](Material& m) {
        m.baseColor = {1, 0, 0.5};
        m.roughness = 1.0;
    });
}
void MaterialImportTest::mtlPlainMaterials() {
    QFETCH(QString, lines);
    QFETCH(Material, expected);
    const Material m = mtl(lines.toStdString());
    QVERIFY(isNear(m.baseColor, expected.baseColor));
    QVERIFY(isNear(m.emission, expected.emission));
    QVERIFY(isNear(m.specularColor, expected.specularColor));
    QVERIFY2(isNear(m.specular, expected.specular), qPrintable(QString::number(m.specular)));
    QVERIFY2(isNear(m.roughness, expected.roughness), qPrintable(QString::number(m.roughness)));
    QVERIFY(isNear(m.metallic, expected.metallic));
    QVERIFY(isNear(m.transmission, expected.transmission));
    QVERIFY(isNear(m.alpha, expected.alpha));
    QVERIFY(isNear(m.ior, expected.ior));
    QVERIFY(m.doubleSided && m.alphaMode == AlphaMode::Blend);
}

void MaterialImportTest::mtlMapsAndOptions() {
    const auto materials = readMtl(
        "newmtl m\nbump -bm 0.5 -clamp on -imfchan l my bump.png\nmap_Kd -s 1 1 1 -o 0 0 -mm 0 1 a.png\n"
        "map_Ks -s 2 2 b.png\nmap_Ke -o 0.5 c.png\nmap_d -blendu off d.png\nnorm -bm 2 e.png\n"
        "map_Pm -unknown 3 f.png\nmap_Pr -bm\nmap_Ns\n");
    const MtlMaterial& m = materials.at("m");
    QCOMPARE(m.bumpMap.file, std::string("my bump.png"));
    QCOMPARE(m.bumpMap.bumpScale, 0.5);
    QCOMPARE(m.diffuseMap.file, std::string("a.png"));
    QVERIFY(!m.diffuseMap.isPlaced && m.specularMap.isPlaced && m.emissionMap.isPlaced);
    QCOMPARE(m.specularMap.file, std::string("b.png"));
    QCOMPARE(m.emissionMap.file, std::string("c.png"));
    QCOMPARE(m.dissolveMap.file, std::string("d.png"));
    QCOMPARE(m.normalMap.bumpScale, 2.0);
    QCOMPARE(m.metallicMap.file, std::string("-unknown 3 f.png"));
    QVERIFY(!m.roughnessMap.isSet() && !m.shininessMap.isSet());
}

void MaterialImportTest::damagedMtlNeverCrashes() {
    const std::string whole = "newmtl a\nKd 0.1 0.2 0.3\nmap_Kd -s 1 2 3 -bm 4 \"red.png\"\nNs 4\nillum 2\n"
                              "bump -bm 2 grey.png\nmap_d -o 1 leaf.png\nPr 0.3\nd 0.5\n";
    std::mt19937 random(8);
    for (int round = 0; round < 20'000; ++round) {
        std::string bent = whole.substr(0, random() % whole.size() + 1);
        for (auto i = random() % 6; i > 0; --i)
            bent[random() % bent.size()] = static_cast<char>(random());
        for (const auto& [name, m] : readMtl(bent))
            for (const auto& value : {m.shininess, m.ior, m.dissolve, m.roughness})
                QVERIFY(!value || std::isfinite(*value));
    }
}

void MaterialImportTest::separateMapsAreJoined() {
    const Material m = mtl("Pr 0.1\nPm 0.1\nmap_Pr grey.png\nmap_Pm dark.png\n");
    QVERIFY(m.roughness == 1.0 && m.metallic == 1.0);
    const Image& joined = *m.metallicRoughnessTexture.image;
    QVERIFY(joined.width == 2 && joined.height == 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            const auto pixel = pixelAt(joined, x, y);
            QCOMPARE(pixel[1], x == 0 ? 51 : 204);
            QCOMPARE(pixel[2], y == 0 ? 102 : 0);
        }
    const Material rough = mtl("Pm 0.5\nmap_Pr grey.png\n");
    QVERIFY(rough.roughness == 1.0 && rough.metallic == 0.5);
    QCOMPARE(pixelAt(*rough.metallicRoughnessTexture.image, 0, 0)[2], 255);
    const Material packed = mtl("map_Pr grey.png\nmap_Pm grey.png\n");
    QVERIFY(packed.metallicRoughnessTexture.file.ends_with("/grey.png"));
    const Material none = mtl("Pr 0.25\nPm 0.5\nmap_Pr missing.png\n");
    QVERIFY(none.roughness == 0.25 && !none.metallicRoughnessTexture.isSet());
}

void MaterialImportTest::opacityMapBecomesAlpha() {
    const Material m = mtl("map_Kd red.png\nmap_d grey.png\n");
    const Image& joined = *m.baseColorTexture.image;
    QVERIFY(!joined.opaque && joined.width == 2 && joined.height == 1);
    QVERIFY(pixelAt(joined, 1, 0) == (std::array{255, 0, 0, 204}));
    const Material alone = mtl("Kd 0.5 0.5 0.5\nd 0\nmap_d leaf.png\n"); // by its alpha channel
    QVERIFY(pixelAt(*alone.baseColorTexture.image, 0, 0) == (std::array{255, 255, 255, 77}));
    QVERIFY(alone.alpha == 1.0 && isNear(alone.baseColor, glm::dvec3(0.5)));
    const Material same = mtl("map_Kd leaf.png\nmap_d leaf.png\n");
    QVERIFY(same.baseColorTexture.file.ends_with("/leaf.png"));
    const Material missing = mtl("map_Kd nowhere.png\nmap_d leaf.png\n"); // still seen to be missing
    QVERIFY(missing.baseColorTexture.isSet() && !missing.baseColorTexture.image);
}

void MaterialImportTest::shininessAndSpecularMaps() {
    const Material m = mtl("Ks 0 0 0\nNs 100\nmap_Ns grey.png\nmap_Ks grey.png\nmap_Ke red.png\n");
    QVERIFY(m.roughness == 1.0 && m.specular == 1.0 && isNear(m.emission, glm::dvec3(1.0)));
    const int wanted = static_cast<int>(std::lround(std::pow(2.0 / (100.0 * 0.2 + 2.0), 0.25) * 255.0));
    QCOMPARE(pixelAt(*m.metallicRoughnessTexture.image, 0, 0)[1], wanted);
    QCOMPARE(pixelAt(*m.metallicRoughnessTexture.image, 0, 0)[2], 255);
    QCOMPARE(pixelAt(*m.specularTexture.image, 1, 0)[3], 204);
    QVERIFY(m.emissionTexture.image);
}

void MaterialImportTest::bumpMaps() {
    const Material normal = mtl("map_Bump -bm 0.5 blue.png\n");
    QVERIFY(normal.normalTexture.file.ends_with("/blue.png"));
    QCOMPARE(normal.normalScale, 0.5);
    const Material height = mtl("map_Bump ramp.png\n");
    QVERIFY(height.normalTexture.image && height.normalScale == 1.0);
    const Material both = mtl("bump ramp.png\nnorm -bm 2 blue.png\n");
    QVERIFY(both.normalTexture.file.ends_with("/blue.png"));
    QCOMPARE(both.normalScale, 2.0);
}

void MaterialImportTest::normalsOfHeightsPointDownhill() {
    // A slope that rises to the right by 5/255 a pixel, 50 pixels wide: height 1 is one pixel high.
    const Material m = mtl("bump -bm 3 ramp.png\n");
    const auto pixel = pixelAt(*m.normalTexture.image, 20, 0);
    const double slope = 3.0 * 5.0 / 255.0;
    QVERIFY(std::abs(pixel[0] - (0.5 - 0.5 * slope / std::hypot(slope, 1.0)) * 255.0) <= 0.5 + 1e-3);
    QCOMPARE(pixel[1], 128);
    // Rising towards the top: the normal leans down, and green is up.
    std::vector<std::uint8_t> rows;
    for (int i = 0; i < 50; ++i)
        rows.insert(rows.end(), 3, static_cast<std::uint8_t>(250 - 5 * i)), rows.push_back(255);
    const ImagePtr normals = normalsFromHeights(makeImage(1, 50, rows), 50.0);
    QVERIFY(pixelAt(*normals, 0, 20)[1] < 127);
    QCOMPARE(pixelAt(*normals, 0, 20)[0], 128);
}

void MaterialImportTest::movedTexturesAreToldOf() {
    QCOMPARE(importMtl("map_Kd -s 1 1 red.png\n").warnings.size(), std::size_t(0));
    const auto model = importMtl("map_Kd -s 2 2 red.png\nmap_Ke -s 2 2 red.png\n");
    QCOMPARE(model.warnings.size(), std::size_t(1));
    QVERIFY(model.warnings[0].file.ends_with("/red.png"));
    QVERIFY(model.materials[0].baseColorTexture.image);
}

void MaterialImportTest::gltfSaysEverything() {
    const auto model = import(gltf(
        R"({"name":"all","pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"baseColorTexture":{"index":0},
        "metallicFactor":0.25,"roughnessFactor":0.75,"metallicRoughnessTexture":{"index":1}},
        "normalTexture":{"index":2,"scale":0.5},"emissiveTexture":{"index":3},"emissiveFactor":[0.5,0.25,1],
        "alphaMode":"MASK","alphaCutoff":0.3,"doubleSided":true,"extensions":{
        "KHR_materials_specular":{"specularFactor":0.7,"specularTexture":{"index":5},"specularColorFactor":[1,0.5,0.25]},
        "KHR_materials_ior":{"ior":1.4},
        "KHR_materials_transmission":{"transmissionFactor":0.9,"transmissionTexture":{"index":4}},
        "KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2.5,"attenuationColor":[0.5,0.6,0.7]},
        "KHR_materials_emissive_strength":{"emissiveStrength":8}}})",
        R"("images":[{"uri":"red.png"},{"uri":"grey.png"},{"uri":"blue.png"},{"uri":"dark.png"},{"uri":"ramp.png"},
        {"uri":"leaf.png"}],"textures":[{"source":0},{"source":1},{"source":2},{"source":3},{"source":4},{"source":5}],)"));
    const Material& m = model.materials[0];
    QVERIFY(isNear(m.baseColor, {0.1, 0.2, 0.3}) && isNear(m.alpha, 0.4));
    QVERIFY(isNear(m.metallic, 0.25) && isNear(m.roughness, 0.75) && isNear(m.normalScale, 0.5));
    QVERIFY(m.alphaMode == AlphaMode::Mask && isNear(m.alphaCutoff, 0.3) && m.doubleSided);
    QVERIFY(isNear(m.emission, {0.5, 0.25, 1}) && isNear(m.emissionStrength, 8.0));
    QVERIFY(isNear(m.specular, 0.7) && isNear(m.specularColor, {1, 0.5, 0.25}));
    QVERIFY(isNear(m.transmission, 0.9) && isNear(m.ior, 1.4));
    QVERIFY(isNear(m.attenuationDistance, 2.5) && isNear(m.attenuationColor, {0.5, 0.6, 0.7}));
    const auto shows = [](const Texture& texture, const char* file) {
        return texture.image && texture.file.ends_with(file);
    };
    QVERIFY(shows(m.baseColorTexture, "/red.png") && shows(m.metallicRoughnessTexture, "/grey.png"));
    QVERIFY(shows(m.normalTexture, "/blue.png") && shows(m.emissionTexture, "/dark.png"));
    QVERIFY(shows(m.transmissionTexture, "/ramp.png") && shows(m.specularTexture, "/leaf.png"));
    QVERIFY(model.warnings.empty());
}

void MaterialImportTest::gltfDefaults() {
    const Material m = import(gltf("{}", "")).materials[0];
    QVERIFY(m.alphaMode == AlphaMode::Opaque && !m.doubleSided);
    QVERIFY(m.metallic == 1.0 && m.roughness == 1.0 && m.specular == 1.0 && m.ior == 1.5);
    QVERIFY(isNear(m.baseColor, glm::dvec3(1.0)) && isNear(m.emission, glm::dvec3(0.0)));
    const Material blended = import(gltf(R"({"alphaMode":"BLEND"})", "")).materials[0];
    QVERIFY(blended.alphaMode == AlphaMode::Blend);
    // A black emission factor is meant, whatever the texture.
    const Material dark = import(gltf(R"({"emissiveTexture":{"index":0}})",
                                      R"("images":[{"uri":"red.png"}],"textures":[{"source":0}],)"))
                              .materials[0];
    QVERIFY(isNear(dark.emission, glm::dvec3(0.0)));
}

void MaterialImportTest::damagedGltfExtrasNeverCrash() {
    const std::string whole =
        R"({"images":[{"uri":"a"},{"bufferView":1},{"bufferView":2}],"textures":[{"source":2},{"source":9}],"materials":[{"extensions":)"
        R"({"KHR_materials_specular":{"specularTexture":{"index":0,"extensions":{"KHR_texture_transform":{}}},"specularFactor":0.5,)"
        R"("specularColorFactor":[1,0.5,0]},"KHR_materials_emissive_strength":{"emissiveStrength":3}}},{}]})";
    const auto extras = readGltfExtras(whole);
    QCOMPARE(extras.size(), std::size_t(2));
    QCOMPARE(extras[0].specularImage, std::string("*1"));
    QVERIFY(extras[0].hasMovedTextures && extras[0].emissiveStrength == 3.0);
    std::mt19937 random(2);
    for (int round = 0; round < 20'000; ++round) {
        std::string bent = whole;
        for (auto i = random() % 4 + 1; i > 0; --i)
            bent[random() % bent.size()] = static_cast<char>(random() % 96 + 32);
        QVERIFY(readGltfExtras(bent).size() <= 10);
    }
    QVERIFY(readGltfExtras("glTF").empty() && readGltfExtras("").empty());
    QVERIFY(readGltfExtras(std::string(100'000, '[')).empty());
}

void MaterialImportTest::madePicturesSurviveTheProjectFile() {
    const auto model = importMtl("Kd 1 1 1\nmap_Kd red.png\nmap_d grey.png\nmap_Pr ramp.png\nbump ramp.png\n"
                                 "map_Ks grey.png\nmap_Ke red.png\n");
    Scene scene;
    MeshSource source;
    source.file = folder_.filePath("m.obj").toStdString();
    addModel(scene, model, source);
    scene.materials.edit()[0].roughness = 0.25; // so that the file holds the material
    const std::string file = folder_.filePath("p.prizma").toStdString();
    QVERIFY(saveProject(file, scene));
    Progress progress;
    const auto loaded = loadProject(file, progress);
    QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
    QVERIFY2(loaded->warnings.empty(), loaded->warnings.empty() ? "" : describe(loaded->warnings[0]).c_str());
    const Material& before = scene.materials[0];
    const Material& after = loaded->scene.materials[0];
    QCOMPARE(after.roughness, 0.25);
    const auto old = texturesOf(before);
    const auto now = texturesOf(after);
    for (std::size_t i = 0; i < old.size(); ++i) {
        QCOMPARE(now[i].file, old[i].file);
        QCOMPARE(now[i].image != nullptr, old[i].image != nullptr);
        QVERIFY(!old[i].image || now[i].image->bytes == old[i].image->bytes);
    }
}

QTEST_GUILESS_MAIN(MaterialImportTest)
#include "tst_material_import.moc"
