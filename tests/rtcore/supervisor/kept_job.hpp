// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "rtcore/job/loaded_job.hpp"
#include "tests/shared/job_fixture.hpp"

namespace psicarve::supervisor::test {

/// A small job for a ball, as a core has it in its hands.
inline std::shared_ptr<const LoadedJob> job_called(const std::string& name, std::uint64_t generation = 1) {
    Profile machine;
    machine.tool.shape = ToolShape::ball;
    JobTable table = small_job(machine);
    table.source_name = name;
    auto job = load_job(job_blob_from_table(table), generation, machine);
    EXPECT_TRUE(job) << (job ? "" : job.error().message);
    return job ? *job : nullptr;
}

}  // namespace psicarve::supervisor::test
