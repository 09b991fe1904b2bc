// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/machine_options.hpp"
#include "hmi/gcode/program_check.hpp"

namespace psicarve::gcode {

inline std::string file_text(const std::string& path) {
    std::ifstream stream{path, std::ios::binary};
    EXPECT_TRUE(stream.good()) << path;
    return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The text in pieces of at most so many bytes.
inline ByteSource bytes_of(const std::string& text, std::size_t most = 4096) {
    const auto at = std::make_shared<std::size_t>(0);
    return [text, most, at](std::span<char> room) -> Result<std::size_t> {
        const std::size_t count = std::min({most, room.size(), text.size() - *at});
        std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(*at), count, room.begin());
        *at += count;
        return count;
    };
}

/// What a program comes to.
struct ReadProgram : CanonSink {
    void take(const CanonRecord& record) override {
        records.push_back(record);
        if (machine) machine->take(record);
    }

    std::vector<CanonRecord> records;
    ProblemList problems;
    ProgramFacts facts;
    std::unique_ptr<MachineCheck> machine;

    /// "LINE:COLUMN code" of all errors, and then of all warnings.
    std::vector<std::string> faults() const {
        std::vector<std::string> texts;
        for (const auto* list : {&problems.errors(), &problems.warnings()})
            for (const Problem& problem : *list)
                texts.push_back(std::to_string(problem.line) + ":" + std::to_string(problem.column) + " " +
                                std::string{name_of(problem.code)});
        return texts;
    }
    std::vector<CanonRecord> of_kind(CanonKind kind) const {
        std::vector<CanonRecord> found;
        for (const CanonRecord& record : records)
            if (record.kind == kind) found.push_back(record);
        return found;
    }
};

inline std::unique_ptr<ReadProgram> read_program(const std::string& text, InterpreterOptions options = {},
                                                 const Profile* profile = nullptr) {
    auto read = std::make_unique<ReadProgram>();
    if (profile != nullptr) {
        read->machine = std::make_unique<MachineCheck>(*profile, read->problems);
        options.is_start_known = false;
        options.reference = MachineCheck::reference_of(*profile);
    }
    LineSource lines{bytes_of(text)};
    const auto facts = interpret_program(lines, options, *read, read->problems);
    EXPECT_TRUE(facts.has_value());
    if (facts) read->facts = *facts;
    return read;
}

using Faults = std::vector<std::string>;

}  // namespace psicarve::gcode
