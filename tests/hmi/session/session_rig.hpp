// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "hmi/session/machine_session.hpp"
#include "hmi/session/open_job.hpp"
#include "tests/places.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::session::test {

/// What a window does between its frames.
class SessionRig : public two_process::CoreRig {
protected:
    void open_session() {
        session_ = std::make_unique<MachineSession>(SessionOptions{segment_name_, {}, {}}, log_);
        desk_ = std::make_unique<OpenJob>(segment_name_, std::string{}, log_);
    }
    template <typename Condition>
    bool comes_true(Condition condition) {
        return eventually([&] {
            session_->poll();
            desk_->poll(session_->view());
            return condition();
        });
    }
    ::testing::AssertionResult comes_to(MachineState state) {
        if (comes_true([&] { return session_->view().state() == state; }))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure()
               << "state is " << name_of(session_->view().state()) << all_messages();
    }
    std::string all_messages() const {
        std::string text;
        for (const Message& message : log_.messages()) text += "\n  " + in_english(message.what);
        return text;
    }
    void open_and_publish(const JobTable& table) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file("long.job")));
        desk_->open(file("long.job"));
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::job; })) << all_messages();
        desk_->publish();
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }))
            << all_messages();
    }
    void slice_to(std::uint32_t layers) {
        cam::JobOptions options;
        options.layer_count = layers;
        options.point_count = 40;
        desk_->slice(options, Profile{});
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::job; })) << all_messages();
    }
    void slice_and_publish(std::uint32_t layers) {
        ASSERT_NO_FATAL_FAILURE(slice_to(layers));
        desk_->publish();
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }))
            << all_messages();
    }
    void home_session() {
        session_->order(CommandKind::home, phrase("Home"));
        ASSERT_TRUE(comes_to(MachineState::ready));
    }

    MessageLog log_;
    std::unique_ptr<MachineSession> session_;
    std::unique_ptr<OpenJob> desk_;
};

}  // namespace psicarve::session::test
