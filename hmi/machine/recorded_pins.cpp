// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/recorded_pins.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <random>
#include <span>
#include <utility>

#include "shared/machine/jog_lease.hpp"
#include "shared/trace/trace_format.hpp"

namespace psicarve::machine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPinsPoll{1};
/// The lease is renewed in between.
constexpr int kMostAtOnce = 256;
constexpr int kRenewalPause_ms = 100;
/// Of a job, between two renewals.
constexpr std::size_t kJobPieceBytes = std::size_t{1} << 20;
/// How long to read the pieces that the core has put into the ring by the end of the recording.
constexpr std::chrono::milliseconds kEndLimit{5000};

std::uint32_t any_token() {
    std::random_device random;
    const std::uint32_t token = random();
    return token != 0 ? token : 1;
}

/// Calls `wait` repeatedly while the verifier has no room for more.
template <typename Wait>
void write_all(int fd, std::span<const std::uint8_t> bytes, Wait&& wait) {
    while (!bytes.empty()) {
        // Once there is room it is for more than a piece: that is less than PIPE_BUF.
        pollfd room{fd, POLLOUT, 0};
        if (poll(&room, 1, kRenewalPause_ms) == 0) {
            wait();
            continue;
        }
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return;  // the verifier says that its trace was cut off
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
}

}  // namespace

RecordedPins::RecordedPins(MachineLink& link) noexcept
    : link_(&link), token_(any_token()), pieces_(link.segment().header().recording, true) {}

Result<std::unique_ptr<RecordedPins>> RecordedPins::start(MachineLink& link, const JobView& job,
                                                          const Profile& profile,
                                                          const std::string& trace_path,
                                                          verify::Verifier::Follower follower,
                                                          FileJob file_job) {
    std::unique_ptr<RecordedPins> made{new RecordedPins{link}};
    auto pipe = open_pipe();
    if (!pipe) return pipe.error();
    auto verification = PipeVerification::start(job, profile, std::move(pipe->read_end), std::move(follower));
    if (!verification) return verification.error();
    made->verification_ = std::move(verification).value();
    made->pipe_ = std::move(pipe->write_end);
    if (file_job == FileJob::carried && !trace_path.ends_with(".vcd")) {
        made->job_blob_ = {reinterpret_cast<const std::byte*>(&job.header()), job.header().total_bytes};
    }
    if (const auto begun = made->begin(trace_path); !begun) return begun.error();
    made->thread_ = std::thread{[self = made.get()] { self->read_pieces(); }};
    return made;
}

Result<std::unique_ptr<RecordedPins>> RecordedPins::start_file(MachineLink& link,
                                                               const std::string& trace_path) {
    std::unique_ptr<RecordedPins> made{new RecordedPins{link}};
    if (const auto begun = made->begin(trace_path); !begun) return begun.error();
    made->thread_ = std::thread{[self = made.get()] { self->read_pieces(); }};
    return made;
}

/// The core comes first: an existing file in the trace's place stays as it is when the core refuses.
Result<void> RecordedPins::begin(const std::string& trace_path) {
    renew();
    const bool is_vcd = trace_path.ends_with(".vcd");
    if (const auto asked = ask(is_vcd ? RecordingForm::vcd : RecordingForm::binary); !asked) return asked;
    if (trace_path.empty()) return {};
    auto opened = TraceOutput::open(trace_path);
    if (!opened) {
        (void)ask(RecordingForm::none);
        return opened.error();
    }
    file_.emplace(std::move(opened).value());
    return {};
}

RecordedPins::~RecordedPins() {
    phase_.store(Phase::given_up);
    if (thread_.joinable()) thread_.join();
    pipe_.reset();  // before waiting for the verifier
    if (file_ && !is_whole_) file_->discard();
}

Result<void> RecordedPins::ask(RecordingForm form) {
    Command command{};
    command.kind = CommandKind::record;
    command.value = static_cast<double>(form);
    command.lease_token = token_;
    return link_->send(command);
}

void RecordedPins::end() {
    phase_.store(ask(RecordingForm::none) ? Phase::ending : Phase::given_up);
    if (thread_.joinable()) thread_.join();
}

/// Pieces were lost.
Error RecordedPins::keep_failure() {
    const Error lost{ErrorCode::machine_refused,
                     pieces_.lost() > 0
                         ? "the pins came faster than this computer could take them from the core"
                         : "the core's recording of its pins ended early"};
    if (file_) {
        file_->discard();
        trace_failure_ = Error{lost.code, "there is no whole trace, and so none: " + lost.message};
    }
    return lost;
}

Result<verify::VerifyReport> RecordedPins::finish() {
    end();
    auto report = verification_->finish();
    if (!is_whole_) return keep_failure();
    if (file_) file_->flush();
    if (file_) trace_failure_ = file_->take_error();
    return report;
}

Result<void> RecordedPins::finish_file() {
    end();
    if (!is_whole_) (void)keep_failure();
    if (is_whole_) file_->flush();
    if (is_whole_) trace_failure_ = file_->take_error();
    if (trace_failure_) return *trace_failure_;
    return {};
}

void RecordedPins::renew() noexcept {
    SegmentHeader& shared = link_->segment().header();
    shared.recording_taken.store(pieces_.position(), std::memory_order_release);
    shared.recording_lease.store(jog_lease_word(token_, ++beat_), std::memory_order_release);
}

void RecordedPins::read_pieces() {
    auto last_piece = Clock::now();
    while (!is_whole_ && pieces_.lost() == 0) {
        const int taken = take_pieces();
        renew();
        if (taken > 0) last_piece = Clock::now();
        if (taken == kMostAtOnce) continue;
        const Phase phase = phase_.load();
        const bool is_silent = Clock::now() - last_piece > kEndLimit;
        if (taken == 0 && (phase == Phase::given_up || (phase == Phase::ending && is_silent))) break;
        std::this_thread::sleep_for(kPinsPoll);
    }
    pipe_.reset();  // the verifier reads to the end of the pieces
}

/// Returns how many there were.
int RecordedPins::take_pieces() {
    for (int n = 0; n < kMostAtOnce; ++n) {
        const auto piece = pieces_.next();
        if (!piece || is_whole_ || pieces_.lost() > 0) return n;
        if (piece->token == token_) hand_on(*piece);
    }
    return kMostAtOnce;
}

void RecordedPins::hand_on(const RecordingPiece& piece) {
    if (piece.bytes == 0) {
        is_whole_ = true;
        return;
    }
    const std::size_t count = std::min<std::size_t>(piece.bytes, sizeof piece.data);
    if (verification_) write_all(pipe_.get(), {piece.data, count}, [this] { renew(); });
    if (file_) write_file({piece.data, count});
}

/// The core does not send the job, which we have: it would have to go through the segment, piece by piece.
void RecordedPins::write_file(std::span<const std::uint8_t> bytes) {
    const auto write = [this](std::span<const std::uint8_t> some) {
        file_->write({reinterpret_cast<const char*>(some.data()), some.size()});
    };
    // The head is less than a piece.
    if (!job_blob_.empty() && bytes.size() >= sizeof(TraceHeader)) {
        std::uint32_t version = 0;
        std::memcpy(&version, bytes.data() + offsetof(TraceHeader, version), sizeof version);
        const std::size_t head_bytes = std::min(trace_head_bytes(version), bytes.size());
        write(bytes.first(head_bytes));
        bytes = bytes.subspan(head_bytes);
        std::array<std::uint8_t, kTraceRecordMaxBytes> head{};
        const std::uint8_t* const end =
            encode_trace_job_head(head.data(), job_blob_.size(), job_checksum(job_blob_));
        write({head.data(), end});
        for (; !job_blob_.empty(); renew()) {
            const auto piece = job_blob_.first(std::min(job_blob_.size(), kJobPieceBytes));
            file_->write({reinterpret_cast<const char*>(piece.data()), piece.size()});
            job_blob_ = job_blob_.subspan(piece.size());
        }
    }
    write(bytes);
}

}  // namespace psicarve::machine
