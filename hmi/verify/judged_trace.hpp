// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Gives a whole trace to a judge: begin, feed (any number of times), finish. `goes_on` is asked now and
/// then; when it returns false the answer is `cancelled`.
template <typename Judge>
auto judged_trace(Judge& judge, TraceReader& trace, const std::function<bool()>& goes_on)
    -> Result<decltype(judge.finish())> {
    constexpr std::size_t kEventsAtOnce = 1024;
    if (const auto begun = judge.begin(trace.start()); !begun)
        return bad_input(trace.name() + ": " + begun.error().message);
    std::vector<TraceEvent> events(kEventsAtOnce);
    for (;;) {
        if (goes_on && !goes_on()) return Error{ErrorCode::cancelled, "verification was cancelled"};
        auto count = trace.read(events);
        if (!count) return count.error();
        if (*count == 0) return judge.finish();
        judge.feed(std::span(events).first(*count));
    }
}

}  // namespace psicarve::verify
