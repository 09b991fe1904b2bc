// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/shared/record_fixture.hpp"
#include "tests/two_process/child_process.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {

/// A core on the virtual clock, homed, that is given programs, and what comes of them.
class ProgramProof : public Machine {
protected:
    void start_homed(const std::vector<std::string>& more = {}) {
        start_core(more);
        ASSERT_EQ(run({"home"}).exit_code, 0);
        segment_view_.emplace(Segment::attach(segment_).value());
    }
    void end_core() {
        segment_view_.reset();
        core_->send(SIGTERM);
        core_->wait();
    }
    std::unique_ptr<RunningProgram> begin(const std::string& text) const {
        write("program.ngc", text);
        return std::make_unique<RunningProgram>(
            "psicarve", std::vector<std::string>{"gcode", "run", file("program.ngc"), "--segment", segment_});
    }
    CoreStatus status() {
        std::optional<CoreStatus> read;
        eventually([&] {
            read = read_record(segment_view_->header().status);
            return read.has_value();
        });
        return read.value_or(CoreStatus{});
    }
    ProgramStatus program_status() const { return program_report(*segment_view_).status; }
    /// Whether the core did it.
    bool command(CommandKind kind, double value = 0.0) {
        Command asked{};
        asked.kind = kind;
        asked.value = value;
        return send_command(*segment_view_, asked, milliseconds{60'000}).has_value();
    }
    /// Runs the program with that number from where the machine stands.
    bool run_numbered(std::uint64_t program) {
        Command asked{};
        asked.kind = CommandKind::program;
        asked.value2 = program;
        const CoreStatus now = status();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            asked.target[k] = static_cast<double>(now.position_pulses[k]);
        return send_command(*segment_view_, asked, milliseconds{60'000}).has_value();
    }
    /// Which axes stepped together, and which way, in order.
    static std::vector<std::uint8_t> order_of_trace(const std::string& path) {
        std::vector<std::uint8_t> order;
        auto reader = verify::open_trace(path);
        EXPECT_TRUE(reader) << path;
        std::array<verify::TraceEvent, 4096> events{};
        SignalWord before = 0;
        for (;;) {
            const auto count = reader ? (*reader)->read(events) : Result<std::size_t>{std::size_t{0}};
            if (!count || *count == 0) return order;
            for (std::size_t i = 0; i < *count; ++i) {
                if (events[i].kind != verify::TraceEvent::Kind::pins) continue;
                const SignalWord levels = events[i].levels;
                std::uint8_t step = 0;
                for (const Axis axis : kAllAxes) {
                    if ((levels & ~before & bit_of(step_of(axis))) == 0) continue;
                    const unsigned way = (levels & bit_of(dir_of(axis))) != 0 ? 2U : 1U;
                    step = static_cast<std::uint8_t>(step | way << (2U * index_of(axis)));
                }
                if (step != 0) order.push_back(step);
                before = levels;
            }
        }
    }
    /// Many short ways along a curve on which nothing asks for a rest.
    static std::string dense_program(int lines) {
        std::string text = "G21 G90 G94 F600\nG0 X50 Z50 Y10 C0\n";
        for (int i = 0; i < lines; ++i) {
            std::array<char, 96> line{};
            std::snprintf(line.data(), line.size(), "G1 X%.4f Y%.4f C%.2f\n", 48.0 + 2.0 * std::cos(0.02 * i),
                          10.0 + 2.0 * std::sin(0.02 * i), 0.1 * i);
            text += line.data();
        }
        return text + "M2\n";
    }

    std::optional<Segment> segment_view_;
};

}  // namespace psicarve::test
