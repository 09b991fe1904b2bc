// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/dashes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace psicarve::flat {
namespace {

/// Goes along one path, pen down and up in turn.
class DashPen {
public:
    DashPen(const Path& path, std::vector<Path>& out, std::size_t& point_count)
        : path_(path), out_(out), point_count_(point_count) {
        const std::vector<double>& lengths = path.dashes.lengths_mm;
        const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
        left_ = path.dashes.offset_mm - whole * std::floor(path.dashes.offset_mm / whole);
        while (left_ > 0.0 && left_ >= lengths[at_] && at_ + 1 < lengths.size()) left_ -= lengths[at_++];
        left_ = std::max(0.0, lengths[at_] - left_);
    }

    /// False where there are too many.
    bool draw() {
        add(path_.points.front());
        const std::size_t count = path_.points.size();
        for (std::size_t i = 0; i + (path_.is_closed ? 0 : 1) < count; ++i) {
            if (!go(path_.points[i], path_.points[(i + 1) % count])) return false;
        }
        end();
        return point_count_ <= kMostDrawingPoints;
    }

private:
    bool is_down() const noexcept { return at_ % 2 == 0; }
    void add(Point point) {
        if (!is_down()) return;
        dash_.push_back(point);
        ++point_count_;
    }
    void end() {
        if (dash_.size() > 1) out_.push_back({std::move(dash_), false, false, path_.width_mm, true, {}});
        dash_.clear();
    }

    bool go(Point from, Point to) {
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        double gone = 0.0;
        while (length - gone >= left_) {
            gone += left_;
            const double share = length > 0.0 ? std::min(gone / length, 1.0) : 1.0;
            turn({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
            if (point_count_ > kMostDrawingPoints || ++turns_ > kMostDrawingPoints) return false;
        }
        left_ -= length - gone;
        if (gone < length) add(to);
        return true;
    }

    void turn(Point at) {
        add(at);
        end();
        at_ = (at_ + 1) % path_.dashes.lengths_mm.size();
        left_ = path_.dashes.lengths_mm[at_];
        add(at);
    }

    const Path& path_;
    std::vector<Path>& out_;
    std::size_t& point_count_;
    std::vector<Point> dash_;
    std::size_t at_ = 0;  ///< of the dash or gap under the pen
    double left_ = 0.0;   ///< of it [mm]
    std::size_t turns_ = 0;
};

}  // namespace

Result<std::vector<Path>> seen_strokes(std::vector<Path> paths, const std::string& file) {
    const bool any = std::any_of(paths.begin(), paths.end(),
                                 [](const Path& path) { return !path.dashes.lengths_mm.empty(); });
    if (!any) return paths;
    std::vector<Path> seen;
    std::size_t point_count = 0;
    for (Path& path : paths) {
        if (path.dashes.lengths_mm.empty()) {
            seen.push_back(std::move(path));
        } else if (!DashPen(path, seen, point_count).draw()) {
            return too_many_points(file);
        }
    }
    return seen;
}

}  // namespace psicarve::flat
