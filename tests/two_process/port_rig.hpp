// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/pin_map.hpp"
#include "tests/fake_port/fake_port_file.hpp"
#include "tests/two_process/core_rig.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::two_process {

/// Cores that drive /dev/parportN by ioctls, which a preloaded library answers.
class PortRig : public CoreRig {
protected:
    static constexpr std::uint32_t kEstopStatusBit = 0x08;

    PortRig() { write_profile(); }
    void write_profile(const std::string& name = "machine.toml") const {
        const std::string text = profile_to_toml(profile_);
        EXPECT_TRUE(write_file_atomically(file(name), std::as_bytes(std::span{text})));
    }

    static Profile machine_with_estop() {
        Profile profile = slow_machine();
        profile.port.pins[index_of(Signal::estop)] = 15;
        return profile;
    }
    void home_where_it_stands() {
        take_sensors_away(profile_);
        write_profile();
        port_.stand(profile_);
    }
    void home_by_one_sensor() {
        leave_one_sensor(profile_);
        write_profile();
        port_.stand(profile_);
    }
    /// No alarm switches these drives off: what it did to the positions can be seen.
    void take_enable_lines_away() {
        for (const Axis axis : kAllAxes) profile_.port.pins[index_of(enable_of(axis))] = 0;
        write_profile();
        port_.stand(profile_);
    }
    /// Layers a pulse apart.
    JobTable coarse_job(std::uint32_t layers) const {
        JobTable table = lobed_job(layers, 9, profile_);
        for (std::uint32_t layer = 0; layer < layers; ++layer) table.layer_height_pulses[layer] = 20 + layer;
        return table;
    }
    /// What the same job makes of the simulated port's pins, on the virtual clock.
    std::vector<fake_port::Pulse> pulses_of_the_simulated_run(const JobTable& table) {
        start_core({"--profile", file("machine.toml"), "--trace", file("virtual.trace")});
        home();
        EXPECT_EQ(publish(table), "");
        start_carving();
        EXPECT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        EXPECT_EQ(refusal_of(CommandKind::shutdown), "");
        EXPECT_EQ(core_->wait_for_exit(), 0);
        auto reader = verify::open_trace(file("virtual.trace"));
        if (!reader) return {};
        std::vector<std::uint32_t> levels;
        std::array<verify::TraceEvent, 256> events{};
        for (;;) {
            const auto count = (*reader)->read(events);
            if (!count || *count == 0) break;
            for (std::size_t i = 0; i < *count; ++i) levels.push_back(events[i].levels & kOutputMask);
        }
        return fake_port::pulses_with_spindle(levels);
    }
    std::vector<std::string> port_arguments(const std::string& segment_name) const {
        return {"--segment",
                segment_name,
                "--clock",
                "real",
                "--profile",
                file("machine.toml"),
                "--port",
                "ppdev:" + port_.device(),
                "--capacity",
                "100x20",
                "--allow-no-realtime"};
    }
    void start_port_core(const std::vector<std::string>& more = {}, bool leads_group = false) {
        core_.reset();
        segment_.reset();
        [[maybe_unused]] const auto removed = Segment::remove(segment_name_);
        {
            const fake_port::FakePortFile::Preload preload{port_};
            std::vector<std::string> arguments = port_arguments(segment_name_);
            arguments.insert(arguments.end(), more.begin(), more.end());
            core_ = std::make_unique<CoreProcess>(arguments, file("core.err"), leads_group);
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
    }
    ~PortRig() override {
        // A test that kills the guard leaves a core behind that waits for a hand.
        if (core_pid_ != 0 && segment_ != nullptr &&
            segment_->core_pid() == static_cast<std::uint32_t>(core_pid_))
            kill(core_pid_, SIGKILL);
    }

    /// The next access of the port's fails, and so many altogether (negative: every one from now on).
    void fail_port(int error, std::int64_t times) {
        port_.state().fault_errno.store(error);
        port_.state().faults.store(times);
        port_.state().accesses_to_fault.store(0);
    }
    void mend_port() {
        port_.state().accesses_to_fault.store(-1);
        port_.state().faults.store(0);
    }
    bool is_safe() {
        const OutputRegisters wanted = safe();
        return port_.state().data.load() == wanted.data && port_.state().control.load() == wanted.control;
    }
    OutputRegisters safe() const { return PinMap::from_profile(profile_)->encode(0); }
    void expect_safe_registers() {
        EXPECT_EQ(port_.state().data.load(), safe().data);
        EXPECT_EQ(port_.state().control.load(), safe().control);
    }
    void expect_safe_first_and_last() {
        const auto writes = port_.writes();
        ASSERT_GE(writes.size(), 4U);
        for (const std::size_t first : {std::size_t{0}, writes.size() - 2}) {
            EXPECT_EQ(writes[first].reg, fake_port::Register::data);
            EXPECT_EQ(writes[first].value, safe().data);
            EXPECT_EQ(writes[first + 1].reg, fake_port::Register::control);
            EXPECT_EQ(writes[first + 1].value, safe().control);
        }
    }
    /// From write number `count` (counted from 0) on no step edge, and the end is safe.
    void expect_safe_after(std::uint64_t count) {
        const auto writes = port_.writes();
        const auto levels = fake_port::levels_of(writes, profile_);
        std::vector<fake_port::Pulse> late;
        for (std::size_t i = count; i < levels.size(); ++i) {
            fake_port::add_pulses(levels[i - 1], levels[i], late);
        }
        EXPECT_EQ(late.size(), 0U);
        expect_safe_registers_but_directions();
    }
    void expect_safe_registers_but_directions() {
        const auto levels = fake_port::levels_of(port_.writes(), profile_);
        ASSERT_FALSE(levels.empty());
        // A drive without an enable line is always on.
        const SignalWord always_on = PinMap::from_profile(profile_)->outputs_from_registers(safe());
        EXPECT_EQ(levels.back() & ~kDirMask, always_on & kOutputMask & ~kDirMask);
    }
    std::uint64_t pulses_on_the_cable() {
        std::uint64_t sum = 0;
        for (const auto& axis : port_.state().axes) sum += axis.pulses.load();
        return sum;
    }

    pid_t core_pid_ = 0;  ///< of the core itself; core_ is its guard
    Profile profile_ = machine_with_estop();
    fake_port::FakePortFile port_{file(""), profile_};
};

}  // namespace psicarve::two_process
