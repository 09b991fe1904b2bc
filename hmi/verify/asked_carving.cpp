// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/asked_carving.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>

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

/// Whether something ended the run that begins here before its time, or the recording does.
bool is_cut_short(Record begin, Record end) {
    const auto rest = std::find_if(begin, end, is_ready);
    const auto is_end = [](const FlightRecord& record) {
        return record.kind == RecordKind::stop || record.kind == RecordKind::emergency_stop ||
               record.kind == RecordKind::alarm || record.kind == RecordKind::failure;
    };
    return rest == end || std::any_of(begin, rest, is_end);
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

}  // namespace

std::optional<AskedCarving> asked_carving(const JobView& job, std::span<const FlightRecord> records,
                                          std::uint64_t points_done) {
    std::optional<Asked> asked;
    bool is_last_dry = false;
    const auto is_start = [](const FlightRecord& record) {
        return is_done_command(record, CommandKind::start);
    };
    const auto is_carving = [](const FlightRecord& record) {
        return is_done_command(record, CommandKind::start_interpolation);
    };
    for (auto start = std::find_if(first_of_replay(records), records.end(), is_start);
         start != records.end();) {
        const auto next = std::find_if(std::next(start), records.end(), is_start);
        const auto carving = std::find_if(start, next, is_carving);
        auto own = carving != next ? asked_by(*start, job) : std::nullopt;
        if (own) own->is_cut = is_cut_short(carving, next);
        if (own) go_on_with(asked, *own);
        if (own) is_last_dry = own->is_dry;
        start = next;
    }
    if (!asked) return std::nullopt;
    const std::uint64_t before = std::uint64_t{asked->begin.layer} * job.point_count() + asked->begin.step;
    const bool is_known = asked->is_cut && !is_last_dry && points_done > before;
    return AskedCarving{.layers = asked->layers,
                        .may_end_early = asked->is_cut,
                        .carves = !asked->is_dry,
                        .ends_there = true,
                        .least_points = is_known ? points_done - before : 0};
}

}  // namespace psicarve::verify
