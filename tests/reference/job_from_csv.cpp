// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a job file of a table as `psicarve snapshot export --format csv` prints it, whole or some layers of
// it.
//
//   job_from_csv TABLE.csv PROFILE.toml OUT.job [FIRST-LAST]

#include <cstdio>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/reference/table_csv.hpp"

namespace {

using namespace psicarve;

Result<LayerRange> parse_range(const std::string& text) {
    LayerRange range;
    if (std::sscanf(text.c_str(), "%u-%u", &range.first, &range.last) != 2 || range.last < range.first) {
        return bad_input(text + ": a range of layers looks like 3-5");
    }
    return range;
}

Result<void> convert(const std::vector<std::string>& words) {
    const auto range = words.size() > 3 ? parse_range(words[3]) : Result<LayerRange>(LayerRange{});
    if (!range) return range.error();
    const auto profile = load_profile(words[1]);
    if (!profile) return profile.error();
    const auto table = table_from_csv(words[0], *profile, *range);
    if (!table) return table.error();
    Snapshot file;
    file.job_blob = job_blob_from_table(*table);
    const auto view = JobView::check(file.job_blob);
    if (!view) return view.error();
    if (const auto fits = check_job(*view, *profile); !fits) return fits;
    return save_snapshot(file, words[2]);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 3 || words.size() > 4) {
        std::fprintf(stderr, "usage: %s TABLE.csv PROFILE.toml OUT.job [FIRST-LAST]\n", argv[0]);
        return 2;
    }
    const auto done = convert(words);
    if (!done) std::fprintf(stderr, "job_from_csv: %s\n", done.error().message.c_str());
    return done ? 0 : 3;
}
