// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/core_profile_bar.hpp"

#include <QLabel>
#include <QPushButton>

#include "hmi/session/profile_differences.hpp"
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

CoreProfileBar::CoreProfileBar(WindowContext& context, QWidget* parent)
    : NoticeBar("core_profile", Glyph::info, parent),
      context_(context),
      details_(add_text("details")),
      take_(new QPushButton{tr("Use the core's profile")}) {
    take_->setObjectName("core_profile_take");
    take_->setFocusPolicy(Qt::TabFocus);
    take_->setToolTip(tr("This window goes by it from now on, also without a core; no file is changed"));
    connect(take_, &QPushButton::clicked, this, [this] {
        if (!is_there() || !context_.knows_core_profile()) return;
        context_.take_core_profile();
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
    const session::MachineView& view = context_.machine.view();
    return view.is_heard() && !view.unused_profile.empty() &&
           context_.machine.options().profile.has_value() && !context_.replay.is_open();
}

void CoreProfileBar::refresh() {
    const bool is_shown = is_there();
    set_shown(is_shown);
    const session::MachineView& view = context_.machine.view();
    const bool is_known = context_.knows_core_profile();
    if (!is_shown || (shown_hash_ == view.core_profile_hash && shown_known_ == is_known)) return;
    shown_hash_ = view.core_profile_hash;
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
    const session::MachineView& view = context_.machine.view();
    const Profile& given = *context_.machine.options().profile;
    const QString of_core = short_file_name(view.profile->name);
    const QString of_window = short_file_name(view.unused_profile);
    title().setText(breakable(
        is_small_ ? tr("Core: profile %1, not %2").arg(of_core, of_window)
                  : tr("The core runs with profile %1, not with %2 of --profile").arg(of_core, of_window)));
    const auto told = [&](std::size_t most, const QString& between) {
        return told_with(session::profile_differences(*view.profile, given, most), between);
    };
    details_->setText(breakable(tr("Motion and slicing go by the core's. %1").arg(told(kShownKeys, "; "))));
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, told(kAllKeys, "\n"));
}

/// What the core's is like is not known.
void CoreProfileBar::show_given() {
    const QString of_window = short_file_name(context_.machine.view().unused_profile);
    title().setText(
        breakable(tr("The core runs with another profile than %1; its file was not found.").arg(of_window)));
    details_->clear();
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, {});
}

}  // namespace psicarve::ui
