// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/dilation_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shared/units.hpp"

namespace psicarve::tool {
namespace {

/// The most that a tool which covers a place between two others may stand at there, by their tips: what
/// covers it covers one of them at least, as wide as a tool is, and there stands no deeper, but for the bend
/// of the turn and, where its end is round, for that. Where both ends of the way are about as high it covers
/// both and is above their chord by no more than its own bend at such a slope.
class GapFill {
public:
    explicit GapFill(const Tool& tool) : is_ball_(tool.shape == Shape::ball), radius_(tool.radius) {}

    float between(float from, float to, double way, double turn_rad, double share) const {
        const double most = std::max(from, to);
        const double part = 0.5 * share * (1.0 - share);
        const double turned = most * turn_rad * turn_rad * part;
        if (!is_ball_) return static_cast<float>(most + turned);
        const double chord = from + share * (static_cast<double>(to) - from);
        const double slope = kSteeper * std::abs(static_cast<double>(to) - from) / way + kSlopeSlack;
        const double bend = std::pow(1.0 + slope * slope, 1.5) / radius_;
        return static_cast<float>(
            std::min(most + way * way * part / radius_, chord + bend * way * way * part) + turned);
    }

private:
    static constexpr double kSteeper = 1.25;
    static constexpr double kSlopeSlack = 0.25;
    bool is_ball_;
    double radius_;
};

}  // namespace

Tool widened(const SampledRadii& surface, Tool tool, Stride stride) {
    const float most = *std::max_element(surface.radius.begin(), surface.radius.end());
    const double up = stride.rows > 1 ? 0.5 * surface.row_pitch * static_cast<double>(stride.rows) : 0.0;
    const double half_rad =
        kPi * static_cast<double>(stride.columns) / static_cast<double>(surface.column_count);
    const double across = stride.columns > 1 ? most * half_rad : 0.0;
    tool.radius = std::sqrt(tool.radius * tool.radius + up * up + across * across);
    return tool;
}

void fill_gaps(const SampledRadii& surface, const Tool& tool, Stride stride, std::vector<float>& tips) {
    const GapFill fill(tool);
    const std::size_t columns = surface.column_count;
    const double turn_rad = 2.0 * kPi / static_cast<double>(columns);
    const auto searched_after = [&](std::size_t row) {
        return std::min(row + stride.rows, surface.row_count - 1);
    };
    for (std::size_t row = 0; stride.columns > 1; row = searched_after(row)) {
        float* const at = tips.data() + row * columns;
        for (std::size_t from = 0; from < columns; from += stride.columns) {
            const std::size_t gap = std::min(stride.columns, columns - from);
            const float last = at[(from + gap) % columns];
            const double gap_rad = turn_rad * static_cast<double>(gap);
            const double way = std::max(1e-9, gap_rad * (std::max(at[from], last) + tool.radius));
            for (std::size_t k = 1; k < gap; ++k)
                at[from + k] = fill.between(at[from], last, way, gap_rad,
                                            static_cast<double>(k) / static_cast<double>(gap));
        }
        if (row == surface.row_count - 1) break;
    }
    for (std::size_t row = 0; row + 1 < surface.row_count; row = searched_after(row)) {
        const std::size_t gap = searched_after(row) - row;
        const double way = surface.row_pitch * static_cast<double>(gap);
        const float* const first = tips.data() + row * columns;
        for (std::size_t k = 1; k < gap; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(gap);
            for (std::size_t column = 0; column < columns; ++column)
                tips[(row + k) * columns + column] =
                    fill.between(first[column], first[gap * columns + column], way, 0.0, share);
        }
    }
}

Stride draft_stride(const SampledRadii& surface, const Tool& tool) {
    constexpr double kPartOfTool = 1.0 / 8.0;
    constexpr double kMost = 8.0;
    const float most = *std::max_element(surface.radius.begin(), surface.radius.end());
    const double round = 2.0 * kPi * most / static_cast<double>(surface.column_count);
    const auto fitting = [&](double pitch) {
        return static_cast<std::size_t>(
            std::clamp(std::floor(kPartOfTool * tool.radius / std::max(pitch, 1e-9)), 1.0, kMost));
    };
    return {fitting(surface.row_pitch), fitting(round)};
}

double sample_allowance(const SampledRadii& surface, const Tool& tool, double share) {
    const std::size_t columns = surface.column_count;
    std::vector<double> asked;
    for (std::size_t row = 1; row + 1 < surface.row_count; ++row) {
        const float* const at = surface.radius.data() + row * columns;
        for (std::size_t column = 0; column < columns; ++column) {
            const double here = at[column];
            const double left = at[(column + columns - 1) % columns];
            const double right = at[(column + 1) % columns];
            const double below = *(at + column - columns);
            const double above = at[column + columns];
            const double round = 2.0 * kPi * here / static_cast<double>(columns);
            const double bend = std::abs(left + right - 2.0 * here) + std::abs(above + below - 2.0 * here);
            if (!(here > 0.0) || bend > std::max(round, surface.row_pitch)) continue;
            const double slope2 = std::pow((right - left) / (2.0 * round), 2) +
                                  std::pow((above - below) / (2.0 * surface.row_pitch), 2);
            const double way2 = round * round + surface.row_pitch * surface.row_pitch;
            asked.push_back(0.25 * bend + way2 * std::pow(1.0 + slope2, 1.5) / (8.0 * tool.radius));
        }
    }
    if (asked.empty()) return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(asked.size() - 1));
    std::nth_element(asked.begin(), asked.begin() + place, asked.end());
    return asked[static_cast<std::size_t>(place)];
}

}  // namespace psicarve::tool
