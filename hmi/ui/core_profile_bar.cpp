// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/core_profile_bar.hpp"

#include <QLabel>
#include <QPushButton>

#include "hmi/session/core_profile.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr std::size_t kShownKeys = 3;
constexpr std::size_t kAllKeys = 1000;

QString told_with(const std::vector<session::Phrase>& differences, const QString& between) {
    QStringList said;
    for (const session::Phrase& each : differences) said << words(each);
    return said.join(between);
}

}  // namespace

CoreProfileBar::CoreProfileBar(Bench& bench, QWidget* parent)
    : NoticeBar("core_profile", Glyph::info, parent),
      bench_(bench),
      details_(add_text("details")),
      take_(new QPushButton{tr("Use the core's profile")}) {
    take_->setObjectName("core_profile_take");
    take_->setFocusPolicy(Qt::TabFocus);
    take_->setToolTip(tr("This window goes by it from now on, also without a core; no file is changed"));
    connect(take_, &QPushButton::clicked, this, [this] {
        if (!is_there() || !bench_.knows_core_profile()) return;
        bench_.take_core_profile();
        refresh();
    });
    add_button(take_);
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
    set_shown(is_shown);
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
    setAccessibleName(title().text());
    setAccessibleDescription(details_->text());
}

void CoreProfileBar::show_both() {
    const session::MachineSight& sight = bench_.machine.sight();
    const Profile& given = *bench_.machine.options().profile;
    const QString of_core = short_file_name(sight.profile->name);
    const QString of_window = short_file_name(sight.unused_profile);
    title().setText(breakable(
        is_small_ ? tr("Core: profile %1, not %2").arg(of_core, of_window)
                  : tr("The core runs with profile %1, not with %2 of --profile").arg(of_core, of_window)));
    const auto told = [&](std::size_t most, const QString& between) {
        return told_with(session::profile_differences(*sight.profile, given, most), between);
    };
    details_->setText(breakable(tr("Motion and slicing go by the core's. %1").arg(told(kShownKeys, "; "))));
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, told(kAllKeys, "\n"));
}

/// Nobody knows what the core's is like.
void CoreProfileBar::show_given() {
    const QString of_window = short_file_name(bench_.machine.sight().unused_profile);
    title().setText(
        breakable(tr("The core runs with another profile than %1; its file was not found.").arg(of_window)));
    details_->clear();
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, {});
}

}  // namespace psicarve::ui
