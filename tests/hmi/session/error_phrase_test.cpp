// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/error_phrase.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

/// Whether a window has words of its own for it.
bool is_known(const std::string& message) {
    const Phrase shown = error_phrase(message);
    return std::string{shown.english} != "%1" && in_english(shown) != "";
}

// What the readers say, as they say it.
TEST(ErrorPhrase, KnowsWhatReadersSay) {
    const psicarve::test::TemporaryFolder folder;
    const auto written = [&folder](const std::string& name, const std::string& content) {
        std::ofstream{folder.path(name), std::ios::binary} << content;
        return folder.path(name);
    };
    const auto said = [&written](const std::string& name, const std::string& content) {
        const auto mesh = model::load_mesh(written(name, content));
        return mesh ? std::string{"it was read"} : mesh.error().message;
    };
    const std::string messages[] = {
        model::load_mesh(folder.path("none.stl")).error().message,
        model::load_mesh(folder.path("")).error().message,
        said("empty.stl", ""),
        said("short.stl", "abc"),
        said("text.obj", "v 1 2 x\n"),
        said("face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"),
        said("more.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n"),
        said("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        said("ascii.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
        said("none.3mf", "PK\x03\x04 and no more"),
        load_snapshot(written("not.job", "nothing of a job")).error().message,
    };
    for (const std::string& message : messages) EXPECT_TRUE(is_known(message)) << message;
    EXPECT_EQ(in_english(error_phrase("a: b.obj: line 12: 'x' is not a number: a vertex needs three")),
              "a: b.obj: line 12: 'x' is not a number: a vertex needs three");
}

TEST(ErrorPhrase, NamesTheWindowsFieldsInsteadOfOptions) {
    const auto mesh = model::load_mesh(example("small.stl"));
    ASSERT_TRUE(mesh);
    cam::JobOptions large;
    large.height_mm = 5000.0;
    cam::JobOptions fine;
    fine.layer_count = 4'000'000;
    cam::JobOptions dense;
    dense.point_count = 4'000'000;
    for (const cam::JobOptions& options : {large, fine, dense}) {
        const auto built = cam::build_job(*mesh, Profile{}, options);
        ASSERT_FALSE(built);
        EXPECT_TRUE(is_known(built.error().message)) << built.error().message;
        EXPECT_EQ(in_english(error_phrase(built.error().message)).find("--"), std::string::npos);
    }
}

}  // namespace
}  // namespace psicarve::session
