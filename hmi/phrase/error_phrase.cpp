// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/error_phrase.hpp"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/phrase/calibration_phrase.hpp"
#include "hmi/phrase/flat_phrase.hpp"
#include "hmi/phrase/message_phrase.hpp"
#include "hmi/phrase/profile_phrase.hpp"
#include "hmi/phrase/program_phrase.hpp"
#include "hmi/phrase/sentence.hpp"
#include "hmi/phrase/warning_phrase.hpp"

namespace psicarve::session {
namespace {

/// With a file's name, or alone from the core.
Sentence blank_too_large() {
    return {
        "the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the "
        "carving begins; take a smaller blank",
        phrase("the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the "
               "carving begins; take a smaller blank")};
}

/// What follows the name of a file.
std::vector<Sentence> of_a_file() {
    return {
        blank_too_large(),
        {"no such file", phrase("no such file")},
        {"has been changed since it was read; decode it again",
         phrase("has been changed since it was read; decode it again")},
        {"cannot be opened: %1", phrase("cannot be opened: %1")},
        {"cannot be read: %1", phrase("cannot be read: %1")},
        {"cannot be written", phrase("cannot be written")},
        {"is a directory, not a model file", phrase("is a folder, not a model file")},
        {"is not a regular file", phrase("is not a regular file")},
        {"became shorter while it was read", phrase("became shorter while it was read")},
        {"too large for this computer's memory", phrase("too large for this computer's memory")},
        {"nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a picture "
         "(PNG, JPEG, "
         "TIFF, BMP, PGM) or a table (CSV)",
         phrase("nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a "
                "picture "
                "(PNG, JPEG, TIFF, BMP, PGM) or a table (CSV)")},
        {"a packed file (gzip), as SVGZ is; unpack it first",
         phrase("a packed file (gzip), as SVGZ is; unpack it first")},
        {"a %1 picture, which is not read; save it as PNG",
         phrase("a %1 picture, which is not read; save it as PNG")},
        {"an %1 picture, which is not read; save it as PNG",
         phrase("a %1 picture, which is not read; save it as PNG")},
        {"a %1 drawing, which is not read; save it as %2",
         phrase("a %1 drawing, which is not read; save it as %2")},
        {"a %1 model, which is not read; save it as STL or 3MF",
         phrase("a %1 model, which is not read; save it as STL or 3MF")},
        {"an %1 model, which is not read; save it as STL or 3MF",
         phrase("a %1 model, which is not read; save it as STL or 3MF")},
        {"the file is empty", phrase("the file is empty")},
        {"holds no facets (%1)", phrase("holds no facets (%1)")},
        {"%1 of %2 facets have NaN or infinite coordinates; this is not a usable mesh",
         phrase("%1 of %2 facets have no finite coordinates; this is not a usable mesh")},
        {"the mesh has no volume (all of it is flat); there is nothing to carve",
         phrase("the mesh has no volume (all of it is flat); there is nothing to carve")},
        {"truncated: a binary STL begins with 84 bytes, the file has %1",
         phrase("cut off: a binary STL begins with 84 bytes, the file has %1")},
        {"truncated, or not an STL file: the header announces %1 facets, the file has room for %2",
         phrase("cut off, or not an STL file: the header announces %1 facets, the file has room for %2")},
        {"truncated: it ends without endsolid, and the mesh has holes",
         phrase("cut off: it ends without endsolid, and the mesh has holes")},
        {"truncated: the PLY header has no end_header", phrase("cut off: the PLY header has no end_header")},
        {"is a zip archive, but holds no 3MF model", phrase("is a zip archive, but holds no 3MF model")},
        {"is no 3MF file: these are zip archives", phrase("is no 3MF file: these are zip archives")},
        {"the zip archive is truncated or damaged: it has no readable directory",
         phrase("the zip archive is cut off or damaged")},
        {"the archive unpacks to far more than a model needs",
         phrase("the archive unpacks to far more than a model needs")},
        {"is no psicarve job or snapshot file", phrase("is no psicarve job or snapshot file")},
        {"truncated: its header is not complete", phrase("cut off: its header is not complete")},
        {"damaged: its checksum is wrong", phrase("damaged: its checksum is wrong")},
        {"damaged: sizes and offsets do not fit each other",
         phrase("damaged: sizes and offsets do not fit each other")},
        {"file version %1, this program knows %2: make the file anew",
         phrase("file version %1, this program knows %2: make the file anew")},
        {"was written by a psicarve of another build (its structures have other sizes)",
         phrase("was written by another build of psicarve")},
        {"holds no job", phrase("holds no job")},
        {"carries no job; open its job first", phrase("carries no job; open its job first")},
        {"carries several jobs; open the one that is meant",
         phrase("carries several jobs; open the one that is meant")},
        {"the job that it carries is damaged", phrase("the job that it carries is damaged")},
        {"opening was cancelled", phrase("opening was cancelled")},
        {"more layers than pulses: %1 layers, but the model is only %2 mm, %3 pulses of axis y, high: at "
         "most "
         "--layers %4, or make it higher with --height or --scale",
         phrase("more layers than pulses: %1 layers, but the model is only %2 mm, %3 pulses of axis Y, high: "
                "choose at most %4 layers, or a larger height")},
        {"the axis passes beside the model and no sample meets it: nothing but the core would be carved; "
         "--axis-at moves the axis",
         phrase(
             "the axis passes beside the model and no sample meets it: nothing but the core would be carved; "
             "choose another axis")},
        {"lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
         "large: "
         "are its units metres (--scale 1000)?",
         phrase(
             "lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
             "large: are its units metres? Height makes it larger")},
        {"lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
         "large: "
         "are its units inches (--scale 25.4)?",
         phrase(
             "lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
             "large: are its units inches? Height makes it larger")},
        {"lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
         "large: "
         "make it larger (--scale, --height, a picture's --diameter), or core_radius_mm smaller",
         phrase(
             "lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 "
             "large: make it larger, or core_radius_mm smaller")},
        {"all radii are the core radius of %1 mm: nothing but a plain rod would be carved; larger radii, or "
         "a "
         "smaller core_radius_mm, carve more",
         phrase(
             "all radii are the core radius of %1 mm: nothing but a plain rod would be carved; larger radii, "
             "or a smaller core_radius_mm, carve more")},
        {"lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod "
         "would be carved; it is %2 large: "
         "are its units metres (--scale 1000)?",
         phrase("lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain "
                "rod would be carved; it is %2 large: are its units metres? Height makes it larger")},
        {"lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod "
         "would be carved; it is %2 large: "
         "are its units inches (--scale 25.4)?",
         phrase("lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain "
                "rod would be carved; it is %2 large: are its units inches? Height makes it larger")},
        {"lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod "
         "would be carved; it is %2 large: "
         "make it larger (--scale, --height, a picture's --diameter), or let travel_mm go further in",
         phrase("lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain "
                "rod would be carved; it is %2 large: make it larger, or let travel_mm go further in")},
        {"no radius is beyond that of %1 mm at which the heads' travel ends: nothing but a plain rod would "
         "be carved; larger radii, or a travel_mm that goes further in, carve more",
         phrase("no radius is beyond that of %1 mm at which the heads' travel ends: nothing but a plain rod "
                "would be carved; larger radii, or a travel_mm that goes further in, carve more")},
        {"stands %1 mm above the table, and the blank is only %2 mm high: nothing of it is left to be carved",
         phrase("stands %1 mm above the table, and the blank is only %2 mm high: nothing of it is left to be "
                "carved")},
        {"larger than the machine's travel: axis %1 would have to go to %2 mm, allowed are %3; --height or "
         "--scale make it smaller",
         phrase(
             "larger than the machine's travel: axis %1 would have to go to %2 mm, allowed are %3; choose a "
             "smaller height")},
    };
}

/// What follows the number of a line.
std::vector<Sentence> of_a_line() {
    return {
        {"%1 is not a number: a vertex needs three", phrase("%1 is not a number: a vertex needs three")},
        {"%1 is not a number", phrase("%1 is not a number")},
        {"OFF in other than 3 dimensions", phrase("OFF in other than 3 dimensions")},
        {"OFF that is binary; save it as text", phrase("OFF that is binary; save it as text")},
        {"%1 is not the number of a vertex", phrase("%1 is not the number of a vertex")},
        {"a face needs at least three vertices", phrase("a face needs at least three vertices")},
        {"the face names a vertex that is not there", phrase("the face names a vertex that is not there")},
        {"the file ends in the middle of a facet", phrase("the file ends in the middle of a facet")},
        {"a facet without endfacet", phrase("a facet without endfacet")},
        {"a facet needs three vertices", phrase("a facet needs three vertices")},
        {"%1 is not a word of ASCII STL", phrase("%1 is not a word of ASCII STL")},
    };
}

std::vector<Sentence> of_a_job() {
    return {
        blank_too_large(),
        {"interrupted; nothing has moved", phrase("interrupted; nothing has moved")},
        {"slicing was cancelled", phrase("slicing was cancelled")},
        {"publishing was cancelled", phrase("publishing was cancelled")},
        {"looking for the best axis was cancelled", phrase("looking for the best axis was cancelled")},
        {"not enough memory to slice %1", phrase("not enough memory to slice %1")},
        {"not enough memory for so many layers and points",
         phrase("not enough memory for so many layers and points")},
        {"more points than pulses: %1 points a layer, but half a turn of axis psi has %2 pulses: at most "
         "--points %3",
         phrase("more points than pulses: %1 points a layer, but half a turn of axis Ψ has %2 pulses: choose "
                "at most %3 points")},
        {"%1 points a layer, not %2: half a turn of axis psi has no more pulses",
         phrase("%1 points a layer, not %2: half a turn of axis Ψ has no more pulses")},
        {"in the lowest layer the tool reaches %1 mm below the table's top: the table must be narrower than "
         "the "
         "job, or "
         "base_height_mm more",
         phrase("In the lowest layer the tool reaches %1 mm below the table's top: the table must be "
                "narrower than the "
                "job, or base_height_mm more.")},
        {"grooves %1 mm deep and %2 mm wide; where no point meets the line, up to %3 mm wider along the "
         "layers and %4 mm across them",
         phrase(
             "grooves %1 mm deep and %2 mm wide; where no point meets the line, up to %3 mm wider along the "
             "layers and %4 mm across them")},
        {"the table's %1 points a circle are evened to %2",
         phrase("the table's %1 points a circle are evened to %2")},
        {"%1 layers, not %2: %3 is only %4 mm high, and a layer needs a pulse of axis y",
         phrase("%1 layers, not %2: %3 is only %4 mm high, and a layer needs a pulse of axis Y")},
        {"the job was made for another machine: %1 differ; slice it again with the core's profile",
         phrase(
             "the job was made for another machine (%1 differ); slice it again with the machine's profile")},
        {"job: layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, "
         "or "
         "lower core_radius_mm",
         phrase("layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, "
                "or lower core_radius_mm")},
    };
}

std::vector<Sentence> of_roughing() {
    return {
        {"roughing: the stepdown must be more than 0 mm, and %1 at most, not %2",
         phrase("the stepdown must be more than 0 mm, and %1 at most, not %2")},
        {"roughing: the allowance must be 0 to %1, not %2", phrase("the allowance must be 0 to %1, not %2")},
        {"roughing: the stepover must be more than 0 mm, not %1",
         phrase("the stepover must be more than 0 mm, not %1")},
        {"roughing: a point carves every layer, whatever the stepover; name the tool by --tool",
         phrase("a point carves every layer, whatever the stepover; choose a tool")},
        {"roughing: a stepover of %1 is more than the tool is wide, %2; ask for less by --stepover",
         phrase("a stepover of %1 is more than the tool is wide, %2")},
        {"roughing begins at the blank's surface: say how large it is with --blank RADIUSxHEIGHT or in the "
         "profile's [blank], or leave roughing out with --finish-only",
         phrase(
             "roughing begins at the blank's surface: say how large the blank is, or choose finishing only")},
        {"roughing: a stepdown of %1 makes more than %2 passes",
         phrase("a stepdown of %1 makes more than %2 passes")},
        {"the table has roughing passes of its own: it gets no others",
         phrase("the table has roughing passes of its own: it gets no others")},
        {"no roughing passes: nothing of the blank stands further out than the allowance",
         phrase("no roughing passes: nothing of the blank stands further out than the allowance")},
    };
}

/// "flower.svg line 12: this is not well-formed XML".
std::optional<Phrase> file_line_phrase(const std::string& message) {
    constexpr std::string_view kLine = " line ";
    // From behind: the file's name may have these letters, too.
    for (std::size_t end = message.rfind(kLine); end != std::string::npos && end > 0;
         end = message.rfind(kLine, end - 1)) {
        const auto line = phrase_for({{"line %1: %2", phrase("line %1")}}, message.substr(end + 1));
        if (!line) continue;
        const Phrase file{"%1", {message.substr(0, end)}, {}};
        for (const auto& sentences : {flat_line_refusals(), of_a_line()}) {
            if (auto found = phrase_for(sentences, line->arguments.back()))
                return Phrase{"%1: %2: %3", {}, {file, phrase("line %1", line->arguments.front()), *found}};
        }
    }
    return std::nullopt;
}

/// "holds no line that can be carved (SVG): line 3: <path> is not right": the reason is one of the warnings.
std::optional<Phrase> without_lines_phrase(const Phrase& file, const std::string& rest) {
    const auto no_outline = phrase_for(
        {{"holds no line that can be carved (%1): %2", phrase("holds no line that can be carved (%1)")}},
        rest);
    if (no_outline) {
        return Phrase{"%1: %2: %3",
                      {},
                      {file, phrase("holds no line that can be carved (%1)", no_outline->arguments.front()),
                       warning_phrase(no_outline->arguments.back())}};
    }
    const auto no_lines = phrase_for({{"no lines to engrave: %1", phrase("no lines to engrave")}}, rest);
    if (!no_lines) return std::nullopt;
    return Phrase{
        "%1: %2: %3", {}, {file, phrase("no lines to engrave"), warning_phrase(no_lines->arguments.back())}};
}

/// "model.obj: line 12: 'x' is not a number", and files without lines.
std::optional<Phrase> file_phrase(const std::string& message) {
    for (std::size_t end = message.find(": "); end != std::string::npos; end = message.find(": ", end + 1)) {
        const Phrase file{"%1", {message.substr(0, end)}, {}};
        const std::string rest = message.substr(end + 2);
        if (auto found = without_lines_phrase(file, rest)) return found;
        if (auto found = phrase_for(of_a_file(), rest)) return joined(file, std::move(*found));
        for (const auto& sentences : {flat_refusals(), program_file_refusals()})
            if (auto found = phrase_for(sentences, rest)) return joined(file, std::move(*found));
        const auto line = phrase_for({{"line %1: %2", phrase("line %1")}}, rest);
        if (!line) continue;
        if (auto found = phrase_for(of_a_line(), line->arguments.back()))
            return Phrase{"%1: %2: %3", {}, {file, phrase("line %1", line->arguments.front()), *found}};
    }
    return std::nullopt;
}

}  // namespace

Phrase error_phrase(const std::string& message) {
    if (auto found = phrase_for(of_a_job(), message)) return *found;
    if (auto found = phrase_for(of_roughing(), message)) return *found;
    if (auto found = calibration_phrase(message)) return *found;
    if (auto found = profile_error_phrase(message)) return *found;
    if (auto found = program_error_phrase(message)) return *found;
    if (auto found = file_phrase(message)) return *found;
    if (auto found = file_line_phrase(message)) return *found;
    return phrase("%1", message);
}

Phrase error_phrase(const Error& error) {
    // Of these there is but a text, which may be known.
    const bool is_text = error.said.is_none() || error.said.id == MessageId::job_unsound;
    return is_text ? error_phrase(error.message) : message_phrase(error.said);
}

}  // namespace psicarve::session
