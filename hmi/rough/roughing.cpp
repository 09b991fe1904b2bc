// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/roughing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/rough/pass_planner.hpp"
#include "hmi/rough/rings.hpp"
#include "hmi/rough/rough_stock.hpp"

namespace psicarve::rough {
namespace {

// Of the tool's diameter, where the user gives none.
constexpr double kFlatStepover = 0.75;
constexpr double kBallStepover = 0.5;
constexpr double kVeeStepover = 0.25;
constexpr double kMost_mm = 10'000.0;  // as the profile's keys

std::string length_text(double value_mm) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.6g mm", value_mm);
    return text.data();
}

Error wrong_use(const std::string& what) {
    return Error{ErrorCode::bad_usage, what};
}

/// The radius that no material exceeds: the blank's surface, and the model's where that stands out of it.
/// Heads that change their halves round it outwards once more.
double furthest_material_mm(const JobTable& table, const Rings& rings, double blank_mm) {
    const auto most = [](const std::vector<std::int32_t>& radii) {
        return *std::max_element(radii.begin(), radii.end());
    };
    const RoughHead& left = rings.head(0);
    const RoughHead& right = rings.head(1);
    const double most_mm = std::max(
        {blank_mm, left.real_mm(most(table.r_left_pulses)), right.real_mm(most(table.r_right_pulses))});
    return most_mm + 1.0 / std::min(left.pulses_per_mm, right.pulses_per_mm);
}

/// The passes in front of a table's own layers.
class Assembly {
public:
    Assembly(JobTable& table, const Rings& rings, const Profile& profile, double clear_mm,
             double allowance_mm)
        : table_(table),
          rings_(rings),
          clear_mm_(clear_mm),
          allowance_mm_(allowance_mm),
          out_s_per_mm_(std::max(1.0 / profile.r1.speed_mm_s, 1.0 / profile.r2.speed_mm_s)),
          in_s_per_mm_(std::max(out_s_per_mm_, 1.0 / profile.job.plunge_mm_s)) {}

    std::size_t layer_count() const noexcept { return heights_.size(); }
    void add(const RoughPass& pass, std::uint32_t number) {
        add_entry(pass.depth_mm, number, pass.layers.size());
        for (const RoughLayer& layer : pass.layers) add_layer(layer);
    }
    void add_idle(const RoughLayer& layer, double depth_mm, std::uint32_t number) {
        add_entry(depth_mm, number, 1);
        add_layer(layer);
    }
    /// Whether each head reaches as far out as the other one does in the table's own layers.
    bool can_swap_heads() const {
        const auto reaches = [this](std::size_t h, const std::vector<std::int32_t>& others) {
            const double most_mm =
                rings_.head(1 - h).real_mm(*std::max_element(others.begin(), others.end()));
            return rings_.head(h).standing_outside(most_mm) <= rings_.head(h).travel;
        };
        return rings_.heads_agree() && reaches(0, table_.r_right_pulses) && reaches(1, table_.r_left_pulses);
    }
    /// Makes the table's own layers the finishing pass.
    void finish() {
        if (passes_.empty()) return;
        if (saved_s_ > longer_ways_s()) radii_ = std::move(raised_);
        raised_ = {};
        if (table_.joining != Joining::zigzag && layer_count() % 2 != 0) swap_heads();
        const auto own = static_cast<std::uint32_t>(table_.layer_count);
        passes_.push_back({static_cast<std::uint32_t>(PassKind::finishing), passes_.back().number + 1,
                           static_cast<std::uint32_t>(layer_count()), own, 0.0, 0.0, clear_mm_});
        table_.layer_count = static_cast<std::uint32_t>(layer_count()) + own;
        put_before(heights_, table_.layer_height_pulses);
        put_before(radii_[0], table_.r_left_pulses);
        put_before(radii_[1], table_.r_right_pulses);
        table_.passes = std::move(passes_);
    }

private:
    template <typename T>
    static void put_before(std::vector<T>& first, std::vector<T>& rest) {
        first.insert(first.end(), rest.begin(), rest.end());
        rest = std::move(first);
    }
    void add_entry(double depth_mm, std::uint32_t number, std::size_t layers) {
        passes_.push_back({static_cast<std::uint32_t>(PassKind::roughing), number,
                           static_cast<std::uint32_t>(layer_count()), static_cast<std::uint32_t>(layers),
                           allowance_mm_, std::max(0.0, depth_mm), clear_mm_});
    }
    void add_layer(const RoughLayer& layer) {
        heights_.push_back(rings_.height_pulses(layer.ring));
        saved_s_ += layer.saved_s;
        for (std::size_t h = 0; h < kHeads; ++h) {
            radii_[h].insert(radii_[h].end(), layer.radii[h].begin(), layer.radii[h].end());
            raised_[h].insert(raised_[h].end(), layer.raised[h].begin(), layer.raised[h].end());
        }
    }
    /// How much longer raised heads make the ways into and out of the blank, which begin and end beyond all
    /// radii.
    double longer_ways_s() const {
        const auto most = [](const std::vector<std::int32_t>& radii) {
            return *std::max_element(radii.begin(), radii.end());
        };
        double further_mm = 0.0;
        for (std::size_t h = 0; h < kHeads; ++h) {
            const std::vector<std::int32_t>& own = h == 0 ? table_.r_left_pulses : table_.r_right_pulses;
            const std::int32_t before = std::max(most(radii_[h]), most(own));
            further_mm = std::max(further_mm, (most(raised_[h]) - before) / rings_.head(h).pulses_per_mm);
        }
        const auto ways = static_cast<double>(passes_.size() + 1);
        return ways * further_mm * (out_s_per_mm_ + in_s_per_mm_);
    }
    /// With an odd number of half turns before them R2 faces the half that R1 faced.
    void swap_heads() {
        for (std::size_t i = 0; i < table_.r_left_pulses.size(); ++i) {
            const double left_mm = rings_.head(0).real_mm(table_.r_left_pulses[i]);
            const double right_mm = rings_.head(1).real_mm(table_.r_right_pulses[i]);
            table_.r_left_pulses[i] = rings_.head(0).standing_outside(right_mm);
            table_.r_right_pulses[i] = rings_.head(1).standing_outside(left_mm);
        }
    }

    JobTable& table_;
    const Rings& rings_;
    double clear_mm_;
    double allowance_mm_;
    double out_s_per_mm_;
    double in_s_per_mm_;
    double saved_s_ = 0.0;
    std::vector<JobPass> passes_;
    std::vector<std::int64_t> heights_;
    std::array<std::vector<std::int32_t>, kHeads> radii_;
    std::array<std::vector<std::int32_t>, kHeads> raised_;
};

}  // namespace

std::optional<RoughingOptions> wanted_roughing(const Profile& profile) {
    const RoughingProfile& roughing = profile.roughing;
    if (roughing.stepdown_mm == 0.0) return std::nullopt;
    RoughingOptions options{roughing.stepdown_mm, roughing.allowance_mm, std::nullopt};
    if (roughing.stepover_mm != 0.0 && profile.tool.shape != ToolShape::point)
        options.stepover_mm = roughing.stepover_mm;
    return options;
}

double used_stepover_mm(const RoughingOptions& options, const ToolProfile& tool) {
    if (options.stepover_mm) return *options.stepover_mm;
    switch (tool.shape) {
        case ToolShape::flat:
            return kFlatStepover * tool.diameter_mm;
        case ToolShape::ball:
            return kBallStepover * tool.diameter_mm;
        case ToolShape::vee:
            return kVeeStepover * tool.diameter_mm;
        case ToolShape::point:
            break;
    }
    return 0.0;
}

Result<void> check_options(const RoughingOptions& options, const Profile& profile) {
    const auto is_length = [](double value_mm) { return value_mm >= 0.0 && value_mm <= kMost_mm; };
    if (!is_length(options.stepdown_mm) || options.stepdown_mm == 0.0)
        return wrong_use("roughing: the stepdown must be more than 0 mm, and " + length_text(kMost_mm) +
                         " at most, not " + length_text(options.stepdown_mm));
    if (!is_length(options.allowance_mm))
        return wrong_use("roughing: the allowance must be 0 to " + length_text(kMost_mm) + ", not " +
                         length_text(options.allowance_mm));
    if (options.stepover_mm && !(*options.stepover_mm > 0.0))
        return wrong_use("roughing: the stepover must be more than 0 mm, not " +
                         length_text(*options.stepover_mm));
    if (options.stepover_mm && profile.tool.shape == ToolShape::point)
        return wrong_use(
            "roughing: a point carves every layer, whatever the stepover; name the tool by --tool");
    if (options.stepover_mm && !(*options.stepover_mm <= profile.tool.diameter_mm)) {
        return wrong_use("roughing: a stepover of " + length_text(*options.stepover_mm) +
                         " is more than the tool is wide, " + length_text(profile.tool.diameter_mm) +
                         "; ask for less by --stepover");
    }
    if (!(profile.blank.radius_mm > 0.0)) {
        return wrong_use(
            "roughing begins at the blank's surface: say how large it is with --blank RADIUSxHEIGHT or in "
            "the profile's [blank], or leave roughing out with --finish-only");
    }
    return {};
}

Result<RoughingSummary> add_roughing(JobTable& table, const JobTable& level, const Profile& profile,
                                     const RoughingOptions& options) {
    if (auto good = check_options(options, profile); !good) return good.error();
    if (auto clear = check_heads_clear(profile.blank, profile); !clear) return clear.error();
    const Rings rings(level, profile);
    // Where the blank stands off the axis, the first passes meet it on one side only.
    const double blank_mm = profile.blank.reach_mm();
    const double deepest_mm = rings.least_tip_mm() + options.allowance_mm;
    const double count = std::ceil((blank_mm - deepest_mm) / options.stepdown_mm - 1e-9);
    if (count >= kMaxJobPasses - 1) {
        return wrong_use("roughing: a stepdown of " + length_text(options.stepdown_mm) + " makes more than " +
                         std::to_string(kMaxJobPasses - 2) + " passes");
    }
    RoughStock stock(rings, profile);
    const PassSettings settings{table.joining,       options.allowance_mm,
                                options.stepdown_mm, used_stepover_mm(options, profile.tool),
                                table.feed_mm_s,     furthest_material_mm(table, rings, blank_mm)};
    PassPlanner planner(rings, stock, profile, settings);
    Assembly assembly(table, rings, profile, blank_mm, options.allowance_mm);
    RoughingSummary summary;
    summary.stepover_mm = settings.stepover_mm;
    RoughPass last;
    for (int k = 1; k <= static_cast<int>(count); ++k) {
        RoughPass pass = planner.plan(blank_mm - k * options.stepdown_mm, assembly.layer_count());
        if (pass.layers.empty()) continue;
        summary.passes.push_back({std::max(0.0, pass.depth_mm),
                                  static_cast<std::uint32_t>(pass.layers.size()), pass.cut_points,
                                  pass.air_points});
        assembly.add(pass, static_cast<std::uint32_t>(summary.passes.size()));
        if (assembly.layer_count() + table.layer_count > kMaxJobCount)
            return bad_input("roughing makes more than " + std::to_string(kMaxJobCount) + " layers");
        last = std::move(pass);
    }
    const bool is_odd = table.joining != Joining::zigzag && assembly.layer_count() % 2 != 0;
    if (is_odd && !assembly.can_swap_heads()) {
        assembly.add_idle(planner.idle_layer(last, assembly.layer_count()), last.depth_mm,
                          static_cast<std::uint32_t>(summary.passes.size()));
    }
    assembly.finish();
    return summary;
}

std::string to_json(const RoughingSummary& summary, const RoughingOptions& options) {
    constexpr std::size_t kMostTold = 60;
    using Json = nlohmann::json;
    Json passes = Json::array();
    std::uint64_t cut = 0;
    std::uint64_t air = 0;
    std::uint64_t layers = 0;
    const auto share = [](std::uint64_t part, std::uint64_t rest) {
        return part + rest > 0 ? static_cast<double>(part) / static_cast<double>(part + rest) : 0.0;
    };
    for (const PassSummary& pass : summary.passes) {
        cut += pass.cut_points;
        air += pass.air_points;
        layers += pass.layers;
        if (passes.size() == kMostTold) continue;
        passes.push_back({{"depth_mm", pass.depth_mm},
                          {"layers", pass.layers},
                          {"air_share", share(pass.air_points, pass.cut_points)}});
    }
    const Json object{{"stepdown_mm", options.stepdown_mm},
                      {"allowance_mm", options.allowance_mm},
                      {"stepover_mm", summary.stepover_mm},
                      {"pass_count", summary.passes.size()},
                      {"layers", layers},
                      {"air_share", share(air, cut)},
                      {"passes", passes}};
    return object.dump();
}

}  // namespace psicarve::rough
