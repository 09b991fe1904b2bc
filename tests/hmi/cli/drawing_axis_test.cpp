// SPDX-License-Identifier: GPL-3.0-or-later
// Where the rotation axis passes through a drawing: radii of a square and a circle off the origin, from
// formulas, to the pulse.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

using Vector = std::array<double, 2>;
/// How far it is from the axis to the outside, in a direction.
using Radius = std::function<double(double)>;

constexpr double kPulsesPerMm = 400.0;   // of the built-in profile
constexpr Vector kCentre_mm{5.0, -4.0};  // of both shapes; y upwards
constexpr double kHalf_mm = 9.0;         // the square's side, the circle's radius

double square(const Vector& axis_mm, double angle_rad) {
    const Vector along{std::cos(angle_rad), std::sin(angle_rad)};
    double radius_mm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
        if (std::abs(along[i]) < 1e-9) continue;
        const double side_mm = kCentre_mm[i] - axis_mm[i] + (along[i] > 0.0 ? kHalf_mm : -kHalf_mm);
        radius_mm = std::min(radius_mm, side_mm / along[i]);
    }
    return radius_mm;
}

double circle(const Vector& axis_mm, double angle_rad) {
    const Vector to{kCentre_mm[0] - axis_mm[0], kCentre_mm[1] - axis_mm[1]};
    const double along_mm = to[0] * std::cos(angle_rad) + to[1] * std::sin(angle_rad);
    return along_mm + std::sqrt(kHalf_mm * kHalf_mm - to[0] * to[0] - to[1] * to[1] + along_mm * along_mm);
}

class DrawingAxis : public CliTest {
protected:
    DrawingAxis() {
        // An SVG's origin is its page's upper left corner, and its y goes down.
        const std::string page =
            "<svg xmlns='http://www.w3.org/2000/svg' width='40mm' height='40mm' viewBox='0 0 40 40' "
            "overflow='visible'>";
        write("square.svg", page + "<rect x='-4' y='-5' width='18' height='18'/></svg>");
        write("circle.svg", page + "<circle cx='5' cy='4' r='9'/></svg>");
        // The same place on paper, which its page begins farther left and up.
        write("moved.svg",
              "<svg xmlns='http://www.w3.org/2000/svg' width='4cm' height='4cm' viewBox='-100 -200 80 80' "
              "overflow='visible'><rect x='-108' y='-210' width='36' height='36'/></svg>");
        const std::string head =
            "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
        const std::string tail = "0\nENDSEC\n0\nEOF\n";
        write(
            "square.dxf",
            head +
                "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n-4\n20\n-13\n10\n14\n20\n-13\n10\n14\n20\n5\n10\n-4\n"
                "20\n5\n" +
                tail);
        write("circle.dxf", head + "0\nCIRCLE\n8\n0\n10\n5\n20\n-4\n40\n9\n" + tail);
    }

    /// Both heads' radii, all round.
    std::vector<std::int32_t> radii_pulses(const std::string& name, const std::string& options) const {
        std::vector<std::string> words{"slice",    file(name), "-o",       file("a.job"),
                                       "--layers", "1",        "--points", "9"};
        for (const std::string& word : words_of(options)) words.push_back(word);
        const Outcome sliced = psicarve(words);
        EXPECT_EQ(sliced.exit_code, 0) << sliced.error;
        const auto read = load_snapshot(file("a.job"));
        if (sliced.exit_code != 0 || !read) return {};
        const JobView job = JobView::check(read->job_blob).value();
        std::vector<std::int32_t> radii;
        for (std::size_t j = 0; j + 1 < job.point_count(); ++j) radii.push_back(job.r_left_pulses(0)[j]);
        for (std::size_t j = 0; j + 1 < job.point_count(); ++j) radii.push_back(job.r_right_pulses(0)[j]);
        return radii;
    }
    void expect_radii(const std::string& name, const std::string& options, const Radius& wanted_mm) const {
        const auto radii = radii_pulses(name, options);
        ASSERT_EQ(radii.size(), 16U) << name;
        for (std::size_t k = 0; k < radii.size(); ++k) {
            const double angle_rad = 2.0 * kPi * static_cast<double>(k) / 16.0;
            // Rounded to a pulse, and a curve's pieces leave it by a fifth of one.
            EXPECT_NEAR(radii[k], kPulsesPerMm * wanted_mm(angle_rad), 0.71)
                << name << ' ' << options << ", direction " << 22.5 * static_cast<double>(k);
        }
    }
    void expect_about(const Vector& axis_mm, const std::string& options) const {
        for (const std::string name : {"square.svg", "square.dxf", "moved.svg"})
            expect_radii(name, options, [&](double angle_rad) { return square(axis_mm, angle_rad); });
        for (const std::string name : {"circle.svg", "circle.dxf"})
            expect_radii(name, options, [&](double angle_rad) { return circle(axis_mm, angle_rad); });
    }
};

TEST_F(DrawingAxis, IsTheAreasCentroidWhereNothingIsSaid) {
    expect_about(kCentre_mm, "");
}

TEST_F(DrawingAxis, IsTheDrawingsOriginWhenAsked) {
    expect_about({0.0, 0.0}, "--axis-at origin");
}

TEST_F(DrawingAxis, IsTheGivenPointWithYUpwards) {
    expect_about({3.5, -7.25}, "--axis-at 3.5,-7.25");
    expect_about({-1.0, 0.0}, "--axis-at=-1,0");
}

TEST_F(DrawingAxis, OfALopsidedShapeIsTheCentroidAndNotTheBoxsMiddle) {
    // Two thirds of the way from the right angle's corner to the others' sides.
    write("corner.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='40mm' height='40mm' viewBox='0 0 40 40'>"
          "<path d='M6,30 H30 L6,6 Z'/></svg>");
    const auto radii = radii_pulses("corner.svg", "");
    ASSERT_EQ(radii.size(), 16U);
    EXPECT_NEAR(radii[8], kPulsesPerMm * 8.0, 0.71);   // to the left side, 24 / 3 away
    EXPECT_NEAR(radii[12], kPulsesPerMm * 8.0, 0.71);  // and down
    EXPECT_NEAR(radii[0], kPulsesPerMm * 8.0, 0.71);   // to the long side
    EXPECT_NEAR(radii[2], kPulsesPerMm * 8.0 / std::sqrt(2.0), 0.71);
    EXPECT_NEAR(radii[10], kPulsesPerMm * 8.0 * std::sqrt(2.0), 0.71);  // into the corner
}

}  // namespace
}  // namespace psicarve::test
