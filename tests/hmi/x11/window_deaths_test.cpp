// SPDX-License-Identifier: GPL-3.0-or-later
// One piece; the core, the window and the computer's power are killed at any instant while it is carved. An
// operator follows what the window says, and the piece is that of an undisturbed carving.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/x11/x11_rig.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/carved_trace.hpp"

namespace psicarve {
namespace {

namespace fs = std::filesystem;
using S = MachineState;

enum class Death : std::uint8_t { core, window, power };

/// From the death before to the next: it is carved meanwhile.
constexpr std::uint32_t kLayersBetween = 150;
constexpr std::uint32_t kDeathPoints = 101;
/// The end of a trace is lost with its core: no more than so many layers of this job.
constexpr std::uint32_t kUnwrittenLayers = 40;

class DeathsOfAPiece : public test::X11Rig {
protected:
    /// Where what a trace has lost cannot be seen: layers from .first to before .second.
    using Gap = std::pair<std::uint32_t, std::uint32_t>;

    std::string state() const { return file("state"); }
    StateNames names() const { return {state(), segment_name_, true}; }
    Checkpoint checkpoint() const {
        return read_record(segment_->header().checkpoint).value_or(Checkpoint{});
    }
    std::uint32_t layer_on_disk() const {
        const auto saved = load_saved_checkpoint(names().checkpoint());
        return saved ? saved->checkpoint.next_layer : 0;
    }
    void start_traced_core() {
        traces_.push_back(file("core_" + std::to_string(traces_.size()) + ".trace"));
        start_core({"--state", state(), "--trace", traces_.back()});
    }
    void open_window_on_it() { open_window({"--state", state()}); }
    void kill_core() {
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
    }
    bool is_carved_up_to(std::uint32_t layer) {
        return eventually([&] { return checkpoint().next_layer >= layer; });
    }

    /// As the window says it, after a restart of the core.
    void home_by_window() {
        ASSERT_TRUE(says("text state_pill", "IDLE"));
        // It may die on its way home, too.
        if (random_() % 3 == 0) {
            ASSERT_TRUE(click("home"));
            kill_core();
            ASSERT_TRUE(says("text state_pill", "NO CORE"));
            traces_.pop_back();  // it carves nothing: only what stands there is of no use
            start_traced_core();
            ASSERT_TRUE(says("text state_pill", "IDLE"));
        }
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(reaches(S::ready));
    }
    /// With the layer that the button names. Where a disk alone knows of it the window asks: also after a
    /// core's death, if that was quicker than the disk.
    void go_on_by_window() {
        const bool asks = checkpoint().is_from_disk();
        const std::uint32_t layer = checkpoint().next_layer;
        std::string words = "Continue from layer " + std::to_string(layer + 1);
        const auto point = point_to_resume(segment_->header().reached_point.load(), checkpoint());
        if (point) words += ", point " + std::to_string(*point + 1);
        ASSERT_TRUE(click("tab 2"));
        ASSERT_TRUE(says("text start", words));
        ASSERT_TRUE(click("start"));
        if (asks) {
            ASSERT_TRUE(says("modal", "Go on with an unfinished piece"));
            take_picture("deaths_asked");
            ASSERT_TRUE(click("dialog " + words));
        }
        const bool goes_on = eventually([&] { return checkpoint().next_layer > layer; });
        if (!goes_on) take_picture("failed");
        ASSERT_TRUE(goes_on) << "from layer " << layer << "; " << pill();
    }

    /// The core writes the checkpoint, then the status: a status that comes after it has all of its points.
    /// Between the two a core may die, and its last status then says less than its checkpoint.
    void expect_checkpoint_of_what_is_carved() {
        const std::uint32_t layer = checkpoint().next_layer;
        const std::uint64_t before = status().heartbeat;
        ASSERT_TRUE(eventually([&] { return status().heartbeat > before; }));
        EXPECT_LE(layer, status().points_done / kDeathPoints) << "more than was carved";
    }
    void core_dies() {
        expect_checkpoint_of_what_is_carved();
        kill_core();
        const std::uint32_t layer = checkpoint().next_layer;
        gaps_.emplace_back(layer - std::min(layer, kUnwrittenLayers), layer);
        // It goes on within that layer; what came before that point was perhaps not written either.
        if (const auto point = point_to_resume(segment_->header().reached_point.load(), checkpoint()))
            begun_within_[layer] = *point;
        ASSERT_TRUE(says("text state_pill", "NO CORE"));
        start_traced_core();
        ASSERT_NO_FATAL_FAILURE(home_by_window());
        ASSERT_NO_FATAL_FAILURE(go_on_by_window());
    }
    /// The machine does not notice.
    void window_dies() {
        window_->kill_now();
        ASSERT_TRUE(is_carved_up_to(checkpoint().next_layer + 5));
        // It is slower than the machine, and the operator holds it meanwhile.
        ASSERT_EQ(refusal_of(CommandKind::hold), "");
        open_window_on_it();
        ASSERT_TRUE(says("text state_pill", "HELD"));
        ASSERT_TRUE(click("tab 2"));
        ASSERT_TRUE(click("resume"));
        EXPECT_EQ(status().alarm_count, 0U);
    }
    /// Everything loses its power, and the disk has what it had some layers ago: what was carved since is
    /// carved again.
    void power_dies() {
        ASSERT_TRUE(eventually([&] { return layer_on_disk() != 0 && fs::exists(copy_of_job()); }));
        copy_disk();
        const std::uint32_t kept = layer_on_disk();
        ASSERT_TRUE(is_carved_up_to(kept + kUnwrittenLayers));
        window_->kill_now();
        kill_core();
        segment_.reset();
        ASSERT_TRUE(Segment::remove(segment_name_));
        fs::remove_all(state());
        fs::rename(file("disk"), state());
        start_traced_core();
        open_window_on_it();
        // With the bar, all below it takes its place.
        ASSERT_TRUE(says("where unfinished_open", " ready"));
        ASSERT_TRUE(click("tab 0"));
        ASSERT_TRUE(click("unfinished_open"));
        ASSERT_TRUE(click("publish"));
        ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
        EXPECT_EQ(checkpoint().next_layer, layer_on_disk());
        EXPECT_LE(layer_on_disk(), kept);
        ASSERT_NO_FATAL_FAILURE(home_by_window());
        ASSERT_NO_FATAL_FAILURE(go_on_by_window());
    }
    std::string copy_of_job() const { return names().job(job_checksum(blob_)); }
    /// The job first: what is written meanwhile is never older than the copy says.
    void copy_disk() const {
        fs::create_directory(file("disk"));
        for (const std::string& name : {names().checkpoint(), copy_of_job()})
            fs::copy_file(name, fs::path{file("disk")} / fs::path{name}.filename());
    }

    void die(Death death) {
        ++deaths_;
        switch (death) {
            case Death::core:
                return core_dies();
            case Death::window:
                return window_dies();
            case Death::power:
                return power_dies();
        }
    }
    std::vector<Death> deaths_to_die() {
        // Each of them once, in any order, and then more.
        std::vector<Death> deaths{Death::core, Death::window, Death::power};
        std::shuffle(deaths.begin(), deaths.end(), random_);
        const int more = test::is_long_run() ? 15 : 1;
        for (int i = 0; i < more; ++i) deaths.push_back(static_cast<Death>(random_() % 3));
        return deaths;
    }
    /// What all cores together have carved.
    std::vector<float> carved(const std::vector<two_process::Carved>& parts, std::uint32_t layer) const {
        std::vector<float> least = parts.front().layer(layer);
        for (const auto& part : parts) {
            const auto radii = part.layer(layer);
            for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], radii[i]);
        }
        return least;
    }
    bool is_in_gap(std::uint32_t layer) const {
        return std::any_of(gaps_.begin(), gaps_.end(),
                           [&](const Gap& gap) { return gap.first <= layer && layer < gap.second; });
    }
    static std::uint32_t alike_cells(const std::vector<float>& radii, const std::vector<float>& wanted) {
        std::uint32_t alike = 0;
        for (std::size_t k = 0; k < radii.size(); ++k) alike += radii[k] == wanted[k] ? 1 : 0;
        return alike;
    }
    void carve_undisturbed(const std::string& trace) {
        start_core({"--trace", trace});
        ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
        home();
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
    }

    std::minstd_rand random_{20261127};
    std::vector<std::byte> blob_;
    std::vector<std::string> traces_;
    std::vector<Gap> gaps_;
    std::map<std::uint32_t, std::uint32_t> begun_within_;  ///< point by layer
    int deaths_ = 0;
};

TEST_F(DeathsOfAPiece, LeaveThePieceThatAnUndisturbedRunCarves) {
    const std::vector<Death> deaths = deaths_to_die();
    const auto layers = static_cast<std::uint32_t>(deaths.size() + 2) * kLayersBetween;
    const JobTable table = two_process::lobed_job(layers, kDeathPoints);
    blob_ = job_blob_from_table(table);
    start_traced_core();
    ASSERT_EQ(publish(table), "");
    open_window_on_it();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(reaches(S::ready));
    ASSERT_TRUE(click("tab 2"));
    ASSERT_TRUE(says("text start", "Start"));
    ASSERT_TRUE(click("start"));
    for (const Death death : deaths) {
        const auto layer = checkpoint().next_layer + 10 + random_() % (kLayersBetween / 3);
        ASSERT_TRUE(is_carved_up_to(static_cast<std::uint32_t>(layer))) << pill();
        ASSERT_NO_FATAL_FAILURE(die(death)) << "death " << deaths_ << " of kind " << static_cast<int>(death);
        ASSERT_LT(checkpoint().next_layer, layers) << "carved before death " << deaths_ + 1;
    }
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; })) << pill();
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == layers; }));
    ASSERT_TRUE(says("text state_pill", "READY"));
    window_->kill_now();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    ASSERT_NO_FATAL_FAILURE(carve_undisturbed(file("whole.trace")));

    std::vector<two_process::Carved> parts;
    for (const std::string& trace : traces_) parts.emplace_back(blob_, trace);
    const two_process::Carved whole{blob_, file("whole.trace")};
    std::uint32_t seen = 0;
    for (std::uint32_t i = 0; i < layers; ++i) {
        const auto radii = carved(parts, i);
        const auto wanted = whole.layer(i);
        if (radii == wanted) {
            ++seen;
            continue;
        }
        const auto within = begun_within_.find(i);
        ASSERT_TRUE(is_in_gap(i) || within != begun_within_.end())
            << "layer " << i << " of " << layers << " is another";
        if (within != begun_within_.end()) {
            // Both heads have gone from there to the layer's end.
            const std::uint32_t points = kDeathPoints - within->second;
            EXPECT_GE(alike_cells(radii, wanted), 2 * (points - 1)) << "layer " << i;
        }
        for (std::size_t k = 0; k < radii.size(); ++k) ASSERT_GE(radii[k], wanted[k]) << "layer " << i;
    }
    RecordProperty("layers", static_cast<int>(layers));
    RecordProperty("layers_seen", static_cast<int>(seen));
}

}  // namespace
}  // namespace psicarve
