// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/machine_session.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "hmi/phrase/message_phrase.hpp"
#include "hmi/session/saved_piece.hpp"
#include "hmi/session/start_place.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::session {
namespace {

using machine::MachineLink;

constexpr std::chrono::milliseconds kAttachPause{200};

}  // namespace

MachineSession::MachineSession(SessionOptions options, MessageLog& log)
    : options_(std::move(options)),
      log_(log),
      profile_(options_.find_profile),
      saved_piece_(options_.segment_name, options_.group, options_.state_folder),
      jog_(
          options_.segment_name, options_.group,
          [this](const Error& error, bool is_of_test) {
              tell_refusal(is_of_test ? OrderPlace::outputs : OrderPlace::jog, phrase("By hand"), error);
          },
          [this](const psicarve::Message& remark) { tell_remark(phrase("By hand"), remark); },
          options_.hand_limit) {
    view_.watched_since = std::chrono::system_clock::now();
    if (options_.profile) profile_.offer(*options_.profile);
    profile_.offer(Profile{});
}

void MachineSession::set_profile(const Profile& profile) {
    options_.profile = profile;
    profile_.offer(profile);
    profile_.forget();  // it may be the built-in one, which is known
}

void MachineSession::take_accepted(const Profile* of_job) {
    // The last known status of a dead core keeps its profile.
    if (!view_.is_heard() || (view_.profile && !view_.is_profile_of_job)) return;
    view_.is_profile_of_job = of_job != nullptr;
    view_.profile.reset();
    if (of_job != nullptr) view_.profile = *of_job;
}

void MachineSession::poll() {
    finder_.deliver();
    deliver_forgetting();
    profile_.poll();
    orders_.deliver();
    const MachineView before = view_;
    keep_attached();
    look();
    // Whose piece it may be is not known before the first look.
    if (has_looked_)
        saved_piece_.poll(link_ ? link_->segment().core_keeping() : CoreKeeping{}, view_, Clock::now());
    refused_.look(view_);
    if (jogs_asked_ != jog_.asked()) refused_.forget();
    jogs_asked_ = jog_.asked();
    jog_.poll();
    for (Message& message : changes_between(before, view_)) log_.add(std::move(message));
    go_on_with_start();
    send_override(CommandKind::override, wanted_.feed_percent, phrase("Feed override"));
    send_override(CommandKind::rapid_override, wanted_.rapid_percent, phrase("Override of rapids"));
}

// One after another; no reason to drop a start that is under way.
void MachineSession::send_override(CommandKind kind, std::optional<std::uint32_t>& wanted_percent,
                                   const Phrase& name) {
    if (!wanted_percent || !orders_.is_idle()) return;
    const double percent = *std::exchange(wanted_percent, std::nullopt);
    send(Command{kind, 0, percent, 0}, name, {});
}

void MachineSession::keep_attached() {
    if (link_ && !link_->segment().is_still_linked()) {
        increments_.reset();
        link_.reset();
    }
    const auto now = Clock::now();
    if (link_ || !finder_.is_idle() || now - attach_tried_ < kAttachPause) return;
    attach_tried_ = now;
    finder_.post([this, name = options_.segment_name, group = options_.group]() -> BackgroundQueue::Finish {
        auto found = std::make_shared<Result<MachineLink>>(MachineLink::attach(name, group));
        return [this, found] {
            const bool is_missing = !*found && found->error().code == ErrorCode::no_core;
            view_.segment_problem = *found || is_missing ? std::string{} : found->error().message;
            if (!*found) {
                has_looked_ = true;
                return;
            }
            link_.emplace(std::move(*found).value());
            increments_.emplace(link_->segment().header().increments);
        };
    });
}

/// Segment::core_pid() without its wait: a core may take seconds until it signs, when it plans the job that
/// was left. Until then it counts as none, since it reads no commands.
std::optional<std::uint32_t> MachineSession::core_now() noexcept {
    const auto now = Clock::now();
    const auto core = link_->segment().glance_at_core();
    if (!core || core->is_signed || core->pid == 0) {
        unsigned_since_.reset();
        return core && core->is_signed ? std::optional{core->pid} : std::nullopt;
    }
    // The core before it, for an instant; or one whose process cannot be seen from here.
    if (!unsigned_since_) unsigned_since_ = now;
    return now - *unsigned_since_ < kSigningLimit ? std::nullopt : std::optional{core->pid};
}

void MachineSession::look() {
    const auto now = Clock::now();
    if (!link_) {
        view_.life = CoreLife::none;
        return;
    }
    const auto pid = core_now();
    if (pid && *pid != view_.core_pid) {
        missed_.forget();
        view_.core_pid = *pid;
        view_.is_core_of_first_look = !has_looked_;
        view_.port_name.clear();
        heartbeat_.count = 0;
        heartbeat_.changed = now;  // a core that has just begun gets its time to write
    }
    has_looked_ = true;
    if (pid && view_.port_name.empty()) view_.port_name = link_->port_name();
    const ProgramStatus program_before = program_report(link_->segment()).status;
    const auto status = link_->last_status();
    if (status && status->heartbeat != heartbeat_.count) {
        heartbeat_.count = status->heartbeat;
        heartbeat_.changed = now;
        take_program(program_before, *status);
        take_status(*status, pid.has_value());
    }
    const auto silence = std::chrono::duration_cast<std::chrono::milliseconds>(now - heartbeat_.changed);
    view_.life = core_life(pid.has_value(), silence);
    profile_.look(link_->segment().header().core_profile_hash.load(), options_.profile, view_);
    profile_.search(view_);
    look_for_checkpoint();
}

/// The core writes it before the status that goes with it: where that is the older one, a program that has
/// ended meanwhile still ran.
void MachineSession::take_program(const ProgramStatus& before, const CoreStatus& status) {
    const ProgramReport report = program_report(link_->segment());
    const bool ran = view_.runs_program();
    view_.program = report.status;
    if (before.program == report.status.program && before.is_running != 0) view_.program.is_running = 1;
    view_.program_refusal.reset();
    if (is_for_good(report.status.hold) && report.refusal) view_.program_refusal = report.refusal->said;
    const bool is_alarm = status.state == MachineState::alarm || status.state == MachineState::backing_off;
    view_.is_alarm_of_program = is_alarm && (ran || view_.is_alarm_of_program);
}

void MachineSession::take_status(const CoreStatus& status, bool has_core) {
    // A guard's last words come after the core has ended, and do not count as hearing the core.
    const bool is_of_heard_core = view_.status && view_.status->tick <= status.tick;
    view_.missed_ticks_at_alarm = missed_ticks_at_alarm(view_, status);
    view_.missed_per_s = missed_.note(status.missed_ticks, Clock::now());
    // Another core may have the pid of the one before.
    if (view_.status && !is_of_heard_core) view_.is_core_of_first_look = false;
    view_.status = status;
    if (has_core) {
        view_.status_time = std::chrono::system_clock::now();
        view_.heard_state = status.state;
    } else if (!is_of_heard_core) {
        // The time of a dead core's status is not known.
        view_.status_time = {};
        view_.heard_state.reset();
    }
}

void MachineSession::look_for_checkpoint() {
    view_.resumable_layer.reset();
    view_.resumable_point.reset();
    view_.earlier_layer.reset();
    view_.is_checkpoint_from_disk = false;
    view_.is_disk_refusing = link_->segment().core_keeping().how == CoreKeeping::How::refused;
    view_.job_remarks = view_.is_heard() ? link_->job_remarks() : std::vector<psicarve::Message>{};
    const auto checkpoint = link_->checkpoint();
    if (!checkpoint || !link_->is_of_published_job(*checkpoint)) return;
    if (checkpoint->next_layer > 0 && checkpoint->next_layer < checkpoint->layer_count)
        view_.resumable_layer = checkpoint->next_layer;
    if (!is_contradicted(*checkpoint, view_)) view_.resumable_point = link_->point_to_resume(*checkpoint);
    if (checkpoint->earlier_layer != 0) view_.earlier_layer = checkpoint->earlier_layer;
    view_.checkpoint_layer_count = checkpoint->layer_count;
    view_.checkpoint_job_checksum = checkpoint->job_checksum;
    view_.is_checkpoint_from_disk = checkpoint->is_from_disk();
}

void MachineSession::forget_piece(const RecordName& record) {
    if (!watches_only_) saved_piece_.forget(record);
}

void MachineSession::deliver_forgetting() {
    const auto done = saved_piece_.take_forgotten();
    if (!done) return;
    if (!*done) return log_.add(Severity::warning, refusal_phrase(phrase("Forget"), done->error()));
    view_.saved_piece.reset();
    log_.add(Severity::info, phrase("The unfinished piece is forgotten."));
}

void MachineSession::go_on_with_start() {
    if (view_.life == CoreLife::none) return intent_.drop();
    // A core that is silent for a moment is still on its way to the first point.
    if (view_.is_heard() && view_.status && intent_.take(*view_.status))
        order(CommandKind::start_interpolation, phrase("Start"));
}

void MachineSession::forget_wishes() noexcept {
    intent_.drop();
    orders_.drop_waiting();
    wanted_.feed_percent.reset();
    wanted_.rapid_percent.reset();
    jog_.release();
    refused_.forget();
}

void MachineSession::tell_refusal(OrderPlace place, const Phrase& name, const Error& why) {
    const Phrase what = refusal_phrase(name, why);
    log_.add_command(Severity::warning, what);
    refused_.note({place, what, help_for(why.said)}, view_);
}

/// Of an order that was taken.
void MachineSession::tell_remark(const Phrase& name, const psicarve::Message& remark) {
    Phrase told = joined(name, message_phrase(remark));
    std::string words = in_english(told);
    if (words == std::exchange(told_remark_, words)) return;
    log_.add_command(Severity::info, std::move(told));
}

void MachineSession::read_increments(const std::function<void(const IncrementEntry&)>& take) {
    // No more than the ring holds at one time: a core on the virtual clock writes faster than any reader
    // reads.
    for (std::size_t i = 0; increments_ && i < kIncrementRingEntries; ++i) {
        const auto entry = increments_->next();
        if (!entry) return;
        take(*entry);
    }
}

void MachineSession::skip_increments() {
    if (link_) increments_.emplace(link_->segment().header().increments, true);
}

void MachineSession::watch_only(bool only) noexcept {
    if (only && !watches_only_) forget_wishes();
    watches_only_ = only;
    jog_.set_locked(only);
}

bool MachineSession::stop() noexcept {
    forget_wishes();
    if (!link_) return false;
    link_->stop();
    return core_now().has_value();
}

bool MachineSession::emergency_stop() noexcept {
    if (link_) link_->emergency_stop();
    forget_wishes();
    const bool has_core = link_ && core_now().has_value();
    view_.unheard_stop = !has_core || view_.life == CoreLife::silent;
    return !view_.unheard_stop;
}

void MachineSession::order(const Command& command, const Phrase& name) {
    intent_.drop();
    send(command, name, {});
}

void MachineSession::order(CommandKind kind, const Phrase& name) {
    Command command{};
    command.kind = kind;
    order(command, name);
}

void MachineSession::order_and_tell(CommandKind kind, const std::function<void(bool)>& answered) {
    forget_wishes();
    Command command{};
    command.kind = kind;
    send(
        command, phrase("%1", name_of(kind)), [answered] { answered(true); },
        [answered] { answered(false); });
}

void MachineSession::start(const StartPlace& from, std::uint32_t layers, RunKind kind) {
    if (view_.state() == MachineState::waiting)
        return order(CommandKind::start_interpolation, phrase("Start"));
    const Command command = start_command(view_, from, layers, kind == RunKind::dry);
    intent_.drop();
    send(command, start_name(from), [this] {
        const auto status = link_ ? link_->last_status() : std::nullopt;
        if (status) intent_.arm(status->heartbeat);
    });
}

void MachineSession::send(const Command& command, const Phrase& name, Then then, Then otherwise) {
    if (watches_only_ && command.kind != CommandKind::hold) {
        return log_.add(Severity::warning, joined(name, phrase("a recording is shown; leave replay first")));
    }
    refused_.forget();
    orders_.post([this, command, name, then = std::move(then), otherwise = std::move(otherwise),
                  segment = options_.segment_name, group = options_.group]() -> BackgroundQueue::Finish {
        auto link = MachineLink::attach(segment, group);
        const auto sent = link ? link->send(command) : Result<void>{link.error()};
        const bool is_turned_at =
            command.kind == CommandKind::override || command.kind == CommandKind::rapid_override;
        if (sent && is_turned_at) return then;
        if (sent)
            return [this, name, then, remark = link->command_remark()] {
                Phrase asked = phrase("Asked for: %1");
                asked.inner.push_back(name);
                log_.add_command(Severity::info, std::move(asked));
                if (!remark.is_none()) tell_remark(name, remark);
                if (then) then();
            };
        return [this, place = place_of(command.kind), name, otherwise, why = sent.error()] {
            tell_refusal(place, name, why);
            if (otherwise) otherwise();
        };
    });
}

}  // namespace psicarve::session
