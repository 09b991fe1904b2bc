// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

using Json = nlohmann::json;

/// A lens, 20 mm wide: two arcs that meet in corners.
constexpr const char* kDrawing =
    "<svg xmlns='http://www.w3.org/2000/svg' width='30mm' height='30mm' viewBox='0 0 30 30'>"
    "<path d='M5,15 A12,12 0 0 1 25,15 A12,12 0 0 1 5,15 Z'/></svg>";

class Piece : public CliTest {
protected:
    Outcome carve(const std::string& model, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"carve",    model, "--segment", segment_, "--layers", "6",
                                           "--points", "41",  "--tool",    "ball:2", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return psicarve(arguments);
    }
};

void expect_deviation(const Json& deviation) {
    ASSERT_TRUE(deviation.is_object()) << deviation;
    // Layers stand 0.5 mm apart, so a ball leaves ridges; it enters the model by what a chord does.
    EXPECT_LT(deviation["gouge"]["max_mm"].get<double>(), 0.1) << deviation["gouge"];
    EXPECT_GT(deviation["leftover"]["max_mm"].get<double>(), 0.005) << deviation["leftover"];
    EXPECT_LT(deviation["leftover"]["max_mm"].get<double>(), 0.4) << deviation["leftover"];
    EXPECT_GT(deviation["places"].get<int>(), 1000);
    EXPECT_GT(deviation["removed_mm3"].get<double>(), 1.0);
    EXPECT_EQ(deviation["histogram"].size(), 11U);
}

TEST_F(Piece, IsComparedWithTheModelByCarveAndAgainByVerify) {
    write("lens.svg", kDrawing);
    const Outcome carved =
        carve(file("lens.svg"), {"--height", "3", "--scale", "0.8", "--rotate", "20", "--trace",
                                 file("pins.trace"), "--deviation", file("carved.png")});
    ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;
    const Json report = carved.json();
    expect_deviation(report["deviation"]);
    EXPECT_EQ(report["deviation_picture"], file("carved.png"));
    EXPECT_EQ(text_of(file("carved.png")).substr(1, 3), "PNG");
    // How large the drawing was made is in the job.
    ASSERT_EQ(psicarve({"slice", file("lens.svg"), "--height", "3", "--scale", "0.8", "--rotate", "20", "-o",
                        file("lens.job"), "--layers", "6", "--points", "41", "--tool", "ball:2"})
                  .exit_code,
              0);
    const Outcome verified = psicarve({"verify", file("lens.job"), file("pins.trace"), "--model",
                                       file("lens.svg"), "--deviation", file("again.png"), "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    EXPECT_EQ(verified.json()["deviation"], report["deviation"]);
    EXPECT_TRUE(text_of(file("again.png")) == text_of(file("carved.png")));
}

TEST_F(Piece, IsComparedByVerifyWithTheModelAlone) {
    const std::string model = box_stl("box.stl");
    ASSERT_EQ(psicarve({"slice", model, "-o", file("box.job"), "--layers", "6", "--points", "41", "--tool",
                        "ball:2"})
                  .exit_code,
              0);
    ASSERT_EQ(psicarve({"replay", file("box.job"), "--trace", file("pins.trace")}).exit_code, 0);
    const auto verified = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"verify", file("box.job"), file("pins.trace"), "--model", model};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
        return outcome;
    };
    const auto files = files_in_folder();
    const Json deviation = verified({"--json"}).json()["deviation"];
    const std::string told = verified({}).out;
    EXPECT_NE(told.find("\n  piece: "), std::string::npos) << told;
    EXPECT_EQ(files_in_folder(), files) << "no file was asked for";
    EXPECT_GT(deviation["places"].get<int>(), 1000) << deviation;
    EXPECT_EQ(deviation, verified({"--json", "--deviation", file("a.png")}).json()["deviation"]);
    write("box.csv", psicarve({"snapshot", "export", file("box.job")}).out);
    const Outcome table =
        psicarve({"verify", file("box.job"), file("pins.trace"), "--model", file("box.csv")});
    EXPECT_EQ(table.exit_code, 2);
    EXPECT_NE(table.error.find("a table has no model to compare with"), std::string::npos) << table.error;
}

TEST_F(Piece, IsToldOfByCarveWithoutBeingAskedFor) {
    const std::string model = box_stl("box.stl");
    const auto files = files_in_folder();
    const Json report = carve(model, {}).json();
    ASSERT_TRUE(report.contains("deviation")) << report;
    const Json deviation = report["deviation"];
    EXPECT_GT(deviation["places"].get<int>(), 1000) << deviation;
    EXPECT_EQ(deviation["histogram"].size(), 11U);
    const std::vector<std::string> in_text{"carve", model,      "--segment", segment_, "--layers",
                                           "6",     "--points", "41",        "--tool", "flat:2"};
    const std::string told = psicarve(in_text).out;
    EXPECT_NE(told.find("\ndeviation  "), std::string::npos) << told;
    EXPECT_EQ(files_in_folder(), files) << "no file was asked for";
    EXPECT_EQ(deviation, carve(model, {"--deviation", file("a.png")}).json()["deviation"]);
    auto without = in_text;
    without.emplace_back("--no-deviation");
    EXPECT_EQ(psicarve(without).out.find("deviation  "), std::string::npos);
    EXPECT_FALSE(carve(model, {"--no-deviation"}).json().contains("deviation"));
    EXPECT_EQ(carve(model, {"--no-deviation", "--deviation", file("a.png")}).exit_code, 2);
    // A piece without a comparison, and a point's, which is the table's own surface.
    const Json piece = carve(model, {"--no-deviation", "--piece", file("piece.stl")}).json();
    EXPECT_EQ(piece["piece"], file("piece.stl"));
    EXPECT_FALSE(piece.contains("deviation"));
    const std::vector<std::string> by_a_point{"carve", model,      "--segment", segment_, "--layers",
                                              "6",     "--points", "41",        "--json"};
    EXPECT_FALSE(psicarve(by_a_point).json().contains("deviation"));
    auto asked = by_a_point;
    asked.insert(asked.end(), {"--deviation", file("point.png")});
    EXPECT_TRUE(psicarve(asked).json()["deviation"].is_object());
}

TEST_F(Piece, OfAJobIsComparedWithTheModelThatCarveIsGiven) {
    const std::string model = box_stl("box.stl");
    ASSERT_EQ(psicarve({"slice", model, "-o", file("box.job"), "--layers", "6", "--points", "41", "--tool",
                        "ball:2"})
                  .exit_code,
              0);
    const auto carve_job = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"carve", file("box.job"), "--segment", segment_, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return psicarve(arguments);
    };
    EXPECT_FALSE(carve_job({}).json().contains("deviation"));
    const Outcome carved = carve_job({"--model", model, "--deviation", file("a.png")});
    ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;
    EXPECT_EQ(carved.json()["deviation"], carve(model, {}).json()["deviation"]);
    EXPECT_EQ(text_of(file("a.png")).substr(1, 3), "PNG");
    EXPECT_EQ(carve_job({"--model", model}).json()["deviation"], carved.json()["deviation"]);
    EXPECT_EQ(carve_job({"--model", box_stl("other.stl", 7.0)}).exit_code, 3);
    const Outcome twice = carve(model, {"--model", model});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_NE(twice.error.find("is for a job file"), std::string::npos) << twice.error;
    EXPECT_NE(carve(file("none.stl"), {"--model", model}).exit_code, 2);
}

TEST_F(Piece, OfEngravedLinesIsComparedWithTheGrooves) {
    write("lens.svg", kDrawing);
    const std::vector<std::string> options{"--engrave", "0.4", "--tool",   "ball:2", "--diameter", "24",
                                           "--start",   "30",  "--layers", "60",     "--points",   "161"};
    std::vector<std::string> carve{"carve",       file("lens.svg"),   "--segment",
                                   segment_,      "--trace",          file("pins.trace"),
                                   "--deviation", file("carved.png"), "--json"};
    carve.insert(carve.end(), options.begin(), options.end());
    const Outcome carved = psicarve(carve);
    ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;
    const Json deviation = carved.json()["deviation"];
    // As much wider as points and layers lie apart; nothing of a groove is left uncut.
    EXPECT_LT(deviation["gouge"]["max_mm"].get<double>(), 0.35) << deviation;
    EXPECT_LT(deviation["leftover"]["max_mm"].get<double>(), 0.1) << deviation;
    std::vector<std::string> slice{"slice", file("lens.svg"), "-o", file("lens.job")};
    slice.insert(slice.end(), options.begin(), options.end());
    ASSERT_EQ(psicarve(slice).exit_code, 0);
    const Outcome verified = psicarve({"verify", file("lens.job"), file("pins.trace"), "--model",
                                       file("lens.svg"), "--deviation", file("again.png"), "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    EXPECT_EQ(verified.json()["deviation"], deviation);
}

TEST_F(Piece, OfAMeshOnItsSideIsComparedAsItWasSliced) {
    const std::string model = box_stl("box.stl");
    const Outcome carved = carve(model, {"--up", "x", "--height", "3", "--axis-at", "4,2", "--piece",
                                         file("piece.ply"), "--picture", file("picture.png")});
    ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;
    const Json report = carved.json();
    expect_deviation(report["deviation"]);
    EXPECT_EQ(report["piece"], file("piece.ply"));
    EXPECT_EQ(text_of(file("piece.ply")).substr(0, 4), "ply\n");
}

TEST_F(Piece, NeedsTheModelThatWasSliced) {
    const std::string model = box_stl("box.stl");
    ASSERT_EQ(psicarve({"slice", model, "-o", file("box.job"), "--layers", "4", "--points", "9"}).exit_code,
              0);
    const Outcome of_job =
        psicarve({"carve", file("box.job"), "--segment", segment_, "--deviation", file("a.png")});
    EXPECT_EQ(of_job.exit_code, 2);
    EXPECT_NE(of_job.error.find("--model MODEL says"), std::string::npos) << of_job.error;
    ASSERT_EQ(psicarve({"replay", file("box.job"), "--trace", file("pins.trace")}).exit_code, 0);
    const Outcome other = psicarve({"verify", file("box.job"), file("pins.trace"), "--model",
                                    box_stl("other.stl", 7.0), "--deviation", file("a.png")});
    EXPECT_EQ(other.exit_code, 3);
    EXPECT_NE(other.error.find("is not the file that the job was sliced from"), std::string::npos);
    const Outcome jpeg = psicarve(
        {"verify", file("box.job"), file("pins.trace"), "--model", model, "--deviation", file("a.jpg")});
    EXPECT_EQ(jpeg.exit_code, 3);
    EXPECT_NE(jpeg.error.find(".png"), std::string::npos) << jpeg.error;
}

}  // namespace
}  // namespace psicarve::test
