// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/warning_phrase.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace psicarve::session {
namespace {

struct Sentence {
    std::string_view said;  ///< %1, %2 ... in their order
    Phrase shown;
};

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

/// What stands for %1, %2 ... when the text is such a sentence.
std::optional<std::vector<std::string>> arguments_of(std::string_view said, std::string_view text) {
    std::vector<std::string> arguments;
    for (;;) {
        const std::size_t mark = said.find('%');
        const std::string_view before = said.substr(0, mark);
        if (!text.starts_with(before)) return std::nullopt;
        text.remove_prefix(before.size());
        if (mark == std::string_view::npos) break;
        said.remove_prefix(mark + 2);
        const std::string_view after = said.substr(0, said.find('%'));
        const std::size_t end = after.empty() ? text.size() : text.find(after);
        if (end == std::string_view::npos) return std::nullopt;
        arguments.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    if (!text.empty()) return std::nullopt;
    return arguments;
}

}  // namespace

Phrase warning_phrase(const std::string& warning) {
    for (Sentence& sentence : sentences()) {
        if (auto arguments = arguments_of(sentence.said, warning)) {
            sentence.shown.arguments = std::move(*arguments);
            return sentence.shown;
        }
    }
    return phrase("%1", warning);
}

}  // namespace psicarve::session
