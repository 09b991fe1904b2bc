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
#include "hmi/session/background_queue.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// What the job's tool leaves of its blank, from the increments that the core reports, cut in the background
/// by a thread of its own. Layers with lost increments, layers that were not seen, or that came faster than
/// they could be cut, are cut as the job says once they are done. The owner waits for it only in the
/// destructor, and then for one place to be cut, or one piece to be copied. Its members: the owner's half,
/// the half of its thread, and between them what both may touch; in this order, told apart below.
class LivePiece {
public:
    /// The machine at one time.
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

    /// A place of the axes, oldest first. Cut after the next look().
    void take(const IncrementEntry& entry) { told_.push_back(entry); }
    /// Call it after all present increments were taken.
    void look(const Look& now);

    piece::PieceFront& front() noexcept { return front_; }
    /// How many layers wait to be cut as the job says.
    std::uint32_t layers_to_come() const noexcept { return layers_to_come_.load(); }
    /// How many increments wait.
    std::size_t waiting() const noexcept { return waiting_.load(); }
    /// How many layers came faster than they could be cut.
    std::uint32_t skipped_layers() const noexcept { return skipped_layers_; }
    /// How many places were cut. Outlives this, and shows what the destructor left uncut.
    std::shared_ptr<const std::atomic<std::size_t>> places_cut() const noexcept { return places_cut_; }
    /// Waits until all increments taken are cut and published.
    void finish();

    /// The most increments that wait: half a minute of a machine's work, and on the virtual clock as many as
    /// are cut in about a second.
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

    // Used by the owner:
    std::shared_ptr<const cam::PreparedJob> job_;  ///< the geometry refers to it
    std::uint32_t layer_count_;
    std::uint32_t point_count_;
    std::vector<IncrementEntry> told_;
    std::vector<Seen> layers_;
    std::uint32_t layer_before_ = 0;
    bool has_looked_ = false;
    bool has_gap_ = false;  ///< it may reach beyond the layer of the last look
    std::uint32_t skipped_layers_ = 0;

    // Used by the queue's thread:
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
    BackgroundQueue queue_{BackgroundQueue::Haste::background};  // last: it uses the others
};

}  // namespace psicarve::session
