// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace psicarve::gcode {

/// What held from which record on, kept where it changed alone; in order. Bounded: the oldest is forgotten.
template <typename What>
class ChangeHistory {
public:
    explicit ChangeHistory(std::size_t most) noexcept : most_(most) {}

    void add(std::uint64_t first, const What& what) {
        if (!changes_.empty() && changes_.back().what == what) return;
        changes_.push_back({first, what});
        if (changes_.size() > most_) changes_.pop_front();
    }
    /// Drops what is not in force any more where this record is: the first that stays is the last one that
    /// begins there or before.
    void drop_before(std::uint64_t sequence) {
        while (changes_.size() > 1 && changes_[1].first <= sequence) changes_.pop_front();
    }
    bool knows(std::uint64_t sequence) const {
        return !changes_.empty() && changes_.front().first <= sequence;
    }
    const What& front() const { return changes_.front().what; }
    /// Where that ends; `none` where it holds to the end.
    std::uint64_t second_first(std::uint64_t none) const {
        return changes_.size() > 1 ? changes_[1].first : none;
    }

private:
    struct Change {
        std::uint64_t first;
        What what;
    };
    std::size_t most_;
    std::deque<Change> changes_;
};

}  // namespace psicarve::gcode
