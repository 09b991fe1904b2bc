// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/calibration_dialog.hpp"

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/words.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::ui {
namespace {

using profile::CalibrationStep;
using session::Severity;

constexpr int kFieldWidth = 110;
constexpr int kTextWidth = 460;
constexpr int kTableHeight = 150;
constexpr int kCalibrationDialogButtonWidth = 88;
constexpr int kDigits = 5;

QString head_name(Axis head) {
    return QString::fromUtf8(session::axis_letter(head));
}

std::string text_in(const QLineEdit* field) {
    return field != nullptr ? field->text().toStdString() : std::string{};
}

QPushButton* plain_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setAutoDefault(false);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

CalibrationDialog::CalibrationDialog(WindowContext& context, Page page, QWidget* parent)
    : QDialog(parent),
      context_(context),
      page_(std::move(page)),
      desk_(context.saves),
      title_(role_label("title")),
      file_(role_label("label")),
      pages_(new QStackedWidget),
      changes_(new QTableWidget),
      reason_(role_label("label")) {
    setObjectName("calibration_dialog");
    setWindowTitle(tr("Calibrate the heads"));
    title_->setObjectName("calibration_title");
    reason_->setObjectName("calibration_reason");
    reason_->setWordWrap(true);
    for (std::size_t i = 0; i < kSteps; ++i) pages_->addWidget(make_step(i));
    pages_->addWidget(make_overview());
    auto* all = new QVBoxLayout{this};
    all->addWidget(title_);
    all->addWidget(file_);
    all->addWidget(rule());
    all->addWidget(pages_, 1);
    all->addWidget(reason_);
    all->addLayout(make_buttons());
    reckon();
    show_step(0);
}

QLineEdit* CalibrationDialog::add_field(QGridLayout& grid, const QString& name, const QString& id) {
    const int line = grid.rowCount();
    auto* field = new QLineEdit;
    field->setObjectName(id);
    field->setAccessibleName(name);
    field->setPlaceholderText(tr("as it is"));
    field->setFixedWidth(kFieldWidth);
    field->setAlignment(Qt::AlignRight);
    grid.addWidget(role_label("label", name), line, 0);
    grid.addWidget(field, line, 1);
    grid.addWidget(role_label("label", "mm"), line, 2);
    connect(field, &QLineEdit::textChanged, this, [this] { reckon(); });
    return field;
}

QWidget* CalibrationDialog::make_step(std::size_t index) {
    const CalibrationStep which = profile::kCalibrationSteps[index];
    const Axis axis = head_of(which);
    const QString head = head_name(axis);
    const QString id = "calibrate_" + QString::number(index) + "_";
    Step& step = steps_[index];
    auto* page = new QWidget;
    auto* column = new QVBoxLayout{page};
    column->setContentsMargins(0, kGap, 0, 0);
    auto* grid = new QGridLayout;
    grid->setColumnStretch(4, 1);
    QString text;
    if (which == CalibrationStep::two_marks) {
        text =
            tr("On a round blank let R1 make a mark: a touch of its tip. Take it out, turn \u03A8 by exactly "
               "180°, leave Y alone, and let R2 make its own. On a machine without error it falls on R1's.");
        step.diameter = add_field(*grid, tr("Diameter of the blank"), id + "diameter");
        step.around =
            add_field(*grid, tr("From R1's mark to R2's, counter-clockwise from above is +"), id + "around");
        step.up = add_field(*grid, tr("How much higher R2's mark is, lower is \u2212"), id + "up");
    } else if (which == CalibrationStep::wear_r1 || which == CalibrationStep::wear_r2) {
        text =
            tr("A tool becomes shorter as it wears: a piece that comes out thicker on the half of %1 by so "
               "much in radius. It is counted from the head's touch-off.")
                .arg(head);
        step.wear = add_field(*grid, tr("Wear of the tool of %1").arg(head), id + "wear");
    } else {
        text =
            tr("Spindle off. Put a pin of known diameter on the axis, home, and bring %1 to it with the Jog "
               "panel, the last steps by hundredths, until the tip just touches: a slip of paper is held.")
                .arg(head);
        step.diameter = add_field(*grid, tr("Diameter of the pin"), id + "diameter");
        step.counted = add_field(*grid, tr("Where %1 is shown to stand").arg(head), id + "counted");
        const auto lock = [this, axis](const WindowContext& now) -> std::optional<session::Phrase> {
            if (const auto busy = desk_.lock()) return busy;
            if (!on_file_) return session::phrase("Here: no profile is open");
            return session::place_lock(now.machine.view(), opened_.path(), *on_file_, axis);
        };
        auto* here = new ActionButton{lock, tr("Here"),
                                      [this, axis, field = step.counted] { take_place(axis, *field); }};
        here->setObjectName(id + "here");
        here->set_hint(tr("Takes the position that the core counts now"));
        grid->addWidget(here, grid->rowCount() - 1, 3);
        here_.push_back(here);
    }
    auto* words_of_it = new QLabel{text};
    words_of_it->setWordWrap(true);
    words_of_it->setMinimumWidth(kTextWidth);
    step.outcome = role_label("label");
    step.outcome->setWordWrap(true);
    step.outcome->setObjectName(id + "outcome");
    column->addWidget(words_of_it);
    column->addLayout(grid);
    column->addWidget(step.outcome);
    column->addStretch();
    return page;
}

QWidget* CalibrationDialog::make_overview() {
    changes_->setObjectName("calibration_changes");
    changes_->setColumnCount(3);
    changes_->setHorizontalHeaderLabels({tr("Key"), tr("Before"), tr("From now on")});
    changes_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    changes_->verticalHeader()->hide();
    changes_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    changes_->setSelectionMode(QAbstractItemView::NoSelection);
    changes_->setFocusPolicy(Qt::NoFocus);
    changes_->setShowGrid(false);
    changes_->setMinimumHeight(kTableHeight);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout{page};
    column->setContentsMargins(0, kGap, 0, 0);
    column->addWidget(changes_, 1);
    auto* after = role_label("label", tr("The old file is kept as a backup. Then start the core with the new "
                                         "one, and slice models anew: a job is made for one calibration."));
    after->setWordWrap(true);
    column->addWidget(after);
    return page;
}

QLayout* CalibrationDialog::make_buttons() {
    back_ = plain_button("calibrate_back", tr("Back"));
    next_ = plain_button("calibrate_next", tr("Next"));
    const auto lock = [this](const WindowContext& now) {
        const auto reason = busy();
        return reason ? reason : session::write_lock(outcome_, now.machine.view());
    };
    write_ = new ActionButton{lock, tr("Write"), [this] { write(); }};
    write_->setObjectName("calibrate_write");
    shut_ = plain_button("calibrate_close", tr("Close"));
    connect(back_, &QPushButton::clicked, this, [this] { show_step(pages_->currentIndex() - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { show_step(pages_->currentIndex() + 1); });
    connect(shut_, &QPushButton::clicked, this, [this] { close(); });
    auto* row = new QHBoxLayout;
    row->addWidget(shut_);
    row->addStretch();
    for (QPushButton* button : {back_, next_, static_cast<QPushButton*>(write_)}) row->addWidget(button);
    for (QPushButton* button : {shut_, back_, next_, static_cast<QPushButton*>(write_)})
        button->setMinimumWidth(kCalibrationDialogButtonWidth);
    return row;
}

/// Two who write one file would each lose what the other has written.
std::optional<session::Phrase> CalibrationDialog::busy() const {
    const auto own = desk_.lock();
    return own ? own : page_.lock();
}

void CalibrationDialog::open_for(const std::string& path) {
    if (desk_.is_busy()) return;
    if (isVisible()) return come_to_front();
    desk_.open(path, [this](const Result<void>& opened) {
        const auto on_file = opened ? desk_.draft().profile() : Result<Profile>{opened.error()};
        if (!on_file) {
            return context_.log.add(
                Severity::warning,
                session::joined(session::phrase("Calibrate"), session::error_phrase(on_file.error())));
        }
        on_file_ = *on_file;
        begin_with_what_was_read();
    });
}

void CalibrationDialog::begin_with_what_was_read() {
    opened_ = desk_.draft();
    context_.machine.offer_profile(*on_file_);
    for (Step& step : steps_) {
        for (QLineEdit* field : {step.diameter, step.counted, step.around, step.up, step.wear}) {
            if (field != nullptr) field->clear();
        }
    }
    const QString path = QString::fromStdString(opened_.path());
    file_->setText(QFileInfo{path}.fileName());
    file_->setToolTip(path);
    reckon();
    show_step(0);
    come_to_front();
}

void CalibrationDialog::come_to_front() {
    show();
    raise();
    activateWindow();
}

void CalibrationDialog::take_place(Axis head, QLineEdit& field) {
    const session::MachineView& view = context_.machine.view();
    const auto place =
        profile::counted_place_mm(opened_.path(), *on_file_, view.core_profile_hash, *view.status, head);
    if (place) field.setText(QString::number(*place, 'f', kDigits));
}

void CalibrationDialog::reckon() {
    session::CalibrationForm form;
    for (std::size_t i = 0; i < kSteps; ++i) {
        const Step& step = steps_[i];
        form[i] = {text_in(step.diameter), text_in(step.counted), text_in(step.around), text_in(step.up),
                   text_in(step.wear)};
    }
    outcome_ = session::reckon(opened_, form);
    for (std::size_t i = 0; i < kSteps; ++i) {
        const session::StepOutcome& outcome = outcome_.steps[i];
        QStringList lines;
        if (outcome.problem) lines += words(*outcome.problem);
        for (const profile::KeyChange& change : outcome.changes)
            lines += QString::fromStdString(change.key + ": " + change.from + " → " + change.to);
        steps_[i].outcome->setText(lines.join('\n'));
    }
    show_changes();
}

void CalibrationDialog::show_changes() {
    const auto changes = profile::changes_of(outcome_.draft);
    changes_->setRowCount(static_cast<int>(changes.size()));
    for (int line = 0; line < changes_->rowCount(); ++line) {
        const profile::KeyChange& change = changes[static_cast<std::size_t>(line)];
        int column = 0;
        for (const std::string* text : {&change.key, &change.from, &change.to})
            changes_->setItem(line, column++, new QTableWidgetItem{QString::fromStdString(*text)});
    }
}

void CalibrationDialog::show_step(int index) {
    const QString names[] = {tr("Touch-off of %1").arg("R1"),
                             tr("Touch-off of %1").arg("R2"),
                             tr("Two marks"),
                             tr("Wear of the tool of %1").arg("R1"),
                             tr("Wear of the tool of %1").arg("R2"),
                             tr("What becomes of it")};
    pages_->setCurrentIndex(index);
    title_->setText(tr("%1 of %2: %3").arg(index + 1).arg(pages_->count()).arg(names[index]));
    refresh();
}

void CalibrationDialog::write() {
    if (busy()) return refresh();
    desk_.show(outcome_.draft);
    desk_.save([this](const Result<void>& saved) { tell_written(saved); });
    refresh();
}

void CalibrationDialog::tell_written(const Result<void>& saved) {
    if (!saved) {
        context_.log.add(Severity::warning, session::joined(session::phrase("Profile not saved"),
                                                            session::error_phrase(saved.error())));
        return come_to_front();  // what was measured is not lost with a dialog that was shut meanwhile
    }
    const std::string path = desk_.draft().path();
    context_.log.add(Severity::info, session::phrase("Calibration written: %1; the old profile is %2", path,
                                                     profile::ProfileDraft::backup_path(path)));
    close();
    page_.written();
}

void CalibrationDialog::refresh() {
    pages_->setEnabled(!desk_.is_busy());  // what is typed while it is written would be lost
    const int index = pages_->currentIndex();
    const bool is_last = index + 1 == pages_->count();
    const auto busy = desk_.lock();
    lock_with(*shut_, busy ? words(*busy) : QString{});
    lock_with(*back_, busy ? words(*busy) : index == 0 ? tr("Back: this is the first step") : QString{});
    next_->setVisible(!is_last);
    write_->setVisible(is_last);
    const QString locked = write_->refresh(context_);
    QString reason = is_last ? locked : QString{};
    for (ActionButton* here : here_) {
        const QString why = here->refresh(context_);
        if (here->isVisible() && reason.isEmpty()) reason = why;
    }
    if (reason_->text() != reason) reason_->setText(reason);
}

}  // namespace psicarve::ui
