// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "shared/wording/wording_tables.hpp"

namespace psicarve {
namespace {

using Id = MessageId;
using K = ArgumentKind;

constexpr ArgumentName kLayer{K::layer, "layer"};
constexpr ArgumentName kPoint{K::point, "point"};
constexpr ArgumentName kHead{K::axis, "axis"};
constexpr ArgumentName kRadius{K::mm, "radius_mm"};
constexpr ArgumentName kRadiusPulses{K::pulses, "radius_pulses"};
constexpr ArgumentName kLimit{K::mm, "limit_mm"};
constexpr ArgumentName kLimitPulses{K::pulses, "limit_pulses"};
constexpr ArgumentName kHeight{K::mm, "height_mm"};
constexpr ArgumentName kHeightPulses{K::pulses, "height_pulses"};
constexpr ArgumentName kBelow{K::mm, "below_mm"};
constexpr ArgumentName kBelowPulses{K::pulses, "below_pulses"};
constexpr ArgumentName kJob{K::mm, "job_mm"};
constexpr ArgumentName kMachine{K::mm, "machine_mm"};

constexpr const char* kInTheWay = "what is larger is in the heads' way: mount the job's, or slice again";
constexpr const char* kAir = "with what is smaller a part of the job is air";
constexpr const char* kSliceForThis = "slice the model for this machine's profile";
constexpr const char* kWiden = "make the model smaller or widen axis.%3.travel_mm";

constexpr std::array kJobWordings{
    Wording{Id::job_unsound, "job_unsound", "%1", "", {{K::text, "reason"}}},
    Wording{Id::job_for_other_machine,
            "job_for_other_machine",
            "the job was made for another machine: %1 differ",
            "slice it again with the core's profile",
            {{K::text, "keys"}}},
    Wording{Id::blank_too_wide,
            "blank_too_wide",
            "the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the "
            "carving begins",
            "take a smaller blank",
            {{K::mm, "blank_mm"}, kHead, {K::mm, "head_mm"}},
            2},
    Wording{Id::blank_beside,
            "blank_beside",
            "the job was made for a blank that stands %1 beside the one that the machine's profile tells of",
            kAir,
            {{K::mm, "apart_mm"}},
            2},
    Wording{Id::blank_beside_in_the_way,
            "blank_beside_in_the_way",
            "the job was made for a blank that stands %1 beside the one that the machine's profile tells of",
            kInTheWay,
            {{K::mm, "apart_mm"}},
            2},
    Wording{Id::blank_radius_differs,
            "blank_radius_differs",
            "the job was made for a blank of %1 radius, the machine's profile tells of %2",
            kAir,
            {kJob, kMachine},
            2},
    Wording{Id::blank_radius_in_the_way,
            "blank_radius_in_the_way",
            "the job was made for a blank of %1 radius, the machine's profile tells of %2",
            kInTheWay,
            {kJob, kMachine},
            2},
    Wording{Id::blank_height_differs,
            "blank_height_differs",
            "the job was made for a blank of %1 height, the machine's profile tells of %2",
            kAir,
            {kJob, kMachine},
            2},
    Wording{Id::blank_height_in_the_way,
            "blank_height_in_the_way",
            "the job was made for a blank of %1 height, the machine's profile tells of %2",
            kInTheWay,
            {kJob, kMachine},
            2},
    Wording{Id::begun_with_other_profile,
            "begun_with_other_profile",
            "this piece was begun with another profile of the machine",
            "",
            {}},
    Wording{Id::segment_and_disk_disagree,
            "segment_and_disk_disagree",
            "segment: layer %1, disk: %2",
            "where this piece goes on the two disagree, the lower one is taken",
            {{K::count, "segment_layer"}, {K::count, "disk_layer"}}},
    Wording{Id::busy_for_a_job, "busy_for_a_job", "the machine is busy", "try again", {}},
    Wording{
        Id::job_runs, "job_runs", "a job runs (%1)", "stop it or wait for its end", {{K::state, "state"}}},
    Wording{Id::other_job_published,
            "other_job_published",
            "another job was published meanwhile",
            "publish this one again",
            {}},
    Wording{Id::job_refused_without_reason,
            "job_refused_without_reason",
            "the core refused the job without a reason",
            "",
            {}},
    Wording{Id::published_without_core,
            "published_without_core",
            "the job is published, but no core serves segment %1: start psicarve-rtcore",
            "",
            {{K::text, "segment"}}},
    Wording{Id::job_not_judged,
            "job_not_judged",
            "the core did not judge the job within %1 ms",
            "",
            {{K::ms, "limit_ms"}}},
    Wording{Id::published_by_nobody,
            "published_by_nobody",
            "the published job is damaged: nobody published generation %1",
            "publish it again",
            {{K::count, "generation"}}},
    Wording{Id::published_too_large,
            "published_too_large",
            "the published job says it has %1 bytes, a slot holds %2",
            "",
            {{K::count, "bytes"}, {K::count, "slot_bytes"}}},
    Wording{Id::published_checksum_wrong,
            "published_checksum_wrong",
            "the published job is damaged: its checksum is wrong",
            "",
            {}},

    Wording{Id::sweep_of_other_machine,
            "sweep_of_other_machine",
            "job: a layer sweeps %1 pulses of psi, half a revolution of this machine is %2",
            kSliceForThis,
            {{K::pulses, "sweep_pulses"}, {K::pulses, "half_turn_pulses"}}},
    Wording{Id::more_points_than_pulses,
            "more_points_than_pulses",
            "job: %1 points in a layer of %2 pulses of psi",
            "slice with at most %3 points",
            {{K::count, "points"}, {K::pulses, "half_turn_pulses"}, {K::count, "most_points"}}},
    Wording{Id::direction_reversed,
            "direction_reversed",
            "job: its direction of axis %1 is the other way round on this machine (axis.%1.positive)",
            kSliceForThis,
            {{K::axis, "axis"}}},
    Wording{
        Id::radius_inside_core,
        "radius_inside_core",
        "layer %1, point %2: the radius of %3, %4 (%5 pulses), is inside the core radius of %6 (%7 pulses)",
        "carve less deep, or lower core_radius_mm",
        {kLayer, kPoint, kHead, kRadius, kRadiusPulses, kLimit, kLimitPulses},
        4},
    Wording{Id::radius_below_travel,
            "radius_below_travel",
            "layer %1, point %2: the radius of %3, %4 (%5 pulses), is below the travel, which ends at %6 (%7 "
            "pulses)",
            kWiden,
            {kLayer, kPoint, kHead, kRadius, kRadiusPulses, kLimit, kLimitPulses},
            4},
    Wording{Id::radius_above_travel,
            "radius_above_travel",
            "layer %1, point %2: the radius of %3, %4 (%5 pulses), is above the travel, which ends at %6 (%7 "
            "pulses)",
            kWiden,
            {kLayer, kPoint, kHead, kRadius, kRadiusPulses, kLimit, kLimitPulses},
            4},
    Wording{
        Id::tips_too_close,
        "tips_too_close",
        "layer %1, point %2: the tips of r1 at %3 (%4 pulses) and r2 at %5 (%6 pulses) are %7 apart, closer "
        "than head_clearance_mm = %8",
        "raise core_radius_mm and slice again",
        {kLayer,
         kPoint,
         {K::mm, "r1_mm"},
         {K::pulses, "r1_pulses"},
         {K::mm, "r2_mm"},
         {K::pulses, "r2_pulses"},
         {K::mm, "apart_mm"},
         {K::mm, "head_clearance_mm"}},
        4},
    Wording{
        Id::height_outside_travel,
        "height_outside_travel",
        "layer %1, point %2: the height of %3 (%4 pulses) lies outside the travel of y, %5 (%6 pulses) to "
        "%7 (%8 pulses)",
        "make the model smaller, or change job.base_height_mm",
        {kLayer,
         kPoint,
         kHeight,
         kHeightPulses,
         {K::mm, "from_mm"},
         {K::pulses, "from_pulses"},
         {K::mm, "to_mm"},
         {K::pulses, "to_pulses"}},
        4},
    Wording{
        Id::ring_not_closed,
        "ring_not_closed",
        "layer %1, point %2: the height of %3 (%4 pulses) is not that of the layer below, %5 (%6 pulses), "
        "as it must be in the ring that closes a spiral",
        "slice the model again",
        {kLayer, kPoint, kHeight, kHeightPulses, kBelow, kBelowPulses},
        4},
    Wording{Id::layer_not_higher,
            "layer_not_higher",
            "layer %1, point %2: the height of %3 (%4 pulses) does not lie above the layer below, %5 (%6 "
            "pulses)",
            "use fewer layers, so that each is at least a pulse higher",
            {kLayer, kPoint, kHeight, kHeightPulses, kBelow, kBelowPulses},
            4},
    Wording{Id::spiral_not_joined,
            "spiral_not_joined",
            "layer %1, point %2: the radius of %3, %4 pulses, is not the %5 pulses in which the layer below "
            "ends: a spiral has no links",
            "slice the model again",
            {kLayer, kPoint, kHead, kRadiusPulses, {K::pulses, "below_pulses"}}},
};

}  // namespace

std::span<const Wording> job_wordings() noexcept {
    return kJobWordings;
}

}  // namespace psicarve
