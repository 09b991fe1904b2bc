// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "shared/profile/profile.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::test {

/// While it lives, programs that are begun without a profile plan as the original did, under ThreadSanitizer:
/// there the look-ahead planner's first horizon takes seconds, on a busy computer as many as a client waits
/// for its answer. For tests of who is interrupted, not of what is planned.
class QuickPlanning {
public:
    /// `path`: where it may write a profile.
    explicit QuickPlanning(const std::string& path) {
        if (!kIsThreadSanitized) return;
        profile_.job.planner = Planner::angle;
        std::ofstream{path} << profile_to_toml(profile_);
        EXPECT_EQ(setenv("PSICARVE_PROFILE", path.c_str(), 1), 0);
    }
    ~QuickPlanning() { setenv("PSICARVE_PROFILE", "", 1); }
    QuickPlanning(const QuickPlanning&) = delete;
    QuickPlanning& operator=(const QuickPlanning&) = delete;

    /// That such a program has.
    const Profile& profile() const { return profile_; }

private:
    Profile profile_;
};

}  // namespace psicarve::test
