// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

/// What a shell may offer where a value stands.
struct ValueCompletion {
    std::vector<std::string> words;    ///< as they are typed; one that ends in = or : goes on
    std::vector<std::string> endings;  ///< of files, without their dot
    bool any_file = false;             ///< whatever they end in
    bool groups = false;               ///< the computer's groups
    bool users = false;

    bool is_of_files() const { return any_file || !endings.empty(); }
    bool is_empty() const { return words.empty() && !is_of_files() && !groups && !users; }
};

/// By its type, "x|y|z", "JOB", "OUT.png"; a FILE is what its option is named after (--profile FILE).
ValueCompletion completion_of(const OptionRow& option);
/// By its words or its name; a FILE is what its group of commands is named after (profile check FILE).
ValueCompletion completion_of(const ArgumentRow& argument, const std::vector<std::string>& command_words);

/// Whether a value of this option is not to be followed by a blank.
bool goes_on(const std::string& word);

/// Whether the option has a value.
inline bool takes_value(const OptionRow& option) {
    return !option.type.empty();
}

}  // namespace psicarve::manual
