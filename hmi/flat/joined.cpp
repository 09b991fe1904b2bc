// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/outline.hpp"

namespace psicarve::flat {
namespace {

double distance(Point a, Point b) noexcept {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// An end of a stroke: 2 * index for its first point, + 1 for its last.
using End = std::size_t;

/// Finds the nearest free end around a place. Ends lie in squares as wide as the gap that is bridged.
class EndTable {
public:
    explicit EndTable(const std::vector<Path>& strokes) : strokes_(strokes), is_used_(strokes.size(), false) {
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            if (strokes[i].is_closed) continue;
            squares_.emplace(key(square(place(2 * i).x), square(place(2 * i).y)), 2 * i);
            squares_.emplace(key(square(place(2 * i + 1).x), square(place(2 * i + 1).y)), 2 * i + 1);
        }
    }

    Point place(End end) const {
        const auto& points = strokes_[end / 2].points;
        return end % 2 == 0 ? points.front() : points.back();
    }
    void use(std::size_t stroke) { is_used_[stroke] = true; }
    bool is_used(std::size_t stroke) const { return is_used_[stroke]; }

    /// False when none is near enough.
    bool nearest(Point to, End& found) const {
        double best = kJoinGap_mm;
        bool any = false;
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto [begin, end] = squares_.equal_range(key(square(to.x) + dx, square(to.y) + dy));
                std::size_t looked_at = 0;
                for (auto it = begin; it != end && looked_at < kMostInASquare; ++it, ++looked_at) {
                    if (is_used_[it->second / 2]) continue;
                    const double away = distance(place(it->second), to);
                    // Of equal ones the first of the file: the table has no order of its own.
                    if (away > best || (any && away == best && it->second > found)) continue;
                    best = away;
                    found = it->second;
                    any = true;
                }
            }
        }
        return any;
    }

private:
    // A hedgehog of a million strokes from one point is no outline, and must not take hours.
    static constexpr std::size_t kMostInASquare = 1000;

    static std::int64_t square(double value) noexcept {
        // Far away, squares are those of the border: the distance decides.
        return static_cast<std::int64_t>(std::floor(std::clamp(value / kJoinGap_mm, -4e18, 4e18)));
    }
    static std::uint64_t key(std::int64_t x, std::int64_t y) noexcept {
        return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(y);
    }

    const std::vector<Path>& strokes_;
    std::vector<bool> is_used_;
    std::unordered_multimap<std::uint64_t, End> squares_;
};

/// Lengthens the chain at its last point as far as strokes follow.
void lengthen(std::vector<Point>& chain, bool& is_filled, EndTable& ends, const std::vector<Path>& strokes) {
    End next = 0;
    while (distance(chain.front(), chain.back()) > kJoinGap_mm || chain.size() < 3) {
        if (!ends.nearest(chain.back(), next)) return;
        const Path& stroke = strokes[next / 2];
        ends.use(next / 2);
        is_filled = is_filled || stroke.is_filled;
        if (next % 2 == 0) {
            chain.insert(chain.end(), stroke.points.begin() + 1, stroke.points.end());
        } else {
            chain.insert(chain.end(), stroke.points.rbegin() + 1, stroke.points.rend());
        }
    }
}

}  // namespace

std::vector<Path> joined(std::vector<Path> strokes) {
    std::vector<Path> out;
    EndTable ends(strokes);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (strokes[i].is_closed) {
            out.push_back(strokes[i]);
            continue;
        }
        if (ends.is_used(i)) continue;
        ends.use(i);
        Path chain = strokes[i];
        lengthen(chain.points, chain.is_filled, ends, strokes);
        std::reverse(chain.points.begin(), chain.points.end());
        lengthen(chain.points, chain.is_filled, ends, strokes);
        std::reverse(chain.points.begin(), chain.points.end());
        if (chain.points.size() > 2 && distance(chain.points.front(), chain.points.back()) <= kJoinGap_mm) {
            chain.points.pop_back();
            chain.is_closed = true;
        }
        out.push_back(std::move(chain));
    }
    return out;
}

}  // namespace psicarve::flat
