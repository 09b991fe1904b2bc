// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/gcode/record_maker.hpp"
#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {

/// Keeps what it takes, until it is to fail.
struct RecordList : RecordSink {
    Result<void> take(const MotionRecord& record) override {
        if (records.size() >= most) return bad_input("the list is full");
        records.push_back(record);
        return {};
    }

    std::vector<MotionRecord> records;
    std::size_t most = SIZE_MAX;
};

struct MadeRecords {
    std::vector<MotionRecord> records;
    std::string failure;      ///< of RecordMaker::finish()
    Faults faults;            ///< of the language
    std::uint64_t lines = 0;  ///< that were read

    /// Of those that are ways.
    std::vector<MotionRecord> ways() const {
        std::vector<MotionRecord> found;
        for (const MotionRecord& record : records)
            if (record.kind == MotionKind::way) found.push_back(record);
        return found;
    }
};

/// A program's records on the machine of `profile`, which stands at its reference.
inline MadeRecords made_records(const std::string& text, const RunOptions& how = {},
                                const Profile& profile = {}, bool is_start_known = true,
                                std::size_t most = SIZE_MAX) {
    InterpreterOptions options = machine_options(profile);
    options.start = options.reference;
    options.is_start_known = is_start_known;
    RecordList list;
    list.most = most;
    RecordMaker maker{profile, how, list};
    ProblemList problems;
    LineSource lines{bytes_of(text)};
    const auto facts = interpret_program(lines, options, maker, problems);
    EXPECT_TRUE(facts.has_value());
    const auto finished = maker.finish();
    MadeRecords made;
    made.records = list.records;
    if (!finished) made.failure = finished.error().message;
    for (const Problem& problem : problems.errors())
        made.faults.push_back(std::to_string(problem.line) + " " + std::string{name_of(problem.code)});
    made.lines = lines.number();
    return made;
}

}  // namespace psicarve::gcode
