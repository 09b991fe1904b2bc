// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"

/// 3MF archives made by the tests themselves.
namespace psicarve::mesh_files {

/// The mesh element of an object.
inline std::string three_mf_mesh(const model::Mesh& mesh) {
    std::string xml = "<mesh><vertices>";
    for (const auto& t : mesh.triangles) {
        for (const auto& v : t.vertices) {
            xml += "<vertex x=\"" + text_of(double{v[0]}) + "\" y=\"" + text_of(double{v[1]}) + "\" z=\"" +
                   text_of(double{v[2]}) + "\"/>";
        }
    }
    xml += "</vertices><triangles>";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        xml += "<triangle v1=\"" + std::to_string(3 * i) + "\" v2=\"" + std::to_string(3 * i + 1) +
               "\" v3=\"" + std::to_string(3 * i + 2) + "\"/>";
    }
    return xml + "</triangles></mesh>";
}

inline std::string object(int id, const std::string& content) {
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\">" + content + "</object>";
}
inline std::string components(const std::string& content) {
    return "<components>" + content + "</components>";
}
/// "component" and "item" are the same but for their name.
inline std::string placed(const std::string& name, int id, const std::string& transform) {
    return "<" + name + " objectid=\"" + std::to_string(id) + "\"" +
           (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}
inline std::string component(int id, const std::string& transform = "") {
    return placed("component", id, transform);
}
inline std::string item(int id, const std::string& transform = "") {
    return placed("item", id, transform);
}

/// A model part; `unit` is the attribute as it stands, or nothing.
inline std::string three_mf_model(const std::string& resources, const std::string& build,
                                  const std::string& unit = "unit=\"millimeter\"") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + unit +
           " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n<resources>" +
           resources + "</resources>\n<build>" + build + "</build></model>";
}

/// What stands around the model part of an archive.
inline Zip three_mf_surroundings() {
    Zip zip;
    zip.add("[Content_Types].xml",
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
            "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
            "<Default Extension=\"rels\" "
            "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
            "<Default Extension=\"model\" "
            "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>");
    zip.add("_rels/.rels",
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
            "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
            "<Relationship Target=\"/3D/model.model\" Id=\"rel0\" "
            "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>");
    return zip;
}

inline Zip three_mf_archive(const std::string& model) {
    Zip zip = three_mf_surroundings();
    zip.add("3D/model.model", model);
    return zip;
}

/// One object, moved by 5 in x where the build places it.
inline std::string three_mf(const model::Mesh& mesh, const std::string& unit = "unit=\"millimeter\"") {
    const std::string build = item(1, "1 0 0 0 1 0 0 0 1 5 0 0");
    return three_mf_archive(three_mf_model(object(1, three_mf_mesh(mesh)), build, unit)).bytes();
}

/// An object that is a box, 1 wide, 2 deep and 3 high.
inline std::string box_object(int id) {
    return object(id, three_mf_mesh(shapes::box({0, 0, 0}, {1, 2, 3})));
}

/// The message, in one line, about a file that is refused; nothing when it is not.
inline std::string refusal_of_file(const std::string& path) {
    const auto mesh = model::load_mesh(path);
    if (mesh) return "";
    EXPECT_EQ(mesh.error().code, ErrorCode::bad_input);
    EXPECT_THAT(mesh.error().message, testing::StartsWith(path + ": "));
    EXPECT_THAT(mesh.error().message, testing::Not(testing::HasSubstr("\n")));
    return mesh.error().message;
}
inline std::string refusal(const std::string& bytes) {
    const Folder folder;
    return refusal_of_file(folder.write("a.3mf", bytes));
}
inline std::string refusal_of_xml(const std::string& xml) {
    return refusal(three_mf_archive(xml).bytes());
}

}  // namespace psicarve::mesh_files
