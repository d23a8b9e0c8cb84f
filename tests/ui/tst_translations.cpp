// Every text of the property tables has a Hungarian one. (Texts of widgets are found by lupdate.)
#include "core/scene/property_tables.h"

#include <QFile>
#include <QHash>
#include <QTest>
#include <QXmlStreamReader>

using namespace prizma;

class TestTranslations : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void propertiesAreTranslated();
    void choicesAreTranslated();

  private:
    void check(std::string_view text);
    template <class Owner>
    void checkProperties();
    template <class Enum>
    void checkChoices();

    QHash<QString, QString> texts_; ///< Of the context "properties".
    QStringList missing_;
};

void TestTranslations::initTestCase() {
    QFile file(QStringLiteral(PRIZMA_SOURCE_DIR "/translations/prizma_hu.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString context;
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("source"))
            source = xml.readElementText();
        else if (xml.name() == QLatin1String("translation") && context == QLatin1String("properties"))
            texts_.insert(source, xml.readElementText(QXmlStreamReader::IncludeChildElements));
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(!texts_.isEmpty());
}

void TestTranslations::check(std::string_view text) {
    const QString source = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    if (!source.isEmpty() && texts_.value(source).isEmpty() && !missing_.contains(source))
        missing_ += source;
}

template <class Owner>
void TestTranslations::checkProperties() {
    for (const Property<Owner>& property : propertiesOf<Owner>())
        for (const std::string_view text : {property.label, property.help, property.section})
            check(text);
}

template <class Enum>
void TestTranslations::checkChoices() {
    for (const Choice& choice : choicesOf<Enum>())
        check(choice.label);
}

void TestTranslations::propertiesAreTranslated() {
    missing_.clear();
    checkProperties<Object>();
    checkProperties<Light>();
    checkProperties<Material>();
    checkProperties<Group>();
    checkProperties<Camera>();
    checkProperties<Background>();
    checkProperties<Timeline>();
    checkProperties<RenderSettings>();
    QVERIFY2(missing_.isEmpty(), qPrintable(missing_.join(QLatin1Char('\n'))));
}

void TestTranslations::choicesAreTranslated() {
    missing_.clear();
    checkChoices<LightType>();
    checkChoices<ShaderType>();
    checkChoices<ViewTransform>();
    checkChoices<AlphaMode>();
    checkChoices<PrimitiveType>();
    checkChoices<UpAxis>();
    checkChoices<LoopMode>();
    QVERIFY2(missing_.isEmpty(), qPrintable(missing_.join(QLatin1Char('\n'))));
}

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
