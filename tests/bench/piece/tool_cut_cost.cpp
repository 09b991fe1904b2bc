// SPDX-License-Identifier: GPL-3.0-or-later
// How many cells of the piece a tool carves a second, beside the same cells by the plainest loop: each cell's
// ray met with the tool by bisection over tool::rise.
//
//     bench_tool_cut
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "hmi/piece/tool_cut.hpp"
#include "shared/units.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

double processor_s() {
    std::timespec at{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
}

constexpr double kHeight_mm = 20.0;
constexpr double kTip_mm = 15.0;

piece::StockMap blank() {
    return piece::StockMap(20.0, 0.0, 0.05, 800, 2500);
}

double cut_rate(const tool::Tool& tool) {
    piece::StockMap stock = blank();
    piece::ToolCut cut(tool, stock);
    const double begin_s = processor_s();
    for (int turn = 0; turn < 4; ++turn) {
        for (int step = 0; step < 3200; ++step)
            cut.at(step * 2.0 * kPi / 3200.0, kHeight_mm + 0.2 * turn, kTip_mm + 0.1 * std::sin(0.01 * step));
    }
    return static_cast<double>(cut.contacts()) / (processor_s() - begin_s);
}

double plain_rate(const tool::Tool& tool) {
    piece::StockMap stock = blank();
    std::uint64_t contacts = 0;
    const double begin_s = processor_s();
    for (int step = 0; step < 40; ++step) {
        const double direction_rad = step * 2.0 * kPi / 3200.0;
        for (std::size_t row = 0; row < stock.row_count(); ++row) {
            const double up = stock.height_mm(row) - kHeight_mm;
            if (std::abs(up) > tool.radius) continue;
            for (std::size_t column = 0; column < stock.column_count(); ++column) {
                const double across = std::remainder(stock.direction_rad(column) - direction_rad, 2.0 * kPi);
                if (std::abs(across) > std::asin(tool.radius / kTip_mm)) continue;
                ++contacts;
                double in = 0.0;
                double out = stock.row(row)[column];
                for (int halving = 0; halving < 24; ++halving) {
                    const double at = 0.5 * (in + out);
                    const double s = std::hypot(at * std::sin(across), up);
                    const bool is_cut =
                        s <= tool.radius && at * std::cos(across) >= kTip_mm + tool::rise(tool, s);
                    (is_cut ? out : in) = at;
                }
                stock.row(row)[column] = static_cast<float>(out);
            }
        }
    }
    return static_cast<double>(contacts) / (processor_s() - begin_s);
}

void measure(const char* name, const tool::Tool& tool) {
    const double ours = cut_rate(tool);
    const double plain = plain_rate(tool);
    std::printf("%-12s %.0f million contacts a second, %.0f times the plain loop\n", name, ours * 1e-6,
                ours / plain);
}

}  // namespace

int main() {
    measure("ball 3 mm", {tool::Shape::ball, 1.5, 0.0});
    measure("flat 2 mm", {tool::Shape::flat, 1.0, 0.0});
    measure("vee 6 mm 60", {tool::Shape::vee, 3.0, 60.0});
    return 0;
}
