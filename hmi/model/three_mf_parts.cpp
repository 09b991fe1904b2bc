// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/three_mf_parts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/model/text_scan.hpp"
#include "hmi/model/xml_part.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/result.hpp"

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

/// What one model part says is added to the package.
class PartReader {
public:
    PartReader(Package3mf& package, const std::string& part, bool is_first)
        : package_(package), part_(part), is_first_(is_first) {}

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
        if (name == "item" && is_first_) return take_item(attributes);
        return {};
    }

private:
    static Result<double> number_of(const XmlAttributes& attributes, const char* name) {
        const auto text = attributes.find(name);
        if (!text) return bad_input(std::string("a vertex without ") + name);
        const auto value = number(*text);
        if (!value) return bad_input(quoted(*text) + " is not a number");
        return *value;
    }

    static Result<std::uint64_t> whole_of(const XmlAttributes& attributes, const char* name) {
        const auto text = attributes.find(name);
        if (!text) return bad_input(std::string("an element without ") + name);
        const auto value = whole_number(*text);
        if (!value || *value < 0)
            return bad_input(std::string(name) + " " + quoted(*text) + " is not a number");
        return static_cast<std::uint64_t>(*value);
    }

    Result<void> take_unit(const XmlAttributes& attributes) {
        const std::string_view wanted = attributes.find("unit").value_or("millimeter");
        for (const Unit& unit : kUnits) {
            if (unit.name != wanted) continue;
            if (is_first_) package_.mm_per_unit = unit.mm;
            return {};
        }
        return bad_input(quoted(wanted) + " is not a unit of 3MF");
    }

    Result<void> take_object(const XmlAttributes& attributes) {
        const auto id = whole_of(attributes, "id");
        if (!id) return id.error();
        const auto [place, is_new] = package_.objects.try_emplace({part_, *id});
        if (!is_new) return bad_input("object " + std::to_string(*id) + " stands there twice");
        object_ = &place->second;
        object_id_ = *id;
        return {};
    }

    Result<void> take_vertex(const XmlAttributes& attributes) {
        if (object_ == nullptr) return bad_input("a vertex outside of an object");
        const auto x = number_of(attributes, "x");
        if (!x) return x.error();
        const auto y = number_of(attributes, "y");
        if (!y) return y.error();
        const auto z = number_of(attributes, "z");
        if (!z) return z.error();
        object_->points.push_back({*x, *y, *z});
        return {};
    }

    Result<void> take_triangle(const XmlAttributes& attributes) {
        if (object_ == nullptr) return bad_input("a triangle outside of an object");
        constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto index = whole_of(attributes, kNames[i]);
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

    Result<PlacedObject> placed(const XmlAttributes& attributes) const {
        const auto id = whole_of(attributes, "objectid");
        if (!id) return id.error();
        PlacedObject out{{std::string(attributes.find(kProductionPath).value_or(part_)), *id}, kUnmoved3mf};
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
        auto component = placed(attributes);
        if (!component) return component.error();
        object_->components.push_back(std::move(component).value());
        return {};
    }

    Result<void> take_item(const XmlAttributes& attributes) {
        auto item = placed(attributes);
        if (!item) return item.error();
        package_.build.push_back(std::move(item).value());
        return {};
    }

    Package3mf& package_;
    const std::string& part_;
    bool is_first_;
    std::string space_;
    Object3mf* object_ = nullptr;
    std::uint64_t object_id_ = 0;
};

Result<std::string> first_part(const ZipArchive& archive) {
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

/// The parts that objects of this package name and that were not read yet.
std::vector<std::string> missing_parts(const Package3mf& package, const std::set<std::string>& known) {
    std::vector<std::string> missing;
    const auto look_at = [&](const PlacedObject& placed) {
        if (!known.contains(placed.object.first)) missing.push_back(placed.object.first);
    };
    for (const PlacedObject& item : package.build) look_at(item);
    for (const auto& [key, object] : package.objects) {
        for (const PlacedObject& component : object.components) look_at(component);
    }
    return missing;
}

}  // namespace

Result<Package3mf> read_3mf_parts(const ZipArchive& archive) {
    const auto first = first_part(archive);
    if (!first) return first.error();
    Package3mf package;
    std::set<std::string> known;
    std::vector<std::string> todo{*first};
    while (!todo.empty()) {
        for (const std::string& part : todo) {
            if (!known.insert(part).second) continue;
            PartReader reader(package, part, part == *first);
            const auto done = read_xml(
                archive, part,
                [&reader](std::string_view space, std::string_view name, const XmlAttributes& attributes) {
                    return reader.take(space, name, attributes);
                });
            if (!done) return done.error();
        }
        todo = missing_parts(package, known);
    }
    return package;
}

}  // namespace psicarve::model
