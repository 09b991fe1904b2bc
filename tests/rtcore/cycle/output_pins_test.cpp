// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/output_pins.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace psicarve::cycle {
namespace {

class PinPort final : public port::Port {
public:
    SignalWord read_inputs(std::int64_t /*time_ns*/) noexcept override { return 0; }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        writes.emplace_back(levels, time_ns);
    }
    void wait(std::int64_t /*width_ns*/) noexcept override {}
    bool is_healthy() const noexcept override { return false; }
    void try_safe_state() noexcept override { ++tries; }
    bool is_silent() const noexcept override { return is_quiet; }

    std::vector<std::pair<SignalWord, std::int64_t>> writes;
    int tries = 0;
    bool is_quiet = false;
};

constexpr SignalWord kSpindle = bit_of(Signal::spindle);

TEST(OutputPins, AreSafeFromTheBeginning) {
    PinPort port;
    const OutputPins sut(port);
    ASSERT_EQ(port.writes.size(), 1U);
    EXPECT_EQ(port.writes[0], std::pair(SignalWord{0}, std::int64_t{0}));
    EXPECT_FALSE(sut.differ_from(0));
    EXPECT_TRUE(sut.differ_from(kSpindle));
}

TEST(OutputPins, ShowTheChargePumpBesideTheLevelsAndNotAmongThem) {
    PinPort port;
    OutputPins sut(port);
    sut.toggle_charge_pump();
    EXPECT_TRUE(sut.differ_from(0));
    sut.write(kSpindle, 100);
    EXPECT_EQ(port.writes.back(), std::pair(kSpindle | kChargePumpBit, std::int64_t{100}));
    EXPECT_EQ(sut.levels(), kSpindle);
    EXPECT_FALSE(sut.differ_from(kSpindle));
    sut.toggle_charge_pump();
    sut.write(kSpindle, 200);
    EXPECT_EQ(port.writes.back().first, kSpindle);
    sut.toggle_charge_pump();
    sut.rest_charge_pump();
    EXPECT_FALSE(sut.differ_from(kSpindle));
}

TEST(OutputPins, EndPulsesAndLeaveAllElse) {
    PinPort port;
    OutputPins sut(port);
    sut.toggle_charge_pump();
    sut.write(kSpindle | kStepMask, 100);
    sut.end_pulses(150);
    EXPECT_EQ(port.writes.back(), std::pair(kSpindle | kChargePumpBit, std::int64_t{150}));
    EXPECT_EQ(sut.levels(), kSpindle);
}

TEST(OutputPins, TellWhenThePortFallsSilentAndWhenItAnswersAgain) {
    PinPort port;
    OutputPins sut(port);
    EXPECT_FALSE(sut.try_safe_state());
    port.is_quiet = true;
    EXPECT_TRUE(sut.try_safe_state());
    EXPECT_FALSE(sut.try_safe_state());
    port.is_quiet = false;
    EXPECT_TRUE(sut.try_safe_state());
    EXPECT_EQ(port.tries, 4);
}

}  // namespace
}  // namespace psicarve::cycle
