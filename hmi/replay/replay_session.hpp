// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hmi/replay/carving_timeline.hpp"
#include "hmi/replay/pin_looks.hpp"
#include "hmi/replay/recording.hpp"
#include "hmi/replay/replay_clock.hpp"
#include "hmi/replay/replay_piece.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/refused_file.hpp"

namespace psicarve::replay {

/// The recording that a window shows instead of the machine. Threads of its own read files; the owner calls
/// poll() and never waits. All calls come from one thread, the owner's. Its members: the recording, what of
/// it is shown, and for each of three threads what it and the owner tell each other.
class ReplaySession {
public:
    using Clock = std::chrono::steady_clock;

    explicit ReplaySession(session::MessageLog& log);
    ~ReplaySession();

    /// Opens a trace or a snapshot; `profile` for a trace without a job. The open recording stays until the
    /// new one is ready, and when that cannot be read.
    void open(const std::string& path, const Profile& profile);
    /// Opens a snapshot at this tick of its core; at its begin where the flight recorder does not reach back
    /// that far.
    void open_at(const std::string& path, const Profile& profile, std::uint64_t tick);
    /// Opens the trace again, with this job or snapshot.
    void add_job(const std::string& path);
    /// Lets opening end soon.
    void cancel() noexcept { cancels_.store(true); }
    /// Returns to the machine.
    void leave();

    /// The file that was last asked for and could not be opened, until the next one is asked for.
    const std::optional<session::RefusedFile>& refused_file() const noexcept { return refused_file_; }
    void forget_refused_file() noexcept { refused_file_.reset(); }

    bool is_opening() const noexcept { return is_opening_; }
    double progress_ratio() const noexcept { return progress_ratio_.load(); }
    bool is_open() const noexcept { return recording_ != nullptr; }
    /// Grows when another recording is open, or none.
    std::uint64_t edition() const noexcept { return edition_; }

    /// Call it at screen rate.
    void poll(Clock::time_point now);
    ReplayClock& clock() noexcept { return clock_; }
    const ReplayClock& clock() const noexcept { return clock_; }
    /// Goes to the begin of the layer before or after, if the recording knows it.
    void step_layer(int by);

    // While is_open():
    const Recording::Facts& facts() const noexcept { return facts_; }
    /// The machine as it was at shown().time_ns.
    const session::MachineView& view() const noexcept { return view_; }
    const Shown& shown() const noexcept { return shown_; }
    /// Whether it shows the clock's time, piece included.
    bool is_settled() const noexcept;
    /// Whether the timing diagram is visible: it costs reading.
    void want_looks(bool wanted) noexcept { wants_looks_ = wanted; }
    const session::LevelHistory& history() const noexcept { return history_; }
    /// The piece at that time; null without a job, or until it is calculated.
    session::CarvingRecord* carving() const noexcept { return carving_.get(); }
    /// What the tool has left of it, if it has a size.
    piece::PieceFront* tool_piece() const noexcept { return tool_piece_ ? &tool_piece_->front() : nullptr; }
    /// Progress of calculating the piece; 1 when there is nothing to do.
    double carving_ratio() const noexcept { return carving_ratio_.load(); }

private:
    struct Piece {
        std::unique_ptr<session::CarvingRecord> record;
        std::shared_ptr<const CarvingTimeline> timeline;
        bool is_of_tool = false;
        std::unique_ptr<ReplayPiece> tool;
    };

    void post_open(const OpenOptions& options, std::int64_t from_ns,
                   std::optional<std::uint64_t> at_tick = std::nullopt);
    void take_opened(std::shared_ptr<Recording> recording, const OpenOptions& options, std::int64_t from_ns);
    void go_to_tick(std::uint64_t tick);
    void fail(const OpenOptions& options, const Error& error);
    void prepare_carving();
    void take_piece(Piece& piece);
    void ask_for_moment();
    void take_shown(Shown shown);
    void follow_carving();

    session::MessageLog& log_;
    ReplayClock clock_;
    Clock::time_point polled_{};
    OpenOptions options_;
    std::shared_ptr<Recording> recording_;
    Recording::Facts facts_;
    session::MachineView view_;
    Shown shown_;
    bool has_shown_ = false;
    bool shown_has_looks_ = false;
    bool wants_looks_ = false;
    session::LevelHistory history_;
    std::unique_ptr<session::CarvingRecord> carving_;
    std::shared_ptr<const CarvingTimeline> timeline_;
    std::unique_ptr<ReplayPiece> tool_piece_;
    std::size_t cuts_ = 0;  ///< the cuts of timeline_ that carving_ contains
    std::uint64_t edition_ = 0;
    std::optional<session::RefusedFile> refused_file_;
    bool is_opening_ = false;
    std::atomic<bool> cancels_{false};
    std::shared_ptr<std::atomic<bool>> drops_carving_;  ///< of the piece that is being calculated
    std::atomic<double> progress_ratio_{0.0};
    std::atomic<double> carving_ratio_{1.0};
    session::BackgroundQueue opener_;  // last: their threads use the others
    session::BackgroundQueue reader_;
    session::BackgroundQueue carver_;
};

/// Why no order can be given while a recording is shown.
inline std::optional<session::Phrase> lock() {
    return session::phrase("Replay moves nothing: leave replay first");
}

}  // namespace psicarve::replay
