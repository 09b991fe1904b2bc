// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/three_mf_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/model/text_scan.hpp"
#include "hmi/model/xml_part.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

constexpr std::string_view kModelRelation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr const char* kUsualModelPart = "/3D/3dmodel.model";
constexpr std::string_view kProductionPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path";

struct Unit {
    std::string_view name;
    double mm;
};
constexpr std::array<Unit, 6> kUnits{{{"micron", 0.001},
                                      {"millimeter", 1.0},
                                      {"centimeter", 10.0},
                                      {"inch", 25.4},
                                      {"foot", 304.8},
                                      {"meter", 1000.0}}};

/// The model parts that were named, in the order they were named first.
class PartNames {
public:
    std::size_t number_of(const std::string& part) {
        const auto [place, is_new] = numbers_.try_emplace(part, names_.size());
        if (is_new) names_.push_back(part);
        return place->second;
    }
    std::size_t count() const noexcept { return names_.size(); }
    std::string operator[](std::size_t number) const { return names_[number]; }

private:
    std::vector<std::string> names_;
    std::map<std::string, std::size_t> numbers_;
};

/// Adds the content of the model parts to the package.
class PartReader {
public:
    PartReader(Package3mf& package, PartNames& parts) : package_(package), parts_(parts) {}

    void begin_part(std::size_t part) {
        part_ = part;
        space_.clear();
        object_ = nullptr;
    }

    Result<void> take(std::string_view space, std::string_view name, const XmlAttributes& attributes) {
        if (name == "model" && space_.empty()) {
            space_ = space;
            return take_unit(attributes);
        }
        // Extensions have vertices and triangles of their own, which are no surface.
        if (space != space_) return {};
        if (name == "vertex") return take_vertex(attributes);
        if (name == "triangle") return take_triangle(attributes);
        if (name == "object") return take_object(attributes);
        if (name == "component") return take_component(attributes);
        if (name == "item" && part_ == 0) return take_item(attributes);
        return {};
    }

private:
    static Result<double> coordinate(const XmlAttributes& attributes, const char* name) {
        const auto text = attributes.find(name);
        if (!text) return bad_input(std::string("a vertex without ") + name);
        const auto value = number(*text);
        if (!value) return bad_input(quoted(*text) + " is not a number");
        return *value;
    }

    static Result<std::uint64_t> whole(const XmlAttributes& attributes, const std::string& name) {
        const auto text = attributes.find(name);
        if (!text) return bad_input("an element without " + name);
        const auto value = whole_number(*text);
        if (!value || *value < 0) return bad_input(name + "=" + quoted(*text) + " is no number to count by");
        return static_cast<std::uint64_t>(*value);
    }

    Result<void> take_unit(const XmlAttributes& attributes) {
        const std::string_view wanted = attributes.find("unit").value_or("millimeter");
        const auto* const unit =
            std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == wanted; });
        if (unit == kUnits.end()) return bad_input(quoted(wanted) + " is not a unit of 3MF");
        if (part_ != 0) return {};
        package_.unit = unit->name;
        package_.mm_per_unit = unit->mm;
        return {};
    }

    Result<void> count_one() {
        if (++counted_ <= kMostObjects3mf) return {};
        return bad_input("more than " + std::to_string(kMostObjects3mf) + " objects");
    }

    Result<void> take_object(const XmlAttributes& attributes) {
        if (auto few = count_one(); !few) return few;
        const auto id = whole(attributes, "id");
        if (!id) return id.error();
        const auto [place, is_new] = package_.objects.try_emplace({part_, *id});
        if (!is_new) return bad_input("object " + std::to_string(*id) + " stands there twice");
        object_ = &place->second;
        object_id_ = *id;
        return {};
    }

    Result<void> take_vertex(const XmlAttributes& attributes) {
        if (object_ == nullptr) return bad_input("a vertex outside of an object");
        constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
        std::array<double, 3> point{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = coordinate(attributes, kNames[k]);
            if (!value) return value.error();
            point[k] = *value;
        }
        object_->points.push_back(point);
        return {};
    }

    Result<void> take_triangle(const XmlAttributes& attributes) {
        if (object_ == nullptr) return bad_input("a triangle outside of an object");
        constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto index = whole(attributes, kNames[i]);
            if (!index) return index.error();
            if (*index >= object_->points.size() || *index > std::numeric_limits<std::uint32_t>::max()) {
                return bad_input("triangle " + std::to_string(object_->triangles.size()) + " of object " +
                                 std::to_string(object_id_) + " names vertex " + std::to_string(*index) +
                                 ", there are " + std::to_string(object_->points.size()));
            }
            corners[i] = static_cast<std::uint32_t>(*index);
        }
        object_->triangles.push_back(corners);
        return {};
    }

    Result<PlacedObject> placed(const XmlAttributes& attributes) {
        const auto id = whole(attributes, "objectid");
        if (!id) return id.error();
        const auto path = attributes.find(kProductionPath);
        PlacedObject out{{path ? parts_.number_of(std::string(*path)) : part_, *id}, kUnmoved3mf};
        const auto text = attributes.find("transform");
        if (!text) return out;
        Words words(*text);
        for (double& value : out.placement) {
            const auto read = number(words.next());
            if (!read)
                return bad_input("the transform of object " + std::to_string(*id) + " needs 12 numbers");
            value = *read;
        }
        return out;
    }

    Result<void> take_component(const XmlAttributes& attributes) {
        if (object_ == nullptr) return bad_input("a component outside of an object");
        return add_to(object_->components, attributes);
    }

    Result<void> take_item(const XmlAttributes& attributes) { return add_to(package_.build, attributes); }

    Result<void> add_to(std::vector<PlacedObject>& list, const XmlAttributes& attributes) {
        if (auto few = count_one(); !few) return few;
        auto object = placed(attributes);
        if (!object) return object.error();
        list.push_back(*object);
        return {};
    }

    Package3mf& package_;
    PartNames& parts_;
    std::size_t part_ = 0;
    std::string space_;
    Object3mf* object_ = nullptr;
    std::uint64_t object_id_ = 0;
    std::size_t counted_ = 0;
};

Result<std::string> first_part(ZipArchive& archive) {
    std::string found = kUsualModelPart;
    if (archive.has("_rels/.rels")) {
        const auto take = [&found](std::string_view, std::string_view name, const XmlAttributes& attributes) {
            const bool is_model = name == "Relationship" && attributes.find("Type") == kModelRelation;
            if (is_model) found = attributes.find("Target").value_or(kUsualModelPart);
            return Result<void>();
        };
        if (auto done = read_xml(archive, "_rels/.rels", take); !done) return done.error();
    }
    if (!archive.has(found)) return bad_input(archive.file() + ": is a zip archive, but holds no 3MF model");
    return found;
}

}  // namespace

Result<Package3mf> read_3mf_parts(ZipArchive& archive) {
    const auto first = first_part(archive);
    if (!first) return first.error();
    Package3mf package;
    PartNames parts;
    parts.number_of(*first);
    PartReader reader(package, parts);
    const auto take = [&reader](std::string_view space, std::string_view name,
                                const XmlAttributes& attributes) {
        return reader.take(space, name, attributes);
    };
    for (std::size_t part = 0; part < parts.count(); ++part) {
        reader.begin_part(part);
        if (auto done = read_xml(archive, parts[part], take); !done) return done.error();
    }
    return package;
}

}  // namespace psicarve::model
