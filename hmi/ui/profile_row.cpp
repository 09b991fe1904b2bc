// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/profile_row.hpp"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <string>
#include <utility>

#include "hmi/phrase/profile_phrase.hpp"
#include "hmi/profile/typed_value.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::ui {
namespace {

enum Column { kChanged, kName, kValue, kUnit, kBounds, kBuiltIn };
constexpr int kChangedWidth = 12;
constexpr int kProfileRowNameWidth = 150;
constexpr int kValueWidth = 112;
constexpr int kProfileRowUnitWidth = 66;
constexpr int kBuiltInWidth = 84;

QLabel* cell(const QString& text, const char* role, int width) {
    QLabel* label = role_label(role, text);
    if (width > 0) label->setFixedWidth(width);
    return label;
}

/// A key may go on in the next line behind its points and underscores.
QString breakable(const std::string& key) {
    constexpr char16_t kZeroWidthSpace = 0x200B;
    QString text;
    for (const QChar letter : QString::fromStdString(key)) {
        text += letter;
        if (letter == u'.' || letter == u'_') text += QChar{kZeroWidthSpace};
    }
    return text;
}

/// "1000000" as it stands elsewhere in the window: "1 000 000".
QString with_thousands(const QString& text) {
    static const QRegularExpression kWhole{QStringLiteral("(?<![\\d.])\\d{4,}")};
    QString told;
    qsizetype done = 0;
    for (auto found = kWhole.globalMatch(text); found.hasNext();) {
        const auto number = found.next();
        told += text.mid(done, number.capturedStart() - done);
        told += QString::fromStdString(session::count_text(number.captured().toLongLong()));
        done = number.capturedEnd();
    }
    return told + text.mid(done);
}

/// "0.001 ... 10 000": what the words between say is clear from the column.
QString short_bounds(const ProfileKey& spec) {
    static const QRegularExpression kBytes{QStringLiteral("^(\\d+) to (\\d+) bytes$")};
    QString text = QString::fromStdString(spec.bounds);
    if (const auto bytes = kBytes.match(text); bytes.hasMatch())
        return ProfileRow::tr("%1 to %2 bytes").arg(bytes.captured(1), bytes.captured(2));
    text.replace(QStringLiteral(" or "), ProfileRow::tr(" or "));
    text = with_thousands(text);
    for (const char* between : {" <= value <= ", " <= first < second <= "}) text.replace(between, " ... ");
    return text;
}

}  // namespace

QWidget* ProfileRow::header() {
    auto* whole = new QWidget;
    auto* row = new QGridLayout{whole};
    row->setContentsMargins(kGap, 0, kGap, 0);
    row->setHorizontalSpacing(kGap);
    row->addWidget(cell({}, "label", kChangedWidth), 0, kChanged);
    QLabel* const key = cell(tr("Key"), "label", kProfileRowNameWidth);
    key->setObjectName("profile_header_key");
    row->addWidget(key, 0, kName);
    row->addWidget(cell(tr("Value"), "label", kValueWidth), 0, kValue);
    row->addWidget(cell(tr("Unit"), "label", kProfileRowUnitWidth), 0, kUnit);
    row->addWidget(cell(tr("Bounds"), "label", 0), 0, kBounds);
    row->addWidget(cell(tr("Default"), "label", kBuiltInWidth), 0, kBuiltIn);
    row->setColumnStretch(kBounds, 1);
    return whole;
}

ProfileRow::ProfileRow(std::size_t key, bool in_full, Events events, QWidget* parent)
    : QFrame(parent), key_(key), events_(std::move(events)), grid_(new QGridLayout{this}) {
    const ProfileKey& spec = profile_keys()[key];
    setObjectName("row_" + QString::fromStdString(spec.path));
    setToolTip(QCoreApplication::translate("profile", spec.explanation.c_str()));
    const std::string name = in_full ? spec.path : std::string(leaf_of_key(spec.path));
    changed_ = cell({}, "head", kChangedWidth);
    changed_->setObjectName("mark");
    built_in_ =
        cell(QString::fromStdString(profile::typed_from_toml(spec, spec.built_in)), "label", kBuiltInWidth);
    problem_ = role_label("problem");
    problem_->setWordWrap(true);
    problem_->hide();
    make_editor();
    QWidget* editor = line_ != nullptr ? static_cast<QWidget*>(line_) : words_;
    editor->setFixedWidth(kValueWidth);
    editor->setAccessibleName(QString::fromStdString(spec.path));
    editor->installEventFilter(this);
    grid_->setContentsMargins(kGap, 2, kGap, 2);
    grid_->setHorizontalSpacing(kGap);
    grid_->setVerticalSpacing(2);
    name_ = cell(breakable(name), "", 0);
    unit_ = cell(QString::fromStdString(spec.unit), "label", kProfileRowUnitWidth);
    bounds_ = cell(short_bounds(spec), "label", 0);
    for (QLabel* label : {name_, bounds_}) label->setWordWrap(true);
    grid_->addWidget(changed_, 0, kChanged);
    grid_->addWidget(problem_, 3, kName, 1, kBuiltIn - kName + 1);
    arrange(1);
}

void ProfileRow::arrange_header(QWidget& header, int lines) {
    header.setVisible(lines < 3);
    header.findChild<QLabel*>("profile_header_key")->setVisible(lines == 1);
}

void ProfileRow::arrange(int lines) {
    QWidget* const editor = line_ != nullptr ? static_cast<QWidget*>(line_) : words_;
    for (QWidget* part : {static_cast<QWidget*>(name_), editor, static_cast<QWidget*>(unit_),
                          static_cast<QWidget*>(bounds_), static_cast<QWidget*>(built_in_)})
        grid_->removeWidget(part);
    const bool has_own_line = lines > 1;
    name_->setMinimumWidth(has_own_line ? 0 : kProfileRowNameWidth);
    name_->setMaximumWidth(has_own_line ? QWIDGETSIZE_MAX : kProfileRowNameWidth);
    const int row = has_own_line ? 1 : 0;
    // What follows the name goes below it, and bounds and default below these.
    const int first = has_own_line ? kName : kValue;
    const int last = lines == 3 ? first : first + 2;
    grid_->addWidget(name_, 0, kName, 1, has_own_line ? kBounds - kName : 1);
    grid_->addWidget(editor, row, first);
    grid_->addWidget(unit_, row, first + 1);
    grid_->addWidget(bounds_, lines == 3 ? 2 : row, last);
    grid_->addWidget(built_in_, lines == 3 ? 2 : row, last + 1);
    for (int column = kName; column <= kBuiltIn; ++column)
        grid_->setColumnStretch(column, column == last + (lines == 3 ? 1 : 0) ? 1 : 0);
}

void ProfileRow::make_editor() {
    const ProfileKey& spec = profile_keys()[key_];
    if (spec.words.empty()) {
        line_ = new QLineEdit;
        connect(line_, &QLineEdit::textEdited, this, [this](const QString& text) { events_.typed(text); });
        return;
    }
    words_ = new ChoiceBox;
    for (const std::string& word : spec.words) words_->addItem(QString::fromStdString(word));
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

/// Not saved; saved, but the core that runs was started with another value.
void ProfileRow::show_marks(const profile::ProfileDraft& draft, const QString& in_core) {
    const bool is_changed = draft.is_changed(key_);
    QStringList hints;
    if (is_changed) hints += tr("In the file: %1").arg(QString::fromStdString(draft.saved(key_)));
    if (!in_core.isEmpty())
        hints += tr("Needs restart: the core has %1 until it is started anew").arg(in_core);
    changed_->setText(is_changed           ? QStringLiteral("\u25CF")
                      : !in_core.isEmpty() ? QStringLiteral("↻")
                                           : QString{});
    changed_->setToolTip(hints.join('\n'));
    changed_->setAccessibleName(changed_->toolTip());
}

void ProfileRow::show_state(const profile::ProfileDraft& draft, const QString& in_core) {
    const QString typed = QString::fromStdString(draft.typed(key_));
    if (line_ != nullptr && line_->text() != typed) line_->setText(typed);
    if (words_ != nullptr && words_->currentText() != typed) {
        const QSignalBlocker still(words_);
        // An unknown word stands in the file: it is shown until a known one is chosen.
        if (words_->findText(typed) < 0) words_->addItem(typed);
        words_->setCurrentText(typed);
    }
    show_marks(draft, in_core);
    QFont font = built_in_->font();
    font.setBold(draft.differs_from_built_in(key_));
    built_in_->setFont(font);
    const std::string& problem = draft.problem(key_);
    const QString told = problem.empty() ? QString{} : words(session::profile_problem_phrase(problem));
    problem_->setText(told);
    problem_->setVisible(!problem.empty());
    set_styled(this, "invalid", !problem.empty());
    QWidget* editor = line_ != nullptr ? static_cast<QWidget*>(line_) : words_;
    set_styled(editor, "invalid", !problem.empty());
    editor->setAccessibleDescription(told);
}

}  // namespace psicarve::ui
