// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/dxf_reader.hpp"
#include "hmi/flat/grooves.hpp"
#include "hmi/flat/outline.hpp"
#include "hmi/flat/stroke_index.hpp"
#include "hmi/flat/svg_reader.hpp"
#include "tests/fuzz/require.hpp"

namespace {

using namespace psicarve;
using fuzz::require;
using fuzz::require_one_line;

/// Its lines are refused, or every place of the cylinder is no deeper than they are to be.
void engrave(const flat::Drawing& drawing, bool is_full_turn) {
    flat::FlatOptions options;
    options.engraving = {1.0, 350.0, true, {ToolShape::ball, 2.0}};
    options.is_full_turn = is_full_turn;
    const auto grooves = flat::grooves_of(drawing, options, "fuzzed");
    require_one_line(grooves);
    if (!grooves) return;
    const flat::StrokeIndex index(*grooves, 2.0);
    for (int k = 0; k < 50; ++k) {
        const double beside_mm = index.beside_floor_mm(2.6 * k, 0.02 * k * grooves->height_mm);
        const double depth_mm = grooves->tip_depth_mm(beside_mm);
        require(depth_mm >= 0.0 && depth_mm <= 1.0, "no tip goes deeper than asked");
    }
}

}  // namespace

/// A drawing is refused with one line, or its outline can be made, or that is; its lines alike.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    for (const auto read : {&flat::read_svg, &flat::read_dxf}) {
        const auto drawing = read(text, "fuzzed", 1.0);
        require_one_line(drawing);
        if (!drawing) continue;
        require_one_line(flat::outline_of(*drawing, "fuzzed"));
        engrave(*drawing, false);
        engrave(*drawing, true);
    }
    return 0;
}
