// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/departure.hpp"

#include <cstdio>
#include <utility>

namespace psicarve::session {
namespace {

constexpr std::chrono::milliseconds kDepartureLook{250};

}  // namespace

Departure::Step Departure::look(Clock::time_point now, const std::vector<SaveUnderWay>& saves) {
    if (saves != before_) last_change_ = now;
    before_ = saves;
    const auto silence = now - last_change_;
    if (saves.empty()) return silence >= kLeave ? Step::leave : Step::wait;
    if (silence >= kGiveUp) return Step::give_up;
    if (has_told_ || now - begin_ < kTell) return Step::wait;
    has_told_ = true;
    return Step::tell;
}

DepartureWatch::DepartureWatch(PendingSaves saves, std::function<void(bool is_lost)> leave)
    : saves_(std::move(saves)), leave_(std::move(leave)), thread_([this] { watch(); }) {}

DepartureWatch::~DepartureWatch() {
    {
        const std::lock_guard lock{mutex_};
        ends_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void DepartureWatch::watch() {
    Departure departure{Departure::Clock::now()};
    std::unique_lock lock{mutex_};
    while (!wake_.wait_for(lock, kDepartureLook, [this] { return ends_; })) {
        const auto saves = saves_.under_way();
        const Departure::Step step = departure.look(Departure::Clock::now(), saves);
        if (step == Departure::Step::tell)
            std::fprintf(stderr, "psicarve-hmi: still being saved: %s; the program ends when that is done\n",
                         paths_of(saves).c_str());
        if (step == Departure::Step::give_up)
            std::fprintf(stderr, "psicarve-hmi: not saved, as the disk does not answer: %s\n",
                         paths_of(saves).c_str());
        if (step == Departure::Step::give_up || step == Departure::Step::leave)
            return leave_(step == Departure::Step::give_up);
    }
}

std::string paths_of(const std::vector<SaveUnderWay>& saves) {
    std::string paths;
    for (const SaveUnderWay& save : saves) paths += (paths.empty() ? "" : ", ") + save.path;
    return paths;
}

}  // namespace psicarve::session
