// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/program/program_rule.hpp"
#include "hmi/verify/program/way_reader.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

struct ProgramVerifyReport {
    bool ok = false;  ///< every judged rule holds
    RuleResults rules;
    std::array<std::uint64_t, kAxisCount> pulses{};  ///< rising step edges in the whole trace
    std::uint64_t ways_done = 0;
    double most_off_mm = 0.0;  ///< the path off its ways, but for 1.5 pulses of each axis
    double run_seconds = 0.0;  ///< from leaving the program's begin to its end
    double trace_seconds = 0.0;
    std::uint64_t events = 0;
    std::vector<LoweredFeed> lowered;  ///< the worst first
    double lowered_seconds = 0.0;      ///< longer than the feeds ask for
    std::uint64_t lowered_count = 0;   ///< all of them
    ProgramTimes times;
    ProgramBounds bounds;
    std::optional<Error> failure;  ///< the program could not be read: nothing is verified
};

/// One JSON object, as `psicarve verify --json` prints it.
nlohmann::ordered_json program_report_json(const ProgramVerifyReport& report);
/// [{"first_line", "last_line", "share", "asked_seconds", "taken_seconds"}], the worst first.
nlohmann::ordered_json lowered_json(const std::vector<LoweredFeed>& lowered);
/// "line 12 by 40 %, lines 20 to 24 by 12 %"; at most `most` of them; empty: none.
std::string lowered_text(const std::vector<LoweredFeed>& lowered, std::size_t most);
/// A few lines for a person.
std::string program_report_text(const ProgramVerifyReport& report);

/// Judges a pin trace against a program in G-code: rule 1 by its canonical motion (ProgramRule), the others
/// as for a job. Call order: begin, feed (any number of times), finish. One thread.
class ProgramVerifier {
public:
    ProgramVerifier(JudgedProgram program, const Profile& profile);
    ~ProgramVerifier();
    ProgramVerifier(const ProgramVerifier&) = delete;
    ProgramVerifier& operator=(const ProgramVerifier&) = delete;

    Result<void> begin(const TraceStart& start);
    void feed(std::span<const TraceEvent> events);
    ProgramVerifyReport finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace psicarve::verify
