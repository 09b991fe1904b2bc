// SPDX-License-Identifier: GPL-3.0-or-later
// How many contacts a second a tool carves: cells of the piece whose place lies within the tool's disc, seen
// along its axis. What it looks at is the square round that, which is told as well. Beside it the same
// contacts several places at a time, and by the plainest loop, each cell's ray met with the tool by bisection
// over tool::rise; and the peak of memory.
//
//     bench_tool_cut
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "hmi/piece/tool_cut.hpp"
#include "hmi/piece/tool_sweep.hpp"
#include "shared/base/units.hpp"
#include "tests/bench/slice/measure.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr double kHeight_mm = 20.0;
constexpr double kTip_mm = 15.0;

piece::StockMap blank() {
    return piece::StockMap(20.0, 0.0, 0.05, 800, 2500);
}

struct Stand {
    double direction_rad;
    double height_mm;
    double tip_mm;
};

/// `visit` at each place of four turns.
template <typename Visit>
void visit_stands(const Visit& visit) {
    for (int turn = 0; turn < 4; ++turn) {
        for (int step = 0; step < 3200; ++step)
            visit(Stand{step * 2.0 * kPi / 3200.0, kHeight_mm + 0.2 * turn,
                        kTip_mm + 0.1 * std::sin(0.01 * step)});
    }
}

/// Cells of a stock that lie within the tool's disc, seen along its axis.
std::uint64_t contacts_of(const tool::Tool& tool, const piece::StockMap& stock, const Stand& at) {
    std::uint64_t contacts = 0;
    const double half_rad = std::asin(tool.radius / at.tip_mm);
    const double column_rad = 2.0 * kPi / static_cast<double>(stock.column_count());
    const auto first = static_cast<std::int64_t>(std::ceil((at.direction_rad - half_rad) / column_rad));
    const auto last = static_cast<std::int64_t>(std::floor((at.direction_rad + half_rad) / column_rad));
    const auto columns = static_cast<std::int64_t>(stock.column_count());
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        const double up = stock.height_mm(row) - at.height_mm;
        if (std::abs(up) > tool.radius) continue;
        for (std::int64_t column = first; column <= last; ++column) {
            const float radius = stock.row(row)[static_cast<std::size_t>((column + columns) % columns)];
            const double across = static_cast<double>(column) * column_rad - at.direction_rad;
            if (std::hypot(static_cast<double>(radius) * std::sin(across), up) <= tool.radius) ++contacts;
        }
    }
    return contacts;
}

struct Rates {
    double contacts;  ///< a second
    double cells;     ///< a second, that were looked at
    double swept;     ///< contacts a second, several places at a time
};

Rates cut_rates(const tool::Tool& tool) {
    std::uint64_t contacts = 0;
    {
        piece::StockMap stock = blank();
        piece::ToolCut cut(tool, stock);
        visit_stands([&](const Stand& at) {
            contacts += contacts_of(tool, stock, at);
            cut.at(at.direction_rad, at.height_mm, at.tip_mm);
        });
    }
    piece::StockMap stock = blank();
    piece::ToolCut cut(tool, stock);
    const double begin_s = bench::cpu_s();
    visit_stands([&cut](const Stand& at) { cut.at(at.direction_rad, at.height_mm, at.tip_mm); });
    const double took_s = bench::cpu_s() - begin_s;
    piece::StockMap swept_stock = blank();
    piece::ToolSweep sweep(tool, swept_stock);
    const double sweep_begin_s = bench::cpu_s();
    visit_stands([&sweep](const Stand& at) { sweep.at(at.direction_rad, at.height_mm, at.tip_mm); });
    sweep.flush();
    const double swept_s = bench::cpu_s() - sweep_begin_s;
    return {static_cast<double>(contacts) / took_s, static_cast<double>(cut.contacts()) / took_s,
            static_cast<double>(contacts) / swept_s};
}

double plain_rate(const tool::Tool& tool) {
    piece::StockMap stock = blank();
    std::uint64_t contacts = 0;
    const double begin_s = bench::cpu_s();
    for (int step = 0; step < 40; ++step) {
        const double direction_rad = step * 2.0 * kPi / 3200.0;
        for (std::size_t row = 0; row < stock.row_count(); ++row) {
            const double up = stock.height_mm(row) - kHeight_mm;
            if (std::abs(up) > tool.radius) continue;
            for (std::size_t column = 0; column < stock.column_count(); ++column) {
                const double across = std::remainder(stock.direction_rad(column) - direction_rad, 2.0 * kPi);
                if (std::abs(across) > std::asin(tool.radius / kTip_mm)) continue;
                double in = 0.0;
                double out = stock.row(row)[column];
                if (std::hypot(out * std::sin(across), up) > tool.radius) continue;
                ++contacts;
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
    return static_cast<double>(contacts) / (bench::cpu_s() - begin_s);
}

void measure(const char* name, const tool::Tool& tool) {
    const Rates ours = cut_rates(tool);
    const double plain = plain_rate(tool);
    std::printf(
        "%-12s %.0f million contacts a second (%.0f million cells looked at), %.0f times the plain loop; "
        "swept "
        "%.0f million\n",
        name, ours.contacts * 1e-6, ours.cells * 1e-6, ours.contacts / plain, ours.swept * 1e-6);
}

}  // namespace

int main() {
    measure("ball 3 mm", {tool::Shape::ball, 1.5, 0.0});
    measure("flat 2 mm", {tool::Shape::flat, 1.0, 0.0});
    measure("vee 6 mm 60", {tool::Shape::vee, 3.0, 60.0});
    const piece::StockMap stock = blank();
    const double map_mb =
        static_cast<double>(stock.row_count() * stock.column_count() * sizeof(float)) * 1e-6;
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    std::printf("peak %.0f MB, of which a map of %zu x %zu cells takes %.0f MB\n",
                static_cast<double>(usage.ru_maxrss) / 1024.0, stock.row_count(), stock.column_count(),
                map_mb);
    return 0;
}
