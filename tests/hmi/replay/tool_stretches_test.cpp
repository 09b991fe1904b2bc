// SPDX-License-Identifier: GPL-3.0-or-later
// What a tool leaves where it was lifted in between, and where there are more places than are kept.
#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "hmi/replay/tool_timeline.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::replay {
namespace {

constexpr double kDeep_mm = 8.0;
constexpr double kHeight_mm = 1.5;
constexpr std::int64_t kTick_ns = 50'000;

class ToolStretches : public two_process::CoreRig {
protected:
    ToolStretches() {
        profile_.tool = {ToolShape::ball, 3.0};
        auto made = cam::prepare_blob(job_blob_from_table(two_process::lobed_job(40, 61, profile_)), profile_,
                                      "lobed");
        EXPECT_TRUE(made);
        job_ = std::make_shared<const cam::PreparedJob>(std::move(*made));
        start_.period_ns = kTick_ns;
        for (const Axis axis : kAllAxes) start_.initial_levels |= bit_of(enable_of(axis));
        start_anew();
        start_.position_pulses[index_of(Axis::r1)] = radius_pulses(kDeep_mm);
        start_.position_pulses[index_of(Axis::r2)] = radius_pulses(kDeep_mm);
        start_.position_pulses[index_of(Axis::y)] = pulses_from_mm(kHeight_mm, profile_.y.pulses_per_mm);
    }
    void start_anew() {
        events_.clear();
        levels_ = start_.initial_levels;
        ticks_ = 0;
    }
    std::int64_t radius_pulses(double mm) const { return pulses_from_mm(mm, profile_.r1.pulses_per_mm); }
    std::int64_t cells(int count) const { return profile_.psi.pulses_per_rev / 480 * count; }

    void become(SignalWord levels) {
        if (levels == levels_) return;
        levels_ = levels;
        events_.push_back({++ticks_ * kTick_ns, levels, verify::TraceEvent::Kind::pins, {}});
    }
    void spindle(bool is_on) {
        const SignalWord bit = bit_of(Signal::spindle);
        become(is_on ? levels_ | bit : levels_ & ~bit);
    }
    void step(SignalWord axes, SignalWord directions, std::int64_t pulses) {
        become((levels_ & ~kDirMask) | (pulses > 0 ? directions : 0));
        for (std::int64_t i = std::abs(pulses); i > 0; --i) {
            become(levels_ | axes);
            become(levels_ & ~axes);
        }
    }
    void turn(std::int64_t pulses) { step(bit_of(step_of(Axis::psi)), bit_of(dir_of(Axis::psi)), pulses); }
    void rise(double mm) {
        step(bit_of(step_of(Axis::y)), bit_of(dir_of(Axis::y)), pulses_from_mm(mm, profile_.y.pulses_per_mm));
    }
    void draw_out(double mm) {
        step(bit_of(step_of(Axis::r1)) | bit_of(step_of(Axis::r2)),
             bit_of(dir_of(Axis::r1)) | bit_of(dir_of(Axis::r2)), radius_pulses(mm));
    }
    /// The timeline of all that happened so far.
    std::shared_ptr<const ToolTimeline> timeline(std::size_t most_places = ToolTimeline::kMostPlaces) {
        std::ofstream(file("made.trace"), std::ios::binary) << verify::as_binary(start_, events_);
        auto index = TraceIndex::build(file("made.trace"), profile_, {});
        EXPECT_TRUE(index);
        EXPECT_EQ((*index)->damage(), "");
        auto made = ToolTimeline::of_trace(job_, *index, {}, most_places);
        EXPECT_TRUE(made);
        return *made;
    }
    double removed_mm3(const std::shared_ptr<const ToolTimeline>& timeline) const {
        PieceInTime piece{timeline};
        EXPECT_TRUE(piece.go(ticks_ * kTick_ns, timeline->place_count()));
        return piece.stock().removed_mm3();
    }
    double removed_mm3(std::size_t most_places = ToolTimeline::kMostPlaces) {
        return removed_mm3(timeline(most_places));
    }

    Profile profile_;
    std::shared_ptr<const cam::PreparedJob> job_;
    verify::TraceStart start_;
    std::vector<verify::TraceEvent> events_;
    SignalWord levels_ = 0;
    std::int64_t ticks_ = 0;
};

TEST_F(ToolStretches, NothingIsCutOnTheWayFromWhereTheSpindleWentOff) {
    spindle(true);
    turn(cells(20));
    spindle(false);
    const double first_mm3 = removed_mm3();
    EXPECT_GT(first_mm3, 1.0);
    // Taken out and away, as after an alarm deep in the material.
    draw_out(6.0);
    turn(cells(150));
    rise(0.5);
    spindle(true);
    turn(cells(2));
    spindle(false);
    EXPECT_EQ(removed_mm3(), first_mm3);
}

TEST_F(ToolStretches, NothingIsCutOnAWayOutsideTheBlank) {
    const auto two_places_mm3 = [this](bool is_off_between) {
        start_anew();
        spindle(true);
        turn(cells(20));
        draw_out(6.0);
        spindle(!is_off_between);
        turn(cells(150));
        spindle(true);
        draw_out(-4.0);
        spindle(false);
        return removed_mm3();
    };
    const double apart_mm3 = two_places_mm3(true);
    EXPECT_NEAR(two_places_mm3(false), apart_mm3, 1e-3 * apart_mm3);
}

TEST_F(ToolStretches, EachIsCutToItsEndWhenPlacesAreLeftOut) {
    for (int stretch = 0; stretch < 6; ++stretch) {
        SCOPED_TRACE(stretch);
        spindle(true);
        turn(cells(41 + 6 * stretch));
        const double all_mm3 = removed_mm3();
        const auto thin = timeline(24);
        EXPECT_LE(thin->place_count(), 24U);
        EXPECT_NEAR(removed_mm3(thin), all_mm3, 2e-3 * all_mm3) << "while the spindle is on";
        spindle(false);
        draw_out(6.0);
        turn(-cells(30));
        draw_out(-6.0);
        rise(0.3);
        EXPECT_NEAR(removed_mm3(24), all_mm3, 2e-3 * all_mm3);
    }
}

TEST_F(ToolStretches, AsManyAsThereAreTakeNoMoreMemory) {
    draw_out(3.0);
    for (int stretch = 0; stretch < 300; ++stretch) {
        spindle(true);
        spindle(false);
        turn(cells(1));
    }
    EXPECT_EQ(timeline()->place_count(), 300U);
    const auto thin = timeline(40);
    EXPECT_LE(thin->place_count(), 40U);
    EXPECT_GE(thin->place_count(), 10U);
    EXPECT_GT(removed_mm3(thin), 0.0);
    EXPECT_LT(removed_mm3(thin), removed_mm3());
}

TEST_F(ToolStretches, APieceOnItsWayStopsAtAnyPlace) {
    spindle(true);
    turn(cells(100));
    const auto all = timeline();
    const std::int64_t end_ns = ticks_ * kTick_ns;
    PieceInTime sut{all};
    int asked = 0;
    EXPECT_FALSE(sut.go(end_ns, all->place_count(), [&] { return ++asked <= 30; }));
    EXPECT_EQ(sut.place_count(), 30U);
    EXPECT_TRUE(sut.go(end_ns, all->place_count()));
    EXPECT_EQ(sut.place_count(), all->place_count());
    EXPECT_EQ(sut.stock().removed_mm3(), removed_mm3(all));
}

}  // namespace
}  // namespace psicarve::replay
