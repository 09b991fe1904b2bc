// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shared/machine/signal.hpp"

namespace psicarve::verify {

inline constexpr std::size_t kRuleCount = 4;

/// How a measured value must compare with the allowed one.
enum class Bound : std::uint8_t { at_most, at_least, exactly };

/// One breach of one of the four rules that pulses must obey, with all that a person needs to find it.
struct Offence {
    int rule = 0;  ///< 1..4 as in the rules' list in docs/verify.md
    std::string
        fault;  ///< what kind, one word for programs: "point-missed", "direction-setup", "disabled"...
    std::optional<Axis> axis;
    std::int64_t time_ns = 0;
    std::optional<std::uint32_t> layer;  ///< the layer being carved
    std::optional<std::uint32_t> point;  ///< index in the layer's row
    std::optional<std::uint64_t> line;   ///< of a program in G-code
    std::string pass;                    ///< "roughing pass 2"; empty: the job has but one
    double measured = 0.0;
    double allowed = 0.0;
    Bound bound = Bound::at_most;
    std::string unit;      ///< of both values: "ns", "pulses", "mm"
    std::string sentence;  ///< one clear line that names all of it
};

/// The result of one rule.
struct RuleResult {
    bool judged = false;
    std::uint64_t offences = 0;
    std::optional<Offence> first;
};

using RuleResults = std::array<RuleResult, kRuleCount>;

/// The first offence in time, whatever its rule; nullptr when there is none.
const Offence* first_offence_of(const RuleResults& rules) noexcept;
nlohmann::ordered_json rules_json(const RuleResults& rules);
/// A line for each rule's first offence.
std::string offences_text(const RuleResults& rules);

/// A pass of a job with several, as the trace carved it.
struct PassTime {
    std::string name;
    std::uint32_t layers = 0;
    double seconds = 0.0;  ///< to its last point from the last of the pass before, or the job's first
};

struct VerifyReport {
    bool ok = false;  ///< every judged rule holds and every point was visited, or it may end early
    RuleResults rules;
    std::array<std::uint64_t, kAxisCount> pulses{};  ///< rising step edges in the whole trace
    std::uint64_t points_visited = 0;                ///< exactly, in order; a point counts for both heads
    std::uint64_t points_total = 0;
    std::uint32_t first_layer = 0;  ///< the first of those to be carved
    std::uint32_t layer_count = 0;
    bool is_whole_job = true;
    std::optional<std::uint32_t> first_point;  ///< of the first layer, where it was to begin within it
    bool is_cut = false;                       ///< it may end where it does, and is judged up to there
    bool is_dry = false;                       ///< dry runs alone: rule 1 is not judged
    bool is_complete = false;                  ///< the last attempt came to the last point, and reached some
    /// Largest difference between carved and wanted radius at those points after all motion of the trace; of
    /// a carving that was cut short, at those that were carved.
    std::int64_t max_deviation_pulses = 0;
    std::uint64_t uncarved_cells = 0;        ///< of the surface, that no tip reached
    double max_line_deviation_mm = 0.0;      ///< largest distance from the straight line between two points
    double max_line_deviation_pulses = 0.0;  ///< the largest in pulses across the line (another place, maybe)
    /// From leaving the first point to reaching the last, or to the last pulse on the path where it was not
    /// reached; where the carving went on from a layer or point, of the last attempt; 0: nothing was carved.
    double carve_seconds = 0.0;
    double trace_seconds = 0.0;
    std::uint64_t events = 0;
    std::vector<PassTime> passes;  ///< none: the job has but one, or was not carved to its end

    /// Only a part of the surface was to be carved, it is not known which: what is left of it is no
    /// deviation.
    bool is_of_carved_alone() const noexcept { return is_cut || is_dry; }
    const Offence* first_offence() const noexcept { return first_offence_of(rules); }
};

/// One JSON object, as `psicarve verify --json` prints it.
std::string report_json(const VerifyReport& report);
/// " in layers 37 to 39", " in layers 2 to 4, from point 5 of layer 2 on, up to where it was recorded"; empty
/// for a whole job.
std::string judged_text(const VerifyReport& report);
/// A few lines for a person.
std::string report_text(const VerifyReport& report);

}  // namespace psicarve::verify
