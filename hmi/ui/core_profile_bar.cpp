// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/core_profile_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/session/core_profile.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kProfileIconSide = 24;
constexpr int kProfileIconWidth = 40;
constexpr std::size_t kShownKeys = 3;
constexpr std::size_t kAllKeys = 1000;

QString told_with(const std::vector<session::Phrase>& differences, const QString& between) {
    QStringList said;
    for (const session::Phrase& each : differences) said << words(each);
    return said.join(between);
}

}  // namespace

CoreProfileBar::CoreProfileBar(Bench& bench, QWidget* parent)
    : QFrame(parent),
      bench_(bench),
      icon_(new QLabel),
      title_(role_label("title")),
      details_(new QLabel),
      take_(new QPushButton{tr("Use the core's profile")}) {
    setObjectName("core_profile");
    title_->setObjectName("core_profile_title");
    details_->setObjectName("core_profile_details");
    icon_->setFixedWidth(kProfileIconWidth);
    icon_->setAlignment(Qt::AlignCenter);
    auto* text = new QVBoxLayout;
    text->setContentsMargins(0, kGap, kGap, kGap);
    text->setSpacing(3);
    for (QLabel* label : {title_, details_}) {
        label->setWordWrap(true);
        text->addWidget(label);
    }
    take_->setObjectName("core_profile_take");
    take_->setFocusPolicy(Qt::TabFocus);
    take_->setToolTip(tr("This window goes by it from now on, also without a core; no file is changed"));
    connect(take_, &QPushButton::clicked, this, [this] {
        if (!is_there() || !bench_.knows_core_profile()) return;
        bench_.take_core_profile();
        refresh();
    });
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(0, 0, kGap, 0);
    all->setSpacing(0);
    all->addWidget(icon_);
    all->addLayout(text, 1);
    all->addWidget(take_, 0, Qt::AlignVCenter);
    setVisible(false);
}

void CoreProfileBar::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(Glyph::info, kProfileIconSide, tokens.warn));
    refresh();
}

void CoreProfileBar::set_room(Room room) {
    is_small_ = room == Room::small;
    shown_hash_ = 0;
    refresh();
}

bool CoreProfileBar::is_there() const {
    const session::MachineSight& sight = bench_.machine.sight();
    return sight.is_heard() && !sight.unused_profile.empty() &&
           bench_.machine.options().profile.has_value() && !bench_.replay.is_open();
}

void CoreProfileBar::refresh() {
    const bool is_shown = is_there();
    if (isHidden() == is_shown) setVisible(is_shown);
    const session::MachineSight& sight = bench_.machine.sight();
    const bool is_known = bench_.knows_core_profile();
    if (!is_shown || (shown_hash_ == sight.core_profile_hash && shown_known_ == is_known)) return;
    shown_hash_ = sight.core_profile_hash;
    shown_known_ = is_known;
    if (is_known)
        show_both();
    else
        show_given();
    take_->setVisible(is_known);
    details_->setHidden(is_small_ || !is_known);
    setAccessibleName(title_->text());
    setAccessibleDescription(details_->text());
}

void CoreProfileBar::show_both() {
    const session::MachineSight& sight = bench_.machine.sight();
    const Profile& given = *bench_.machine.options().profile;
    const QString of_core = short_file_name(sight.profile->name);
    const QString of_window = short_file_name(sight.unused_profile);
    title_->setText(breakable(
        is_small_ ? tr("Core: profile %1, not %2").arg(of_core, of_window)
                  : tr("The core runs with profile %1, not with %2 of --profile").arg(of_core, of_window)));
    const auto told = [&](std::size_t most, const QString& between) {
        return told_with(session::profile_differences(*sight.profile, given, most), between);
    };
    details_->setText(breakable(tr("Motion and slicing go by the core's. %1").arg(told(kShownKeys, "; "))));
    for (QLabel* label : {title_, details_}) label->setToolTip(told(kAllKeys, "\n"));
}

/// Nobody knows what the core's is like.
void CoreProfileBar::show_given() {
    const QString of_window = short_file_name(bench_.machine.sight().unused_profile);
    title_->setText(
        breakable(tr("The core runs with another profile than %1; its file was not found.").arg(of_window)));
    details_->clear();
    for (QLabel* label : {title_, details_}) label->setToolTip({});
}

}  // namespace psicarve::ui
