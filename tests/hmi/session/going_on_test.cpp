// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/going_on.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "hmi/session/start_place.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;

/// After 131 of 200 layers.
MachineView stopped_in(S state) {
    MachineView machine = machine_in(state);
    machine.resumable_layer = 131;
    machine.checkpoint_layer_count = 200;
    return machine;
}

OpenJobView desk_in(OpenJobState state) {
    return OpenJobView{state, false, 200};
}

std::string start_says(const MachineView& machine, OpenJobState desk = OpenJobState::published,
                       bool is_dry = false) {
    return in_english(start_text(machine, desk_in(desk), is_dry));
}

std::vector<std::string> details(const UnfinishedPiece& piece, const MachineView& machine,
                                 const cam::PreparedJob* job = nullptr) {
    std::vector<std::string> said;
    for (const Phrase& each : unfinished_details(piece, machine, job)) said.push_back(in_english(each));
    return said;
}

/// Layers of five points, 1 mm apart; R1's tip is at 10 mm, R2's at 20 mm.
cam::PreparedJob some_layers(std::uint32_t count = 4, std::int64_t apart_pulses = 400,
                             std::vector<JobPass> passes = {}) {
    const Profile profile;
    JobTable table;
    table.layer_count = count;
    table.point_count = 5;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = Joining::continuous;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::int64_t layer = 0; layer < count; ++layer) {
        table.layer_height_pulses.push_back(apart_pulses * (layer + 1));
        table.r_left_pulses.insert(table.r_left_pulses.end(), 5, 4000);
        table.r_right_pulses.insert(table.r_right_pulses.end(), 5, 8000);
    }
    if (!passes.empty()) {  // the upper layers lie where the lower ones do
        for (std::uint32_t layer = passes.back().first_layer; layer < count; ++layer)
            table.layer_height_pulses[layer] = table.layer_height_pulses[layer - passes.back().first_layer];
    }
    table.passes = std::move(passes);
    auto job = cam::prepare_blob(job_blob_from_table(table), profile, "four layers");
    EXPECT_TRUE(job);
    return std::move(*job);
}

TEST(GoingOnWords, TheButtonSaysWithWhichLayerItBegins) {
    for (const S state : {S::off, S::ready, S::alarm, S::homing, S::moving})
        EXPECT_EQ(start_says(stopped_in(state)), "Continue from layer 132") << name_of(state);
    EXPECT_EQ(start_says(stopped_in(S::ready), OpenJobState::empty), "Continue from layer 132");
    EXPECT_EQ(start_says(machine_in(S::ready)), "Start");
    EXPECT_EQ(start_says(stopped_in(S::ready), OpenJobState::published, true), "Start dry run");
    for (const S state : {S::positioning, S::carving, S::holding, S::held, S::finishing, S::stopping})
        EXPECT_EQ(start_says(stopped_in(state)), "Start") << name_of(state);
    for (const OpenJobState other :
         {OpenJobState::opening, OpenJobState::model, OpenJobState::slicing, OpenJobState::job})
        EXPECT_EQ(start_says(stopped_in(S::ready), other), "Start") << "another job is open";
}

TEST(GoingOnWords, TheButtonSaysItOfACoreThatIsGone) {
    MachineView machine = stopped_in(S::carving);
    machine.life = CoreLife::none;
    EXPECT_EQ(start_says(machine), "Continue from layer 132");
    OpenJobView open = desk_in(OpenJobState::job);
    open.is_of_checkpoint = true;
    EXPECT_EQ(in_english(start_text(machine, open, false)), "Continue from layer 132")
        << "as the segment has it";
    EXPECT_TRUE(unfinished_piece(machine, open));
    EXPECT_EQ(start_says(machine, OpenJobState::job), "Start") << "another job is open";
    EXPECT_FALSE(unfinished_piece(machine, desk_in(OpenJobState::job)));
    EXPECT_EQ(start_says(machine, OpenJobState::model), "Start");
}

TEST(GoingOnWords, TheButtonSaysForWhichLayerTheHeadsWait) {
    MachineView machine = stopped_in(S::waiting);
    EXPECT_EQ(start_says(machine), "Start") << "at the first";
    machine.status->layer = 40;
    EXPECT_EQ(start_says(machine), "Continue from layer 41");
    EXPECT_EQ(place_to_begin_with(machine, desk_in(OpenJobState::published), false), (StartPlace{40, {}}));
    machine.status->is_dry = 1;
    EXPECT_EQ(start_says(machine), "Start dry run");
}

/// The 57th point of the layer behind the 131 finished ones.
MachineView stopped_within(S state) {
    MachineView machine = stopped_in(state);
    machine.resumable_point = 56;
    return machine;
}

TEST(GoingOnWords, TheButtonSaysTheLastPointThatIsCarved) {
    for (const S state : {S::off, S::ready, S::alarm})
        EXPECT_EQ(start_says(stopped_within(state)), "Continue from layer 132, point 57") << name_of(state);
    EXPECT_EQ(start_says(stopped_within(S::carving)), "Start");
    EXPECT_EQ(start_says(stopped_within(S::ready), OpenJobState::model), "Start");
    EXPECT_EQ(start_says(stopped_within(S::ready), OpenJobState::published, true), "Start dry run");
    MachineView lost = stopped_within(S::carving);
    lost.life = CoreLife::none;
    EXPECT_EQ(start_says(lost), "Continue from layer 132, point 57");
    MachineView in_first = machine_in(S::ready);
    in_first.checkpoint_layer_count = 200;
    in_first.resumable_point = 4;
    EXPECT_EQ(start_says(in_first), "Continue from layer 1, point 5");
    const auto piece = unfinished_piece(in_first, desk_in(OpenJobState::published));
    ASSERT_TRUE(piece);
    EXPECT_EQ(in_english(unfinished_title(*piece)),
              "Unfinished: a part of the first of 200 layers is carved");
    EXPECT_EQ(in_english(anew_question(*piece)),
              "A part of layer 1 of 200 is carved and would be carved again.");
}

TEST(GoingOnWords, TheButtonSaysForWhichPointTheHeadsWait) {
    MachineView machine = machine_in(S::waiting);
    OpenJobView desk = desk_in(OpenJobState::published);
    desk.core_layer_count = 200;
    machine.status->points_total = 200 * 50;
    machine.status->layer = 40;
    machine.status->point = 12;
    machine.status->points_done = 40 * 50 + 13;
    EXPECT_EQ(place_to_begin_with(machine, desk, false), (StartPlace{40, 12}));
    machine.status->points_done = 40 * 50 + 1;
    machine.status->point = 49;
    EXPECT_EQ(place_to_begin_with(machine, desk, false), (StartPlace{40, {}})) << "the layer's begin";
}

TEST(GoingOnWords, TheOrderLetsTheCoreLookAtThePlaceItself) {
    const MachineView machine = stopped_within(S::ready);
    const Command within = start_command(machine, {131, 56}, 0, false);
    EXPECT_EQ(within.axis, kStartResumes | kStartResumesWithin);
    EXPECT_EQ(within.value, 131.0);
    EXPECT_EQ(start_point_number(within), 57U);
    EXPECT_EQ(start_command(machine, {131, {}}, 0, false).axis, kStartResumes) << "the layer's begin";
    EXPECT_EQ(start_command(machine, {131, 55}, 0, false).axis, 0U);
    EXPECT_EQ(start_command(machine, {131, 56}, 1, false).axis, 0U);
    EXPECT_EQ(start_command(machine, {131, 56}, 0, true).axis, kStartsDry);
    EXPECT_EQ(in_english(start_name({131, 56})), "Start from layer 132, point 57");
    EXPECT_EQ(in_english(start_name({131, {}})), "Start");
}

TEST(GoingOnWords, TheWayIsThatToThePointItself) {
    cam::PreparedJob job = some_layers();
    MachineView machine = machine_in(S::ready);
    machine.status->points_done = 12;
    machine.status->points_total = 20;
    machine.status->layer = 2;
    machine.status->point = 1;
    const std::vector<std::string> said{
        "Last good: layer 3, to its point 2.",
        "Then: heads out, Ψ to 45.00°, Y to 3.00 mm, spindle on, heads in to R1 10.00, R2 20.00 mm."};
    EXPECT_EQ(details({2, 0, 4, 1}, machine, &job), said) << "where it ended is not said twice";
    machine.status->point = 2;
    EXPECT_EQ(details({2, 0, 4, 1}, machine, &job)[1], "It ended in layer 3, point 3.");
    EXPECT_TRUE(is_place_of(job, {2, 3}));
    EXPECT_FALSE(is_place_of(job, {2, 4})) << "nothing of the layer is left behind it";
    EXPECT_FALSE(is_place_of(job, {4, 1}));
}

TEST(GoingOnWords, APieceIsUnfinishedUntilItGoesOnOrAnotherJobIsOpen) {
    const OpenJobView desk = desk_in(OpenJobState::published);
    EXPECT_EQ(unfinished_piece(stopped_in(S::ready), desk), (UnfinishedPiece{131, 0, 200}));
    EXPECT_FALSE(unfinished_piece(stopped_in(S::carving), desk));
    EXPECT_FALSE(unfinished_piece(machine_in(S::ready), desk));
    EXPECT_FALSE(unfinished_piece(stopped_in(S::ready), desk_in(OpenJobState::model)));
    MachineView slipped = machine_in(S::ready);
    slipped.earlier_layer = 94;
    slipped.checkpoint_layer_count = 200;
    EXPECT_EQ(unfinished_piece(slipped, desk), (UnfinishedPiece{0, 94, 200}));
    EXPECT_EQ(in_english(unfinished_title({131, 0, 200})), "Unfinished: 131 of 200 layers are carved");
    EXPECT_EQ(in_english(unfinished_title({0, 94, 200})), "Begun anew: none of 200 layers is finished");
    EXPECT_EQ(in_english(anew_question({131, 0, 200})),
              "Layers 1 to 131 of 200 are carved and would be carved again.");
    EXPECT_EQ(in_english(anew_question({0, 94, 200})),
              "The run before came to layer 94 of 200: if its piece is still mounted, From layer 95 goes on "
              "with it, and layer 1 carves it again.");
    EXPECT_EQ(in_english(anew_question({1, 0, 200})), "Layer 1 of 200 is carved and would be carved again.");
}

TEST(GoingOnWords, ItsDetailsSayTheLastGoodPointTheWayAndWhatComesFirst) {
    const cam::PreparedJob job = some_layers();
    MachineView machine = machine_in(S::ready);
    machine.status->points_done = 12;
    machine.status->points_total = 20;
    machine.status->layer = 2;
    machine.status->point = 1;
    EXPECT_EQ(
        details({2, 0, 4}, machine, &job),
        (std::vector<std::string>{
            "Last good: layer 2, to its point 5.", "It ended in layer 3, point 2.",
            "Then: heads out, Ψ to 0.00°, Y to 3.00 mm, spindle on, heads in to R1 10.00, R2 20.00 mm."}));
    machine.status->points_done = 0;
    machine.status->homed_mask = 0x1;
    EXPECT_EQ(details({2, 0, 4}, machine),
              (std::vector<std::string>{"Last good layer: 2.", "First Home all: R2 Ψ Y are not homed."}));
    machine.status->homed_mask = test::kAllHomed;
    machine.status->state = S::off;
    EXPECT_EQ(details({2, 0, 4}, machine).back(), "First Home all: the drives are off.");
    machine.life = CoreLife::none;
    EXPECT_EQ(details({2, 3, 4}, machine),
              (std::vector<std::string>{"Last good layer: 2.", "First start psicarve-rtcore, then Home all.",
                                        "The run before came to layer 3: if its piece is still mounted, From "
                                        "layer 4 goes on with it."}));
}

TEST(GoingOnWords, ItsNeedsAreWhatComesFirstAndTheWayBack) {
    EXPECT_TRUE(unfinished_needs({2, 0, 4}, machine_in(S::ready)).empty());
    MachineView machine = machine_in(S::ready, 0x1);
    machine.status->points_done = 12;
    machine.status->points_total = 20;
    std::vector<std::string> said;
    for (const Phrase& each : unfinished_needs({2, 3, 4}, machine)) said.push_back(in_english(each));
    EXPECT_EQ(said, (std::vector<std::string>{"First Home all.", "Run before: to layer 3 (From layer 4)."}));
    machine.life = CoreLife::none;
    EXPECT_EQ(in_english(unfinished_needs({2, 0, 4}, machine).front()),
              "First start psicarve-rtcore, then Home all.");
}

TEST(GoingOnWords, ThePictureHasNoRadiusOfWhatIsOnlyRoughed) {
    const std::vector<JobPass> passes{
        {static_cast<std::uint32_t>(PassKind::roughing), 1, 0, 2, 0.3, 2.0, 30.0},
        {static_cast<std::uint32_t>(PassKind::finishing), 2, 2, 2, 0.0, 0.0, 30.0}};
    const cam::PreparedJob job = some_layers(4, 400, passes);
    ASSERT_EQ(job.view.finishing_layer(), 2U);
    for (const std::uint32_t carved : {0U, 1U, 2U, 3U, 4U}) {
        const CarvedPicture picture = carved_picture(job, carved, 0x123456);
        ASSERT_EQ(picture.rows, 2U);
        const std::size_t coloured = carved > 2 ? carved - 2 : 0;
        for (std::size_t row = 0; row < 2; ++row) {
            const bool is_rest = picture.rgb[row * picture.columns] == 0xFF123456;
            EXPECT_EQ(is_rest, row < 2 - coloured)
                << "row " << row << " from the top, " << carved << " carved";
        }
    }
}

TEST(GoingOnWords, ThePictureIsColouredAsFarAsItIsCarved) {
    const cam::PreparedJob job = some_layers();
    for (const std::uint32_t carved : {0U, 1U, 3U, 4U}) {
        const CarvedPicture picture = carved_picture(job, carved, 0x123456);
        ASSERT_EQ(picture.rows, 4U);
        ASSERT_EQ(picture.rgb.size(), picture.rows * picture.columns);
        for (std::size_t row = 0; row < 4; ++row) {
            const bool is_rest = picture.rgb[row * picture.columns] == 0xFF123456;
            EXPECT_EQ(is_rest, row < 4 - carved) << "row " << row << " from the top, " << carved << " carved";
        }
    }
    const CarvedPicture fine = carved_picture(some_layers(1000, 40), 1, 0x123456);
    ASSERT_LT(fine.rows, 500U);
    EXPECT_NE(fine.rgb.back(), 0xFF123456) << "a little is seen, too";
    EXPECT_EQ(fine.rgb[(fine.rows - 2) * fine.columns], 0xFF123456);
}

}  // namespace
}  // namespace psicarve::session
