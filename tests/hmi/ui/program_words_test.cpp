// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a program, in each language of the window.
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "hmi/ui/language.hpp"
#include "hmi/ui/words.hpp"
#include "shared/base/printable.hpp"
#include "tests/hmi/gcode/read_program.hpp"
#include "tests/hmi/ui/program_rig.hpp"
#include "tests/parameter_name.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using gcode::Problem;

/// A machine that warns of all that a machine can warn of.
Profile strict_machine(bool is_stepwise) {
    Profile profile;
    profile.head_clearance_mm = 4.0;
    profile.core_radius_mm = 5.0;
    profile.gcode.is_stepwise = is_stepwise;
    return profile;
}

/// Beside the files of tests/data/gcode/bad: warnings, what is too long for a file, other words of a code.
std::vector<std::string> more_programs() {
    std::string many_names;
    for (int i = 0; i <= 10'000; ++i) many_names += "#<n" + std::to_string(i) + "> = 1\n";
    return {
        many_names,
        "o1 repeat [100]\nG0 X41\nX42\no1 endrepeat\nM2\n",
        "O5\nG4 P1\nM98 P5\nM2\n",
        "G0 X1\nM99\n",
        "F9 G20 G1 X1\nG64 P.01 Q.1\nS100 M3\nM8\nM2\n",
        "G21 G90 F600\nG0 X50 Z50 Y40 C0\nG1 X49\no1 repeat [3]\nG1 X49 C5\nG1 X48 C0\no1 endrepeat\n"
        "G1 X50 Z49\nG3 I-.01\nG3 I-1 C9\nG0 C0\nG0 X59\nG12.1\nG1 C9\nM2\n",
        "G4 P100000\nG64 P11\nM49\nM52\nM4\nM2\n",
        "G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X20 C4\nX-20\nM2\n",
        "G21 G90 F300\nG0 X40 Y999\nX3\nG1 Z1 F.001\nM2\n",
        "#1=[ACOS[2]]\nM2\n",
        "#1=[1/0]\nM2\n",
        "#1=[2 &]\nM2\n",
        "G0 X12345678901\n",
        "G81 X1\nG82 X1 Z1 R1\nM62\nM98\nG10\nG10 L2\nG4\nM2\n",
        "",
    };
}

/// Problems of one program of each kind, by code.
const std::vector<Problem>& all_problems() {
    static const std::vector<Problem> kAll = [] {
        std::vector<std::string> texts = more_programs();
        for (const auto& file : std::filesystem::directory_iterator{in_source("tests/data/gcode/bad")})
            if (file.path().extension() == ".ngc") texts.push_back(gcode::file_text(file.path().string()));
        std::vector<Problem> all;
        gcode::InterpreterOptions options;
        options.most_repeated_blocks = 50;
        options.most_idle_blocks = 40;
        for (const std::string& text : texts) {
            for (const bool is_stepwise : {false, true}) {
                const Profile profile = strict_machine(is_stepwise);
                const auto read = gcode::read_program(text, options, &profile);
                for (const auto* list : {&read->problems.errors(), &read->problems.warnings()})
                    all.insert(all.end(), list->begin(), list->end());
            }
        }
        return all;
    }();
    return kAll;
}

bool has_word(const std::string& text) {
    static const QRegularExpression kWord{"[A-Za-z]{2}"};
    return QString::fromStdString(text).contains(kWord);
}

/// Templates that the language lacks, and arguments that its words have lost.
void look_through(const session::Phrase& text, const QString& shown, std::set<std::string>& wrong) {
    const QString translated = QCoreApplication::translate("session", text.english);
    if (has_word(text.english) && translated == QString::fromUtf8(text.english)) wrong.insert(text.english);
    for (const std::string& argument : text.arguments)
        if (!shown.contains(QString::fromStdString(printable(argument))))
            wrong.insert(std::string{text.english} + " without " + argument);
    for (const session::Phrase& inner : text.inner) look_through(inner, shown, wrong);
}

class ProgramWords : public test::ProgramRig, public ::testing::WithParamInterface<Language> {
protected:
    ProgramWords() { use_language(GetParam()); }
    ~ProgramWords() override { use_language(Language::english); }
};

TEST_P(ProgramWords, TellEveryProblemWithItsArguments) {
    static const QRegularExpression kMark{"%[1-9]"};
    static const QRegularExpression kOwnLetters{"[\\p{Cyrillic}\\p{Han}]"};
    std::set<std::string> codes;
    std::set<std::string> wrong;
    for (const Problem& problem : all_problems()) {
        codes.emplace(name_of(problem.code));
        const session::Phrase text = problem_phrase(problem);
        const QString shown = words(text);
        look_through(text, shown, wrong);
        if (shown.contains(kMark)) wrong.insert("a mark in " + shown.toStdString());
        for (const session::Phrase& part : text.inner)
            if (!words(part).contains(kOwnLetters)) wrong.insert(words(part).toStdString());
    }
    EXPECT_EQ(wrong, std::set<std::string>{});
    for (std::size_t i = 0; i < gcode::kProblemCodeCount; ++i) {
        const std::string code{name_of(static_cast<gcode::ProblemCode>(i))};
        EXPECT_TRUE(codes.contains(code)) << code << " is raised by no program here";
    }
}

// The same on the page: its list, beside the lines, and below a block that was typed.
TEST_P(ProgramWords, StandOnThePageAndBelowATypedBlock) {
    const bool is_russian = GetParam() == Language::russian;
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    show_page("program_page");
    ASSERT_TRUE(opens("G21 G90\nG0 X40\nG1 X30\nG1 F300 X99\nS1000 M7\nG0 Y1 <\nM2\n"));
    const auto& list = part<QListWidget>("program_problems");
    ASSERT_EQ(list.count(), 5);
    EXPECT_EQ(list.item(0)->text().toStdString(),
              is_russian
                  ? "Строка 3, столбец 4: feed_missing: рабочее перемещение, а подача 0; задайте F до "
                    "первого рабочего перемещения"
                  : "第 3 行第 4 列：feed_missing：切削运动，而进给为 0；请在第一个切削运动之前给出 F");
    EXPECT_TRUE(list.item(1)->text().contains(QString::fromUtf8(
        is_russian ? "r1 приходит в 99.0000 mm, её ход от " : "r1 到达 99.0000 mm，其行程为 ")))
        << list.item(1)->text().toStdString();
    take_picture(is_russian ? "program_words_ru" : "program_words_zh");
    auto& line = part<QLineEdit>("mdi_line");
    line.setFocus();
    line.setText("G1 X43 F3OO");
    press_key(Qt::Key_Return);
    ASSERT_TRUE(comes_true([&] { return desk().ended() && desk().ended()->problems.error_count() > 0; }));
    window_->refresh();
    EXPECT_EQ(text_of("mdi_said").toStdString(),
              is_russian ? "Столбец 10: o_word_beside: слово O стоит после других слов; дайте слову O "
                           "отдельную строку"
                         : "第 10 列：o_word_beside：O 字位于其他字之后；请让 O 字单独成行");
}

INSTANTIATE_TEST_SUITE_P(Ui, ProgramWords, ::testing::Values(Language::chinese, Language::russian),
                         [](const auto& language) {
                             return language.param == Language::russian ? "Russian" : "Chinese";
                         });

}  // namespace
}  // namespace psicarve::ui
