// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_source.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>

#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/source_text.hpp"
#include "hmi/gcode/judged_motion.hpp"
#include "hmi/offsets/source_numbers.hpp"
#include "shared/base/shared_text.hpp"
#include "shared/program/text_sum.hpp"

namespace psicarve::cli {
namespace {

Result<TextSum> sum_of_text(const GcodeRunOptions& options) {
    const auto bytes = gcode::open_unchanged_program(options.path, *options.state);
    if (!bytes) return bytes.error();
    TextSum sum;
    std::array<char, 65'536> room;
    for (;;) {
        const auto count = bytes->read(room);
        if (!count) return count.error();
        if (*count == 0) return sum;
        sum.add(std::span{room}.first(*count));
    }
}

std::uint32_t flags_of(const GcodeRunOptions& options) {
    std::uint32_t flags = kSourceHasOptionalStops;
    if (options.is_typed) flags |= kSourceIsTyped;
    if (options.is_stream()) flags |= kSourceIsStream;
    if (options.stops_at_optional) flags |= kSourceStopsAtOptional;
    if (options.skips_deleted) flags |= kSourceSkipsDeleted;
    if (options.is_dry) flags |= kSourceIsDry;
    if (options.dialect == "iso") flags |= kSourceIsIso;
    if (options.is_single) flags |= kSourceIsSingle;
    return flags;
}

/// A longer path would lose its end, which is what tells it; a file's own name is never too long.
std::string name_that_fits(const std::string& path) {
    if (path.size() < kSourceNameBytes) return path;
    return path.substr(path.find_last_of('/') + 1);
}

gcode::RunOptions steps_of_source(const ProgramSource& source) {
    gcode::RunOptions steps;
    steps.program = source.program;
    steps.from_line = source.from_line;
    steps.stops_at_optional = (source.flags & kSourceStopsAtOptional) != 0;
    steps.has_optional_stops = (source.flags & kSourceHasOptionalStops) != 0;
    steps.is_dry = (source.flags & kSourceIsDry) != 0;
    return steps;
}

/// Sums records up, until there are as many as are wanted.
class RecordSums : public gcode::RecordSink {
public:
    explicit RecordSums(std::uint64_t wanted) noexcept : wanted_(wanted) {}

    Result<void> take(const MotionRecord& record) override {
        if (taken_ == wanted_) return Error{ErrorCode::cancelled, "there are enough"};
        sum_ = with_record(sum_, record.check);
        line_ = record.line;
        ++taken_;
        return {};
    }
    std::uint64_t taken() const noexcept { return taken_; }
    std::uint64_t sum() const noexcept { return sum_; }
    std::uint64_t line() const noexcept { return line_; }

private:
    std::uint64_t wanted_;
    std::uint64_t taken_ = 0;
    std::uint64_t sum_ = 0;
    std::uint64_t line_ = 0;
};

}  // namespace

Result<void> tell_source(ProgramWriter& writer, const GcodeRunOptions& options, const Profile& profile,
                         const CoreStatus& status, const gcode::KeptOffsets& offsets) {
    const std::string toml = profile_to_toml(profile);
    // Of one that is longer no job could be made either.
    if (toml.size() > kSourceProfileBytes) return {};
    auto source = std::make_unique<ProgramSource>();
    source->from_line = options.from_line;
    source->flags = flags_of(options);
    std::ranges::copy(status.position_pulses, source->start_pulses.begin());
    source->kept = offsets::source_numbers(offsets);
    text_into_field(source->name, name_that_fits(options.path));
    source->profile_bytes = static_cast<std::uint32_t>(toml.size());
    std::memcpy(source->profile, toml.data(), toml.size());
    if (!options.is_stream()) {
        const auto sum = sum_of_text(options);
        if (!sum) return sum.error();
        source->text_bytes = sum->bytes();
        source->text_sum = sum->value();
    }
    writer.tell(*source);
    return {};
}

Result<SourcedProgram> sourced_program(const RecordedSource& recorded, const std::string& path,
                                       const std::string& snapshot) {
    const ProgramSource& source = recorded.source;
    SourcedProgram program;
    program.options.path = path;
    const auto state = gcode::state_of_program(path);
    if (!state) return state.error();
    program.options.state = *state;
    program.is_stream = (source.flags & kSourceIsStream) != 0;
    if (!program.is_stream) {
        const auto sum = sum_of_text(program.options);
        if (!sum) return sum.error();
        if (sum->bytes() != source.text_bytes || sum->value() != source.text_sum)
            return bad_input(path + ": another text than that of " + text_from_field(source.name) + " in " +
                             snapshot + ": " + text_words(sum->bytes(), sum->value()) + ", not " +
                             text_words(source.text_bytes, source.text_sum));
    }
    auto profile = parse_profile({source.profile, source.profile_bytes}, snapshot);
    if (!profile) return profile.error();
    program.profile = std::move(*profile);
    const auto kept = offsets::kept_from(source.kept);
    if (!kept) return bad_input(snapshot + ": damaged: the work offsets of its program are none");
    program.options.dialect = (source.flags & kSourceIsIso) != 0 ? "iso" : "ngc";
    program.options.skips_deleted = (source.flags & kSourceSkipsDeleted) != 0;
    CoreStatus status{};
    std::ranges::copy(source.start_pulses, std::begin(status.position_pulses));
    program.language = language_of(program.options, program.profile, status, *kept);
    program.language.ends_with_input = program.is_stream;
    program.steps = steps_of_source(source);
    return program;
}

Result<void> require_same_records(const SourcedProgram& program, const RecordedSource& recorded,
                                  const std::string& snapshot) {
    auto bytes = gcode::open_unchanged_program(program.options.path, *program.options.state);
    if (!bytes) return bytes.error();
    RecordSums sums{recorded.taken};
    gcode::ProblemList problems;
    gcode::KeptOffsets offsets = program.language.offsets;
    gcode::ModesTrail trail{program.profile.gcode, program.language.start, 1};
    gcode::RecordMaker maker{program.profile, program.steps, sums};
    gcode::JudgedMotion motion{program.profile, problems, maker, offsets, trail};
    gcode::LineSource lines{std::move(*bytes)};
    const auto facts = gcode::interpret_program(lines, program.language, motion, problems);
    if (!facts) return facts.error();
    motion.end_block();
    (void)maker.finish();  // that there were enough is no failure
    if (problems.error_count() > 0) print_problems(program.options.path, problems);
    if (sums.taken() == recorded.taken && sums.sum() == recorded.record_sum) return {};
    return bad_input(program.options.path + ": its motions up to line " + std::to_string(sums.line()) +
                     " are not those of the program in " + snapshot);
}

}  // namespace psicarve::cli
