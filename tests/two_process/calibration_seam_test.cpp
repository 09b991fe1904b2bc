// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated machine whose heads do not stand as its core's profile says: what it carves has a seam;
// psicarve calibrate takes it away. Everything is measured on what the tips left of blank and pin.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"
#include "tests/places.hpp"
#include "tests/two_process/commanded_core.hpp"

namespace psicarve::test {
namespace {

constexpr double kHeight_mm = 10.0;

/// The model: three flanks, off the axis, twisted, so that angle and height of a cut show in its radius.
double model_radius_mm(double direction_rad, double height_mm) {
    const double twisted_rad = direction_rad + 0.06 * height_mm;
    return 12.0 + std::cos(3.0 * twisted_rad) + 0.6 * std::sin(direction_rad) + 0.08 * height_mm;
}

/// The machine as it truly is: tips, wear, where R2 stands; and what is on its table.
Profile true_machine(double tool_wear_mm, double blank_radius_mm) {
    Profile profile;
    profile.r1.tip_offset_mm = 0.18;
    profile.r1.tool_wear_mm = tool_wear_mm;
    profile.r2.tip_offset_mm = -0.12;
    profile.head_r2_angle_error_deg = 1.4;
    profile.head_r2_height_error_mm = 0.25;
    profile.blank.radius_mm = blank_radius_mm;
    profile.blank.height_mm = 20.0;
    return profile;
}

constexpr double kNew = 0.0;
constexpr double kWorn_mm = 0.05;
constexpr double kPinRadius_mm = 3.0;
constexpr double kMarkedRadius_mm = 15.0;

/// A row of the piece: where, and what is left there.
struct Cut {
    double direction_deg;
    double height_mm;
    double radius_mm;
    bool is_right;  ///< of R2
};

/// How far the surface is outside of the model.
double off_pulses(const Cut& cut) {
    return (cut.radius_mm - model_radius_mm(rad_from_deg(cut.direction_deg), cut.height_mm)) * 400.0;
}

struct Deviation {
    double most_pulses = 0.0;  ///< of any cell of a layer from the model
    double seam_pulses = 0.0;  ///< from one head's half to the other's: the worst layer's, at either end
    std::size_t layers = 0;
};

/// Half a layer, from the head's first direction to its last.
using Half = std::vector<Cut>;

class CalibrationSeam : public CommandedCore {
protected:
    void write_model() const {
        constexpr int kAround = 480;
        constexpr int kUp = 60;
        std::ofstream stl(file("model.stl"));
        const auto vertex = [&](int around, int up, bool is_on_axis) {
            const double angle = 2.0 * kPi * around / kAround;
            const double height = kHeight_mm * up / kUp;
            const double r = is_on_axis ? 0.0 : model_radius_mm(angle, height);
            char line[120];
            (void)std::snprintf(line, sizeof line, "vertex %.7f %.7f %.7f\n", r * std::cos(angle),
                                r * std::sin(angle), height);
            stl << line;
        };
        const auto facet = [&](auto&& corners) {
            stl << "facet normal 0 0 0\nouter loop\n";
            corners();
            stl << "endloop\nendfacet\n";
        };
        stl << "solid seam\n";
        for (int a = 0; a < kAround; ++a) {
            const int b = (a + 1) % kAround;
            for (int u = 0; u < kUp; ++u) {
                facet([&] { vertex(a, u, false), vertex(b, u, false), vertex(b, u + 1, false); });
                facet([&] { vertex(a, u, false), vertex(b, u + 1, false), vertex(a, u + 1, false); });
            }
            facet([&] { vertex(0, 0, true), vertex(b, 0, false), vertex(a, 0, false); });
            facet([&] { vertex(0, kUp, true), vertex(a, kUp, false), vertex(b, kUp, false); });
        }
        stl << "endsolid seam\n";
    }

    /// A core that believes in machine.toml, on a simulated machine that is as `truth` says.
    void start_machine(const Profile& truth) {
        write("true.toml", profile_to_toml(truth));
        start_core({"--profile", file("machine.toml"), "--machine", file("true.toml"), "--piece",
                    file("piece.csv")});
    }
    /// Switches it off and takes the piece from the table.
    std::vector<Cut> take_piece() {
        core_->send(SIGTERM);
        EXPECT_EQ(core_->wait(), 0) << core_->error();
        core_said_ = core_->error();
        core_.reset();
        std::ifstream csv(file("piece.csv"));
        std::string line;
        std::getline(csv, line);
        EXPECT_EQ(line, "direction_deg,height_mm,radius_mm,head");
        std::vector<Cut> cuts;
        while (std::getline(csv, line)) {
            Cut cut{};
            char head[3] = "";
            EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%2s", &cut.direction_deg, &cut.height_mm,
                                  &cut.radius_mm, head),
                      4);
            cut.is_right = std::string{head} == "r2";
            cuts.push_back(cut);
        }
        return cuts;
    }
    /// Slices and carves with the profile that stands in machine.toml.
    Deviation carve(const Profile& truth) {
        const Outcome sliced =
            run({"slice", file("model.stl"), "-o", file("seam.job"), "--layers", "12", "--points", "241",
                 "--axis-at", "origin", "--profile", file("machine.toml")});
        EXPECT_EQ(sliced.exit_code, 0) << sliced.error;
        start_machine(truth);
        const Outcome carved = run({"carve", file("seam.job"), "--json"});
        EXPECT_EQ(carved.exit_code, 0) << carved.error;
        return measure(take_piece());
    }

    /// What a head carved at one height is a layer's half when it goes half round; the rest are ways between.
    static std::vector<Half> halves(const std::vector<Cut>& piece, bool is_right) {
        std::vector<Half> all;
        Half row;
        const auto end_row = [&] {
            if (row.size() > 2000) all.push_back(from_its_begin(row));
            row.clear();
        };
        for (const Cut& cut : piece) {
            if (cut.is_right != is_right) continue;
            if (!row.empty() && row.back().height_mm != cut.height_mm) end_row();
            row.push_back(cut);
        }
        end_row();
        return all;
    }
    /// It begins behind the half that is not its own.
    static Half from_its_begin(Half row) {
        for (std::size_t i = 1; i < row.size(); ++i) {
            if (row[i].direction_deg - row[i - 1].direction_deg < 90.0) continue;
            std::rotate(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(i), row.end());
            break;
        }
        return row;
    }
    static Deviation measure(const std::vector<Cut>& piece) {
        const std::vector<Half> left = halves(piece, false);
        const std::vector<Half> right = halves(piece, true);
        EXPECT_EQ(left.size(), right.size());
        Deviation deviation;
        deviation.layers = std::min(left.size(), right.size());
        const auto seam = [](const Half& one, const Half& other) {
            return std::fabs(off_pulses(one.back()) - off_pulses(other.front()));
        };
        for (std::size_t layer = 0; layer < deviation.layers; ++layer) {
            for (const Half* half : {&left[layer], &right[layer]}) {
                for (const Cut& cut : *half)
                    deviation.most_pulses = std::max(deviation.most_pulses, std::fabs(off_pulses(cut)));
            }
            deviation.seam_pulses = std::max(
                {deviation.seam_pulses, seam(left[layer], right[layer]), seam(right[layer], left[layer])});
        }
        return deviation;
    }

    /// Moves both tips into the pin and out again, and reads where they met it.
    std::array<std::string, 2> shown_at_pin() {
        start_machine(true_machine(kNew, kPinRadius_mm));
        EXPECT_EQ(run({"home"}).exit_code, 0);
        for (const char* head : {"r1", "r2"}) {
            EXPECT_EQ(run({"move", std::string{head} + "=2.5"}).exit_code, 0);
            EXPECT_EQ(run({"home", head}).exit_code, 0);
        }
        take_piece();
        std::array<std::string, 2> shown;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::string words = std::string{k == 0 ? "r1" : "r2"} + " first touched the blank at ";
            const std::size_t at = core_said_.find(words);
            EXPECT_NE(at, std::string::npos) << core_said_;
            if (at != std::string::npos) shown[k] = core_said_.substr(at + words.size(), 6);
        }
        return shown;
    }
    /// The two marks as they are found on the blank.
    std::array<std::string, 2> marks() {
        start_machine(true_machine(kNew, kMarkedRadius_mm));
        EXPECT_EQ(run({"home"}).exit_code, 0);
        EXPECT_EQ(run({"move", "y=5"}).exit_code, 0);
        EXPECT_EQ(run({"move", "r1=14.5"}).exit_code, 0);
        EXPECT_EQ(run({"home", "r1"}).exit_code, 0);
        EXPECT_EQ(run({"jog", "psi", "180"}).exit_code, 0);
        EXPECT_EQ(run({"move", "r2=14.5"}).exit_code, 0);
        EXPECT_EQ(run({"home", "r2"}).exit_code, 0);
        const std::vector<Cut> piece = take_piece();
        EXPECT_EQ(piece.size(), 2U) << "nothing but the marks";
        const auto of = [&](bool is_right) {
            const auto found = std::find_if(piece.begin(), piece.end(),
                                            [&](const Cut& cut) { return cut.is_right == is_right; });
            return found == piece.end() ? Cut{} : *found;
        };
        const double around_rad = rad_from_deg(of(true).direction_deg - of(false).direction_deg);
        return {number(around_rad * kMarkedRadius_mm, 2),
                number(of(true).height_mm - of(false).height_mm, 2)};
    }

    static std::string number(double value, int digits) {
        char text[32];
        (void)std::snprintf(text, sizeof text, "%.*f", digits, value);
        return text;
    }
    /// psicarve with answers on its standard input.
    int guided(const std::string& answers) const {
        write("answers", answers);
        const std::string command = in_build("bin/psicarve calibrate --guided --profile ") +
                                    file("machine.toml") + " --segment " + segment_ + " < " +
                                    file("answers") + " > " + file("out") + " 2> " + file("err");
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::string core_said_;
};

TEST_F(CalibrationSeam, IsThereBeforeAndGoneAfter) {
    const Profile worn = true_machine(kWorn_mm, kMarkedRadius_mm);
    write_model();
    write("machine.toml", "# ours\n" + profile_to_toml(Profile{}));
    const Deviation before = carve(worn);
    std::printf("before: seam %.2f pulses (%.4f mm), most %.2f pulses in %zu layers\n", before.seam_pulses,
                before.seam_pulses / 400.0, before.most_pulses, before.layers);
    EXPECT_GT(before.seam_pulses, 50.0);
    EXPECT_EQ(before.layers, 12U);

    const auto at_pin = shown_at_pin();
    start_machine(true_machine(kNew, kPinRadius_mm));
    const Outcome unhomed =
        run({"calibrate", "--profile", file("machine.toml"), "--pin-diameter", "6", "--r1-at", "here"});
    EXPECT_EQ(unhomed.exit_code, 4) << unhomed.error;
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"move", "r1=" + at_pin[0]}).exit_code, 0);
    const Outcome left = run(
        {"calibrate", "--profile", file("machine.toml"), "--pin-diameter", "6", "--r1-at", "here", "--json"});
    ASSERT_EQ(left.exit_code, 0) << left.error;
    EXPECT_EQ(left.json()["changes"].size(), 1U) << left.out;
    EXPECT_NE(text_of(file("machine.toml")).find("# ours"), std::string::npos);
    EXPECT_EQ(text_of(file("machine.toml.bak")), "# ours\n" + profile_to_toml(Profile{}));
    // The core still counts by the old one: it does not say where R2 is by the new one.
    EXPECT_EQ(run({"calibrate", "--profile", file("machine.toml"), "--pin-diameter", "6", "--r2-at", "here"})
                  .exit_code,
              4);
    take_piece();
    const auto between = marks();
    // The rest in one talk, with a slip of the finger or two.
    EXPECT_EQ(guided("\n6\n5O\n" + at_pin[1] + "\n30\n300\n0\n30\n" + between[0] + "\n" + between[1] +
                     "\n0.05\n\nyes\n"),
              0)
        << text_of(file("err"));
    EXPECT_NE(text_of(file("err")).find("'5O' is not a number"), std::string::npos) << text_of(file("err"));
    EXPECT_NE(text_of(file("err")).find("half a turn?"), std::string::npos) << text_of(file("err"));

    const auto calibrated = load_profile(file("machine.toml"));
    ASSERT_TRUE(calibrated.has_value()) << calibrated.error().message;
    EXPECT_NEAR(calibrated->r1.tip_mm(), worn.r1.tip_mm(), 0.0026) << "a pulse";
    EXPECT_NEAR(calibrated->r2.tip_mm(), worn.r2.tip_mm(), 0.0026);
    EXPECT_NEAR(calibrated->head_r2_angle_error_deg, 1.4, 0.04);
    EXPECT_NEAR(calibrated->head_r2_height_error_mm, 0.25, 0.011);
    const Deviation after = carve(worn);
    std::printf("after:  seam %.2f pulses (%.4f mm), most %.2f pulses in %zu layers\n", after.seam_pulses,
                after.seam_pulses / 400.0, after.most_pulses, after.layers);
    // A pulse of each tip, a caliper's hundredth on the steepest flank, and what cell and pulse round off.
    EXPECT_LT(after.seam_pulses, 4.0);
    EXPECT_LT(after.most_pulses, 6.0);
    EXPECT_EQ(after.layers, 12U);
}

TEST_F(CalibrationSeam, WhatCannotBeIsRefusedAndNothingIsWritten) {
    const std::string text = profile_to_toml(Profile{});
    write("machine.toml", text);
    const auto exit_code = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"calibrate", "--profile", file("machine.toml")});
        return run(more).exit_code;
    };
    EXPECT_EQ(run({"calibrate", "--r1-wear", "0.1"}).exit_code, 2) << "no file";
    EXPECT_EQ(exit_code({}), 2) << "nobody there to ask";
    EXPECT_EQ(exit_code({"--r1-wear", "o.1"}), 2);
    EXPECT_EQ(exit_code({"--pin-diameter", "6"}), 2);
    EXPECT_EQ(exit_code({"--r1-at", "3"}), 2);
    EXPECT_EQ(exit_code({"--blank-diameter", "40", "--mark-up", "0.1"}), 2);
    EXPECT_EQ(exit_code({"--guided", "--r1-wear", "0.1"}), 2);
    EXPECT_EQ(exit_code({"--r1-wear", "60"}), 3);
    EXPECT_EQ(exit_code({"--pin-diameter", "60", "--r1-at", "3"}), 3);
    EXPECT_EQ(exit_code({"--blank-diameter", "40", "--mark-around", "-30", "--mark-up", "0"}), 3);
    EXPECT_EQ(exit_code({"--pin-diameter", "6", "--r1-at", "here"}), 5) << "no core";
    EXPECT_EQ(run({"calibrate", "--profile", file("none.toml"), "--r1-wear", "0.1"}).exit_code, 3);
    EXPECT_EQ(guided("6\n3.1\n"), 4) << "the answers ended";
    EXPECT_EQ(guided("6\n3.1\n\n\n\n\nno\n"), 4);
    EXPECT_EQ(text_of(file("machine.toml")), text);
    EXPECT_FALSE(std::filesystem::exists(file("machine.toml.bak")));
    EXPECT_EQ(guided("\n\n\n\n\n"), 0) << text_of(file("err"));
    EXPECT_NE(text_of(file("out")).find("nothing changed"), std::string::npos);
    EXPECT_EQ(exit_code({"--blank-diameter", "40", "--mark-around", "-0.35", "--mark-up", "0.2"}), 0);
    EXPECT_NE(text_of(file("machine.toml")), text);
}

}  // namespace
}  // namespace psicarve::test
