// SPDX-License-Identifier: GPL-3.0-or-later
// Which text a program is of, as any process reads it out of the segment.
#include "shared/machine/program_origin.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "shared/segment/segment_program.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

class OriginInSegment : public test::SegmentOfTwo {};

TEST_F(OriginInSegment, TheReportTellsWhichTextTheProgramAtTheMachineIsOf) {
    ASSERT_TRUE(core_->claim_core());
    ProgramDesk desk{*core_};
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    // The core answers as the writer waits for it.
    std::thread core{[&] {
        while (!desk.open()) std::this_thread::yield();
    }};
    const auto begun = writer.begin(std::chrono::milliseconds{60'000});
    core.join();
    ASSERT_TRUE(begun);
    EXPECT_FALSE(program_report(*hmi_).origin) << "its writer has told nothing";
    auto source = std::make_unique<ProgramSource>();
    source->from_line = 12;
    source->flags = kSourceIsDry | kSourceSkipsDeleted;
    const auto told = [&](const std::string& name) {
        std::memset(static_cast<char*>(source->name), 0, sizeof source->name);
        name.copy(static_cast<char*>(source->name), sizeof source->name);
        writer.tell(*source);
        return program_report(*hmi_).origin;
    };
    EXPECT_FALSE(told("a")) << "the machine is at no program yet";
    ProgramStatus status{};
    status.program = writer.program();
    desk.tell(status);
    // As many bytes as there are, and as a writer that cares for nothing may leave them.
    for (const std::size_t bytes : {std::size_t{1}, kSourceNameBytes - 1, kSourceNameBytes}) {
        const std::string name(bytes, '\xC3');
        const auto origin = told(name);
        ASSERT_TRUE(origin) << bytes;
        EXPECT_EQ(std::string(static_cast<const char*>(origin->name), bytes), name);
        EXPECT_EQ(origin->from_line, 12U);
        EXPECT_EQ(origin->flags, kSourceIsDry | kSourceSkipsDeleted);
    }
    status.program += 1;
    desk.tell(status);
    EXPECT_FALSE(program_report(*hmi_).origin) << "that of another program";
    status.program -= 1;
    desk.tell(status);
    EXPECT_TRUE(program_report(*hmi_).origin);
    core_->header().program.source.sequence.fetch_or(1U);
    EXPECT_FALSE(program_report(*hmi_).origin) << "its writer died within it";
}

}  // namespace
}  // namespace psicarve
