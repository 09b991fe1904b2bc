// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replay_session.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::replay {
namespace {

using session::BackgroundQueue;
using session::phrase;
using session::Severity;

/// A few milliseconds' worth: a jump over a whole job takes some frames.
constexpr std::size_t kMostCutsAtOnce = 400'000;
constexpr double kPointShare = 0.2;  // of the time that a tool's piece takes

}  // namespace

ReplaySession::ReplaySession(session::MessageLog& log) : log_(log) {}

ReplaySession::~ReplaySession() {
    cancels_.store(true);
    if (drops_carving_) drops_carving_->store(true);
}

void ReplaySession::open(const std::string& path, const Profile& profile) {
    post_open({path, {}, profile}, 0);
}

void ReplaySession::open_at(const std::string& path, const Profile& profile, std::uint64_t tick) {
    post_open({path, {}, profile}, 0, tick);
}

void ReplaySession::go_to_tick(std::uint64_t tick) {
    const bool is_there = tick >= facts_.first_tick;
    clock_.seek(is_there ? time_of_ticks(tick - facts_.first_tick, facts_.period_ns) : 0);
    if (!is_there)
        log_.add(Severity::warning,
                 phrase("The flight recorder does not reach back to that moment any more"));
}

void ReplaySession::add_job(const std::string& path) {
    if (!recording_) return;
    OpenOptions options = options_;
    options.job_path = path;
    post_open(options, clock_.now_ns());
}

void ReplaySession::post_open(const OpenOptions& options, std::int64_t from_ns,
                              std::optional<std::uint64_t> at_tick) {
    if (is_opening_) return;
    is_opening_ = true;
    refused_file_.reset();
    cancels_.store(false);
    progress_ratio_.store(0.0);
    opener_.post([this, options, from_ns, at_tick]() -> BackgroundQueue::Finish {
        const auto show = [this](double done) {
            progress_ratio_.store(done);
            return !cancels_.load();
        };
        auto opened = open_recording(options, show);
        if (!opened) return [this, options, error = opened.error()] { fail(options, error); };
        const std::shared_ptr<Recording> recording{std::move(opened).value()};
        return [this, recording, options, from_ns, at_tick] {
            take_opened(recording, options, from_ns);
            if (at_tick) go_to_tick(*at_tick);
        };
    });
}

void ReplaySession::fail(const OpenOptions& options, const Error& error) {
    is_opening_ = false;
    const bool was_cancelled = error.code == ErrorCode::cancelled;
    const session::Phrase why = session::error_phrase(error);
    log_.add(was_cancelled ? Severity::info : Severity::warning, why);
    if (was_cancelled) return;
    refused_file_ = {options.job_path.empty() ? options.path : options.job_path, why};
}

void ReplaySession::take_opened(std::shared_ptr<Recording> recording, const OpenOptions& options,
                                std::int64_t from_ns) {
    is_opening_ = false;
    leave();
    recording_ = std::move(recording);
    options_ = options;
    facts_ = recording_->facts();
    clock_.begin(facts_.end_ns);
    // The last events are usually the reason for a snapshot.
    clock_.seek(facts_.kind == Recording::Kind::snapshot ? facts_.end_ns : from_ns);
    view_ = {};
    view_.life = session::CoreLife::alive;
    view_.profile = facts_.profile;
    ++edition_;
    log_.add(Severity::info,
             phrase("Replay: %1, %2 recorded", std::filesystem::path{options.path}.filename().string(),
                    session::clock_text(seconds_from_ns(facts_.end_ns))));
    for (const session::Phrase& warning : facts_.warnings) log_.add(Severity::warning, warning);
    prepare_carving();
}

void ReplaySession::leave() {
    if (!recording_) return;
    reader_.drop_waiting();
    if (drops_carving_) drops_carving_->store(true);
    recording_.reset();  // a read that is under way keeps its own reference
    facts_ = {};
    clock_.begin(0);
    has_shown_ = false;
    shown_ = {};
    view_ = {};
    history_.forget();
    carving_.reset();
    timeline_.reset();
    tool_piece_.reset();
    cuts_ = 0;
    carving_ratio_.store(1.0);
    ++edition_;
}

void ReplaySession::prepare_carving() {
    if (!facts_.job) return;
    drops_carving_ = std::make_shared<std::atomic<bool>>(false);
    carving_ratio_.store(0.0);
    carver_.post([this, job = facts_.job, index = recording_->index(), drops = drops_carving_,
                  edition = edition_]() -> BackgroundQueue::Finish {
        const bool is_of_tool = job->profile.tool.shape != ToolShape::point;
        const double first_share = is_of_tool ? kPointShare : 1.0;
        const auto show = [this, &drops](double done) {
            if (!drops->load()) carving_ratio_.store(done);
            return !drops->load();
        };
        const auto show_first = [&](double done) { return show(first_share * done); };
        const auto show_tool = [&](double done) { return show(first_share + (1.0 - first_share) * done); };
        const auto piece = std::make_shared<Piece>();
        piece->is_of_tool = is_of_tool;
        auto record = session::CarvingRecord::make(job);
        auto timeline = index ? CarvingTimeline::of_trace(job, index, show_first)
                              : CarvingTimeline::of_job(job, show_first);
        if (record) piece->record = std::move(record).value();
        if (timeline) piece->timeline = std::move(timeline).value();
        if (is_of_tool && piece->timeline) {
            auto tool =
                index ? ToolTimeline::of_trace(job, index, show_tool) : ToolTimeline::of_job(job, show_tool);
            if (tool) piece->tool = std::make_unique<ReplayPiece>(std::move(tool).value());
        }
        return [this, edition, piece] {
            if (edition == edition_) take_piece(*piece);
        };
    });
}

void ReplaySession::take_piece(Piece& piece) {
    carving_ratio_.store(1.0);
    if (!piece.record || !piece.timeline || (piece.is_of_tool && !piece.tool))
        return log_.add(Severity::warning, phrase("Replay: the piece cannot be shown"));
    carving_ = std::move(piece.record);
    timeline_ = std::move(piece.timeline);
    tool_piece_ = std::move(piece.tool);
    cuts_ = 0;
    if (!timeline_->is_whole())
        log_.add(Severity::warning, phrase("Replay: the piece is too large to be shown to its end"));
}

void ReplaySession::poll(Clock::time_point now) {
    opener_.deliver();
    reader_.deliver();
    carver_.deliver();
    const auto passed = now - std::exchange(polled_, now);
    if (!recording_) return;
    // After the window has stood still for a while the replay does not jump ahead.
    constexpr std::chrono::milliseconds kMostPassed{250};
    clock_.advance(std::min<Clock::duration>(passed, kMostPassed) / std::chrono::nanoseconds{1});
    ask_for_moment();
    follow_carving();
}

void ReplaySession::ask_for_moment() {
    const std::int64_t wanted_ns = clock_.now_ns();
    const bool is_shown = has_shown_ && shown_.time_ns == wanted_ns && (!wants_looks_ || shown_has_looks_);
    if (is_shown || !reader_.is_idle()) return;
    reader_.post([this, recording = recording_, wanted_ns, with_looks = wants_looks_,
                  edition = edition_]() -> BackgroundQueue::Finish {
        auto shown = std::make_shared<Result<Shown>>(recording->at(wanted_ns, with_looks));
        return [this, shown, with_looks, edition] {
            if (edition != edition_) return;
            if (!*shown) {
                log_.add(Severity::warning, session::error_phrase(shown->error()));
                return leave();
            }
            shown_has_looks_ = with_looks;
            take_shown(std::move(*shown).value());
        };
    });
}

void ReplaySession::take_shown(Shown shown) {
    shown_ = std::move(shown);
    has_shown_ = true;
    CoreStatus& status = shown_.status;
    if (facts_.job && shown_.place) {
        const std::uint32_t points = facts_.job->view.point_count();
        status.layer = shown_.place->layer;
        status.point = shown_.place->point;
        status.points_total = std::uint64_t{facts_.job->view.layer_count()} * points;
        status.points_done = std::uint64_t{status.layer} * points + status.point + 1;
    }
    view_.status = status;
    if (shown_has_looks_) history_.show(std::move(shown_.looks));
}

void ReplaySession::follow_carving() {
    if (!timeline_ || !has_shown_) return;
    cuts_ = timeline_->apply(*carving_, cuts_, shown_.carving_time, kMostCutsAtOnce);
    if (tool_piece_) tool_piece_->want(shown_.carving_time);
}

bool ReplaySession::is_settled() const noexcept {
    if (!recording_ || !has_shown_ || shown_.time_ns != clock_.now_ns()) return false;
    if (wants_looks_ && !shown_has_looks_) return false;
    if (carving_ratio_.load() < 1.0) return false;
    if (tool_piece_ && !tool_piece_->shows(shown_.carving_time)) return false;
    return !timeline_ || timeline_->is_applied(cuts_, shown_.carving_time);
}

void ReplaySession::step_layer(int by) {
    // Uses the piece's own history: the first cut of that layer.
    if (!timeline_ || !shown_.place || !facts_.knows_every_pulse) return;
    const auto time = timeline_->begin_of_layer(static_cast<std::int64_t>(shown_.place->layer) + by);
    if (time) clock_.seek(*time);
}

}  // namespace psicarve::replay
