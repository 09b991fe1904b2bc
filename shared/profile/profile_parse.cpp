// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <type_traits>

#include "shared/base/nearest.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/profile_table.hpp"
#include "shared/profile/toml_library.hpp"

namespace psicarve {
namespace {

using namespace profile_detail;  // NOLINT(google-build-using-namespace): this is one of its source files

constexpr std::size_t kQuotedBytes = 60;  // of foreign text in a message

/// Makes foreign text fit for one line of a message.
std::string printable(std::string_view text, std::size_t most = kQuotedBytes) {
    std::string result;
    for (const char c : text.substr(0, most)) {
        const auto byte = static_cast<unsigned char>(c);
        result += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    return text.size() > most ? result + "..." : result;
}

/// Whether a known key stands in this table ("axis.r1"; empty: the top).
bool has_keys(std::string_view table) {
    return std::any_of(key_table().begin(), key_table().end(),
                       [&](const KeySpec& key) { return table_of_key(key.path) == table; });
}

/// The known key that was meant: one of the same table, never of another, where a similar name means
/// something else. For an unknown table: the nearest table's name.
std::string suggestion_for(const std::string& path) {
    constexpr std::size_t kLongestGuess = 80;
    const std::string nothing = "see profile show for all keys";
    if (path.size() > kLongestGuess) return nothing;
    const std::string_view table = table_of_key(path);
    std::vector<std::string> names;
    for (const KeySpec& key : key_table()) {
        const std::string_view its_table = table_of_key(key.path);
        if (its_table == table) names.emplace_back(leaf_of_key(key.path));
        if (its_table.empty() || !has_keys(its_table)) continue;
        // "axis.r1" beside "axis.x", "job" beside "jobs"
        if (table_of_key(its_table) == table) names.emplace_back(leaf_of_key(its_table));
    }
    const auto meant = nearest(leaf_of_key(path), names);
    if (!meant) return nothing;
    return "did you mean " + (table.empty() ? "" : std::string{table} + ".") + *meant + "?";
}

bool is_table_path(const std::string& path) {
    return std::any_of(key_table().begin(), key_table().end(), [&path](const KeySpec& key) {
        return key.path.size() > path.size() && key.path[path.size()] == '.' && key.path.starts_with(path);
    });
}

const char* type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number with a fraction";
        case toml::node_type::boolean:
            return "true or false";
        case toml::node_type::none:
            break;
        default:
            return "a date or time";
    }
    return "nothing";
}

std::string table_expected(const std::string& path, const toml::node& node) {
    std::string text = type_name(node);
    text.append(" where the table [").append(path).append("] is expected; put its keys below [");
    return text.append(path).append("]");
}

/// Reads one profile: keeps every problem with its line, so that the first in the file can be reported.
class Reader {
public:
    void read(std::string_view text);
    /// The problems found, in the order of their lines.
    std::vector<ProfileProblem> take_problems();
    /// Without problems: what the text says. With them: the part that could be read.
    const Profile& profile() const { return profile_; }
    bool is_each_value_read() const { return is_each_value_read_; }

private:
    void read_table(const toml::table& table, const std::string& prefix);
    void read_node(const std::string& path, const toml::node& node);
    void note(std::int64_t line, const std::string& key, std::string text);

    /// Stores the value in the profile, or returns what is wrong with it.
    static std::string store(const KeySpec& key, const toml::node& node, Profile& profile);
    void locate(Problem problem);

    Profile profile_;
    std::vector<ProfileProblem> found_;
    std::map<std::string, std::int64_t> lines_;
    bool is_each_value_read_ = false;
};

void Reader::note(std::int64_t line, const std::string& key, std::string text) {
    found_.push_back({line, key, std::move(text)});
}

void Reader::read_table(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
        const std::string_view name = key.str();
        const std::int64_t line = key.source().begin.line;
        std::string path = prefix;
        path += name;
        const bool quoted_dot = name.find('.') != std::string_view::npos;  // "a.b" = 1 is not a.b = 1
        if (!quoted_dot && find_key(path) != nullptr) {
            lines_[path] = line;
            read_node(path, node);
        } else if (!quoted_dot && is_table_path(path)) {
            if (const toml::table* inner = node.as_table()) {
                path += '.';
                read_table(*inner, path);
            } else {
                note(line, path, table_expected(path, node));
            }
        } else {
            note(line, printable(path), "unknown key; " + suggestion_for(path));
        }
    }
}

void Reader::read_node(const std::string& path, const toml::node& node) {
    std::string problem = store(*find_key(path), node, profile_);
    if (!problem.empty()) note(node.source().begin.line, path, std::move(problem));
}

/// Checks a number of any kind against the key's bounds; returns what is wrong.
std::string number_problem(const KeySpec& key, double value) {
    const std::string unit = key.unit.empty() || key.unit == "pin" ? "" : " " + key.unit;
    if (!std::isfinite(value)) return number_text(value) + " is no number to work with; give a finite one";
    if (value < key.bounds.least || value > key.bounds.greatest) {
        return number_text(value) + unit + " is impossible; give a value from " +
               number_text(key.bounds.least) + " to " + number_text(key.bounds.greatest) + unit;
    }
    return {};
}

std::string wrong_type(const toml::node& node, const char* wanted) {
    return std::string(type_name(node)) + " where " + wanted + " is expected; correct the value";
}

std::string store_real(const KeySpec& key, const toml::node& node, double& field) {
    double value = 0.0;
    if (const auto* real = node.as_floating_point()) {
        value = real->get();
    } else if (const auto* integer = node.as_integer()) {
        value = static_cast<double>(integer->get());
    } else {
        return wrong_type(node, "a number");
    }
    std::string problem = number_problem(key, value);
    if (problem.empty()) field = value + 0.0;  // -0.0 becomes 0.0
    return problem;
}

template <typename Integer>
std::string store_integer(const KeySpec& key, const toml::node& node, Integer& field) {
    const auto* integer = node.as_integer();
    if (integer == nullptr) return wrong_type(node, "a whole number");
    std::string problem = number_problem(key, static_cast<double>(integer->get()));
    if (problem.empty()) field = static_cast<Integer>(integer->get());
    return problem;
}

std::string store_text(const KeySpec& key, const toml::node& node, std::string& field) {
    const auto* text = node.as_string();
    if (text == nullptr) return wrong_type(node, "a string");
    const std::string& value = text->get();
    const auto length = static_cast<double>(value.size());
    if (length < key.bounds.least || length > key.bounds.greatest) {
        return "a text of " + std::to_string(value.size()) + " bytes; give " + bounds_text(key);
    }
    if (printable(value, value.size()) != value) return "a control character in the text; remove it";
    field = value;
    return {};
}

std::string store_range(const KeySpec& key, const toml::node& node, std::array<double, 2>& field) {
    const auto* pair = node.as_array();
    if (pair == nullptr || pair->size() != 2) return wrong_type(node, "an array of two numbers");
    for (std::size_t i = 0; i < 2; ++i) {
        std::string problem = store_real(key, (*pair)[i], field[i]);
        if (!problem.empty()) return problem;
    }
    return {};
}

template <typename T>
std::string store_word(const KeySpec& key, const toml::node& node, T& field) {
    const auto* text = node.as_string();
    if (text == nullptr) return wrong_type(node, bounds_text(key).c_str());
    for (const Word& word : key.words) {
        if (word.text != text->get()) continue;
        field = static_cast<T>(word.value);
        return {};
    }
    return "\"" + printable(text->get()) + "\" is not possible here; give " + bounds_text(key);
}

std::string Reader::store(const KeySpec& key, const toml::node& node, Profile& profile) {
    return std::visit(
        [&](auto* field) -> std::string {
            using T = std::remove_cvref_t<decltype(*field)>;
            if constexpr (std::is_same_v<T, double>)
                return store_real(key, node, *field);
            else if constexpr (std::is_same_v<T, std::string>)
                return store_text(key, node, *field);
            else if constexpr (std::is_same_v<T, std::array<double, 2>>)
                return store_range(key, node, *field);
            else if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>)
                return store_word(key, node, *field);
            else
                return store_integer(key, node, *field);
        },
        key.field(profile));
}

void Reader::locate(Problem problem) {
    std::vector<std::string> keys{problem.key};
    keys.insert(keys.end(), problem.also.begin(), problem.also.end());
    std::int64_t line = 0;
    for (const std::string& key : keys) {
        const auto given = lines_.find(key);
        if (given == lines_.end() || given->second <= line) continue;
        line = given->second;
        if (!problem.blame_later) break;
        problem.key = key;
    }
    note(line, problem.key, std::move(problem.text));
}

void Reader::read(std::string_view text) {
    if (text.size() > kProfileTextBytes) {
        note(1, "",
             "the profile is " + std::to_string(text.size()) + " bytes long; the most is " +
                 std::to_string(kProfileTextBytes));
        return;
    }
    const toml::parse_result parsed = toml::parse(text);
    if (!parsed) {
        const toml::parse_error& error = parsed.error();
        note(error.source().begin.line, "",
             "this is not TOML: " + printable(error.description(), 200) + "; correct the line");
        return;
    }
    read_table(parsed.table(), "");
    is_each_value_read_ = found_.empty();
    if (!is_each_value_read_) return;
    if (auto problem = check_profile(profile_)) locate(*std::move(problem));
}

std::vector<ProfileProblem> Reader::take_problems() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const ProfileProblem& a, const ProfileProblem& b) { return a.line < b.line; });
    return std::move(found_);
}

}  // namespace

Result<Profile> parse_profile(std::string_view toml, std::string_view file_name) {
    Reader reader;
    reader.read(toml);
    const std::vector<ProfileProblem> problems = reader.take_problems();
    if (problems.empty()) return reader.profile();
    const ProfileProblem& first = problems.front();
    return bad_input(printable(file_name, 4096) + ":" +
                     std::to_string(std::max<std::int64_t>(first.line, 1)) + ": " +
                     (first.key.empty() ? "" : first.key + ": ") + first.text);
}

std::vector<ProfileProblem> profile_problems(std::string_view toml) {
    return read_profile(toml).problems;
}

ProfileReading read_profile(std::string_view toml) {
    Reader reader;
    reader.read(toml);
    return {reader.profile(), reader.take_problems(), reader.is_each_value_read()};
}

Result<Profile> load_profile(const std::string& path) {
    // One byte more than allowed is enough to be refused.
    const auto bytes = read_file_start(path, kProfileTextBytes + 1);
    if (!bytes) return bytes.error();
    return parse_profile({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path);
}

}  // namespace psicarve
