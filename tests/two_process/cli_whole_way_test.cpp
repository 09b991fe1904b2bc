// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/hmi/cli/program_run.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

// From a model's file to what left the pins, judged by nothing of ours in between.
namespace psicarve::test {
namespace {

/// Where the axes stand, counted from a value-change dump: steps with the direction's level, from the last
/// positions that a comment gives.
class PinsOfADump {
public:
    explicit PinsOfADump(const std::string& text) : lines_(text) {}

    /// Goes on to the next instant, when all pulses of the last one have been counted; false at the end.
    bool next() {
        for (std::string line; std::getline(lines_, line);) {
            if (line.starts_with("#")) return true;
            if (line.starts_with("$var wire 1 ")) {
                const auto words = words_of(line);
                names_[words[3]] = words[4];
            } else if (line.starts_with("$comment position_pulses")) {
                take_positions(line);
            } else if (line.size() > 1 && (line[0] == '0' || line[0] == '1')) {
                take_level(line);
            }
        }
        return false;
    }
    std::int64_t at(const std::string& axis) const { return positions_.at(axis); }

private:
    void take_positions(const std::string& line) {
        for (const std::string& word : words_of(line)) {
            const auto equals = word.find('=');
            if (equals != std::string::npos) {
                positions_[word.substr(0, equals)] = std::stoll(word.substr(equals + 1));
            }
        }
    }
    void take_level(const std::string& line) {
        const std::string& name = names_.at(line.substr(1));
        const bool is_high = line[0] == '1';
        const bool was_high = std::exchange(levels_[name], is_high);
        if (!name.ends_with("_step") || !is_high || was_high) return;
        const std::string axis = name.substr(0, name.size() - 5);
        if (levels_[axis + "_enable"]) positions_[axis] += levels_[axis + "_dir"] ? 1 : -1;
    }

    std::istringstream lines_;
    std::map<std::string, std::string> names_;
    std::map<std::string, bool> levels_;
    std::map<std::string, std::int64_t> positions_;
};

class WholeWay : public CliTest {
protected:
    std::string stl(const std::string& name, const model::Mesh& mesh) const {
        write(name, mesh_files::binary_stl(mesh));
        return file(name);
    }
};

/// How the upright letter lies in a file that `up` raises.
model::Mesh letter_for(char up) {
    return shapes::moved(shapes::letter(), [up](const shapes::Point& p) {
        if (up == 'x') return shapes::Point{p[2], p[0], p[1]};
        if (up == 'y') return shapes::Point{p[1], p[2], p[0]};
        return p;
    });
}

// Counter-clockwise from R1's direction 0: 9 mm along +x at the bottom, 6 along +y in the middle, 4 along -x
// on top. Turning its positive way the table brings +y before R1 after +x.
TEST_F(WholeWay, ALetterComesOutOfThePinsUnmirroredHoweverItLies) {
    for (const char up : {'x', 'y', 'z'}) {
        if (!is_thorough() && up != 'x') continue;
        const std::string model = stl("letter.stl", letter_for(up));
        const Outcome outcome = psicarve({"carve", model, "--segment", segment_, "--up", std::string{up},
                                          "--axis-at", "origin", "--layers", "3", "--points", "5",
                                          "--joining", "zigzag", "--trace", file("letter.vcd"), "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
        // By height and quarter of a turn: the deepest that each head went.
        std::map<std::pair<std::int64_t, std::int64_t>, std::array<std::int64_t, 2>> deepest;
        PinsOfADump pins{text_of(file("letter.vcd"))};
        while (pins.next()) {
            const std::int64_t turned = (pins.at("psi") % 6400 + 6400) % 6400;
            if (turned % 1600 != 0) continue;
            const std::pair place{pins.at("y"), turned / 1600};
            auto& [r1, r2] =
                deepest.try_emplace(place, std::array<std::int64_t, 2>{99999, 99999}).first->second;
            r1 = std::min(r1, pins.at("r1"));
            r2 = std::min(r2, pins.at("r2"));
        }
        const auto at = [&](std::int64_t y, std::int64_t quarter) {
            const auto found = deepest.find({y, quarter});
            if (found == deepest.end()) return std::array<double, 2>{};
            return std::array{static_cast<double>(found->second[0]), static_cast<double>(found->second[1])};
        };
        // A pulse of r1 may come before psi's next one: by as much as the path may leave its line.
        constexpr double kTolerance_pulses = 5.0;
        EXPECT_NEAR(at(800, 0)[0], 9 * 400, kTolerance_pulses) << up;
        EXPECT_NEAR(at(2400, 1)[0], 6 * 400, kTolerance_pulses) << up;
        EXPECT_NEAR(at(2400, 1)[1], 600, kTolerance_pulses) << up;
        EXPECT_NEAR(at(4000, 2)[0], 4 * 400, kTolerance_pulses) << up;
        EXPECT_NEAR(at(4000, 0)[1], 4 * 400, kTolerance_pulses) << up;
    }
}

// Its pins change every 500 us, under a lock; its motors are those of its time.
TEST_F(WholeWay, TheOriginalsMachineCarvesToo) {
    for (const std::string profile : {"/original.toml", "/fine.toml"}) {
        const Outcome outcome =
            psicarve({"carve", example("small.stl"), "--profile", in_source("examples") + profile,
                      "--segment", segment_, "--layers", "5", "--points", "20", "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << profile << outcome.error;
        EXPECT_EQ(outcome.json()["verified"], true) << profile;
        EXPECT_EQ(outcome.json()["verification"]["points_visited"], 100) << profile;
        EXPECT_EQ(outcome.json()["alarms"], nlohmann::json::array()) << profile;
    }
}

}  // namespace
}  // namespace psicarve::test
