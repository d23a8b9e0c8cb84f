#include "ui/main_window/file_actions.h"

#include "core/scene/starter_scene.h"
#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/document/strings.h"
#include "ui/import/background_job.h"
#include "ui/import/import_controller.h"
#include "ui/import/import_options_dialog.h"
#include "ui/import/import_settings.h"
#include "ui/main_window/file_dialog.h"
#include "ui/main_window/theme.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>

#include <algorithm>

namespace prizma {
namespace {

const QString projectSuffix = QStringLiteral("prizma");

bool isProject(const QString& file) {
    return QFileInfo(file).suffix().toLower() == projectSuffix;
}

QString patternsOf(const std::vector<std::string>& extensions) {
    QStringList patterns;
    for (const std::string& extension : extensions)
        patterns += QStringLiteral("*.") + toQString(extension);
    return patterns.join(QLatin1Char(' '));
}

QString modelFilter() {
    return FileActions::tr("3D models (%1)").arg(patternsOf(modelExtensions()));
}

QString animationFilter() {
    return FileActions::tr("Animations (%1)").arg(patternsOf(animationExtensions()));
}

/// Whether one must look into some of the files to know what they are.
bool mayHoldAnimations(const QStringList& files) {
    return std::ranges::any_of(files, [](const QString& file) {
        const QString suffix = QFileInfo(file).suffix().toLower();
        return suffix == QLatin1String("smd") || suffix == QLatin1String("md5anim");
    });
}

QStringList toQStrings(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts)
        list += toQString(text);
    return list;
}

} // namespace

FileActions::FileActions(Document& document, ImportController& importer, QMainWindow& window)
    : QObject(&window),
      document_(document),
      importer_(importer),
      window_(window),
      unsavedChanges_(
          document, [this](const std::function<void()>& whenSaved) { save(whenSaved); }, window) {
    connect(&recentFiles_, &RecentFiles::chosen, this, &FileActions::openFile);
    connect(&importer_, &ImportController::projectLoaded, this, &FileActions::takeProject);
    connect(&importer_, &ImportController::failed, this, [this](const QString& file) {
        sample_.clear();
        if (!QFileInfo::exists(file))
            recentFiles_.remove(file);
    });
}

void FileActions::fillMenu(QMenu& menu, const QList<QAction*>& exports) {
    const auto add = [&](const char* iconName, const QString& text, const QKeySequence& key, auto&& slot) {
        QAction* action = menu.addAction(icon(QString::fromLatin1(iconName)), text, this, slot);
        action->setShortcut(key);
        return action;
    };
    add("document-new", tr("&New"), QKeySequence::New, [this] {
        newScene();
    })->setStatusTip(tr("Start with an empty scene"));
    add("document-open", tr("&Open…"), QKeySequence::Open, [this] {
        open();
    })->setStatusTip(tr("Open a project file"));
    QMenu* recent = menu.addMenu(icon(QStringLiteral("document-open-recent")), tr("Open &Recent"));
    recentFiles_.attach(*recent);
    menu.addSeparator();
    add("document-save", tr("&Save"), QKeySequence::Save, [this] { save({}); });
    add("document-save-as", tr("Save &As…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S, [this] { saveAs({}); });
    menu.addSeparator();
    add("document-import", tr("&Import Model…"), Qt::CTRL | Qt::Key_I, [this] {
        import();
    })->setStatusTip(tr("Add the contents of model files to the scene"));
    add("document-import", tr("Import A&nimation…"), Qt::CTRL | Qt::SHIFT | Qt::Key_I, [this] {
        importAnimation();
    })->setStatusTip(tr("Give the selected object the clips of animation files"));
    menu.addActions(exports);
    menu.addSeparator();
    QAction* quit = add("application-exit", tr("&Quit"), QKeySequence::Quit, [this] { window_.close(); });
    quit->setShortcut(Qt::CTRL | Qt::Key_Q); // no desktop, no standard key
    quit->setMenuRole(QAction::QuitRole);
}

void FileActions::newScene() {
    unsavedChanges_.guard([this] {
        importer_.cancel();
        document_.reset(makeStarterScene(), {});
    });
}

void FileActions::open() {
    auto* dialog = new QFileDialog(&window_, tr("Open a Project"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Prizma projects (*.prizma)"), tr("All files (*)")});
    showFileDialog(dialog, QStringLiteral("project"),
                   [this](const QStringList& files) { openFile(files.value(0)); });
}

void FileActions::openFile(const QString& file) {
    unsavedChanges_.guard([this, file] { load(file, false); });
}

void FileActions::openSample(const QString& file) {
    document_.reset(Scene{}, {}); // nothing to see until it is there, rather than another scene for a blink
    load(file, true);
}

void FileActions::load(const QString& file, bool asSample) {
    importer_.cancel();
    sample_ = asSample ? file : QString();
    loadRevision_ = document_.revision();
    importer_.loadProject(file);
}

void FileActions::takeProject(const QString& file, const std::shared_ptr<Project>& project) {
    const bool asSample = !sample_.isEmpty();
    sample_.clear();
    const auto take = [this, file, project, asSample] {
        document_.reset(project->scene, asSample ? QString() : file,
                        asSample ? nullptr : project->unknownKeys);
        if (!asSample)
            recentFiles_.add(file);
    };
    // Somebody may have gone on working while the file was read: that is not what was agreed to be lost.
    if (document_.revision() == loadRevision_)
        take();
    else
        unsavedChanges_.guard(take);
}

void FileActions::save(const std::function<void()>& whenSaved) {
    if (document_.file().isEmpty())
        saveAs(whenSaved);
    else
        saveFile(document_.file(), whenSaved);
}

void FileActions::saveAs(const std::function<void()>& whenSaved) {
    auto* dialog = new QFileDialog(&window_, tr("Save the Project"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Prizma projects (*.prizma)"));
    dialog->setDefaultSuffix(projectSuffix);
    if (!document_.file().isEmpty())
        dialog->selectFile(document_.file());
    showFileDialog(dialog, QStringLiteral("project"),
                   [this, whenSaved](const QStringList& files) { saveFile(files.value(0), whenSaved); });
}

void FileActions::saveFile(const QString& file, const std::function<void()>& whenSaved) {
    const QString fault = document_.save(file);
    if (!fault.isEmpty()) {
        Q_EMIT message({Severity::Error, toStdString(fault), toStdString(file), 0});
        report(tr("The Project Was Not Saved"), fault);
        return;
    }
    recentFiles_.add(document_.file());
    Q_EMIT saved(document_.file());
    if (whenSaved)
        whenSaved();
}

void FileActions::import() {
    auto* dialog = new QFileDialog(&window_, tr("Import Models"));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters({modelFilter(), tr("All files (*)")});
    showFileDialog(dialog, QStringLiteral("model"), [this](const QStringList& files) { takeFiles(files); });
}

void FileActions::importAnimation() {
    if (animationTarget(document_) == noId) {
        report(tr("No Object Can Be Animated"),
               tr("Select the object that the animation is for. It must have bones."));
        return;
    }
    auto* dialog = new QFileDialog(&window_, tr("Import Animations"));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters({animationFilter(), tr("All files (*)")});
    showFileDialog(dialog, QStringLiteral("animation"),
                   [this](const QStringList& files) { importAnimationFiles(files); });
}

void FileActions::importAnimationFiles(const QStringList& files) {
    const Id target = animationTarget(document_);
    if (target != noId)
        importer_.importAnimations(files, target);
    else
        report(
            tr("No Object Can Be Animated"),
            tr("%1 is an animation. Import the model that it belongs to as well, or select the object that "
               "it is for.")
                .arg(QFileInfo(files.value(0)).fileName()));
}

void FileActions::askAndImport(const QStringList& models, const QStringList& animations) {
    if (models.isEmpty()) {
        if (!animations.isEmpty())
            importAnimationFiles(animations);
        return;
    }
    if (const auto remembered = rememberedImportOptions(models.first())) {
        importFiles(models, *remembered, animations);
        return;
    }
    auto* dialog = new ImportOptionsDialog(models, &window_);
    connect(dialog, &QDialog::accepted, this, [this, dialog, models, animations] {
        if (dialog->isRemembered())
            rememberImportOptions(models.first(), dialog->options());
        importFiles(models, dialog->options(), animations);
    });
    dialog->open();
}

void FileActions::importFiles(const QStringList& models, const ImportOptions& options,
                              const QStringList& animations) {
    if (animations.isEmpty()) {
        for (const QString& file : models)
            importer_.importModel(file, options);
        return;
    }
    BatchFiles together;
    for (const QString& file : models)
        together.models.push_back(toStdString(file));
    for (const QString& file : animations)
        together.animations.push_back(toStdString(file));
    importer_.importTogether(together, options);
}

void FileActions::takeFiles(const QStringList& files) {
    QStringList models;
    QString project;
    for (const QString& file : files) {
        if (isProject(file))
            project = file;
        else
            models += file;
    }
    if (project.isEmpty())
        takeModels(models);
    else // the models go into the project: both are read one after the other
        unsavedChanges_.guard([this, project, models] {
            load(project, false);
            for (const QString& model : models)
                importer_.importModel(model, importOptionsFor(model));
        });
}

void FileActions::takeModels(const QStringList& files) {
    if (!mayHoldAnimations(files)) {
        askAndImport(files, {});
        return;
    }
    new BackgroundJob(
        tr("Looking at %1…").arg(QFileInfo(files.value(0)).fileName()),
        [this, files](Progress&) -> BackgroundJob::Delivery {
            std::vector<std::string> names;
            for (const QString& file : files)
                names.push_back(toStdString(file));
            const BatchFiles sorted = sortFiles(names);
            return [this, sorted] { askAndImport(toQStrings(sorted.models), toQStrings(sorted.animations)); };
        },
        this);
}

void FileActions::report(const QString& title, const QString& text) {
    auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::Ok, &window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace prizma
