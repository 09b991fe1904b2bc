// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/side_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <stdexcept>
#include <vector>

namespace psicarve::rtcore {
namespace {

TEST(SideThread, DoesAllInOrderBeforeItsEnd) {
    auto done = std::make_shared<std::vector<int>>();
    {
        SideThread sut;
        for (int i = 0; i < 100; ++i) {
            EXPECT_TRUE(sut.do_later([done, i] { done->push_back(i); }));
        }
    }
    ASSERT_EQ(done->size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ((*done)[static_cast<std::size_t>(i)], i);
}

TEST(SideThread, RefusesWhatIsTooMuchAndWaitsForNoTaskThatHangs) {
    auto may_go_on = std::make_shared<std::promise<void>>();
    auto begun = std::make_shared<std::promise<void>>();
    auto ended = std::make_shared<std::promise<void>>();
    auto others = std::make_shared<std::atomic<int>>(0);
    {
        SideThread sut{SideThread::Priority::low, 3};
        ASSERT_TRUE(sut.do_later([=] {
            begun->set_value();
            may_go_on->get_future().wait();
        }));
        begun->get_future().wait();
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(sut.do_later([=] { ++*others; }));
        EXPECT_TRUE(sut.do_later([=] { ended->set_value(); }));
        EXPECT_FALSE(sut.do_later([=] { ++*others; }));
    }
    EXPECT_EQ(others->load(), 0);
    // What it left behind uses nothing that is gone.
    may_go_on->set_value();
    ended->get_future().wait();
    EXPECT_EQ(others->load(), 2);
}

TEST(SideThread, ATaskThatThrowsIsSaidAndEndsNothing) {
    std::atomic<bool> is_done{false};
    testing::internal::CaptureStderr();
    {
        SideThread sut;
        sut.do_later([] { throw std::runtime_error{"the disk burns"}; });
        sut.do_later([] { throw 4; });
        sut.do_later([&] { is_done.store(true); });
    }
    EXPECT_TRUE(is_done.load());
    EXPECT_NE(testing::internal::GetCapturedStderr().find("the disk burns"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::rtcore
