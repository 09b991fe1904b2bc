// SPDX-License-Identifier: GPL-3.0-or-later
// How the time that is told of a job changes while it is planned bit by bit, as a run that has already begun
// sees it: elapsed and left together, from the first that is told on.
//
//     estimate_course JOB...     the profile is each job's own
//
// Ends with 1 where that falls by more than a tenth of what was told before, where less is told than is
// planned, or where what is told first is off by more than a tenth.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/plan/time_forecast.hpp"
#include "shared/snapshot_file.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr double kMostFall = 0.1;
constexpr double kMostOff = 0.1;

struct Course {
    double first_s = 0.0;
    double last_s = 0.0;
    double greatest_s = 0.0;
    double least_of_greatest = 1.0;  ///< what was told over the greatest told before
    bool is_below_plan = false;
};

Course course_of(const plan::MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    const std::uint64_t total = std::uint64_t{job->layer_count()} * job->point_count();
    plan::JobEstimate estimate;
    plan::TimeForecast forecast(limits, job);
    while (forecast.next()) {
    }
    estimate.forecast(forecast.layer_ends_seconds(), job->point_count());
    Course course;
    course.first_s = estimate.left(1, total).seconds;
    const auto program = plan::carving_of(limits, job);
    cycle::MotionBlock block{};
    std::uint64_t points = 0;
    for (bool goes_on = true; goes_on;) {
        goes_on = program->next(block);
        plan::PlannedSoFar planned = program->planned();
        if (goes_on && planned.points == points) continue;
        points = planned.points++;
        estimate.add(planned);
        // Wherever the carving is in what is planned, it got there in the time planned.
        for (const std::uint64_t done : {std::uint64_t{1}, estimate.points() / 2, estimate.points()}) {
            course.last_s = estimate.seconds_to(done) + estimate.left(done, total).seconds;
            course.greatest_s = std::max({course.greatest_s, course.first_s, course.last_s});
            course.least_of_greatest = std::min(course.least_of_greatest, course.last_s / course.greatest_s);
            course.is_below_plan = course.is_below_plan || course.last_s < estimate.seconds() * (1.0 - 1e-12);
        }
    }
    return course;
}

Result<bool> is_good(const char* path) {
    const auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    const auto view = JobView::check(snapshot.value().job_blob);
    if (!view) return view.error();
    const auto profile = job_profile(view.value());
    if (!profile) return profile.error();
    const auto job = std::make_shared<const JobView>(view.value());
    const Course course = course_of(plan::limits_for(plan::machine_limits(profile.value()), *job), job);
    std::printf("%s: planned %.3f s, told first %.3f s (%+.1f %%), at most %.3f s, fell to %.1f %%%s\n", path,
                course.last_s, course.first_s, 100.0 * (course.first_s / course.last_s - 1.0),
                course.greatest_s, 100.0 * course.least_of_greatest,
                course.is_below_plan ? ", less than planned" : "");
    const bool is_near = std::abs(course.first_s - course.last_s) <= kMostOff * course.last_s;
    return course.least_of_greatest >= 1.0 - kMostFall && !course.is_below_plan && is_near;
}

}  // namespace

int main(int argc, char** argv) {
    bool all_are_good = argc > 1;
    for (int i = 1; i < argc; ++i) {
        const auto good = is_good(argv[i]);
        if (!good) std::fprintf(stderr, "%s: %s\n", argv[i], good.error().message.c_str());
        all_are_good = all_are_good && good && *good;
    }
    return all_are_good ? 0 : 1;
}
