// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/remedy.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/cam/job_plan.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/message/message.hpp"

namespace psicarve::session {
namespace {

using Kind = Remedy::Kind;

/// The field has two decimals; for a suggestion one is enough.
constexpr double kHeightSteps_per_mm = 10.0;

bool says(const Error& error, std::string_view words) {
    return error.message.find(words) != std::string::npos;
}

/// The number that follows an option of the command line in the words of a refusal.
std::optional<double> number_behind(const Error& error, std::string_view option) {
    const auto at = error.message.find(option);
    if (at == std::string::npos) return std::nullopt;
    const char* const first = error.message.data() + at + option.size();
    double value = 0.0;
    const auto read = std::from_chars(first, error.message.data() + error.message.size(), value);
    return read.ec == std::errc{} && value > 0.0 ? std::optional{value} : std::nullopt;
}

/// The largest height that travel and blank allow, rounded down.
std::optional<Remedy> fitting_height(const model::Mesh& mesh, const Profile& profile,
                                     cam::JobOptions options) {
    options.height_mm.reset();
    options.scale.reset();
    options.diameter_mm.reset();
    options.fits = true;
    cam::SliceReport report;
    const auto plan = cam::plan_job(mesh, profile, options, report);
    if (!plan) return std::nullopt;
    const double units =
        slice::placed(options.up, mesh.facts.max)[2] - slice::placed(options.up, mesh.facts.min)[2];
    const double height_mm = std::floor(plan->scale * units * kHeightSteps_per_mm) / kHeightSteps_per_mm;
    return height_mm > 0.0 ? std::optional{Remedy{Kind::height, height_mm}} : std::nullopt;
}

}  // namespace

Phrase remedy_text(const Remedy& remedy) {
    switch (remedy.kind) {
        case Kind::height:
            return phrase("Height %1 mm", number_text(remedy.value, 1));
        case Kind::scale:
            return phrase("Scale %1", number_text(remedy.value, remedy.value < 100.0 ? 1 : 0));
        case Kind::layers:
            return phrase("%1 layers", number_text(remedy.value, 0));
        case Kind::best_axis:
            return phrase("Axis: least lost");
        case Kind::core_profile:
            break;
    }
    return phrase("Use the core's profile");
}

std::vector<Remedy> slicing_remedies(const Error& error, const model::Mesh& mesh, const Profile& profile,
                                     const cam::JobOptions& options) {
    std::vector<Remedy> found;
    if (says(error, "larger than the machine's travel")) {
        if (const auto height = fitting_height(mesh, profile, options)) found.push_back(*height);
    }
    const bool has_own_size = options.height_mm || options.scale || options.diameter_mm || options.fits;
    if (const auto scale = number_behind(error, "(--scale "); scale && !has_own_size)
        found.push_back({Kind::scale, *scale});
    // One less: with as many layers as pulses two may get the same one.
    if (const auto layers = number_behind(error, "at most --layers "); layers && *layers > 1.0)
        found.push_back({Kind::layers, *layers - 1.0});
    if (says(error, "--axis-at moves the axis") && options.axis_at != cam::AxisAt::best)
        found.push_back({Kind::best_axis});
    return found;
}

std::vector<Remedy> publishing_remedies(const Error& error) {
    if (error.said.id != MessageId::job_for_other_machine) return {};
    return {{Kind::core_profile}};
}

}  // namespace psicarve::session
