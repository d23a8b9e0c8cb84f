#pragma once

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <string>

namespace prizma::test {

/// Writes a file into `folder`, making the folders that its name asks for, and gives its path.
inline std::string writeFile(const QTemporaryDir& folder, const QString& name, const std::string& content) {
    QDir(folder.path()).mkpath(QFileInfo(name).path());
    QFile stream(folder.filePath(name));
    if (!stream.open(QIODevice::WriteOnly) ||
        stream.write(content.data(), static_cast<qint64>(content.size())) !=
            static_cast<qint64>(content.size()))
        qFatal("no test file");
    return stream.fileName().toStdString();
}

} // namespace prizma::test
