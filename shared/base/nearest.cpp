// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/nearest.hpp"

#include <algorithm>
#include <utility>

namespace psicarve {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table of distances between prefixes: two letters back, one back, this one.
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0U : 1U;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (is_swap) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    // Half of the letters may be wrong; more than that is another word.
    std::size_t best_distance = typed.size() / 2 + 1;
    for (const std::string& candidate : candidates) {
        // A beginning of a long name is as likely an abbreviation as a mistake.
        const bool is_start = typed.size() >= 2 && candidate.starts_with(typed);
        const std::size_t distance = is_start ? 1 : edit_distance(typed, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace psicarve
