// SPDX-License-Identifier: GPL-3.0-or-later
// What of the profile the core that runs does not have yet: it takes one when it starts.
#include "hmi/profile/typed_value.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/profile_row.hpp"

namespace psicarve::ui {

void ProfilePage::look_at_core() {
    const session::MachineView& view = context_.machine.view();
    // A job's profile has the machine's motion, not all of its keys.
    const bool is_known = view.is_heard() && view.profile && !view.is_profile_of_job;
    if (!is_known && core_values_.empty()) return;
    if (is_known && !core_values_.empty() && core_hash_ == view.core_profile_hash) return;
    core_values_ = is_known ? profile_values(*view.profile) : std::vector<std::string>{};
    core_hash_ = view.core_profile_hash;
    show_state();
}

/// Its value as it would be typed, where it is another one.
QString ProfilePage::in_core(std::size_t key) const {
    if (core_values_.empty() || draft().path().empty() || !draft().differs_from(key, core_values_[key]))
        return {};
    return QString::fromStdString(profile::typed_from_toml(profile_keys()[key], core_values_[key]));
}

QString ProfilePage::restart_text() const {
    int count = 0;
    for (std::size_t key = 0; key < core_values_.size(); ++key) {
        // Of what is not saved a restart would not know.
        if (!draft().is_changed(key) && !in_core(key).isEmpty()) ++count;
    }
    const QString backup = tr("The old file is kept as a backup. A core takes a profile when it starts.");
    if (count == 0) return backup;
    return backup + " " + tr("Values that need a restart (↻): %1.").arg(count);
}

}  // namespace psicarve::ui
