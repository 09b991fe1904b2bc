// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace psicarve::session {

/// A point of a job's tables.
struct TablePlace {
    std::uint32_t layer = 0;
    std::uint32_t point = 0;
    bool operator==(const TablePlace&) const = default;
};

/// The layer and point of a job that the view shows: those of the machine while it carves this job, until
/// others are chosen; then those, until the view follows the machine again.
class LayerCursor {
public:
    /// Another job. Keeps the choice where the job has such a layer and point. Requires at least one of each.
    void begin(std::uint32_t layer_count, std::uint32_t point_count);
    void choose_layer(std::uint32_t layer);
    void choose_point(std::uint32_t point);
    void follow(bool follows) noexcept { follows_ = follows; }
    /// The machine's place; nothing while it is not at this job: the view follows it the next time.
    void note_machine(const std::optional<TablePlace>& machine);

    const TablePlace& place() const noexcept { return place_; }
    bool follows() const noexcept { return follows_; }

private:
    void put(TablePlace place) noexcept;

    TablePlace place_;
    std::uint32_t layer_count_ = 1;
    std::uint32_t point_count_ = 1;
    bool follows_ = true;
    bool is_at_job_ = false;
};

}  // namespace psicarve::session
