// SPDX-License-Identifier: GPL-3.0-or-later
// What a round of the supervisor takes up, and that it comes to its end whatever others do to the segment.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <functional>
#include <future>
#include <thread>
#include <vector>

#include "shared/segment/checkpoint.hpp"
#include "tests/two_process/core_rig.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::two_process {
namespace {

/// Long for a core that hears, on a busy computer.
constexpr milliseconds kHeardLimit{20'000};

class CoreRounds : public CoreRig {
protected:
    CoreStatus shown() const { return read_record(segment_->header().status).value_or(CoreStatus{}); }
    void start_on_real_clock(std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"--segment", segment_name_, "--clock",
                                           "real",      "--capacity",  "4000x400"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
        attach();
        ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
            << text_of(file("core.err"));
    }
    bool has_pending_command() const {
        const auto& slots = segment_->header().commands;
        return std::any_of(std::begin(slots), std::end(slots), [](const CommandSlot& slot) {
            return static_cast<std::uint32_t>(slot.state_and_sender.load()) ==
                   static_cast<std::uint32_t>(SlotState::pending);
        });
    }
    Checkpoint checkpoint() const {
        return read_record(segment_->header().checkpoint).value_or(Checkpoint{});
    }
    void attach_to_new_segment() {
        ASSERT_TRUE(eventually([&] {
            const auto fresh = Segment::attach(segment_name_);
            return fresh && fresh->core_pid();
        }));
        attach();
    }
};

/// On the real clock, ready for a start soon.
class StartedJob : public CoreRounds {
protected:
    void start_ready() {
        take_sensors_away(profile_);
        const std::string text = profile_to_toml(profile_);
        ASSERT_TRUE(write_file_atomically(file("machine.toml"), std::as_bytes(std::span{text})));
        start_on_real_clock({"--profile", file("machine.toml")});
        home();
    }
    JobTable job_of(std::uint32_t layers) const {
        JobTable table = lobed_job(layers, 9, profile_);
        std::int64_t height = 20;
        for (std::int64_t& pulses : table.layer_height_pulses) pulses = height += 2;
        return table;
    }
    Profile profile_ = slow_machine();
};

// Both lie there when the core comes round: the tick still has the job before.
TEST_F(StartedJob, IsTheOneThatWasPublishedBeforeTheStartOrNone) {
    start_ready();
    ASSERT_EQ(publish(job_of(2)), "");
    for (int times = 0; times < 3; ++times) {
        core_->send_signal(SIGSTOP);
        const auto generation = publish_job(*segment_, job_blob_from_table(job_of(20)));
        ASSERT_TRUE(generation) << generation.error().message;
        auto answer = std::async(std::launch::async, [&] { return refusal_of(CommandKind::start); });
        ASSERT_TRUE(eventually([&] { return has_pending_command(); }));
        core_->send_signal(SIGCONT);
        const std::string refused = answer.get();
        EXPECT_TRUE(!refused.empty() || status().job_generation == *generation)
            << "the job before was started";
        EXPECT_TRUE(wait_for_acceptance(*segment_, *generation, kLimit));
        if (!refused.empty()) {
            EXPECT_NE(refused.find("once it is accepted"), std::string::npos) << refused;
            EXPECT_EQ(status().state, MachineState::ready);
        } else {
            request_stop(*segment_);
            ASSERT_TRUE(reaches(MachineState::ready));
        }
    }
}

TEST_F(CoreRounds, AFloodOfRefusedCommandsKeepsNobodyFromAnEmergencyStop) {
    constexpr int kSenders = 60;
    start_on_real_clock();
    std::atomic<bool> must_end{false};
    std::vector<std::thread> senders;
    for (int i = 0; i < kSenders; ++i) {
        senders.emplace_back([&] {
            Command command{};
            command.kind = static_cast<CommandKind>(999);
            while (!must_end) static_cast<void>(send_command(*segment_, command, milliseconds{2000}));
        });
    }
    std::this_thread::sleep_for(milliseconds{200});
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return shown().state == MachineState::alarm; }, kHeardLimit));
    must_end = true;
    for (std::thread& sender : senders) sender.join();
}

/// Senders that refill their slots as soon as they are answered. Of commands that were sent after a request
/// it counts the answers that came before the core said that it obeyed: both are moments of the core's own
/// order, and a sender that a busy computer delays counts too few, never too many.
class Flood {
public:
    static constexpr int kSenders = 60;
    static constexpr int kRequests = 5;
    /// Two takes of a round each: of the one that just did not see the request, of the one that did, and of
    /// the one after the tick that obeys.
    static constexpr std::uint64_t kMostBeforeItIsObeyed = 3 * 2 * 16;
    using Obeyed = std::function<bool(MachineState)>;

    Flood(Segment& segment, Obeyed is_obeyed) : segment_(&segment), is_obeyed_(std::move(is_obeyed)) {
        for (int i = 0; i < kSenders; ++i) senders_.emplace_back([this] { send_on(); });
    }
    ~Flood() {
        must_end_ = true;
        for (std::thread& sender : senders_) sender.join();
    }
    Flood(const Flood&) = delete;
    Flood& operator=(const Flood&) = delete;
    std::uint64_t answered() const { return answered_; }
    /// At most kRequests times.
    void ask(void (*request)(Segment&) noexcept) {
        request(*segment_);
        ++requests_;
    }
    bool has_obeyed() const {
        const auto status = read_record(segment_->header().status);
        return status && is_obeyed_(status->state);
    }
    /// The last request.
    std::uint64_t answered_before_obeyed() const { return before_obeyed_.at(requests_); }

private:
    void send_on() {
        Command command{};
        command.kind = static_cast<CommandKind>(999);
        while (!must_end_) {
            const std::size_t number = requests_;
            const auto sent = send_command(*segment_, command, milliseconds{2000});
            ++answered_;
            if (sent || sent.error().code != ErrorCode::machine_refused) continue;
            const auto status = read_record(segment_->header().status);
            if (status && !is_obeyed_(status->state)) ++before_obeyed_[number];
        }
    }

    Segment* segment_;
    Obeyed is_obeyed_;
    std::atomic<bool> must_end_{false};
    std::atomic<std::uint64_t> answered_{0};
    std::atomic<std::size_t> requests_{0};
    std::array<std::atomic<std::uint64_t>, kRequests + 1> before_obeyed_{};  ///< by requests made before
    std::vector<std::thread> senders_;
};

// On the virtual clock supervisor and tick are one thread: what is answered before the stop is no matter of
// how busy the computer is.
TEST_F(CoreRounds, AFloodOfCommandsIsNotAnsweredBeforeAnEmergencyStopWhileHoming) {
    start_core();
    ASSERT_EQ(refusal_of(CommandKind::home), "");
    Flood flood{*segment_, [](MachineState state) { return state == MachineState::alarm; }};
    ASSERT_TRUE(eventually([&] { return flood.answered() > 1000 || shown().state != MachineState::homing; }));
    ASSERT_TRUE(reaches(MachineState::ready)) << "homing goes on under a flood";
    for (int round = 0; round < Flood::kRequests; ++round) {
        ASSERT_TRUE(eventually([&] { return refusal_of(CommandKind::home).empty(); }));
        flood.ask(request_emergency_stop);
        ASSERT_TRUE(eventually([&] { return flood.has_obeyed(); }, kHeardLimit));
        EXPECT_LE(flood.answered_before_obeyed(), Flood::kMostBeforeItIsObeyed);
        ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    }
}

TEST_F(CoreRounds, AFloodOfCommandsIsNotAnsweredBeforeAStopWhileCarving) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    Flood flood{*segment_, [](MachineState state) { return state != MachineState::carving; }};
    for (int round = 0; round < Flood::kRequests; ++round) {
        start_carving();
        ASSERT_TRUE(reaches(MachineState::carving));
        flood.ask(request_stop);
        ASSERT_TRUE(eventually([&] { return flood.has_obeyed(); }, kHeardLimit));
        EXPECT_LE(flood.answered_before_obeyed(), Flood::kMostBeforeItIsObeyed);
        ASSERT_TRUE(reaches(MachineState::ready)) << "while the flood goes on";
    }
}

// A new segment counts its jobs from one again.
TEST_F(CoreRounds, ACheckpointOutlivesItsSegmentAndTheJobsThatArePublishedIntoTheNext) {
    start_core();
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return checkpoint().next_layer >= 3; }));
    ASSERT_TRUE(Segment::remove(segment_name_));
    attach_to_new_segment();
    ASSERT_TRUE(eventually([&] { return shown().state == MachineState::alarm; }));
    const Checkpoint before = checkpoint();
    EXPECT_GE(before.next_layer, 3U);
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    ASSERT_EQ(publish(long_job()), "");
    const std::uint64_t beat = shown().heartbeat;
    ASSERT_TRUE(eventually([&] { return shown().heartbeat > beat + 3; }));
    EXPECT_EQ(checkpoint().job_checksum, before.job_checksum);
    EXPECT_EQ(checkpoint().next_layer, before.next_layer);
}

TEST_F(CoreRounds, ASegmentThatSomebodyElseNeverFinishesMakingHoldsNobodyUp) {
    constexpr std::uint64_t kRounds = 40;
    start_core();
    ASSERT_TRUE(Segment::remove(segment_name_));
    int half_made = -1;
    ASSERT_TRUE(eventually([&] {
        shm_unlink(segment_name_.c_str());
        half_made = shm_open(segment_name_.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
        return half_made >= 0;
    }));
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    ASSERT_EQ(fcntl(half_made, F_OFD_SETLK, &whole), 0);
    const std::uint64_t beat = shown().heartbeat;
    EXPECT_TRUE(eventually([&] { return shown().heartbeat > beat + kRounds; }, kHeardLimit));
    close(half_made);
    attach_to_new_segment();
}

}  // namespace
}  // namespace psicarve::two_process
