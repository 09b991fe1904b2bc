// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/replay/record_states.hpp"
#include "hmi/replay/recording.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::replay {

/// A snapshot as a recording: the machine at each entry of its flight recorder, and its whole status at the
/// end.
class SnapshotRecording final : public Recording {
public:
    static Result<std::unique_ptr<Recording>> open(const std::string& path);

    Result<Shown> at(std::int64_t time_ns, bool with_looks) override;

private:
    SnapshotRecording() = default;
    void list_contents();
    void list_program();
    void fill_from_entry(std::int64_t time_ns, Shown& shown) const;
    void look_back(Shown& shown) const;

    Snapshot snapshot_;  ///< without its job
    RecordStates states_;
    std::optional<verify::JobGeometry> geometry_;
    std::uint64_t first_tick_ = 0;
    std::int64_t period_ns_ = 1;
};

}  // namespace psicarve::replay
