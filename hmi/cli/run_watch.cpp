// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_watch.hpp"

#include <optional>
#include <string>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {

void RunWatch::tell_remark() {
    const std::string remark =
        std::exchange(has_told_, true) ? std::string{} : in_words(link_->job_remarks());
    if (remark.empty()) return;
    clear_progress_line();
    print_warning(remark);
}

Result<void> RunWatch::look(const CoreStatus& status) {
    tell_remark();
    const std::string state{name_of(status.state)};
    bar_.relabel(state);
    if (status.points_total > 0) {
        const double done_ratio =
            static_cast<double>(status.points_done) / static_cast<double>(status.points_total);
        // On the virtual clock machine time does not predict our waiting.
        const bool is_told = status.is_virtual_clock == 0 && status.seconds_left >= 0.0;
        const bool has_passes = job_->passes().size() > 1 && status.layer < job_->layer_count();
        const std::string pass =
            has_passes ? pass_name(job_->passes()[job_->pass_of(status.layer)]) + ", " : std::string{};
        bar_.update(
            done_ratio,
            pass + "layer " + std::to_string(status.layer) + ", point " + std::to_string(status.point),
            is_told ? std::optional{TimeToGo{status.seconds_left, status.is_left_forecast != 0}}
                    : std::nullopt);
    } else {
        bar_.update(0.0);
    }
    return operator_break_.pass_on(*link_);
}

}  // namespace psicarve::cli
