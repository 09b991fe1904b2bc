// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/warning_phrase.hpp"

#include <algorithm>
#include <iterator>

#include <utility>
#include <vector>

#include "hmi/phrase/flat_phrase.hpp"
#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> warning_sentences() {
    return {
        {"%1 of the surface lies behind another part and cannot be reached; --axis-at best would lose %2 of "
         "the surface and %3 of the layers, by the same look this axis %4 and %5",
         phrase("%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, "
                "%2 of the surface and %3 of the layers would be lost; by the same look this axis loses %4 "
                "and %5.")},
        {"%1 of the surface lies behind another part and cannot be reached; --axis-at best looks for an axis "
         "that loses less",
         phrase("%1 of the surface lies behind another part and cannot be reached. Axis at: least lost looks "
                "for an axis that loses less.")},
        {"%1 of the surface lies behind another part and cannot be reached",
         phrase("%1 of the surface lies behind another part and cannot be reached.")},
        {"%1 of %2 layers do not contain the axis; --axis-at best would lose %3 of the surface and %4 of the "
         "layers, by the same look this axis %5 and %6",
         phrase("%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 "
                "of the layers would be lost; by the same look this axis loses %5 and %6.")},
        {"%1 of %2 layers do not contain the axis; --axis-at best looks for an axis that loses less",
         phrase("%1 of %2 layers do not contain the axis. Axis at: least lost looks for an axis that loses "
                "less.")},
        {"%1 of %2 layers do not contain the axis", phrase("%1 of %2 layers do not contain the axis.")},
        {"the mesh is open at %1 of the samples; what is missing there is carved down to what lies behind "
         "it, "
         "or to the core",
         phrase("The mesh is open at %1 of the samples; what is missing there is carved down to what lies "
                "behind "
                "it, or to the core.")},
        {"the model is only %1 mm high: are its units inches (--scale 25.4) or metres (--scale 1000)?",
         phrase("The model is only %1 mm high: are its units inches or metres? Height makes it larger.")},
        {"the model stands so far from its file's origin that its coordinates are rounded to %1 mm, more "
         "than "
         "a pulse (%2 mm): move it to the origin before it is exported",
         phrase(
             "The model stands so far from its file's origin that its coordinates are rounded to %1 mm, more "
             "than a pulse (%2 mm): move it to the origin before it is exported.")},
        {"between two points of a layer the tool goes up to %1 mm too deep along its radius, into the model "
         "mostly less; more points make that less",
         phrase("Between two points of a layer the tool goes up to %1 mm too deep along its radius, into the "
                "model mostly less; more points make that less.")},
        {"the layers lie %1 mm apart, but the tool is only %2 mm wide: between them material stays, as high "
         "as "
         "the blank; more layers leave less",
         phrase("The layers lie %1 mm apart, but the tool is only %2 mm wide: between them material stays, "
                "as high as the blank; more layers leave less.")},
        {"R2's height error draws the rows up to %1 mm apart, but the tool is only %2 mm wide: between them "
         "material stays, as high as the blank; zigzag joining avoids it",
         phrase("R2's height error draws the rows up to %1 mm apart, but the tool is only %2 mm wide: "
                "between them material stays, as high as the blank; zigzag joining avoids it.")},
        {"R2's height error makes the rows uneven: up to %1 mm apart instead of %2 mm; zigzag joining avoids "
         "it",
         phrase("R2's height error makes the rows uneven: up to %1 mm apart instead of %2 mm; zigzag "
                "joining avoids it.")},
        {"R2 stands %1 mm lower than R1 and is under the model in %2 of its layers: there it cuts what holds "
         "the model down to a radius of %3 mm",
         phrase("R2 stands %1 mm lower than R1 and is under the model in %2 of its layers: there it cuts "
                "what holds the model down to a radius of %3 mm.")},
        {"%1 of the points stand at the core radius of %2 mm: what lies inside it is not carved; a larger "
         "model "
         "(--scale, --height, a picture's --diameter) or a smaller core_radius_mm loses less",
         phrase("%1 of the points stand at the core radius of %2 mm: what lies inside it is not carved; a "
                "larger "
                "model or a smaller core_radius_mm loses less.")},
        {"%1 of the points stand at the radius of %2 mm at which the heads' travel ends: what lies inside it "
         "is not carved; a larger model (--scale, --height, a picture's --diameter) or a travel_mm that goes "
         "further in loses less",
         phrase("%1 of the points stand at the radius of %2 mm at which the heads' travel ends: what lies "
                "inside it is not carved; a larger model or a travel_mm that goes further in loses less.")},
        {"roughing cannot keep its stepover of %1 mm: the job's layers lie %2 mm apart",
         phrase("Roughing cannot keep its stepover of %1 mm: the job's layers lie %2 mm apart.")},
        {"the file ends without endsolid", phrase("The file ends without endsolid.")},
    };
}

std::vector<Sentence> blank_sentences() {
    return {
        {"the blank's radius of %1 mm is less than the model's, %2 mm",
         phrase("The blank's radius of %1 mm is less than the model's, %2 mm.")},
        {"the model stands out of the blank, which is off the table's axis, by up to %1 mm in direction %2 "
         "deg",
         phrase(
             "The model stands out of the blank, which is off the table's axis, by up to %1 mm in direction "
             "%2°.")},
        {"the blank's top stands %1 mm above the table, the model's %2 mm",
         phrase("The blank's top stands %1 mm above the table, the model's %2 mm.")},
        {"the blank's radius of %1 mm is more than the heads can clear, %2 mm",
         phrase("The blank's radius of %1 mm is more than the heads can clear, %2 mm.")},
        {"the blank reaches out to %1 mm, which is more than the heads can clear, %2 mm",
         phrase("The blank reaches out to %1 mm, which is more than the heads can clear, %2 mm.")},
        {"the heads can go only %1 mm out of the blank before they begin, not the %2 mm of job.clearance_mm",
         phrase("The heads can go only %1 mm out of the blank before they begin, not the %2 mm of "
                "job.clearance_mm.")},
        {"above the blank's top there is nothing to cut: %1 of %2 layers are left out",
         phrase("Above the blank's top there is nothing to cut: %1 of %2 layers are left out.")},
        {"the tool cuts %1 mm deep, but the job goes %2 mm into the blank",
         phrase("The tool cuts %1 mm deep, but the job goes %2 mm into the blank.")},
        {"the depth limit of %1 mm below the blank's surface keeps the heads out of %2 of the points, by up "
         "to "
         "%3 mm",
         phrase(
             "The depth limit of %1 mm below the blank's surface keeps the heads out of %2 of the points, by "
             "up to %3 mm.")},
    };
}

std::vector<Sentence> mesh_sentences() {
    return {
        {"the mesh has holes: %1 to an odd number of facets; a hole is carved down to what lies behind it, "
         "or to the "
         "core",
         phrase("The mesh has holes, which are carved down to what lies behind them, or to the core.")},
        {"some facets are flipped: along %1 the neighbours disagree about what is outside; carved as if they "
         "agreed",
         phrase("Some facets are flipped against their neighbours; carved as if they were not.")},
        {"the mesh is inside out: all facets are flipped; carved as if they were not",
         phrase("The mesh is inside out; carved as if it were not.")},
    };
}

}  // namespace

Phrase warning_phrase(const std::string& warning) {
    if (auto found = phrase_for(flat_warnings(), warning)) return *found;
    if (const auto line = phrase_for({{"line %1: %2", phrase("line %1")}}, warning)) {
        if (auto found = phrase_for(flat_line_warnings(), line->arguments.back()))
            return joined(phrase("line %1", line->arguments.front()), std::move(*found));
    }
    if (auto found = phrase_for(blank_sentences(), warning)) return *found;
    if (auto found = phrase_for(mesh_sentences(), warning)) return *found;
    return phrase_for(warning_sentences(), warning).value_or(phrase("%1", warning));
}

std::vector<std::string> other_warnings(const std::vector<std::string>& more,
                                        const std::vector<std::string>& known) {
    std::vector<std::string> others;
    std::copy_if(more.begin(), more.end(), std::back_inserter(others), [&known](const std::string& warning) {
        return std::find(known.begin(), known.end(), warning) == known.end();
    });
    return others;
}

}  // namespace psicarve::session
