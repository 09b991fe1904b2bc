// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/saved_piece_watch.hpp"

#include <utility>

#include "hmi/session/saved_piece.hpp"

namespace psicarve::session {
namespace {

constexpr std::chrono::milliseconds kDiskPause{1000};

}  // namespace

SavedPieceWatch::SavedPieceWatch(std::string segment_name, std::string group, std::string state_folder)
    : segment_name_(std::move(segment_name)),
      group_(std::move(group)),
      state_folder_(std::move(state_folder)) {}

void SavedPieceWatch::poll(const CoreKeeping& core, MachineView& view, Clock::time_point now) {
    auto found = search_.take();
    const bool is_wanted = may_be_saved(view) || view.is_checkpoint_from_disk;
    if (!is_wanted) {
        looked_ = {};  // the next request asks at once
        return view.saved_piece.reset();
    }
    const bool has_status = view.is_heard() && view.status;
    const auto kind = has_status ? std::optional{view.is_simulator()} : std::nullopt;
    if (std::exchange(kind_, kind) != kind) looked_ = {};
    if (found) view.saved_piece = std::move(*found);
    const auto& shown = view.saved_piece;
    if (shown && kind && shown->saved.name().is_simulator != *kind) view.saved_piece.reset();
    if (search_.is_under_way() || now - looked_ < kDiskPause) return;
    looked_ = now;
    search_.begin([name = segment_name_, kind, folder = state_folder_, core] {
        return find_unfinished(name, kind, folder, core);
    });
}

bool SavedPieceWatch::forget(const RecordName& record) {
    if (forgetting_.is_under_way()) return false;
    forgetting_.begin([name = segment_name_, group = group_, folder = state_folder_, record] {
        return machine::forget_piece(name, group, folder, record);
    });
    return true;
}

std::optional<Result<machine::ForgottenPiece>> SavedPieceWatch::take_forgotten() {
    auto done = forgetting_.take();
    if (done) looked_ = {};  // what is known of it is past
    return done;
}

}  // namespace psicarve::session
