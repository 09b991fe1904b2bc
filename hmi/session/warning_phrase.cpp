// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/warning_phrase.hpp"

#include <vector>

#include "hmi/session/sentence.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> sentences() {
    return {
        {"%1 of the surface lies behind another part and cannot be reached; --axis-at best would lose %2 of "
         "the surface and %3 of the layers",
         phrase("%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, "
                "%2 of "
                "the surface and %3 of the layers would be lost.")},
        {"%1 of the surface lies behind another part and cannot be reached",
         phrase("%1 of the surface lies behind another part and cannot be reached.")},
        {"%1 of %2 layers do not contain the axis; --axis-at best would lose %3 of the surface and %4 of the "
         "layers",
         phrase("%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 "
                "of the "
                "layers would be lost.")},
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
        {"the file ends without endsolid", phrase("The file ends without endsolid.")},
    };
}

}  // namespace

Phrase warning_phrase(const std::string& warning) {
    return phrase_for(sentences(), warning).value_or(phrase("%1", warning));
}

}  // namespace psicarve::session
