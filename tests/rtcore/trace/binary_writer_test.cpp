// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/binary_writer.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "shared/trace/trace_format.hpp"
#include "tests/rtcore/trace/trace_files.hpp"

namespace psicarve::trace {
namespace {

using BinaryWriterTest = TraceFolder;

struct ReadTrace {
    TraceHeader header{};
    std::vector<TraceEntry> entries;
    std::optional<std::uint64_t> end_tick;  ///< nothing: it was cut off
};

/// A reader that follows docs/trace.md and nothing else.
ReadTrace read_trace(const std::string& bytes) {
    ReadTrace trace;
    std::memcpy(&trace.header, bytes.data(), sizeof trace.header);
    const auto* in = reinterpret_cast<const std::uint8_t*>(bytes.data()) + sizeof trace.header;
    const auto* const end = reinterpret_cast<const std::uint8_t*>(bytes.data()) + bytes.size();
    std::uint64_t tick = 0;
    SignalWord levels = trace.header.initial_levels;
    const auto number = [&] {
        std::uint64_t value = 0;
        if (in != nullptr) in = decode_leb128(in, end, value);
        return value;
    };
    while (in != nullptr && in != end) {
        const std::uint64_t head = number();
        tick += trace_record_ticks(head);
        const TraceRecordKind kind = trace_record_kind(head);
        if (kind == TraceRecordKind::end) {
            if (in == end) trace.end_tick = tick;
            return trace;
        }
        TraceEntry entry = pins(tick, 0);
        if (kind == TraceRecordKind::position) {
            entry.kind = TraceEntry::Kind::position;
            for (std::int64_t& value : entry.position_pulses) value = value_from_zigzag(number());
        } else {
            if (kind == TraceRecordKind::pins_with_offset)
                entry.offset_ns = static_cast<std::uint32_t>(number());
            entry.levels = levels ^= static_cast<SignalWord>(number());
        }
        if (in != nullptr) trace.entries.push_back(entry);
    }
    return trace;
}

void expect_same(const TraceEntry& read, const TraceEntry& written) {
    EXPECT_EQ(read.tick, written.tick);
    EXPECT_EQ(read.kind, written.kind);
    EXPECT_EQ(read.offset_ns, written.offset_ns);
    EXPECT_EQ(read.levels, written.levels);
    EXPECT_EQ(read.position_pulses, written.position_pulses);
}

TEST_F(BinaryWriterTest, PutsAJobBehindWhatHasHappened) {
    const std::string file = path("t.pct");
    std::vector<std::byte> blob(70'000, std::byte{7});  // more than one piece
    blob.back() = std::byte{9};
    {
        auto sut = open_trace(file, {.period_ns = 50'000, .levels = 0, .position_pulses = {}}).value();
        sut->add(pins(3, 0x1));
        sut->add_job({nullptr, blob, 0x0807060504030201});
        sut->add(pins(5, 0));
        sut->finish(6);
        EXPECT_FALSE(sut->take_error());
    }
    const std::string head = std::string("\x0C\x01", 2) + std::string("\0\0", 2) + "\xF0\xA2\x04" +  // 70 000
                             "\x01\x02\x03\x04\x05\x06\x07\x08";
    const std::string bytes = content(file).substr(64);
    ASSERT_EQ(bytes.size(), head.size() + blob.size() + 3);
    EXPECT_EQ(bytes.substr(0, head.size()), head);
    EXPECT_EQ(bytes.substr(head.size(), blob.size()), std::string(69'999, '\7') + '\x09');
    EXPECT_EQ(bytes.substr(head.size() + blob.size()), "\x08\x01\x07");
}

TEST_F(BinaryWriterTest, WritesTheBytesThatTheFormatSays) {
    const std::string file = path("t.pct");
    {
        auto sut =
            open_trace(file, {.period_ns = 50'000, .levels = 0x2000, .position_pulses = {1, -1, 64, 0}})
                .value();
        sut->add(pins(3, 0x2001));
        sut->add(pins(3, 0x2000, 200));
        sut->add(position(4, {0, -1, 64, 1}));
        sut->finish(36);
    }
    const std::string bytes = content(file);
    ASSERT_EQ(bytes.size(), 64U + 2 + 4 + 6 + 2);
    EXPECT_EQ(bytes.substr(0, 8), "PSCATRC1");
    EXPECT_EQ(bytes.substr(8, 8), std::string("\x02\0\0\0\0\x20\0\0", 8));
    EXPECT_EQ(bytes.substr(16, 8), std::string("\x50\xC3\0\0\0\0\0\0", 8));
    EXPECT_EQ(bytes.substr(24, 8), std::string("\x01\0\0\0\0\0\0\0", 8));
    EXPECT_EQ(bytes.substr(32, 8), std::string(8, '\xFF'));
    EXPECT_EQ(bytes.substr(64), std::string("\x0C\x01"                // 3 ticks on: r1_step changes
                                            "\x02\xC8\x01\x01"        // same tick, 200 ns: it changes again
                                            "\x05\0\x01\x80\x01\x02"  // a tick on: positions
                                            "\x83\x01",               // 32 ticks on: the end
                                            14));
}

TEST_F(BinaryWriterTest, TellsCrossedGapsBehindItsHeadAndIsOfAVersionOfItsOwnThen) {
    const std::string file = path("crossed.pct");
    {
        auto sut = open_trace(file, {.period_ns = 50'000, .crossed_pulses = {0, 40, 0, 1}}).value();
        sut->add(pins(3, 1));
        sut->finish(4);
    }
    const std::string bytes = content(file);
    ASSERT_EQ(bytes.size(), 64U + 32 + 2 + 1);
    EXPECT_EQ(bytes.substr(8, 4), std::string("\x03\0\0\0", 4));
    EXPECT_EQ(bytes.substr(64, 16), std::string("\0\0\0\0\0\0\0\0\x28\0\0\0\0\0\0\0", 16));
    EXPECT_EQ(bytes.substr(80, 16), std::string("\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0", 16));
    EXPECT_EQ(bytes.substr(96), "\x0C\x01\x07");
}

TEST_F(BinaryWriterTest, StoryComesBackWhole) {
    const std::string file = path("story.bin");
    std::vector<TraceEntry> written;
    {
        auto sut = open_trace(file, kStoryStart).value();
        tell_short_story([&](const TraceEntry& entry) {
            written.push_back(entry);
            sut->add(entry);
        });
        sut->finish(kStoryEndTick);
        EXPECT_FALSE(sut->take_error());
    }
    const ReadTrace read = read_trace(content(file));
    EXPECT_EQ(read.header.magic, kTraceMagic);
    EXPECT_EQ(read.header.initial_levels, kStoryStart.levels);
    EXPECT_EQ(read.header.position_pulses[2], -1'600);
    ASSERT_EQ(read.entries.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) expect_same(read.entries[i], written[i]);
    EXPECT_EQ(read.end_tick, kStoryEndTick);
}

TEST_F(BinaryWriterTest, RandomLifeComesBackWholeThroughManyBuffers) {
    std::mt19937 random(9);
    const std::string file = path("long.bin");
    std::vector<TraceEntry> written;
    std::uint64_t tick = 0;
    SignalWord levels = kStoryStart.levels;
    {
        auto sut = open_trace(file, kStoryStart).value();
        for (int i = 0; i < 200'000; ++i) {
            tick += random() % 5 == 0 ? random() % 1'000'000 : 1;
            if (random() % 100 == 0) {
                const auto far = static_cast<std::int64_t>((std::uint64_t{random()} << 30) ^ random());
                written.push_back(position(tick, {far, -far, 0, 1}));
            } else {
                levels ^= bit_of(static_cast<Signal>(random() % kSignalCount));
                written.push_back(pins(
                    tick, levels, random() % 3 == 0 ? static_cast<std::uint32_t>(random() % 50'000) : 0));
            }
            sut->add(written.back());
        }
        sut->finish(tick);
    }
    const ReadTrace read = read_trace(content(file));
    ASSERT_EQ(read.entries.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) expect_same(read.entries[i], written[i]);
    EXPECT_EQ(read.end_tick, tick);
}

TEST_F(BinaryWriterTest, WritesNothingForLevelsThatDidNotChange) {
    const std::string file = path("same.bin");
    {
        auto sut = open_trace(file, {.period_ns = 50'000, .levels = 5}).value();
        sut->add(pins(1, 5));
        sut->finish(1);
    }
    EXPECT_TRUE(read_trace(content(file)).entries.empty());
}

TEST_F(BinaryWriterTest, CutOffTraceHasNoEndWhereverItWasCut) {
    const std::string file = path("cut.bin");
    {
        auto sut = open_trace(file, kStoryStart).value();
        tell_short_story([&](const TraceEntry& entry) { sut->add(entry); });
        sut->finish(kStoryEndTick);
    }
    const std::string whole = content(file);
    ASSERT_TRUE(read_trace(whole).end_tick);
    for (std::size_t size = sizeof(TraceHeader); size < whole.size(); ++size) {
        EXPECT_FALSE(read_trace(whole.substr(0, size)).end_tick) << size;
    }
    const std::string unfinished = path("unfinished.bin");
    { open_trace(unfinished, kStoryStart).value()->add(pins(1, 0)); }
    EXPECT_EQ(read_trace(content(unfinished)).entries.size(), 1U);
    EXPECT_FALSE(read_trace(content(unfinished)).end_tick);
}

}  // namespace
}  // namespace psicarve::trace
