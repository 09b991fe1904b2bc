// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/report/lost_steps.hpp"
#include "hmi/scene/carving_record.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// The layers of the piece on the table that can be wrong: those in which the table had lost steps, as the
/// alarms of its job say. They stay in doubt until each is carved again.
class LayersInDoubt {
public:
    /// Another piece.
    void forget();
    /// These layers, from first to before end, were carved once more since. Returns whether one of them was
    /// in doubt.
    bool carved_again(std::uint32_t first, std::uint32_t end);
    /// The alarms of the job since its start. Returns whether there are new ones among them.
    bool take(const CoreStatus& status);

    /// Apart from each other, and in order.
    std::span<const verify::LayerRange> layers() const noexcept { return layers_; }
    /// By how much the table stood off in the worst of these alarms [pulses], without a sign.
    std::uint64_t most_off_pulses() const noexcept { return layers_.empty() ? 0 : most_off_pulses_; }

private:
    void add(const report::LostSteps::Layers& layers);

    std::vector<verify::LayerRange> layers_;
    std::uint64_t most_off_pulses_ = 0;
    std::uint64_t taken_ = 0;  ///< of the status' alarms
};

/// "Layers 4 to 7 can be wrong (≤ 1.178 mm)"; layers counted from 1. Empty: none is in doubt. `table`: of the
/// job's profile.
Phrase doubt_text(const LayersInDoubt& doubt, const report::TableSize& table);

}  // namespace psicarve::session
