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

/// What has been read, in short.
std::string judged(const Result<ProgramFacts>& facts, const ProblemList& problems,
                   const SoundMotion& motion) {
    fuzz::require(facts.has_value(), "bytes can be read");
    fuzz::require(facts->has_end || problems.error_count() > 0, "no program is right without an end");
    std::string told =
        std::to_string(facts->line_count) + ' ' + std::to_string(facts->motion_count) + ' ' + motion.text;
    for (const Problem& problem : problems.errors()) {
        const std::string text = problem_text(problem, "f.ngc");
        fuzz::require(problem.line >= 1 && problem.column >= 1, "a problem has a place");
        fuzz::require(text.find('\n') == std::string::npos, "a problem is one line");
        told += text;
    }
    return told;
}

}  // namespace
}  // namespace psicarve::gcode

/// A program, whatever the bytes look like.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace psicarve;
    gcode::InterpreterOptions options;
    options.is_start_known = size % 2 == 0;
    options.most_repeated_blocks = 20'000;
    options.most_idle_blocks = 5'000;
    std::string told;
    // As a file and as a stream.
    for (const bool is_file : {true, false}) {
        std::size_t at = 0;
        gcode::ProgramBytes bytes;
        bytes.read = [&](std::span<char> room) -> Result<std::size_t> {
            const std::size_t count = std::min({room.size(), size - at, std::size_t{100}});
            std::copy_n(data + at, count, room.begin());
            at += count;
            return count;
        };
        if (is_file)
            bytes.seek = [&](std::uint64_t offset) -> Result<void> {
                fuzz::require(offset <= size, "a place lies in the program");
                at = offset;
                return {};
            };
        gcode::LineSource lines{std::move(bytes)};
        gcode::ProblemList problems;
        gcode::SoundMotion motion{problems};
        const auto facts = gcode::interpret_program(lines, options, motion, problems);
        const std::string now = gcode::judged(facts, problems, motion);
        // A number that has gone by in a stream is not found again.
        const bool has_gone_by = now.find("text_too_long") != std::string::npos;
        fuzz::require(is_file || has_gone_by || now == told, "a stream means what a file means");
        told = now;
    }
    return 0;
}
