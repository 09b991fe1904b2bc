// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

const Tokens& tokens_of(Theme theme) {
    static const Tokens kLight{.win = "#D9DEE4",
                               .panel = "#F4F6F8",
                               .field = "#FFFFFF",
                               .view = "#E9EDF1",
                               .raised = "#E6EAEE",
                               .sel = "#D3DAE2",
                               .line = "#BFC7D0",
                               .edge = "#768290",
                               .text = "#12171D",
                               .text2 = "#47525F",
                               .dis = "#616D7A",
                               .run = "#00654D",
                               .run_fill = "#00755A",
                               .warn = "#6B4800",
                               .warn_fill = "#FFD45A",
                               .warn_ground = "#FFF4D2",
                               .alarm = "#B3141C",
                               .alarm_fill = "#B3141C",
                               .alarm_ground = "#FBE4E3",
                               .sim = "#5B3A9E",
                               .sim_fill = "#5B3A9E",
                               .r1 = "#0A5FA5",
                               .r2 = "#B04A00",
                               .idle_fill = "#56616E",
                               .on_fill = "#FFFFFF",
                               .on_warn = "#1A1300"};
    static const Tokens kDark{.win = "#0B0D10",
                              .panel = "#181C21",
                              .field = "#0E1114",
                              .view = "#0E1114",
                              .raised = "#272E36",
                              .sel = "#333C46",
                              .line = "#323A44",
                              .edge = "#707C8A",
                              .text = "#E8ECF0",
                              .text2 = "#A7B2BE",
                              .dis = "#7C8794",
                              .run = "#35C99E",
                              .run_fill = "#0A7D60",
                              .warn = "#FFCB47",
                              .warn_fill = "#FFCB47",
                              .warn_ground = "#2E2710",
                              .alarm = "#FF7F78",
                              .alarm_fill = "#C9252D",
                              .alarm_ground = "#3A1619",
                              .sim = "#BBA2FF",
                              .sim_fill = "#6A49B8",
                              .r1 = "#5BB0F5",
                              .r2 = "#FF9D4D",
                              .idle_fill = "#55606D",
                              .on_fill = "#FFFFFF",
                              .on_warn = "#1A1300"};
    return theme == Theme::light ? kLight : kDark;
}

QColor fill_of(const Tokens& tokens, session::Tone tone) {
    switch (tone) {
        case session::Tone::idle:
            return tokens.idle_fill;
        case session::Tone::run:
            return tokens.run_fill;
        case session::Tone::warn:
            return tokens.warn_fill;
        case session::Tone::alarm:
            return tokens.alarm_fill;
        case session::Tone::replay:
            return tokens.sim_fill;
    }
    return tokens.idle_fill;
}

QColor ink_of(const Tokens& tokens, session::Tone tone) {
    return tone == session::Tone::warn ? tokens.on_warn : tokens.on_fill;
}

}  // namespace psicarve::ui
