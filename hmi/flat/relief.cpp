// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/relief.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/decimals.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

// A job of 1000 layers and 2000 directions has no more places; finer pictures are averaged, never subsampled.
constexpr std::size_t kMostSamples = 2'000'000;
constexpr double kLeastRadius_mm = 0.05;
constexpr double kSeamToTell_mm = 0.05;
// 8 bits over a large depth are coarse: a few greys are no step.
constexpr double kSeamToTellOfDepth = 0.02;
constexpr double kSeamToTellRatio = 1.5;
constexpr double kUsualShare = 0.95;
constexpr double kHighRowsShare = 0.25;
constexpr double kWallOfDepth = 0.25;
constexpr std::size_t kBlendShareOfWidth = 20;
constexpr double kKernelSigmas = 3.0;
constexpr std::ptrdiff_t kWidestKernel = 1000;

/// Brightness from 0 to 1, `step` x `step` pixels averaged to one.
DepthMap averaged(const GreyImage& image) {
    std::size_t step = 1;
    while ((image.width / step) * (image.height / step) > kMostSamples) ++step;
    DepthMap map;
    map.width = std::max<std::size_t>(image.width / step, 1);
    map.height = std::max<std::size_t>(image.height / step, 1);
    map.depth_mm.resize(map.width * map.height);
    // Cells of nearly equal size that use every pixel once.
    for (std::size_t y = 0; y < map.height; ++y) {
        const std::size_t y0 = y * image.height / map.height, y1 = (y + 1) * image.height / map.height;
        for (std::size_t x = 0; x < map.width; ++x) {
            const std::size_t x0 = x * image.width / map.width, x1 = (x + 1) * image.width / map.width;
            std::uint64_t sum = 0;
            for (std::size_t v = y0; v < y1; ++v) {
                for (std::size_t u = x0; u < x1; ++u) sum += image.values[v * image.width + u];
            }
            const auto count = static_cast<double>((y1 - y0) * (x1 - x0));
            map.at(x, y) = static_cast<float>(static_cast<double>(sum) / count / 65535.0);
        }
    }
    map.warnings = image.warnings;
    if (step > 1) {
        map.warnings.push_back("the picture's " + std::to_string(image.width) + " x " +
                               std::to_string(image.height) + " pixels are averaged to " +
                               std::to_string(map.width) + " x " + std::to_string(map.height));
    }
    return map;
}

Result<void> set_size(DepthMap& map, double aspect, const FlatOptions& options, const std::string& file) {
    map.radius_mm = 0.5 * options.diameter_mm.value_or(kUsualDiameter_mm);
    const double turn_mm = 2.0 * kPi * map.radius_mm;
    map.height_mm = options.height_mm.value_or(turn_mm / aspect);
    map.share_of_turn = 1.0;
    if (!options.height_mm || options.is_full_turn) return {};
    map.share_of_turn = map.height_mm * aspect / turn_mm;
    if (map.share_of_turn > 1.0 + 1e-9) {
        return bad_input(file + ": a picture " + decimals(map.height_mm, 2) + " mm high would be " +
                         decimals(map.height_mm * aspect, 2) + " mm wide, and once round are only " +
                         decimals(turn_mm, 2) + " mm: at most --height " + decimals(turn_mm / aspect, 2) +
                         ", a larger --diameter, or --full-turn to change its shape");
    }
    // A picture that nearly closes counts as a full turn: no slot of a few micrometres.
    if (map.share_of_turn > 1.0 - 0.5 / static_cast<double>(map.width)) map.share_of_turn = 1.0;
    return {};
}

/// Once along a line of samples that stand `stride` apart.
void smooth_line(float* line, std::size_t count, std::size_t stride, const std::vector<double>& kernel,
                 bool is_ring, std::vector<float>& before) {
    before.resize(count);
    for (std::size_t i = 0; i < count; ++i) before[i] = line[i * stride];
    const auto n = static_cast<std::ptrdiff_t>(count);
    const auto reach = static_cast<std::ptrdiff_t>(kernel.size()) - 1;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        double sum = kernel[0] * static_cast<double>(before[static_cast<std::size_t>(i)]);
        for (std::ptrdiff_t k = 1; k <= reach; ++k) {
            std::ptrdiff_t a = i - k, b = i + k;
            if (is_ring) {
                a = ((a % n) + n) % n;
                b %= n;
            } else {
                a = std::max<std::ptrdiff_t>(a, 0);
                b = std::min(b, n - 1);
            }
            sum += kernel[static_cast<std::size_t>(k)] *
                   (static_cast<double>(before[static_cast<std::size_t>(a)]) +
                    static_cast<double>(before[static_cast<std::size_t>(b)]));
        }
        line[static_cast<std::size_t>(i) * stride] = static_cast<float>(sum);
    }
}

/// Half of a Gaussian, its weights' sum over both sides 1.
std::vector<double> kernel_of(double sigma_samples) {
    const auto reach =
        std::min<std::ptrdiff_t>(std::lround(std::ceil(kKernelSigmas * sigma_samples)), kWidestKernel);
    std::vector<double> kernel;
    double sum = 0.0;
    for (std::ptrdiff_t k = 0; k <= reach; ++k) {
        const double away = static_cast<double>(k) / sigma_samples;
        kernel.push_back(std::exp(-0.5 * away * away));
        sum += kernel.back() * (k == 0 ? 1.0 : 2.0);
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

void smooth(DepthMap& map, double sigma_mm) {
    const double x_pitch_mm = 2.0 * kPi * map.radius_mm * map.share_of_turn / static_cast<double>(map.width);
    const double y_pitch_mm = map.height_mm / static_cast<double>(map.height);
    const auto across = kernel_of(sigma_mm / x_pitch_mm);
    const auto down = kernel_of(sigma_mm / y_pitch_mm);
    std::vector<float> before;
    for (std::size_t y = 0; y < map.height; ++y) {
        smooth_line(&map.depth_mm[y * map.width], map.width, 1, across, map.share_of_turn == 1.0, before);
    }
    for (std::size_t x = 0; x < map.width; ++x) {
        smooth_line(&map.depth_mm[x], map.height, map.width, down, false, before);
    }
}

/// Both edges meet at their mean; the change fades out inwards.
void blend_seam(DepthMap& map) {
    const std::size_t reach =
        std::min(std::max<std::size_t>(map.width / kBlendShareOfWidth, 1), map.width / 2);
    for (std::size_t y = 0; y < map.height; ++y) {
        const float step = map.at(0, y) - map.at(map.width - 1, y);
        for (std::size_t k = 0; k < reach; ++k) {
            const float part = 0.5F * step * (1.0F - static_cast<float>(k) / static_cast<float>(reach));
            map.at(k, y) -= part;
            map.at(map.width - 1 - k, y) += part;
        }
    }
}

/// The step that all but a twentieth of a picture's neighbours in rows keep below.
double usual_step_mm(const DepthMap& map) {
    std::vector<float> steps_mm;
    steps_mm.reserve(map.depth_mm.size());
    for (std::size_t y = 0; y < map.height; ++y) {
        for (std::size_t x = 1; x < map.width; ++x)
            steps_mm.push_back(std::abs(map.at(x, y) - map.at(x - 1, y)));
    }
    if (steps_mm.empty()) return 0.0;
    const auto at = static_cast<std::ptrdiff_t>(kUsualShare * static_cast<double>(steps_mm.size() - 1));
    std::nth_element(steps_mm.begin(), steps_mm.begin() + at, steps_mm.end());
    return static_cast<double>(steps_mm[static_cast<std::size_t>(at)]);
}

/// The steps between two columns that become neighbours and were not in the picture.
class EdgeSteps {
public:
    explicit EdgeSteps(double range_mm, double usual_mm)
        : range_mm_(range_mm),
          least_to_tell_mm_(
              std::max({kSeamToTell_mm, kSeamToTellOfDepth * range_mm, kSeamToTellRatio * usual_mm})) {}
    void add(double one_mm, double other_mm) {
        const double step_mm = one_mm - other_mm;
        most_mm_ = std::max(most_mm_, std::abs(step_mm));
        sum_mm_ += step_mm;
        high_ += std::abs(step_mm) > least_to_tell_mm_ ? 1.0 : 0.0;
        rows_ += 1.0;
    }
    double most_mm() const noexcept { return most_mm_; }
    /// Whether a warning is due: higher than the picture's own steps in many rows, or one wall from top to
    /// bottom, whatever other walls it has.
    bool is_to_tell() const noexcept {
        const double wall_mm = std::abs(sum_mm_) / rows_;
        return high_ > kHighRowsShare * rows_ || wall_mm > std::max(kSeamToTell_mm, kWallOfDepth * range_mm_);
    }

private:
    double range_mm_;
    double least_to_tell_mm_;
    double most_mm_ = 0.0;
    double sum_mm_ = 0.0;
    double high_ = 0.0;
    double rows_ = 0.0;
};

void tell_of_seam(DepthMap& map, double range_mm) {
    if (map.width < 3) return;
    EdgeSteps seam(range_mm, usual_step_mm(map));
    const auto depth = [&map](std::size_t x, std::size_t y) { return static_cast<double>(map.at(x, y)); };
    for (std::size_t y = 0; y < map.height; ++y) seam.add(depth(0, y), depth(map.width - 1, y));
    if (!seam.is_to_tell()) return;
    map.warnings.push_back("the picture's left and right edges do not meet: a step of up to " +
                           decimals(seam.most_mm(), 2) + " mm at direction 0; --seam blend makes it smooth");
}

/// Warns of the edges of a picture that does not go all round.
void tell_of_edges(DepthMap& map, double range_mm) {
    const double usual_mm = usual_step_mm(map);
    EdgeSteps left(range_mm, usual_mm), right(range_mm, usual_mm);
    for (std::size_t y = 0; y < map.height; ++y) {
        left.add(static_cast<double>(map.at(0, y)), map.rest_depth_mm);
        right.add(static_cast<double>(map.at(map.width - 1, y)), map.rest_depth_mm);
    }
    if (!left.is_to_tell() && !right.is_to_tell()) return;
    map.warnings.push_back("the picture ends before the full turn in steps to the white rest: of up to " +
                           decimals(left.most_mm(), 2) + " mm at its left edge and " +
                           decimals(right.most_mm(), 2) +
                           " mm at its right one; white edges or --full-turn leave none");
}

}  // namespace

Result<DepthMap> depths_of(const GreyImage& image, const FlatOptions& options, const std::string& file) {
    DepthMap map = averaged(image);
    const double aspect = static_cast<double>(image.width) / static_cast<double>(image.height);
    if (auto fits = set_size(map, aspect, options, file); !fits) return fits.error();
    const double white_mm = options.white_depth_mm;
    const double black_mm = options.depth_mm;
    for (float& value : map.depth_mm) {
        double grey = options.is_inverted ? 1.0 - static_cast<double>(value) : static_cast<double>(value);
        if (options.gamma != 1.0) grey = std::pow(grey, options.gamma);
        value = static_cast<float>(black_mm + (white_mm - black_mm) * grey);
    }
    map.rest_depth_mm = white_mm;
    if (options.smooth_mm > 0.0) smooth(map, options.smooth_mm);
    if (map.share_of_turn == 1.0 && options.blends_seam) blend_seam(map);
    const double range_mm = std::abs(black_mm - white_mm);
    if (map.share_of_turn == 1.0 && !options.blends_seam) tell_of_seam(map, range_mm);
    if (map.share_of_turn < 1.0) tell_of_edges(map, range_mm);
    const double deepest_mm = std::max(white_mm, black_mm);
    if (map.radius_mm - deepest_mm < kLeastRadius_mm) {
        return bad_input(file + ": " + decimals(deepest_mm, 2) +
                         " mm deep goes to the middle of a cylinder of " + decimals(2.0 * map.radius_mm, 2) +
                         " mm diameter");
    }
    return map;
}

}  // namespace psicarve::flat
