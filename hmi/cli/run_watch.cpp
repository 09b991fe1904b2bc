// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_watch.hpp"

#include <optional>
#include <string>

namespace psicarve::cli {

Result<void> RunWatch::look(const CoreStatus& status) {
    const std::string state{name_of(status.state)};
    bar_.relabel(state);
    if (status.points_total > 0) {
        const double done_ratio =
            static_cast<double>(status.points_done) / static_cast<double>(status.points_total);
        // On the virtual clock machine time says nothing about how long we wait.
        const bool is_planned = status.is_virtual_clock == 0 && status.seconds_left >= 0.0;
        bar_.update(done_ratio,
                    "layer " + std::to_string(status.layer) + ", point " + std::to_string(status.point),
                    is_planned ? std::optional{status.seconds_left} : std::nullopt);
    } else {
        bar_.update(0.0);
    }
    return operator_break_.pass_on(*link_);
}

}  // namespace psicarve::cli
