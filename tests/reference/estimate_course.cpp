// SPDX-License-Identifier: GPL-3.0-or-later
// How the time that is told of a job changes while it is planned bit by bit: of the whole, and of what is
// left from each layer on that has at least a tenth of the job behind it, as a run that is there sees it.
//
//     estimate_course JOB...     the profile is each job's own
//
// Ends with 1 where one of these falls by more than a tenth of what was told before, where less is told than
// is planned, or where what is told first of the whole is off by more than a tenth.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/plan/time_forecast.hpp"
#include "shared/record/snapshot_file.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr double kMostFall = 0.1;
constexpr double kMostOff = 0.1;

/// What was told of some stretch of the job, again and again.
struct Told {
    double last_s = 0.0;
    double greatest_s = 0.0;
    double least_of_greatest = 1.0;  ///< what was told over the greatest told before

    void tell(double seconds) {
        last_s = seconds;
        greatest_s = std::max(greatest_s, seconds);
        least_of_greatest = std::min(least_of_greatest, seconds / greatest_s);
    }
};

struct Course {
    double first_s = 0.0;
    Told whole;
    std::vector<Told> left;  ///< from the begin of each layer
    bool is_below_plan = false;

    std::size_t worst_layer() const {
        const auto worst = std::ranges::min_element(left, {}, &Told::least_of_greatest);
        return static_cast<std::size_t>(worst - left.begin());
    }
};

void tell(Course& course, const plan::JobEstimate& estimate, const JobView& job) {
    const std::uint64_t total = std::uint64_t{job.layer_count()} * job.point_count();
    course.whole.tell(estimate.left(1, total).seconds);
    for (std::uint64_t layer = 0; layer < course.left.size(); ++layer) {
        const std::uint64_t done = std::max<std::uint64_t>(layer * job.point_count(), 1);
        const double left_s = estimate.left(done, total).seconds;
        course.left[layer].tell(left_s);
        // Both are sums of many.
        const double planned_s = estimate.seconds() - estimate.seconds_to(done);
        course.is_below_plan = course.is_below_plan || left_s < planned_s - 1e-9 * estimate.seconds();
    }
}

Course course_of(const plan::MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    plan::JobEstimate estimate;
    plan::TimeForecast forecast(limits, job);
    while (forecast.next()) {
    }
    estimate.forecast(forecast.layer_ends_seconds(), job->point_count());
    Course course;
    course.left.resize(job->layer_count() - (job->layer_count() + 9) / 10 + 1);
    tell(course, estimate, *job);
    course.first_s = course.whole.last_s;
    const auto program = plan::carving_of(limits, job);
    cycle::MotionBlock block{};
    std::uint64_t points = 0;
    for (bool goes_on = true; goes_on;) {
        goes_on = program->next(block);
        plan::PlannedSoFar planned = program->planned();
        if (goes_on && planned.points == points) continue;
        points = planned.points++;
        estimate.add(planned);
        tell(course, estimate, *job);
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
    const std::size_t layer = course.worst_layer();
    const double left_least = course.left[layer].least_of_greatest;
    const double off = course.first_s / course.whole.last_s - 1.0;
    std::printf(
        "%s: planned %.3f s, told first %.3f s (%+.1f %%), fell to %.1f %%; "
        "left fell to %.1f %% (layer %zu)%s\n",
        path, course.whole.last_s, course.first_s, 100.0 * off, 100.0 * course.whole.least_of_greatest,
        100.0 * left_least, layer, course.is_below_plan ? ", less than planned" : "");
    return std::min(course.whole.least_of_greatest, left_least) >= 1.0 - kMostFall && !course.is_below_plan &&
           std::abs(off) <= kMostOff;
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
