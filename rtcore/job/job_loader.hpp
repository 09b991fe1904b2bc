// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "rtcore/job/loaded_job.hpp"
#include "rtcore/process/side_thread.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Copies a published job out of the segment and checks it, which takes half a second for a hundred
/// megabytes: in a thread of its own, so that no other request to the supervisor waits for it. One at a time.
/// The supervisor's thread calls all methods.
class JobLoader {
public:
    /// `has_thread` false: begin() does it all, as on the virtual clock, which stands still meanwhile.
    JobLoader(const Profile& profile, bool has_thread);

    /// The result of a look. Neither job nor reason: there was no job to take, or publishers were faster.
    struct Outcome {
        std::uint64_t generation = 0;
        bool is_published = false;  ///< false: no publisher wrote that generation, its word is damaged
        std::shared_ptr<const LoadedJob> job;
        Message refusal{};  ///< where there is no job
    };
    /// Requires that it is not busy. `generation`: of the published job as it was seen, for a report if it is
    /// damaged.
    void begin(std::shared_ptr<Segment> segment, std::uint64_t known_generation, std::uint64_t generation);
    /// From begin() until its outcome was taken.
    bool is_busy() const noexcept { return is_busy_; }
    /// Nothing until the look is done.
    std::optional<Outcome> take_outcome();

private:
    struct Exchange {
        Outcome outcome;  ///< written before has_outcome
        std::atomic<bool> has_outcome{false};
    };
    std::shared_ptr<const Profile> profile_;
    std::shared_ptr<Exchange> exchange_ = std::make_shared<Exchange>();
    bool is_busy_ = false;
    std::unique_ptr<rtcore::SideThread> thread_;  ///< null: there is none
};

}  // namespace psicarve::supervisor
