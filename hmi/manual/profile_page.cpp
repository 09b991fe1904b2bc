// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "hmi/manual/man_page.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::manual {
namespace {

constexpr const char* kAboutProfiles =
    "A profile says what a machine is: its axes and motors, its port and wiring, tool and blank. It is a "
    "TOML file. A key that it does not give has the value of the built-in profile, so an empty file is that "
    "profile.";
constexpr const char* kAboutValues =
    "An unknown key, a wrong type or an impossible value is refused with file, line and key: psicarve "
    "profile check looks at a file, psicarve profile show prints every key with its value. A job carries the "
    "profile that it was made for; where a key matters to motion, the core refuses jobs that were made for "
    "another value.";

std::string table_of_key(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string key_entry(const ProfileKey& key) {
    std::string text = ".TP\n\\fB" + man_text(key.path) + "\\fR";
    if (!key.unit.empty()) text += " [" + man_text(key.unit) + "]";
    text += "\n" + man_paragraph(man_text(key.explanation)) + "\nBounds: " + man_text(key.bounds) +
            ". Built in: \\fB" + man_text(key.built_in) + "\\fR.\n";
    return text + (key.matters_to_motion ? "Matters to motion.\n" : "");
}

}  // namespace

std::string profile_page(const Edition& edition) {
    std::string text =
        man_head("psicarve-profile", "5", "machine profiles of the two-head engraver", edition) +
        ".SH DESCRIPTION\n" + man_paragraph(man_text(kAboutProfiles)) + "\n.PP\n" +
        man_paragraph(man_text(kAboutValues)) + "\n.SH KEYS\n";
    std::string table;
    for (const ProfileKey& key : profile_keys()) {
        if (const std::string next = table_of_key(key.path); next != table) {
            table = next;
            text += ".SS [" + man_text(table) + "]\n";
        }
        text += key_entry(key);
    }
    return text + man_also({"psicarve(1)", "psicarve-profile(1)", "psicarve-rtcore(1)"});
}

}  // namespace psicarve::manual
