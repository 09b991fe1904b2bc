// SPDX-License-Identifier: GPL-3.0-or-later
// How the cost of making a job grows with triangles, layers and points: processor time on one thread and peak
// memory, each figure of a process of its own, as CSV. plot_growth.py draws it.
//   bench_growth > growth.csv
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/piece/expected_piece.hpp"
#include "hmi/rough/roughing.hpp"
#include "rtcore/plan/lookahead_program.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

struct Size {
    std::size_t triangles = 100'000;
    std::uint32_t layers = 500;
    std::uint32_t points = 500;
};

constexpr double kBlank_mm = 24.0;
constexpr std::size_t kColumns = 720;  // of the piece to be expected, as psicarve estimate has it

Profile profile_with(ToolShape shape) {
    Profile profile;
    profile.tool = {shape, 3.0, 60.0, 0.0};
    profile.blank.radius_mm = kBlank_mm;
    return profile;
}

JobTable job_of(const Size& size, const model::Mesh& mesh, const Profile& profile) {
    cam::JobOptions options;
    options.layer_count = size.layers;
    options.point_count = size.points;
    auto job = cam::build_job(mesh, profile, options);
    if (job) return std::move(job->table);
    std::fprintf(stderr, "%s\n", job.error().message.c_str());
    std::exit(1);
}

/// A stage prepares what it needs and returns what itself took [s].
using Stage = double (*)(const Size&);

double sliced_with(ToolShape shape, const Size& size) {
    const model::Mesh mesh = bench::relief_mesh(size.triangles);
    const double begin_s = bench::cpu_s();
    job_of(size, mesh, profile_with(shape));
    return bench::cpu_s() - begin_s;
}

double slice_point(const Size& size) {
    return sliced_with(ToolShape::point, size);
}

double slice_ball(const Size& size) {
    return sliced_with(ToolShape::ball, size);
}

/// The later stages are the same whatever the tips' radii are: a point's are there soonest.
double rough_ball(const Size& size) {
    JobTable table = job_of(size, bench::relief_mesh(size.triangles), profile_with(ToolShape::point));
    const JobTable level = table;
    const double begin_s = bench::cpu_s();
    const auto done = rough::add_roughing(table, level, profile_with(ToolShape::ball), {4.0, 0.3, {}});
    if (!done) std::exit(1);
    return bench::cpu_s() - begin_s;
}

double plan_job(const Size& size) {
    const Profile profile = profile_with(ToolShape::point);
    const auto blob = job_blob_from_table(job_of(size, bench::relief_mesh(size.triangles), profile));
    const auto job = std::make_shared<const JobView>(JobView::check(blob).value());
    const double begin_s = bench::cpu_s();
    plan::LookaheadProgram program(plan::machine_limits(profile), job);
    cycle::MotionBlock block{};
    while (program.next(block)) continue;
    return bench::cpu_s() - begin_s;
}

double expect_piece(const Size& size) {
    const auto blob =
        job_blob_from_table(job_of(size, bench::relief_mesh(size.triangles), profile_with(ToolShape::point)));
    const Profile ball = profile_with(ToolShape::ball);
    const auto geometry = verify::JobGeometry::make(JobView::check(blob).value(), ball);
    if (!geometry) std::exit(1);
    const double begin_s = bench::cpu_s();
    piece::expected_piece(*geometry, ball, kColumns);
    return bench::cpu_s() - begin_s;
}

struct NamedStage {
    const char* name;
    Stage stage;
};
constexpr std::array kStages{NamedStage{"slice", slice_point}, NamedStage{"ball", slice_ball},
                             NamedStage{"rough", rough_ball}, NamedStage{"plan", plan_job},
                             NamedStage{"preview", expect_piece}};

/// In a process of its own, which begins as small as this one.
bool measure(const char* sweep, std::size_t value, const Size& size, const NamedStage& stage) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const double seconds = stage.stage(size);
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        std::printf("%s,%zu,%s,%.4f,%.1f\n", sweep, value, stage.name, seconds,
                    static_cast<double>(usage.ru_maxrss) / 1024.0);
        std::fflush(stdout);
        _exit(0);
    }
    int status = 0;
    return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

}  // namespace

int main() {
    bool is_good = true;
    const auto sweep = [&is_good](const char* name, const std::vector<std::size_t>& values,
                                  const std::function<void(Size&, std::size_t)>& set) {
        for (const std::size_t value : values) {
            Size size;
            set(size, value);
            for (const NamedStage& stage : kStages) is_good = measure(name, value, size, stage) && is_good;
        }
    };
    std::printf("sweep,value,stage,cpu_s,peak_mb\n");
    sweep("triangles", {10'000, 30'000, 100'000, 300'000, 1'000'000},
          [](Size& size, std::size_t value) { size.triangles = value; });
    sweep("layers", {125, 250, 500, 1000, 2000, 4000},
          [](Size& size, std::size_t value) { size.layers = static_cast<std::uint32_t>(value); });
    sweep("points", {125, 250, 500, 1000, 2000, 3000},
          [](Size& size, std::size_t value) { size.points = static_cast<std::uint32_t>(value); });
    return is_good ? 0 : 1;
}
