// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ProgrammedWay that goes along arcs. On small ones no angle tells where a place belongs: all of
// a circle may be within the tolerance of it, and each turn of several is.
#include <algorithm>
#include <cmath>

#include "hmi/verify/program/programmed_way.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {
namespace {

/// Ranges of an arc are known to that part of a pulse.
constexpr double kPartOfPulse = 0.25;
/// A nearest place is looked for between so many, then by halving.
constexpr int kPlaces = 16;
constexpr int kHalvings = 24;

}  // namespace

double ProgrammedWay::Off::room_mm() const noexcept {
    double room = slack_mm[0] - std::abs(mm[0]);
    for (std::size_t k = 1; k < mm.size(); ++k) room = std::min(room, slack_mm[k] - std::abs(mm[k]));
    return std::max(room, 0.0);
}

/// No place of a head's space goes further while its share does, psi at the radius at which the place stands.
double ProgrammedWay::arc_length_mm(std::size_t head, const Positions& at) const noexcept {
    const double pulse_mm = heads_[head].pulse_mm[1];
    const double r_mm = std::max(static_cast<double>(at[head]) * pulse_mm + scale_->tip_mm[head], 0.0);
    const double turned_mm = std::abs(to_[kPsi] - from_[kPsi]) * scale_->rad_per_pulse * r_mm;
    const double drawn_mm = std::abs(arc_->sweep_rad) * std::max(arc_->start_radius_mm, arc_->end_radius_mm) +
                            std::abs(arc_->end_radius_mm - arc_->start_radius_mm);
    const double other_mm = arc_->moves_head[head] ? 0.0 : std::abs(to_[head] - from_[head]) * pulse_mm;
    return turned_mm + drawn_mm + other_mm;
}

ProgrammedWay::Near ProgrammedWay::near_at(std::size_t head, const Positions& at,
                                           const WayTolerance& tolerance, double share,
                                           double length_mm) const noexcept {
    ++places_looked_at_;
    const Off off = this->off(head, at, this->at(share), tolerance.pulses);
    const double off_mm = off.distance_mm();
    const bool is_near = off_mm <= tolerance.mm;
    const double alike_mm = is_near ? tolerance.mm - off_mm + off.room_mm() : off_mm - tolerance.mm;
    const double least_mm = kPartOfPulse * std::min(heads_[head].pulse_mm[1], heads_[head].pulse_mm[2]);
    return {is_near, share + std::max(alike_mm, least_mm) / length_mm};
}

bool ProgrammedWay::go_on(std::size_t head, const Positions& at, const WayTolerance& tolerance,
                          Reach& reach) const {
    const double length_mm = arc_length_mm(head, at);
    // Between two places lies a pulse, which may be off by more than both.
    const double pulse = std::max(heads_[head].pulse_mm[1], heads_[head].pulse_mm[2]) / length_mm;
    Reach next;
    for (const ShareRange& range : reach) {
        double share = std::max(range.least - pulse, 0.0);
        if (!next.empty()) share = std::max(share, next.back().most);
        while (share <= std::min(range.most + pulse, 1.0)) {
            Near near = near_at(head, at, tolerance, share, length_mm);
            if (!near.is_near) {
                // The arc's very end is a place, too.
                share = share < 1.0 ? std::min(near.next_share, 1.0) : near.next_share;
                continue;
            }
            ShareRange found{share, share};
            while (near.is_near && found.most < 1.0) {
                const double further = std::min(near.next_share, 1.0);
                near = near_at(head, at, tolerance, further, length_mm);
                share = further;
                if (near.is_near) found.most = further;
                // A whole turn is near: so are all that follow, over the same places.
                if (found.most - found.least >= turn_share_) found.most = 1.0;
            }
            found = {std::max(found.least, range.least), std::max(found.most, range.least)};
            if (!next.empty() && found.least <= next.back().most)
                next.back().most = std::max(next.back().most, found.most);
            else
                next.push_back(found);
            if (found.most >= 1.0) break;
        }
    }
    if (next.empty()) return false;
    reach = std::move(next);
    return true;
}

/// By the angle at which the place stands around the centre; of several turns the one that is nearest to
/// where it was before.
double ProgrammedWay::share_of_arc(const Positions& at, double share_before) const noexcept {
    const std::size_t head = arc_->moves_head[0] ? 0 : 1;
    const double r_mm = static_cast<double>(at[head]) / scale_->pulses_per_unit[head] - arc_->centre_r_mm;
    const double y_mm = static_cast<double>(at[kY]) / scale_->pulses_per_unit[kY] - arc_->centre_y_mm;
    const double before_rad = arc_->start_rad + share_before * arc_->sweep_rad;
    const double angle_rad = before_rad + std::remainder(std::atan2(y_mm, r_mm) - before_rad, 2.0 * kPi);
    return std::clamp((angle_rad - arc_->start_rad) / arc_->sweep_rad, 0.0, 1.0);
}

ProgrammedWay::Nearest ProgrammedWay::nearest_within(std::size_t head, const Positions& at,
                                                     const WayTolerance& tolerance,
                                                     const ShareRange& range) const noexcept {
    const auto off_mm = [&](double share) { return distance_mm(head, at, share, tolerance.pulses); };
    const double guess =
        std::clamp(share_of_arc(at, 0.5 * (range.least + range.most)), range.least, range.most);
    Nearest best{guess, off_mm(guess)};
    if (best.mm <= 0.0) return best;
    const double apart = (range.most - range.least) / kPlaces;
    for (int n = 0; n <= kPlaces; ++n) {
        const double share = std::min(range.least + n * apart, range.most);
        const double mm = off_mm(share);
        if (mm < best.mm) best = {share, mm};
    }
    double step = 0.5 * apart;
    for (int n = 0; n < kHalvings && best.mm > 0.0; ++n, step *= 0.5) {
        for (const double share : {best.share - step, best.share + step}) {
            const double inside = std::clamp(share, range.least, range.most);
            const double mm = off_mm(inside);
            if (mm < best.mm) best = {inside, mm};
        }
    }
    return best;
}

std::optional<double> ProgrammedWay::last_near(std::size_t head, const Positions& at,
                                               const WayTolerance& tolerance,
                                               const ShareRange& range) const noexcept {
    const double length_mm = arc_length_mm(head, at);
    std::optional<double> last;
    // The last of several like turns has all places.
    for (double share = std::max(range.least, range.most - turn_share_); share <= range.most;) {
        const Near near = near_at(head, at, tolerance, share, length_mm);
        if (near.is_near) last = share;
        if (share >= range.most) break;
        share = std::min(near.next_share, range.most);
    }
    return last;
}

double ProgrammedWay::from_one_place_within_mm(const Positions& at, const WayTolerance& tolerance,
                                               const ShareRange& range) const noexcept {
    const std::array<double, kHeadCount> lengths_mm{arc_length_mm(0, at), arc_length_mm(1, at)};
    double least_mm = both_mm(at, 0.5 * (range.least + range.most), tolerance.pulses);
    // One of several like turns has all places.
    const double most = std::min(range.most, range.least + turn_share_);
    for (double share = range.least; least_mm > tolerance.mm;) {
        const double mm = both_mm(at, share, tolerance.pulses);
        least_mm = std::min(least_mm, mm);
        if (share >= most) break;
        // A place within the tolerance is no nearer than that on either head's way.
        const double apart_mm = std::max(mm - tolerance.mm, kPartOfPulse * heads_[0].pulse_mm[2]);
        share = std::min(share + apart_mm / std::max(lengths_mm[0], lengths_mm[1]), most);
    }
    return least_mm;
}

}  // namespace psicarve::verify
