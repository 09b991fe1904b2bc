// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/segment/segment.hpp"
#include "tests/shared/stale_segments.hpp"

namespace psicarve::test {

/// A segment's name that no other test uses; the object is removed at the end, whatever happened.
class SegmentName {
public:
    SegmentName() {
        remove_stale_segments_once();
        static int s_counter = 0;
        name_ = "/" + named_after_this_process(kTestSegmentPrefix) + "-" + std::to_string(s_counter++);
        owner_ = ::getpid();
    }
    ~SegmentName() {
        if (owner_ == ::getpid()) (void)Segment::remove(name_).has_value();
    }
    SegmentName(const SegmentName&) = delete;
    SegmentName& operator=(const SegmentName&) = delete;
    const std::string& get() const noexcept { return name_; }
    /// Room for jobs of up to 500 layers of 500 points.
    SegmentOptions options() const {
        SegmentOptions options;
        options.name = name_;
        options.capacity_layers = 500;
        options.capacity_points = 500;
        return options;
    }

private:
    std::string name_;
    pid_t owner_;
};

/// One segment as an operator's program and a core that has not claimed it see it.
class SegmentOfTwo : public testing::Test {
protected:
    void SetUp() override {
        auto hmi = Segment::create_or_attach(name_.options());
        auto core = Segment::attach(name_.get());
        ASSERT_TRUE(hmi.has_value() && core.has_value());
        hmi_.emplace(std::move(hmi).value());
        core_.emplace(std::move(core).value());
    }
    SegmentName name_;
    std::optional<Segment> hmi_;
    std::optional<Segment> core_;
};

/// A job whose radii all are `mark`: two jobs can be told apart anywhere in their tables.
inline std::vector<std::byte> make_job(std::int32_t mark, std::uint32_t layers = 4,
                                       std::uint32_t points = 5) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    for (std::uint32_t layer = 0; layer < layers; ++layer) table.layer_height_pulses.push_back(layer * 100);
    table.r_left_pulses.assign(std::size_t{layers} * points, mark);
    table.r_right_pulses.assign(std::size_t{layers} * points, mark);
    table.source_name = "test.stl";
    table.profile_toml = "name = \"default\"\n";
    table.report_json = "{}";
    return job_blob_from_table(table);
}

}  // namespace psicarve::test
