// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "shared/machine/recording.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

using trace::TraceEntry;
using trace::TraceRing;
using Kind = TraceEntry::Kind;

/// A machine whose pins nobody traces unless asked to.
class Recording : public testing::Test {
protected:
    Recording() {
        rig_.io->trace = ring_.get();
        rig_.io->traces_always = false;
    }
    Refusal record(RecordingForm form, std::uint32_t token) {
        Request request{};
        request.kind = RequestKind::record;
        request.value = static_cast<std::uint64_t>(form);
        request.lease_token = token;
        return rig_.ask(request);
    }
    std::vector<TraceEntry> entries() {
        std::vector<TraceEntry> all;
        for (TraceEntry entry; ring_->pop_into(entry);) all.push_back(entry);
        return all;
    }
    MachineRig rig_{quick_profile()};
    std::unique_ptr<TraceRing> ring_ = std::make_unique<TraceRing>();
};

TEST_F(Recording, BeginsWithLevelsAndPositionsAndHoldsEveryPulseFromThere) {
    ASSERT_TRUE(rig_.home());
    EXPECT_TRUE(entries().empty()) << "not asked for yet";
    const Positions before = rig_.positions();
    ASSERT_EQ(record(RecordingForm::binary, 9), Refusal::none);
    const auto begin = entries();
    ASSERT_GE(begin.size(), 1U);
    EXPECT_EQ(begin[0].kind, Kind::begin_binary);
    EXPECT_EQ(begin[0].token, 9U);
    EXPECT_EQ(begin[0].position_pulses, before);
    EXPECT_EQ(begin[0].levels & kEnableMask, kEnableMask);

    PinCounter pins{before};
    pins.take(begin[0].levels);
    rig_.load(random_job(2, 10, 3));
    ASSERT_EQ(rig_.ask(RequestKind::start), Refusal::none);
    ASSERT_TRUE(rig_.run_while([&] {
        for (const TraceEntry& entry : entries()) {
            if (entry.kind == Kind::pins) pins.take(entry.levels);
        }
        return rig_.cycle->state() != MachineState::waiting;
    }));
    EXPECT_EQ(pins.positions()[0], rig_.positions()[0]);
    EXPECT_EQ(pins.positions()[1], rig_.positions()[1]);
    EXPECT_EQ(pins.positions()[3], rig_.positions()[3]);
}

TEST_F(Recording, EndsForItsReaderOrForTheSupervisorAndForNobodyElse) {
    ASSERT_TRUE(rig_.home());
    ASSERT_EQ(record(RecordingForm::vcd, 9), Refusal::none);
    EXPECT_EQ(record(RecordingForm::binary, 10), Refusal::recording);
    EXPECT_EQ(record(RecordingForm::none, 10), Refusal::recording);
    EXPECT_EQ(record(RecordingForm::none, 9), Refusal::none);
    EXPECT_EQ(entries().back().kind, Kind::end);
    EXPECT_EQ(record(RecordingForm::binary, 10), Refusal::none);
    EXPECT_EQ(record(RecordingForm::none, 0), Refusal::none);
    EXPECT_EQ(record(RecordingForm::none, 11), Refusal::none) << "over and over";
    entries();
    rig_.home();
    EXPECT_TRUE(entries().empty());
}

TEST_F(Recording, BeginsAtRestOnly) {
    ASSERT_TRUE(rig_.prepare(random_job(2, 10, 3)));
    EXPECT_EQ(record(RecordingForm::binary, 9), Refusal::not_in_this_state);
    ASSERT_EQ(rig_.ask(RequestKind::start_interpolation), Refusal::none);
    EXPECT_EQ(record(RecordingForm::binary, 9), Refusal::not_in_this_state);
    EXPECT_TRUE(entries().empty());
}

TEST_F(Recording, IsNoPartOfWhatTheMachineDid) {
    ASSERT_TRUE(rig_.home());
    const std::size_t before = rig_.records_of(RecordKind::command).size();
    ASSERT_EQ(record(RecordingForm::binary, 9), Refusal::none);
    ASSERT_EQ(record(RecordingForm::none, 9), Refusal::none);
    EXPECT_EQ(rig_.records_of(RecordKind::command).size(), before);
}

TEST_F(Recording, WithoutARingForItIsRefused) {
    rig_.io->trace = nullptr;
    EXPECT_EQ(record(RecordingForm::binary, 9), Refusal::recording);
}

}  // namespace
}  // namespace psicarve::cycle
