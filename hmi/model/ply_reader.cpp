// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/text_mesh_readers.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/model/whole_file.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

enum class Kind { none, i8, u8, i16, u16, i32, u32, f32, f64 };

struct KindName {
    std::string_view name;
    Kind kind;
};
constexpr std::array<KindName, 16> kKindNames{{{"char", Kind::i8},
                                               {"int8", Kind::i8},
                                               {"uchar", Kind::u8},
                                               {"uint8", Kind::u8},
                                               {"short", Kind::i16},
                                               {"int16", Kind::i16},
                                               {"ushort", Kind::u16},
                                               {"uint16", Kind::u16},
                                               {"int", Kind::i32},
                                               {"int32", Kind::i32},
                                               {"uint", Kind::u32},
                                               {"uint32", Kind::u32},
                                               {"float", Kind::f32},
                                               {"float32", Kind::f32},
                                               {"double", Kind::f64},
                                               {"float64", Kind::f64}}};

Kind kind_of(std::string_view name) noexcept {
    for (const KindName& known : kKindNames) {
        if (known.name == name) return known.kind;
    }
    return Kind::none;
}

template <typename T>
double value_of(const std::array<char, 8>& bytes) noexcept {
    T value{};
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
}

bool is_whole_below(double value, std::size_t end) noexcept {
    return value >= 0.0 && value < static_cast<double>(end) && value == std::floor(value);
}

struct Property {
    std::string_view name;
    Kind kind = Kind::none;
    Kind count_kind = Kind::none;  ///< of a list; none: a single value
};

struct Element {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& path) : bytes_(bytes), words_(bytes), path_(path) {}

    Result<Mesh> read() {
        if (auto done = read_header(); !done) return done.error();
        for (const Element& element : elements_) {
            for (std::uint64_t i = 0; i < element.count; ++i) {
                if (auto done = read_row(element, i); !done) return done.error();
            }
        }
        Mesh mesh = mesh_.finish("PLY");
        if (has_float_points()) mesh.facts.coordinate_step = float_step_at(mesh.facts);
        return mesh;
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(path_ + ": line " + std::to_string(words_.line()) + ": " + what);
    }

    Result<void> read_header() {
        words_.skip_line();
        while (!words_.at_end()) {
            const std::string_view word = words_.next_in_line();
            Result<void> done;
            if (word == "format") done = take_format(words_.next_in_line());
            if (word == "element") done = take_element();
            if (word == "property") done = take_property();
            if (!done) return done.error();
            words_.skip_line();
            if (word != "end_header") continue;
            position_ = words_.position();
            return {};
        }
        return bad_input(path_ + ": truncated: the PLY header has no end_header");
    }

    Result<void> take_format(std::string_view name) {
        if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian") {
            return wrong(quoted(name) + " is not a PLY format");
        }
        binary_ = name != "ascii";
        swapped_ = name == "binary_big_endian";
        return {};
    }

    Result<void> take_element() {
        Element element;
        element.name = words_.next_in_line();
        const std::string_view word = words_.next_in_line();
        const auto count = whole_number(word);
        if (!count || *count < 0) return wrong(quoted(word) + " is not a count");
        element.count = static_cast<std::uint64_t>(*count);
        elements_.push_back(element);
        return {};
    }

    Result<void> take_property() {
        if (elements_.empty()) return wrong("a property without an element");
        Property property;
        std::string_view word = words_.next_in_line();
        if (word == "list") {
            word = words_.next_in_line();
            property.count_kind = kind_of(word);
            if (property.count_kind == Kind::none) return wrong(quoted(word) + " is not a PLY type");
            word = words_.next_in_line();
        }
        property.kind = kind_of(word);
        if (property.kind == Kind::none) return wrong(quoted(word) + " is not a PLY type");
        property.name = words_.next_in_line();
        elements_.back().properties.push_back(property);
        return {};
    }

    /// The next value of the body; nothing when the file ends or holds no number there.
    std::optional<double> next_value(Kind kind) noexcept {
        if (!binary_) return number(words_.next());
        constexpr std::array<std::size_t, 9> kSizes{0, 1, 1, 2, 2, 4, 4, 4, 8};
        const std::size_t size = kSizes[static_cast<std::size_t>(kind)];
        if (bytes_.size() - position_ < size) return std::nullopt;
        std::array<char, 8> raw{};
        std::memcpy(raw.data(), bytes_.data() + position_, size);
        if (swapped_) std::reverse(raw.data(), raw.data() + size);
        position_ += size;
        switch (kind) {
            case Kind::i8:
                return value_of<std::int8_t>(raw);
            case Kind::u8:
                return value_of<std::uint8_t>(raw);
            case Kind::i16:
                return value_of<std::int16_t>(raw);
            case Kind::u16:
                return value_of<std::uint16_t>(raw);
            case Kind::i32:
                return value_of<std::int32_t>(raw);
            case Kind::u32:
                return value_of<std::uint32_t>(raw);
            case Kind::f32:
                return value_of<float>(raw);
            case Kind::f64:
                return value_of<double>(raw);
            case Kind::none:
                break;
        }
        return std::nullopt;
    }

    Error row_error(const Element& element, std::uint64_t row) const {
        return bad_input(path_ + ": truncated or damaged at element " + quoted(element.name) + " " +
                         std::to_string(row) + " of " + std::to_string(element.count));
    }

    Result<void> read_row(const Element& element, std::uint64_t row) {
        std::array<double, 3> point{};
        for (const Property& property : element.properties) {
            std::uint64_t count = 1;
            if (property.count_kind != Kind::none) {
                const auto given = next_value(property.count_kind);
                // A list cannot be longer than the file.
                if (!given || !is_whole_below(*given, bytes_.size())) {
                    return row_error(element, row);
                }
                count = static_cast<std::uint64_t>(*given);
            }
            values_.clear();
            for (std::uint64_t i = 0; i < count; ++i) {
                const auto value = next_value(property.kind);
                if (!value) return row_error(element, row);
                values_.push_back(*value);
            }
            const bool is_face = element.name == "face" && property.name.substr(0, 11) == "vertex_indi";
            const bool is_face_of_others = element.name == "face" && property.name == "vertex_index";
            if ((is_face || is_face_of_others) && !add_face()) {
                return bad_input(path_ + ": face " + std::to_string(row) +
                                 " names a vertex that is not there");
            }
            if (property.count_kind != Kind::none) continue;
            if (property.name == "x") point[0] = values_[0];
            if (property.name == "y") point[1] = values_[0];
            if (property.name == "z") point[2] = values_[0];
        }
        if (element.name == "vertex") mesh_.add_point(point);
        return element.properties.empty() ? Result<void>(row_error(element, row)) : Result<void>();
    }

    /// Whether the file itself holds its coordinates as floats.
    bool has_float_points() const {
        return binary_ && std::any_of(elements_.begin(), elements_.end(), [](const Element& element) {
                   return element.name == "vertex" && !element.properties.empty() &&
                          element.properties.front().kind == Kind::f32;
               });
    }

    bool add_face() {
        corners_.clear();
        for (const double value : values_) {
            if (!is_whole_below(value, mesh_.point_count())) return false;
            corners_.push_back(static_cast<std::uint64_t>(value));
        }
        return mesh_.add_polygon(corners_);
    }

    std::string_view bytes_;
    Words words_;
    const std::string& path_;
    std::size_t position_ = 0;  ///< in the bytes, for binary bodies
    bool binary_ = false;
    bool swapped_ = false;
    std::vector<Element> elements_;
    IndexedMesh mesh_;
    std::vector<double> values_;
    std::vector<std::uint64_t> corners_;
};

}  // namespace

Result<Mesh> read_ply(const InputFile& file) {
    return read_whole<PlyReader>(file);
}

}  // namespace psicarve::model
