// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path_offences.hpp"

#include <string>
#include <utility>

#include "hmi/verify/offence_log.hpp"

namespace psicarve::verify {

namespace {

Offence finding(const char* fault, Bound bound, double measured, double allowed, const char* unit,
                std::string sentence) {
    Offence offence;
    offence.rule = 1;
    offence.fault = fault;
    offence.bound = bound;
    offence.measured = measured;
    offence.allowed = allowed;
    offence.unit = unit;
    offence.sentence = std::move(sentence);
    return offence;
}

Offence of_axis(Axis axis, Offence offence) {
    offence.axis = axis;
    return offence;
}

Offence missed(Axis axis, std::int64_t measured_pulses, std::int64_t wanted_pulses, std::string sentence) {
    return of_axis(axis, finding("point-missed", Bound::exactly, static_cast<double>(measured_pulses),
                                 static_cast<double>(wanted_pulses), "pulses", std::move(sentence)));
}

}  // namespace

Offence point_missed(Axis axis, std::int64_t measured_pulses, std::int64_t wanted_pulses) {
    return missed(axis, measured_pulses, wanted_pulses,
                  "a point was not visited: " + shown_name(axis) + " stood elsewhere");
}

Offence point_not_met_at_once(Axis axis, std::int64_t measured_pulses, std::int64_t wanted_pulses) {
    return missed(axis, measured_pulses, wanted_pulses,
                  "a point was not visited by all axes at one instant: psi went past it");
}

Offence off_the_line(Axis head, const PathLine::Distance& distance) {
    return of_axis(head, finding("off-the-line", Bound::at_most, distance.judged_mm, distance.allowed_mm,
                                 "mm", shown_name(head) + " leaves the straight line to a point"));
}

Offence off_the_height(bool is_spiral, std::int64_t y_pulses, double wanted_pulses) {
    return of_axis(Axis::y,
                   finding("height", Bound::exactly, static_cast<double>(y_pulses), wanted_pulses, "pulses",
                           is_spiral ? "Y leaves the straight line to a point"
                                     : "Y leaves its layer before the layer's end"));
}

Offence wrong_layer(std::uint32_t layer, std::uint32_t due, std::int64_t y_pulses,
                    std::int64_t wanted_pulses) {
    return of_axis(Axis::y, finding("layer-order", Bound::exactly, static_cast<double>(y_pulses),
                                    static_cast<double>(wanted_pulses), "pulses",
                                    "Y goes to layer " + std::to_string(layer) + " where layer " +
                                        std::to_string(due) + " is due"));
}

Offence too_deep(Axis head, std::int64_t radius_pulses, std::int64_t too_deep_pulses,
                 std::optional<std::uint32_t> layer) {
    return of_axis(head, finding("too-deep", Bound::at_least, static_cast<double>(radius_pulses),
                                 static_cast<double>(radius_pulses + too_deep_pulses), "pulses",
                                 shown_name(head) + " stands deeper than " +
                                     (layer ? "layer " + std::to_string(*layer) : std::string("the job")) +
                                     " asks, off the way between two points"));
}

Offence layers_left_out(std::uint32_t layer, std::uint32_t due) {
    return finding("layers-left-out", Bound::at_most, static_cast<double>(layer), static_cast<double>(due),
                   "layer",
                   "carving begins with layer " + std::to_string(layer) + ", but layer " +
                       std::to_string(due) + " is the first that has not been carved");
}

Offence points_left_out(CarvePoint begin, std::uint32_t carved) {
    return finding("points-left-out", Bound::at_most, static_cast<double>(begin.step),
                   static_cast<double>(carved), "points",
                   "carving begins behind " + std::to_string(begin.step) + " points of layer " +
                       std::to_string(begin.layer) + ", of which " + std::to_string(carved) +
                       " have been carved");
}

Offence nothing_carved(std::uint64_t points_total) {
    return finding("no-carving", Bound::exactly, 0.0, static_cast<double>(points_total), "points",
                   "nothing was carved: the first point is never reached with the spindle on");
}

Offence ends_early(std::uint64_t points, std::uint64_t points_total, const Nearest& nearest) {
    Offence offence =
        finding("ends-early", Bound::exactly, static_cast<double>(points), static_cast<double>(points_total),
                "points", "the carving ends before the job's last point");
    if (const auto alone = nearest.only_axis_off()) {
        offence.axis = alone;
        offence.sentence += ", from which " + shown_name(*alone) + " alone stood " +
                            std::to_string(nearest.most_off) +
                            (nearest.most_off == 1 ? " pulse off" : " pulses off");
    }
    return offence;
}

}  // namespace psicarve::verify
