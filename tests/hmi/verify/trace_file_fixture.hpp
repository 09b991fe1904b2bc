// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {

struct ReadTrace {
    TraceStart start;
    std::vector<TraceEvent> events;
    std::string error;
};

inline ReadTrace read_all(Result<std::unique_ptr<TraceReader>> reader, std::size_t at_once = 64) {
    ReadTrace read;
    if (!reader) {
        read.error = reader.error().message;
        return read;
    }
    read.start = (*reader)->start();
    std::vector<TraceEvent> some(at_once);
    for (;;) {
        auto count = (*reader)->read(some);
        if (!count) read.error = count.error().message;
        if (!count || *count == 0) return read;
        read.events.insert(read.events.end(), some.begin(),
                           some.begin() + static_cast<std::ptrdiff_t>(*count));
    }
}

class TraceFile : public testing::Test {
protected:
    ~TraceFile() override { ::unlink(path_.c_str()); }

    ReadTrace read(const std::string& bytes, std::size_t at_once = 64) {
        std::ofstream(path_, std::ios::binary) << bytes;
        return read_all(open_trace(path_), at_once);
    }

    std::string path_ = testing::TempDir() + "psicarve_trace_" + std::to_string(::getpid());
};

inline void expect_equal(const ReadTrace& read, const PerfectMachine& machine) {
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(read.start.initial_levels, machine.start.initial_levels);
    EXPECT_EQ(read.start.position_pulses, machine.start.position_pulses);
    ASSERT_GE(read.events.size(), machine.events.size());
    for (std::size_t n = 0; n < machine.events.size(); ++n) {
        ASSERT_EQ(read.events[n].time_ns, machine.events[n].time_ns) << n;
        ASSERT_EQ(read.events[n].levels, machine.events[n].levels) << n;
        ASSERT_EQ(read.events[n].kind, machine.events[n].kind) << n;
        ASSERT_EQ(read.events[n].position_pulses, machine.events[n].position_pulses) << n;
    }
}

class WholeTrace : public TraceFile {
protected:
    WholeTrace() { machine_.define_positions({24000, 24000, -5, 0}).carve_job(); }

    SampleJob job_ = wavy_job();
    PerfectMachine machine_{job_};
};

}  // namespace psicarve::verify
