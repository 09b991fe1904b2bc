// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/verifier.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::two_process {

/// The piece as a trace's pins carve it; one that breaks off, too.
class Carved {
public:
    Carved(const std::vector<std::byte>& blob, const std::string& trace_path)
        : job_(JobView::check(blob).value()), verifier_(verify::Verifier::make(job_, Profile{}).value()) {
        auto trace = verify::open_trace(trace_path);
        EXPECT_TRUE(trace.has_value()) << trace_path;
        if (!trace) return;
        EXPECT_TRUE(verifier_.begin((*trace)->start()).has_value());
        std::array<verify::TraceEvent, 1024> events;
        for (;;) {
            const auto count = (*trace)->read(events);
            if (!count || *count == 0) return;
            verifier_.feed(std::span{events}.first(*count));
        }
    }
    std::vector<float> layer(std::uint32_t number) const {
        const auto radii = verifier_.surface().radii_mm(number);
        return {radii.begin(), radii.end()};
    }

private:
    JobView job_;
    verify::Verifier verifier_;
};

}  // namespace psicarve::two_process
