// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hmi/machine/unique_fd.hpp"
#include "hmi/replay/pin_follower.hpp"
#include "hmi/trace/binary_reader.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::replay {

/// Called with the share that is done, 0 to 1; returns false to give up.
using Progress = std::function<bool(double)>;

/// Maps times of a binary trace to places in the file, with the state of the pins there: so any instant needs
/// only a short read. Its memory does not grow with the trace, only its keyframes move apart.
class TraceIndex {
public:
    struct Keyframe {
        verify::BinaryReader::Place place;
        PinFollower follower;
    };
    /// A change of the pins other than a step.
    struct PinChange {
        std::int64_t time_ns;
        SignalWord before;
        SignalWord after;
        bool is_definition;  ///< homing defined the positions anew; the pins stayed
    };

    static constexpr std::uint64_t kLeastStride_bytes = std::uint64_t{32} * 1024;
    static constexpr std::size_t kMostKeyframes = 16384;
    static constexpr std::size_t kMostChanges = 20'000;

    /// Reads the file once. One that was cut off or damaged on its way is used up to there: damage() says so.
    /// "FILE: what is wrong" when nothing of it can be shown.
    static Result<std::shared_ptr<const TraceIndex>> build(const std::string& path, const Profile& profile,
                                                           const Progress& progress,
                                                           std::size_t most_keyframes = kMostKeyframes);

    const std::string& path() const noexcept { return path_; }
    const verify::TraceStart& start() const noexcept { return start_; }
    std::int64_t end_ns() const noexcept { return end_ns_; }
    std::uint64_t events() const noexcept { return events_; }
    std::size_t jobs_begun() const noexcept { return jobs_begun_; }  ///< jobs that the trace carries
    const std::string& damage() const noexcept { return damage_; }   ///< empty: the trace is whole
    const std::vector<Keyframe>& keyframes() const noexcept { return keyframes_; }
    /// The last keyframe that is not after the time.
    const Keyframe& keyframe_at(std::int64_t time_ns) const noexcept;
    /// In order; the first kMostChanges.
    const std::vector<PinChange>& changes() const noexcept { return changes_; }
    /// A new reader that starts at the keyframe. Any thread.
    Result<std::unique_ptr<verify::BinaryReader>> read_from(const Keyframe& keyframe) const;

private:
    TraceIndex() = default;
    Result<void> read_all(verify::BinaryReader& reader, const Profile& profile, const Progress& progress,
                          std::size_t most_keyframes);
    void note_change(const PinMoment& before, const verify::TraceEvent& event);
    void keep(const verify::BinaryReader::Place& place, const PinFollower& follower, std::size_t most);

    std::string path_;
    machine::UniqueFd file_;  ///< the file that was indexed, whatever becomes of its name
    verify::TraceStart start_;
    std::int64_t end_ns_ = 0;
    std::uint64_t events_ = 0;
    std::uint64_t bytes_ = 0;
    std::size_t jobs_begun_ = 0;
    std::uint64_t stride_bytes_ = kLeastStride_bytes;
    std::string damage_;
    std::vector<Keyframe> keyframes_;
    std::vector<PinChange> changes_;
};

}  // namespace psicarve::replay
