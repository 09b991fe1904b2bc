// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/piece_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace psicarve::verify {

namespace {

constexpr std::size_t kSamples = 3;  // a side of the square of samples in each pixel

/// A corner of a triangle in the view: x to the right, y down [samples], depth towards the viewer.
struct Corner {
    float x = 0.0F;
    float y = 0.0F;
    float depth = 0.0F;
    Vec3 normal;  ///< in the viewer's frame
    float openness = 1.0F;
};

struct Sample {
    float depth = -std::numeric_limits<float>::infinity();
    Vec3 normal;
    float openness = 1.0F;
};

class View {
public:
    explicit View(const PieceGrid& grid, const PieceCamera& camera)
        : width_(camera.width_px * kSamples),
          height_(camera.height_px * kSamples),
          samples_(width_ * height_),
          cos_azimuth_(static_cast<float>(std::cos(camera.azimuth_rad))),
          sin_azimuth_(static_cast<float>(std::sin(camera.azimuth_rad))),
          cos_elevation_(static_cast<float>(std::cos(camera.elevation_rad))),
          sin_elevation_(static_cast<float>(std::sin(camera.elevation_rad))),
          scale_(static_cast<float>(camera.px_per_mm) * static_cast<float>(kSamples)),
          middle_mm_((grid.bottom_mm + grid.top_mm) / 2.0F) {}

    /// x right, y up, z towards the viewer.
    Vec3 turned(const Vec3& v) const {
        const float right = cos_azimuth_ * v.y - sin_azimuth_ * v.x;
        const float ahead = cos_azimuth_ * v.x + sin_azimuth_ * v.y;
        return {right, cos_elevation_ * v.z - sin_elevation_ * ahead,
                cos_elevation_ * ahead + sin_elevation_ * v.z};
    }

    Corner corner(const PieceGrid::Node& node) const {
        Vec3 p = node.position_mm;
        p.z -= middle_mm_;
        const Vec3 seen = turned(p);
        return {static_cast<float>(width_) / 2.0F + seen.x * scale_,
                static_cast<float>(height_) / 2.0F - seen.y * scale_, seen.z, turned(node.normal),
                node.openness};
    }

    void triangle(const Corner& a, const Corner& b, const Corner& c);
    PixelImage pixels() const;

private:
    std::size_t width_;
    std::size_t height_;
    std::vector<Sample> samples_;
    float cos_azimuth_;
    float sin_azimuth_;
    float cos_elevation_;
    float sin_elevation_;
    float scale_;
    float middle_mm_;
};

void View::triangle(const Corner& a, const Corner& b, const Corner& c) {
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area >= 0.0F) return;  // seen from behind (y points down)
    const auto clamp_to = [](float value, std::size_t most) {
        return static_cast<std::size_t>(std::clamp(value, 0.0F, static_cast<float>(most)));
    };
    const std::size_t x0 = clamp_to(std::floor(std::min({a.x, b.x, c.x})), width_);
    const std::size_t x1 = clamp_to(std::ceil(std::max({a.x, b.x, c.x})), width_);
    const std::size_t y0 = clamp_to(std::floor(std::min({a.y, b.y, c.y})), height_);
    const std::size_t y1 = clamp_to(std::ceil(std::max({a.y, b.y, c.y})), height_);
    const float per_area = 1.0F / area;
    for (std::size_t y = y0; y < y1; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        for (std::size_t x = x0; x < x1; ++x) {
            const float px = static_cast<float>(x) + 0.5F;
            const float wa = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) * per_area;
            const float wb = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) * per_area;
            const float wc = 1.0F - wa - wb;
            if (wa < 0.0F || wb < 0.0F || wc < 0.0F) continue;
            const float depth = wa * a.depth + wb * b.depth + wc * c.depth;
            Sample& sample = samples_[y * width_ + x];
            if (depth <= sample.depth) continue;
            sample.depth = depth;
            sample.normal = {wa * a.normal.x + wb * b.normal.x + wc * c.normal.x,
                             wa * a.normal.y + wb * b.normal.y + wc * c.normal.y,
                             wa * a.normal.z + wb * b.normal.z + wc * c.normal.z};
            sample.openness = wa * a.openness + wb * b.openness + wc * c.openness;
        }
    }
}

float dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Light from the upper left in front, a weaker one from the right, sky from above: linear red, green, blue.
Vec3 lit(const Sample& sample) {
    const float length = std::sqrt(dot(sample.normal, sample.normal));
    const float scale = length > 0.0F ? 1.0F / length : 0.0F;
    const Vec3 n{sample.normal.x * scale, sample.normal.y * scale, sample.normal.z * scale};
    constexpr Vec3 kKey{-0.55F, 0.62F, 0.56F};
    constexpr Vec3 kFill{0.85F, 0.10F, 0.52F};
    constexpr Vec3 kHalf{-0.311F, 0.351F, 0.883F};  // between the key light and the viewer
    const float key = std::max(0.0F, dot(n, kKey));
    const float fill = std::max(0.0F, dot(n, kFill));
    const float sky = 0.5F + 0.5F * n.y;
    const float shine = std::pow(std::max(0.0F, dot(n, kHalf)), 28.0F);
    const float open = std::clamp(sample.openness, 0.0F, 1.15F);
    const float warm = open * (0.86F * key * (0.55F + 0.45F * open) + 0.06F);
    const float cool = open * (0.15F * fill + 0.17F * sky);
    constexpr Vec3 kWood{0.80F, 0.52F, 0.29F};
    const float gloss = 0.08F * shine * open;
    return {kWood.x * (1.05F * warm + 0.92F * cool) + gloss, kWood.y * (warm + cool) + gloss,
            kWood.z * (0.92F * warm + 1.25F * cool) + gloss};
}

std::uint32_t to_byte(float linear, float alpha) {
    const float bounded = std::clamp(linear, 0.0F, 1.0F);
    const float coded =
        bounded <= 0.0031308F ? 12.92F * bounded : 1.055F * std::pow(bounded, 1.0F / 2.4F) - 0.055F;
    return static_cast<std::uint32_t>(std::lround(coded * alpha * 255.0F));
}

PixelImage View::pixels() const {
    PixelImage image;
    image.width = width_ / kSamples;
    image.height = height_ / kSamples;
    image.argb.resize(image.width * image.height);
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < image.width; ++x) {
            Vec3 sum;
            float covered = 0.0F;
            for (std::size_t k = 0; k < kSamples * kSamples; ++k) {
                const std::size_t sy = y * kSamples + k / kSamples;
                const Sample& sample = samples_[sy * width_ + x * kSamples + k % kSamples];
                if (std::isinf(sample.depth)) continue;
                const Vec3 colour = lit(sample);
                sum = {sum.x + colour.x, sum.y + colour.y, sum.z + colour.z};
                covered += 1.0F;
            }
            if (covered == 0.0F) continue;
            const float alpha = covered / static_cast<float>(kSamples * kSamples);
            image.argb[y * image.width + x] = static_cast<std::uint32_t>(std::lround(alpha * 255.0F)) << 24U |
                                              to_byte(sum.x / covered, alpha) << 16U |
                                              to_byte(sum.y / covered, alpha) << 8U |
                                              to_byte(sum.z / covered, alpha);
        }
    }
    return image;
}

/// The flat end of the piece, as a fan around the axis.
void draw_end(View& view, const PieceGrid& grid, std::size_t row, bool is_top) {
    const float way = is_top ? 1.0F : -1.0F;
    PieceGrid::Node hub;
    hub.position_mm = {0.0F, 0.0F, is_top ? grid.top_mm : grid.bottom_mm};
    hub.normal = {0.0F, 0.0F, way};
    const Corner middle = view.corner(hub);
    for (std::size_t c = 0; c < grid.columns; ++c) {
        PieceGrid::Node a = grid.at(row, c);
        PieceGrid::Node b = grid.at(row, (c + 1) % grid.columns);
        for (PieceGrid::Node* node : {&a, &b}) {
            node->normal = hub.normal;
            node->openness = 1.0F;
        }
        if (is_top)
            view.triangle(middle, view.corner(a), view.corner(b));
        else
            view.triangle(middle, view.corner(b), view.corner(a));
    }
}

}  // namespace

double fitting_px_per_mm(const PieceGrid& grid, double elevation_rad, double width_px, double height_px) {
    constexpr double kMargin = 0.94;
    const double wide_mm = 2.0 * static_cast<double>(grid.radius_mm);
    const double tall_mm = static_cast<double>(grid.top_mm - grid.bottom_mm) * std::cos(elevation_rad) +
                           wide_mm * std::sin(elevation_rad);
    return kMargin * std::min(width_px / wide_mm, height_px / tall_mm);
}

PixelImage draw_piece(const PieceGrid& grid, const PieceCamera& camera) {
    View view(grid, camera);
    std::vector<Corner> below(grid.columns);
    std::vector<Corner> above(grid.columns);
    for (std::size_t r = 0; r < grid.rows; ++r) {
        std::swap(below, above);
        for (std::size_t c = 0; c < grid.columns; ++c) above[c] = view.corner(grid.at(r, c));
        if (r == 0) continue;
        for (std::size_t c = 0; c < grid.columns; ++c) {
            const std::size_t next = (c + 1) % grid.columns;
            view.triangle(below[c], below[next], above[next]);
            view.triangle(below[c], above[next], above[c]);
        }
    }
    draw_end(view, grid, grid.rows - 1, true);
    draw_end(view, grid, 0, false);
    return view.pixels();
}

}  // namespace psicarve::verify
