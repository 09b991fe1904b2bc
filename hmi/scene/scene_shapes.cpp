// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "hmi/scene/space_picture.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr std::uint32_t kSides = 20;
constexpr double kTipLength = 0.10;  // of the rod
constexpr double kTipRadius = 0.35;
constexpr int kBallRings = 6;
constexpr int kRimDashes = 36;
constexpr int kSideDashes = 18;
constexpr int kRingSides = 48;
constexpr double kRingThickness = 0.03;  // of the radius: two lines beside each other
constexpr double kRingInFront = 2.0;     // of the radius: in front of what it goes round
constexpr double kDash = 0.6;            // of a dash and the gap after it

double angle_of(double part) noexcept {
    return 2.0 * kPi * part;
}

struct HeadRing {
    double x;
    double radius;
};

/// From the tip along the rod: the tool's end, or of a point a needle's, and the rod's two ends.
std::vector<HeadRing> rings_of(double rod_length, double rod_radius, const tool::Tool& tool) {
    const double tip_end = kTipLength * rod_length;
    if (tool.shape == tool::Shape::point) {
        const double needle = kTipRadius * rod_radius;
        return {{tip_end * 0.3, needle}, {tip_end, needle}, {tip_end, rod_radius}, {rod_length, rod_radius}};
    }
    std::vector<HeadRing> rings;
    const int steps = tool.shape == tool::Shape::ball ? kBallRings : 1;
    for (int i = 1; i <= steps; ++i) {
        const double off = tool.radius * std::sin(0.25 * angle_of(static_cast<double>(i) / steps));
        rings.push_back({tool::rise(tool, off), off});
    }
    const double shank_end = std::max(tip_end, 2.0 * rings.back().x);
    const double rod = std::max(rod_radius, tool.radius);
    rings.insert(rings.end(), {{shank_end, tool.radius}, {shank_end, rod}});
    rings.push_back({std::max(rod_length, shank_end), rod});
    return rings;
}

}  // namespace

std::vector<Facet> lathe_facets(std::size_t round, std::size_t up, std::size_t step) {
    std::vector<Facet> facets;
    const auto add = [&facets](std::size_t a, std::size_t b, std::size_t c) {
        facets.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    };
    const auto next_of = [step](std::size_t here, std::size_t end) { return std::min(here + step, end); };
    for (std::size_t column = 0; column < round; column += step) {
        const std::size_t beside = next_of(column, round) % round;
        for (std::size_t row = 0; row + 1 < up; row = next_of(row, up - 1)) {
            const std::size_t low = row * round;
            const std::size_t high = next_of(row, up - 1) * round;
            add(low + column, low + beside, high + column);
            add(low + beside, high + beside, high + column);
        }
        const std::size_t top = (up - 1) * round;
        add(top + column, top + beside, up * round);
    }
    return facets;
}

MeshScene head_scene(double rod_length, double rod_radius, const tool::Tool& tool) {
    MeshScene scene;
    const std::vector<HeadRing> rings = rings_of(rod_length, rod_radius, tool);
    const double widest = 2.0 * rings.back().radius;
    scene.size = {rod_length, widest, widest};
    scene.vertices.push_back({0.0F, 0.0F, 0.0F});
    for (const HeadRing& ring : rings) {
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const double angle_rad = angle_of(static_cast<double>(side) / kSides);
            scene.vertices.push_back({static_cast<float>(ring.x),
                                      static_cast<float>(ring.radius * std::cos(angle_rad)),
                                      static_cast<float>(ring.radius * std::sin(angle_rad))});
        }
    }
    scene.vertices.push_back({static_cast<float>(rod_length), 0.0F, 0.0F});
    const auto last = static_cast<std::uint32_t>(scene.vertices.size() - 1);
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const std::uint32_t next = (side + 1) % kSides;
        scene.facets.push_back({0, 1 + side, 1 + next});
        for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
            const std::uint32_t here = 1 + ring * kSides;
            scene.facets.push_back({here + side, here + kSides + side, here + next});
            scene.facets.push_back({here + next, here + kSides + side, here + kSides + next});
        }
        scene.facets.push_back({last, last - kSides + side, last - kSides + next});
    }
    return scene;
}

std::array<SceneLine, 3> axis_triad(const SceneCamera& camera, slice::Up up, double x_px, double y_px,
                                    double length_px, std::uint32_t rgb) {
    const double scale = camera.px_per_unit();
    const auto middle = camera.project({});
    std::array<double, 3> origin{};
    for (std::size_t k = 0; k < origin.size(); ++k)
        origin[k] = (camera.right()[k] * (x_px - middle[0]) - camera.up()[k] * (y_px - middle[1])) / scale;
    std::array<SceneLine, 3> lines{};
    for (std::size_t axis = 0; axis < lines.size(); ++axis) {
        std::array<double, 3> along{};
        along[axis] = length_px / scale;
        const auto placed = slice::placed(up, along);
        lines[axis] = {origin, origin, rgb};
        for (std::size_t k = 0; k < origin.size(); ++k) lines[axis].to[k] += placed[k];
    }
    return lines;
}

std::vector<SceneLine> ring_outline(const SceneCamera& camera, const std::array<double, 3>& centre,
                                    double radius, std::uint32_t rgb) {
    std::vector<SceneLine> lines;
    for (const double across : {radius, radius * (1.0 - kRingThickness)}) {
        const auto at = [&](int side) {
            const double angle_rad = angle_of(static_cast<double>(side) / kRingSides);
            std::array<double, 3> place = centre;
            for (std::size_t k = 0; k < 3; ++k)
                place[k] += across * (std::cos(angle_rad) * camera.right()[k] +
                                      std::sin(angle_rad) * camera.up()[k]) +
                            kRingInFront * radius * camera.towards()[k];
            return place;
        };
        for (int side = 0; side < kRingSides; ++side) lines.push_back({at(side), at(side + 1), rgb});
    }
    return lines;
}

std::vector<SceneLine> cylinder_outline(const std::array<double, 2>& axis, double radius, double low,
                                        double high, const std::array<double, 3>& right, std::uint32_t rgb) {
    std::vector<SceneLine> lines;
    const auto at = [&](double angle_rad, double z) {
        return std::array{axis[0] + radius * std::cos(angle_rad), axis[1] + radius * std::sin(angle_rad), z};
    };
    for (const double z : {low, high}) {
        for (int dash = 0; dash < kRimDashes; ++dash)
            lines.push_back({at(angle_of(static_cast<double>(dash) / kRimDashes), z),
                             at(angle_of((dash + kDash) / kRimDashes), z), rgb});
    }
    const double side_rad = std::atan2(right[1], right[0]);
    for (const double angle_rad : {side_rad, side_rad + kPi}) {
        for (int dash = 0; dash < kSideDashes; ++dash) {
            const double step = (high - low) / kSideDashes;
            lines.push_back(
                {at(angle_rad, low + dash * step), at(angle_rad, low + (dash + kDash) * step), rgb});
        }
    }
    return lines;
}

}  // namespace psicarve::session
