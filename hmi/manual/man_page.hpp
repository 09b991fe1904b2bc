// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

/// The text at the head and foot of each page.
struct Edition {
    std::string version;  ///< "0.1.0"
    std::string date;     ///< of that version, "2026-11-26"
};

/// A page in man(7)'s own language. `also`: other pages, as "psicarve(1)". Equal tables give equal bytes.
std::string man_page(const PlacedCommand& command, const std::vector<std::string>& also,
                     const Edition& edition);
/// Makes "psicarve-snapshot-save" of its words.
std::string page_name(const std::vector<std::string>& words);

/// psicarve-profile(5): every key of a machine profile.
std::string profile_page(const Edition& edition);

/// Text for man(7): no part of it acts as a request.
std::string man_text(const std::string& text);
/// The text of man_text, in lines of at most 80 bytes where words allow.
std::string man_paragraph(const std::string& text);
/// The first lines of a page, to the section NAME.
std::string man_head(const std::string& name, const std::string& section, const std::string& summary,
                     const Edition& edition);
std::string man_also(const std::vector<std::string>& also);

}  // namespace psicarve::manual
