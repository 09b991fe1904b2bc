// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/mesh_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hmi/model/load_mesh.hpp"

namespace psicarve::session {
namespace {

std::vector<std::string> english(const model::Mesh& mesh, const std::array<double, 3>& size) {
    std::vector<std::string> lines;
    for (const Phrase& line : mesh_lines(mesh, size)) lines.push_back(in_english(line));
    return lines;
}

model::Mesh closed_mesh() {
    model::Mesh mesh;
    mesh.triangles.resize(1200);
    mesh.facts.signed_volume = 12'345.6;
    mesh.facts.max = {10.0, 20.0, 30.0};
    return mesh;
}

TEST(MeshText, TellsSizeFacetsAndVolumeOfAClosedMesh) {
    EXPECT_EQ(english(closed_mesh(), {10.0, 20.04, 1234.5}),
              (std::vector<std::string>{"10.0 × 20.0 × 1\u2009234.5", "1\u2009200 facets, 12.3 cm³",
                                        "Surface closed, all facets turned alike"}));
}

TEST(MeshText, CountsWhatIsWrongAndKnowsNoVolumeThen) {
    model::Mesh mesh = closed_mesh();
    mesh.facts.closed = false;
    mesh.facts.same_orientation = false;
    mesh.facts.open_edge_count = 14;
    mesh.facts.turned_edge_count = 206;
    mesh.facts.degenerate_count = 3;
    mesh.facts.duplicate_count = 2;
    mesh.facts.dropped_count = 1;
    const auto lines = english(mesh, {1.0, 1.0, 1.0});
    EXPECT_EQ(lines[1], "1\u2009200 facets");
    EXPECT_EQ(lines[2],
              "open edges: 14, edges between flipped facets: 206, without area: 3, doubled: 2, left out: 1");
}

TEST(MeshText, NamesAMeshThatIsInsideOut) {
    model::Mesh mesh = closed_mesh();
    mesh.facts.signed_volume = -5000.0;
    const auto lines = english(mesh, {1.0, 1.0, 1.0});
    EXPECT_EQ(lines[1], "1\u2009200 facets, 5.0 cm³");
    EXPECT_EQ(lines[2], "inside out");
}

TEST(MeshText, DoubtsMillimetresBySizeAlone) {
    model::Mesh mesh = closed_mesh();
    mesh.facts.max = {1.0, 2.0, 0.5};
    EXPECT_EQ(english(mesh, {1.0, 2.0, 0.5}).back(), "Probable unit: inches");
    mesh.facts.max = {0.1, 0.2, 0.05};
    EXPECT_EQ(english(mesh, {0.1, 0.2, 0.05}).back(), "Probable unit: m");
    mesh.facts.max = {9000.0, 2.0, 0.5};
    EXPECT_EQ(english(mesh, {9000.0, 2.0, 0.5}).back(), "Probable unit: µm");
}

/// "name: value", a name only where it is told.
std::vector<std::string> rows_of(const ModelKnowledge& known) {
    std::vector<std::string> lines;
    for (const ReportRow& row : model_rows(known))
        lines.push_back((row.name.is_empty() ? "" : in_english(row.name) + ": ") + in_english(row.value));
    return lines;
}

TEST(MeshText, ReportsAModelAsItBecomesKnown) {
    model::Mesh mesh = closed_mesh();
    mesh.format = "OBJ";
    mesh.facts.max = {10.0, 20.0, 30.0};
    EXPECT_EQ(rows_of({mesh, nullptr, nullptr, nullptr, {}}),
              (std::vector<std::string>{"Mesh: OBJ, facets: 1\u2009200", "Bodies: …",
                                        "Surface: closed, all facets turned alike", "Probable unit: mm",
                                        "Size: …", "Volume: …", "Undercut: …", "Open in directions: …",
                                        "The tool leaves: …"}));
    ReachReport view;
    view.size = {10.0, 20.0, 30.0};
    view.mm_per_unit = 0.5;
    view.undercut_share = 0.0842;
    report::ModelFindings findings;
    findings.parts = {3, 1, 0, 0};
    findings.hidden.hidden_deg = {
        {10.0, 20.0, 0.02}, {350.0, 370.0, 0.5}, {40.0, 50.0, 0.03}, {60.0, 70.0, 0.2}};
    findings.hidden.hidden_mm = {{4.0, 7.0, 0.25}};
    PieceView piece;
    piece.has_model = true;
    piece.draft_allowance_mm = 0.01;
    piece.deviation.emplace();
    piece.deviation->leftover = {1.5, 0.1, 30.0, 2.0};
    piece.deviation->histogram[8] = 1;
    piece.deviation->histogram[5] = 3;
    piece.deviation->place_count = 4;
    const auto rows = rows_of({mesh, &view, &findings, &piece, {}});
    EXPECT_EQ(rows[1], "Bodies: 3");
    EXPECT_EQ(rows[2], "Surface: bodies inside out: 1");
    EXPECT_EQ(rows[4], "Size: 5.00 × 10.00 × 15.00 mm, scale 0.5000");
    EXPECT_EQ(rows[5], "Volume: 1.54 cm³");
    EXPECT_EQ(rows[6], "Undercut: about 8.4 % of the surface");
    EXPECT_EQ(rows_of({mesh, &view, &findings, &piece, {}, 0.0831})[6], "Undercut: 8.31 % of the surface")
        << "as the job has it";
    EXPECT_EQ(rows[7], "350–10°, through 0° (50.0 %), 60–70° (20.0 %), 40–50° (3.0 %), …");
    EXPECT_EQ(rows[8], "4.0–7.0 mm high (25.0 %)");
    EXPECT_EQ(rows[9], "Open in directions: none");
    EXPECT_EQ(rows[10], "The tool leaves (draft): More than 0.1 mm on 25.00 % of the surface");
    EXPECT_EQ(rows[12], "Left over 1.500 mm at most, at 30.0°, 2.00 mm high; 0.1000 mm on average");
    // Too deep is only told of a job: a draft's samples are no cuts.
    piece.draft_allowance_mm.reset();
    EXPECT_EQ(rows_of({mesh, &view, &findings, &piece, {}})[11], "Nowhere too deep");
}

TEST(MeshText, ReportsHolesAndWhereTheyAreAndWhyThereIsNoPiece) {
    model::Mesh mesh = closed_mesh();
    mesh.facts.closed = false;
    mesh.facts.open_edge_count = 14;
    report::ModelFindings findings;
    findings.parts = {1, 0, 1, 2};
    findings.hidden.open_deg = {{40.0, 140.0, 0.4}};
    findings.hidden.open_mm = {{4.0, 7.0, 0.25}};
    const auto rows = rows_of({mesh, nullptr, &findings, nullptr, phrase("a point leaves nothing")});
    EXPECT_EQ(rows[2], "Surface: holes: 2, open edges: 14");
    EXPECT_EQ(rows[5], "Volume: not known: the surface is not closed, or turned both ways");
    EXPECT_EQ(rows[7], "Open in directions: 40–140° (40.0 %)");
    EXPECT_EQ(rows[8], "4.0–7.0 mm high (25.0 %)");
    EXPECT_EQ(rows[9], "The tool leaves: a point leaves nothing");
}

}  // namespace
}  // namespace psicarve::session
