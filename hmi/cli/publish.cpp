// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kPublishText{
    "publish", "Put a job into the segment",
    "A core that serves the segment judges it at once; else the next one that starts will.",
    "psicarve publish figurine.job"};

struct PublishOptions {
    std::string path;
    ModelOptions model;
};

Result<int> publish(const CommonOptions& common, const PublishOptions& options) {
    const auto job = prepare_job(options.path, options.model, common);
    if (!job) return job.error();
    SegmentOptions segment;
    segment.name = common.segment;
    segment.group = common.group;
    auto link = machine::MachineLink::create_or_attach(segment);
    if (!link) return link.error();
    const auto generation = link->publish(job->blob);
    if (!generation) return generation.error();
    const bool has_core = link->core_pid().has_value();
    if (const std::string remark = in_words(link->job_remarks()); !remark.empty()) print_warning(remark);
    if (!has_core)
        print_note("no core serves segment " + common.segment + " yet; the next one will judge the job");
    if (common.json) {
        const Json object{{"generation", *generation},
                          {"accepted", has_core ? Json(true) : Json(nullptr)},
                          {"layers", job->view.layer_count()},
                          {"points", job->view.point_count()},
                          {"segment", common.segment}};
        std::printf("%s\n", object.dump().c_str());
    } else {
        std::printf("published: %u layers x %u points as generation %llu of %s%s\n", job->view.layer_count(),
                    job->view.point_count(), static_cast<unsigned long long>(*generation),
                    common.segment.c_str(), has_core ? ", accepted by the core" : "");
    }
    return kExitDone;
}

}  // namespace

void add_publish(CommandSet& commands) {
    const auto options = std::make_shared<PublishOptions>();
    Syntax syntax = commands.add(
        kPublishText, [options](const CommonOptions& common) { return publish(common, *options); });
    syntax.input("MODEL|JOB", options->path,
                 "A mesh, drawing, picture or table, as slice takes them, or a job or snapshot file");
    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
