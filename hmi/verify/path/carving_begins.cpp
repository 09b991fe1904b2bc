// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/carving_begins.hpp"

#include <algorithm>
#include <cstdlib>

namespace psicarve::verify {

CarvingBegins::CarvingBegins(const JobGeometry& geometry) : geometry_(geometry) {
    const std::int64_t rev = geometry.rev_pulses();
    const auto begin_of = [&](std::uint32_t layer) {
        Positions begin = geometry.target(layer, geometry.first_step(layer));
        begin[kPsi] = (begin[kPsi] % rev + rev) % rev;
        return begin;
    };
    std::vector<Positions> others;
    for (std::uint32_t layer = 0; layer < geometry.layer_count(); ++layer) {
        if (layer < geometry.first_layer() || layer >= geometry.end_layer())
            others.push_back(begin_of(layer));
    }
    std::sort(others.begin(), others.end());
    for (std::uint32_t layer = geometry.first_layer(); layer < geometry.end_layer(); ++layer)
        are_shared_ = are_shared_ || std::binary_search(others.begin(), others.end(), begin_of(layer));
}

/// Both begin here.
bool CarvingBegins::is_likelier(std::uint32_t layer, std::uint32_t than, std::uint32_t due) const noexcept {
    if (layer == due || than == due) return layer == due;
    const std::uint32_t end = geometry_.end_layer();
    if (due == end && (layer >= end || than >= end)) return layer >= end;
    return layer == first().layer;
}

bool CarvingBegins::is_begin_of(std::uint32_t layer, const Positions& at) const noexcept {
    const Positions begin = geometry_.target(layer, geometry_.first_step(layer));
    return at[kY] == begin[kY] && at[0] == begin[0] && at[1] == begin[1] &&
           (at[kPsi] - begin[kPsi]) % geometry_.rev_pulses() == 0;
}

bool CarvingBegins::is_near_first(const Positions& at, std::int64_t most_pulses) const noexcept {
    const Positions begin = geometry_.target(first().layer, first().step);
    const std::int64_t rest = std::abs((at[kPsi] - begin[kPsi]) % geometry_.rev_pulses());
    return std::abs(at[0] - begin[0]) <= most_pulses && std::abs(at[1] - begin[1]) <= most_pulses &&
           std::abs(at[kY] - begin[kY]) <= most_pulses &&
           std::min(rest, geometry_.rev_pulses() - rest) <= most_pulses;
}

std::optional<std::uint32_t> CarvingBegins::layer_at(const Positions& at, std::uint32_t due) {
    if (begins_y_ != at[kY]) {
        begins_y_ = at[kY];
        beginning_.clear();
        for (std::uint32_t layer = 0; layer < geometry_.layer_count(); ++layer) {
            if (geometry_.target(layer, geometry_.first_step(layer))[kY] == at[kY])
                beginning_.push_back(layer);
        }
    }
    std::optional<std::uint32_t> found;
    for (const std::uint32_t layer : beginning_) {
        if (is_begin_of(layer, at) && (!found || is_likelier(layer, *found, due))) found = layer;
    }
    return found;
}

std::optional<CarvePoint> CarvingBegins::point_at(const Positions& at, std::uint32_t due) {
    look_for_points(at);
    std::optional<CarvePoint> found;
    for (const CarvePoint& point : plunge_points_) {
        const Positions target = geometry_.target(point.layer, point.step);
        if (target[0] != at[0] || target[1] != at[1]) continue;
        if (!found || is_likelier(point.layer, found->layer, due)) found = point;
    }
    return found;
}

/// Of all layers: once for a plunge of many pulses.
void CarvingBegins::look_for_points(const Positions& at) {
    if (plunge_ == std::pair{at[kPsi], at[kY]}) return;
    plunge_ = {at[kPsi], at[kY]};
    plunge_points_.clear();
    for (std::uint32_t layer = 0; layer < geometry_.layer_count(); ++layer) {
        const auto step = geometry_.step_at(layer, at);
        if (step && *step + 1 < geometry_.point_count()) plunge_points_.push_back({layer, *step});
    }
}

}  // namespace psicarve::verify
