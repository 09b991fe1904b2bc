// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/profile_row.hpp"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <string>
#include <utility>

#include "hmi/profile/typed_value.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "shared/profile_text.hpp"

namespace psicarve::ui {
namespace {

enum Column { kChanged, kName, kValue, kUnit, kBounds, kBuiltIn };
constexpr int kChangedWidth = 12;
constexpr int kNameWidth = 150;
constexpr int kValueWidth = 112;
constexpr int kUnitWidth = 66;
constexpr int kBuiltInWidth = 84;

QLabel* cell(const QString& text, const char* role, int width) {
    QLabel* label = role_label(role, text);
    if (width > 0) label->setFixedWidth(width);
    return label;
}

/// "0.001 ... 10000": what the words between say is clear from the column.
QString short_bounds(const ProfileKey& spec) {
    QString text = QString::fromStdString(spec.bounds);
    for (const char* between : {" <= value <= ", " <= first < second <= "}) text.replace(between, " ... ");
    return text;
}

QString text_of(const std::string& text) {
    return QString::fromStdString(text);
}

}  // namespace

ProfileRow::ProfileRow(std::size_t key, bool in_full, Events events, QWidget* parent)
    : QFrame(parent), key_(key), events_(std::move(events)), grid_(new QGridLayout{this}) {
    const ProfileKey& spec = profile_keys()[key];
    setObjectName("row_" + text_of(spec.path));
    setToolTip(QCoreApplication::translate("profile", spec.explanation.c_str()));
    const std::string name = in_full ? spec.path : std::string(leaf_of_key(spec.path));
    changed_ = cell({}, "head", kChangedWidth);
    built_in_ = cell(text_of(profile::typed_from_toml(spec, spec.built_in)), "label", kBuiltInWidth);
    problem_ = role_label("problem");
    problem_->setWordWrap(true);
    problem_->hide();
    make_editor();
    QWidget* editor = line_ != nullptr ? static_cast<QWidget*>(line_) : words_;
    editor->setFixedWidth(kValueWidth);
    editor->setAccessibleName(text_of(spec.path));
    editor->installEventFilter(this);
    grid_->setContentsMargins(kGap, 2, kGap, 2);
    grid_->setHorizontalSpacing(kGap);
    grid_->setVerticalSpacing(2);
    grid_->addWidget(changed_, 0, kChanged);
    grid_->addWidget(cell(text_of(name), "", kNameWidth), 0, kName);
    grid_->addWidget(editor, 0, kValue);
    grid_->addWidget(cell(text_of(spec.unit), "label", kUnitWidth), 0, kUnit);
    grid_->addWidget(cell(short_bounds(spec), "label", 0), 0, kBounds);
    grid_->addWidget(built_in_, 0, kBuiltIn);
    grid_->addWidget(problem_, 1, kName, 1, kBuiltIn - kName + 1);
    grid_->setColumnStretch(kBounds, 1);
}

void ProfileRow::make_editor() {
    const ProfileKey& spec = profile_keys()[key_];
    if (spec.words.empty()) {
        line_ = new QLineEdit;
        connect(line_, &QLineEdit::textEdited, this, [this](const QString& text) { events_.typed(text); });
        return;
    }
    words_ = new ChoiceBox;
    for (const std::string& word : spec.words) words_->addItem(text_of(word));
    // A wheel over the page is meant for the page.
    words_->setFocusPolicy(Qt::StrongFocus);
    connect(words_, &QComboBox::currentTextChanged, this,
            [this](const QString& text) { events_.typed(text); });
}

bool ProfileRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) events_.looked_at();
    if (event->type() == QEvent::Wheel && watched == words_ && !words_->hasFocus()) {
        event->ignore();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

void ProfileRow::show_state(const profile::ProfileDraft& draft) {
    const QString typed = text_of(draft.typed(key_));
    if (line_ != nullptr && line_->text() != typed) line_->setText(typed);
    if (words_ != nullptr && words_->currentText() != typed) {
        const QSignalBlocker still(words_);
        // A word that nobody knows stands in the file: it is shown until a known one is chosen.
        if (words_->findText(typed) < 0) words_->addItem(typed);
        words_->setCurrentText(typed);
    }
    changed_->setText(draft.is_changed(key_) ? QStringLiteral("\u25CF") : QString{});
    changed_->setToolTip(draft.is_changed(key_) ? tr("In the file: %1").arg(text_of(draft.saved(key_)))
                                                : QString{});
    QFont font = built_in_->font();
    font.setBold(draft.differs_from_built_in(key_));
    built_in_->setFont(font);
    const std::string& problem = draft.problem(key_);
    problem_->setText(text_of(problem));
    problem_->setVisible(!problem.empty());
    set_styled(this, "invalid", !problem.empty());
    QWidget* editor = line_ != nullptr ? static_cast<QWidget*>(line_) : words_;
    set_styled(editor, "invalid", !problem.empty());
    editor->setAccessibleDescription(text_of(problem));
}

}  // namespace psicarve::ui
