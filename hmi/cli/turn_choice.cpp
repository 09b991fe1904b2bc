// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/turn_choice.hpp"

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace psicarve::cli {

Result<model::MeshTurn> mesh_turn(const std::string& rotate, const std::string& mirror, slice::Up up) {
    model::MeshTurn turn;
    if (!mirror.empty()) turn.mirror = mirror == "x" ? 0U : mirror == "y" ? 1U : 2U;
    if (rotate.empty()) return turn;
    std::vector<double> numbers;
    bool is_good = true;
    for (const char* from = rotate.data(); is_good;) {
        double value = 0.0;
        const char* end_of_all = rotate.data() + rotate.size();
        const auto [end, error] = std::from_chars(from, end_of_all, value);
        is_good = error == std::errc{} && std::isfinite(value) && (end == end_of_all || *end == ',');
        numbers.push_back(value);
        if (end == end_of_all) break;
        from = end + 1;
    }
    if (!is_good || (numbers.size() != 1 && numbers.size() != 3)) {
        return Error{ErrorCode::bad_usage, "--rotate: '" + rotate +
                                               "' is neither DEGREES about the upright axis (as in 30) nor "
                                               "X,Y,Z (as in 90,0,30)"};
    }
    if (numbers.size() == 1) {
        turn.rotate_deg[static_cast<std::size_t>(up)] = numbers[0];
    } else {
        turn.rotate_deg = {numbers[0], numbers[1], numbers[2]};
    }
    return turn;
}

}  // namespace psicarve::cli
