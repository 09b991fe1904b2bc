// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/asked_carving.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <tuple>
#include <vector>

#include "hmi/verify/path/point_way.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_start.hpp"

namespace psicarve::verify {
namespace {

using Record = std::span<const FlightRecord>::iterator;

bool is_done(const FlightRecord& record, RecordKind kind) {
    return record.kind == kind && static_cast<AnswerKind>(record.answer) == AnswerKind::done;
}

bool is_done_command(const FlightRecord& record, CommandKind kind) {
    return is_done(record, RecordKind::command) && static_cast<CommandKind>(record.code) == kind;
}

bool is_ready(const FlightRecord& record) {
    return record.kind == RecordKind::state_change &&
           static_cast<MachineState>(record.code) == MachineState::ready;
}

/// No start before the newest job is of that job, and none behind it comes before the machine is at rest.
Record first_of_replay(std::span<const FlightRecord> records) {
    const auto ends_replayable = [](const FlightRecord& record) {
        return is_done(record, RecordKind::job) || is_done_command(record, CommandKind::program);
    };
    const auto last = std::find_if(records.rbegin(), records.rend(), ends_replayable);
    return last != records.rend() ? last.base() : std::ranges::find_if(records, is_ready);
}

/// In the order of carving.
struct Place {
    std::uint32_t layer = 0;
    std::uint32_t step = 0;
};

bool lies_behind(const Place& one, const Place& other) {
    return std::tie(one.layer, one.step) > std::tie(other.layer, other.step);
}

struct Asked {
    Place begin;
    LayerRange layers;
    std::uint32_t end_layer = 0;
    bool is_dry = false;
    bool is_cut = false;
};

/// Nothing for numbers that no core takes.
std::optional<Asked> asked_by(const FlightRecord& record, const JobView& job) {
    const RecordedStart start = recorded_start(static_cast<std::uint64_t>(record.value));
    if (start.first_layer >= job.layer_count() || start.point_number >= job.point_count() + 1)
        return std::nullopt;
    Asked asked;
    asked.layers = {start.first_layer, start.layers, std::nullopt};
    asked.begin = {start.first_layer, 0};
    if (start.point_number != 0) {
        const std::uint32_t point = start.point_number - 1;
        asked.begin.step = carved_point(job.joining(), job.point_count(), start.first_layer, point);
        if (asked.begin.step + 1 == job.point_count()) return std::nullopt;
        // The layer's first point is its begin, and reached as such.
        if (asked.begin.step != 0) asked.layers.first_point = point;
    }
    const std::uint32_t left = job.layer_count() - start.first_layer;
    asked.end_layer = start.first_layer + (start.layers == 0 ? left : std::min(start.layers, left));
    asked.is_dry = start.is_dry;
    return asked;
}

bool ends_run(const FlightRecord& record) {
    return record.kind == RecordKind::stop || record.kind == RecordKind::emergency_stop ||
           record.kind == RecordKind::alarm || record.kind == RecordKind::failure;
}

/// Whether something ended the run that begins here before its time, or the recording does.
bool is_cut_short(Record begin, Record end) {
    const auto rest = std::find_if(begin, end, is_ready);
    return rest == end || std::any_of(begin, rest, ends_run);
}

std::uint64_t points_before(const Place& place, const JobView& job) {
    return std::uint64_t{place.layer} * job.point_count() + place.step;
}

std::int64_t off(std::int64_t one_pulses, std::int64_t other_pulses) {
    return std::abs(one_pulses - other_pulses);
}

/// Whether the machine is known to have come to the second point of the run that begins here.
bool has_carved(Record begin, Record end, const JobView& job) {
    const auto cut = std::find_if(begin, end, ends_run);
    const std::int64_t spacing_pulses =
        off(job.psi_sweep_pulses(), 0) / std::max<std::int64_t>(std::int64_t{job.point_count()} - 1, 1);
    return std::any_of(begin, cut == end ? end : std::next(cut), [&](const FlightRecord& record) {
        return off(record.position_pulses[kPsi], begin->position_pulses[kPsi]) > spacing_pulses;
    });
}

/// Whether the heads may have come to the first point of a start that was called off.
bool may_have_gone_in(Record begin, Record end, const Asked& asked, const JobView& job) {
    const std::uint32_t point =
        carved_point(job.joining(), job.point_count(), asked.begin.layer, asked.begin.step);
    return std::any_of(begin, end, [&](const FlightRecord& record) {
        const auto& at = record.position_pulses;
        return (record.signals & bit_of(Signal::spindle)) != 0 &&
               off(at[0], job.r_left_pulses(asked.begin.layer)[point]) <= kNearPulses &&
               off(at[1], job.r_right_pulses(asked.begin.layer)[point]) <= kNearPulses &&
               at[kY] == job.y_pulses(asked.begin.layer, point);
    });
}

void go_on_with(std::optional<Asked>& so_far, const Asked& next) {
    const bool has_carved = so_far && !so_far->is_dry;
    if (next.is_dry && has_carved) return;
    const bool goes_on = has_carved && !next.is_dry && lies_behind(next.begin, so_far->begin) &&
                         !lies_behind(next.begin, {so_far->end_layer, 0});
    if (!goes_on) {
        so_far = next;
        return;
    }
    // One that ends before the other does carves less of it anew, but what the other did counts.
    so_far->is_cut = next.is_cut || next.end_layer < so_far->end_layer;
    so_far->end_layer = std::max(so_far->end_layer, next.end_layer);
    so_far->layers.count = so_far->end_layer - so_far->layers.first;
}

/// Which starts came to their second point, and which ones that followed may have led the heads in: where
/// they began.
struct Runs {
    std::vector<Place> carving;
    std::vector<Place> in_vain;

    void note(const Place& begin, bool has_carved) {
        if (has_carved) in_vain.clear();
        (has_carved ? carving : in_vain).push_back(begin);
    }
};

std::uint64_t count_within(const std::vector<Place>& begins, const Asked& asked) {
    return static_cast<std::uint64_t>(std::ranges::count_if(begins, [&](const Place& begin) {
        return !lies_behind(asked.begin, begin) && begin.layer < asked.end_layer;
    }));
}

/// Takes the starts one after the other.
class Starts {
public:
    Starts(const JobView& job, TraceHolds holds) : job_(job), holds_(holds) {}

    /// `points_done`: 0 where they are of another start.
    void take(Record start, Record next, std::uint64_t points_done) {
        const auto carving = std::find_if(start, next, [](const FlightRecord& record) {
            return is_done_command(record, CommandKind::start_interpolation);
        });
        auto own = asked_by(*start, job_);
        const bool is_told = carving != next;
        last_points_ = 0;
        if (own && is_told) {
            own->is_cut = is_cut_short(carving, next);
            go_on_with(asked_, *own);
        }
        if (!own || own->is_dry) return;
        if (is_told) {
            last_points_ = points_done;
            runs_.note(own->begin, !own->is_cut || points_done > points_before(own->begin, job_) + 1 ||
                                       has_carved(carving, next, job_));
        } else if (holds_ == TraceHolds::all_runs || may_have_gone_in(start, next, *own, job_)) {
            runs_.note(own->begin, false);
        }
    }

    std::optional<AskedCarving> asked() const {
        if (!asked_) return std::nullopt;
        AskedCarving found{.layers = asked_->layers,
                           .may_end_early = asked_->is_cut,
                           .carves = !asked_->is_dry,
                           .ends_there = true};
        if (asked_->is_dry) return found;
        const std::uint64_t before = points_before(asked_->begin, job_);
        if (asked_->is_cut && last_points_ > before) found.least_points = last_points_ - before;
        found.most_vain_starts = count_within(runs_.in_vain, *asked_);
        if (holds_ == TraceHolds::all_runs) found.least_runs = count_within(runs_.carving, *asked_);
        return found;
    }

private:
    const JobView& job_;
    TraceHolds holds_;
    std::optional<Asked> asked_;
    Runs runs_;
    std::uint64_t last_points_ = 0;  ///< of the job, if the last start carved them; 0: not known
};

}  // namespace

std::optional<AskedCarving> asked_carving(const JobView& job, std::span<const FlightRecord> records,
                                          std::uint64_t points_done, TraceHolds holds) {
    const auto is_start = [](const FlightRecord& record) {
        return is_done_command(record, CommandKind::start);
    };
    Starts starts(job, holds);
    for (auto start = std::find_if(first_of_replay(records), records.end(), is_start);
         start != records.end();) {
        const auto next = std::find_if(std::next(start), records.end(), is_start);
        starts.take(start, next, next == records.end() ? points_done : 0);
        start = next;
    }
    return starts.asked();
}

}  // namespace psicarve::verify
