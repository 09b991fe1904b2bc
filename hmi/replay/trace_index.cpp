// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/trace_index.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <system_error>
#include <utility>

#include "shared/trace/trace_format.hpp"

namespace psicarve::replay {
namespace {

using verify::BinaryReader;
using verify::ByteSource;
using verify::TraceEvent;

constexpr std::size_t kEventsAtOnce = 2048;

Error cannot_open(const std::string& path) {
    return bad_input(path + ": cannot open: " + std::generic_category().message(errno));
}

}  // namespace

Result<std::shared_ptr<const TraceIndex>> TraceIndex::build(const std::string& path, const Profile& profile,
                                                            const Progress& progress,
                                                            std::size_t most_keyframes) {
    const std::shared_ptr<TraceIndex> index{new TraceIndex};
    index->path_ = path;
    index->file_ = machine::UniqueFd{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (index->file_.get() < 0) return cannot_open(path);
    struct stat facts {};
    if (::fstat(index->file_.get(), &facts) != 0) return cannot_open(path);
    if (!S_ISREG(facts.st_mode)) return bad_input(path + ": not a file, and only files can be replayed");
    index->bytes_ = static_cast<std::uint64_t>(facts.st_size);
    const int own = ::fcntl(index->file_.get(), F_DUPFD_CLOEXEC, 0);
    if (own < 0) return cannot_open(path);
    auto reader = BinaryReader::open_binary(ByteSource{own, path});
    if (!reader) return reader.error();
    index->start_ = (*reader)->start();
    if (const auto read = index->read_all(**reader, profile, progress, most_keyframes); !read)
        return read.error();
    return std::shared_ptr<const TraceIndex>{index};
}

Result<void> TraceIndex::read_all(BinaryReader& reader, const Profile& profile, const Progress& progress,
                                  std::size_t most_keyframes) {
    PinFollower follower{start_, profile};
    keyframes_.push_back({reader.place(), follower});
    std::vector<TraceEvent> events(kEventsAtOnce);
    while (true) {
        const auto count = reader.read(events);
        jobs_begun_ = reader.jobs_begun();
        if (!count) {
            if (events_ == 0) return count.error();
            damage_ = count.error().message;
            return {};
        }
        if (*count == 0) return {};
        for (const TraceEvent& event : std::span{events}.first(*count)) {
            note_change(follower.moment(), event);
            follower.take(event);
        }
        events_ += *count;
        end_ns_ = follower.moment().time_ns;
        const BinaryReader::Place place = reader.place();
        if (place.offset < keyframes_.back().place.offset + stride_bytes_) continue;
        keep(place, follower, most_keyframes);
        if (progress && !progress(static_cast<double>(place.offset) / static_cast<double>(bytes_)))
            return Error{ErrorCode::cancelled, path_ + ": opening was cancelled"};
    }
}

void TraceIndex::keep(const BinaryReader::Place& place, const PinFollower& follower, std::size_t most) {
    keyframes_.push_back({place, follower});
    if (keyframes_.size() < most) return;
    // Every second one goes, and from here on they stand twice as far apart. The first stays.
    std::size_t kept = 1;
    for (std::size_t i = 2; i < keyframes_.size(); i += 2) keyframes_[kept++] = keyframes_[i];
    keyframes_.erase(keyframes_.begin() + static_cast<std::ptrdiff_t>(kept), keyframes_.end());
    stride_bytes_ *= 2;
}

void TraceIndex::note_change(const PinMoment& before, const TraceEvent& event) {
    constexpr SignalWord kQuiet = kStepMask | kDirMask | bit_of(Signal::psi_index);
    const bool is_definition = event.kind == TraceEvent::Kind::position;
    const bool is_change = ((before.levels ^ event.levels) & ~kQuiet) != 0;
    if (!is_definition && !is_change) return;
    if (changes_.size() < kMostChanges)
        changes_.push_back({event.time_ns, before.levels, event.levels, is_definition});
}

const TraceIndex::Keyframe& TraceIndex::keyframe_at(std::int64_t time_ns) const noexcept {
    // Events of the keyframe's own instant may still follow it, none of an earlier one.
    const auto behind = std::upper_bound(
        keyframes_.begin() + 1, keyframes_.end(), time_ns,
        [](std::int64_t wanted_ns, const Keyframe& frame) { return wanted_ns < frame.place.time_ns; });
    return *(behind - 1);
}

Result<std::unique_ptr<BinaryReader>> TraceIndex::read_from(const Keyframe& keyframe) const {
    // Opened anew: a duplicate would share its place with other threads' readers.
    const std::string same = "/proc/self/fd/" + std::to_string(file_.get());
    machine::UniqueFd file{::open(same.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.get() < 0) return cannot_open(path_);
    const auto offset = static_cast<off_t>(keyframe.place.offset);
    if (::lseek(file.get(), offset, SEEK_SET) != offset) return cannot_open(path_);
    return BinaryReader::resume(ByteSource{file.release(), path_, keyframe.place.offset}, start_,
                                keyframe.place);
}

}  // namespace psicarve::replay
