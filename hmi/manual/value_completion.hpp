// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

/// What a shell may offer for a value.
struct ValueCompletion {
    std::vector<std::string> words;    ///< as they are typed; the user goes on typing behind one that ends in
                                       ///< = or :
    std::vector<std::string> endings;  ///< of files, without their dot
    bool any_file = false;             ///< files of any ending
    bool groups = false;               ///< the computer's groups
    bool users = false;

    bool is_of_files() const { return any_file || !endings.empty(); }
    bool is_empty() const { return words.empty() && !is_of_files() && !groups && !users; }
};

/// By its type, "x|y|z", "JOB", "OUT.png"; for a FILE by the option's name (--profile FILE).
ValueCompletion completion_of(const OptionRow& option);
/// By its words or its name; for a FILE by the name of its group of commands (profile check FILE).
ValueCompletion completion_of(const ArgumentRow& argument, const std::vector<std::string>& command_words);

/// Whether the user goes on typing behind this value, so that no blank follows it.
bool goes_on(const std::string& word);

/// Whether the option has a value.
inline bool takes_value(const OptionRow& option) {
    return !option.type.empty();
}

}  // namespace psicarve::manual
