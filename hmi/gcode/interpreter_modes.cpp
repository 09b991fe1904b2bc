// SPDX-License-Identifier: GPL-3.0-or-later
// What holds, for those who look on.
#include <algorithm>
#include <cmath>

#include "hmi/gcode/interpreter.hpp"

namespace psicarve::gcode {
namespace {

constexpr int kInch = 200;
constexpr int kMillimetre = 210;
/// No tool has a larger number.
constexpr double kMostTool = 1e15;

int system_of(std::size_t active) noexcept {
    constexpr std::size_t kPlain = 6;
    return active < kPlain ? 540 + 10 * static_cast<int>(active) : 585 + static_cast<int>(active);
}

int plane_code(const Plane* plane) noexcept {
    return plane == &kPlaneXy ? 170 : (plane == &kPlaneZx ? 180 : 190);
}

int feed_code(FeedMode mode) noexcept {
    return mode == FeedMode::inverse_time ? 930 : (mode == FeedMode::per_minute ? 940 : 950);
}

/// Codes one after the other, the rest unused.
template <std::size_t kCount>
class CodeList {
public:
    explicit CodeList(std::array<std::int16_t, kCount>& codes) noexcept : codes_(codes) { codes_.fill(-1); }
    void add(int code) noexcept {
        if (count_ < kCount) codes_[count_++] = static_cast<std::int16_t>(code);
    }

private:
    std::array<std::int16_t, kCount>& codes_;
    std::size_t count_ = 0;
};

}  // namespace

/// Nearly no block does.
bool Interpreter::may_change_modes() const noexcept {
    for (std::size_t group = 0; group < kCodeGroupCount; ++group) {
        const auto which = static_cast<CodeGroup>(group);
        if (which != CodeGroup::motion && words_.has(which)) return true;
    }
    const int motion = words_.code(CodeGroup::motion);
    return (motion != kNoCode && motion != modes_.motion) ||
           (words_.has('F') && words_.value('F') != modes_.feed_number) ||
           (words_.has('S') && words_.value('S') != modes_.spindle_rpm);
}

/// Before what it holds for. A block that changes modes may give something in between.
void Interpreter::give(const CanonRecord& given) {
    if (mode_report_.is_owed) {
        tell_modes();
        mode_report_.is_owed = mode_report_.is_changing;
    }
    sink_->take(given);
}

void Interpreter::tell_modes() {
    const ActiveModes now = active_modes();
    if (mode_report_.told == now) return;
    mode_report_.told = now;
    sink_->set_modes(now);
}

ActiveModes Interpreter::active_modes() const noexcept {
    ActiveModes made;
    CodeList g{made.g_codes};
    // The moves of a cycle are its own.
    g.add(is_cycle(outcome_.motion) ? outcome_.motion : modes_.motion);
    g.add(plane_code(is_drawing(DrawnMode::none) ? modes_.plane : drawing_.plane_before));
    g.add(modes_.mm_per_unit == 1.0 ? kMillimetre : kInch);
    g.add(modes_.is_incremental ? 910 : 900);
    g.add(feed_code(modes_.feed_mode));
    g.add(system_of(offsets_.active()));
    g.add(modes_.path);
    g.add(400);
    g.add(modes_.length);
    g.add(modes_.retracts_to_start ? 980 : 990);
    g.add(modes_.has_absolute_centres ? 901 : 911);
    g.add(is_drawing(DrawnMode::cylinder) ? 71 : (is_drawing(DrawnMode::polar) ? 121 : 131));
    CodeList m{made.m_codes};
    m.add(!modes_.is_spindle_on ? 5 : (modes_.is_spindle_reverse ? 4 : 3));
    if (modes_.is_mist_on) m.add(7);
    if (modes_.is_flood_on) m.add(8);
    if (!modes_.is_mist_on && !modes_.is_flood_on) m.add(9);
    m.add(modes_.are_overrides_off ? 49 : 48);
    made.feed = modes_.feed_number;
    made.speed_rpm = modes_.spindle_rpm;
    made.tool = static_cast<std::int64_t>(std::clamp(modes_.tool_in_spindle, 0.0, kMostTool));
    made.rotation_deg = offsets_.rotation_deg(offsets_.active());
    made.zero = offsets_.to_machine(Position{});
    return made;
}

}  // namespace psicarve::gcode
