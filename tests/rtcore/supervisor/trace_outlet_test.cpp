// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/trace_outlet.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/rtcore/trace/trace_files.hpp"

namespace psicarve::supervisor {
namespace {

using trace::TraceEntry;
using trace::TraceRing;

TraceEntry entry(TraceEntry::Kind kind, std::uint64_t tick, std::uint32_t token) {
    TraceEntry made{};
    made.kind = kind;
    made.tick = tick;
    made.token = token;
    return made;
}

class Recording : public trace::TraceFolder {
protected:
    void open(const std::vector<std::string>& paths) {
        ASSERT_TRUE(sut_.open(paths, start_));
        sut_.set_recording_taker([this](std::uint32_t token, std::span<const std::uint8_t> bytes) {
            tokens_.push_back(token);
            taken_.append(bytes.begin(), bytes.end());
            has_ended_ = bytes.empty();
        });
    }
    void pass(const TraceEntry& one) {
        ring_->push(one);
        sut_.drain(*ring_);
    }
    /// What a trace file of the same story holds.
    std::string story_in_file(const std::string& name) {
        TraceOutlet outlet;
        EXPECT_TRUE(outlet.open({path(name)}, start_));
        trace::tell_short_story([&](const TraceEntry& one) {
            ring_->push(one);
            outlet.drain(*ring_);
        });
        outlet.finish(1000);
        return content(path(name));
    }
    std::unique_ptr<TraceRing> ring_ = std::make_unique<TraceRing>();
    trace::TraceStart start_{50'000, 0, {}};
    std::vector<std::uint32_t> tokens_;
    std::string taken_;
    bool has_ended_ = false;
    TraceOutlet sut_;
};

TEST_F(Recording, IsTheTraceOfAFileThatBeganAtItsTick) {
    constexpr std::uint64_t kBegin = 123'456;
    for (const auto& [kind, name] : {std::pair{TraceEntry::Kind::begin_binary, "a.trace"},
                                     std::pair{TraceEntry::Kind::begin_vcd, "a.vcd"}}) {
        taken_.clear();
        has_ended_ = false;
        open({});
        pass(entry(kind, kBegin, 5));
        trace::tell_short_story([&](TraceEntry one) {
            one.tick += kBegin;
            pass(one);
        });
        EXPECT_FALSE(has_ended_);
        pass(entry(TraceEntry::Kind::end, kBegin + 1000, 5));
        EXPECT_TRUE(has_ended_);
        EXPECT_EQ(taken_, story_in_file(name)) << name;
        EXPECT_EQ(tokens_.back(), 5U);
    }
}

TEST_F(Recording, LeavesTraceFilesAsTheyWouldBeWithoutIt) {
    open({path("with.trace")});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    trace::tell_short_story([&](const TraceEntry& one) { pass(one); });
    pass(entry(TraceEntry::Kind::end, 900, 5));
    sut_.finish(1000);
    EXPECT_EQ(content(path("with.trace")), story_in_file("without.trace"));
}

TEST_F(Recording, EndsWithTheCore) {
    open({});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    sut_.finish(10);
    EXPECT_TRUE(has_ended_);
}

TEST_F(Recording, ThatIsDroppedSaysNothingMore) {
    open({});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    sut_.drop_recording();
    pass(entry(TraceEntry::Kind::end, 10, 5));
    sut_.finish(20);
    EXPECT_EQ(taken_, "");
    EXPECT_TRUE(tokens_.empty());
}

}  // namespace
}  // namespace psicarve::supervisor
