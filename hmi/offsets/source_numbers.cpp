// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/source_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::offsets {
namespace {

static_assert(gcode::kSystemCount * (gcode::kLetterCount + 1) + gcode::kLetterCount + 1 +
                  2 * (1 + gcode::kLetterCount) ==
              kSourceNumbers);

/// Goes through all of them in their order; `visit` writes a number or reads it.
template <typename Kept, typename Visit>
void visit_all(Kept& kept, const Visit& visit) {
    const auto visit_place = [&](auto& place) {
        for (auto& number : place) visit(number);
    };
    for (auto& system : kept.systems) {
        visit_place(system.origin);
        visit(system.rotation_deg);
    }
    visit_place(kept.shift);
}

}  // namespace

SourceNumbers source_numbers(const gcode::KeptOffsets& kept) {
    SourceNumbers numbers{};
    std::size_t next = 0;
    visit_all(kept, [&](double number) { numbers[next++] = number; });
    numbers[next++] = kept.is_shifted ? 1.0 : 0.0;
    for (const auto& reference : kept.references) {
        numbers[next++] = reference ? 1.0 : 0.0;
        for (const double number : reference.value_or(gcode::Position{})) numbers[next++] = number;
    }
    return numbers;
}

std::optional<gcode::KeptOffsets> kept_from(const SourceNumbers& numbers) {
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
        return std::nullopt;
    gcode::KeptOffsets kept;
    std::size_t next = 0;
    visit_all(kept, [&](double& number) { number = numbers[next++]; });
    kept.is_shifted = numbers[next++] != 0.0;
    for (auto& reference : kept.references) {
        const bool is_set = numbers[next++] != 0.0;
        gcode::Position place{};
        for (double& number : place) number = numbers[next++];
        if (is_set) reference = place;
    }
    if (!kept.is_within_limits()) return std::nullopt;
    return kept;
}

}  // namespace psicarve::offsets
