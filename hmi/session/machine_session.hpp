// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hmi/machine/core_profile.hpp"
#include "hmi/machine/forget_piece.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/jog_hand.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/profile_of_core.hpp"
#include "hmi/session/refused_order.hpp"
#include "hmi/session/saved_piece_watch.hpp"
#include "hmi/session/start_intent.hpp"
#include "hmi/session/tick_health.hpp"
#include "shared/machine/command.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::session {

/// The purpose of a job's start.
enum class RunKind : std::uint8_t {
    carve,
    dry,  ///< table and Y go as they would; heads outside the blank, spindle off
};

struct SessionOptions {
    std::string segment_name = kDefaultSegmentName;
    std::string group;
    std::optional<Profile> profile;  ///< chosen by the user; else the built-in one and the job's are tried
    /// How long a jog goes on without a sign of the window. More only where a busy computer must not matter.
    std::chrono::milliseconds hand_limit = kJogLease;
    std::string state_folder{};  ///< where cores keep unfinished pieces; empty: their default folders
    /// Searches files for a core's profile; on a thread of its own, as their disk may hang.
    std::function<std::optional<Profile>(std::uint32_t core_pid, std::uint64_t hash)> find_profile =
        machine::find_core_profile;
};

/// The machine for a window: attaches whenever there is a segment, poll() reads it, orders go to it. No call
/// waits for the core: a thread of its own sends orders, stop and emergency stop are one store. All calls
/// come from one thread, the owner's. Its members: parts, each for one question to the machine, and what of
/// attaching and of orders under way is none of theirs.
class MachineSession {
public:
    MachineSession(SessionOptions options, MessageLog& log);

    /// Call it at screen rate.
    void poll();
    const MachineView& view() const noexcept { return view_; }
    const SessionOptions& options() const noexcept { return options_; }
    /// Chosen by the user, as in the options.
    void set_profile(const Profile& profile);
    /// Offers a profile that may be the machine's: a job's.
    void offer_profile(const Profile& profile) { profile_.offer(profile); }
    /// The profile of the job that the core has accepted; null: there is none, or it is not known. The core
    /// accepts only jobs whose motion matches its own: where its profile is unknown, mm and degrees are
    /// calculated by this one.
    void take_accepted(const Profile* of_job);

    /// While a recording is shown the machine gets no orders but hold, stop and emergency stop; requests
    /// under way are dropped.
    void watch_only(bool only) noexcept;

    // False when there is no core to take them.
    bool stop() noexcept;
    /// Also false when the core is silent; view() then shows an unheard stop until it is acknowledged, or
    /// another one is heard.
    bool emergency_stop() noexcept;
    void acknowledge_unheard_stop() noexcept { view_.unheard_stop = false; }

    /// Sends a command; a refusal becomes a message that begins with `name`.
    void order(const Command& command, const Phrase& name);
    void order(CommandKind kind, const Phrase& name);
    /// For a window that closes: poll() calls `answered` once the core has taken the order, or has refused it
    /// or kept silent; the last two become messages. May be seconds later when the core hangs.
    void order_and_tell(CommandKind kind, const std::function<void(bool was_taken)>& answered);
    /// Moves the heads to that place, then carves `layers` layers (0: all that follow). In state waiting:
    /// carves what the heads wait for.
    void start(const StartPlace& from, std::uint32_t layers = 0, RunKind kind = RunKind::carve);
    /// From the layer's begin.
    void start(std::uint32_t from_layer, std::uint32_t layers = 0, RunKind kind = RunKind::carve) {
        start(StartPlace{from_layer, {}}, layers, kind);
    }
    /// Makes segment and disk forget this unfinished piece, and no other: it will not be continued. The
    /// result becomes a message.
    void forget_piece(const RecordName& record);
    /// The newest value is sent as soon as the one before is answered.
    void set_override(std::uint32_t percent) noexcept {
        if (!watches_only_) wanted_.feed_percent = percent;
    }
    /// The same of a program's rapid ways.
    void set_rapid_override(std::uint32_t percent) noexcept {
        if (!watches_only_) wanted_.rapid_percent = percent;
    }
    /// The core may still show the old percentages.
    bool is_override_under_way() const {
        return wanted_.feed_percent || wanted_.rapid_percent || !orders_.is_idle();
    }
    /// The last order that was refused, while that holds; also a jog or an output's test.
    const std::optional<OrderRefusal>& refused_order() const noexcept { return refused_.told(); }
    /// The fields that such an order would use have changed.
    void forget_refused_order(OrderPlace place) noexcept { refused_.forget(place); }
    /// An order is on its way to the core, or waits for the one before.
    bool has_orders() const { return !orders_.is_idle(); }
    /// Gives the core's motion since the last call, oldest first. Increments that came faster than they were
    /// read are lost.
    void read_increments(const std::function<void(const IncrementEntry&)>& take);
    /// How many increments were lost, since the session attached or skipped.
    std::uint64_t lost_increments() const noexcept { return increments_ ? increments_->lost() : 0; }
    /// Skips all increments reported so far.
    void skip_increments();
    /// The program that runs, or ran last, by whichever process.
    ProgramReport program() const noexcept {
        return link_ ? program_report(link_->segment()) : ProgramReport{};
    }
    JogHand& jog() noexcept { return jog_; }

private:
    using Clock = std::chrono::steady_clock;
    struct Heartbeat {
        std::uint64_t count = 0;
        Clock::time_point changed{};
    };
    /// Overrides that are not sent yet.
    struct WantedOverrides {
        std::optional<std::uint32_t> feed_percent{};
        std::optional<std::uint32_t> rapid_percent{};
    };
    using Then = std::function<void()>;

    void send(const Command& command, const Phrase& name, Then then, Then otherwise = {});
    void keep_attached();
    std::optional<std::uint32_t> core_now() noexcept;
    void look();
    void take_program(const ProgramStatus& before, const CoreStatus& status);
    void take_status(const CoreStatus& status, bool has_core);
    void look_for_checkpoint();
    void deliver_forgetting();
    void go_on_with_start();
    void forget_wishes() noexcept;
    void send_override(CommandKind kind, std::optional<std::uint32_t>& wanted_percent, const Phrase& name);
    void tell_remark(const Phrase& name, const psicarve::Message& remark);
    void tell_refusal(OrderPlace place, const Phrase& name, const Error& why);

    SessionOptions options_;
    MessageLog& log_;
    MachineView view_;
    std::optional<machine::MachineLink> link_;
    std::optional<RingReader<IncrementEntry, kIncrementRingEntries>> increments_;  // of link_
    ProfileOfCore profile_;
    SavedPieceWatch saved_piece_;
    MissedMeter missed_;
    Heartbeat heartbeat_;
    Clock::time_point attach_tried_{};
    std::optional<Clock::time_point> unsigned_since_;  ///< so long the lock's words name no living process
    StartIntent intent_;
    bool has_looked_ = false;  ///< has looked for a core, and knows whether one was there
    bool watches_only_ = false;
    WantedOverrides wanted_;
    RefusedOrder refused_;
    std::uint64_t jogs_asked_ = 0;
    std::string told_remark_;  ///< the last, in English: a key that is pressed again says nothing new
    JogHand jog_;
    BackgroundQueue finder_;
    BackgroundQueue orders_;
};

}  // namespace psicarve::session
