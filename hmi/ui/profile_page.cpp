// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/profile_page.hpp"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "hmi/ui/calibration_dialog.hpp"
#include "hmi/ui/checked_width.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/profile_row.hpp"
#include "hmi/ui/words.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::ui {
namespace {

constexpr int kFindWidth = 150;

QPushButton* push_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

ProfilePage::ProfilePage(WindowContext& context, QWidget* parent)
    : QWidget(parent), context_(context), list_(new QListWidget), area_(new QScrollArea) {
    setObjectName("profile_page");
    list_->setObjectName("profile_groups");
    list_->setAccessibleName(tr("Parts of the profile"));
    area_->setWidgetResizable(true);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area_->setObjectName("profile_rows");
    explanation_ = role_label("label");
    explanation_->setTextFormat(Qt::RichText);
    explanation_->setWordWrap(true);
    middle_ = new QBoxLayout{QBoxLayout::LeftToRight};
    middle_->setSpacing(kGap);
    middle_->addWidget(list_);
    auto* keys = new QVBoxLayout;
    keys->setSpacing(kSmallGap);
    header_ = ProfileRow::header();
    keys->addWidget(header_);
    keys->addWidget(area_, 1);
    middle_->addLayout(keys, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addWidget(make_head());
    all->addLayout(middle_, 1);
    all->addWidget(explanation_);
    all->addWidget(make_foot());
    make_groups();
    connect(list_, &QListWidget::currentRowChanged, this, [this] { show_rows(); });
    connect(find_, &QLineEdit::textChanged, this, [this] { show_rows(); });
    for (QPushButton* filter : {only_changed_, compare_})
        connect(filter, &QPushButton::toggled, this, [this] { show_rows(); });
    list_->setCurrentRow(0);
}

ProfilePage::~ProfilePage() = default;

QWidget* ProfilePage::make_head() {
    file_ = role_label("title");
    changes_ = role_label("label");
    find_ = new QLineEdit;
    find_->setObjectName("profile_find");
    find_->setPlaceholderText(tr("Find a key"));
    find_->setClearButtonEnabled(true);
    find_->setFixedWidth(kFindWidth);
    only_changed_ = push_button("profile_only_changed", tr("Changed"));
    only_changed_->setToolTip(tr("Shows only what differs from the file, and would be saved"));
    compare_ = push_button("profile_compare", tr("Compare with defaults"));
    compare_->setToolTip(tr("Shows only what differs from the built-in profile"));
    for (QPushButton* filter : {only_changed_, compare_}) {
        filter->setCheckable(true);
        leave_room_for_bold(*filter);
    }
    calibrate_ = new ActionButton{
        [this](const WindowContext&) -> std::optional<session::Phrase> {
            if (const auto busy = busy_lock()) return busy;
            if (draft().path().empty())
                return session::phrase(
                    "Calibrate: open the machine's profile first, or save this one as a file");
            if (draft().changed_count() > 0)
                return session::phrase("Calibrate: save the profile first, or undo what was changed");
            if (draft().problem_count() > 0)
                return session::phrase("Calibrate: a value of the profile is wrong");
            return std::nullopt;
        },
        tr("Calibrate…"), [this] { calibrate(); }};
    calibrate_->setObjectName("profile_calibrate");
    calibrate_->set_hint(tr("Touch-off, two marks and tool wear become values of the profile, step by step"));
    auto* head = new QWidget;
    auto* row = new FlowLayout{head};
    row->addWidget(file_);
    row->addWidget(changes_);
    row->add_end();
    row->addWidget(find_);
    row->addWidget(only_changed_);
    row->addWidget(compare_);
    row->addWidget(calibrate_);
    return head;
}

QWidget* ProfilePage::make_foot() {
    reason_ = role_label("label");
    reason_->setObjectName("profile_reason");
    reason_->setWordWrap(true);
    open_ = push_button("profile_open", tr("Open..."));
    undo_ = push_button("profile_undo", tr("Undo all"));
    restore_ = push_button("profile_restore", tr("Restore backup"));
    save_as_ = push_button("profile_save_as", tr("Save as..."));
    save_ = push_button("profile_save", tr("Save"));
    make_menus();
    connect(undo_, &QPushButton::clicked, this, [this] {
        context_.profile_desk.undo_all();
        show_changed();
    });
    connect(save_as_, &QPushButton::clicked, this, [this] { ask_save_as(); });
    connect(save_, &QPushButton::clicked, this, [this] { ask_save(); });
    auto* foot = new QWidget;
    auto* rows = new QVBoxLayout{foot};
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kSmallGap);
    rows->addWidget(reason_);
    auto* row = new FlowLayout;
    rows->addLayout(row);
    row->add_end();
    for (QPushButton* button : {open_, undo_, restore_, save_as_, save_}) row->addWidget(button);
    return foot;
}

// In the order of the keys; tables of the port apart.
void ProfilePage::make_groups() {
    const std::pair<const char*, QString> titles[] = {{"", tr("General")},
                                                      {"tick", tr("Tick")},
                                                      {"axis.r1", tr("Axis R1")},
                                                      {"axis.r2", tr("Axis R2")},
                                                      {"axis.psi", tr("Axis \u03A8")},
                                                      {"axis.y", tr("Axis Y")},
                                                      {"head.r2", tr("Head R2")},
                                                      {"tool", tr("Tool")},
                                                      {"blank", tr("Blank")},
                                                      {"roughing", tr("Roughing")},
                                                      {"gcode", tr("G-code")},
                                                      {"job", tr("Job")},
                                                      {"port", tr("Port timing")},
                                                      {"port.pins", tr("Port pins")}};
    for (const ProfileKey& key : profile_keys()) {
        const std::string table{table_of_key(key.path)};
        if (!groups_.empty() && groups_.back().table == table) continue;
        QString title = QString::fromStdString(table);
        for (const auto& [name, words] : titles) {
            if (table == name) title = words;
        }
        groups_.push_back({table, title});
        list_->addItem(title);
    }
}

void ProfilePage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    show_state();
}

bool ProfilePage::is_filtered() const {
    return only_changed_->isChecked() || compare_->isChecked();
}

bool ProfilePage::belongs(std::size_t key) const {
    const std::string& path = profile_keys()[key].path;
    const QString wanted = find_->text().trimmed();
    const bool searches = !wanted.isEmpty();
    if (searches && !QString::fromStdString(path).contains(wanted, Qt::CaseInsensitive)) return false;
    if (only_changed_->isChecked() && !draft().is_changed(key)) return false;
    if (compare_->isChecked() && !draft().differs_from_built_in(key)) return false;
    if (searches || is_filtered()) return true;
    const int row = list_->currentRow();
    return row >= 0 && groups_[static_cast<std::size_t>(row)].table == table_of_key(path);
}

QString ProfilePage::why_no_rows() const {
    if (only_changed_->isChecked() && draft().changed_count() == 0) return tr("Nothing was changed");
    if (compare_->isChecked() && find_->text().trimmed().isEmpty())
        return tr("Nothing differs from the built-in profile");
    return tr("No key has these letters");
}

/// Other values than those that were typed into these rows.
void ProfilePage::show_changed() {
    if (only_changed_->isChecked()) return show_rows();
    show_state();
}

void ProfilePage::show_rows() {
    const bool in_full = is_filtered() || !find_->text().trimmed().isEmpty();
    list_->setEnabled(!in_full);
    auto* sheet = new QWidget;
    sheet->setObjectName("profile_sheet");
    auto* column = new QVBoxLayout{sheet};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    rows_.clear();
    for (std::size_t key = 0; key < profile_keys().size(); ++key) {
        if (!belongs(key)) continue;
        rows_.push_back(new ProfileRow{
            key,
            in_full,
            {[this, key](const QString& text) { type(key, text); }, [this, key] { explain(key); }}});
        rows_.back()->arrange(std::max(1, row_lines_));
        column->addWidget(rows_.back());
        column->addWidget(rule());
    }
    if (rows_.empty()) {
        auto* const why = role_label("label", why_no_rows());
        why->setObjectName("profile_no_rows");
        column->addWidget(why);
    }
    column->addStretch();
    area_->setWidget(sheet);
    explanation_->clear();
    show_state();
}

void ProfilePage::type(std::size_t key, const QString& text) {
    context_.profile_desk.type(key, text.toStdString());
    show_state();
}

void ProfilePage::explain(std::size_t key) {
    const ProfileKey& spec = profile_keys()[key];
    explanation_->setText("<b>" + QString::fromStdString(spec.path).toHtmlEscaped() + "</b> \u2014 " +
                          QCoreApplication::translate("profile", spec.explanation.c_str()).toHtmlEscaped());
}

// What may be saved while the machine moves would not be what it moves by.
QString ProfilePage::lock() const {
    if (const auto busy = busy_lock()) return words(*busy);
    const auto& view = context_.machine.view();
    if (view.is_heard() && !is_at_rest(view.state())) return tr("Save: the machine moves");
    const std::size_t problems = draft().problem_count();
    if (problems == 1) return tr("Save: one value is wrong");
    if (problems > 1) return tr("Save: %1 values are wrong").arg(problems);
    return {};
}

void ProfilePage::refresh() {
    context_.profile_desk.poll();
    look_at_core();
    if (calibration_ != nullptr) calibration_->poll();
    if (calibration_ != nullptr && calibration_->isVisible()) calibration_->refresh();
    show_locks();
}

void ProfilePage::show_locks() {
    const QString reason = lock();
    const auto under_way = busy_lock();
    const QString busy = under_way ? words(*under_way) : QString{};
    const bool has_file = !draft().path().empty();
    const bool is_changed = draft().changed_count() > 0;
    if (area_->isEnabled() == context_.profile_desk.takes_values())
        area_->setEnabled(!context_.profile_desk.takes_values());
    lock_with(*open_, busy);
    lock_with(*save_as_, reason);
    lock_with(*save_, !reason.isEmpty() ? reason
                      : !has_file       ? tr("Save: the built-in profile has no file; save it as one")
                      : !is_changed     ? tr("Save: nothing was changed")
                                        : QString{});
    lock_with(*undo_, !busy.isEmpty() ? busy : !is_changed ? tr("Undo all: nothing was changed") : QString{});
    lock_with(*restore_, !busy.isEmpty() ? busy
                         : !has_file     ? tr("Restore backup: the built-in profile has no file")
                         : !has_backup() ? tr("Restore backup: this file has none yet")
                                         : QString{});
    calibrate_->refresh(context_);
    const QString text = !reason.isEmpty() ? reason
                         : !has_file       ? tr("The built-in profile has no file: save it as one.")
                                           : restart_text();
    if (reason_->text() != text) reason_->setText(text);
}

QString ProfilePage::unsaved_text() const {
    const std::size_t count = draft().changed_count();
    if (count == 0) return {};
    return count == 1 ? tr("1 change not saved") : tr("%1 changes not saved").arg(count);
}

void ProfilePage::show_state() {
    for (ProfileRow* row : rows_) row->show_state(draft(), in_core(row->key()));
    const QString path = QString::fromStdString(draft().path());
    file_->setText(path.isEmpty() ? tr("built-in profile") : QFileInfo{path}.fileName());
    file_->setToolTip(path);
    changes_->setText(unsaved_text());
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        int problems = 0;
        for (std::size_t key = 0; key < profile_keys().size(); ++key) {
            if (table_of_key(profile_keys()[key].path) == groups_[i].table && !draft().problem(key).empty())
                ++problems;
        }
        QListWidgetItem* item = list_->item(static_cast<int>(i));
        item->setText(problems > 0 ? tr("%1 (%2)").arg(groups_[i].title).arg(problems) : groups_[i].title);
        if (tokens_ != nullptr) item->setForeground(problems > 0 ? tokens_->alarm : tokens_->text);
    }
    show_locks();
}

}  // namespace psicarve::ui
