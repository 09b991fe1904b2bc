// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/flat_phrase.hpp"

namespace psicarve::session {
namespace {

void add_pictures(std::vector<Sentence>& all) {
    const auto more = as_said({
        phrase("a picture without pixels"),
        phrase("a picture of %1 x %2 pixels; at most 100 million can be read, and 65535 a side"),
        phrase("not a picture that can be read here (PNG, JPEG, TIFF, BMP, PGM)"),
        phrase("a BMP picture of OS/2's kind, which is not read"),
        phrase("a BMP picture of a kind that is not read (%1 bits, compression %2); save it as PNG"),
        phrase("a TIFF picture of signed or floating numbers; save it with 8 or 16 bits"),
        phrase("a TIFF picture of %1 bits a sample: 8 or 16 are read"),
        phrase("a TIFF picture whose samples are of different sizes; save it as PNG"),
        phrase("a TIFF picture that is packed in a way that is not read (compression %1); save it as PNG"),
        phrase(
            "a TIFF picture of a kind that is not read (%1 samples of %2 bits, photometric %3); save it as "
            "PNG"),
        phrase("a damaged TIFF picture: its directory cannot be read"),
        phrase("a damaged TIFF picture: its pixels cannot be unpacked"),
        phrase("a damaged BMP picture: its pixels are said to begin at byte %1, inside its head of %2"),
        phrase("a damaged %1 picture: the file ends too early"),
        phrase("a damaged %1 picture: %2"),
        phrase("a damaged %1 picture"),
        phrase("%1 mm deep goes to the middle of a cylinder of %2 mm diameter"),
        phrase("more than 512 MiB, which no drawing or picture needs"),
    });
    all.insert(all.end(), more.begin(), more.end());
    all.push_back(
        {"a picture %1 mm high would be %2 mm wide, and once round are only %3 mm: at most "
         "--height %4, a larger --diameter, or --full-turn to change its shape",
         phrase("a picture %1 mm high would be %2 mm wide, and once round are only %3 mm: choose "
                "at most %4 mm of height, a larger diameter, or all round, which changes its "
                "shape")});
}

void add_grooves(std::vector<Sentence>& all) {
    const auto more = as_said({
        phrase("no lines to engrave"),
        phrase("the drawing would be more than ten metres wide or high"),
        phrase("a drawing without a width goes not all round"),
        phrase("grooves %1 mm deep; they must be deeper than 0, and less deep than the cylinder's radius of "
               "%2 mm"),
        phrase("its grooves are of another tool"),
    });
    all.insert(all.end(), more.begin(), more.end());
    all.push_back(
        {"the drawing is %1 mm wide, and once round the cylinder are only %2 mm: at most --scale %3, a "
         "larger "
         "--diameter, or --full-turn",
         phrase("the drawing is %1 mm wide, and once round the cylinder are only %2 mm: choose a scale of at "
                "most %3, a larger diameter, or all round")});
    all.push_back(
        {"the drawing is %1 mm high, and the cylinder only %2 mm: --height or --scale",
         phrase("the drawing is %1 mm high, and the cylinder only %2 mm: choose a larger height or a "
                "smaller scale")});
}

}  // namespace

std::vector<Sentence> flat_refusals() {
    auto all = as_said({
        phrase("holds no line that can be carved (%1)"),
        phrase("has no closed outline; the longest stroke goes from %1 to %2 mm, %3 apart; close it in the "
               "drawing program"),
        phrase("its outlines cannot be joined: %1"),
        phrase("its outlines enclose no area; there is nothing to carve"),
        phrase("a coordinate is not a finite number"),
        phrase("more than %1 points when its curves are cut into straight pieces; nobody can carve that"),
        phrase("its blocks draw more than a million elements"),
        phrase("its blocks draw more than half a gigabyte of text"),
        phrase("its <use> elements draw more than two million elements"),
        phrase("a binary DXF drawing; save it as text (ASCII DXF)"),
        phrase("the drawing's width or height is not more than 0"),
        phrase("the table has no layers"),
        phrase("more points than pulses: %1 points in half a turn of %2 pulses"),
        phrase("layer %1, point %2: a radius of %3 mm, less than core_radius_mm, %4 mm"),
        phrase("layer %1, point %2: axis %3 would have to go to %4 mm, but goes from %5 mm to %6 mm"),
        phrase("layer %1 lies no higher than the one before"),
        phrase("the table's last layer is not whole, or there is none"),
        phrase("layer %1, point %2: psi is not where any joining has it"),
        phrase("layer %1, point %2: the height is neither its layer's nor on a spiral's way up"),
        phrase("the last row does not close the spiral"),
        phrase("psi goes further in a layer than any machine"),
        phrase("the finishing pass is missing: the last run is of a roughing pass, and leaves what the model "
               "does not have"),
        phrase("a layer of one point goes nowhere; it needs two"),
        phrase("layer %1 lies no higher than the one before: a table of several passes needs the columns run "
               "to clear_mm; export the job again"),
        phrase("more than a gigabyte, which no table needs"),
    });
    all.push_back(
        {"roughing needs level layers, which a table of a spiral does not have: slice the model with "
         "roughing, or leave it out with --finish-only",
         phrase("roughing needs level layers, which a table of a spiral does not have: slice the model with "
                "roughing, or choose finishing only")});
    all.push_back({"a table of layers is no spiral: --joining continuous or zigzag",
                   phrase("a table of layers is no spiral: choose Joining continuous or zigzag")});
    add_pictures(all);
    add_grooves(all);
    return all;
}

std::vector<Sentence> flat_line_refusals() {
    return as_said({
        phrase("%1 is no group code"),
        phrase("%1 is not a whole number"),
        phrase("the file ends too early: there is no EOF"),
        phrase("more than four million values in one element"),
        phrase("this is no DXF file: it does not begin with a section"),
        phrase("the XML ends too early"),
        phrase("this is not well-formed XML"),
        phrase("there is no <svg> element"),
        phrase("the first element is not <svg>"),
        phrase("%1 is not a number that a table can hold"),
        phrase("%1 is no head of a table: y_mm,r_mm or y_pulses,r_pulses, or what snapshot export writes"),
        phrase("a layer needs its height and at least two radii"),
        phrase("%1 radii, but the layers before have %2"),
        phrase("%1 numbers, not %2"),
        phrase("another run than that of the layer's first point"),
        phrase("runs and passes do not count on by one"),
        phrase("column %1: a pass has no such length"),
        phrase("column %1: %2 mm, but the heads clear no more than %3 mm"),
        phrase("more than %1 runs, which no job has"),
        phrase("layers do not count on by one"),
        phrase("a number that no machine has"),
        phrase("pulses and counts are whole numbers"),
        phrase("points do not follow each other from 0 on, as many in each layer"),
    });
}

std::vector<Sentence> flat_warnings() {
    return {
        {"the drawing does not say its units: they are taken as millimetres",
         phrase("The drawing does not say its units: they are taken as millimetres.")},
        {"the drawing does not say how large it is: its units are taken as 1/96 inch",
         phrase("The drawing does not say how large it is: its units are taken as 1/96 inch (0.26 mm).")},
        {"left out, as they are no lines: %1", phrase("Left out, as they are no lines: %1.")},
        {"1 stroke is not closed and left out, the first from %1 to %2 mm",
         phrase("1 stroke is not closed and left out, from %1 to %2 mm.")},
        {"%1 strokes are not closed and left out, the first from %2 to %3 mm",
         phrase("%1 strokes are not closed and left out, the first from %2 to %3 mm.")},
        {"<text> is left out: convert text to paths in the drawing program",
         phrase("Text is left out: convert it to paths in the drawing program.")},
        {"<%1> is left out", phrase("<%1> is left out.")},
        {"of <style> only rules for element names, .class and #id are followed, not %1",
         phrase("Of <style> only rules for element names, .class and #id are followed, not %1.")},
        {"the picture is in colour; its brightness is taken",
         phrase("The picture is in colour; its brightness is taken.")},
        {"of the picture's 16 bits 8 are taken, as its samples lie in planes",
         phrase("Of the picture's 16 bits 8 are taken, as its samples lie in planes.")},
        {"the picture does not say what its fourth sample is: taken as alpha",
         phrase("The picture does not say what its fourth sample is: it is taken as transparency (alpha).")},
        {"the picture's %1 x %2 pixels are averaged to %3 x %4",
         phrase("The picture's %1 x %2 pixels are averaged to %3 x %4.")},
        {"the picture's left and right edges do not meet: a step of up to %1 mm at direction 0; --seam blend "
         "makes it smooth",
         phrase("The picture's left and right edges do not meet: a step of up to %1 mm at direction 0. Seam: "
                "blended makes it smooth.")},
        {"the picture ends before the full turn in steps to the white rest: of up to %1 mm at its left edge "
         "and %2 mm at its right one; white edges or --full-turn leave none",
         phrase(
             "The picture ends before the full turn in steps to the white rest: of up to %1 mm at its left "
             "edge and %2 mm at its right one. White edges, or all round, leave none.")},
        {"the table is taken as it stands: R2's angle and height errors stay in it",
         phrase("The table is taken as it stands: R2's angle and height errors stay in it.")},
        {"%1 of %2 strokes are narrower than the tool cuts, %3 mm: they become as wide as that",
         phrase("%1 of %2 strokes are narrower than the tool cuts, %3 mm: they become as wide as that.")},
        {"the tool is a point, which leaves no width: grooves are as wide as the real tool cuts them",
         phrase(
             "The tool is a point, which leaves no width: grooves are as wide as the real tool cuts them.")},
        {"layers and points lie farther from each other than the tool cuts, %1 mm: more --layers or --points",
         phrase("Layers and points lie farther from each other than the tool cuts, %1 mm: choose more of "
                "them.")},
        {"grooves end at the core radius of %1 mm, less deep than asked",
         phrase("Grooves end at the core radius of %1 mm, less deep than asked.")},
    };
}

std::vector<Sentence> flat_line_warnings() {
    return {
        {"a SPLINE whose knots and points do not belong together is left out",
         phrase("a SPLINE whose knots and points do not belong together is left out.")},
        {"INSERT of a block that is not there is left out",
         phrase("INSERT of a block that is not there is left out.")},
        {"INSERT of a block that is not there or holds itself is left out",
         phrase("INSERT of a block that is not there or holds itself is left out.")},
        {"a transform that cannot be read; the element is left out",
         phrase("a transform that cannot be read; the element is left out.")},
        {"<%1> is not right; what follows the fault is left out",
         phrase("<%1> is not right; what follows the fault is left out.")},
        {"<%1> is not right and left out", phrase("<%1> is not right and left out.")},
        {"clipping and masks are not followed: <%1> is carved whole",
         phrase("clipping and masks are not followed: <%1> is carved whole.")},
        {"what lies beyond the edge of <%1> is carved, too",
         phrase("what lies beyond the edge of <%1> is carved, too.")},
        {"<use> of something that is not in this file is left out",
         phrase("<use> of something that is not in this file is left out.")},
        {"<switch> holds nothing for every language and is left out",
         phrase("<switch> holds nothing for every language and is left out.")},
    };
}

}  // namespace psicarve::session
