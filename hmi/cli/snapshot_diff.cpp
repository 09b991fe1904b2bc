// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/report/snapshot_differences.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kSnapshotDiffText{"diff", "What differs between two snapshots or jobs",
                                        "Exit code 0 when nothing does, 6 when something does.",
                                        "psicarve snapshot diff before.snap after.snap"};
constexpr std::size_t kLongestValue = 120;

struct SnapshotDiffOptions {
    std::string a;
    std::string b;
};

std::string shortened(const std::string& text) {
    return text.size() <= kLongestValue ? text : text.substr(0, kLongestValue) + "...";
}

void print_json(const std::vector<report::Difference>& found) {
    auto list = Json::array();
    for (const report::Difference& one : found)
        list.push_back({{"what", one.what}, {"a", one.a}, {"b", one.b}});
    const Json object{{"same", found.empty()}, {"differences", list}};
    std::printf("%s\n", object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
}

Result<int> diff(const CommonOptions& common, const SnapshotDiffOptions& options) {
    const auto a = load_snapshot(options.a);
    if (!a) return a.error();
    const auto b = load_snapshot(options.b);
    if (!b) return b.error();
    const std::vector<report::Difference> found = report::differences_between(*a, *b);
    if (common.json) {
        print_json(found);
    } else {
        for (const report::Difference& one : found) {
            std::printf("%s: %s | %s\n", one.what.c_str(), shortened(one.a).c_str(),
                        shortened(one.b).c_str());
        }
        if (found.empty()) std::printf("no difference\n");
    }
    return found.empty() ? kExitDone : kExitDifference;
}

}  // namespace

void add_snapshot_diff(CommandSet& commands) {
    const auto options = std::make_shared<SnapshotDiffOptions>();
    commands.add(kSnapshotDiffText, [options](const CommonOptions& common) { return diff(common, *options); })
        .input("JOB_A", options->a, "A snapshot or job file")
        .input("JOB_B", options->b, "Another");
}

}  // namespace psicarve::cli
