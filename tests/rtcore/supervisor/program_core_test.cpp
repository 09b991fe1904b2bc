// SPDX-License-Identifier: GPL-3.0-or-later
// A core on the virtual clock runs programs whose records come from a script.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "rtcore/supervisor/run_loops.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace psicarve::supervisor {
namespace {

using namespace std::chrono_literals;
using plan::Supply;
using plan::test::Script;
using plan::test::ScriptedSource;

constexpr std::uint64_t kNumber = 5;

SegmentOptions program_segment() {
    SegmentOptions options;
    options.name = "/psicarve-program-core-" + std::to_string(getpid());
    options.capacity_layers = 4;
    options.capacity_points = 8;
    return options;
}

Profile program_core_profile() {
    Profile profile;
    profile.job.spindle_spinup_s = 0.01;
    return profile;
}

/// A core in a thread of its own, homed.
class ProgramCore {
public:
    explicit ProgramCore(bool has_programs = true) {
        auto served = Segment::create_or_attach(program_segment());
        EXPECT_TRUE(served && served->take_core_lock());
        CoreOptions options;
        options.segment_name = program_segment().name;
        options.clock = ClockKind::virtual_time;
        PartsRequest request;
        request.machine = program_core_profile();
        auto parts = build_core(options, program_core_profile(), std::move(request));
        EXPECT_TRUE(parts);
        parts_ = std::move(*parts);
        const CoreFacts facts{.period_ns = parts_->period_ns,
                              .is_simulator = true,
                              .is_virtual_clock = true,
                              .missing_sensors_mask = 0};
        supervisor_ = std::make_unique<Supervisor>(*parts_, program_segment(), std::move(*served), facts);
        if (has_programs) supervisor_->set_program_access(access());
        supervisor_->segment().sign_core();
        thread_ = std::thread([this] {
            EndRequest end;
            run_on_virtual_clock(*parts_, *supervisor_, {}, end);
            supervisor_->leave();
        });
        auto attached = Segment::attach(program_segment().name);
        EXPECT_TRUE(attached);
        segment_ = std::make_unique<Segment>(std::move(*attached));
        EXPECT_TRUE(send(CommandKind::home));
        EXPECT_TRUE(wait_for([&] { return status().state == MachineState::ready; }));
    }
    ~ProgramCore() {
        // Whatever a test has left: a core that moves does not end.
        request_stop(*segment_);
        EXPECT_TRUE(wait_for([&] { return status().state == MachineState::ready; }));
        EXPECT_TRUE(send(CommandKind::shutdown));
        thread_.join();
        segment_.reset();
        EXPECT_TRUE(Segment::remove(program_segment().name));
    }
    ProgramCore(const ProgramCore&) = delete;
    ProgramCore& operator=(const ProgramCore&) = delete;

    bool send(CommandKind kind, std::uint64_t value2 = 0) {
        Command command{};
        command.kind = kind;
        command.value2 = value2;
        for (std::size_t k = 0; k < kAxisCount; ++k) command.target[k] = static_cast<double>(positions()[k]);
        return send_command(*segment_, command, 60s).has_value();
    }
    CoreStatus status() const {
        auto read = read_record(segment_->header().status);
        while (!read) read = read_record(segment_->header().status);
        return *read;
    }
    template <typename Condition>
    bool wait_for(Condition&& condition) const {
        for (int n = 0; n < 60'000 && !condition(); ++n) std::this_thread::sleep_for(1ms);
        return condition();
    }
    /// Rounds of the core go by.
    void let_rounds_pass() const {
        const std::uint64_t before = status().heartbeat;
        EXPECT_TRUE(wait_for([&] { return status().heartbeat > before + 8; }));
    }
    Segment& segment() { return *segment_; }
    plan::Pulses4 positions() const {
        plan::Pulses4 at{};
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] = status().position_pulses[k];
        return at;
    }

    /// Of program kNumber.
    std::shared_ptr<ScriptedSource> give(const Script& script, std::size_t written) {
        const std::lock_guard<std::mutex> lock(mutex_);
        source_ = std::make_shared<ScriptedSource>(script.steps);
        source_->written = written;
        return source_;
    }

    std::atomic<std::uint64_t> line{0};
    std::atomic<std::uint64_t> starvations{0};
    std::atomic<bool> is_running{false};

private:
    ProgramAccess access() {
        ProgramAccess programs;
        programs.open = [this](std::uint64_t number) -> Result<std::shared_ptr<plan::StepSource>> {
            if (number != kNumber) return Error{ErrorCode::machine_refused, "no such program"};
            const std::lock_guard<std::mutex> lock(mutex_);
            return std::shared_ptr<plan::StepSource>{source_};
        };
        programs.serve = [this](const std::shared_ptr<Segment>&, const ProgramStatus& now) {
            line = now.line;
            starvations = now.starvations;
            is_running = now.is_running != 0;
        };
        return programs;
    }

    std::mutex mutex_;  ///< the core sees the segment elsewhere: nothing of it orders the two threads
    std::shared_ptr<ScriptedSource> source_;
    std::unique_ptr<CoreParts> parts_;
    std::unique_ptr<Supervisor> supervisor_;
    std::thread thread_;
    std::unique_ptr<Segment> segment_;
};

Script in_three_parts(const plan::Pulses4& from) {
    Script script{from};
    script.spindle(true).way({-300, -200, 0, 100}, 0.0, 0.05).dwell(0.02);
    script.way({0, 100, 200, 0}, 0.01).way({100, 0, 200, -20}, 0.01).end();
    return script;
}

/// Ticks that the whole of it takes, when so many of its steps have come first.
std::uint64_t ticks_with_pause(std::size_t written) {
    ProgramCore sut;
    const Script script = in_three_parts(sut.positions());
    const auto source = sut.give(script, written);
    const std::uint64_t before = sut.status().tick;
    EXPECT_TRUE(sut.send(CommandKind::program, kNumber));
    if (written < script.steps.size()) {
        sut.let_rounds_pass();
        EXPECT_TRUE(sut.is_running);
        EXPECT_EQ(sut.status().state, MachineState::carving);
        source->written = script.steps.size();
    }
    EXPECT_TRUE(sut.wait_for([&] { return sut.status().state == MachineState::ready; }));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.starvations, 0U);
    EXPECT_EQ(sut.line, 6U);
    return sut.status().tick - before;
}

// Wall time decides about no tick: not about when a program starves, either.
TEST(ProgramCore, OnTheVirtualClockTakesTheSameTicksHoweverItsWriterPauses) {
    const std::uint64_t plain = ticks_with_pause(6);
    for (const std::size_t written :
         {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{5}})
        EXPECT_EQ(ticks_with_pause(written), plain) << written;
}

TEST(ProgramCore, StopsWhileItsWriterIsSilent) {
    ProgramCore sut;
    sut.give(in_three_parts(sut.positions()), 2);
    ASSERT_TRUE(sut.send(CommandKind::program, kNumber));
    ASSERT_TRUE(sut.wait_for([&] { return sut.line == 2U; }));
    sut.let_rounds_pass();
    request_stop(sut.segment());
    ASSERT_TRUE(sut.wait_for([&] { return sut.status().state == MachineState::ready; }));
    EXPECT_FALSE(sut.is_running);
    EXPECT_EQ(sut.status().signals & bit_of(Signal::spindle), 0U);
}

TEST(ProgramCore, HoldsAndResumesWhileItsWriterIsSilent) {
    ProgramCore sut;
    const Script script = in_three_parts(sut.positions());
    const auto source = sut.give(script, 2);
    ASSERT_TRUE(sut.send(CommandKind::program, kNumber));
    ASSERT_TRUE(sut.wait_for([&] { return sut.line == 2U; }));
    ASSERT_TRUE(sut.send(CommandKind::hold));
    ASSERT_TRUE(sut.wait_for([&] { return sut.status().state == MachineState::held; }));
    source->written = script.steps.size();
    sut.let_rounds_pass();
    EXPECT_EQ(sut.status().state, MachineState::held);
    ASSERT_TRUE(sut.send(CommandKind::resume));
    ASSERT_TRUE(sut.wait_for([&] { return sut.status().state == MachineState::ready; }));
    EXPECT_EQ(sut.positions(), script.at());
}

TEST(ProgramCore, RefusesAProgramThatNobodyGave) {
    ProgramCore sut;
    EXPECT_FALSE(sut.send(CommandKind::program, kNumber + 1));
    EXPECT_EQ(sut.status().state, MachineState::ready);
    EXPECT_FALSE(sut.is_running);
}

}  // namespace
}  // namespace psicarve::supervisor
