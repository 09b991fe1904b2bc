// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hmi/gcode/canon_writer.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/program_check.hpp"
#include "tests/fuzz/require.hpp"

namespace psicarve::gcode {
namespace {

/// Every record is a line of JSON with numbers, and begins where the one before it ended.
struct SoundMotion : CanonSink {
    explicit SoundMotion(ProblemList& problems) : machine(Profile{}, problems) {}

    void take(const CanonRecord& record) override {
        machine.take(record);
        text.clear();
        append_canon_line(record, text);
        fuzz::require(text.back() == '\n' && text.find('\n') == text.size() - 1, "a record is one line");
        fuzz::require(text.find("null") == std::string::npos, "every number is one");
        const bool moves = record.kind == CanonKind::rapid || record.kind == CanonKind::feed ||
                           record.kind == CanonKind::arc;
        if (!moves) return;
        fuzz::require(record.start == at, "motion has no gap");
        fuzz::require(record.feed_per_min >= 0.0, "no feed goes backwards");
        at = record.end;
    }

    MachineCheck machine;
    std::string text;
    Position at{};
};

}  // namespace
}  // namespace psicarve::gcode

/// A program, whatever the bytes look like.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace psicarve;
    std::size_t at = 0;
    gcode::LineSource lines{[&](std::span<char> room) -> Result<std::size_t> {
        const std::size_t count = std::min(room.size(), size - at);
        std::copy_n(data + at, count, room.begin());
        at += count;
        return count;
    }};
    gcode::InterpreterOptions options;
    options.is_start_known = size % 2 == 0;
    gcode::ProblemList problems;
    gcode::SoundMotion motion{problems};
    const auto facts = gcode::interpret_program(lines, options, motion, problems);
    fuzz::require(facts.has_value(), "bytes can be read");
    fuzz::require(facts->has_end || problems.error_count() > 0, "no program is right without an end");
    for (const gcode::Problem& problem : problems.errors()) {
        const std::string text = gcode::problem_text(problem, "f.ngc");
        fuzz::require(problem.line >= 1 && problem.column >= 1, "a problem has a place");
        fuzz::require(text.find('\n') == std::string::npos, "a problem is one line");
    }
    return 0;
}
