// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/standard_streams.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/snapshot_taker.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kSnapshotSaveText{
    "save", "Job, status and flight recorder of the segment into a file",
    "Works with a living core, a dead one or none. The old file stays intact whatever happens.",
    "psicarve snapshot save before-repair.snap"};
constexpr std::chrono::milliseconds kLockLimit{5000};

Result<int> save(const CommonOptions& common, const std::string& path) {
    if (const auto good = check_standard_output(path, common.json); !good) return good.error();
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link) return link.error();
    const auto snapshot = machine::take_snapshot(*link, kLockLimit);
    if (!snapshot) return snapshot.error();
    if (is_standard_output(path)) {
        const auto written = write_snapshot(*snapshot, STDOUT_FILENO, "standard output");
        return written ? Result<int>{kExitDone} : written.error();
    }
    if (const auto saved = save_snapshot(*snapshot, path, common.group); !saved) return saved.error();
    if (common.json) {
        using SavedJson = nlohmann::ordered_json;
        const SavedJson object{{"file", path},
                               {"generation", snapshot->generation},
                               {"records", snapshot->records.size()},
                               {"job_bytes", snapshot->job_blob.size()}};
        std::printf("%s\n", object.dump(-1, ' ', false, SavedJson::error_handler_t::replace).c_str());
    } else {
        std::printf("%s: %s, %zu records of the flight recorder\n", path.c_str(),
                    snapshot->job_blob.empty() ? "no job" : "one job", snapshot->records.size());
    }
    return kExitDone;
}

}  // namespace

void add_snapshot_save(CommandSet& commands) {
    const auto path = std::make_shared<std::string>();
    commands.add(kSnapshotSaveText, [path](const CommonOptions& common) { return save(common, *path); })
        .argument("FILE", *path, "The snapshot file to write; - writes to standard output");
}

}  // namespace psicarve::cli
