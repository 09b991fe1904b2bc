// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/value_completion.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <sstream>

#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::manual {
namespace {

using Endings = std::vector<std::string>;

const Endings kModelEndings{"stl", "obj",  "ply", "3mf",  "off", "svg", "dxf", "png",
                            "jpg", "jpeg", "tif", "tiff", "bmp", "pgm", "csv"};
const Endings kJobEndings{"job", "snap", "psi"};

/// The meaning of the words in capitals, wherever they are the type of a value. For a file to be written only
/// the ending is known.
const std::map<std::string, Endings>& endings_by_type() {
    static const std::map<std::string, Endings> endings{
        {"MODEL", kModelEndings},
        {"JOB", kJobEndings},
        {"JOB_A", kJobEndings},
        {"JOB_B", kJobEndings},
        {"SNAPSHOT", kJobEndings},
        {"PROFILE", {"toml", "job", "snap", "psi"}},
        {"MACHINE", {"toml", "job", "snap", "psi"}},
        {"REPLAY", kJobEndings},
        {"TRACE", {"vcd", "trace"}},
        {"PIECE", {"stl", "ply"}},
        // Of `profile set`, which takes the file last.
        {"KEY=VALUE", {"toml"}},
    };
    return endings;
}

std::vector<std::string> axis_words(const std::string& tail) {
    std::vector<std::string> words;
    words.reserve(kAxisCount);
    for (const Axis axis : kAllAxes) words.push_back(std::string{name_of(axis)} + tail);
    return words;
}

std::vector<std::string> output_words() {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if (is_output(signal)) words.emplace_back(name_of(signal));
    }
    return words;
}

std::vector<std::string> tool_words() {
    std::vector<std::string> words;
    for (const ToolShape shape : {ToolShape::point, ToolShape::ball, ToolShape::flat, ToolShape::vee})
        words.push_back(std::string{name_of(shape)} + (shape == ToolShape::point ? "" : ":"));
    return words;
}

std::vector<std::string> key_words(const std::string& tail) {
    std::vector<std::string> words;
    for (const ProfileKey& key : profile_keys()) words.push_back(key.path + tail);
    return words;
}

const std::map<std::string, std::vector<std::string>>& words_by_type() {
    static const std::map<std::string, std::vector<std::string>> words{
        {"AXIS", axis_words("")},
        {"AXIS=POSITION", axis_words("=")},
        {"AXIS=POSITION,...", axis_words("=")},
        {"SIGNAL", output_words()},
        {"SHAPE:MM", tool_words()},
        {"KEY", key_words("")},
        {"KEY=VALUE", key_words("=")},
    };
    return words;
}

/// "here" of "MM|here": a word that is typed literally.
bool is_word(const std::string& part) {
    const auto is_of_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
    return !part.empty() && std::islower(static_cast<unsigned char>(part.front())) != 0 &&
           std::all_of(part.begin(), part.end(), is_of_word);
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

template <typename Value>
void append(std::vector<Value>& to, const std::vector<Value>& from) {
    for (const Value& value : from) {
        if (std::find(to.begin(), to.end(), value) == to.end()) to.push_back(value);
    }
}

/// `owner`: in capitals, the name that a FILE or a NAME belongs to.
void add_part(const std::string& part, const std::string& owner, ValueCompletion& completion) {
    const std::size_t dot = part.rfind('.');
    const auto words = words_by_type().find(part);
    if (words != words_by_type().end()) append(completion.words, words->second);
    if (is_word(part)) {
        completion.words.push_back(part);
    } else if (const auto known = endings_by_type().find(part); known != endings_by_type().end()) {
        append(completion.endings, known->second);
    } else if (part == "FILE") {
        const auto of_owner = endings_by_type().find(owner);
        if (of_owner == endings_by_type().end()) completion.any_file = true;
        if (of_owner != endings_by_type().end()) append(completion.endings, of_owner->second);
    } else if (part == "FOLDER") {
        completion.any_file = true;  // on the way to it
    } else if (part == "NAME") {
        completion.groups |= owner == "GROUP";
        completion.users |= owner == "USER";
    } else if (dot != std::string::npos && is_word(part.substr(dot + 1))) {
        append(completion.endings, {part.substr(dot + 1)});
    }
}

ValueCompletion completion_of_type(const std::string& type, const std::string& owner) {
    ValueCompletion completion;
    std::istringstream parts{type};
    for (std::string part; std::getline(parts, part, '|');) add_part(part, owner, completion);
    return completion;
}

}  // namespace

ValueCompletion completion_of(const OptionRow& option) {
    const std::string& name = option.names.back();
    const std::size_t first = name.find_first_not_of('-');
    return completion_of_type(option.type, first == std::string::npos ? "" : upper(name.substr(first)));
}

ValueCompletion completion_of(const ArgumentRow& argument, const std::vector<std::string>& command_words) {
    const std::string group = command_words.size() > 2 ? upper(command_words[1]) : "";
    return completion_of_type(argument.type.empty() ? argument.name : argument.type, group);
}

bool goes_on(const std::string& word) {
    return !word.empty() && (word.back() == '=' || word.back() == ':');
}

}  // namespace psicarve::manual
