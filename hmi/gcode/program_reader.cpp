// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/program_reader.hpp"

#include <algorithm>
#include <utility>

#include "hmi/gcode/block_reader.hpp"
#include "hmi/gcode/end_words.hpp"

namespace psicarve::gcode {
namespace {

bool is_blank_line(std::string_view line) noexcept {
    return std::all_of(line.begin(), line.end(),
                       [](char byte) { return byte == ' ' || byte == '\t' || byte == '\r'; });
}

}  // namespace

ProgramReader::ProgramReader(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                             ProblemList& problems)
    : lines_(lines),
      options_(options),
      sink_(sink),
      problems_(problems),
      interpreter_(std::make_unique<Interpreter>(options, sink, problems)),
      parameters_(std::make_unique<Parameters>(*interpreter_)),
      block_(std::make_unique<Block>()),
      flow_(lines, *parameters_, options.skips_deleted) {}

bool ProgramReader::wants_more() const noexcept {
    return !interpreter_->has_ended() && !is_given_up_ && sink_.wants_more();
}

/// Only how lines are written is judged.
bool ProgramReader::is_judging() const noexcept {
    return flow_.has_begun() && (problems_.error_count() > 0 || !flow_.is_running());
}

bool ProgramReader::is_frame(std::string_view line) {
    const bool frames = line.size() <= kMostLineBytes && is_percent_line(line) && (is_framed_ || !has_begun_);
    has_begun_ = has_begun_ || frames || !is_blank_line(line);
    if (!frames) return false;
    if (is_framed_ && is_judging()) {
        is_given_up_ = true;
        if (problems_.error_count() == 0) tell_end();
    } else if (auto unclosed = is_framed_ ? flow_.unclosed() : std::nullopt) {
        is_given_up_ = true;
        problems_.add(std::move(*unclosed));
    } else if (is_framed_) {
        interpreter_->end_without_block(lines_.number());
    }
    is_framed_ = true;
    return true;
}

/// A stream that breaks off may break off within a number.
bool ProgramReader::is_torn(std::string_view line) {
    if (!options_.ends_with_input || lines_.has_line_feed() || is_blank_line(line) || names_end(line))
        return false;
    problems_.add({lines_.number(), 1, ProblemCode::no_end,
                   phrase("the stream ends within a line: it may have been torn off, and is not run")});
    is_given_up_ = true;
    return true;
}

Result<ProgramFacts> ProgramReader::read() {
    std::string_view line;
    while (wants_more()) {
        if (const auto gone = leave_flow(); !gone) return gone.error();
        const auto has_line = lines_.next(line);
        if (!has_line) return has_line.error();
        if (!*has_line) break;
        interpreter_->begin_line(lines_.number());
        if (flow_.is_running()) sink_.begin_line({lines_.number(), flow_.called_line()});
        if (flow_.has_begun() && !is_work_bounded()) break;
        if (lines_.number() > line_count_) {
            line_count_ = lines_.number();
            furthest_ = lines_.place();
        }
        if (is_frame(line)) continue;
        if (is_torn(line)) break;
        if (has_read_plain(line)) continue;
        const auto gone = block_->o_word() ? read_o_word(line) : jump();
        if (!gone) return gone.error();
    }
    if (wants_more()) tell_end();
    if (const auto closed = pass_to_block_end(); !closed) return closed.error();
    return ProgramFacts{line_count_, interpreter_->motion_count(), interpreter_->has_ended()};
}

/// M2 may stand in a branch or a loop, which must have its end all the same.
Result<void> ProgramReader::pass_to_block_end() {
    if (!interpreter_->has_ended() || problems_.error_count() > 0 || !flow_.pass_over()) return {};
    std::string_view line;
    while (problems_.error_count() == 0) {
        auto unclosed = flow_.unclosed();
        if (!unclosed) break;
        const auto has_line = lines_.next(line);
        if (!has_line) return has_line.error();
        if (!*has_line || lines_.has_overflowed() || (is_framed_ && is_percent_line(line))) {
            tell(std::move(unclosed));
            break;
        }
        auto outcome = flow_.pass(line);
        if (!outcome) return outcome.error();
        if (*outcome) tell(std::move(*outcome));
    }
    return {};
}

/// Behind a fault what has been read is not read again.
Result<void> ProgramReader::leave_flow() {
    if (has_left_flow_ || !flow_.has_begun() || problems_.error_count() == 0) return {};
    has_left_flow_ = true;
    return lines_.go_to(furthest_);
}

/// Whether that was all: so it is with nearly every line.
bool ProgramReader::has_read_plain(std::string_view line) {
    const ReadingMode mode{is_judging(), options_.skips_deleted};
    auto wrong = read_block(line, lines_.number(), *parameters_, mode, *block_);
    if (options_.skips_deleted && block_->is_deleted()) return true;
    if (wrong) {
        refuse(std::move(*wrong), line);
        return true;
    }
    if (block_->o_word()) return false;
    if (mode.is_judging) return true;
    if (block_->has_values()) {
        if (const auto unset = parameters_->apply()) {
            refuse({block_->line(), 1, unset->code, unset->what}, {});
            return true;
        }
    }
    interpreter_->run(*block_, parameters_->is_doubtful());
    sink_.end_block();
    return interpreter_->wanted_jump().code == 0;
}

Result<void> ProgramReader::read_o_word(std::string_view line) {
    if (problems_.error_count() > 0) {
        tell(flow_.judge(line, *block_->o_word()));
        return {};
    }
    auto outcome = flow_.run(line, *block_->o_word());
    if (!outcome) return outcome.error();
    tell(std::move(*outcome));
    return {};
}

Result<void> ProgramReader::jump() {
    const WantedJump& wanted = interpreter_->wanted_jump();
    if (problems_.error_count() > 0) {
        is_given_up_ = is_given_up_ || wanted.code == 99;
        return {};
    }
    auto outcome = wanted.code == 98
                       ? flow_.call({wanted.number, wanted.times, block_->line(), wanted.column})
                       : flow_.go_back(block_->line(), wanted.column);
    if (!outcome) return outcome.error();
    tell(std::move(*outcome));
    return {};
}

void ProgramReader::refuse(Problem wrong, std::string_view line) {
    parameters_->drop_plans();
    // What follows from values that were not set is not told.
    const bool is_known = parameters_->is_doubtful() && block_->has_values() && problems_.error_count() > 0;
    if (!is_known || wrong.code < ProblemCode::value_impossible) problems_.add(std::move(wrong));
    if (block_->has_values()) parameters_->doubt();
    interpreter_->pass_unreadable(line);
}

void ProgramReader::tell(std::optional<Problem> wrong) {
    if (!lines_.has_overflowed()) {
        if (wrong) problems_.add(std::move(*wrong));
        return;
    }
    problems_.add({lines_.number(), 1, ProblemCode::text_too_long,
                   phrase("loops and subroutines of a stream have more than 64 MiB")});
    is_given_up_ = true;
}

/// A program that goes on for ever has an end here.
bool ProgramReader::is_work_bounded() {
    if (lines_.has_overflowed()) {
        tell(std::nullopt);
        return false;
    }
    const std::uint64_t chords = interpreter_->drawn_chord_count() - drawn_chords_;
    drawn_chords_ += chords;
    if (flow_.called_line() == 0 && lines_.number() > main_line_count_) {
        main_line_count_ = lines_.number();
        return true;
    }
    sink_.end_block();
    repeated_blocks_ += std::max<std::uint64_t>(chords, 1);
    ++idle_blocks_;
    if (actions_ != interpreter_->action_count()) idle_blocks_ = 0;
    actions_ = interpreter_->action_count();
    const bool is_idle = idle_blocks_ > options_.most_idle_blocks;
    if (!is_idle && repeated_blocks_ <= options_.most_repeated_blocks) return true;
    const std::uint64_t most = is_idle ? options_.most_idle_blocks : options_.most_repeated_blocks;
    problems_.add({lines_.number(), 1, is_idle ? ProblemCode::endless : ProblemCode::too_many_blocks,
                   phrase(is_idle ? "%1 blocks in loops make no move, no dwell and no stop"
                                  : "loops and calls make more than %1 blocks",
                          std::to_string(most))});
    is_given_up_ = true;
    return false;
}

void ProgramReader::tell_end() {
    const bool is_wrong = problems_.error_count() > 0;
    if (flow_.has_begun() && is_wrong) return;
    if (auto unclosed = flow_.unclosed()) {
        problems_.add(std::move(*unclosed));
        return;
    }
    if (interpreter_->is_end_doubtful()) return;
    if (options_.ends_with_input && line_count_ > 0 && !is_framed_) {
        if (!is_wrong) interpreter_->end_without_block(line_count_);
        return;
    }
    problems_.add({std::max<std::uint64_t>(line_count_, 1), 1, ProblemCode::no_end,
                   phrase(line_count_ == 0 ? "the program is empty" : "the program has no end")});
}

}  // namespace psicarve::gcode
