// SPDX-License-Identifier: GPL-3.0-or-later
// What a ball tool's pulses leave of meshes that others made: at points taken by chance from a fixed seed the
// tool, shrunk by a pulse all round, must be clear of all facets. Of the code that is judged this takes the
// readers of the mesh and of the trace.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "hmi/model/load_mesh.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/hmi/model/real_meshes.hpp"
#include "tests/hmi/tool/brute_mesh.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/pin_walk.hpp"

namespace psicarve::test {
namespace {

constexpr double kHeight_mm = 12.0;
constexpr double kBall_mm = 2.0;
// Nearer to each other than the ball is wide: Y rises from one to the next between what both ask.
const std::string kLayers = "12";
const std::string kPoints = is_thorough() ? "401" : "101";
constexpr std::size_t kJudgedPoints = 40;  // of each head

struct Carved {
    std::string name;
    RealMesh mesh;
    slice::Up up;
    bool is_compared_by_sanitizers = false;  ///< the map of what differs takes most of the time

    friend void PrintTo(const Carved& carved, std::ostream* out) { *out << carved.mesh.path; }
};

/// Where the tip of a head stands.
struct Tip {
    double radius_mm;
    double direction_rad;
    double height_mm;

    friend std::ostream& operator<<(std::ostream& out, const Tip& tip) {
        return out << "at " << tip.radius_mm << " mm, direction " << tip.direction_rad << ", height "
                   << tip.height_mm;
    }
};

Tip tip_of(const std::array<std::int64_t, kAxisCount>& at_pulses, std::size_t head, const Profile& profile) {
    const auto number = [&at_pulses](std::size_t axis) { return static_cast<double>(at_pulses[axis]); };
    const double turn_rad = 2.0 * kPi * number(2) / static_cast<double>(profile.psi.pulses_per_rev);
    return {number(head) / profile.r1.pulses_per_mm, turn_rad + (head == 0 ? 0.0 : kPi),
            number(3) / profile.y.pulses_per_mm};
}

class RealMeshGouges : public CliTest, public ::testing::WithParamInterface<Carved> {
protected:
    /// From the mesh to its pins, real.job and pins.trace, and how far from it they leave the piece.
    nlohmann::json deviation_of(const std::string& model) const {
        const std::string options = "--height 12 --tool ball:2 --layers " + kLayers + " --points " + kPoints +
                                    (GetParam().up == slice::Up::y ? " --up y" : " --up z");
        std::vector<std::string> slice{"slice", model, "-o", file("real.job")};
        std::vector<std::string> carve{"carve", model, "--segment", segment_, "--trace", file("pins.trace"),
                                       "--json"};
        if (is_compared())
            carve.insert(carve.end(), {"--deviation", file("deviation.png")});
        else
            carve.emplace_back("--no-deviation");
        for (const std::string& word : words_of(options)) {
            slice.push_back(word);
            carve.push_back(word);
        }
        const Outcome sliced = psicarve(slice);
        EXPECT_EQ(sliced.exit_code, 0) << sliced.error;
        const Outcome carved = psicarve(carve);
        EXPECT_EQ(carved.exit_code, 0) << carved.error;
        if (carved.exit_code != 0) return {};
        EXPECT_EQ(carved.json()["max_deviation_pulses"], 0);
        return is_compared() ? carved.json()["deviation"] : nlohmann::json::object();
    }

    static bool is_compared() { return is_thorough() || GetParam().is_compared_by_sanitizers; }

    /// The ball about the same middle, smaller or larger by so much all round: does a facet lift it?
    static bool touches(const model::Mesh& body, double more_mm, const Tip& tip) {
        const ToolProfile ball{ToolShape::ball, kBall_mm + 2.0 * more_mm, 60.0, 0.0};
        const double own_mm = tip.radius_mm - more_mm;
        return brute::tip_mm(body, ball, tip.direction_rad, tip.height_mm, own_mm) > own_mm;
    }
};

/// How far from the axis the body reaches.
double reach_mm(const model::Mesh& body) {
    double reach = 0.0;
    for (const model::Triangle& facet : body.triangles) {
        for (const auto& vertex : facet.vertices)
            reach = std::max(reach, std::hypot(double{vertex[0]}, double{vertex[1]}));
    }
    return reach;
}

TEST_P(RealMeshGouges, AreNoDeeperThanAPulseAtPointsAndThanTheirDistanceBetween) {
    const std::string model = file_of(GetParam().mesh, folder_);
    const nlohmann::json deviation = deviation_of(model);
    ASSERT_TRUE(deviation.is_object());
    const auto mesh = model::load_mesh(model);
    ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
    const model::Mesh body = brute::standing(*mesh, GetParam().up, kHeight_mm);
    const auto snapshot = load_snapshot(file("real.job"));
    ASSERT_TRUE(snapshot.has_value());
    const JobView job = JobView::check(snapshot->job_blob).value();
    const Profile profile = job_profile(job).value();
    const double pulse_mm = 1.0 / profile.r1.pulses_per_mm;
    // A tool that is clear of the model at a point goes no deeper than it is turned from there, a ball
    // further out than at a point is as clear; and the path has its tolerance.
    const double step_rad = kPi / (job.point_count() - 1);
    const double between_mm = pulse_mm + profile.job.path_tolerance_mm + reach_mm(body) * step_rad;

    const auto walk = two_process::walk_of(file("pins.trace"), profile);
    const std::size_t point_count = std::size_t{job.layer_count()} * job.point_count();
    std::mt19937_64 random{4711};
    int resting = 0;
    int judged = 0;
    std::size_t before = 0;
    for (std::size_t k = 0; k < point_count; ++k) {
        const auto layer = static_cast<std::uint32_t>(k / job.point_count());
        const auto point = static_cast<std::uint32_t>(k % job.point_count());
        const std::size_t here = two_process::first_step_at(walk, job, layer, point, before);
        ASSERT_LT(here, walk.steps.size()) << "layer " << layer << " point " << point;
        const bool is_judged = random() % point_count < kJudgedPoints;
        for (std::size_t head = 0; is_judged && head < 2; ++head) {
            const Tip tip = tip_of(walk.positions_pulses[here], head, profile);
            EXPECT_FALSE(touches(body, -pulse_mm, tip)) << tip;
            resting += touches(body, 2.0 * pulse_mm, tip) ? 1 : 0;
            ++judged;
            if (point == 0) continue;
            const Tip on_the_way = tip_of(walk.positions_pulses[(before + here) / 2], head, profile);
            EXPECT_FALSE(touches(body, -between_mm, on_the_way)) << on_the_way;
        }
        before = here;
    }
    EXPECT_GT(judged, 40);
    EXPECT_GT(resting, judged / 3) << "it is to be the mesh that the tool rests on, not the core";
    if (!is_compared()) return;
    // Between the map's cells the model is not known, so that is not to be told apart from a gouge.
    EXPECT_LE(deviation["gouge"]["max_mm"].get<double>(), between_mm + deviation["cell_mm"].get<double>())
        << deviation["gouge"];
    EXPECT_LT(deviation["gouge"]["mean_mm"].get<double>(), pulse_mm) << deviation["gouge"];
}

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealMeshGouges,
    ::testing::Values(Carved{"elephant", of_cgal("refined_elephant.off"), slice::Up::y},
                      Carved{"armadillo", of_cgal("armadillo.off"), slice::Up::y},
                      Carved{"camel", of_cgal("camel.off"), slice::Up::y},
                      Carved{"pig", of_cgal("pig.stl"), slice::Up::z},
                      Carved{"elephant_with_holes", of_cgal("elephant-with-holes.off"), slice::Up::y},
                      Carved{"shark_with_holes", of_cgal("mech-holes-shark.off"), slice::Up::z},
                      Carved{"blob", of_cgal("blobby-shuffled.off"), slice::Up::z, true},
                      Carved{"dragon", of_cgal("ChineseDragon-10kv.off"), slice::Up::y},
                      Carved{"bunny", of_glmark("bunny.obj"), slice::Up::y},
                      Carved{"bearing", of_opencascade("bearing.stl"), slice::Up::z, true},
                      Carved{"propeller", of_opencascade("propeller.stl"), slice::Up::z}),
    [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace psicarve::test
