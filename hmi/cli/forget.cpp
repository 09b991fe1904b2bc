// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/machine/forget_piece.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kForgetText{
    "forget", "Nobody goes on with the unfinished piece",
    "How far it is carved goes from the segment and from the disk, and the copy of its job from the disk.\n"
    "The next start begins with the first layer. Nothing moves; refused while a job runs.",
    "psicarve forget"};

std::string forgotten_text(const machine::ForgottenPiece& piece) {
    const std::string progress = std::to_string(piece.checkpoint.next_layer) + " of " +
                                 std::to_string(piece.checkpoint.layer_count) + " layers";
    if (piece.path.empty()) return "forget: " + progress + ", known to the segment alone, are forgotten\n";
    return "forget: " + progress + " of " + piece.source_name + ", kept in " + piece.path +
           ", are forgotten\n";
}

std::string forgotten_json(const machine::ForgottenPiece& piece) {
    nlohmann::ordered_json object{{"command", "forget"},
                                  {"next_layer", piece.checkpoint.next_layer},
                                  {"layer_count", piece.checkpoint.layer_count}};
    if (!piece.path.empty()) {
        object["source"] = piece.source_name;
        object["kept_in"] = piece.path;
    }
    return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_forget(CommandSet& commands) {
    const auto folder = std::make_shared<std::string>();
    commands
        .add(kForgetText,
             [folder](const CommonOptions& common) -> Result<int> {
                 const auto done = machine::forget_piece(common.segment, common.group, *folder);
                 if (!done) return done.error();
                 std::fputs((common.json ? forgotten_json(*done) : forgotten_text(*done)).c_str(), stdout);
                 return kExitDone;
             })
        .option("--state", *folder, "FOLDER", "Where the core keeps it, if it was given --state");
}

}  // namespace psicarve::cli
