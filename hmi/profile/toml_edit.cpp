// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/toml_edit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "hmi/profile/text_places.hpp"
#include "shared/profile/profile_text.hpp"
#include "shared/profile/toml_library.hpp"

namespace psicarve::profile {
namespace {

using Keys = std::vector<std::string_view>;

Keys keys_of(std::string_view path) {
    Keys keys;
    for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
        keys.push_back(path.substr(0, dot));
        path.remove_prefix(dot + 1);
    }
    keys.push_back(path);
    return keys;
}

/// Whether both have the same value, at any place. Not toml++'s ==, for which nan is not nan.
bool is_same(const toml::node& a, const toml::node& b) {
    if (a.type() != b.type()) return false;
    if (const toml::table* table = a.as_table()) {
        const auto is_there = [&](const auto& entry) {
            const toml::node* const other = b.as_table()->get(entry.first.str());
            return other != nullptr && is_same(entry.second, *other);
        };
        return table->size() == b.as_table()->size() && std::all_of(table->begin(), table->end(), is_there);
    }
    if (const toml::array* array = a.as_array())
        return std::equal(array->begin(), array->end(), b.as_array()->begin(), b.as_array()->end(), is_same);
    return a.visit([&](const auto& value) {
        using Node = std::remove_cvref_t<decltype(value)>;
        if constexpr (!toml::is_value<Node>) {
            return false;
        } else {
            if constexpr (toml::is_floating_point<Node>)
                if (std::isnan(value.get())) return std::isnan(b.as_floating_point()->get());
            return value == *b.as<typename Node::value_type>();
        }
    });
}

struct Bytes {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Bytes bytes_of(const toml::node& node, const TextPlaces& places) {
    const toml::source_region& place = node.source();
    return {places.offset_of(place.begin.line, place.begin.column),
            places.offset_of(place.end.line, place.end.column)};
}

/// How many of the tables that lead to a key exist.
struct Way {
    const toml::table* table = nullptr;    ///< the innermost of them
    std::string_view rest;                 ///< of the path, from there on
    const toml::table* braces = nullptr;   ///< the innermost of them that is written `{ ... }`
    std::string_view rest_in_braces = {};  ///< of the path, from there on
    const toml::node* next = nullptr;      ///< has the name of the first key of the rest
    bool is_whole = false;                 ///< the rest is the last key alone
};

Way way_to(const toml::table& root, std::string_view path) {
    Way way{.table = &root, .rest = path};
    for (const std::string_view key : keys_of(path)) {
        way.next = way.table->get(key);
        way.is_whole = key.size() == way.rest.size();
        if (way.is_whole || way.next == nullptr || !way.next->is_table()) break;
        way.table = way.next->as_table();
        way.rest.remove_prefix(key.size() + 1);
        if (!way.table->is_inline()) continue;
        way.braces = way.table;
        way.rest_in_braces = way.rest;
    }
    return way;
}

/// `root` with the value changed or added.
toml::table changed_tree(const toml::table& root, std::string_view path, const toml::node& value) {
    toml::table changed = root;
    toml::table* table = &changed;
    Keys keys = keys_of(path);
    const std::string_view leaf = keys.back();
    keys.pop_back();
    for (const std::string_view key : keys)
        table = table->insert(key, toml::table{}).first->second.as_table();
    value.visit([&](const auto& node) { table->insert_or_assign(leaf, node); });
    return changed;
}

struct Edit {
    Bytes old;
    std::string text;

    std::string applied_to(std::string_view all) const {
        return std::string{all.substr(0, old.begin)}.append(text).append(all.substr(old.end));
    }
};

Edit insertion(std::size_t offset, std::string text) {
    return {{offset, offset}, std::move(text)};
}

/// The places of a table's keys in the text, and those where another one may go.
class TableText {
public:
    TableText(std::string_view text, const TextPlaces& places, const toml::table& table)
        : text_{text}, places_{places}, table_{table} {}

    /// The edits that may put `line`, "key = value", into a table that is written on lines: likeliest first;
    /// not each is valid.
    std::vector<Edit> below_its_lines(const std::string& line) const {
        std::vector<Edit> all;
        const toml::key* last_key = nullptr;
        std::size_t last = 0;
        for (const auto& [key, node] : table_) {
            if (is_headed(node) || end_of(node) <= last) continue;
            last = end_of(node);
            last_key = &key;
        }
        if (last_key != nullptr) {
            // Of dotted keys also what stands before their last part.
            const std::size_t key = begin_of(last_key->source());
            std::string_view dotted = text_.substr(places_.line_begin(key), key - places_.line_begin(key));
            dotted.remove_prefix(std::min(dotted.find_first_not_of(" \t"), dotted.size()));
            all.push_back(line_after(last, std::string{dotted} + line));
        }
        if (has_bracket(table_)) all.push_back(line_after(begin_of(table_.source()), line));
        all.push_back(insertion(places_.text_begin(), line + std::string{places_.newline()}));
        return all;
    }
    /// The same for one written `{ ... }`.
    Edit within_braces(const std::string& line) const {
        std::size_t last = 0;
        for (const auto& [key, node] : table_) last = std::max(last, end_of(node));
        if (last > 0) return insertion(last, ", " + line);
        return insertion(begin_of(table_.source()) + 1, " " + line + " ");
    }

private:
    std::size_t begin_of(const toml::source_region& region) const {
        return places_.offset_of(region.begin.line, region.begin.column);
    }
    /// End of a value; for a table of dotted keys, of the last of them.
    std::size_t end_of(const toml::node& node) const {
        const toml::table* const table = node.as_table();
        if (table == nullptr || table->is_inline()) return bytes_of(node, places_).end;
        std::size_t end = 0;
        for (const auto& [key, inner] : *table)
            if (!is_headed(inner)) end = std::max(end, end_of(inner));
        return end;
    }
    bool has_bracket(const toml::node& node) const {
        const std::size_t begin = begin_of(node.source());
        return begin < text_.size() && text_[begin] == '[';
    }
    /// Whether it has `[headers]` of its own, and so stands below the lines of the table that it is in.
    bool is_headed(const toml::node& node) const {
        const toml::array* const array = node.as_array();
        return has_bracket(node) && (node.is_table() || (!array->empty() && array->front().is_table() &&
                                                         has_bracket(array->front())));
    }
    Edit line_after(std::size_t offset, const std::string& line) const {
        const std::size_t end = places_.line_end(offset);
        const std::string newline{places_.newline()};
        const bool is_ended = end > 0 && text_[end - 1] == '\n';
        return insertion(end, is_ended ? line + newline : newline + line);
    }

    std::string_view text_;
    const TextPlaces& places_;
    const toml::table& table_;
};

/// A table of its own at the end, after an empty line.
Edit table_at_the_end(std::string_view text, std::string_view newline, std::string_view path,
                      std::string_view toml) {
    const std::size_t dot = path.rfind('.');
    const std::string end{newline};
    std::string added;
    if (!text.empty() && text.back() != '\n') added += end;
    if (!text.empty() && !text.ends_with(end + end)) added += end;
    added.append("[").append(path.substr(0, dot)).append("]").append(end);
    added.append(path.substr(dot + 1)).append(" = ").append(toml).append(end);
    return insertion(text.size(), std::move(added));
}

std::vector<Edit> insertions(std::string_view text, const TextPlaces& places, const Way& way,
                             std::string_view path, std::string_view toml) {
    const std::string said = " = " + std::string{toml};
    if (way.braces != nullptr) {
        const TableText table{text, places, *way.braces};
        return {table.within_braces(std::string{way.rest_in_braces} + said)};
    }
    std::vector<Edit> all = TableText{text, places, *way.table}.below_its_lines(std::string{way.rest} + said);
    if (path.find('.') == std::string_view::npos) return all;
    // Where the table is there, its own lines come first; else a table of its own does.
    all.insert(way.is_whole ? all.end() : all.begin(), table_at_the_end(text, places.newline(), path, toml));
    return all;
}

/// `[header]`, `{ ... }`, dotted keys, `[[headers]]`.
bool is_table_of_any_kind(const toml::node& node) {
    const toml::array* const array = node.as_array();
    const toml::table* const first = array == nullptr || array->empty() ? nullptr : array->front().as_table();
    return node.is_table() || (first != nullptr && !first->is_inline());
}

Error refused(std::int64_t line, const std::string& why) {
    return bad_input("line " + std::to_string(std::max<std::int64_t>(line, 1)) + ": " + why);
}

Error no_toml(const toml::parse_error& error) {
    return refused(error.source().begin.line, "this is not TOML: " + std::string{error.description()});
}

}  // namespace

Result<std::string> with_value(std::string_view text, std::string_view path, std::string_view toml) {
    const toml::parse_result read = toml::parse(text);
    if (!read) return no_toml(read.error());
    const toml::parse_result value = toml::parse("value = " + std::string{toml});
    if (!value) return bad_input(std::string{toml} + " is no value of TOML");
    const TextPlaces places{text};
    const Way way = way_to(read.table(), path);
    const std::string name{path};
    const bool is_there = way.next != nullptr;
    if (is_there && (!way.is_whole || is_table_of_any_kind(*way.next))) {
        return refused(way.next->source().begin.line,
                       name + " has no place: " + (is_table_of_any_kind(*way.next) ? "a table" : "a value") +
                           " of that name stands here; rename it");
    }
    const toml::table wanted = changed_tree(read.table(), path, *value.table().get("value"));
    for (const Edit& edit : is_there ? std::vector<Edit>{{bytes_of(*way.next, places), std::string{toml}}}
                                     : insertions(text, places, way, path, toml)) {
        const std::string result = edit.applied_to(text);
        const toml::parse_result again = toml::parse(result);
        if (again && is_same(again.table(), wanted)) return result;
    }
    return refused((is_there ? way.next : way.table)->source().begin.line,
                   name + " cannot be set as this is written; give its table a header, [" +
                       std::string{table_of_key(path)} + "], and each key a line below it");
}

std::optional<std::string> value_in(std::string_view text, std::string_view path) {
    const toml::parse_result read = toml::parse(text);
    if (!read) return std::nullopt;
    const Way way = way_to(read.table(), path);
    if (way.next == nullptr || !way.is_whole || is_table_of_any_kind(*way.next)) return std::nullopt;
    const Bytes value = bytes_of(*way.next, TextPlaces{text});
    return std::string{text.substr(value.begin, value.end - value.begin)};
}

}  // namespace psicarve::profile
