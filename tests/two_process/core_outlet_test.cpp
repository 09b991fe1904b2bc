// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the core's words and traces, and the files that its supervisor's thread reads, may stand
// still: no order to stop waits for them.
#include <fcntl.h>
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "tests/places.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

/// Long for a core that hears, on a busy computer; none that waits for a reader ever comes to it.
constexpr milliseconds kHeardLimit{20'000};

/// A named pipe whose reader stands still when it is told to.
class StandingReader {
public:
    explicit StandingReader(std::string path) : path_(std::move(path)) {
        EXPECT_EQ(mkfifo(path_.c_str(), 0600), 0);
        pipe_ = open(path_.c_str(), O_RDWR | O_NONBLOCK);
        EXPECT_GE(pipe_, 0);
        thread_ = std::thread{[this] { read_all(); }};
    }
    StandingReader(const StandingReader&) = delete;
    StandingReader& operator=(const StandingReader&) = delete;
    ~StandingReader() {
        must_end_ = true;
        thread_.join();
        close(pipe_);
    }
    const std::string& path() const { return path_; }
    void stand() { stands_ = true; }
    void go_on() { stands_ = false; }
    /// From here on nothing fits.
    void stand_and_fill() {
        stand();
        const std::string filling(4096, '#');
        std::this_thread::sleep_for(milliseconds{20});
        for (std::size_t piece = filling.size(); piece > 0;) {
            if (write(pipe_, filling.data(), piece) < 0) piece /= 2;
        }
    }
    std::string taken() {
        const std::scoped_lock lock(mutex_);
        return taken_;
    }

private:
    void read_all() {
        std::array<char, 4096> bytes{};
        while (!must_end_) {
            const ssize_t got = stands_ ? -1 : read(pipe_, bytes.data(), bytes.size());
            if (got <= 0) {
                std::this_thread::sleep_for(milliseconds{2});
                continue;
            }
            const std::scoped_lock lock(mutex_);
            taken_.append(bytes.data(), static_cast<std::size_t>(got));
        }
    }
    std::string path_;
    int pipe_ = -1;
    std::atomic<bool> stands_{false};
    std::atomic<bool> must_end_{false};
    std::mutex mutex_;
    std::string taken_;
    std::thread thread_;
};

class CoreOutlet : public PortRig {
protected:
    CoreOutlet() { home_where_it_stands(); }
    void carve(const std::vector<std::string>& more) {
        start_port_core(more);
        home();
        ASSERT_EQ(publish(coarse_job(40)), "");
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    }
    bool is_spindle_on() {
        const auto levels = fake_port::levels_of(port_.writes(), profile_);
        return !levels.empty() && (levels.back() & bit_of(Signal::spindle)) != 0;
    }
    bool has_ended() const { return text_of("/proc/" + std::to_string(core_pid_) + "/stat").empty(); }
    /// Stands still where the hook that is loaded into it says, for as long as file("held") is there.
    void start_core_that_can_be_held(const char* hook, const std::vector<std::string>& more = {}) {
        {
            const fake_port::FakePortFile::Preload port{port_};
            const std::string both =
                std::string{std::getenv("LD_PRELOAD")} + ":" + in_build("tests/wall_clock_preload.so");
            setenv("LD_PRELOAD", both.c_str(), 1);
            setenv(hook, file("held").c_str(), 1);
            std::vector<std::string> arguments = port_arguments(segment_name_);
            arguments.insert(arguments.end(), more.begin(), more.end());
            core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
            unsetenv(hook);
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
    }
    void hold_it() const { std::ofstream{file("held")} << "held"; }
    void let_it_go() const { EXPECT_EQ(std::remove(file("held").c_str()), 0); }
};

TEST_F(CoreOutlet, AnEmergencyStopIsHeardWhileATracesReaderStandsStill) {
    StandingReader reader{file("standing.trace")};
    carve({"--trace", reader.path()});
    reader.stand_and_fill();
    const std::uint64_t heartbeat = status().heartbeat;
    EXPECT_TRUE(eventually([&] { return status().heartbeat > heartbeat + 20; }, kHeardLimit));
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return status().state == MachineState::alarm; }, kHeardLimit));
    EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop);
    EXPECT_FALSE(is_spindle_on());
    // It ends in order, though its words have no reader.
    core_->send_signal(SIGTERM);
    EXPECT_TRUE(eventually([&] { return has_ended(); }, kHeardLimit));
    if (!has_ended()) kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    const std::string said = text_of(file("core.err"));
    EXPECT_NE(said.find("standing.trace: "), std::string::npos) << said;
    EXPECT_NE(said.find("not complete"), std::string::npos) << said;
}

TEST_F(CoreOutlet, TwoOrdersEndACarvingWhileATracesReaderStandsStillAndThePortFails) {
    StandingReader reader{file("standing.vcd")};
    carve({"--trace", reader.path()});
    reader.stand_and_fill();
    std::this_thread::sleep_for(milliseconds{50});
    fail_port(EIO, -1);
    core_->send_signal(SIGTERM);
    std::this_thread::sleep_for(milliseconds{50});
    core_->send_signal(SIGTERM);
    // By now it ticks no more, and waits for the reader; so stopped, it does nothing for the port.
    std::this_thread::sleep_for(milliseconds{500});
    kill(core_pid_, SIGSTOP);
    mend_port();
    EXPECT_TRUE(eventually([&] { return is_safe(); }, kHeardLimit)) << "the guard goes on trying";
    kill(core_pid_, SIGCONT);
    EXPECT_TRUE(eventually([&] { return has_ended(); }, kHeardLimit));
    if (!has_ended()) kill(core_pid_, SIGKILL);
    core_->wait_for_exit();
}

// The trace is whole all the same: time stands still meanwhile, but not for those who want a stop.
TEST_F(CoreOutlet, OnTheVirtualClockAStopIsHeardWhileATracesReaderStandsStill) {
    StandingReader reader{file("standing.trace")};
    start_core({"--trace", reader.path()});
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    reader.stand();
    std::uint64_t tick = 0;
    ASSERT_TRUE(eventually([&] {
        const std::uint64_t before = std::exchange(tick, status().tick);
        std::this_thread::sleep_for(milliseconds{200});
        return tick == before && tick == status().tick;
    }));
    EXPECT_EQ(status().state, MachineState::carving);
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return status().state == MachineState::alarm; }, kHeardLimit));
    reader.go_on();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    EXPECT_EQ(status().trace_lost, 0U);
    std::this_thread::sleep_for(milliseconds{200});
    std::ofstream{file("taken.trace"), std::ios::binary} << reader.taken();
    auto trace = verify::open_trace(file("taken.trace"));
    ASSERT_TRUE(trace);
    std::array<verify::TraceEvent, 256> events{};
    for (;;) {
        const auto count = (*trace)->read(events);
        ASSERT_TRUE(count) << count.error().message;
        if (*count == 0) break;
    }
}

TEST_F(CoreOutlet, OnTheVirtualClockTwoOrdersEndACoreWhoseTraceNobodyReads) {
    StandingReader reader{file("standing.trace")};
    start_core({"--trace", reader.path()});
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    reader.stand();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    core_->send_signal(SIGTERM);
    std::this_thread::sleep_for(milliseconds{100});
    core_->send_signal(SIGTERM);
    EXPECT_TRUE(eventually([&] { return !segment_->core_pid(); }, kHeardLimit));
    if (segment_->core_pid()) core_->send_signal(SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

TEST_F(CoreOutlet, ASupervisorThatStandsStillIsAControlledStop) {
    take_enable_lines_away();
    start_core_that_can_be_held("PSICARVE_HELD_SUPERVISOR");
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    hold_it();
    EXPECT_TRUE(eventually([&] { return !is_spindle_on(); }, kHeardLimit));
    const std::uint64_t pulses = pulses_on_the_cable();
    std::this_thread::sleep_for(milliseconds{50});
    EXPECT_EQ(pulses_on_the_cable(), pulses);
    let_it_go();
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::supervisor_stalled) << name_of(status().alarm_cause);
    EXPECT_EQ(status().homed_mask, 0xF) << "it slowed down";
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    EXPECT_EQ(status().state, MachineState::ready);
}

TEST_F(CoreOutlet, ServesCommandsWhileAJobIsLookedAt) {
    start_core_that_can_be_held("PSICARVE_HELD_READ");
    home();
    ASSERT_EQ(publish(coarse_job(4)), "");
    hold_it();
    const auto generation = publish_job(*segment_, job_blob_from_table(coarse_job(40)));
    ASSERT_TRUE(generation);
    const std::uint64_t heartbeat = status().heartbeat;
    EXPECT_TRUE(eventually([&] { return status().heartbeat > heartbeat + 20; }, kHeardLimit));
    if (status().heartbeat > heartbeat + 20) {
        EXPECT_NE(refusal_of(CommandKind::start).find("is being looked at"), std::string::npos);
        EXPECT_EQ(refusal_of(CommandKind::spindle, 1.0), "");
        EXPECT_EQ(refusal_of(CommandKind::home), "");
    }
    let_it_go();
    EXPECT_TRUE(wait_for_acceptance(*segment_, *generation, kLimit));
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(status().job_generation, *generation);
    EXPECT_EQ(refusal_of(CommandKind::start), "");
}

// The disk that they are to be written to hangs.
TEST_F(CoreOutlet, AnEmergencyStopIsHeardWhileLayerTimesCannotBeWritten) {
    start_core_that_can_be_held("PSICARVE_HELD_WRITE", {"--layer-times", file("times.csv")});
    hold_it();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    EXPECT_EQ(text_of(file("times.csv")), "") << "it stands still";
    const std::uint64_t heartbeat = status().heartbeat;
    EXPECT_TRUE(eventually([&] { return status().heartbeat > heartbeat + 20; }, kHeardLimit));
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return status().state == MachineState::alarm; }, kHeardLimit));
    EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop) << name_of(status().alarm_cause);
    EXPECT_FALSE(is_spindle_on());
    // Once the disk answers they are written, of the job as it was planned.
    let_it_go();
    EXPECT_TRUE(eventually([&] { return text_of(file("times.csv")).starts_with("layer,seconds\n0,"); }));
    // Once more, and the reader never answers: it ends in order all the same.
    hold_it();
    ASSERT_EQ(publish(coarse_job(20)), "");
    core_->send_signal(SIGTERM);
    EXPECT_TRUE(eventually([&] { return has_ended(); }, kHeardLimit));
    if (!has_ended()) kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    expect_safe_registers();
}

TEST_F(CoreOutlet, AnEmergencyStopIsHeardWhileTheCheckpointCannotBeWritten) {
    start_core_that_can_be_held("PSICARVE_HELD_WRITE", {"--state", file("state")});
    const StateNames names{file("state"), segment_name_, false};
    hold_it();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    const auto next_layer = [this] {
        return read_record(segment_->header().checkpoint).value_or(Checkpoint{}).next_layer;
    };
    ASSERT_TRUE(eventually([&] { return next_layer() >= 1; })) << "the segment has it";
    EXPECT_FALSE(load_saved_checkpoint(names.checkpoint())) << "it stands still";
    const std::uint64_t heartbeat = status().heartbeat;
    EXPECT_TRUE(eventually([&] { return status().heartbeat > heartbeat + 20; }, kHeardLimit));
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return status().state == MachineState::alarm; }, kHeardLimit));
    EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop) << name_of(status().alarm_cause);
    EXPECT_FALSE(is_spindle_on());
    // Once the disk answers it is written, and the newest.
    let_it_go();
    EXPECT_TRUE(eventually([&] {
        const auto saved = load_saved_checkpoint(names.checkpoint());
        return saved && saved->checkpoint.next_layer == next_layer();
    }));
    EXPECT_FALSE(load_saved_checkpoint(names.checkpoint())->is_simulator);
    // Once more, and the reader never answers: it ends in order all the same.
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    home();
    hold_it();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    core_->send_signal(SIGTERM);
    EXPECT_TRUE(eventually([&] { return has_ended(); }, kHeardLimit));
    if (!has_ended()) kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    expect_safe_registers();
}

// The guard's words have nowhere to go, and the port does not answer.
TEST_F(CoreOutlet, AFullPipeOfWordsKeepsNoGuardFromSwitchingOff) {
    StandingReader reader{file("core.err")};
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    reader.stand_and_fill();
    fail_port(EIO, -1);
    kill(core_pid_, SIGKILL);
    ASSERT_TRUE(eventually([&] {
        return load_words<CoreStatus>(segment_->header().status.words).alarm_cause == AlarmCause::core_lost;
    }));
    std::this_thread::sleep_for(milliseconds{200});
    EXPECT_FALSE(is_safe());
    mend_port();
    EXPECT_TRUE(eventually([&] { return is_safe(); }, kHeardLimit));
    reader.go_on();
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
}

}  // namespace
}  // namespace psicarve::two_process
