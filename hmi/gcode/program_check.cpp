// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/program_check.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "hmi/gcode/block_reader.hpp"

namespace psicarve::gcode {
namespace {

bool is_blank_line(std::string_view line) noexcept {
    return std::all_of(line.begin(), line.end(),
                       [](char byte) { return byte == ' ' || byte == '\t' || byte == '\r'; });
}

}  // namespace

Result<ProgramFacts> interpret_program(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                                       ProblemList& problems) {
    const auto interpreter = std::make_unique<Interpreter>(options, sink, problems);
    const auto block = std::make_unique<Block>();
    std::string_view line;
    bool has_begun = false;
    bool is_framed = false;
    while (!interpreter->has_ended() && sink.wants_more()) {
        const auto has_line = lines.next(line);
        if (!has_line) return has_line.error();
        if (!*has_line) break;
        if (line.size() <= kMostLineBytes && is_percent_line(line) && (is_framed || !has_begun)) {
            if (is_framed) interpreter->end_by_percent(lines.number());
            is_framed = true;
            has_begun = true;
            continue;
        }
        has_begun = has_begun || !is_blank_line(line);
        if (auto wrong = read_block(line, lines.number(), *block)) {
            if (options.skips_deleted && block->is_deleted()) continue;
            problems.add(std::move(*wrong));
            interpreter->pass_unreadable(line);
        } else {
            interpreter->run(*block);
        }
    }
    if (!interpreter->has_ended() && !interpreter->is_end_doubtful() && sink.wants_more())
        problems.add({std::max<std::uint64_t>(lines.number(), 1), 1, ProblemCode::no_end,
                      lines.number() == 0 ? "the program is empty" : "the program has no end"});
    return ProgramFacts{lines.number(), interpreter->motion_count(), interpreter->has_ended()};
}

}  // namespace psicarve::gcode
