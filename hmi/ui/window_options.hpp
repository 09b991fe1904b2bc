// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/ui/language.hpp"

namespace psicarve::ui {

/// Whether the views of the space are drawn with OpenGL.
enum class OpenGl : std::uint8_t {
    automatic,  ///< where a graphics card does it
    always,     ///< also where the processor has to
    never,
};

/// What stands on the command line of psicarve-hmi.
struct WindowOptions {
    std::string path;  ///< model, job or recording to open; empty: none
    std::string segment_name;
    std::string group;
    std::string state_folder;
    std::string profile_path;
    std::string language;  ///< a code of kLanguages; empty: as in the settings
    OpenGl opengl = OpenGl::automatic;
    /// The program ends at once: with this text and this exit code.
    std::optional<int> exit_code;
    std::string text;
};

/// Arguments without the program's name.
WindowOptions parse_window_options(const std::vector<std::string>& arguments);

}  // namespace psicarve::ui
