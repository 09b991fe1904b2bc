// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/piece/piece_front.hpp"
#include "hmi/piece/tool_way.hpp"
#include "hmi/session/work_lane.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// What the job's tool leaves of its blank, from the increments that the core reports, cut on a thread of its
/// own in the background. Layers of which increments were lost, which nobody saw, or which came faster than
/// they could be cut are cut as the job says once they are done. The owner never waits for it, but when it
/// ends, and then for one place to be cut, or one piece to be copied.
class LivePiece {
public:
    /// Of the machine at one time.
    struct Look {
        std::uint64_t points_done = 0;
        bool has_lost = false;  ///< increments, since the look before
    };

    /// Requires a tool that has a size. Takes some milliseconds.
    LivePiece(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry,
              std::size_t columns = piece::kViewColumns);
    ~LivePiece();
    LivePiece(const LivePiece&) = delete;
    LivePiece& operator=(const LivePiece&) = delete;

    /// Where the axes were, oldest first. Cut behind the next look().
    void take(const IncrementEntry& entry) { told_.push_back(entry); }
    /// After all increments that are there were taken.
    void look(const Look& now);

    piece::PieceFront& front() noexcept { return front_; }
    /// How many layers are still to be cut as the job says.
    std::uint32_t layers_to_come() const noexcept { return layers_to_come_.load(); }
    /// How many increments wait.
    std::size_t waiting() const noexcept { return waiting_.load(); }
    /// How many layers came faster than they could be cut.
    std::uint32_t skipped_layers() const noexcept { return skipped_layers_; }
    /// How many places were cut. Outlives this, and tells what its end left uncut.
    std::shared_ptr<const std::atomic<std::size_t>> places_cut() const noexcept { return places_cut_; }
    /// Waits until all that was told is cut and published.
    void finish();

    /// Increments that wait at most: half a minute of a machine's work, and as much on the virtual clock as
    /// is cut in about a second.
    static constexpr std::size_t kMostWaiting = 200'000;

private:
    enum class Seen : std::uint8_t { yes, no, cut };

    void hand_over();
    void mark_unseen(std::uint32_t first, std::uint32_t last);
    void post_unseen(std::uint32_t end);
    void post_layer(std::uint32_t layer, std::uint32_t end_step);
    void cut(const std::vector<IncrementEntry>& entries);
    void settle(const verify::Positions& at);
    void show();

    // The owner's:
    std::shared_ptr<const cam::PreparedJob> job_;  ///< that the geometry looks into
    std::uint32_t layer_count_;
    std::uint32_t point_count_;
    std::vector<IncrementEntry> told_;
    std::vector<Seen> layers_;
    std::uint32_t layer_before_ = 0;
    bool has_looked_ = false;
    bool has_gap_ = false;  ///< that may reach beyond the layer of the last look
    std::uint32_t skipped_layers_ = 0;

    // The lane's:
    piece::StockMap stock_;
    piece::PieceCarver carver_;
    piece::ToolWay way_;
    std::optional<verify::Positions> last_;
    std::chrono::steady_clock::time_point shown_{};

    piece::PieceFront front_;
    std::atomic<std::size_t> waiting_{0};
    std::atomic<std::uint32_t> layers_to_come_{0};
    std::shared_ptr<std::atomic<std::size_t>> places_cut_ = std::make_shared<std::atomic<std::size_t>>(0);
    std::atomic<bool> is_dropped_{false};
    WorkLane lane_{WorkLane::Haste::background};  // last: it uses the others
};

}  // namespace psicarve::session
