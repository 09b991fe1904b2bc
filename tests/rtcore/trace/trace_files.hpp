// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "rtcore/trace/trace_entry.hpp"
#include "rtcore/trace/trace_writer.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::trace {

/// A folder of its own for one test.
class TraceFolder : public testing::Test {
protected:
    TraceFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "psicarve_trace_XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
    }
    ~TraceFolder() override { std::filesystem::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    static std::string content(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    std::filesystem::path folder_;
};

inline TraceEntry pins(std::uint64_t tick, SignalWord levels, std::uint32_t offset_ns = 0) {
    return {.tick = tick,
            .levels = levels,
            .kind = TraceEntry::Kind::pins,
            .offset_ns = offset_ns,
            .token = 0,
            .position_pulses = {},
            .crossed_pulses = {}};
}
inline TraceEntry position(std::uint64_t tick, std::array<std::int64_t, kAxisCount> pulses) {
    return {.tick = tick,
            .levels = 0,
            .kind = TraceEntry::Kind::position,
            .offset_ns = 0,
            .token = 0,
            .position_pulses = pulses,
            .crossed_pulses = {}};
}

/// A short life of a machine: drives on, a pulse each way, homing, pulses with an offset, an input, the end.
template <typename Sink>
void tell_short_story(Sink&& add) {
    constexpr SignalWord kOn = kEnableMask | bit_of(Signal::r1_dir);
    add(pins(0, kOn));
    add(pins(2, kOn | bit_of(Signal::r1_step)));
    add(pins(3, kOn));
    add(pins(4, kOn | bit_of(Signal::psi_dir)));
    add(pins(5, kOn | bit_of(Signal::psi_dir) | bit_of(Signal::psi_step)));
    add(pins(5, kOn | bit_of(Signal::psi_dir), 12'500));
    add(position(7, {24'000, 23'999, 0, -3}));
    add(pins(7, kOn | bit_of(Signal::r1_limit)));
    add(pins(1'000'000, kOn | bit_of(Signal::r1_limit) | bit_of(Signal::spindle)));
    add(pins(1'000'001, bit_of(Signal::estop)));
}
inline constexpr std::uint64_t kStoryEndTick = 1'000'010;
inline constexpr TraceStart kStoryStart{.period_ns = 50'000,
                                        .levels = bit_of(Signal::y_limit),
                                        .position_pulses = {12'000, 12'000, -1'600, 2'000}};

}  // namespace psicarve::trace
