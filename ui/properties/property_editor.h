#pragma once

#include "core/diagnostic.h"
#include "core/scene/properties.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace prizma {

class Document;
class MaterialSlots;
class PropertyRow;

/// Shows and edits the properties of what is selected. It knows no property by itself: all come from the
/// tables in core. If several things of one kind are selected, an edit is for all of them.
class PropertyEditor : public QWidget {
    Q_OBJECT

  public:
    explicit PropertyEditor(Document& document, QWidget* parent = nullptr);

  Q_SIGNALS:
    void message(const prizma::Diagnostic& diagnostic);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void refresh();
    void rebuild(const std::vector<PropertyInfo>& properties);
    void addRow(const PropertyInfo& property);
    void addSection(std::string_view section);
    void showHeading();
    void report(const QString& fault);
    void loadTexture(const std::string& key, const QString& file);

    Document& document_;
    std::vector<EntityRef> entities_; ///< Selected things of the current one's kind, the current one last.
    std::vector<std::string> layoutOfRows_; ///< What the present rows were made for.
    std::vector<PropertyRow*> rows_;
    int gesture_ = 0;

    QLabel* icon_;
    QLabel* heading_;
    QLabel* hint_;
    QVBoxLayout* content_;
    QWidget* grid_ = nullptr;
    MaterialSlots* slots_;
};

} // namespace prizma
