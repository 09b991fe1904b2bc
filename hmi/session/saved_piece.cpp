// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/saved_piece.hpp"

#include <cstdint>
#include <string>
#include <utility>

#include "hmi/report/utc_text.hpp"

namespace psicarve::session {
namespace {

Phrase origin(const SavedCheckpoint& saved) {
    const std::string since = report::utc_text(saved.written_s);
    if (saved.tool.empty()) return phrase("Since %1.", since);
    return phrase("Since %1, tool %2.", since, saved.tool);
}

Phrase what_to_do(const FoundCheckpoint& found) {
    const Checkpoint& checkpoint = found.saved.checkpoint;
    const bool goes_on = checkpoint.next_layer != 0;
    const std::string layer =
        std::to_string((goes_on ? checkpoint.next_layer : checkpoint.earlier_layer) + 1);
    if (found.job_path.empty()) {
        return phrase(
            "No copy of its job is there: open that very job, publish it, Home all, then go on from layer "
            "%1.",
            layer);
    }
    return phrase("Open its job, publish it, Home all, then go on from layer %1.", layer);
}

}  // namespace

bool may_be_saved(const MachineSight& machine) noexcept {
    return !machine.is_heard() || !machine.status || machine.status->job_generation == 0;
}

Phrase saved_title(const SavedCheckpoint& saved) {
    const std::string count = std::to_string(saved.checkpoint.layer_count);
    if (saved.checkpoint.next_layer == 0)
        return phrase("Begun anew: none of %1 layers of %2 is finished", count, saved.source_name);
    return phrase("Unfinished: %1 of %2 layers of %3 are carved", std::to_string(saved.checkpoint.next_layer),
                  count, saved.source_name);
}

std::vector<Phrase> saved_details(const FoundCheckpoint& found, const MachineSight& machine) {
    std::vector<Phrase> details{origin(found.saved)};
    for (Phrase& need : saved_needs(found, machine)) details.push_back(std::move(need));
    return details;
}

std::vector<Phrase> saved_needs(const FoundCheckpoint& found, const MachineSight& machine) {
    std::vector<Phrase> needs;
    if (!machine.is_heard()) needs.push_back(phrase("First start psicarve-rtcore."));
    needs.push_back(what_to_do(found));
    const std::uint32_t earlier = found.saved.checkpoint.earlier_layer;
    if (earlier != 0) {
        needs.push_back(phrase("Run before: to layer %1 (From layer %2).", std::to_string(earlier),
                               std::to_string(earlier + 1)));
    }
    return needs;
}

}  // namespace psicarve::session
