// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/pin_looks.hpp"

#include <algorithm>

namespace psicarve::replay {
namespace {

using session::LevelHistory;

constexpr std::int64_t kPause_ns = 20'000'000;
constexpr std::int64_t kLength_ns = std::chrono::nanoseconds{LevelHistory::kLength}.count();
/// Directions turn hundreds of times a second and are seen at the next look.
constexpr SignalWord kSeldom = ~(kStepMask | kDirMask);

/// Adds a sample of the state after everything up to and with this time, calculated from the moment before.
void add_look(PinLooks::Looks& looks, const PinMoment& last, std::int64_t time_ns, const PinMoment& moment) {
    if (looks.empty() || looks.back().time < PinLooks::time_point(time_ns))
        looks.push_back({PinLooks::time_point(time_ns), 0, {}});
    LevelHistory::Look& look = looks.back();
    look.levels = moment.levels;
    for (std::size_t k = 0; k < kAxisCount; ++k) look.pulses[k] += moment.pulses[k] - last.pulses[k];
}

}  // namespace

Result<void> PinLooks::begin_at(std::int64_t time_ns) {
    auto moment = cursor_.at(time_ns);
    if (!moment) return moment.error();
    looks_.clear();
    last_ = *moment;
    look(time_ns, last_);
    next_look_ns_ = time_ns + kPause_ns;
    has_begun_ = true;
    return {};
}

void PinLooks::look(std::int64_t time_ns, const PinMoment& moment) {
    add_look(looks_, last_, time_ns, moment);
    last_ = moment;
}

Result<PinLooks::Looks> PinLooks::until(std::int64_t time_ns) {
    const std::int64_t from_ns = std::max<std::int64_t>(time_ns - kLength_ns, 0);
    const bool goes_on = has_begun_ && cursor_.position_ns() <= time_ns && cursor_.position_ns() >= from_ns;
    if (!goes_on) {
        if (const auto begun = begin_at(from_ns); !begun) return begun.error();
    }
    const auto visit = [this](const PinMoment& before, const PinMoment& after) {
        while (next_look_ns_ < after.time_ns) {
            look(next_look_ns_, before);
            next_look_ns_ += kPause_ns;
        }
        if (((before.levels ^ after.levels) & kSeldom) != 0) look(after.time_ns, after);
    };
    const auto now = cursor_.go_on(time_ns, visit);
    if (!now) return now.error();
    for (; next_look_ns_ <= time_ns; next_look_ns_ += kPause_ns) look(next_look_ns_, *now);
    while (looks_.size() > 2 && looks_[1].time < time_point(from_ns)) looks_.pop_front();
    Looks shown = looks_;
    add_look(shown, last_, time_ns, *now);
    return shown;
}

}  // namespace psicarve::replay
