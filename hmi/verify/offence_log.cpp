// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/offence_log.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

std::string place_text(const CarvePlace& place) {
    std::string text;
    if (place.layer) text += " in layer " + std::to_string(*place.layer);
    if (place.point) text += " at point " + std::to_string(*place.point);
    if (place.pass != nullptr) text += " of the " + pass_name(*place.pass);
    if (place.line) text += " in line " + std::to_string(*place.line);
    return text;
}

std::string time_text(std::int64_t time_ns) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.9f s", seconds_from_ns(time_ns));
    return text.data();
}

}  // namespace

std::string shown_name(Axis axis) {
    switch (axis) {
        case Axis::r1:
            return "R1";
        case Axis::r2:
            return "R2";
        case Axis::psi:
            return "psi";
        case Axis::y:
            return "Y";
    }
    return "?";
}

std::string shown_number(double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

namespace {
const char* word_of(Bound bound) {
    return bound == Bound::at_most ? "allowed" : bound == Bound::at_least ? "needed" : "expected";
}
}  // namespace

void OffenceLog::describe(Offence offence, const CarvePlace& place) {
    offence.layer = place.layer;
    offence.point = place.point;
    offence.line = place.line;
    if (place.pass != nullptr) offence.pass = pass_name(*place.pass);
    offence.sentence = "rule " + std::to_string(offence.rule) + ": " + offence.sentence + place_text(place) +
                       ", " + time_text(offence.time_ns) + ": " + shown_number(offence.measured) + " " +
                       offence.unit + " measured, " + shown_number(offence.allowed) + " " + offence.unit +
                       " " + word_of(offence.bound);
    rules_[static_cast<std::size_t>(offence.rule) - 1].first = std::move(offence);
}

}  // namespace psicarve::verify
