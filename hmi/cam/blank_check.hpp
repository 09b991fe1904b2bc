// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "hmi/cam/slice_report.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The largest radius of a model in each direction, over all layers. Layers may come from several threads.
class OutermostRadii {
public:
    void note(std::span<const double> once_round);
    std::span<const double> radii() const noexcept { return most_; }

private:
    std::mutex mutex_;
    std::vector<double> most_;
};

/// First layer of a table's finishing pass; these warnings are about that pass alone.
std::size_t finishing_layer(const JobTable& table) noexcept;

/// Keeps all tips of the tables above the profile's depth limit below the blank's surface, counts what stays
/// uncut, and warns of it.
void hold_depth_limit(const Profile& profile, JobTable& table, SliceReport& report);

/// Warns of a blank that does not hold the model, or that the heads cannot clear. `directions_rad` and
/// `model_mm` belong together; `top_mm` is the model's top above the table.
void warn_about_blank_size(const Profile& profile, std::span<const double> directions_rad,
                           std::span<const double> model_mm, double top_mm, SliceReport& report);
/// The same, and of a blank that is deeper than the tool cuts.
void warn_about_blank(const Profile& profile, std::span<const double> directions_rad,
                      std::span<const double> model_mm, double top_mm, SliceReport& report);
/// The same where only the tips of a table are known of a model.
void warn_about_blank(const Profile& profile, const JobTable& table, SliceReport& report);

/// Notes how far the tool of the lower head reaches below the top of the table on which the blank stands.
void note_what_meets_the_table(const Profile& profile, const JobTable& table, SliceReport& report);

/// Warns of an R2 that stands so much lower than R1 that its first layers pass under the model: there the
/// table has the core radius, or what the depth limit leaves. For a table made of a model, whose base is
/// known.
void warn_about_foot(const Profile& profile, const JobTable& table, SliceReport& report);

/// The greatest distance between the finishing pass' layers.
double layer_pitch_mm(const Profile& profile, const JobTable& table);
/// The greatest distance between two rows of the same direction: except in zigzag the heads alternate there,
/// and R2 stands higher or lower by its height error.
double row_gap_mm(const Profile& profile, const JobTable& table);
/// Warns of rows further from each other than the tool is wide. Points need no such warning, since between
/// them the tool cuts as it goes, except where R2's height error makes the rows uneven.
void warn_about_layers(const Profile& profile, const JobTable& table, SliceReport& report);

}  // namespace psicarve::cam
