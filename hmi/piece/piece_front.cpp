// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_front.hpp"

#include <algorithm>

namespace psicarve::piece {

PieceFront::PieceFront(const StockMap& blank)
    : shown_(blank), front_(blank), differs_(blank.row_count(), std::uint8_t{0}) {}

void PieceFront::publish(const StockMap& stock) {
    bool is_new = false;
    const std::lock_guard lock{mutex_};
    for (std::size_t row = 0; row < differs_.size(); ++row) {
        const auto now = stock.row(row);
        const auto before = front_.row(row);
        if (std::equal(now.begin(), now.end(), before.begin())) continue;
        std::copy(now.begin(), now.end(), before.begin());
        differs_[row] = 1;
        is_new = true;
    }
    if (is_new) ++edition_;
}

std::vector<std::size_t> PieceFront::take_changed_rows() {
    std::vector<std::size_t> rows;
    const std::lock_guard lock{mutex_};
    for (std::size_t row = 0; row < differs_.size(); ++row) {
        if (differs_[row] == 0) continue;
        differs_[row] = 0;
        const auto now = front_.row(row);
        std::copy(now.begin(), now.end(), shown_.row(row).begin());
        rows.push_back(row);
    }
    return rows;
}

}  // namespace psicarve::piece
