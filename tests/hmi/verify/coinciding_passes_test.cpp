// SPDX-License-Identifier: GPL-3.0-or-later
// Roughing without an allowance: where it leaves nothing, layers of two passes begin at the same place.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kRoughedPoints = 21;
constexpr std::int64_t kOutside_pulses = 4400;  ///< of the blank

struct Roughed {
    std::uint32_t layers;
    std::uint32_t finished;  ///< layers
    bool leaves;             ///< 2 mm, but at the layers' ends
    std::uint32_t layer_count() const noexcept { return layers + finished; }
};
constexpr Roughed kAllRoughed[] = {{2, 2, false}, {2, 2, true}, {2, 4, true}, {3, 2, true}};

SampleJob roughed_job(const Roughed& roughed) {
    const std::uint32_t roughing_layers = roughed.layers;
    const std::uint32_t layers = roughed.layer_count();
    SampleJob job(Profile{}, layers, kRoughedPoints, Joining::continuous, [](double, double) { return 8.0; });
    const JobView view = job.view();
    JobTable table;
    table.layer_count = layers;
    table.point_count = kRoughedPoints;
    table.psi_sweep_pulses = view.psi_sweep_pulses();
    table.joining = Joining::continuous;
    table.feed_mm_s = job.profile.job.feed_mm_s;
    table.source_name = "roughed.stl";
    table.profile_toml = profile_to_toml(job.profile);
    table.report_json = "{}";
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        const bool is_roughing = layer < roughing_layers;
        table.layer_height_pulses.push_back(
            100 + 80 * static_cast<std::int32_t>(is_roughing ? layer : layer - roughing_layers));
        for (std::uint32_t point = 0; point < kRoughedPoints; ++point) {
            const bool is_end = point == 0 || point + 1 == kRoughedPoints;
            const std::int32_t radius = is_roughing && roughed.leaves && !is_end ? 4000 : 3200;
            table.r_left_pulses.push_back(radius);
            table.r_right_pulses.push_back(radius);
        }
    }
    JobPass roughing{};
    roughing.kind = static_cast<std::uint32_t>(PassKind::roughing);
    roughing.number = 1;
    roughing.layer_count = roughing_layers;
    JobPass finishing{};
    finishing.kind = static_cast<std::uint32_t>(PassKind::finishing);
    finishing.number = 2;
    finishing.first_layer = roughing_layers;
    finishing.layer_count = roughed.finished;
    table.passes = {roughing, finishing};
    job.blob = job_blob_from_table(table);
    return job;
}

/// Each layer from outside, with the spindle on all along. `wrong`: the layer in which R1 leaves its line.
PerfectMachine carved(const SampleJob& job, std::optional<std::uint32_t> wrong = {}) {
    const JobView view = job.view();
    PerfectMachine machine(job);
    machine.start.position_pulses = machine.position = {kOutside_pulses, kOutside_pulses, 0, 0};
    for (const Axis axis : kAllAxes) machine.set(enable_of(axis), true);
    for (std::uint32_t layer = 0; layer < view.layer_count(); ++layer) {
        machine.line({kOutside_pulses - machine.position[0], kOutside_pulses - machine.position[1], 0, 0});
        machine.move(Axis::psi, view.psi_pulses(layer, 0) - machine.position[2]);
        machine.move(Axis::y, view.y_pulses(layer, 0) - machine.position[3]);
        machine.set(Signal::spindle, true);
        machine.line({view.r_left_pulses(layer)[0] - machine.position[0],
                      view.r_right_pulses(layer)[0] - machine.position[1], 0, 0});
        for (std::uint32_t step = 1; step < kRoughedPoints; ++step) {
            machine.to_point(layer, step);
            if (wrong != layer || step != 7) continue;
            machine.line({0, 0, 40, 0});
            machine.move(Axis::r1, -60).move(Axis::r1, 60);
        }
    }
    return machine.finish();
}

std::vector<LayerRange> parts_of(std::uint32_t layers) {
    std::vector<LayerRange> parts;
    for (std::uint32_t first = 0; first < layers; ++first)
        for (std::uint32_t count = 1; first + count <= layers; ++count) parts.push_back({first, count, {}});
    return parts;
}

std::string named(const Roughed& roughed, const LayerRange& part) {
    return std::to_string(roughed.layers) + " before " + std::to_string(roughed.finished) +
           (roughed.leaves ? " that leave" : " that leave nothing") + ", from " + std::to_string(part.first) +
           ": " + std::to_string(part.count) + "\n";
}

TEST(CoincidingPasses, AreRightInEveryPart) {
    for (const Roughed& roughed : kAllRoughed) {
        const SampleJob job = roughed_job(roughed);
        const PerfectMachine machine = carved(job);
        for (const LayerRange& part : parts_of(roughed.layer_count())) {
            const VerifyReport report = verified(job, machine, part);
            EXPECT_TRUE(report.ok) << named(roughed, part) << report_text(report);
        }
    }
}

TEST(CoincidingPasses, AreWrongInThePartThatIs) {
    for (const Roughed& roughed : kAllRoughed) {
        const SampleJob job = roughed_job(roughed);
        for (std::uint32_t wrong = 0; wrong < roughed.layer_count(); ++wrong) {
            const PerfectMachine machine = carved(job, wrong);
            for (const LayerRange& part : parts_of(roughed.layer_count())) {
                const bool is_in = wrong >= part.first && wrong < part.first + part.count;
                const VerifyReport report = verified(job, machine, part);
                EXPECT_EQ(report.ok, !is_in)
                    << "wrong " << wrong << " of " << named(roughed, part) << report_text(report);
            }
        }
    }
}

}  // namespace
}  // namespace psicarve::verify
