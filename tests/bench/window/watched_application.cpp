// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/window/watched_application.hpp"

#include <time.h>

#include <QEvent>
#include <QMetaEnum>

#include <algorithm>
#include <utility>

namespace psicarve::context {
namespace {

double now_ms(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
    if (depth_ > 0)
        return event->type() == QEvent::Paint ? paint(receiver, event)
                                              : QApplication::notify(receiver, event);
    ++depth_;
    const char* const event_name = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
    const std::string what =
        std::string{event_name != nullptr ? event_name : "event"} + " " + receiver->metaObject()->className();
    const double wall = now_ms(CLOCK_MONOTONIC);
    const double cpu = now_ms(CLOCK_THREAD_CPUTIME_ID);
    const bool is_done = QApplication::notify(receiver, event);
    turns_.push_back({now_ms(CLOCK_MONOTONIC) - wall, now_ms(CLOCK_THREAD_CPUTIME_ID) - cpu, what});
    --depth_;
    return is_done;
}

bool WatchedApplication::paint(QObject* receiver, QEvent* event) {
    const double wall = now_ms(CLOCK_MONOTONIC);
    const bool is_done = QApplication::notify(receiver, event);
    const QObject* const parent = receiver->parent();
    if (parent != nullptr && parent->objectName() == watched_view_)
        paints_ms_.push_back(now_ms(CLOCK_MONOTONIC) - wall);
    return is_done;
}

std::vector<double> WatchedApplication::take_paints_ms() {
    return std::exchange(paints_ms_, {});
}

bool WatchedApplication::run_until(const std::function<bool()>& condition, double limit_s) {
    const double end_ms = now_ms(CLOCK_MONOTONIC) + limit_s * 1e3;
    while (!condition()) {
        processEvents(QEventLoop::WaitForMoreEvents);
        if (now_ms(CLOCK_MONOTONIC) > end_ms) return false;
    }
    return true;
}

void WatchedApplication::run_for(double seconds) {
    const double end_ms = now_ms(CLOCK_MONOTONIC) + seconds * 1e3;
    run_until([end_ms] { return now_ms(CLOCK_MONOTONIC) > end_ms; });
}

std::vector<Turn> WatchedApplication::take_turns() {
    std::sort(turns_.begin(), turns_.end(),
              [](const Turn& a, const Turn& b) { return a.wall_ms > b.wall_ms; });
    return std::exchange(turns_, {});
}

}  // namespace psicarve::context
