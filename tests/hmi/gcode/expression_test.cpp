// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <random>

#include "hmi/gcode/expression_reader.hpp"
#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

struct NoMachine : ProgramState {
    StateAnswer numbered(std::uint32_t /*number*/) const override { return {}; }
    StateAnswer named(std::string_view /*name*/) const override { return {}; }
};

/// An expression as text, and what C++ makes of the same tree.
struct Made {
    std::string text;
    double value = 0.0;
    int strength = 6;  ///< of its weakest operator outside brackets
};

/// Random expressions whose values stay moderate, with as few brackets as the order of operators allows.
class ExpressionMaker {
public:
    explicit ExpressionMaker(std::uint64_t seed) : random_(seed) {}

    Made make(int depth) {
        if (depth == 0 || draw(6) == 0) return number();
        const int kind = draw(12);
        return kind < 3 ? function(depth) : binary(depth);
    }

private:
    int draw(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }

    Made number() {
        const double value = (draw(20'000) - 10'000) / 100.0;
        char text[32];
        std::snprintf(text, sizeof text, "%.2f", value);
        return {text, value, 6};
    }

    std::string blank() { return draw(3) == 0 ? " " : ""; }

    std::string within(const Made& part, bool needs_brackets) {
        return needs_brackets ? "[" + blank() + part.text + "]" : part.text;
    }

    Made function(int depth) {
        const Made part = make(depth - 1);
        const std::string in = "[" + blank() + part.text + blank() + "]";
        const double angle_rad = part.value * (std::acos(-1.0) / 180.0);
        switch (draw(7)) {
            case 0:
                return {"ABS" + in, std::abs(part.value)};
            case 1:
                return {"sin" + in, std::sin(angle_rad)};
            case 2:
                return {"Cos" + in, std::cos(angle_rad)};
            case 3:
                return {"FIX" + in, std::floor(part.value)};
            case 4:
                return {"FUP" + in, std::ceil(part.value)};
            case 5:
                return {"SQRT[ABS" + in + "]", std::sqrt(std::abs(part.value))};
            default:
                return {"ATAN" + in + "/[7]", std::atan2(part.value, 7.0) * (180.0 / std::acos(-1.0))};
        }
    }

    Made binary(int depth) {
        struct Row {
            const char* text;
            int strength;
        };
        static constexpr Row kRows[] = {{"+", 3},  {"-", 3},  {"*", 4},   {"/", 4},  {"MOD", 4}, {"LT", 2},
                                        {"gt", 2}, {"LE", 2}, {"AND", 1}, {"OR", 1}, {"xor", 1}, {"**", 5}};
        const int which = draw(12);
        const Row& row = kRows[which];
        Made left = make(depth - 1);
        Made right = make(depth - 1);
        if (which == 3 || which == 4) right = {"[ABS[" + right.text + "]+1]", std::abs(right.value) + 1.0};
        if (which == 11) {
            left = {"[ABS[" + left.text + "] MOD 10+1]", std::fmod(std::abs(left.value), 10.0) + 1.0};
            right = {"2", 2.0};
        }
        const std::string text = within(left, left.strength < row.strength) + blank() + row.text + blank() +
                                 within(right, right.strength <= row.strength);
        return {text, value_of(which, left.value, right.value), row.strength};
    }

    static double value_of(int which, double a, double b) {
        switch (which) {
            case 0:
                return a + b;
            case 1:
                return a - b;
            case 2:
                return a * b;
            case 3:
                return a / b;
            case 4:
                return std::fmod(a, b) < 0.0 ? std::fmod(a, b) + b : std::fmod(a, b);
            case 5:
                return a < b ? 1.0 : 0.0;
            case 6:
                return a > b ? 1.0 : 0.0;
            case 7:
                return a <= b ? 1.0 : 0.0;
            case 8:
                return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
            case 9:
                return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
            case 10:
                return (a != 0.0) != (b != 0.0) ? 1.0 : 0.0;
            default:
                return std::pow(a, b);
        }
    }

    std::mt19937_64 random_;
};

TEST(Expressions, HaveTheValueThatCppGivesThemToTheLastBit) {
    const NoMachine state;
    Parameters parameters{state};
    ExpressionMaker maker{11};
    int compared = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Made made = maker.make(1 + i % 6);
        const std::string text = "[" + made.text + "]";
        double value = 0.0;
        ExpressionReader sut{text, 0, parameters, false};
        ASSERT_TRUE(sut.read_value(value)) << text << ": " << in_english(sut.fault().what);
        ASSERT_EQ(sut.at(), text.size()) << text;
        ASSERT_NEAR(value, made.value, 1e-12 * (1.0 + std::abs(made.value))) << text;
        ++compared;
    }
    EXPECT_EQ(compared, 20'000);
}

TEST(Expressions, AreJudgedWithoutValues) {
    const NoMachine state;
    Parameters parameters{state};
    for (const std::string text : {"[1 / 0]", "#<never>", "[SQRT[-1] + LN[0]]", "##9999"}) {
        double value = 0.0;
        EXPECT_TRUE((ExpressionReader{text, 0, parameters, true}.read_value(value))) << text;
        EXPECT_FALSE((ExpressionReader{text, 0, parameters, false}.read_value(value))) << text;
    }
    double value = 0.0;
    EXPECT_FALSE((ExpressionReader{"[1 +]", 0, parameters, true}.read_value(value)));
}

TEST(Expressions, NestOnlySoDeep) {
    const NoMachine state;
    Parameters parameters{state};
    for (const int levels : {60, 500}) {
        const auto count = static_cast<std::size_t>(levels);
        const std::string text = std::string(count, '[') + "1" + std::string(count, ']');
        double value = 0.0;
        ExpressionReader sut{text, 0, parameters, false};
        ASSERT_EQ(sut.read_value(value), levels == 60);
        if (levels == 500) {
            EXPECT_EQ(sut.fault().code, ProblemCode::too_deep);
        }
    }
}

TEST(Expressions, RefuseWhatHasNoValue) {
    const auto fault = [](const std::string& value) {
        return read_program("G0 X" + value + "\nM2\n")->faults();
    };
    for (const std::string value : {"[1/0]", "[1 MOD 0]", "[[-8] ** [1/3]]", "[LN[0]]", "[SQRT[-1]]",
                                    "[ACOS[1.1]]", "[ASIN[-2]]", "[EXP[1000]]", "[10 ** 400]", "[0 ** -1]"}) {
        const Faults faults = fault(value);
        ASSERT_EQ(faults.size(), 1U) << value;
        EXPECT_NE(faults.front().find("value_impossible"), std::string::npos) << value;
    }
    EXPECT_EQ(fault("[10 ** 9 + 1]"), Faults{"1:4 bad_number"});
    for (const std::string value :
         {"[]", "[1 2 +]", "[1]]", "[1 = 2]", "SIN", "[SIN]", "ATAN[1]", "#", "#[", "-"})
        EXPECT_EQ(fault(value).size(), 1U) << value;
}

}  // namespace
}  // namespace psicarve::gcode
